//! Stepping through time: good and bad methods with one interface, and correct and wrong engines.
//!
//! A [`Method`] takes a [`State`] of a [`System`] (a body and the [torques](Torque) on it) one step further.
//! Each family of methods is in its own file, generic over the number type; proofs of a method's order run
//! the same code on power series.
//!
//! Nothing here uses the [exact motion](crate::exact): the tests compare the two.

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
pub use info::MethodInfo;
pub use method::Method;
pub use methods::runge_kutta::rk4;
pub use pitfalls::Engine;
pub use position_stage::{PositionStage, Stepped};
pub use stepper::Stepper;
pub use system::System;
pub use torque::Torque;
