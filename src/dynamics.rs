//! How a rigid body moves: Euler's equations, the stability of a steady spin, its kinetic energy and its
//! flips.

pub mod euler;
pub(crate) mod invariants;
pub mod observe;
pub mod stability;
