//! Stepping through time: methods good and bad under one contract, and whole engines right and wrong.
//!
//! A [`Method`] takes a [`Motion`] of a [`System`] (a body and the [torques](Torque) on it) one step further. Each family is a file
//! of its own, generic over the number type; on power series the same code proves its own order.
//!
//! Nothing here knows the [exact motion](crate::exact): the two judge each other.

mod buss;
mod decimal;
mod dormand_prince;
mod engine;
mod explicit;
mod game;
mod gauss;
mod lie;
mod method;
mod moser_veselov;
mod physics_engine;
mod rk4;
mod rules;
mod spiral;
mod splitting;
mod symmetric_top;
mod system;
mod torque;

pub(crate) use dormand_prince::controlled_within;
pub use dormand_prince::{Controlled, LEAST_TOLERANCE, MOST_STEPS, controlled};
pub use engine::Engine;
pub use game::game;
pub use method::{About, Keeps, Method};
pub use physics_engine::{Limits, PHYSICS_ENGINES, PhysicsEngine};
pub use rk4::{Motion, rk4};
pub use system::System;
pub use torque::Torque;
