//! A scene: bodies, torques, times, outputs and an accuracy.

use crate::error::{Error, positive, within};
use crate::initial_state::InitialState;
use crate::times::Times;
use crate::torques::simplified;
use tumbling::PrincipalMoments;
use tumbling::step::{System, Torque};

/// Bodies that do not touch, the torques on each of them, the outputs requested, and how accurate they must
/// be.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    bodies: Vec<InitialState>,
    torques: Vec<Torque<f64>>,
    times: Times,
    outputs: Outputs,
    accuracy: f64,
}

impl Scene {
    /// Bodies under the same torques, with the same outputs at the same times.
    ///
    /// Torques that are zero at all times are left out, and nested windows of time are merged into one; times
    /// are those of the scene. Vectors of a torque in body axes are in the axes of each body, except for a
    /// [`Damping`](Torque::Damping), which is along its principal axes. A torque given by a function is
    /// refused when a body is planned.
    ///
    /// An invalid body is refused when that body is [planned](Self::plan); the others are answered.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling_scenes::{InitialState, Outputs, Scene, Times};
    /// let good = InitialState::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 1.0, 0.2));
    /// let bad = InitialState::spinning(Vector3::new(1.0, 2.0, 3.5), Vector3::new(0.1, 1.0, 0.2));
    /// let outputs = Outputs { spin: true, ..Outputs::NOTHING };
    /// let scene = Scene::new([good, bad, good], vec![], Times::every(1.0, 2.0), outputs, 1e-9)?;
    /// assert!(scene.plan(0).is_ok() && scene.plan(2).is_ok());
    /// assert!(scene.plan(1).unwrap_err().to_string().starts_with("body 1: no body has principal moments"));
    /// # Ok::<(), tumbling_scenes::Error>(())
    /// ```
    ///
    /// # Errors
    /// No body; a torque that is not valid; times that are [not valid](Times::validate); an accuracy that is
    /// not above zero and below 1, or that is below 2 epsilon, which no state can reach.
    pub fn new<B: Into<InitialState>>(
        bodies: impl IntoIterator<Item = B>,
        torques: Vec<Torque<f64>>,
        times: Times,
        outputs: Outputs,
        accuracy: f64,
    ) -> Result<Self, Error> {
        let bodies: Vec<InitialState> = bodies.into_iter().map(Into::into).collect();
        if bodies.is_empty() {
            positive("the number of bodies", 0.0)?;
        }
        let any = PrincipalMoments::new(1.0, 1.0, 1.0)?;
        for (index, torque) in torques.iter().enumerate() {
            // Torques are checked together with a body; here any body will do.
            System::with(any, vec![torque.clone()]).map_err(|source| Error::Torque { index, source })?;
        }
        times.validate()?;
        within("the accuracy", positive("the accuracy", accuracy)?, accuracy < 1.0, "it must be below 1")?;
        if accuracy < 2.0 * f64::EPSILON {
            return Err(Error::unattainable(accuracy, 2.0 * f64::EPSILON));
        }
        let torques = torques.into_iter().filter_map(simplified).collect();
        Ok(Self { bodies, torques, times, outputs, accuracy })
    }

    /// The bodies.
    #[must_use]
    pub fn bodies(&self) -> &[InitialState] {
        &self.bodies
    }

    /// The torques on each of them, without those that are zero.
    #[must_use]
    pub fn torques(&self) -> &[Torque<f64>] {
        &self.torques
    }

    /// The times requested.
    #[must_use]
    pub fn times(&self) -> &Times {
        &self.times
    }

    /// The outputs requested.
    #[must_use]
    pub fn outputs(&self) -> Outputs {
        self.outputs
    }

    /// The accuracy requested.
    #[must_use]
    pub fn accuracy(&self) -> f64 {
        self.accuracy
    }
}

/// The outputs requested for each body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Outputs {
    /// The angular velocity in body axes, at each time.
    pub spin: bool,
    /// The attitude, body to world, at each time.
    pub attitude: bool,
    /// The kinetic energy, at each time.
    pub energy: bool,
    /// The angle between spin and momentum, at each time.
    pub angle_to_momentum: bool,
    /// The instants up to the end at which the spin along the middle axis changes sign.
    pub flips: bool,
    /// The path of the spin in the body, for free bodies only.
    pub polhode: bool,
}

impl Outputs {
    /// No output.
    pub const NOTHING: Self = Self {
        spin: false,
        attitude: false,
        energy: false,
        angle_to_momentum: false,
        flips: false,
        polhode: false,
    };

    /// Whether any of the outputs is a function of time.
    #[must_use]
    pub fn states(self) -> bool {
        self.spin || self.attitude || self.energy || self.angle_to_momentum
    }
}
