//! Free motion in closed form: the spin and the attitude of a torque-free body at any instant, to rounding.

mod circulating;
mod elementary;
mod klein;

use crate::error::{Error, finite, finite_vector};
use crate::inertia::possible_moments;
use crate::invariants::{Kind, classify};
use circulating::Elliptic;
use elementary::{Precession, Turn, scaled};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A free motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeMotion {
    moments: Vector3<f64>,
    start: Vector3<f64>,
    clock: f64,
    law: Law,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Law {
    AtRest,
    Steady(Turn),
    Symmetric(Precession),
    Elliptic(Elliptic),
}

impl FreeMotion {
    /// New.
    ///
    /// # Errors
    /// Bad.
    pub fn new(moments: &Vector3<f64>, omega: &Vector3<f64>) -> Result<Self, Error> {
        possible_moments(moments)?;
        finite_vector("the spin", omega)?;
        let (i, w): ([f64; 3], [f64; 3]) = ((*moments).into(), (*omega).into());
        let (unit_moments, unit_omega, clock) = scaled(&i, &w);
        let law = match classify(i, w) {
            Kind::Steady if *omega == Vector3::zeros() => Law::AtRest,
            Kind::Steady => Law::Steady(Turn::along(unit_omega.map(Into::into))),
            Kind::Symmetric(axis) => {
                Law::Symmetric(Precession::new(&unit_moments, axis, &unit_omega, omega))
            }
            Kind::Asymmetric(motion) => Law::Elliptic(Elliptic::new(&motion, &w)),
        };
        let clock = crate::scale::times_power_of_two(1.0, clock);
        Ok(Self { moments: *moments, start: *omega, clock, law })
    }

    /// Spin.
    ///
    /// # Errors
    /// Bad time.
    pub fn omega(&self, t: f64) -> Result<Vector3<f64>, Error> {
        let time = finite("the time", t)? * self.clock;
        Ok(match &self.law {
            _ if t == 0.0 => self.start,
            Law::AtRest | Law::Steady(_) => self.start,
            Law::Symmetric(precession) => precession.omega(time),
            Law::Elliptic(motion) => motion.omega(time),
        })
    }

    /// Both.
    ///
    /// # Errors
    /// Bad time.
    pub fn at(&self, t: f64) -> Result<(Vector3<f64>, UnitQuaternion<f64>), Error> {
        let time = finite("the time", t)? * self.clock;
        let (omega, attitude) = match &self.law {
            _ if t == 0.0 => (self.start, Quaternion::identity()),
            Law::AtRest => (self.start, Quaternion::identity()),
            Law::Steady(turn) => (self.start, turn.at(time)),
            Law::Symmetric(precession) => (precession.omega(time), precession.attitude(time)),
            Law::Elliptic(motion) => motion.at(time),
        };
        Ok((omega, UnitQuaternion::new_unchecked(attitude)))
    }
}
