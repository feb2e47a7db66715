//! Torques on a body: each with its value, and with its own exact flow while the attitude stands still.

mod named;

pub(in crate::step) use named::before_or_at;

use crate::attitude;
use crate::error::{Error, Refusal, Subject, finite, finite_vector, not_negative};
use crate::number::Analytic;
use alloc::boxed::Box;
use alloc::sync::Arc;
use core::fmt;
use nalgebra::{Matrix3, Quaternion, Vector3};
use num_traits::ToPrimitive;

/// A torque on a rigid body about its centre of mass, or about the fixed point of a top.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Torque<T: nalgebra::Scalar> {
    /// Constant along the body's axes, N m: a thruster.
    InBody(Vector3<T>),
    /// Constant along the world's axes, N m.
    InWorld(Vector3<T>),
    /// `arm x field`, with the arm fixed in the body and the field in the world. A compass needle has its
    /// magnetic moment (A m²) for an arm in the field's tesla; a heavy top has the way from its point to its
    /// centre of mass (m) for an arm, and its weight (N) for a field. Near rest it is a spring.
    Aligning {
        /// In body axes.
        arm: Vector3<T>,
        /// In world axes.
        field: Vector3<T>,
    },
    /// `-c_i w_i` along each principal axis, `c` in N m s: viscous drag.
    Damping(Vector3<T>),
    /// `k L x (L x w)`, `k` in s/(kg m²): loss inside a body that is not quite rigid. It keeps `|L|` and
    /// takes energy, until the body turns about the axis of its largest moment [BKMR96](crate::references).
    Dissipation(T),
    /// `strength n x I n`, with `n` the unit vector to a body that attracts: the gravity gradient of one that
    /// is far away, as [`Torque::gravity_gradient`] gives it.
    GravityGradient {
        /// `3 mu / r^3`, 1/s²: of a circular orbit three times the square of its rate.
        strength: T,
        /// `n` at time zero, in world axes: of length 1, to 1e-6.
        direction: Vector3<T>,
        /// How fast `n` turns, in world axes, rad/s: the rate of the orbit about its normal; zero where `n`
        /// stands still.
        orbit: Vector3<T>,
    },
    /// `amplitude cos(rate t + phase)`, with `t` the time of the [`Stepper`](crate::step::Stepper): a motor
    /// that pushes to and fro; two of them make a push that turns round in the body.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// // 2 N m cos(3 t) about z on 4 kg m², from rest.
    /// let inertia = Inertia::from_moments(2.0, 3.0, 4.0)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::zeros())?;
    /// let motor = Torque::Periodic { amplitude: Vector3::z() * 2.0, rate: 3.0, phase: 0.0 };
    /// let mut stepper = Stepper::<f64>::adaptive(&body, 1e-12, 1000)?.with_torques([motor])?;
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
        /// What acts from the start to the end, and nowhere else.
        torque: Box<Torque<T>>,
    },
    /// A function of time, attitude and spin, from [`Torque::function`].
    Function(TorqueFunction<T>),
}

type LawOfTorque<T> = dyn Fn(T, &Matrix3<T>, &Vector3<T>) -> Vector3<T> + Send + Sync;

/// The function of a [`Torque::Function`]. Clones share it; two are equal if they are clones of one.
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
    /// A torque by a law of its own: from the time (s), the rotation matrix of the attitude (body to world)
    /// and the spin in body axes (rad/s) to the torque in body axes (N m). `rotation.tr_mul(&v)` is the
    /// world's vector `v` in body axes.
    ///
    /// The time is that of the [`Stepper`](crate::step::Stepper), which counts it; a
    /// [`Method`](crate::step::Method) by itself starts each step at zero. Methods with kicks hold time and
    /// attitude for each half kick and take the spin on the way by the explicit midpoint rule: of the second
    /// order, and reversible where the law does not depend on the spin.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Method, Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// // A motor that swings to and fro about z: 2 N m cos(3 t) on 4 kg m².
    /// let inertia = Inertia::from_moments(2.0, 3.0, 4.0)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::zeros())?;
    /// let motor = Torque::function(|time: f64, _, _| Vector3::z() * (2.0 * (3.0 * time).cos()));
    /// let mut stepper = Stepper::new(&body, Method::RungeKutta4)?.with_torques([motor])?;
    /// stepper.run(0.01, 100).try_for_each(|state| state.map(drop))?;
    /// assert!((stepper.omega().z - 2.0 / 4.0 * 3.0_f64.sin() / 3.0).abs() < 1e-9);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// Drag of the air, `c` (N m s²) times the square of the spin against it, on a body that turns about one
    /// axis: `I w' = -c w²`, so `w = w0 / (1 + c w0 t / I)`.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::step::{Stepper, Torque};
    /// use tumbling::{Body, Inertia};
    /// let inertia = Inertia::from_moments(2.0, 3.0, 4.0)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(0.0, 0.0, 10.0))?;
    /// let drag = Torque::function(|_, _, omega: &Vector3<f64>| omega * (-0.06 * omega.norm()));
    /// let mut stepper = Stepper::<f64>::adaptive(&body, 1e-12, 1000)?.with_torques([drag])?;
    /// stepper.step(20.0)?;
    /// assert!((stepper.omega().z - 10.0 / (1.0 + 0.06 * 10.0 * 20.0 / 4.0)).abs() < 1e-10);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    pub fn function(law: impl Fn(T, &Matrix3<T>, &Vector3<T>) -> Vector3<T> + Send + Sync + 'static) -> Self {
        Self::Function(TorqueFunction(Arc::new(law)))
    }
}

/// What a torque may depend on.
#[derive(Debug)]
pub(crate) struct Instant<'a, T: nalgebra::Scalar> {
    /// The body's inverse principal moments, 1/(kg m²).
    pub(crate) inverse: &'a Vector3<T>,
    /// s.
    pub(crate) time: &'a T,
    /// Takes body axes to the world's.
    pub(crate) rotation: &'a Matrix3<T>,
    /// Angular momentum in body axes, kg m²/s.
    pub(crate) momentum: &'a Vector3<T>,
    /// Spin in body axes, rad/s.
    pub(crate) omega: &'a Vector3<T>,
}

impl<T: Analytic> Torque<T> {
    /// Its value in body axes, N m.
    // Always: into a kick, which looks at one kind of torque alone.
    #[inline(always)]
    pub(crate) fn at(&self, now: &Instant<'_, T>) -> Vector3<T> {
        let Instant { time, rotation, momentum, omega, .. } = *now;
        match self {
            Self::InBody(torque) => torque.clone(),
            Self::InWorld(torque) => rotation.tr_mul(torque),
            Self::Aligning { arm, field } => arm.cross(&rotation.tr_mul(field)),
            Self::Damping(coefficients) => -coefficients.component_mul(omega),
            Self::Dissipation(strength) => {
                momentum.cross(&momentum.cross(omega)).map(|x| x * strength.clone())
            }
            Self::GravityGradient { .. } => self.gradient(now),
            Self::Periodic { amplitude, rate, phase } => {
                let (_, cosine) = (rate.clone() * time.clone() + phase.clone()).sin_cos();
                amplitude.map(|x| x * cosine.clone())
            }
            Self::During { torque, .. } if self.acts_at(time) => torque.inner(now),
            Self::During { .. } => momentum.map(|_| T::zero()),
            Self::Function(TorqueFunction(law)) => law(time.clone(), rotation, omega),
        }
    }

    // Not inlined: a torque within a torque.
    #[inline(never)]
    fn inner(&self, now: &Instant<'_, T>) -> Vector3<T> {
        self.at(now)
    }

    /// The momentum (body axes) after it alone has acted for `h` seconds at a standing attitude and time.
    /// Damping decays and dissipation turns by their own exact laws, so that neither overshoots however long
    /// the step; a function acts by the explicit midpoint rule.
    pub(crate) fn kick(&self, now: &Instant<'_, T>, h: T) -> Vector3<T> {
        let Instant { inverse, momentum, .. } = *now;
        match self {
            Self::InBody(_)
            | Self::InWorld(_)
            | Self::Aligning { .. }
            | Self::GravityGradient { .. }
            | Self::Periodic { .. } => momentum + self.at(now).map(|x| x * h.clone()),
            Self::During { torque, .. } if self.acts_at(now.time) => torque.kick(now, h),
            Self::During { .. } => momentum.clone(),
            Self::Function(law) => law.kick(now, h),
            Self::Damping(coefficients) => Vector3::from_fn(|i, _| {
                momentum[i].clone() * (-(coefficients[i].clone() * inverse[i].clone() * h.clone())).exp()
            }),
            Self::Dissipation(strength) => dissipated(momentum, inverse, &(strength.clone() * h)),
        }
    }
}

impl<T: Analytic> TorqueFunction<T> {
    // Not inlined: most torques are others, and their way is the shorter for it.
    #[inline(never)]
    fn kick(&self, now: &Instant<'_, T>, h: T) -> Vector3<T> {
        let change =
            |omega: &Vector3<T>, h: T| (self.0)(now.time.clone(), now.rotation, omega).map(|x| x * h.clone());
        let halfway = now.momentum + change(now.omega, h.clone() / T::integer(2));
        now.momentum + change(&halfway.component_mul(now.inverse), h)
    }
}

/// The flow of `L' = L x (L x w)` with `w = J L`: each component decays by `exp(-|L|^2 J_i t)`, and the whole
/// is brought back to its length. Rates are taken from the slowest, so that one component always stays;
/// lengths relative to the largest component, so that no square leaves the range.
fn dissipated<T: Analytic>(momentum: &Vector3<T>, inverse: &Vector3<T>, time: &T) -> Vector3<T> {
    let present = |i: &usize| momentum[*i].size() > 0.0;
    let slowest = (0..3).filter(present).min_by(|&i, &j| inverse[i].size().total_cmp(&inverse[j].size()));
    let Some(slowest) = slowest else { return momentum.clone() };
    let largest = &momentum[momentum.map(|x| x.size()).imax()];
    let part = momentum.map(|x| x / largest.clone());
    let square = part.dot(&part);
    let decay = |i: usize| {
        // The difference of the rates first: where it is zero the product stays zero, however large the
        // others.
        let faster = (inverse[i].clone() - inverse[slowest].clone()) * time.clone();
        (-(faster * largest.clone() * largest.clone() * square.clone())).exp()
    };
    let shrunk = Vector3::from_fn(|i, _| part[i].clone() * decay(i));
    let back = (square.clone() / shrunk.dot(&shrunk)).sqrt();
    shrunk.map(|x| x * back.clone() * largest.clone())
}

/// How far the length of a direction may be from 1: several roundings of `f32`.
const UNIT_TOLERANCE: f64 = 1e-6;

impl<T: nalgebra::Scalar + ToPrimitive> Torque<T> {
    /// That its numbers are finite, its coefficients of loss not below zero, and its directions of length 1.
    pub(crate) fn validate(&self) -> Result<(), Error> {
        let number = |x: &T| x.to_f64().unwrap_or(f64::NAN);
        let vector = |v: &Vector3<T>| Vector3::from_fn(|i, _| number(&v[i]));
        match self {
            Self::InBody(torque) | Self::InWorld(torque) => finite_vector(Subject::Torque, &vector(torque)),
            Self::Aligning { arm, field } => {
                finite_vector(Subject::Arm, &vector(arm))?;
                finite_vector(Subject::Field, &vector(field))
            }
            Self::Damping(coefficients) => {
                let coefficients = vector(coefficients);
                coefficients.iter().try_for_each(|&c| not_negative(Subject::DampingCoefficient, c).map(drop))
            }
            Self::Dissipation(strength) => {
                not_negative(Subject::DissipationStrength, number(strength)).map(drop)
            }
            Self::GravityGradient { strength, direction, orbit } => {
                not_negative(Subject::GradientStrength, number(strength))?;
                finite_vector(Subject::OrbitRate, &vector(orbit))?;
                let (what, direction) = (Subject::GradientDirection, vector(direction));
                finite_vector(what, &direction)?;
                let length = direction.norm();
                if (length - 1.0).abs() > UNIT_TOLERANCE {
                    return Err(Refusal::NotUnit { what, length, tolerance: UNIT_TOLERANCE }.into());
                }
                Ok(())
            }
            Self::Periodic { amplitude, rate, phase } => {
                finite_vector(Subject::Torque, &vector(amplitude))?;
                finite(Subject::PeriodicRate, number(rate))?;
                finite(Subject::PeriodicPhase, number(phase)).map(drop)
            }
            Self::During { start, end, torque } => {
                let [start, end] = [start, end].map(number);
                for (what, time) in [(Subject::TorqueStart, start), (Subject::TorqueEnd, end)] {
                    if time.is_nan() {
                        return Err(Refusal::Undefined { what, why: "its time is not a number" }.into());
                    }
                }
                if start > end {
                    let (smaller, larger) = (Subject::TorqueStart, "its end");
                    return Err(Refusal::Order { smaller, small: start, larger, large: end }.into());
                }
                torque.validate()
            }
            Self::Function(_) => Ok(()),
        }
    }
}

impl<T: Analytic + Send + Sync> Torque<T> {
    /// The torque along other axes of the body: `frame` takes coordinates along the new axes to those
    /// along the old.
    ///
    /// # Errors
    /// Damping that differs from axis to axis: it is given along the principal axes.
    pub(crate) fn along(&self, frame: &Quaternion<T>) -> Result<Self, Error> {
        let turned = |v: &Vector3<T>| attitude::rotate_inverse(frame, v);
        Ok(match self {
            Self::InBody(torque) => Self::InBody(turned(torque)),
            Self::Aligning { arm, field } => Self::Aligning { arm: turned(arm), field: field.clone() },
            Self::Periodic { amplitude, rate, phase } => {
                Self::Periodic { amplitude: turned(amplitude), rate: rate.clone(), phase: phase.clone() }
            }
            Self::Damping(c) if c.x != c.y || c.y != c.z => {
                return Err(Refusal::Undefined {
                    what: Subject::UnequalDamping,
                    why: "it is given along the principal axes, and those of a body with products of inertia have no order to go \
                          by: give the body's moments along them, without products",
                }.into());
            }
            Self::Function(TorqueFunction(law)) => {
                let (law, old) = (Arc::clone(law), attitude::rotation_matrix(frame));
                Self::function(move |time, rotation, omega| {
                    old.tr_mul(&law(time, &(rotation * old.transpose()), &(&old * omega)))
                })
            }
            Self::During { start, end, torque } => Self::During {
                start: start.clone(),
                end: end.clone(),
                torque: Box::new(torque.along(frame)?),
            },
            Self::InWorld(_) | Self::Damping(_) | Self::Dissipation(_) | Self::GravityGradient { .. } => {
                self.clone()
            }
        })
    }
}
