//! Four engines that differ in the vector that they store and in how they compute the spin from it. One is
//! right; the other three are pitfalls.

use super::methods::runge_kutta::rk4;
use crate::attitude;
use crate::body::{Body, along};
use crate::dynamics::euler::tensor_times_acceleration;
use crate::error::{Error, Refusal, Subject, finite};
use crate::number::Field;
use alloc::vec::Vec;
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

/// A rule for turning a body: the vector that an engine stores, and the spin that it computes from this
/// vector.
///
/// All turn the body by the same integrator; they differ only in the vector they store, in its
/// [`rate`](Self::rate) and in [`omega_world`](Self::omega_world).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Engine {
    /// Right: carries `L`, constant, and turns the inverse tensor to the attitude, `w = R J R^T L`.
    Turned,
    /// Pitfall 1: carries `w` by the world's own equation `I w' = (I w) x w`, but with the body's tensor in
    /// it, as if the body had never turned.
    Frozen,
    /// Pitfall 2: carries `L`, constant, and takes it for the spin up to a constant factor: `w = L / m` with
    /// `m` the mean of the moments. Right for a sphere.
    MomentumForSpin,
    /// Pitfall 3: carries `w` as if it were conserved: no gyroscopic term, so it never flips.
    NoGyroscopicTerm,
}

impl Engine {
    /// All four, the right one first.
    pub const ALL: [Self; 4] = [Self::Turned, Self::Frozen, Self::MomentumForSpin, Self::NoGyroscopicTerm];

    /// The spin in world axes (rad/s) that this engine computes, from the attitude `rotation` (body to
    /// world), the body's tensor and its inverse, and the world vector it carries.
    ///
    /// ```
    /// use nalgebra::{Matrix3, Vector3};
    /// use tumbling::step::Engine;
    /// let tensor = Matrix3::from_diagonal(&Vector3::new(1.0, 2.0, 3.0));
    /// let inverse = tensor.map(|x| if x == 0.0 { 0.0 } else { 1.0 / x });
    /// let quarter_turn = Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    /// let carried = Vector3::new(2.0, 2.0, 0.0);
    /// let spin = |engine: Engine| engine.omega_world(&quarter_turn, &tensor, &inverse, &carried);
    /// assert_eq!(spin(Engine::Turned), Vector3::new(1.0, 2.0, 0.0));
    /// assert_eq!(spin(Engine::Frozen), carried);
    /// assert_eq!(spin(Engine::MomentumForSpin), Vector3::new(1.0, 1.0, 0.0));
    /// assert_eq!(spin(Engine::NoGyroscopicTerm), carried);
    /// ```
    #[must_use]
    pub fn omega_world<T: Field>(
        self,
        rotation: &Matrix3<T>,
        tensor: &Matrix3<T>,
        inverse: &Matrix3<T>,
        carried: &Vector3<T>,
    ) -> Vector3<T> {
        match self {
            Self::Turned => crate::inertia::omega_world(rotation, inverse, carried),
            Self::MomentumForSpin => {
                let sum = tensor[(0, 0)].clone() + tensor[(1, 1)].clone() + tensor[(2, 2)].clone();
                carried.map(|x| x * T::integer(3) / sum.clone())
            }
            Self::Frozen | Self::NoGyroscopicTerm => carried.clone(),
        }
    }

    /// The rates of the attitude (body to world, of any length) and of `carried`, the momentum or the spin in
    /// world axes, as the engine has it, while no torque acts, for the body's tensor and its inverse: the law
    /// that [`run`](Self::run) integrates.
    ///
    /// ```
    /// use nalgebra::{Matrix3, Quaternion, Vector3};
    /// use tumbling::step::Engine;
    /// let tensor = Matrix3::from_diagonal(&Vector3::new(1.0, 2.0, 4.0));
    /// let inverse = Matrix3::from_diagonal(&Vector3::new(1.0, 0.5, 0.25));
    /// let (start, carried) = (Quaternion::identity(), Vector3::new(1.0, 2.0, 0.0));
    /// let (attitude, vector) = Engine::Turned.rate(&tensor, &inverse, &start, &carried);
    /// assert_eq!(attitude, Quaternion::new(0.0, 0.5, 0.5, 0.0));
    /// assert_eq!(vector, Vector3::zeros());
    /// let (_, vector) = Engine::Frozen.rate(&tensor, &inverse, &start, &carried);
    /// assert_eq!(vector, Vector3::new(0.0, 0.0, -0.5));
    /// ```
    #[must_use]
    pub fn rate<T: Field>(
        self,
        tensor: &Matrix3<T>,
        inverse: &Matrix3<T>,
        attitude: &Quaternion<T>,
        carried: &Vector3<T>,
    ) -> (Quaternion<T>, Vector3<T>) {
        let rotation = attitude::rotation_matrix(attitude);
        let omega = self.omega_world(&rotation, tensor, inverse, carried);
        let turn = attitude::rate(attitude, &(rotation.transpose() * omega));
        let none = Vector3::from_fn(|_, _| T::zero());
        match self {
            Self::Frozen => (turn, inverse * tensor_times_acceleration(tensor, carried, &none)),
            Self::Turned | Self::MomentumForSpin | Self::NoGyroscopicTerm => (turn, none),
        }
    }

    /// The world vector that this engine carries for `body`: its momentum, or its spin.
    fn carried(self, body: &Body) -> Vector3<f64> {
        match self {
            Self::Frozen | Self::NoGyroscopicTerm => body.omega_world(),
            Self::Turned | Self::MomentumForSpin => body.momentum_world(),
        }
    }

    /// The free motion of `body` as this engine computes it, in `count` steps of `h` seconds: one body for
    /// each instant, including the start.
    ///
    /// Each body returned has the attitude that the engine computed and the true momentum at that spin, `R I
    /// R^T w`: the value that a measurement would find, not the one that the engine stores. The attitude is
    /// brought back to length 1 after each step; too long a step shows in the energy.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::{Body, Inertia, step::Engine};
    /// let inertia = Inertia::from_moments(1.0, 2.0, 2.5)?;
    /// let start = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(1.0, 1.0, 0.0))?;
    /// let right = Engine::Turned.run(&start, 0.01, 200)?;
    /// assert_eq!(right.len(), 201);
    /// assert!((right[200].energy() / start.energy() - 1.0).abs() < 1e-9);
    /// let wrong = Engine::Frozen.run(&start, 0.01, 2000)?;
    /// let most = wrong.iter().map(tumbling::Body::energy).fold(0.0, f64::max);
    /// assert!(most / start.energy() > 1.1, "{}", most / start.energy());
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A step that is not finite, or so coarse that the motion leaves what `f64` holds; more steps than there
    /// is memory for.
    pub fn run(self, body: &Body, h: f64, count: usize) -> Result<Vec<Body>, Error> {
        finite(Subject::Step, h)?;
        let tensor = body.inertia().matrix();
        let inverse = body.inverse();
        type Carried = (Quaternion<f64>, Vector3<f64>);
        let law = |(attitude, carried): &Carried| self.rate(&tensor, &inverse, attitude, carried);
        let plus = |(attitude, carried): &Carried, rate: &Carried, h| {
            let attitude = Quaternion::from_vector(along(&attitude.coords, &rate.0.coords, &h));
            (attitude, along(carried, &rate.1, &h))
        };
        let mut motion = (body.attitude().into_inner(), self.carried(body));
        let length = count.saturating_add(1);
        let mut bodies = Vec::new();
        // Reserved at once, so that a run too long for the memory is refused before it begins.
        bodies.try_reserve_exact(length).map_err(|_| Refusal::TooMany { what: Subject::Steps, count })?;
        for step in 0..=count {
            if step > 0 {
                motion = rk4(&motion, h, law, plus);
                let norm = motion.0.norm();
                Refusal::OutOfRange { what: Subject::AttitudeAfterStep, value: norm }
                    .when(!(norm.is_finite() && norm > 0.0))?;
                motion.0 /= norm;
            }
            let (attitude, carried) = &motion;
            let rotation = attitude::rotation_matrix(attitude);
            let omega = self.omega_world(&rotation, &tensor, &inverse, carried);
            let momentum = crate::inertia::turned(&rotation, &tensor) * omega;
            bodies.push(body.with(UnitQuaternion::new_unchecked(*attitude), &momentum)?);
        }
        Ok(bodies)
    }
}
