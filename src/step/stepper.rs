//! A body whose tensor has an inverse, stepped along its principal axes.

use super::adaptive::AdaptiveRun;
use super::fixed_rate::fixed_rate;
use crate::body::{Body, State};
use crate::error::{Error, Refusal, Subject, finite, finite_vector, positive, representable};
use crate::inertia::Frame;
use crate::step::method::Method;
use crate::step::system::System;
use crate::step::torque::Torque;
use alloc::boxed::Box;
use nalgebra::Vector3;

/// Steps a body through time under torques: by a method, at a fixed rate, or by steps within a tolerance.
///
/// The tensor may have products of inertia. All inputs and outputs are along the body's own axes and the
/// world's. The principal axes are computed once; the internal state is not converted back and
/// forth, so that a reversible method stays reversible. A step by a method or at a fixed rate allocates
/// nothing; an adaptive one allocates the series of its run. In `f32`, use
/// [`PositionStage`](super::PositionStage) for a free body, and [`Method::step`] or [`fixed_rate`] for a
/// [`System`] of `f32`.
///
/// ```
/// use nalgebra::{Matrix3, UnitQuaternion, Vector3};
/// use tumbling::step::{Method, Stepper};
/// use tumbling::{Body, Inertia};
/// // A T-handle whose stem leans in its axes, spun near its middle axis.
/// let inertia = Inertia::try_from(Matrix3::new(3.0, 0.5, 0.0, 0.5, 2.0, 0.0, 0.0, 0.0, 4.0))?;
/// let handle = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(6.0, 2.0, 0.01))?;
/// let mut stepper = Stepper::new(&handle, Method::RotationSplitting4)?;
/// for state in stepper.run(1.0 / 60.0, 600) {
///     let attitude = state?.attitude; // draw it
///     assert!((attitude.norm() - 1.0).abs() < 1e-12);
/// }
/// assert!((stepper.body()?.energy() / handle.energy() - 1.0).abs() < 1e-3);
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// Bodies are independent, so they can be spread over threads, with the same bits as one after the other.
/// Here are satellites under gravity gradient with different starts, for one orbit.
///
/// ```
/// use nalgebra::{UnitQuaternion, Vector3};
/// use tumbling::step::{State, Stepper, Torque};
/// use tumbling::{Body, Error, Inertia};
/// let rate = Vector3::z() * 1.1e-3;
/// let satellite = |k: usize| {
///     let inertia = Inertia::from_moments(10.0, 14.0, 17.0)?;
///     let start = UnitQuaternion::from_euler_angles(0.1, 0.2, 0.01 * k as f64);
///     let body = Body::spinning(inertia, start, &Vector3::new(0.0, 1e-4, 1.1e-3))?;
///     let stepper = Stepper::adaptive(&body, 1e-10, 10_000)?;
///     stepper.with_torques([Torque::gravity_gradient(&Vector3::x(), &rate)])
/// };
/// let mut fleet: Vec<Stepper> = (0..50).map(satellite).collect::<Result<_, Error>>()?;
/// let fly = |some: &mut [Stepper]| -> Result<Vec<State<f64>>, Error> {
///     some.iter_mut().map(|one| one.step(5700.0)).collect()
/// };
/// let alone = fly(&mut fleet.clone())?;
/// let parts: Result<Vec<_>, Error> = std::thread::scope(|scope| {
///     let threads: Vec<_> = fleet.chunks_mut(25).map(|some| scope.spawn(|| fly(some))).collect();
///     threads.into_iter().map(|thread| thread.join().expect("no panic")).collect()
/// });
/// assert_eq!(parts?.concat(), alone);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Stepper {
    /// The body at the start.
    pub(super) body: Body,
    pub(super) rule: Rule,
    /// Along the principal axes.
    pub(super) system: System<f64>,
    /// Along the principal axes.
    pub(super) state: State<f64>,
    pub(super) frame: Frame,
    /// Seconds since the start.
    pub(super) time: f64,
    /// The run of an adaptive stepper, and the time at which it began.
    pub(super) run: Option<(Box<AdaptiveRun>, f64)>,
    /// The sign of the spin about the middle axis before now, if flips were looked for until now.
    pub(super) sign: f64,
    /// The number of steps that the runs have taken or rejected.
    pub(super) count: usize,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Rule {
    Method(Method),
    FixedRate,
    Adaptive { tolerance: f64, budget: usize },
}

impl Stepper {
    /// A stepper for a free body, by `method`.
    ///
    /// # Errors
    /// A moment whose inverse is beyond `f64` or below its normal numbers, or a spin beyond `f64`.
    pub fn new(body: &Body, method: Method) -> Result<Self, Error> {
        Self::by(body, Rule::Method(method))
    }

    /// A stepper for a free body at a fixed rate: each step is that of [`fixed_rate`], with the same parts
    /// and the same errors.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn fixed_rate(body: &Body) -> Result<Self, Error> {
        Self::by(body, Rule::FixedRate)
    }

    pub(super) fn by(body: &Body, rule: Rule) -> Result<Self, Error> {
        let (moments, to_body) = body.inertia().along_principal_axes()?;
        let frame = to_body.map_or(Frame::BODY, |to_body| Frame::new(to_body.into_inner()));
        let system = System::free(moments)?;
        let start = body.state();
        let state = State {
            attitude: frame.attitude_of_axes(start.attitude),
            momentum: frame.along(&start.momentum),
        };
        let stepper =
            Self { body: *body, rule, system, state, frame, time: 0.0, run: None, sign: 0.0, count: 0 };
        stepper.checked().map(|_| stepper)
    }

    /// Adds torques to those that already act. Their vectors are in the body's or the world's axes. Damping
    /// is along principal axes: it must be the same about all three if the tensor has products of inertia.
    ///
    /// # Errors
    /// A torque whose numbers are not finite, a coefficient of damping or dissipation below zero, a direction
    /// of the gravity gradient whose length is not 1, or damping that differs between the axes of a body with
    /// products of inertia.
    pub fn with_torques(mut self, torques: impl IntoIterator<Item = Torque<f64>>) -> Result<Self, Error> {
        let mut all = self.system.torques().to_vec();
        for torque in torques {
            torque.validate()?;
            all.push(torque.along(&self.frame)?);
        }
        self.system = self.system.under(all);
        self.set_time(self.time);
        // What acts from now on did not act in the last step.
        self.run = None;
        Ok(self)
    }

    /// Takes one step of `h` seconds, backward in time if negative, and returns the [`state`](Self::state)
    /// after it. A step that fails leaves the body unchanged.
    ///
    /// # Errors
    /// The errors of [`Method::step`] or [`fixed_rate`]. For an adaptive stepper: a step whose error stays
    /// too large however short it is, or kind [`TooMany`](crate::ErrorKind::TooMany) after its budget of
    /// steps, or as soon as stiff damping would need more. A torque, such as that of a [`Torque::Function`],
    /// that is not finite at the start or the end; a spin or a time beyond the range of `f64`.
    pub fn step(&mut self, h: f64) -> Result<State<f64>, Error> {
        self.go(self.time + finite(Subject::Step, h)?, h)
    }

    /// Takes one step to the time `end` (s), forward or backward, and returns the state there.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn step_to(&mut self, end: f64) -> Result<State<f64>, Error> {
        self.go(end, finite(Subject::EndTime, end)? - self.time)
    }

    fn go(&mut self, after: f64, h: f64) -> Result<State<f64>, Error> {
        representable(Subject::TimeAfterStep, &[after])?;
        let end = match self.rule {
            Rule::Method(method) => method.step(&self.system, &self.state, h),
            Rule::FixedRate => fixed_rate(&self.system, &self.state, h),
            Rule::Adaptive { tolerance, mut budget } => self.run_to(after, tolerance, &mut budget, false),
        }
        .map_err(|error| self.torque_not_finite(after).unwrap_or(error))?;
        self.arrive(end, after)
    }

    /// Takes up a state at a time, if it and its spin are finite.
    pub(super) fn arrive(&mut self, end: State<f64>, after: f64) -> Result<State<f64>, Error> {
        let start = core::mem::replace(&mut self.state, end);
        match self.checked() {
            Ok(state) => {
                self.sign = 0.0;
                self.set_time(after);
                Ok(state)
            }
            Err(error) => {
                self.state = start;
                Err(error)
            }
        }
    }

    /// The state, if it and the spin are finite along the body's axes.
    pub(super) fn checked(&self) -> Result<State<f64>, Error> {
        let value = self.omega().abs().sum();
        representable(Subject::Spin, &[value])?;
        self.state().checked()
    }

    /// The cause of a step that failed on a torque that is not finite where it began or at the time where it
    /// would have ended; or, by a method of fixed steps, on an orbit whose turn until then is not finite.
    fn torque_not_finite(&self, after: f64) -> Option<Error> {
        let adaptive = matches!(self.rule, Rule::Adaptive { .. });
        [self.time, after].into_iter().find_map(|time| {
            let exact = self.system.starting_at(time).torque(&self.state);
            let rounded = self.system.torque_after(&self.state, &(time - self.time));
            let too_late = !adaptive && rounded.iter().any(|x| !x.is_finite());
            let why = "a fixed step takes phases and turns of orbits from the time; they are beyond `f64`";
            let refused = Refusal::Undefined { what: Subject::Torque, why }.when(too_late);
            finite_vector(Subject::Torque, &exact).and(refused).err()
        })
    }

    pub(super) fn set_time(&mut self, time: f64) {
        self.time = time;
        self.system.set_time(time);
    }

    /// Takes `count` steps of `h` seconds; the iterator yields the state after each. It is lazy, and ends
    /// after the first error.
    ///
    /// # Errors
    /// Each item has the errors of [`step`](Self::step).
    pub fn run(&mut self, h: f64, count: usize) -> impl Iterator<Item = Result<State<f64>, Error>> {
        let mut failed = false;
        (0..count).map_while(move |_| {
            let state = (!failed).then(|| self.step(h))?;
            failed = state.is_err();
            Some(state)
        })
    }

    /// The time since the start, s: the sum of the steps, or after [`step_to`](Self::step_to) the time
    /// requested. A step of 1/60 s that was rounded to `f32` is longer by 9e-10 s, which adds up to 6 µs in
    /// two minutes.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Attitude (body to world) and angular momentum along the body's axes. If the method does not keep the
    /// attitude's length, it may differ from 1 here.
    #[must_use]
    pub fn state(&self) -> State<f64> {
        self.along_body(&self.state)
    }

    /// A state along the body's axes, from one along the principal axes.
    pub(super) fn along_body(&self, state: &State<f64>) -> State<f64> {
        State {
            attitude: self.frame.attitude_as_long(state.attitude),
            momentum: self.frame.in_body(state.momentum),
        }
    }

    /// The spin along the body's axes, rad/s.
    #[must_use]
    pub fn omega(&self) -> Vector3<f64> {
        self.frame.in_body(self.system.omega(&self.state.momentum))
    }

    /// The body in its current state, with the attitude scaled to length 1.
    ///
    /// # Errors
    /// A spin beyond `f64`, or an attitude of length zero.
    pub fn body(&self) -> Result<Body, Error> {
        let state = self.state();
        let norm = positive(Subject::AttitudeLength, state.attitude.norm())?;
        self.body.with_state(&State { attitude: state.attitude / norm, ..state })
    }
}
