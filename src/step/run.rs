//! A stepper with adaptive steps: its run, the state at any time within the run's last step, and flips.

use super::adaptive::{AdaptiveRun, Tracked, check_tolerance, unit_length};
use super::stepper::{Rule, Stepper};
use super::system::System;
use crate::body::{Body, State};
use crate::error::{Error, Refusal, Subject, finite};
use crate::inertia::{Frame, Inertia, PrincipalMoments};
use alloc::boxed::Box;
use alloc::vec::Vec;
use nalgebra::{UnitQuaternion, Vector3};

impl Stepper {
    /// A stepper for a free body with adaptive internal steps, called its run. The run keeps the estimated
    /// error of each internal step, relative to the attitude's length and the momentum's size, below
    /// `tolerance` or below 32 roundings, whichever is larger. The tolerance applies to each internal
    /// step, not to the whole motion: errors accumulate, and [`expected_error`](Stepper::expected_error)
    /// says how far they may.
    ///
    /// The run's steps are as long as the tolerance permits, whatever steps are requested: a state between
    /// their ends is evaluated by the step's own series (dense output), is as accurate as the step, and does
    /// not affect later states. So a torque given by a function is called with times later than those
    /// requested. A [`step`](Self::step) that needs more than `budget` steps of the run is refused.
    ///
    /// A step of the run is a Taylor series in the time, of an order between 6 and 24 set by the tolerance,
    /// whose error is estimated by the residual of the series in the law of motion at its end. The residual
    /// also gives an approximation of the next term, which is added, so that the step errs less than
    /// estimated. Where a torque is given by a function, it is a step of DOP853, the pair of Dormand and
    /// Prince of order 8. Where damping far faster than the motion would keep such steps short, the run uses
    /// collocation at Radau's nodes. After each the attitude is brought back to length 1, and the momentum of
    /// a free body to the length that it had at the start; these corrections count as errors of the step.
    ///
    /// ```
    /// use nalgebra::{Matrix3, UnitQuaternion, Vector3};
    /// use tumbling::step::Stepper;
    /// use tumbling::{Body, Inertia, exact::FreeMotion};
    /// let inertia = Inertia::try_from(Matrix3::new(3.0, 0.5, 0.0, 0.5, 2.0, 0.0, 0.0, 0.0, 4.0))?;
    /// let handle = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(6.0, 2.0, 0.01))?;
    /// let mut stepper = Stepper::adaptive(&handle, 1e-12, 100)?;
    /// // 120 frames at 60 Hz, in a few steps of the run.
    /// for state in stepper.run(1.0 / 60.0, 120) {
    ///     let attitude = state?.attitude; // draw it
    ///     assert!((attitude.norm() - 1.0).abs() < 1e-14);
    /// }
    /// assert!((stepper.omega() - FreeMotion::of(&handle)?.omega(stepper.time())?).norm() < 1e-9);
    /// assert!(stepper.steps_of_run() < 30);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`new`](Self::new), or a tolerance below four roundings.
    pub fn adaptive(body: &Body, tolerance: f64, budget: usize) -> Result<Self, Error> {
        check_tolerance(tolerance)?;
        Self::by(body, Rule::Adaptive { tolerance, budget })
    }

    /// An [adaptive](Self::adaptive) stepper for the body and the torques of a system, from a state along the
    /// system's axes.
    ///
    /// ```
    /// use nalgebra::{Quaternion, Vector3};
    /// use tumbling::PrincipalMoments;
    /// use tumbling::step::{State, Stepper, System, Torque};
    /// let top = Torque::gravity(&Vector3::new(0.05, 0.0, 0.1), 0.5);
    /// let system = System::with(PrincipalMoments::new(1.0, 2.0, 2.5)?, vec![top])?;
    /// let momentum = system.momentum(&Vector3::new(0.3, 2.0, 0.1));
    /// let start = State { attitude: Quaternion::identity(), momentum };
    /// let mut stepper = Stepper::of_system(system, &start, 1e-12, 1000)?;
    /// let end = stepper.step_to(10.0)?;
    /// assert_eq!(stepper.state(), end);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`adaptive`](Self::adaptive), or an attitude of length zero.
    pub fn of_system(
        system: System<f64>,
        start: &State<f64>,
        tolerance: f64,
        budget: usize,
    ) -> Result<Self, Error> {
        let inertia = Inertia::from(PrincipalMoments::try_from(*system.moments())?);
        let body = Body::new(inertia, UnitQuaternion::identity(), &Vector3::zeros())?;
        check_tolerance(tolerance)?;
        system.check_inverse()?;
        let mut state = (*start).checked()?;
        unit_length(&mut state.attitude)?;
        let (rule, frame) = (Rule::Adaptive { tolerance, budget }, Frame::BODY);
        let stepper = Self { body, rule, system, state, frame, time: 0.0, run: None, sign: 0.0, count: 0 };
        stepper.checked().map(|_| stepper)
    }

    /// The state at a time by a run that [holds](AdaptiveRun::holds) it: the one under way, or a new one.
    pub(super) fn run_to(
        &mut self,
        end: f64,
        tolerance: f64,
        budget: &mut usize,
        flips: bool,
    ) -> Result<State<f64>, Error> {
        let usable = |run: &AdaptiveRun, began: f64| {
            run.holds(end - began) && (!flips || run.flips_after(self.time - began, end - began))
        };
        let (mut run, began) = match self.run.take() {
            Some((run, began)) if usable(&run, began) => (run, began),
            _ => {
                let tracked = if flips { Tracked::Flips(self.sign) } else { Tracked::Nothing };
                let end_of_run = f64::INFINITY.copysign(end - self.time);
                let run = AdaptiveRun::new(self.system.clone(), &self.state, end_of_run, tolerance, tracked)?;
                (Box::new(run), self.time)
            }
        };
        let allowed = *budget;
        let there = run.at(end - began, budget);
        self.count += allowed - *budget;
        self.run = Some((run, began));
        there
    }

    /// The number of steps that the runs of an adaptive stepper have taken or rejected.
    #[must_use]
    pub fn steps_of_run(&self) -> usize {
        self.count
    }

    /// The tolerance and the budget of an adaptive stepper; for another, the error that it cannot do `what`.
    pub(super) fn tolerance(&self, what: Subject) -> Result<(f64, usize), Error> {
        if let Rule::Adaptive { tolerance, budget } = self.rule {
            return Ok((tolerance, budget));
        }
        let why = "steps of a fixed method give their ends alone: make the stepper by `Stepper::adaptive`";
        Err(Refusal::Undefined { what, why }.into())
    }

    /// The state at a time (s) within the last step that the run of an [adaptive](Self::adaptive) stepper has
    /// taken, which may reach beyond [`time`](Self::time). It is evaluated by the step's own series and is as
    /// accurate as the step. The stepper does not advance.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// let inertia = Inertia::from_moments(1.0, 2.0, 2.5)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(0.1, 2.0, 0.3))?;
    /// let top = Torque::gravity(&Vector3::new(0.1, 0.2, 0.3), 4.0);
    /// let mut stepper = Stepper::adaptive(&body, 1e-12, 1000)?.with_torques([top])?;
    /// let _ = stepper.step(0.1)?;
    /// let within = stepper.at(0.07)?;
    /// assert_eq!(stepper.step_to(0.07)?, within);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A stepper by a method of fixed steps, or a time outside the last step of the run.
    pub fn at(&self, time: f64) -> Result<State<f64>, Error> {
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

    /// Advances to the time `end` (s), forward or backward, and returns the times on the way at which the
    /// spin about the principal axis of the middle moment changes its sign, with or without torques. Each is
    /// located to rounding on the series of its step. If the spin is zero at the end, the next call reports
    /// the flip, where the spin leaves zero.
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
    /// let mut stepper = Stepper::adaptive(&body, 1e-13, 1000)?.with_torques([drag])?;
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
    /// A stepper by a method of fixed steps, a torque that is a function and acts within the step, or as
    /// [`step`](Self::step); the body then stays where it was.
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
