//! Which rule made the steps.

mod advice;
mod candidates;
mod confidence;
mod diagnosis;
mod fitted;
mod jumps;
mod names;
mod rules;
mod tried;
mod unnamed;

pub use advice::Advice;
pub(crate) use candidates::Subject;
pub use confidence::Confidence;
pub use diagnosis::{Diagnosis, Explanation};
pub(crate) use diagnosis::{Whole, diagnose};
pub(crate) use fitted::{compound, inside, momentum_for_spin, other_bodies, tensor};
pub use jumps::Jump;
pub(crate) use names::{TERMS, engine_names, engines, first_named, readable, settings, with_unseen};
pub use rules::{Alteration, Base, Rule, Steps, Turn, When};
pub(crate) use rules::{distinct, frozen, in_parts, of_parts, plain};
