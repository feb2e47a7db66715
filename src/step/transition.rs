//! The state transition of a step: the step itself on numbers that carry their derivatives.

use super::adaptive::{AdaptiveRun, Tracked};
use super::stepper::Stepper;
use super::system::System;
use super::torque::Torque;
use crate::attitude;
use crate::body::State;
use crate::error::{Error, Refusal, Subject, finite, representable};
use crate::number::{Analytic, functions};
use core::f64::consts::PI;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use nalgebra::{Matrix6, Quaternion, Vector3, Vector6};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
use num_traits::{FromPrimitive, One, Zero};

impl Stepper<f64> {
    /// One step of `h` seconds of an [adaptive](Self::adaptive) stepper, as [`step`](Self::step), and its
    /// state transition matrix: of attitude error (rad) and spin error (rad/s) along the body's axes, in the
    /// convention of [`FreeMotion::state_transition`](crate::exact::FreeMotion::state_transition). The
    /// matrix of several steps is the product, the last on the left.
    ///
    /// The step runs on numbers that carry six derivatives; its own steps keep the error of each column below
    /// the tolerance, relative to the column's size.
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
    ///     let mut stepper = Stepper::<f64>::adaptive(&body, 1e-13, 1000)?.with_torques([top])?;
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
    /// A stepper by a method of fixed steps, a torque that is a function, or as [`step`](Self::step); the
    /// body then stays where it was.
    pub fn step_with_transition(&mut self, h: f64) -> Result<Matrix6<f64>, Error> {
        let (tolerance, mut budget) = self.tolerance(Subject::StepTransition)?;
        let transition =
            self.turned(&self.transition(&self.state, [self.time, h], tolerance, &mut budget)?);
        representable(Subject::Transition, transition.as_slice())?;
        self.step(h).map(|_| transition)
    }

    /// An estimate of how far off the attitude will be after a [`step`](Self::step) of `h` seconds, rad; at
    /// most pi, where nothing is known of it. The stepper stays where it is.
    ///
    /// The start is taken to be right to rounding, each of the run's own steps to the tolerance, and what
    /// they are off by is carried on to the end by the motion's state transition, as independent errors. It
    /// costs a run with derivatives, some ten times that of the step. A motion near an unstable equilibrium
    /// or a separatrix multiplies errors by more than any tolerance makes up for: this says so.
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
    ///     let stepper = Stepper::<f64>::adaptive(&body, 1e-14, 100_000)?;
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
        let (tolerance, mut budget) = self.tolerance(Subject::StepError)?;
        let mut run = AdaptiveRun::new(
            self.system.clone(),
            &self.state,
            finite(Subject::Step, h)?,
            tolerance,
            Tracked::Nothing,
        )?;
        let inverse = self.system.inverse;
        // The variances of an error of the attitude's quaternion and of the momentum, relative to their size.
        let made = |state: &State<f64>, error: f64| {
            let spin = inverse * (error * state.momentum.amax());
            let each = |i: usize| if i < 3 { 2.0 * error } else { spin[i - 3] };
            Matrix6::from_diagonal(&Vector6::from_fn(|i, _| each(i) * each(i)))
        };
        let mut variance = made(&self.state, f64::EPSILON);
        let error = tolerance.max(32.0 * f64::EPSILON);
        let mut off = 0.0;
        let mut start = *run.state();
        while let Some([began, ended]) = run.next_step(&mut budget)? {
            let times = [self.time + began, ended - began];
            let on = self.transition(&start, times, tolerance, &mut budget)?;
            start = *run.state();
            variance = on * variance * on.transpose() + made(&start, error);
            off = variance.fixed_view::<3, 3>(0, 0).trace().sqrt();
            if off.is_nan() || off >= PI {
                return Ok(PI);
            }
        }
        Ok(off)
    }

    /// The state transition, along the principal axes, from a state at a time to the one a duration later.
    fn transition(
        &self,
        start: &State<f64>,
        [time, duration]: [f64; 2],
        tolerance: f64,
        budget: &mut usize,
    ) -> Result<Matrix6<f64>, Error> {
        let dual = |torque: &Torque<f64>| torque.map(Dual::from, |v| v.map(Dual::from));
        let Some(torques) = self.system.torques().iter().map(dual).collect() else {
            let why = "a function gives no derivatives: give the torque by its name";
            return Err(Refusal::Undefined { what: Subject::Transition, why }.into());
        };
        let moments = *self.system.moments();
        let mut system = System::of_numbers(moments.map(Dual::from), torques);
        system.set_time(Dual::from(time));
        let start = varied(start, &moments);
        let tracked = Tracked::Derivatives(|x: &Dual| x.derivatives.map(f64::abs));
        let end = AdaptiveRun::new(system, &start, duration, tolerance, tracked)?.at(duration, budget)?;
        Ok(read(&end, &self.system.inverse))
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

/// A state with its derivatives by an error of the attitude and by one of the spin.
fn varied(state: &State<f64>, moments: &Vector3<f64>) -> State<Dual> {
    let mut varied = State {
        attitude: Quaternion::from_vector(state.attitude.coords.map(Dual::from)),
        momentum: state.momentum.map(Dual::from),
    };
    for axis in 0..3 {
        let mut unit = Vector3::zeros();
        unit[axis] = 1.0;
        let turn = attitude::rate(&state.attitude, &unit);
        for i in 0..4 {
            varied.attitude.coords[i].derivatives[axis] = turn.coords[i];
        }
        varied.momentum[axis].derivatives[3 + axis] = moments[axis];
    }
    varied
}

/// The errors of attitude and spin, by those at the start.
fn read(end: &State<Dual>, inverse: &Vector3<f64>) -> Matrix6<f64> {
    let back = attitude::conjugate(&Quaternion::from_vector(end.attitude.coords.map(|x| x.value)));
    let mut matrix = Matrix6::zeros();
    for column in 0..6 {
        let moved = Quaternion::from_vector(end.attitude.coords.map(|x| x.derivatives[column]));
        let turn = attitude::product(&back, &moved).coords;
        for i in 0..3 {
            matrix[(i, column)] = 2.0 * turn[i];
            matrix[(3 + i, column)] = end.momentum[i].derivatives[column] * inverse[i];
        }
    }
    matrix
}

/// A number with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Dual {
    value: f64,
    derivatives: [f64; 6],
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Self { value, derivatives: [0.0; 6] }
    }
}

impl Dual {
    /// A function of it, by the function's value and derivative.
    fn by(&self, value: f64, derivative: f64) -> Self {
        Self { value, derivatives: self.derivatives.map(|x| x * derivative) }
    }
}

/// Operators, each by the value of its result and by one of the derivatives.
macro_rules! operators {
    ($($name:ident, $method:ident, $assign:ident, $method_assign:ident:
        |$a:ident, $b:ident, $i:ident| $value:expr, $derivative:expr;)*) => {$(
        #[allow(clippy::suspicious_arithmetic_impl, reason = "the rules of products and quotients")]
        impl $name for Dual {
            type Output = Self;
            #[inline(always)]
            fn $method(self, $b: Self) -> Self {
                let $a = self;
                Self { value: $value, derivatives: core::array::from_fn(|$i| $derivative) }
            }
        }

        impl $assign for Dual {
            #[inline(always)]
            fn $method_assign(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}

operators! {
    Add, add, AddAssign, add_assign: |a, b, i| a.value + b.value, a.derivatives[i] + b.derivatives[i];
    Sub, sub, SubAssign, sub_assign: |a, b, i| a.value - b.value, a.derivatives[i] - b.derivatives[i];
    Mul, mul, MulAssign, mul_assign: |a, b, i| a.value * b.value,
        a.derivatives[i] * b.value + a.value * b.derivatives[i];
    Div, div, DivAssign, div_assign: |a, b, i| a.value / b.value,
        (a.derivatives[i] - a.value / b.value * b.derivatives[i]) / b.value;
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, derivatives: self.derivatives.map(|x| -x) }
    }
}

impl Zero for Dual {
    fn zero() -> Self {
        Self::from(0.0)
    }
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Dual {
    fn one() -> Self {
        Self::from(1.0)
    }
}

impl FromPrimitive for Dual {
    fn from_i64(n: i64) -> Option<Self> {
        f64::from_i64(n).map(Self::from)
    }
    fn from_u64(n: u64) -> Option<Self> {
        f64::from_u64(n).map(Self::from)
    }
    fn from_f64(x: f64) -> Option<Self> {
        Some(Self::from(x))
    }
}

/// Its size is that of the value: an adaptive run measures each column of derivatives by itself.
impl Analytic for Dual {
    fn sqrt(&self) -> Self {
        let root = Analytic::sqrt(&self.value);
        self.by(root, 0.5 / root)
    }
    fn sin_cos(&self) -> (Self, Self) {
        let (sine, cosine) = functions::sin_cos(self.value);
        (self.by(sine, cosine), self.by(cosine, -sine))
    }
    fn exp(&self) -> Self {
        let value = functions::exp(self.value);
        self.by(value, value)
    }
    fn cos_sinc_of_root(&self) -> (Self, Self) {
        let (cosine, sinc) = functions::cos_sinc_of_root(self.value);
        // Of the root's square `s`: the cosine falls by half the sinc, and the sinc by (sinc - cosine) / 2s,
        // of which the first terms are left where it cancels.
        let s = self.value;
        let derivative = if s.abs() < 1e-2 {
            -1.0 / 6.0 + s * (1.0 / 60.0 - s * (1.0 / 1680.0 - s / 90_720.0))
        } else {
            (cosine - sinc) / (2.0 * s)
        };
        (self.by(cosine, -0.5 * sinc), self.by(sinc, derivative))
    }
    fn size(&self) -> f64 {
        self.value.abs()
    }
    fn rounding() -> f64 {
        f64::EPSILON
    }
}
