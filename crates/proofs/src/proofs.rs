//! The list of proofs, in the order of the library.

/// The proofs of each part of the library. Each has a name, its check, a sentence that says what the check
/// shows, and altered laws or claims with which it must fail. If the sentence has formulas, the check returns
/// the meanings of their names; for an altered law or claim the sentence must not hold. Before the name
/// stands the [`Kind`](crate::proof::Kind) if it is not a proof through the library.
macro_rules! proofs {
    ($($part:literal {$(
        $([$kind:ident])? $name:literal: $check:expr, $statement:expr; $(but $change:literal: $mutant:expr,)*
    )*})*) => {
        pub(super) const PROOFS: &[$crate::proof::Proof] = &[$($($crate::proof::Proof {
            name: $name,
            kind: [$($crate::proof::Kind::$kind,)? $crate::proof::Kind::Library][0],
            part: $part,
            statement: $statement,
            cases: || $crate::proof::Cases::cases($check),
            mutants: &[$($crate::proof::Mutant {
                change: $change,
                check: || $crate::proof::hold($statement, $mutant),
            },)*],
        },)*)*];
    };
}

pub(crate) mod conserved;
mod discrete;
mod engines;
mod errata;
mod euler;
pub(crate) mod gap;
mod inertia;
mod integrals;
mod kept;
pub(crate) mod klein;
pub(crate) mod methods;
pub(crate) mod order;
mod position_stage;
mod sensitivity;
mod shares;
mod solids;
mod stability;
mod theta;
mod turning;

use crate::proof::Proof;

/// Every proof.
#[must_use]
pub fn proofs() -> Vec<&'static Proof> {
    let parts: [&[Proof]; 18] = [
        solids::PROOFS,
        inertia::PROOFS,
        turning::PROOFS,
        euler::PROOFS,
        conserved::PROOFS,
        stability::PROOFS,
        gap::PROOFS,
        engines::PROOFS,
        theta::PROOFS,
        klein::PROOFS,
        integrals::PROOFS,
        sensitivity::PROOFS,
        methods::PROOFS,
        discrete::PROOFS,
        shares::PROOFS,
        kept::PROOFS,
        position_stage::PROOFS,
        errata::PROOFS,
    ];
    parts.into_iter().flatten().collect()
}
