//! Drawings in SVG, made into files that other programs show alike: plain SVG, PNG, PDF, films.
//!
//! A [`Drawing`] is read from an SVG document whose colours are plain. Its letters are set in the fonts that
//! this crate carries, so that a file looks the same on a machine that has none. A [`Film`](film::Film) takes
//! pictures of drawings, one after another, as a GIF.

mod drawing;
mod error;
pub mod film;
mod letters;
mod pdf;
mod picture;

pub use drawing::Drawing;
pub use error::Error;
pub use letters::{SANS, SYMBOLS};
pub use picture::{Picture, Rgb};
