//! The file in double precision.

type Real = f64;
#[allow(clippy::duplicate_mod, reason = "the file is compiled once for each precision")]
#[path = "../../../examples/engines/position_stage.rs"]
mod position_stage;
pub use position_stage::{PositionStage, step_all};
