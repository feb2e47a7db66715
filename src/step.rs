//! Stepping through time: methods good and bad under one contract, and whole engines right and wrong.
//!
//! A [`Method`] takes a [`State`] of a [`System`] (a body and the [torques](Torque) on it) one step further.
//! Each family is a file of its own, generic over the number type; on power series the same code proves its
//! own order.
//!
//! Nothing here uses the [exact motion](crate::exact): the tests hold the two to each other.

mod adaptive;
mod fixed_rate;
mod info;
mod method;
mod methods;
mod pitfalls;
pub(crate) mod position_stage;
mod run;
mod stepper;
pub(crate) mod system;
mod torque;
mod torques;
mod transition;

pub use crate::body::State;
pub use fixed_rate::fixed_rate;
pub use info::{Conserved, MethodInfo};
pub use method::Method;
pub use methods::runge_kutta::rk4;
pub use pitfalls::Engine;
pub use position_stage::{PositionStage, Stepped};
pub use stepper::Stepper;
pub use system::System;
pub use torque::{Torque, TorqueFunction};
