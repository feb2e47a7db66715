//! Rotation of rigid bodies: why a tossed book flips, and a library to compute it. In rotation, a matrix
//! plays the role of mass: a body's [`Inertia`] maps its spin to its angular momentum, and the two point in
//! the same direction only along the [principal axes](PrincipalAxes). A free body keeps its momentum; so, off
//! these axes, its spin must change, and near the middle axis the body flips.
//!
//! ```
//! use nalgebra::{UnitQuaternion, Vector3};
//! use tumbling::solid::{Cuboid, Solid};
//! use tumbling::{Body, exact::FreeMotion};
//!
//! // A box of 2 x 1 x 3 m and 1 kg, spun halfway between two of its edges.
//! let inertia = Cuboid::new(2.0, 1.0, 3.0)?.with_mass(1.0)?.inertia();
//! let omega = Vector3::new(1.0, 1.0, 0.0);
//! assert_eq!(format!("{:.1}°", inertia.angle_to_momentum(&omega)?.to_degrees()), "7.4°");
//!
//! // Near its middle axis, it flips for the first time after 15.1 s.
//! let start = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(1.0, 0.01, 0.01))?;
//! let motion = FreeMotion::of(&start)?;
//! assert_eq!(motion.next_flip(0.0)?.map(|time| format!("{time:.1} s")), Some("15.1 s".into()));
//! // Its spin and attitude at any time, without steps.
//! let there = motion.at(1e6)?;
//! let then = Body::spinning(inertia, there.attitude, &there.omega)?;
//! assert!((then.energy() / start.energy() - 1.0).abs() < 1e-14);
//! # Ok::<(), tumbling::Error>(())
//! ```
//!
//! # The modules
//!
//! Data flows one way; each module uses only those before it, and [`exact`] and [`step`] never each other:
//!
//! - [`number`]: the number types on which the laws run.
//! - [`attitude`]: rotations as quaternions.
//! - [`inertia`]: the tensor: apply, invert once, turn to the world. [`PrincipalAxes`] and
//!   [`PrincipalMoments`] follow from it.
//! - [`solid`]: a shape and a mass give [`MassProperties`]: mass, centre, tensor.
//! - [`body`]: a [`Body`] has inertia, attitude and angular momentum; its spin is derived. [`body::named`]
//!   has ready ones.
//! - [`dynamics`]: Euler's equations, stability, energy and flips.
//! - [`exact`]: free motion in closed form: [`exact::FreeMotion`] of one body, [`exact::Batch`] of many.
//! - [`step`]: stepping through time, right and wrong: a [`step::Stepper`] runs a body by the method of your
//!   choice, under torques.
//! - [`laws`]: functions that are public only for the proofs, and traits for vectors of several numbers.
//!
//! `FreeMotion::of` and `Stepper::new` accept a `Body` with products of inertia too, and return results in
//! the axes of that body.
//!
//! # Where to start
//!
//! | to | use |
//! |---|---|
//! | get the free motion of a body at any instant, its flips, its period | [`exact::FreeMotion`] |
//! | bound the angle between one of its axes and its momentum | [`FreeMotion::angles_to_momentum`](exact::FreeMotion::angles_to_momentum) |
//! | find how far it turns about its momentum from flip to flip | [`FreeMotion::twist_of_half_period`](exact::FreeMotion::twist_of_half_period) |
//! | propagate the covariance of its attitude and spin | [`FreeMotion::state_transition`](exact::FreeMotion::state_transition) |
//! | step a body in a loop of your own, free or under torques | [`step::Stepper`]; [`step::Method`] says which method for what |
//! | answer many free bodies at once | [`exact::Batch`] |
//! | use a tensor or moments that were printed with few digits | [`Inertia::within`] |
//!
//! # Conventions
//!
//! SI units and radians. Attitudes take body coordinates to world. Products of inertia carry the sign that
//! makes `L = I w` hold. Names end in `_body` or `_world` where it matters. The documentation says where
//! values are along principal axes.
//!
//! Numbers, attitudes, tensors, moments, mass properties and choices such as [`Axis`] are passed by value;
//! vectors, matrices, states, bodies and systems by reference. The generic laws take all arguments by
//! reference, since their numbers may be large.
//!
//! # Many kinds of number
//!
//! The laws ([`dynamics::euler`], [`inertia::turned`], [`attitude::rate`], [`step::rk4`], the moments in
//! [`solid`]) are generic over [`number::Ring`] or [`number::Field`]: the same functions run on `f64`, on
//! exact rationals, on dual numbers, or on numbers that count what a formula costs.
//!
//! # Errors
//!
//! Constructors check their arguments and return an [`Error`] that names the value, the rule and the margin,
//! and has a [kind](ErrorKind) for programs. No public function may panic on any `f64` or count: a result
//! that memory cannot hold is an error. The generic laws behave as their number type does: integers, for
//! example, panic when they divide by zero.
//!
//! # Features
//!
//! - `std`, on by default: without it the library needs only `core` and `alloc`.
//!
//! Results have the same bits wherever `f64` follows IEEE 754, since the elementary functions are the
//! library's own.
//!
//! Sources are cited by keys, which [`references`] lists.
#![cfg_attr(not(feature = "std"), no_std)]
#![cfg_attr(doctest, doc = include_str!("../README.md"))]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))] // of clippy.toml

extern crate alloc;

pub mod attitude;
pub mod body;
pub mod dynamics;
pub mod exact;
pub mod inertia;
pub mod laws;
pub mod number;
pub mod references;
pub mod solid;
pub mod step;

mod error;

pub use body::{Body, State};
pub use error::{Error, ErrorKind, Subject};
pub use inertia::{Axis, Inertia, PrincipalAxes, PrincipalMoments};
pub use solid::{MassProperties, Solid};
