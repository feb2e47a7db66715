//! The file in double precision.

type Real = f64;
#[path = "../../../examples/engines/position_stage.rs"]
mod position_stage;
pub use position_stage::PositionStage;
