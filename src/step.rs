//! Stepping through time: the classical Runge-Kutta method, and engines right and wrong to run on it.

mod engine;
mod rk4;

pub use engine::Engine;
pub use rk4::{Motion, rk4};
