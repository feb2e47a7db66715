//! How the laws of free motion are kept from row to row.

mod complaint;
mod curve;
mod followed;
mod jumps;
mod points;
mod trial;

pub use complaint::{Complaint, Seen};
pub(crate) use curve::Curve;
pub use curve::{FlipCount, Growth, Law};
pub(crate) use followed::Laws;
pub use jumps::Reset;
pub(crate) use jumps::{Errors, Jumps};
pub use points::Point;
pub(crate) use points::{Stretch, Stretches};
pub use trial::Gaps;
pub(crate) use trial::Trial;
