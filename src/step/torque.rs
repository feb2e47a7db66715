//! Torques on a body, as the caller states them, with their checks and their transformation to other body
//! axes.

mod named;

use crate::error::{Error, Refusal, Subject, finite, finite_vector, not_negative};
use crate::inertia::Frame;
use crate::number::Analytic;
use crate::number::functions::atan2;
use crate::step::adaptive::{Circle, turned};
use alloc::boxed::Box;
use alloc::sync::Arc;
use core::fmt;
use nalgebra::{Matrix3, Vector3};

/// A torque on a rigid body about its centre of mass, or about the fixed point of a top.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Torque<T: nalgebra::Scalar> {
    /// Constant along the body's axes, N m: a thruster.
    InBody(Vector3<T>),
    /// Constant along the world's axes, N m.
    InWorld(Vector3<T>),
    /// `arm x field`, with the arm fixed in the body and the field in the world. For a compass needle, the
    /// arm is its magnetic moment (A m²) and the field is in tesla; for a heavy top, the arm is the vector
    /// from its fixed point to its centre of mass (m) and the field is its weight (N). Near rest it acts like
    /// a spring.
    Aligning {
        /// In body axes.
        arm: Vector3<T>,
        /// In world axes.
        field: Vector3<T>,
    },
    /// `-c_i w_i` along each principal axis, `c` in N m s: viscous drag.
    Damping(Vector3<T>),
    /// `k L x (L x w)`, `k` in s/(kg m²): dissipation inside a body that is not quite rigid. It conserves
    /// `|L|` and reduces the energy until the body turns about the axis of its largest moment
    /// [BKMR96](crate::references).
    Dissipation(T),
    /// `strength n x I n`, with `n` the unit vector to a distant attracting body: the gravity gradient.
    /// [`Torque::gravity_gradient`] computes its fields from an orbit.
    GravityGradient {
        /// `3 mu / r^3`, 1/s²; in a circular orbit, three times the square of the orbital rate.
        strength: T,
        /// `n` at time zero, in world axes: of length 1, to 1e-6.
        direction: Vector3<T>,
        /// The angular velocity of `n` in world axes, rad/s: that of the orbit, along its normal; zero if `n`
        /// is constant.
        orbit: Vector3<T>,
    },
    /// `amplitude cos(rate t + phase)`, with `t` the time of the [`Stepper`](crate::step::Stepper): an
    /// oscillating motor. Two of them, about different axes and a quarter of a period apart, add up to a
    /// torque vector that rotates in the body.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// // 2 N m cos(3 t) about z on 4 kg m², from rest.
    /// let inertia = Inertia::from_moments(2.0, 3.0, 4.0)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::zeros())?;
    /// let motor = Torque::Periodic { amplitude: Vector3::z() * 2.0, rate: 3.0, phase: 0.0 };
    /// let mut stepper = Stepper::adaptive(&body, 1e-12, 1000)?.with_torques([motor])?;
    /// stepper.step(5.0)?;
    /// assert!((stepper.omega().z - 2.0 / 4.0 * 15.0_f64.sin() / 3.0).abs() < 1e-11);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    Periodic {
        /// Along the body's axes, N m.
        amplitude: Vector3<T>,
        /// rad/s.
        rate: T,
        /// rad.
        phase: T,
    },
    /// A torque from one time to another, from [`Torque::during`].
    During {
        /// s.
        start: T,
        /// s.
        end: T,
        /// The torque that acts between the two times.
        torque: Box<Torque<T>>,
    },
    /// A function of time, attitude and spin, from [`Torque::function`]. Clones share it, and two are equal
    /// only if one is a clone of the other.
    Function(TorqueFunction<T>),
}

type LawOfTorque<T> = dyn Fn(T, &Matrix3<T>, &Vector3<T>) -> Vector3<T> + Send + Sync;

/// What a [`Torque::Function`] holds. No user has to name it, so it is not exported.
#[derive(Clone)]
pub struct TorqueFunction<T: nalgebra::Scalar>(Arc<LawOfTorque<T>>);

impl<T: nalgebra::Scalar> fmt::Debug for TorqueFunction<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("TorqueFunction")
    }
}

impl<T: nalgebra::Scalar> PartialEq for TorqueFunction<T> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl<T: nalgebra::Scalar> Torque<T> {
    /// A torque given by a function. Its arguments are the time (s), the rotation matrix of the attitude
    /// (body to world) and the spin in body axes (rad/s); it returns the torque in body axes (N m).
    /// `rotation.tr_mul(&v)` gives the body components of a world vector `v`.
    ///
    /// The time is that of the [`Stepper`](crate::step::Stepper), which advances it; a
    /// [`Method`](crate::step::Method) used alone starts each step at time zero. In methods with kicks, time
    /// and attitude are constant during each half kick, and the spin follows the explicit midpoint rule: it
    /// has order two, and is reversible if the function does not depend on the spin.
    ///
    /// The time is rounded, at 1e9 s to 1e-7 s. An adaptive run takes that for an error if the function
    /// changes fast: it makes short steps, or refuses. The phases of [`Periodic`](Self::Periodic) torques and
    /// of orbits do not suffer from it: the run takes them from the exact product of rate and time.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Method, Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// // A motor that pushes to and fro about z: 2 N m cos(3 t) on 4 kg m².
    /// let inertia = Inertia::from_moments(2.0, 3.0, 4.0)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::zeros())?;
    /// let motor = Torque::function(|time: f64, _, _| Vector3::z() * (2.0 * (3.0 * time).cos()));
    /// let mut stepper = Stepper::new(&body, Method::RungeKutta4)?.with_torques([motor])?;
    /// stepper.run(0.01, 100).try_for_each(|state| state.map(drop))?;
    /// assert!((stepper.omega().z - 2.0 / 4.0 * 3.0_f64.sin() / 3.0).abs() < 1e-9);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// Air drag, `c` (N m s²) times the square of the spin and opposite to it, on a body that turns about one
    /// axis: `I w' = -c w²`, so `w = w0 / (1 + c w0 t / I)`.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// let inertia = Inertia::from_moments(2.0, 3.0, 4.0)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(0.0, 0.0, 10.0))?;
    /// let drag = Torque::function(|_, _, omega: &Vector3<f64>| omega * (-0.06 * omega.norm()));
    /// let mut stepper = Stepper::adaptive(&body, 1e-12, 1000)?.with_torques([drag])?;
    /// stepper.step(20.0)?;
    /// assert!((stepper.omega().z - 10.0 / (1.0 + 0.06 * 10.0 * 20.0 / 4.0)).abs() < 1e-10);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    pub fn function(law: impl Fn(T, &Matrix3<T>, &Vector3<T>) -> Vector3<T> + Send + Sync + 'static) -> Self {
        Self::Function(TorqueFunction(Arc::new(law)))
    }
}

/// The quantities on which a torque may depend.
#[derive(Debug)]
pub(crate) struct Instant<'a, T: nalgebra::Scalar> {
    /// The body's inverse principal moments, 1/(kg m²).
    pub(crate) inverse: &'a Vector3<T>,
    /// s.
    pub(crate) time: &'a T,
    /// From body axes to world axes.
    pub(crate) rotation: &'a Matrix3<T>,
    /// Angular momentum in body axes, kg m²/s.
    pub(crate) momentum: &'a Vector3<T>,
    /// Spin in body axes, rad/s.
    pub(crate) omega: &'a Vector3<T>,
}

impl<'a, T: nalgebra::Scalar> Instant<'a, T> {
    /// The same instant with another momentum.
    pub(super) fn with(&self, momentum: &'a Vector3<T>) -> Self {
        Self { momentum, ..*self }
    }
}

impl<T: Analytic> TorqueFunction<T> {
    /// The torque in body axes at a given spin, N m.
    pub(super) fn at(&self, now: &Instant<'_, T>, omega: &Vector3<T>) -> Vector3<T> {
        (self.0)(now.time.clone(), now.rotation, omega)
    }

    /// The momentum after the torque has acted for `h` seconds, by the explicit midpoint rule.
    pub(super) fn kick(&self, now: &Instant<'_, T>, h: &T) -> Vector3<T> {
        let half = h.clone() / T::integer(2);
        let omega = now.momentum.component_mul(now.inverse);
        let halfway = now.momentum + self.at(now, &omega).map(|x| x * half.clone());
        now.momentum + self.at(now, &halfway.component_mul(now.inverse)).map(|x| x * h.clone())
    }
}

/// The tolerance on the length of a direction: several roundings of `f32`.
const UNIT_TOLERANCE: f64 = 1e-6;

impl Torque<f64> {
    /// Checks that all numbers are finite, damping, dissipation and the gradient's strength are not negative,
    /// times are in order, and directions have length 1.
    pub(crate) fn validate(&self) -> Result<(), Error> {
        match self {
            Self::InBody(torque) | Self::InWorld(torque) => finite_vector(Subject::Torque, torque),
            Self::Aligning { arm, field } => {
                finite_vector(Subject::Arm, arm)?;
                finite_vector(Subject::Field, field)
            }
            Self::Damping(coefficients) => {
                coefficients.iter().try_for_each(|&c| not_negative(Subject::DampingCoefficient, c).map(drop))
            }
            Self::Dissipation(strength) => not_negative(Subject::DissipationStrength, *strength).map(drop),
            Self::GravityGradient { strength, direction, orbit } => {
                not_negative(Subject::GradientStrength, *strength)?;
                finite_vector(Subject::OrbitRate, orbit)?;
                let what = Subject::GradientDirection;
                finite_vector(what, direction)?;
                let length = direction.norm();
                let off = (length - 1.0).abs();
                Refusal::NotUnit { what, length, tolerance: UNIT_TOLERANCE }.when(off > UNIT_TOLERANCE)
            }
            Self::Periodic { amplitude, rate, phase } => {
                finite_vector(Subject::Torque, amplitude)?;
                finite(Subject::PeriodicRate, *rate)?;
                finite(Subject::PeriodicPhase, *phase).map(drop)
            }
            Self::During { start, end, torque } => {
                let (start, end) = (*start, *end);
                for (what, time) in [(Subject::TorqueStart, start), (Subject::TorqueEnd, end)] {
                    Refusal::Undefined { what, why: "its time is not a number" }.when(time.is_nan())?;
                }
                let (smaller, larger) = (Subject::TorqueStart, "its end");
                Refusal::Order { smaller, small: start, larger, large: end }.when(start > end)?;
                torque.validate()
            }
            Self::Function(_) => Ok(()),
        }
    }

    /// The torque as it is for a run that begins at a time and counts its own from there.
    pub(crate) fn starting_at(&self, start: f64) -> Self {
        match self.clone() {
            same if start == 0.0 => same,
            Self::Function(TorqueFunction(law)) => {
                Self::function(move |time, rotation, omega| law(time + start, rotation, omega))
            }
            Self::Periodic { amplitude, rate, phase } => {
                let (sine, cosine) = turned(phase, rate, start);
                Self::Periodic { amplitude, rate, phase: atan2(sine, cosine) }
            }
            Self::GravityGradient { strength, direction, orbit } => {
                Self::GravityGradient { strength, direction: Circle::of(&direction, &orbit).at(start), orbit }
            }
            Self::During { start: first, end, torque } => {
                Self::during(first - start, end - start, torque.starting_at(start))
            }
            same => same,
        }
    }

    /// The torque along a body's principal axes.
    ///
    /// # Errors
    /// Damping that differs between axes, for a body whose axes are not principal: it is given along the
    /// principal axes.
    pub(crate) fn along(self, frame: &Frame) -> Result<Self, Error> {
        let Some(to_principal) = frame.matrix() else { return Ok(self) };
        Ok(match self {
            Self::Damping(c) if c.x != c.y || c.y != c.z => {
                return Err(Refusal::Undefined {
                    what: Subject::UnequalDamping,
                    why: "it is given along the principal axes, which have no defined order if there are products \
                          of inertia: give the moments along the principal axes, without products",
                }.into());
            }
            Self::Function(TorqueFunction(law)) => Self::function(move |time, rotation, omega| {
                let to_body = to_principal.transpose();
                to_principal * law(time, &(rotation * to_principal), &(to_body * omega))
            }),
            Self::During { start, end, torque } => Self::during(start, end, torque.along(frame)?),
            Self::InBody(torque) => Self::InBody(frame.along(&torque)),
            Self::Aligning { arm, field } => Self::Aligning { arm: frame.along(&arm), field },
            Self::Periodic { amplitude, rate, phase } => {
                Self::Periodic { amplitude: frame.along(&amplitude), rate, phase }
            }
            Self::InWorld(_) | Self::Damping(_) | Self::Dissipation(_) | Self::GravityGradient { .. } => self,
        })
    }
}

/// Whether `a <= b`. The number types have no order, but the square root of `b - a` is a number only then.
pub(in crate::step) fn before_or_at<T: Analytic>(a: &T, b: &T) -> bool {
    !(b.clone() - a.clone()).sqrt().size().is_nan()
}
