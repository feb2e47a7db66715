//! Tests of drawings and films by theme, as one program, since each one more is linked on its own:
//! `cargo test -p tumbling-media --test media films` runs a part.

mod drawings;
mod films;
