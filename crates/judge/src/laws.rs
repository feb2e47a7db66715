//! How the laws of free motion are kept from row to row.

mod complaint;
mod curve;
mod followed;
mod jumps;
mod kept;
mod points;
mod stretches;
mod trial;

pub use complaint::{Complaint, Seen};
pub(crate) use curve::Curve;
pub use curve::Growth;
pub(crate) use followed::Laws;
pub use jumps::Reset;
pub(crate) use jumps::{Errors, Jumps};
pub use kept::{FlipCount, Law};
pub use points::Point;
pub(crate) use stretches::{Stretch, Stretches};
pub use trial::Gaps;
pub(crate) use trial::Trial;
