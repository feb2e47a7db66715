//! Converts SVG drawings to files that look the same in all programs: plain SVG, PNG, PDF, films.
//!
//! A [`Drawing`] is read from an SVG document whose colours do not depend on a page. Its text uses the fonts
//! in this crate, so that a file looks the same on a machine without them. A [`Film`](film::Film) is a GIF
//! made from a sequence of pictures of drawings.

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
