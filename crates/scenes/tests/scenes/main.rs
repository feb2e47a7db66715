//! Tests of scenes by theme, as one program, since each one more is linked on its own:
//! `cargo test -p tumbling-scenes --test scenes free` runs a part.

mod batch;
mod common;
mod driven;
mod ensemble;
mod exact_drift;
#[cfg(feature = "file")]
mod files;
mod free;
#[cfg(feature = "file")]
mod same_bits;
mod scene;
mod torques;
mod trials;
