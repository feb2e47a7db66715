//! Tests of proofs and their numbers by theme, as one program, since each one more is linked on its own:
//! `cargo test -p tumbling-proofs-tests sympy` runs a part.

mod all;
mod intervals;
mod laws;
mod many_numbers;
mod methods;
mod motion;
mod numbers;
mod reader;
mod regions;
mod rests;
mod rounded;
mod series;
mod sympy;
mod tex;
