//! Free motion in closed form: the spin and the attitude of a torque-free body at any instant.
//!
//! Prepare a [`FreeMotion`] once from the moments and the spin at time 0; each later (or earlier) instant
//! then costs the same, however far away it is. The spin is Jacobi's solution ([LL76](crate::references),
//! section 37), computed by theta functions of the phase. The attitude is computed by two more theta
//! functions, which give its Cayley-Klein parameters ([KS97](crate::references); [vZS07](crate::references)
//! has theta functions for the rotation matrix). Nothing is integrated in time, so no errors of steps add up:
//! in tests, the error is a few times that caused by rounding the inputs.
//!
//! ```
//! use nalgebra::Vector3;
//! use tumbling::{PrincipalMoments, exact::FreeMotion};
//!
//! // A box spun about its middle axis, with a slip of a thousandth.
//! let moments = PrincipalMoments::new(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0)?;
//! let motion = FreeMotion::new(moments, &Vector3::new(1.0, 0.0, 1e-3))?;
//! let flip = motion.next_flip(0.0)?.unwrap();
//! let after = motion.at(flip * 2.0)?;
//! assert!((after.omega.x + 1.0).abs() < 1e-6); // turned over
//! // The momentum has not moved in the world.
//! let momentum = after.attitude * moments.vector().component_mul(&after.omega);
//! assert!((momentum - Vector3::new(10.0 / 12.0, 0.0, 5e-3 / 12.0)).norm() < 1e-14);
//! # Ok::<(), tumbling::Error>(())
//! ```

// Formulas are cited by their numbers, as (C1), in the derivation: book/chapters/closed-form.md.

mod batch;
mod cayley_klein;
mod elementary;
mod elliptic;
mod elliptic_motion;
mod flips;
mod geometry;
mod mount;
mod regime;
mod sensitivity;
pub(crate) mod series;
mod top;

pub use batch::Batch;
pub use flips::Flips;
pub use geometry::{Polhode, time_between_flips};
pub use regime::Regime;
pub use top::{LagrangeTop, TopRegime};

use crate::body::Body;
use crate::dynamics::invariants::{Kind, classify};
use crate::error::{Error, Refusal, Subject, finite, finite_vector, representable};
use crate::inertia::{Axis, Frame, PrincipalMoments};
use crate::number::times_power_of_two;
use elementary::{Precession, Turn, scaled};
use elliptic_motion::EllipticMotion;
use flips::Clock;
use mount::{Mount, spin_along};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// The free motion of one body from one start, prepared for any instant.
///
/// Times are in seconds from the start and may be negative. At time 0 the result equals the start to the last
/// bit. For times so long that the inputs do not determine even the first digit of the phase, the result is
/// still a spin and an attitude that the motion passes through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeMotion {
    moments: PrincipalMoments,
    start: Vector3<f64>,
    exponent: i32,
    clock: f64,
    law: Motion,
    mount: Option<Mount>,
}

/// The thinnest needle: products of three moments must keep their digits. A line of atoms is far from it.
const THINNEST: f64 = 1e-100;

#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "a box would cost each instant a detour, and the motion its `Copy`"
)]
enum Motion {
    AtRest,
    Steady(Turn),
    Symmetric(Precession),
    Elliptic(EllipticMotion),
}

/// A body in free motion at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant {
    /// Angular velocity in body axes, rad/s.
    pub omega: Vector3<f64>,
    /// Attitude, body to world.
    pub attitude: UnitQuaternion<f64>,
}

impl FreeMotion {
    /// From the principal moments and the spin (rad/s) along the same axes at time 0. The attitude at that
    /// time is the identity: the axes of world and body coincide.
    ///
    /// # Errors
    /// A moment that is less than 1e-100 of another; a spin that is not finite; a spin so large that the spin
    /// or the precession rate exceeds `f64` during the motion; or a spin so close to the separatrix (a
    /// deviation of less than 1e-570 of the spin) that `f64` cannot distinguish the two.
    pub fn new(moments: PrincipalMoments, omega: &Vector3<f64>) -> Result<Self, Error> {
        finite_vector(Subject::Spin, omega)?;
        let (i, w): ([f64; 3], [f64; 3]) = (moments.into(), (*omega).into());
        let (unit_moments, unit_omega, exponent) = scaled(&i, &w);
        let thinnest = unit_moments.iter().copied().fold(1.0, f64::min);
        Refusal::TooSmall {
            what: Subject::SmallestMoment,
            value: moments.smallest(),
            least: THINNEST * moments.largest(),
            meaning: "1e-100 of the largest moment",
        }
        .when(thinnest < THINNEST)?;
        let law = match classify(moments, omega) {
            Kind::Steady if *omega == Vector3::zeros() => Motion::AtRest,
            Kind::Steady => Motion::Steady(Turn::along(unit_omega.map(Into::into))),
            Kind::Symmetric(axis) => {
                Motion::Symmetric(Precession::new(&unit_moments, axis, &unit_omega, omega))
            }
            Kind::Asymmetric(motion) => Motion::Elliptic(EllipticMotion::new(&motion, &w)?),
        };
        let clock = times_power_of_two(1.0, exponent);
        // With room for the roundings on the way.
        law.has_room_for(1.0 + 1e-12, exponent)?;
        Ok(Self { moments, start: *omega, exponent, clock, law, mount: None })
    }

    /// The free motion of `body` from its attitude and momentum. Results are in the axes of its tensor, which
    /// need not be principal.
    ///
    /// For a tensor that is not diagonal, the principal axes are rounded: the motion is then that of a tensor
    /// that differs by some units in the last place of the largest entry. For a needle whose smallest moment
    /// is `e` times its largest, this is a large relative error: the smallest moment is accurate to a
    /// relative `4/e` x 2^-53, and spin and attitude in the first few radians to `8/e` x 2^-53, which is
    /// 9e-10 for `e` of 1e-6 and 9e-4 for 1e-12. A diagonal tensor loses nothing.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::{Body, Inertia, exact::FreeMotion};
    /// let turned = UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9);
    /// let inertia = Inertia::from_moments(1.0, 2.0, 2.5)?.turned(turned)?;
    /// let body = Body::spinning(inertia, turned.inverse(), &Vector3::new(0.5, -1.0, 0.2))?;
    /// let after = FreeMotion::of(&body)?.at(123.0)?;
    /// let momentum = after.attitude * inertia.momentum(&after.omega);
    /// assert!((momentum - body.momentum_world()).norm() < 1e-13);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A smallest moment that is zero to rounding, or the errors of [`new`](Self::new).
    pub fn of(body: &Body) -> Result<Self, Error> {
        let (moments, to_body) = body.inertia().along_principal_axes()?;
        let frame = to_body.map_or(Frame::BODY, |to_body| Frame::new(to_body.into_inner()));
        let motion = Self::new(moments, &spin_along(body, moments, &frame)?)?;
        if !frame.is_body() {
            motion.law.has_room_for(mount::ROOM_TO_TURN, motion.exponent)?;
        }
        let mount = Mount::new(frame, body.attitude(), body.omega_body());
        let body = Some((body.inertia(), body.momentum_world()));
        Ok(Self { mount: Some(Mount { body, ..mount }), ..motion })
    }

    /// The same motion with another attitude (body to world) at time 0.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::{PrincipalMoments, exact::FreeMotion};
    /// let motion = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 2.5)?, &Vector3::new(0.5, -1.0, 0.2))?;
    /// let start = UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9);
    /// let turned = motion.with_attitude(start)?;
    /// assert_eq!(turned.at(0.0)?.attitude, start);
    /// assert!(turned.at(7.0)?.attitude.angle_to(&(start * motion.at(7.0)?.attitude)) < 1e-15);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// An attitude whose length is not 1 to a billionth, or that is not finite.
    pub fn with_attitude(self, attitude: UnitQuaternion<f64>) -> Result<Self, Error> {
        let attitude = crate::attitude::checked(attitude)?;
        let Some(mount) = self.mount else {
            let same = attitude == UnitQuaternion::identity();
            let mount = (!same).then(|| Mount::new(Frame::BODY, attitude, self.start));
            return Ok(Self { mount, ..self });
        };
        // The momentum turns with the body.
        let turn = attitude * mount.attitude.inverse();
        let body = mount.body.map(|(inertia, momentum)| (inertia, turn * momentum));
        Ok(Self { mount: Some(Mount { body, ..Mount::new(mount.frame, attitude, mount.omega) }), ..self })
    }

    /// Angular velocity in body axes at time `t`, rad/s. Does not compute the attitude.
    ///
    /// # Errors
    /// A time that is not finite.
    #[inline(always)]
    pub fn omega(&self, t: f64) -> Result<Vector3<f64>, Error> {
        let time = finite(Subject::Time, t)? * self.clock;
        if time == 0.0 {
            return Ok(self.first().omega);
        }
        Ok(self.in_body(self.omega_along(time)))
    }

    /// The spin along the principal axes.
    fn omega_along(&self, time: f64) -> Vector3<f64> {
        match &self.law {
            Motion::AtRest | Motion::Steady(_) => self.start,
            Motion::Symmetric(precession) => precession.omega(time),
            Motion::Elliptic(motion) => motion.omega(time),
        }
    }

    /// Attitude at time `t`, body to world: less work than [`at`](Self::at) where the spin is not needed.
    ///
    /// # Errors
    /// A time that is not finite.
    #[inline(always)]
    pub fn attitude(&self, t: f64) -> Result<UnitQuaternion<f64>, Error> {
        let time = finite(Subject::Time, t)? * self.clock;
        if time == 0.0 {
            return Ok(self.first().attitude);
        }
        Ok(self.in_world(self.turned(time).into_inner()))
    }

    /// The turn of the principal axes since the start, at a scaled time other than zero.
    fn turned(&self, time: f64) -> UnitQuaternion<f64> {
        UnitQuaternion::new_unchecked(match &self.law {
            Motion::AtRest => Quaternion::identity(),
            Motion::Steady(turn) => turn.at(time),
            Motion::Symmetric(precession) => precession.attitude(time),
            Motion::Elliptic(motion) => motion.attitude(time),
        })
    }

    /// Spin and attitude at time `t`, which share most of their work.
    ///
    /// # Errors
    /// A time that is not finite.
    pub fn at(&self, t: f64) -> Result<Instant, Error> {
        let time = finite(Subject::Time, t)? * self.clock;
        if time == 0.0 {
            return Ok(self.first());
        }
        let (omega, turned) = self.along_principal_axes(time);
        if self.mount.is_none() {
            return Ok(Instant { omega, attitude: UnitQuaternion::new_unchecked(turned) });
        }
        Ok(Instant { omega: self.in_body(omega), attitude: self.in_world(turned) })
    }

    /// The spin along the principal axes, and their turn since the start, at a scaled time other than zero.
    #[inline(always)]
    fn along_principal_axes(&self, time: f64) -> (Vector3<f64>, Quaternion<f64>) {
        // Most motions are: first.
        if let Motion::Elliptic(motion) = &self.law {
            return motion.at(time);
        }
        (self.omega_along(time), self.turned(time).into_inner())
    }

    /// The start, as it was given.
    #[cold]
    fn first(&self) -> Instant {
        match &self.mount {
            None => Instant { omega: self.start, attitude: UnitQuaternion::identity() },
            Some(mount) => Instant { omega: mount.omega, attitude: mount.attitude },
        }
    }

    /// The spin in body axes, from that along the principal axes.
    #[inline(always)]
    fn in_body(&self, omega: Vector3<f64>) -> Vector3<f64> {
        self.mount.as_ref().map_or(omega, |mount| mount.in_body(omega))
    }

    #[inline(always)]
    fn in_world(&self, turned: Quaternion<f64>) -> UnitQuaternion<f64> {
        UnitQuaternion::new_unchecked(self.mount.as_ref().map_or(turned, |mount| mount.in_world(turned)))
    }

    /// What kind of motion it is, with its constants in SI units.
    #[must_use]
    pub fn regime(&self) -> Regime {
        let per_second = |rate: f64| times_power_of_two(rate, self.exponent);
        match &self.law {
            Motion::AtRest => Regime::AtRest,
            Motion::Steady(turn) => Regime::Steady { speed: per_second(turn.rate()) },
            Motion::Symmetric(top) => {
                let largest = self.moments.axis(Axis::Largest) == top.axis;
                Regime::SymmetricTop {
                    axis: if largest { Axis::Largest } else { Axis::Smallest },
                    nutation: per_second(top.nutation_turns() * core::f64::consts::TAU),
                    precession: per_second(top.about_momentum.rate()),
                }
            }
            Motion::Elliptic(motion) => motion.regime(per_second),
        }
    }

    /// The first instant after `t` at which the spin along the middle axis changes sign, s. `None` if there
    /// is none: a steady spin, two equal moments, or the separatrix once it has flipped.
    ///
    /// If that spin is exactly zero at the start, that flip is at time exactly 0, and so it is not after 0.
    ///
    /// # Errors
    /// A time that is not finite, one with more than 9e15 flips between it and the start, or a flip beyond
    /// `f64`.
    pub fn next_flip(&self, t: f64) -> Result<Option<f64>, Error> {
        finite(Subject::Time, t)?;
        let Some((clock, exponent)) = self.clock_of_flips() else { return Ok(None) };
        let next = clock.next_after(t, exponent)?;
        representable(Subject::NextFlip, next.as_slice()).map(|()| next)
    }

    /// All instants after `from` and up to `to` at which the spin along the middle axis changes sign, in
    /// order, one at a time: an interval with a billion flips needs no more memory than one with two, and
    /// [`Flips::remaining`] counts them without computing each.
    ///
    /// A flip at `from` is excluded and one at `to` is included, so that adjacent intervals count each flip
    /// once. If the spin along the middle axis is exactly zero at the start, that flip is at time exactly 0.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::{PrincipalMoments, exact::FreeMotion};
    /// let motion = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 3.0)?, &Vector3::new(0.0, 10.0, 0.001))?;
    /// let times: Vec<String> = motion.flips(0.0, 10.0)?.map(|t| format!("{t:.4}")).collect();
    /// assert_eq!(times, ["1.7402", "5.2207", "8.7012"]);
    /// let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
    /// let from_a_flip = FreeMotion::new(moments, &Vector3::new(-1.0, 0.0, 0.2))?;
    /// assert_eq!(from_a_flip.flips(-0.1, 0.0)?.collect::<Vec<_>>(), [0.0]);
    /// assert_eq!(from_a_flip.flips(0.0, 0.1)?.count(), 0);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A time that is not finite, or one with more than 2.2e15 flips between it and the start: farther away,
    /// successive flips can have the same time in `f64`.
    pub fn flips(&self, from: f64, to: f64) -> Result<Flips, Error> {
        finite(Subject::IntervalStart, from)?;
        finite(Subject::IntervalEnd, to)?;
        Flips::between(self.clock_of_flips(), from, to)
    }

    fn clock_of_flips(&self) -> Option<(Clock, i32)> {
        match &self.law {
            Motion::Elliptic(motion) => Some((motion.clock(), self.exponent)),
            Motion::AtRest | Motion::Steady(_) | Motion::Symmetric(_) => None,
        }
    }
}
