//! The list of proofs, in the order of the library.

mod inertia;
mod solids;

use crate::proof::Proof;

/// Every proof.
#[must_use]
pub fn proofs() -> Vec<&'static Proof> {
    let parts: [&[Proof]; 2] = [
        solids::PROOFS,
        inertia::PROOFS,
    ];
    parts.into_iter().flatten().collect()
}
