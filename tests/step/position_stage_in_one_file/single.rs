//! The file in single precision.

type Real = f32;
#[path = "../../../examples/engines/position_stage.rs"]
mod position_stage;
pub use position_stage::PositionStage;
