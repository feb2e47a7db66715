//! Torques on a body: each with its value, and with its own exact flow while the attitude stands still.

use crate::error::{Error, finite_vector, not_negative};
use crate::number::{Analytic, Field};
use nalgebra::{Matrix3, Vector3};

/// A torque on a rigid body about its centre of mass, or about the fixed point of a top.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Torque<T: nalgebra::Scalar> {
    /// Constant along the body's axes, N m: a thruster.
    InBody(Vector3<T>),
    /// Constant along the world's axes, N m.
    InWorld(Vector3<T>),
    /// `arm x field`, with the arm fixed in the body and the field in the world. A compass needle has its magnetic
    /// moment (A m²) for an arm in the field's tesla; a heavy top has the way from its point to its centre of mass
    /// (m) for an arm, and its weight (N) for a field. Near rest it is a spring.
    Aligning {
        /// In body axes.
        arm: Vector3<T>,
        /// In world axes.
        field: Vector3<T>,
    },
    /// `-c_i w_i` along each principal axis, `c` in N m s: viscous drag.
    Damping(Vector3<T>),
    /// `k L x (L x w)`, `k` in s/(kg m²): loss inside a body that is not quite rigid. It keeps `|L|` and takes energy,
    /// until the body turns about the axis of its largest moment [BKMR96](crate::references).
    Dissipation(T),
}

impl<T: Field> Torque<T> {
    /// Gravity on a top whose centre of mass is `arm` (m) from the fixed point, in body axes, and whose weight (N) pulls
    /// along the world's -z.
    #[must_use]
    pub fn gravity(arm: Vector3<T>, weight: T) -> Self {
        Self::Aligning { arm, field: Vector3::new(T::zero(), T::zero(), -weight) }
    }

    /// Its value in body axes, N m, at the attitude with this rotation matrix (body to world) and the momentum and spin in
    /// body axes.
    ///
    /// ```
    /// use nalgebra::{Matrix3, Vector3};
    /// use tumbling::step::Torque;
    /// // A top lying along the world's x: its weight of 2 N half a metre out turns it about y.
    /// let top = Torque::gravity(Vector3::new(0.5, 0.0, 0.0), 2.0);
    /// let still = Vector3::zeros();
    /// assert_eq!(top.at(&Matrix3::identity(), &still, &still), Vector3::new(0.0, 1.0, 0.0));
    /// ```
    #[must_use]
    pub fn at(&self, rotation: &Matrix3<T>, momentum: &Vector3<T>, omega: &Vector3<T>) -> Vector3<T> {
        match self {
            Self::InBody(torque) => torque.clone(),
            Self::InWorld(torque) => rotation.tr_mul(torque),
            Self::Aligning { arm, field } => arm.cross(&rotation.tr_mul(field)),
            Self::Damping(coefficients) => -coefficients.component_mul(omega),
            Self::Dissipation(strength) => {
                momentum.cross(&momentum.cross(omega)).map(|x| x * strength.clone())
            }
        }
    }
}

impl<T: Analytic> Torque<T> {
    /// The momentum (body axes) after it alone has acted for the time `h` (s) on a body of these inverse moments at a
    /// standing attitude. Damping decays and
    /// dissipation turns by their own exact laws, so that neither overshoots however long the step.
    ///
    /// ```
    /// use nalgebra::{Matrix3, Vector3};
    /// use tumbling::step::Torque;
    /// let drag = Torque::Damping(Vector3::new(4.0, 0.0, 2.0));
    /// let (before, inverse) = (Vector3::new(1.0, 1.0, 1.0), Vector3::new(1.0, 0.5, 0.25));
    /// let after = drag.kick(&inverse, &Matrix3::identity(), &before, 1e3);
    /// assert_eq!(after, Vector3::new(0.0, 1.0, (-500.0_f64).exp()));
    /// ```
    #[must_use]
    pub fn kick(
        &self,
        inverse: &Vector3<T>,
        rotation: &Matrix3<T>,
        momentum: &Vector3<T>,
        h: T,
    ) -> Vector3<T> {
        match self {
            Self::InBody(_) | Self::InWorld(_) | Self::Aligning { .. } => {
                // None of the three looks at the spin.
                momentum + self.at(rotation, momentum, momentum).map(|x| x * h.clone())
            }
            Self::Damping(coefficients) => Vector3::from_fn(|i, _| {
                momentum[i].clone() * (-(coefficients[i].clone() * inverse[i].clone() * h.clone())).exp()
            }),
            Self::Dissipation(strength) => dissipated(momentum, inverse, &(strength.clone() * h)),
        }
    }
}

/// The flow of `L' = L x (L x w)` with `w = J L`: each component decays by `exp(-|L|^2 J_i t)`, and the whole is brought back to
/// its length. Rates are taken from the slowest, so that one component always stays; lengths in parts of the largest component, so
/// that no square leaves the range.
fn dissipated<T: Analytic>(momentum: &Vector3<T>, inverse: &Vector3<T>, time: &T) -> Vector3<T> {
    let present = |i: &usize| momentum[*i].size() > 0.0;
    let slowest = (0..3).filter(present).min_by(|&i, &j| inverse[i].size().total_cmp(&inverse[j].size()));
    let Some(slowest) = slowest else { return momentum.clone() };
    let largest = &momentum[momentum.map(|x| x.size()).imax()];
    let part = momentum.map(|x| x / largest.clone());
    let square = part.dot(&part);
    let decay = |i: usize| {
        // In this order: nothing times anything finite is nothing.
        let beside = (inverse[i].clone() - inverse[slowest].clone()) * time.clone();
        (-(beside * largest.clone() * largest.clone() * square.clone())).exp()
    };
    let shrunk = Vector3::from_fn(|i, _| part[i].clone() * decay(i));
    let back = (square.clone() / shrunk.dot(&shrunk)).sqrt();
    shrunk.map(|x| x * back.clone() * largest.clone())
}

impl Torque<f64> {
    /// That its numbers are finite, and its coefficients of loss not below zero.
    pub fn validate(&self) -> Result<(), Error> {
        match self {
            Self::InBody(torque) | Self::InWorld(torque) => finite_vector("the torque", torque),
            Self::Aligning { arm, field } => {
                finite_vector("the arm", arm)?;
                finite_vector("the field", field)
            }
            Self::Damping(coefficients) => {
                coefficients.iter().try_for_each(|&c| not_negative("a damping coefficient", c).map(drop))
            }
            Self::Dissipation(strength) => {
                not_negative("the strength of the dissipation", *strength).map(drop)
            }
        }
    }
}
