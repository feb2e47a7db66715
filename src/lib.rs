//! Rotation of rigid bodies: why a tossed book flips, with every claim checked.
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod attitude;
pub mod bodies;
pub mod counted;
pub mod elliptic;
pub mod euler;
pub mod exact;
pub mod inertia;
pub mod observe;
pub mod references;
pub mod scalar;
pub mod solid;
pub mod stability;
pub mod step;

mod body;
mod double;
mod error;
mod invariants;
mod principal;
mod scale;
mod wide;

pub use body::Body;
pub use error::Error;
pub use inertia::{Inertia, InverseInertia};
pub use principal::{Axis, PrincipalAxes};
pub use solid::{MassProperties, Solid};
