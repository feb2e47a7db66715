//! How a rigid body moves: Euler's equations, what becomes of a small push, which regime a free motion is in,
//! and what to read off a motion.

pub mod euler;
pub mod observe;
pub(crate) mod regime;
pub mod stability;
