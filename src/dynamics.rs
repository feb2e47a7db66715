//! How a rigid body moves: Euler's equations, the stability of a steady spin, and what to read off a motion.

pub mod euler;
pub mod observe;
pub(crate) mod regime;
pub mod stability;
