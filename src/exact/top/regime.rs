//! Which kind of motion of a top it is.

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
/// // Upright it stands if (0.5 spin)² is 4 x 1 x 2 at least.
/// assert_eq!(regime(0.0, [0.0, 0.0, 6.0])?, TopRegime::Sleeping { stable: true });
/// assert_eq!(regime(0.0, [0.0, 0.0, 5.0])?, TopRegime::Sleeping { stable: false });
/// assert_eq!(regime(0.5, [0.0, 0.0, 9.0])?, TopRegime::Cusped);
/// assert_eq!(regime(0.5, [0.0, 0.1, 9.0])?, TopRegime::Nutation);
/// assert_eq!(regime(0.5, [0.0, -0.9, 9.0])?, TopRegime::Looping);
/// assert_eq!(regime(0.5, [0.1, 0.3, 0.0])?, TopRegime::Pendulum);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum TopRegime {
    /// Without weight or without an arm: a free symmetric body.
    Free,
    /// Exactly upright, turning about its axis or at rest: both the lean and the spin across the axis are 0,
    /// not merely small. It is stable from the critical spin on, where the square of the momentum about the
    /// axis is 4 x (moment across it) x weight x arm.
    Sleeping {
        /// Whether a small push leaves it nearly upright.
        stable: bool,
    },
    /// Exactly straight down, turning about its axis or at rest: it leans by 180°, to the bit.
    Hanging,
    /// It goes round at a constant lean and rate.
    SteadyPrecession,
    /// It rises and sinks, and always goes round the same way.
    Nutation,
    /// It rises and sinks, and stands still at each highest place, as a top that was let go without a push.
    Cusped,
    /// It rises and sinks, and goes backward for a part of each loop.
    Looping,
    /// It has no momentum about its axis: a spherical or a plane pendulum.
    Pendulum,
    /// It comes from exactly upright and returns there, without end.
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
        if down.hi() == 0.0 && up.hi() == 0.0 {
            return Self::SteadyPrecession;
        }
        let (low, high) = (*about + *along * *down, *about - *along * *up);
        let same = low.hi() * high.hi();
        // Next to a cusp it is a rounding of its parts, or of the spin that the start was made from.
        let rounding = 1e-15 * about.hi().abs().max(spin.abs().min(1e12 * low.hi().abs()));
        if high.hi().abs() <= rounding {
            Self::Cusped
        } else if same > 0.0 {
            Self::Nutation
        } else {
            Self::Looping
        }
    }
}
