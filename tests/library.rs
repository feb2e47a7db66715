//! Tests of the library by its rooms: what concerns `src/ROOM/NAME.rs` is in `tests/ROOM/NAME.rs`, or next to
//! the code where it needs what is private there. One program, since each one more is linked on its own:
//! `cargo test --test library exact::flips` runs a part.

mod attitude;
mod body;
mod common;
mod dynamics;
mod exact;
mod house;
mod inertia;
mod number;
mod same_bits;
mod solid;
mod step;
