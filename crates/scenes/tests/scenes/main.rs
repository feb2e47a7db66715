//! Tests of scenes by theme, as one program, since each one more is linked on its own:
//! `cargo test -p tumbling-scenes --test scenes free` runs a part.

mod batch;
mod common;
mod driven;
mod free;
mod lanes;
mod same_bits;
mod scene;
mod torques;
mod trials;
