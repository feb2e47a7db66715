//! A body at the start of a scene, as described and along its principal axes.

use crate::error::{Error, Field, finite};
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::{Body, Inertia, PrincipalMoments, attitude, dynamics::observe};

/// How a body moves at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Start {
    /// With this angular velocity in body axes, rad/s.
    Spin(Vector3<f64>),
    /// With this angular momentum in world axes, kg m²/s.
    Momentum(Vector3<f64>),
}

/// A body at the start of a scene: its tensor, attitude, and spin or momentum, in any axes.
///
/// It is a plain description, which is checked when the body is [planned](crate::Scene::plan). A [`Body`]
/// converts into it.
///
/// ```
/// use nalgebra::{UnitQuaternion, Vector3};
/// use tumbling::{Body, Inertia};
/// use tumbling_scenes::InitialState;
/// let tensor = Inertia::new([3.0, 1.5, 2.5], [0.2, 0.0, -0.1])?;
/// let body = Body::spinning(tensor, UnitQuaternion::identity(), &Vector3::new(0.1, 2.0, 0.3))?;
/// let state = InitialState::from(body);
/// assert_eq!(state.products, Vector3::new(0.2, 0.0, -0.1));
/// assert_eq!(state.body()?, body);
/// # Ok::<(), tumbling_scenes::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InitialState {
    /// The diagonal of the inertia tensor in body axes, kg m²: the principal moments where the products are
    /// zero.
    pub moments: Vector3<f64>,
    /// The entries xy, xz, yz of the tensor, kg m², signed so that `L = I w` holds. Damping that differs
    /// between axes acts along the principal axes. If the products are not zero, these axes have no defined
    /// order, so a body with such damping is refused.
    pub products: Vector3<f64>,
    /// Body to world.
    pub attitude: UnitQuaternion<f64>,
    /// The spin or the angular momentum.
    pub start: Start,
}

impl From<Body> for InitialState {
    fn from(body: Body) -> Self {
        let tensor = body.inertia().matrix();
        Self {
            moments: tensor.diagonal(),
            products: Vector3::new(tensor[(0, 1)], tensor[(0, 2)], tensor[(1, 2)]),
            attitude: body.attitude(),
            start: Start::Momentum(body.momentum_world()),
        }
    }
}

impl InitialState {
    /// A body with these principal moments (kg m²) and this spin (rad/s) along the same axes, which are the
    /// world's at the start.
    #[must_use]
    pub fn spinning(moments: Vector3<f64>, omega: Vector3<f64>) -> Self {
        let (products, attitude) = (Vector3::zeros(), UnitQuaternion::identity());
        Self { moments, products, attitude, start: Start::Spin(omega) }
    }

    /// The body.
    ///
    /// # Errors
    /// [`Error::Field`] with the field that is invalid, and why.
    pub fn body(&self) -> Result<Body, Error> {
        let inertia = Inertia::new(self.moments.into(), self.products.into());
        let inertia = inertia.map_err(|error| self.of_tensor(error))?;
        let attitude = self.checked_attitude()?;
        let body = match &self.start {
            Start::Spin(omega) => Body::spinning(inertia, attitude, omega),
            Start::Momentum(momentum) => Body::new(inertia, attitude, momentum),
        };
        body.map_err(|error| Error::of_field(self.start_field())(error.into()))
    }

    /// Its free motion, answered in its own axes and in the world.
    ///
    /// # Errors
    /// The errors of [`body`](Self::body) or of [`FreeMotion::new`].
    pub fn motion(&self) -> Result<FreeMotion, Error> {
        match self.start {
            Start::Spin(omega) if self.products == Vector3::zeros() => {
                Ok(FreeMotion::new(self.moments.try_into()?, &omega)?.with_attitude(self.attitude)?)
            }
            _ => Ok(FreeMotion::of(&self.body()?)?),
        }
    }

    /// The error with the right field: the products, if a body could have the moments without them.
    fn of_tensor(&self, error: tumbling::Error) -> Error {
        let alone = self.products != Vector3::zeros() && PrincipalMoments::try_from(self.moments).is_ok();
        Error::of_field(if alone { Field::Products } else { Field::Moments })(error.into())
    }

    fn start_field(&self) -> Field {
        match self.start {
            Start::Spin(_) => Field::Spin,
            Start::Momentum(_) => Field::Momentum,
        }
    }

    fn checked_attitude(&self) -> Result<UnitQuaternion<f64>, Error> {
        attitude::checked(self.attitude).map_err(|error| Error::of_field(Field::Attitude)(error.into()))
    }

    /// The checked state, with the values that its plan needs.
    pub(crate) fn checked(&self) -> Result<Checked, Error> {
        let attitude = self.checked_attitude()?;
        let products = self.products.iter().zip(["xy", "xz", "yz"]);
        for (&product, what) in products {
            finite(what, product).map_err(Error::of_field(Field::Products))?;
        }
        let framed = self.products != Vector3::zeros();
        let (inertia, omega, moments) = match self.start {
            Start::Spin(omega) if !framed => {
                let moments = PrincipalMoments::try_from(self.moments);
                let moments = moments.map_err(|error| self.of_tensor(error))?;
                (Inertia::from(moments), omega, moments)
            }
            _ => {
                let body = self.body()?;
                let moments = match framed {
                    true => body.inertia().principal().try_into(),
                    false => self.moments.try_into(),
                };
                let moments = moments.map_err(|error| self.of_tensor(error))?;
                let omega = if let Start::Spin(omega) = self.start { omega } else { body.omega_body() };
                (body.inertia(), omega, moments)
            }
        };
        let wrong = Error::of_field(self.start_field());
        omega.iter().try_for_each(|&x| finite("the spin", x).map(drop)).map_err(wrong)?;
        let along = if framed { inertia.principal().frame().tr_mul(&omega) } else { omega };
        let rounded = self.rounded(&moments.vector(), &along, framed);
        Ok(Checked { inertia, omega, attitude, moments, along, rounded })
    }

    /// The rounding in the conversion of these numbers to principal axes: of the moments of a tensor relative
    /// to the largest of them, of a rotated momentum relative to its length.
    fn rounded(&self, moments: &Vector3<f64>, omega: &Vector3<f64>, framed: bool) -> Rounded {
        let (largest, length) = (moments.max(), moments.component_mul(omega).norm());
        let turned = matches!(self.start, Start::Momentum(_)) && self.attitude != UnitQuaternion::identity();
        let omega = if framed {
            // The moment that the momentum is divided by is rounded too.
            moments.zip_map(omega, |moment, w| (length + w.abs() * largest) / moment)
        } else if turned {
            moments.map(|moment| length / moment)
        } else {
            omega.abs()
        };
        Rounded { moments: if framed { Vector3::repeat(largest) } else { *moments }, omega }
    }
}

/// A body at the start, and along its principal axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Checked {
    pub(crate) inertia: Inertia,
    /// In body axes, rad/s.
    pub(crate) omega: Vector3<f64>,
    /// Body to world.
    pub(crate) attitude: UnitQuaternion<f64>,
    pub(crate) moments: PrincipalMoments,
    /// The spin along the principal axes, rad/s.
    pub(crate) along: Vector3<f64>,
    pub(crate) rounded: Rounded,
}

/// For each number of a body along its principal axes, the size of which one rounding is a share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rounded {
    pub(crate) moments: Vector3<f64>,
    pub(crate) omega: Vector3<f64>,
}

impl Checked {
    /// Whether it has a middle axis: three different moments.
    pub(crate) fn can_flip(&self) -> bool {
        let [a, b, c] = self.moments.into();
        a != b && b != c && c != a
    }

    /// The kinetic energy at a spin in body axes, J.
    pub(crate) fn energy(&self, omega: &Vector3<f64>) -> Result<f64, Error> {
        finite("the energy", observe::energy(omega, &self.inertia.momentum(omega)))
    }
}
