//! Tests of the library by module: the tests of `src/MODULE/NAME.rs` are in `tests/MODULE/NAME.rs`, or next
//! to the code if they need its private items or take millions of steps. They are one program, because each
//! program is linked separately. `cargo test --test library exact::flips` runs a part.

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
