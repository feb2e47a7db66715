//! Scenes: bodies, the torques on them and the outputs requested. They are answered in the cheapest way that
//! is accurate enough.
//!
//! A [`Scene`] is a plain value. [`Scene::plan`] chooses for one of its bodies how to answer: a [`Plan`]
//! explains in words what it leaves out ([`Plan::explain`]), and returns the states one after another
//! ([`Plan::states`]), so that a long run needs no more memory than a short one. [`batch`] answers many
//! bodies in lanes and on all cores.
//!
//! ```
//! use nalgebra::Vector3;
//! use tumbling_scenes::{InitialState, Outputs, Scene, Strategy, Times};
//!
//! // A racket: when does it flip? No motion is computed.
//! let moments = Vector3::new(0.00121, 0.01638, 0.01748);
//! let racket = InitialState::spinning(moments, Vector3::new(0.01, 10.0, 0.0));
//! let outputs = Outputs { flips: true, ..Outputs::NOTHING };
//! let scene = Scene::new([racket], vec![], Times::every(0.1, 10.0), outputs, 1e-9)?;
//! let plan = scene.plan(0)?;
//! assert_eq!(plan.strategy(), Strategy::Nothing);
//! assert_eq!(plan.flips()?.count(), 5);
//! # Ok::<(), tumbling_scenes::Error>(())
//! ```
//!
//! # Accuracy
//!
//! One number is the error allowed in every state: in the angle of the attitude (rad), in the spin relative
//! to the largest spin so far, and in the energy relative to the largest energy so far. For a flip under a
//! torque it is the angle that the body turns during the error in time (rad). A free body is answered in
//! closed form, as accurately as its conditioning permits; a finer accuracy is refused, and the error states
//! the finest possible. Under a torque a tolerance is chosen and then tried: the run is compared with a finer
//! one and refined until the two agree to half of the accuracy (the finer run is used) or to a tenth of it
//! (the coarser one is used). With the least tolerance, the body changed by some roundings must move alike,
//! too. That is evidence, not proof.
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
#![warn(clippy::disallowed_methods)] // of clippy.toml

pub mod batch;

mod cost;
mod driven;
mod error;
mod explain;
mod free;
mod initial_state;
mod lanes;
mod plan;
mod scene;
mod states;
mod times;
mod torques;

/// What the tests need and nobody else calls.
#[doc(hidden)]
pub mod tested {
    pub use crate::batch::side_by_side;
    pub use crate::driven::{Run, Trial, changed};
    pub use crate::lanes::Lanes;
}

pub use cost::Cost;
pub use error::{Error, Field};
pub use initial_state::{InitialState, Start};
pub use plan::{Driven, FlipTimes, Plan, Strategy};
pub use scene::{Outputs, Scene};
pub use states::{Answer, States};
pub use times::Times;
