//! The library's laws on any number that only proofs call: `crates/proofs` runs these very functions on
//! algebraic symbols, as it does the other laws, which stand in their modules.

pub use crate::body::Rate;
pub use crate::solid::mesh::mesh_moments;
pub use crate::step::position_stage::turn::{change_of_spin, conserving_pace, conserving_turn};
