//! How the laws of free motion are kept from row to row.

mod curve;
mod followed;
mod jumps;
mod kept;
mod points;
mod trial;

pub(crate) use curve::Curve;
use curve::line;
pub(crate) use followed::Laws;
use jumps::Errors;
pub use jumps::Reset;
pub use kept::{FlipCount, Growth, Law};
pub use points::Point;
pub(crate) use points::{Stretch, Stretches};
pub use trial::Gaps;
pub(crate) use trial::Trial;
