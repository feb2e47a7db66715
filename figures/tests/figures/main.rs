//! Tests of figures and films by theme, as one program, since each one more is linked on its own:
//! `cargo test -p tumbling-figures --test figures film` runs a part.

mod drawings;
mod exported;
mod film;
mod of_body;
