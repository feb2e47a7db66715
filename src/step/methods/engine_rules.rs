//! The rules by which physics engines turn a free body, each as a [`Method`](crate::step::Method).
//!
//! They differ in what they do with the gyroscopic term `L x w` and in how they turn the attitude by the new
//! spin. All of them bring the attitude back to length 1 after each step, as the engines do. Torques act as
//! they stand at the start of the step, except in the Runge-Kutta ones.

pub(crate) mod explicit;
pub(crate) mod newton;
pub(crate) mod runge_kutta;
pub(crate) mod turn;
