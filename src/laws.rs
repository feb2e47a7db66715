//! Laws on any kind of number that are public for proofs alone: `crates/proofs` runs these very functions on
//! algebraic symbols, and the closed form on intervals. The other laws that it runs stand in their modules.

pub use crate::body::Rate;
pub use crate::exact::series::{
    ClosedForm, ComplementaryPair, ComplementarySeries, DirectPair, DirectSeries, Parts,
};
pub use crate::number::real::Real;
pub use crate::solid::mesh::{mesh_moments, tetrahedron_moments};
pub use crate::step::position_stage::turn::{change_of_spin, conserving_rate, conserving_turn};
pub use crate::step::system::altered;
