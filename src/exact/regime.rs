//! The kind of a free motion, with the constants of that kind.

use crate::inertia::Axis;

/// The kinds of free motion, each with its own constants.
///
/// ```
/// use tumbling::{Axis, PrincipalMoments};
/// use tumbling::exact::{FreeMotion, Regime};
/// let moments = PrincipalMoments::new(3.0, 4.0, 6.0)?;
/// let regime = |omega: [f64; 3]| FreeMotion::new(moments, &omega.into()).map(|motion| motion.regime());
/// assert_eq!(regime([0.0, 0.0, 0.0])?, Regime::AtRest);
/// assert_eq!(regime([0.0, -2.0, 0.0])?, Regime::Steady { speed: 2.0 });
/// // 6 (6-4) w3² = 3 (4-3) w1² exactly: between circling the one axis and the other.
/// assert!(matches!(regime([2.0, 1.0, 1.0])?, Regime::Separatrix { .. }));
/// assert!(matches!(regime([1.9, 1.0, 1.0])?, Regime::Elliptic { about: Axis::Largest, .. }));
/// assert!(matches!(regime([2.1, 1.0, 1.0])?, Regime::Elliptic { about: Axis::Smallest, .. }));
/// // Off the separatrix by less than `f64` holds.
/// assert!(matches!(regime([1e-150, 1e200, 0.0])?, Regime::Elliptic { complement: 0.0, .. }));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Regime {
    /// No spin at all.
    AtRest,
    /// The spin is constant: about a principal axis, or any axis of a sphere, or one in the plane of two
    /// equal moments.
    Steady {
        /// The length of the spin, rad/s, not below 0.
        speed: f64,
    },
    /// Two moments are equal and the spin is oblique: it circles the axis of symmetry at a constant rate,
    /// while that axis precesses about the angular momentum.
    SymmetricTop {
        /// The axis of symmetry: that of the largest or of the smallest moment.
        axis: Axis,
        /// Rate at which the spin circles that axis in the body (the free nutation), rad/s; positive is
        /// counter-clockwise.
        nutation: f64,
        /// Rate at which that axis circles the angular momentum in the world, rad/s: `L / I`.
        precession: f64,
    },
    /// Three different moments: the spin circles the axis of the largest or the smallest one.
    Elliptic {
        /// Which of the two.
        about: Axis,
        /// The modulus `k` of Jacobi's functions: 0 for an infinitesimal libration.
        modulus: f64,
        /// The complement `k' = sqrt(1 - k²)`, with all its digits; 0 where it is below the smallest number
        /// of `f64`; the motion still flips at its correct times.
        complement: f64,
        /// The rate of Jacobi's argument, 1/s: a flip occurs each time the argument has advanced by `2 K`.
        /// Where `k'` is at most 0.1, a deviation from the middle axis first grows as `cosh(rate t)`, by the
        /// factor `1/k'` up to the flip; the rate is at most `0.6 k'²` (relative) above that of a small push
        /// on a steady spin about that axis with the same momentum.
        rate: f64,
    },
    /// Three different moments, exactly between the two: the spin leaves the middle axis, flips once, and
    /// approaches the axis again asymptotically.
    Separatrix {
        /// The rate at which it leaves and approaches the axis, as `exp(±rate t)`, 1/s.
        rate: f64,
    },
}
