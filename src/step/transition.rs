//! The state transition matrix of a step, from the series of the step and of its variations.

use super::adaptive::{AdaptiveRun, Tracked};
use super::method::check_square_underflow;
use super::stepper::Stepper;
use crate::body::State;
use crate::error::{Error, Subject, finite, representable};
use core::f64::consts::PI;
use nalgebra::{Matrix6, Vector3, Vector6};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

impl Stepper {
    /// One step of `h` seconds of an [adaptive](Self::adaptive) stepper, as [`step`](Self::step), and its
    /// state transition matrix: of attitude error (rad) and spin error (rad/s) along the body's axes, in the
    /// convention of [`FreeMotion::state_transition`](crate::exact::FreeMotion::state_transition). The
    /// matrix of several steps is the product, the last on the left.
    ///
    /// It costs several times as much as `step`: six columns are integrated with the motion, and the internal
    /// steps keep the error of each column, relative to its size, below the tolerance. Unlike `step`, it does
    /// not treat damping far faster than the motion implicitly: then its internal steps are a few decay times
    /// long, and there may be many of them.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3, Vector6};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// let inertia = Inertia::from_moments(1.0, 2.0, 2.5)?;
    /// let run = |e: Vector3<f64>, w: Vector3<f64>| {
    ///     let spin = Vector3::new(0.1, 2.0, 0.3) + w;
    ///     let body = Body::spinning(inertia, UnitQuaternion::from_scaled_axis(e), &spin)?;
    ///     let top = Torque::gravity(&Vector3::new(0.1, 0.2, 0.3), 4.0);
    ///     let mut stepper = Stepper::adaptive(&body, 1e-13, 1000)?.with_torques([top])?;
    ///     let transition = stepper.step_with_transition(3.0)?;
    ///     Ok::<_, tumbling::Error>((stepper.body()?, transition))
    /// };
    /// let (e, w) = (Vector3::new(3e-7, -1e-7, 2e-7), Vector3::new(1e-7, 2e-7, -1e-7));
    /// let (one, f) = run(Vector3::zeros(), Vector3::zeros())?;
    /// let (other, _) = run(e, w)?;
    /// let expected = f * Vector6::new(e.x, e.y, e.z, w.x, w.y, w.z);
    /// let turned = (one.attitude().inverse() * other.attitude()).scaled_axis();
    /// assert!((turned - expected.fixed_rows::<3>(0)).norm() < 1e-5 * turned.norm());
    /// let faster = other.omega_body() - one.omega_body();
    /// assert!((faster - expected.fixed_rows::<3>(3)).norm() < 1e-5 * faster.norm());
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A stepper by a method of fixed steps, a torque that is a function and acts within the step, or as
    /// [`step`](Self::step); the body then stays where it was.
    pub fn step_with_transition(&mut self, h: f64) -> Result<Matrix6<f64>, Error> {
        let (mut run, _, mut budget) = self.begin(Tracked::Variation, h, Subject::StepTransition)?;
        run.at(h, &mut budget)?;
        let transition = self.turned(&run.variation());
        representable(Subject::Transition, transition.as_slice())?;
        self.step(h).map(|_| transition)
    }

    /// How far off the attitude may be after a [`step`](Self::step) of `h` seconds, rad, if each internal
    /// step errs as much as the tolerance permits. The result pi means that nothing is known of the attitude.
    /// The stepper does not advance.
    ///
    /// The start is assumed to be accurate to rounding and each internal step to the tolerance; these errors,
    /// taken as independent, are propagated to the end by the state transition of the motion. Most steps by
    /// series err far less than the tolerance, and so does the motion: this is more a bound than an estimate.
    /// It costs some six to nine times the step, and more under damping far faster than the motion, as
    /// [`step_with_transition`](Self::step_with_transition). A motion near an unstable equilibrium or a
    /// separatrix may amplify errors more than any tolerance can compensate; this number shows it.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// // A pendulum let go at an angle from the upright, for a minute.
    /// let expected = |angle: f64| {
    ///     let inertia = Inertia::from_moments(2.0, 1.5, 1.0)?;
    ///     let leaning = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), angle);
    ///     let body = Body::spinning(inertia, leaning, &Vector3::zeros())?;
    ///     let stepper = Stepper::adaptive(&body, 1e-14, 100_000)?;
    ///     stepper.with_torques([Torque::gravity(&Vector3::z(), 9.8)])?.expected_error(60.0)
    /// };
    /// assert!(expected(2.5)? < 1e-10);
    /// assert!(expected(1e-8)? > 1.0);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`step_with_transition`](Self::step_with_transition).
    pub fn expected_error(&self, h: f64) -> Result<f64, Error> {
        let (mut plain, tolerance, mut steps) = self.begin(Tracked::Nothing, h, Subject::StepError)?;
        let (mut run, _, mut budget) = self.begin(Tracked::Variation, h, Subject::StepError)?;
        // The variances of an error of the attitude's quaternion and of the momentum, relative to their size.
        let made = |state: &State<f64>, error: f64| {
            let spin = self.system.inverse * (error * state.momentum.amax());
            let errors = Vector6::from_fn(|i, _| if i < 3 { 2.0 * error } else { spin[i - 3] });
            Matrix6::from_diagonal(&errors.component_mul(&errors))
        };
        let (mut variance, mut off) = (made(&self.state, f64::EPSILON), 0.0);
        // The variation begins anew where a step of the plain run has ended. After each of the varied run's,
        // what damping takes of it would never fade, and would keep the steps short.
        while let Some(time) = plain.next_step(&mut steps)? {
            run.at(time, &mut budget)?;
            let on = run.variation();
            let now = on * variance * on.transpose() + made(run.state(), tolerance.max(32.0 * f64::EPSILON));
            off = now.fixed_view::<3, 3>(0, 0).trace().sqrt();
            if off.is_nan() || off >= PI {
                return Ok(PI);
            }
            // At rest no step errs.
            if run.state().momentum != Vector3::zeros() {
                variance = now;
                run.vary_anew();
            }
        }
        Ok(off)
    }

    /// A run from now on, its tolerance and its budget.
    fn begin(&self, track: Tracked, h: f64, what: Subject) -> Result<(AdaptiveRun, f64, usize), Error> {
        let (tolerance, budget) = self.tolerance(what)?;
        check_square_underflow(&self.system.omega(&self.state.momentum), &finite(Subject::Step, h)?)?;
        Ok((AdaptiveRun::new(self.system.clone(), &self.state, h, tolerance, track)?, tolerance, budget))
    }

    /// A matrix along the body's axes, from one along the principal axes.
    fn turned(&self, along: &Matrix6<f64>) -> Matrix6<f64> {
        let Some(back) = self.frame.matrix() else { return *along };
        let mut blocks = Matrix6::zeros();
        blocks.fixed_view_mut::<3, 3>(0, 0).copy_from(&back);
        blocks.fixed_view_mut::<3, 3>(3, 3).copy_from(&back);
        blocks.transpose() * along * blocks
    }
}
