//! The list of proofs, in the order of the library.

pub(crate) mod closed_forms;
mod conserved;
pub mod engines;
mod errata;
mod euler;
mod gap;
mod inertia;
mod integrals;
pub(crate) mod klein;
mod methods;
mod order;
mod position_stage;
mod sensitivity;
mod solids;
mod stability;
mod theta;
mod turning;

use crate::proof::Proof;

/// Every proof.
#[must_use]
pub fn proofs() -> Vec<&'static Proof> {
    let parts: [&[Proof]; 17] = [
        solids::PROOFS,
        inertia::PROOFS,
        turning::PROOFS,
        euler::PROOFS,
        conserved::PROOFS,
        stability::PROOFS,
        gap::PROOFS,
        engines::PROOFS,
        closed_forms::PROOFS,
        theta::PROOFS,
        klein::PROOFS,
        integrals::PROOFS,
        sensitivity::PROOFS,
        order::PROOFS,
        methods::PROOFS,
        position_stage::PROOFS,
        errata::PROOFS,
    ];
    parts.into_iter().flatten().collect()
}
