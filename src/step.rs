//! Stepping through time: methods good and bad under one contract, and whole engines right and wrong.
//!
//! A [`Method`] takes a [`State`] of a [`System`] (a body and the [torques](Torque) on it) one step further. Each family is a file
//! of its own, generic over the number type; on power series the same code proves its own order.
//!
//! Nothing here knows the [exact motion](crate::exact): the two judge each other.

mod fixed_rate;
mod method;
mod methods;
mod pitfalls;
mod system;
mod torque;

pub use crate::body::{Rate, State};
pub use fixed_rate::fixed_rate;
pub use method::{Conserved, Method, MethodInfo};
pub use methods::dormand_prince::{Controlled, LEAST_TOLERANCE, MOST_STEPS, controlled, controlled_within};
pub use methods::rk4::rk4;
pub use pitfalls::{Carried, Engine};
pub use system::System;
pub use torque::Torque;
