//! How the laws of free motion are kept from row to row.

mod curve;
mod followed;
mod points;
mod trial;

pub(crate) use curve::Curve;
pub use curve::{FlipCount, Growth, Law};
pub(crate) use followed::Laws;
pub use points::Point;
pub(crate) use points::{Stretch, Stretches};
pub(crate) use trial::Trial;
pub use trial::{Gaps, Reset};
