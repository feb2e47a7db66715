//! What an adaptive stepper has of the last step of its run: the state at any time within, and the flips.

use super::stepper::{Rule, Stepper};
use crate::body::State;
use crate::error::{Error, Refusal, Subject, finite};
use crate::number::Analytic;
use alloc::vec::Vec;
use num_traits::{FromPrimitive, ToPrimitive};

impl<T: Analytic + Copy + FromPrimitive + ToPrimitive + Send + Sync> Stepper<T> {
    /// The tolerance of an adaptive stepper and its budget; none of another, which has not what is requested.
    pub(super) fn tolerance(&self, what: Subject) -> Result<(f64, usize), Error> {
        if let Rule::Adaptive { tolerance, budget } = self.rule {
            return Ok((tolerance, budget));
        }
        let why = "steps of a fixed method give their ends alone: make the stepper by `Stepper::adaptive`";
        Err(Refusal::Undefined { what, why }.into())
    }

    /// The state at a time (s) within the last step that the run of an [adaptive](Self::adaptive) stepper has
    /// taken, which may reach beyond [`time`](Self::time): from the step's own series, as accurate as the
    /// step. The stepper stays where it is.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// let inertia = Inertia::from_moments(1.0, 2.0, 2.5)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(0.1, 2.0, 0.3))?;
    /// let top = Torque::gravity(&Vector3::new(0.1, 0.2, 0.3), 4.0);
    /// let mut stepper = Stepper::<f64>::adaptive(&body, 1e-12, 1000)?.with_torques([top])?;
    /// let _ = stepper.step(0.1)?;
    /// let within = stepper.at(0.07)?;
    /// assert_eq!(stepper.step_to(0.07)?, within);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A stepper by a method of fixed steps, or a time outside the last step of the run.
    pub fn at(&self, time: f64) -> Result<State<T>, Error> {
        self.tolerance(Subject::MotionWithinStep)?;
        finite(Subject::Time, time)?;
        if time == self.time {
            return self.state().checked();
        }
        match &self.run {
            Some((run, began)) if run.holds(time - began) && run.reached(time - began) => {
                self.along_body(&run.read(time - began)?).checked()
            }
            _ => {
                let what = Subject::MotionOutsideStep;
                Err(Refusal::Undefined { what, why: "a run keeps no more than its last step" }.into())
            }
        }
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
        let there = self.run_to(finite(Subject::EndTime, end)?, tolerance, &mut budget, true)?;
        self.arrive(there, end)?;
        let Some((run, began)) = &mut self.run else { return Ok(Vec::new()) };
        let (mut flips, sign) = run.take_flips(end - *began).unwrap_or_default();
        for flip in &mut flips {
            *flip += *began;
        }
        self.sign = sign;
        Ok(flips)
    }
}
