//! Quantities derived from a motion: the body at a time, its energy, its period, its angles to the momentum,
//! and its twist.
//!
//! The period of the spin and its path in the body follow from the conserved quantities alone.

use super::elliptic::quarter_period_from_root;
use super::{FreeMotion, Motion};
use crate::body::Body;
use crate::dynamics::invariants::{Asymmetric, Kind, classify};
use crate::dynamics::observe::energy;
use crate::error::{Error, Refusal, Subject, finite_vector, representable};
use crate::inertia::{Axis, Inertia, PrincipalMoments, unit};
use crate::number::functions::{atan2, hypot};
use crate::number::{DoubleDouble, Real, splat, times_power_of_two};
use core::f64::consts::PI;
use nalgebra::Vector3;

/// `K`, a quarter of the period in Jacobi's argument; infinite on the separatrix.
pub(super) fn quarter_period<T: Real>(motion: &Asymmetric<T>) -> DoubleDouble<T> {
    if motion.separatrix {
        return DoubleDouble::from(splat::<T>(f64::INFINITY));
    }
    quarter_period_from_root(motion.complement(0), motion.root_of_complement())
}

/// A length of time that is above zero, in scaled units, in seconds.
pub(super) fn seconds(what: Subject, scaled: f64, exponent: i32) -> Result<f64, Error> {
    let value = times_power_of_two(scaled, -exponent);
    Refusal::OutOfRange { what, value }.when(!value.is_finite() || value <= 0.0).map(|()| value)
}

/// The time between two flips of a free body, s: half the period of its spin in body axes. `None` where no
/// flip follows another: a steady spin, two equal moments, or exactly on the separatrix, where there is at
/// most one flip.
///
/// The spin (rad/s) is along the principal axes. A flip is when the spin component along the middle axis
/// changes sign; every other free motion does so periodically, even a stable libration, where the change is
/// small and fast. If that component is exactly zero at the start, there is a flip at time 0, and the result
/// is the time of the first flip after it.
///
/// The formula is `2 K / rate` [LL76](crate::references), section 37, with the elliptic integral `K` from the
/// arithmetic-geometric mean [Gau99](crate::references). It depends on small differences, which are computed
/// from the given moments, never from squares, so that the result is accurate even for a deviation of 1e-300.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::{PrincipalMoments, exact::time_between_flips};
/// let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
/// let book = time_between_flips(moments, &Vector3::new(0.0, 10.0, 0.001))?;
/// assert_eq!(format!("{:.4}", book.unwrap()), "3.4805");
/// assert_eq!(time_between_flips(moments, &Vector3::new(0.0, 10.0, 0.0))?, None);
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// # Errors
/// A spin that is not finite, or a time beyond `f64`.
pub fn time_between_flips(moments: PrincipalMoments, omega: &Vector3<f64>) -> Result<Option<f64>, Error> {
    finite_vector(Subject::Spin, omega)?;
    let Kind::Asymmetric(motion) = classify(moments, omega) else {
        return Ok(None);
    };
    if motion.separatrix {
        return Ok(None);
    }
    // (C36)
    let half_period = quarter_period(&motion) * 2.0 / motion.rate();
    seconds(Subject::TimeBetweenFlips, half_period.hi(), motion.clock).map(Some)
}

/// The extent of the closed curve that the spin of a free body traces in body axes (the polhode).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polhode {
    /// The smallest magnitude of the spin's component along each principal axis, rad/s.
    pub least: Vector3<f64>,
    /// The largest, rad/s.
    pub greatest: Vector3<f64>,
    /// The period, s. None where the spin is constant, or on the separatrix, where it never returns.
    pub period: Option<f64>,
}

impl Polhode {
    /// For principal moments (kg m²) and a spin (rad/s) along the same axes at any instant of the motion.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::{PrincipalMoments, exact::Polhode};
    /// // A spin about the middle axis, with a slip along the third: on the way it nears both others.
    /// let polhode = Polhode::new(PrincipalMoments::new(1.0, 2.0, 2.5)?, &Vector3::new(0.0, 5.0, 0.1))?;
    /// assert!((polhode.least - Vector3::new(0.0, 0.0, 0.1)).norm() < 1e-15);
    /// // C (C - A) w3² there is what C (C - A) w3² + B (B - A) w2² is at the start.
    /// assert!((polhode.greatest.z - (0.01 + 50.0 / 3.75_f64).sqrt()).abs() < 1e-15);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A spin that is not finite, a spin so large that it exceeds `f64` during the motion, or a period beyond
    /// `f64`.
    pub fn new(moments: PrincipalMoments, omega: &Vector3<f64>) -> Result<Self, Error> {
        finite_vector(Subject::Spin, omega)?;
        let still = omega.map(f64::abs);
        let polhode = match classify(moments, omega) {
            Kind::Steady => Self { least: still, greatest: still, period: None },
            Kind::Symmetric(axis) => {
                let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
                let across = hypot(omega[a], omega[b]);
                let (mut least, mut greatest) = (still, still);
                for across_axis in [a, b] {
                    (least[across_axis], greatest[across_axis]) = (0.0, across);
                }
                let rate = omega[axis] * ((moments[axis] - moments[a]) / moments[a]);
                let period = Some(core::f64::consts::TAU / rate.abs()).filter(|period| period.is_finite());
                Self { least, greatest, period }
            }
            Kind::Asymmetric(motion) => {
                let [across, middle, around] =
                    motion.amplitudes(0).map(|size| times_power_of_two(size.hi(), motion.clock));
                let (mut least, mut greatest) = (Vector3::zeros(), Vector3::zeros());
                greatest[motion.across] = across;
                greatest[motion.middle] = middle;
                greatest[motion.around] = around;
                // Zero on the separatrix.
                least[motion.around] = around * motion.complement(0).hi();
                let period = time_between_flips(moments, omega)?.map(|half| 2.0 * half);
                Self { least, greatest, period }
            }
        };
        representable(Subject::GreatestSpin, polhode.greatest.as_slice())?;
        representable(Subject::Period, polhode.period.as_slice())?;
        Ok(polhode)
    }
}

impl Motion {
    /// Refuses a motion whose greatest spin times `room` is beyond `f64`; scaled spins are times
    /// `2^-exponent`.
    pub(super) fn has_room_for(&self, room: f64, exponent: i32) -> Result<(), Error> {
        let greatest = match self {
            Self::AtRest => 0.0,
            Self::Steady(turn) => times_power_of_two(turn.rate(), exponent),
            Self::Symmetric(top) => {
                top.greatest_spin().max(times_power_of_two(top.about_momentum.rate(), exponent))
            }
            Self::Elliptic(motion) => motion.greatest,
        };
        representable(Subject::GreatestSpin, &[greatest * room])
    }
}

impl FreeMotion {
    /// The body at time `t`. Its momentum in world axes equals that of the start to the last bit.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::{Body, Inertia, exact::FreeMotion};
    /// let turned = UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9);
    /// let inertia = Inertia::from_moments(1.0, 2.0, 2.5)?.turned(turned)?;
    /// let body = Body::spinning(inertia, turned.inverse(), &Vector3::new(0.5, -1.0, 0.2))?;
    /// let motion = FreeMotion::of(&body)?;
    /// let after = motion.body(123.0)?;
    /// assert_eq!((after.inertia(), after.momentum_world()), (inertia, body.momentum_world()));
    /// assert!((after.omega_body() - motion.omega(123.0)?).norm() < 1e-14);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A time that is not finite, or a momentum beyond `f64`.
    pub fn body(&self, t: f64) -> Result<Body, Error> {
        let attitude = self.attitude(t)?;
        if let Some((inertia, momentum)) = self.mount.and_then(|mount| mount.body) {
            return Body::new(inertia, attitude, &momentum);
        }
        let (first, moments) = (self.first(), self.moments);
        let inertia = Inertia::from_moments(moments[0], moments[1], moments[2])?;
        let start = Body::spinning(inertia, first.attitude, &first.omega)?;
        start.with(attitude, &start.momentum_world())
    }

    /// Kinetic energy, J, which is constant. It is infinite above the range of `f64`; below the range it is
    /// zero or has lost digits.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::{PrincipalMoments, exact::FreeMotion};
    /// let motion = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 2.5)?, &Vector3::new(1.0, -1.0, 2.0))?;
    /// assert_eq!(motion.energy(), 6.5);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    #[must_use]
    pub fn energy(&self) -> f64 {
        // Of half the momentum, so that it is infinite only where the result is. The spin is halved, not the
        // moments: where a moment is near the least number, half of it is another.
        2.0 * energy(&self.start, &self.moments.vector().component_mul(&(self.start * 0.5)))
    }

    /// The period of the spin in body axes, s; it contains two flips. `None` where the spin is constant, and
    /// on the separatrix, where it never returns.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::{PrincipalMoments, exact::FreeMotion};
    /// let motion = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 3.0)?, &Vector3::new(0.0, 10.0, 0.001))?;
    /// assert_eq!(format!("{:.4}", motion.period()?.unwrap()), "6.9610");
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A period beyond `f64`.
    pub fn period(&self) -> Result<Option<f64>, Error> {
        let scaled = match &self.law {
            Motion::AtRest | Motion::Steady(_) => None,
            Motion::Symmetric(top) => Some(1.0 / top.nutation_turns().abs()),
            Motion::Elliptic(motion) => motion.half_period().map(|half| 2.0 * half),
        };
        scaled.map(|time| seconds(Subject::Period, time, self.exponent)).transpose()
    }

    /// The least and greatest angle, radians, between a principal axis and the angular momentum, over all of
    /// time. On the separatrix these angles are limits. Of two equal moments, the one given first counts as
    /// the smaller.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::{Axis, PrincipalMoments, exact::FreeMotion};
    /// // A libration about the axis of the largest moment. By hand: with the spin (0.03, 0, 1) a quarter
    /// // period later, that axis is 1/100 off the momentum, at the start 2/100.
    /// let motion = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 3.0)?, &Vector3::new(0.0, 0.03, 1.0))?;
    /// let text = |x: f64| format!("{:.2}", x.to_degrees());
    /// let degrees = |axis| motion.angles_to_momentum(axis).map(|angles| angles.map(text));
    /// assert_eq!(degrees(Axis::Largest)?, ["0.57", "1.15"]);
    /// assert_eq!(degrees(Axis::Middle)?, ["88.85", "91.15"]);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A body at rest, which has no momentum.
    pub fn angles_to_momentum(&self, axis: Axis) -> Result<[f64; 2], Error> {
        let axis = self.moments.axis(axis);
        let scaled = |v: Vector3<f64>, by: f64| v.map(|x| x / by);
        Refusal::ZeroVector { what: Subject::AngularMomentum }.when(self.start == Vector3::zeros())?;
        let momentum = scaled(self.moments.vector(), self.moments.largest())
            .component_mul(&scaled(self.start, self.start.amax()));
        let share = unit(Subject::AngularMomentum, &momentum)?;
        let around_a_right_angle = |along: f64, off: f64| {
            let least = atan2(off, along);
            [least, PI - least]
        };
        let off = |axis: usize| hypot(share[(axis + 1) % 3], share[(axis + 2) % 3]);
        Ok(match &self.law {
            Motion::AtRest | Motion::Steady(_) => [atan2(off(axis), share[axis]); 2],
            Motion::Symmetric(top) if top.axis == axis => [atan2(off(axis), share[axis]); 2],
            Motion::Symmetric(top) => around_a_right_angle(off(top.axis), share[top.axis].abs()),
            Motion::Elliptic(motion) => {
                // Where the two are nearly the same, each is rounded on its own.
                let [a, b] = motion.angles(axis);
                [a.min(b), a.max(b)]
            }
        })
    }

    /// The angle by which the body turns about its angular momentum during half a period of the spin, from
    /// one flip to the next, radians. It is never negative and not reduced by whole turns. `None` where there
    /// is no period, or where it is beyond `f64`.
    ///
    /// The turn is measured relative to the shortest rotation from the circled axis (for two equal moments,
    /// the third axis) to the momentum, which is always defined. After half a period the two components of
    /// the spin across the circled axis have changed sign, so the body stands as at first but turned by half
    /// a turn about the circled axis, and then by the twist and half a turn about the momentum; after a whole
    /// period, by two twists about the momentum. Divided by π it is the rotation number; where that is a
    /// ratio of integers, the motion in the world closes.
    #[must_use]
    pub fn twist_of_half_period(&self) -> Option<f64> {
        match &self.law {
            Motion::AtRest | Motion::Steady(_) => None,
            Motion::Symmetric(top) => Some(top.twist_of_half_period()).filter(|twist| twist.is_finite()),
            Motion::Elliptic(motion) => motion.twist_of_half_period(),
        }
    }
}
