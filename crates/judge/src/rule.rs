//! Which rule made the steps.

pub(crate) mod accuracy;
pub(crate) mod advice;
pub(crate) mod candidates;
pub(crate) mod confidence;
pub(crate) mod diagnosis;
pub(crate) mod drift;
pub(crate) mod engine_step;
pub(crate) mod engines;
pub(crate) mod fitted;
pub(crate) mod hints;
pub(crate) mod names;
pub(crate) mod rules;
