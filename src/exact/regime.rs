//! Which kind of free motion it is, with the numbers that belong to that kind.

use crate::inertia::Axis;

/// The kinds of free motion, each with its own constants.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::Axis;
/// use tumbling::exact::{FreeMotion, Regime};
/// let moments = Vector3::new(3.0, 4.0, 6.0);
/// let regime = |omega: [f64; 3]| FreeMotion::new(&moments, &omega.into()).map(|motion| motion.regime());
/// assert_eq!(regime([0.0, 0.0, 0.0])?, Regime::AtRest);
/// assert_eq!(regime([0.0, -2.0, 0.0])?, Regime::Steady { speed: 2.0 });
/// // 6 (6-4) w3² = 3 (4-3) w1² exactly: between circling the one axis and the other.
/// assert!(matches!(regime([2.0, 1.0, 1.0])?, Regime::Separatrix { .. }));
/// assert!(matches!(regime([1.9, 1.0, 1.0])?, Regime::Elliptic { about: Axis::Largest, .. }));
/// assert!(matches!(regime([2.1, 1.0, 1.0])?, Regime::Elliptic { about: Axis::Smallest, .. }));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Regime {
    /// No spin at all.
    AtRest,
    /// The spin is constant: about a principal axis, or any axis of a sphere, or one in the plane of two equal
    /// moments.
    Steady {
        /// Angular speed, rad/s.
        speed: f64,
    },
    /// Two moments are equal and the spin is oblique: it circles the third axis evenly, while the body
    /// turns evenly about its angular momentum.
    SymmetricTop {
        /// Index of the body's axis of symmetry, from 0, among the principal axes in the order given.
        axis: usize,
        /// How fast the spin circles that axis, seen from the body, rad/s; positive is counter-clockwise.
        wobble: f64,
        /// How fast the axis circles the angular momentum, seen from the world, rad/s: `L / I`.
        precession: f64,
    },
    /// Three different moments: the spin circles the axis of the largest or the smallest one.
    Elliptic {
        /// Which of the two.
        about: Axis,
        /// The modulus `k` of Jacobi's functions: 0 for an infinitesimal wobble.
        modulus: f64,
        /// The complement `k' = sqrt(1 - k²)`, with all its digits: 0 would be the separatrix.
        complement: f64,
        /// How fast Jacobi's argument runs, 1/s: a flip comes each time it has moved by `2 K`.
        rate: f64,
    },
    /// Three different moments, exactly between the two: the spin leaves the middle axis, flips once, and
    /// returns to it without end.
    Separatrix {
        /// How fast it leaves and returns, 1/s: as `exp(±rate t)`.
        rate: f64,
    },
}
