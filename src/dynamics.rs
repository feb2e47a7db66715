//! How a rigid body moves: Euler's equations, the stability of a steady spin, and what to read off a motion.

pub mod euler;
pub(crate) mod invariants;
pub mod observe;
pub mod stability;
