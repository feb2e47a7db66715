//! Lagrange's top in closed form: a symmetric body that turns about a fixed point on its axis under its
//! weight.

mod factor;
mod integrals;
mod kind;
mod mounted;
mod nutation;
mod precession;

pub use kind::TopRegime;

use super::Instant;
use super::elementary::Turn;
use super::geometry::seconds;
use super::mount::spin_along;
use crate::attitude::{checked, product};
use crate::body::Body;
use crate::error::{Error, Refusal, Subject, finite, finite_vector, not_negative, representable};
use crate::inertia::{Frame, PrincipalMoments};
use crate::number::functions::{atan2, hypot};
use crate::number::{DoubleDouble, exponent, times_power_of_two};
use integrals::{Integrals, Start};
use mounted::Mounted;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
use nutation::Nutation;

/// The motion of one top from one start, prepared for any instant.
///
/// A body with two equal moments is held at a point of its axis of symmetry, and its weight pulls along the
/// world's -z: the case of [`Torque::gravity`](crate::step::Torque::gravity) that has a closed form, by
/// Lagrange. Attitude and spin are quotients of theta functions ([KS97](crate::references)). It covers a top
/// that nutates with waves, loops or cusps, a sleeping top, a top that falls from the sleeping position, a
/// pendulum, and, without weight or arm, the free motion of a symmetric body.
///
/// Times are in seconds from the start and may be negative. At time 0 the result equals the start to the last
/// bit.
///
/// ```
/// use nalgebra::{UnitQuaternion, Vector3};
/// use tumbling::PrincipalMoments;
/// use tumbling::exact::LagrangeTop;
/// // A top of 0.1 kg, 4 cm from its point to its centre, at 200 rad/s, let go at a lean of 0.5 rad.
/// let moments = PrincipalMoments::new(2e-4, 2e-4, 5e-5)?;
/// let leaning = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.5);
/// let (spin, arm) = (Vector3::new(0.0, 0.0, 200.0), Vector3::new(0.0, 0.0, 0.04));
/// let top = LagrangeTop::new(moments, leaning, &spin, &arm, 0.1 * 9.81)?;
/// let [highest, lowest] = top.lean();
/// assert!((highest - 0.5).abs() < 1e-12 && (lowest - 0.5947).abs() < 1e-4);
/// // It goes round at nearly weight x arm / (moment x spin) = 3.92 rad/s, and comes back up to its lean.
/// assert!((top.precession_rate() - 4.219).abs() < 1e-3);
/// let lean = |t: f64| top.attitude(t).map(|q| (q * Vector3::z()).z.acos());
/// assert!((lean(top.period()?.unwrap())? - 0.5).abs() < 1e-12);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LagrangeTop {
    mounted: Mounted,
    start: Instant,
    /// The top's own axes: spin along the third at the start, rad/s.
    along: f64,
    exponent: i32,
    clock: f64,
    law: TopMotion,
    constants: Constants,
}

/// In SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Constants {
    energy: f64,
    momentum_along: f64,
    lean: [f64; 2],
    regime: TopRegime,
}

#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "a box would cost each instant a detour, and the motion its `Copy`"
)]
enum TopMotion {
    /// A turn about the top's axis, which does not move.
    Steady(Turn),
    Nutation(Nutation),
}

/// Below this part of the rates a small number, or its square, would lose digits.
const SMALLEST: f64 = 1e-140;

impl LagrangeTop {
    /// From the principal moments about the fixed point (kg m²), the attitude (principal axes to world) and
    /// the spin (rad/s, along the principal axes) at time 0, the vector from the fixed point to the centre of
    /// mass (m, along the principal axes) and the weight (N), which pulls along the world's -z.
    ///
    /// # Errors
    /// Two moments across the arm that differ, or an arm off its principal axis, by more than rounding
    /// (a relative 1e-14); a value that is not finite; a weight below zero; a rate or an energy beyond `f64`.
    ///
    /// A value that is nearly zero is refused, not taken for zero, since a top at zero may sleep or hang: a
    /// lean from the vertical below about 1e-70 rad, a spin across the axis below about 1e-70 of the fastest
    /// rate, a torque of the weight below about 1e-140 of the moment across the axis times the square of that
    /// rate. Zero itself is accepted.
    pub fn new(
        moments: PrincipalMoments,
        attitude: UnitQuaternion<f64>,
        omega: &Vector3<f64>,
        arm: &Vector3<f64>,
        weight: f64,
    ) -> Result<Self, Error> {
        finite_vector(Subject::Spin, omega)?;
        finite_vector(Subject::Arm, arm)?;
        not_negative(Subject::Weight, weight)?;
        let attitude = checked(attitude)?;
        let mounted = Mounted::new(moments, arm)?;
        let torque = DoubleDouble::product(mounted.arm, weight).abs();
        let q = mounted.frame.attitude_of_axes(attitude.into_inner());
        let spin = mounted.frame.along(omega);
        let (across, polar) = (DoubleDouble::from(mounted.across), DoubleDouble::from(mounted.polar));
        let along = polar * spin.z / across;
        let pull = torque * 2.0 / across;
        let rates = [spin.x, spin.y, along.hi(), spin.z, pull.hi().sqrt()];
        let fastest = rates.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        Refusal::OutOfRange { what: Subject::TopFastestRate, value: fastest }
            .when(!fastest.is_finite() || !pull.hi().is_finite())?;
        let power = exponent(fastest).clamp(-1000, 1000);
        let scaled = |x: f64| times_power_of_two(x, -power);
        let start = Start {
            alpha: [q.w, q.k],
            beta: [q.i, q.j],
            across: [scaled(spin.x), scaled(spin.y)],
            along: along.scaled(-power),
            pull: pull.scaled(-power).scaled(-power),
        };
        let integrals = Integrals::new(&start);
        in_range(&integrals, &start, &spin, mounted.arm != 0.0 && weight != 0.0)?;
        let still = integrals.across_squared.hi() == 0.0;
        let upright = integrals.from_bottom.hi() == 0.0 || integrals.from_top.hi() == 0.0;
        let law = if still && (upright || start.pull.hi() == 0.0) {
            TopMotion::Steady(Turn::along([0.0, 0.0, scaled(spin.z)].map(DoubleDouble::from)))
        } else {
            let ahead = DoubleDouble::from(scaled(spin.z)) - start.along;
            TopMotion::Nutation(integrals.nutation(&start, ahead))
        };
        let constants = Constants::new(&mounted, &integrals, &law, power);
        let top = Self {
            mounted,
            start: Instant { omega: *omega, attitude },
            along: spin.z,
            exponent: power,
            clock: times_power_of_two(1.0, power),
            law,
            constants,
        };
        top.checked()
    }

    /// The motion of `body` from its attitude and momentum. Its tensor must be the one about the fixed point,
    /// and the arm is in the axes of that tensor.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::exact::{LagrangeTop, TopRegime};
    /// use tumbling::solid::{Cone, Solid};
    /// use tumbling::Body;
    /// // A cone on its tip, leaning by 0.3 rad.
    /// let cone = Cone::new(0.02, 0.05)?.with_mass(0.1)?;
    /// let arm = Vector3::new(0.0, 0.0, 0.0375);
    /// let leaning = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.3);
    /// let body = Body::spinning(cone.about(&-arm)?, leaning, &Vector3::new(0.0, 0.0, 300.0))?;
    /// let top = LagrangeTop::of(&body, &arm, cone.mass() * 9.81)?;
    /// assert_eq!(top.regime(), TopRegime::Cusped);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A smallest moment that is zero to rounding, or as [`new`](Self::new). Where the tensor is not
    /// diagonal, the rounding of its entries turns its axes, and more so the less the moments differ. Then
    /// the arm may be off the axis by 1e-14 divided by the relative difference of the moments along and
    /// across it, and the direction of the arm is used as the axis.
    pub fn of(body: &Body, arm: &Vector3<f64>, weight: f64) -> Result<Self, Error> {
        finite_vector(Subject::Arm, arm)?;
        let (moments, frame) = body.inertia().along_principal_axes()?;
        let start = Instant { omega: body.omega_body(), attitude: body.attitude() };
        let Some(frame) = frame else {
            let omega = spin_along(body, moments, &Frame::BODY)?;
            return Ok(Self { start, ..Self::new(moments, body.attitude(), &omega, arm, weight)? });
        };
        let (turn, arm) = mounted::onto_arm(moments, &(frame.inverse() * arm))?;
        let frame = frame * turn;
        let omega = spin_along(body, moments, &Frame::new(frame.into_inner()))?;
        let top = Self::new(moments, body.attitude() * frame, &omega, &arm, weight)?;
        Ok(Self { mounted: top.mounted.within(&frame), start, ..top })
    }

    /// Spin (body axes, rad/s) and attitude (body to world) at time `t`.
    ///
    /// In tests the energy is kept to 1e-13 and both momenta to 1e-11 up to some 1e18 rad of turning. Later
    /// the phases lose their last digits.
    ///
    /// # Errors
    /// A time that is not finite.
    pub fn at(&self, t: f64) -> Result<Instant, Error> {
        let time = finite(Subject::Time, t)? * self.clock;
        if time == 0.0 {
            return Ok(self.start);
        }
        Ok(match &self.law {
            TopMotion::Steady(turn) => {
                let attitude = product(
                    self.start.attitude.quaternion(),
                    &self.mounted.frame.turn_in_body(turn.at(time)),
                );
                Instant { omega: self.start.omega, attitude: UnitQuaternion::new_unchecked(attitude) }
            }
            TopMotion::Nutation(nutation) => {
                let ([[w, z], [x, y]], [first, second]) = nutation.at(time);
                let q = Quaternion::new(w, x, y, z);
                let inverse = 1.0 / q.norm();
                let scaled = |x: f64| times_power_of_two(x, self.exponent);
                let omega = Vector3::new(scaled(first), scaled(second), self.along);
                let attitude =
                    UnitQuaternion::new_unchecked(self.mounted.frame.attitude_of_body(q * inverse));
                Instant { omega: self.mounted.frame.in_body(omega), attitude }
            }
        })
    }

    /// Attitude at time `t`, body to world.
    ///
    /// # Errors
    /// A time that is not finite.
    pub fn attitude(&self, t: f64) -> Result<UnitQuaternion<f64>, Error> {
        self.at(t).map(|at| at.attitude)
    }

    /// Angular velocity in body axes at time `t`, rad/s.
    ///
    /// # Errors
    /// A time that is not finite.
    pub fn omega(&self, t: f64) -> Result<Vector3<f64>, Error> {
        self.at(t).map(|at| at.omega)
    }

    /// The body at time `t`, with its tensor about the fixed point.
    ///
    /// # Errors
    /// A time that is not finite, or a momentum beyond `f64`.
    pub fn body(&self, t: f64) -> Result<Body, Error> {
        let Instant { omega, attitude } = self.at(t)?;
        Body::spinning(self.mounted.inertia()?, attitude, &omega)
    }

    /// The time from one highest position of the axis to the next, s: the period of the nutation. `None`
    /// where the lean is constant, and on the separatrix, where the axis does not return.
    ///
    /// # Errors
    /// A period beyond `f64`.
    pub fn period(&self) -> Result<Option<f64>, Error> {
        let TopMotion::Nutation(nutation) = &self.law else { return Ok(None) };
        let scaled = nutation.half_period.hi();
        if scaled.is_infinite() || self.constants.regime == TopRegime::SteadyPrecession {
            return Ok(None);
        }
        seconds(Subject::Period, scaled, self.exponent).map(Some)
    }

    /// The mean rate at which the axis precesses about the vertical over a period, rad/s; counter-clockwise
    /// seen from above is positive. It is accurate to the rounding of the inputs times its condition number,
    /// however slow it is relative to the spin. It is zero where the axis does not move. Where the axis
    /// passes exactly through the vertical, as in a plane pendulum, its azimuth jumps by half a turn; these
    /// jumps do not count. On the separatrix it is the limit of the rate at late times.
    #[must_use]
    pub fn precession_rate(&self) -> f64 {
        match &self.law {
            TopMotion::Steady(_) => 0.0,
            TopMotion::Nutation(nutation) => times_power_of_two(nutation.precession, self.exponent),
        }
    }

    /// The least and the greatest angle between the vertical and the axis, taken from the fixed point to the
    /// centre of mass, rad: 0 is upright.
    #[must_use]
    pub fn lean(&self) -> [f64; 2] {
        self.constants.lean
    }

    /// What kind of motion it is.
    #[must_use]
    pub fn regime(&self) -> TopRegime {
        self.constants.regime
    }

    /// Kinetic energy and that of the weight's height above the fixed point, J: constant.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.constants.energy
    }

    /// The momentum about the top's axis, taken from the fixed point to the centre of mass, kg m²/s:
    /// constant.
    #[must_use]
    pub fn momentum_about_axis(&self) -> f64 {
        self.constants.momentum_along
    }

    /// That no constant has left the range of `f64`.
    fn checked(self) -> Result<Self, Error> {
        let Constants { energy, momentum_along, lean, .. } = self.constants;
        // With room for a turn.
        let fastest = match &self.law {
            TopMotion::Steady(_) => 0.0,
            TopMotion::Nutation(nutation) if nutation.is_finite() => {
                let greatest = hypot(nutation.carriers[2].greatest, nutation.rate);
                times_power_of_two(4.0 * greatest, self.exponent)
            }
            TopMotion::Nutation(_) => f64::INFINITY,
        };
        let rates = [energy, momentum_along, self.precession_rate(), 4.0 * self.along, fastest];
        representable(Subject::TopRate, &lean)?;
        representable(Subject::TopRate, &rates).map(|()| self)
    }
}

/// Refuses what is not zero but too small for its square to have all its digits, or to be above zero.
fn in_range(integrals: &Integrals, start: &Start, spin: &Vector3<f64>, pulled: bool) -> Result<(), Error> {
    let Integrals { from_bottom, from_top, across_squared, pull, .. } = integrals;
    for (what, square, present) in [
        (Subject::TopHanging, from_bottom, start.alpha != [0.0; 2]),
        (Subject::TopUpright, from_top, start.beta != [0.0; 2]),
        (Subject::TopSpinAcross, across_squared, spin.x != 0.0 || spin.y != 0.0),
        (Subject::TopTorque, pull, pulled),
    ] {
        let value = square.hi();
        representable(what, &[value])?;
        Refusal::Underflow { what, value, least: SMALLEST }
            .when((present || value != 0.0) && value.abs() < SMALLEST)?;
    }
    Ok(())
}

impl Constants {
    fn new(mounted: &Mounted, integrals: &Integrals, law: &TopMotion, power: i32) -> Self {
        let Integrals { along, pull, across_squared, .. } = integrals;
        let polar_spin = mounted.across / mounted.polar * along.hi();
        let twice = *across_squared + *pull * integrals.height() + *along * polar_spin;
        let energy = times_power_of_two(0.5 * mounted.across * twice.hi(), power);
        let root = |x: DoubleDouble| x.hi().max(0.0).sqrt();
        let angle = |k: usize| 2.0 * atan2(root(integrals.tops[k]), root(integrals.bottoms[k]));
        let steady = matches!(law, TopMotion::Steady(_));
        let here = 2.0 * atan2(root(integrals.from_top), root(integrals.from_bottom));
        Self {
            energy: times_power_of_two(energy, power),
            momentum_along: times_power_of_two(along.hi() * mounted.across, power),
            lean: if steady { [here; 2] } else { [angle(1), angle(0)] },
            regime: TopRegime::new(integrals, steady, polar_spin),
        }
    }
}

#[cfg(test)]
mod tests;
