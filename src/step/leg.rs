//! What a stepper has of its last step: the state at any time within, and the flips on the way.

use super::adaptive::{adaptive, adaptive_with_flips};
use super::stepper::{Rule, Stepper, number};
use crate::body::State;
use crate::error::{Error, Refusal, Subject, finite};
use crate::number::Analytic;
use alloc::vec::Vec;
use num_traits::{FromPrimitive, ToPrimitive};

/// Where a step began.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Leg<T: nalgebra::Scalar> {
    /// Along the principal axes.
    pub(super) state: State<T>,
    /// s.
    pub(super) time: f64,
    /// The sign of the spin about the middle axis at the end of the step, if flips were looked for: where the
    /// spin is zero, that before.
    pub(super) side: f64,
}

impl<T: Analytic + Copy + FromPrimitive + ToPrimitive + Send + Sync> Stepper<T> {
    /// The tolerance of an adaptive stepper and its budget; none of another, which has not what is requested.
    pub(super) fn tolerance(&self, what: Subject) -> Result<(f64, usize), Error> {
        if let Rule::Adaptive { tolerance, budget } = self.rule {
            return Ok((tolerance, budget));
        }
        let why = "steps of a fixed method give their ends alone: make the stepper by `Stepper::adaptive`";
        Err(Refusal::Undefined { what, why }.into())
    }

    /// The state at a time (s) within the last step of an [adaptive](Self::adaptive) stepper, as accurate as
    /// the step. The stepper stays where it is.
    ///
    /// It goes there from the start of the step; a series takes as few terms as the way is short.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// let inertia = Inertia::from_moments(1.0, 2.0, 2.5)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(0.1, 2.0, 0.3))?;
    /// let top = Torque::gravity(&Vector3::new(0.1, 0.2, 0.3), 4.0);
    /// let mut stepper = Stepper::<f64>::adaptive(&body, 1e-12, 1000)?.with_torques([top])?;
    /// let mut other = stepper.clone();
    /// stepper.step(2.0)?;
    /// let (within, there) = (stepper.at(0.7)?, other.step(0.7)?);
    /// assert!((within.momentum - there.momentum).norm() < 1e-12);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A stepper by a method of fixed steps, a time outside the last step, or as [`step`](Self::step).
    pub fn at(&self, time: f64) -> Result<State<T>, Error> {
        let (tolerance, mut budget) = self.tolerance(Subject::MotionWithinStep)?;
        let (one, other) = (self.leg.time, self.time);
        let (first, last) = if one < other { (one, other) } else { (other, one) };
        if !(first..=last).contains(&finite(Subject::Time, time)?) {
            let what = Subject::MotionOutsideStep;
            return Err(Refusal::Undefined { what, why: "a stepper keeps no more than its last step" }.into());
        }
        let mut system = self.system.clone();
        system.set_time(T::from_f64(one).unwrap_or_else(T::zero));
        let there = adaptive(&system, &self.leg.state, time - one, tolerance, &mut budget)?;
        self.along_body(&there).checked()
    }

    /// Goes on to the time `end` (s), forth or back, and returns the times on the way at which the spin about
    /// the principal axis of the middle moment changes its sign, under torques too: each found to rounding
    /// on the series of its step. Where the spin is zero at the end, it has its flip where it leaves zero, in
    /// the next call.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia, exact::FreeMotion};
    /// // Drag in proportion to the tensor slows the free motion down and does nothing else: the spin is
    /// // e^(-ct) times that of the free body at the time (1 - e^(-ct))/c.
    /// let (moments, c) = (Vector3::new(1.0, 2.0, 2.6), 0.02);
    /// let body = Body::spinning(
    ///     Inertia::from_moments(moments.x, moments.y, moments.z)?,
    ///     UnitQuaternion::identity(),
    ///     &Vector3::new(0.5, 2.0, 0.3),
    /// )?;
    /// let drag = Torque::Damping(moments * c);
    /// let mut stepper = Stepper::<f64>::adaptive(&body, 1e-13, 1000)?.with_torques([drag])?;
    /// let flips = stepper.flips(60.0)?;
    /// let free: Vec<f64> = FreeMotion::of(&body)?.flips(0.0, (1.0 - f64::exp(-c * 60.0)) / c)?.collect();
    /// assert!(flips.len() == free.len() && flips.len() > 3);
    /// for (flip, free) in flips.iter().zip(&free) {
    ///     assert!(((1.0 - f64::exp(-c * flip)) / c - free).abs() < 1e-9);
    /// }
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A stepper by a method of fixed steps, a torque that is a function, two gravity gradients, three
    /// rates of periodic torques, or as [`step`](Self::step); the body then stays where it was.
    pub fn flips(&mut self, end: f64) -> Result<Vec<f64>, Error> {
        let (tolerance, mut budget) = self.tolerance(Subject::FlipWithinStep)?;
        let duration = finite(Subject::EndTime, end)? - self.time;
        let (state, mut flips, side) =
            adaptive_with_flips(&self.system, &self.state, duration, tolerance, &mut budget, self.leg.side)?;
        for flip in &mut flips {
            *flip += self.time;
        }
        let spin = number(self.system.omega(&state.momentum).sum());
        self.along_body(&state).checked()?;
        finite(Subject::Spin, spin)?;
        self.leg = Leg { state: core::mem::replace(&mut self.state, state), time: self.time, side };
        self.set_time(end);
        Ok(flips)
    }
}
