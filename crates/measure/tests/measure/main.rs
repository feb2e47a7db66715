//! Tests of the harness and its records by theme, as one program, since each one more is linked on its own:
//! `cargo test -p tumbling-measure --test measure atlas` runs a part.

mod atlas;
mod costs;
mod harness;
mod records;
mod scenes;
