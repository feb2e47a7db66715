//! Physics engines: the rule by which each turns a rigid body, in one setting, and what it did, as recorded.
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod catalogue;
mod error;
mod records;

pub use catalogue::{Limits, PHYSICS_ENGINES, PhysicsEngine, parted, turned_straight};
pub use error::Error;
pub use records::{Kept, RECORDED, Recorded, RecordedRow, Trajectory, table};
