//! The kind of motion of a top (T23).

use super::integrals::Integrals;

/// The kinds of motion of a top. The lean is the angle between the vertical and its axis, taken from the
/// fixed point to the centre of mass.
///
/// ```
/// use nalgebra::{UnitQuaternion, Vector3};
/// use tumbling::PrincipalMoments;
/// use tumbling::exact::{LagrangeTop, TopRegime};
/// let moments = PrincipalMoments::new(1.0, 1.0, 0.5)?;
/// let regime = |lean: f64, omega: [f64; 3]| {
///     let leaning = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), lean);
///     LagrangeTop::new(moments, leaning, &omega.into(), &Vector3::z(), 2.0).map(|top| top.regime())
/// };
/// // Upright it is stable if (0.5 spin)² is at least 4 x 1 x 2.
/// assert_eq!(regime(0.0, [0.0, 0.0, 6.0])?, TopRegime::Sleeping { stable: true });
/// assert_eq!(regime(0.0, [0.0, 0.0, 5.0])?, TopRegime::Sleeping { stable: false });
/// assert_eq!(regime(0.5, [0.0, 0.0, 9.0])?, TopRegime::Cusped);
/// assert_eq!(regime(0.5, [0.0, 0.1, 9.0])?, TopRegime::Nutation);
/// assert_eq!(regime(0.5, [0.0, -0.9, 9.0])?, TopRegime::Looping);
/// assert_eq!(regime(0.0, [0.3, 0.0, 9.0])?, TopRegime::Nutation); // through the upright
/// assert_eq!(regime(0.5, [0.1, 0.3, 0.0])?, TopRegime::Pendulum);
/// // Steady at 0.5 rad, where 1 x cos(0.5) x rate² - 0.5 x 9 x rate + 2 is zero.
/// let rate = 4.0 / (4.5 + (4.5_f64.powi(2) - 8.0 * 0.5_f64.cos()).sqrt());
/// let spin = 9.0;
/// assert_eq!(regime(0.5, [0.0, rate * 0.5_f64.sin(), spin])?, TopRegime::SteadyPrecession);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum TopRegime {
    /// Without weight or without an arm: a free symmetric body.
    Free,
    /// Exactly upright, turning about its axis or at rest: both the lean and the spin across the axis are 0,
    /// not merely small. It is stable where the square of the momentum about the axis is at least
    /// 4 x (moment across it) x weight x arm.
    Sleeping {
        /// Whether a small push leaves it nearly upright.
        stable: bool,
    },
    /// Exactly straight down, turning about its axis or at rest: the lean is 180° to the last bit.
    Hanging,
    /// It precesses at a constant lean and rate, to the rounding of the input: a start computed in `f64` from
    /// one of the two steady rates counts as steady, up to 16 roundings (2⁻⁵³ each) of the terms in balance.
    /// The two values of [`lean`](super::LagrangeTop::lean) may then differ by the oscillation that these
    /// roundings leave. A [`Body`](crate::Body) stores its momentum in world axes; if it spins much faster
    /// than it precesses, rounding that momentum exceeds this limit.
    SteadyPrecession,
    /// Its axis rises and sinks, and always precesses in the same direction, or passes exactly through the
    /// vertical.
    Nutation,
    /// Its axis rises and sinks, and stops at each highest position (a cusp), as for a top released with its
    /// axis at rest.
    Cusped,
    /// Its axis rises and sinks, and precesses backward during part of each loop.
    Looping,
    /// It has no momentum about its axis: a spherical, plane or conical pendulum.
    Pendulum,
    /// It leaves the exactly upright position and returns to it, in infinite time.
    Separatrix,
}

impl TopRegime {
    pub(super) fn new(integrals: &Integrals, steady: bool, spin: f64) -> Self {
        let Integrals { along, pull, about, down, up, from_bottom, .. } = integrals;
        if pull.hi() == 0.0 {
            return Self::Free;
        }
        if steady {
            let stable = (*along * *along - *pull * 2.0).hi() >= 0.0;
            return if from_bottom.hi() == 0.0 { Self::Hanging } else { Self::Sleeping { stable } };
        }
        if integrals.third.hi() == 0.0 && integrals.tops[1].hi() == 0.0 {
            return Self::Separatrix;
        }
        if along.hi() == 0.0 {
            return Self::Pendulum;
        }
        if integrals.is_steady() {
            return Self::SteadyPrecession;
        }
        let (low, high) = (*about + *along * *down, *about - *along * *up);
        let same = low.hi() * high.hi();
        // Next to a cusp it is a rounding of its parts, or of the spin that the start was made from.
        let rounding = 1e-15 * about.hi().abs().max(spin.abs().min(1e12 * low.hi().abs()));
        // A path through the vertical itself has neither cusps nor loops.
        let through = integrals.bottoms[0].hi() == 0.0 || integrals.tops[1].hi() == 0.0;
        if !through && high.hi().abs() <= rounding {
            Self::Cusped
        } else if through || same > 0.0 {
            Self::Nutation
        } else {
            Self::Looping
        }
    }
}
