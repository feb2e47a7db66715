//! A scene: bodies, torques, times, outputs and an accuracy.

use crate::driven;
use crate::error::{Error, positive};
use crate::initial_state::InitialState;
use crate::plan::Plan;
use crate::states::Answer;
use crate::times::Times;
use tumbling::PrincipalMoments;
use tumbling::step::{System, Torque};

/// What is requested of each body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Outputs {
    /// The angular velocity in body axes, at each time.
    pub spin: bool,
    /// The attitude, body to world, at each time.
    pub attitude: bool,
    /// The kinetic energy, at each time.
    pub energy: bool,
    /// The angle between spin and momentum, at each time.
    pub gap: bool,
    /// The instants up to the end at which the spin along the middle axis changes sign. Of free bodies alone.
    pub flips: bool,
    /// The path of the spin in the body. Of free bodies alone.
    pub polhode: bool,
}

impl Outputs {
    /// None of them.
    pub const NOTHING: Self =
        Self { spin: false, attitude: false, energy: false, gap: false, flips: false, polhode: false };

    /// Whether any of them belongs to a time.
    #[must_use]
    pub fn states(self) -> bool {
        self.spin || self.attitude || self.energy || self.gap
    }
}

/// Bodies that do not touch, the torques on each of them, the outputs requested, and how accurate they must be.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    bodies: Vec<InitialState>,
    torques: Vec<Torque<f64>>,
    times: Times,
    outputs: Outputs,
    accuracy: f64,
}

impl Scene {
    /// Bodies under the same torques, with the same outputs at the same times. Torques that are zero are left out. Vectors of a torque
    /// that are given in body axes are in each body's own, but for a [`Damping`](Torque::Damping), which is along its principal axes.
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
    /// No body; a torque that is not valid; times that [cannot be had](Times::validate); an accuracy that is not above zero and below 1,
    /// or below 2 epsilon, which no state meets.
    pub fn new<B: Into<InitialState>>(
        bodies: impl IntoIterator<Item = B>,
        torques: Vec<Torque<f64>>,
        times: Times,
        outputs: Outputs,
        accuracy: f64,
    ) -> Result<Self, Error> {
        let bodies: Vec<InitialState> = bodies.into_iter().map(Into::into).collect();
        if bodies.is_empty() {
            return Err(Error::TooFew { what: "bodies", count: 0, needed: 1 });
        }
        let any = PrincipalMoments::new(1.0, 1.0, 1.0)?;
        for (index, torque) in torques.iter().enumerate() {
            // Torques are checked with the body on which they act; here any will do.
            System::with(any, vec![torque.clone()]).map_err(|source| Error::Torque { index, source })?;
        }
        times.validate()?;
        if positive("the accuracy", accuracy)? >= 1.0 {
            return Err(Error::Value {
                what: "the accuracy",
                value: accuracy,
                rule: "it must be below 1".to_owned(),
            });
        }
        if accuracy < 2.0 * f64::EPSILON {
            return Err(Error::Unattainable { requested: accuracy, attainable: 2.0 * f64::EPSILON });
        }
        let torques = torques.into_iter().filter(|torque| !driven::is_nothing(torque)).collect();
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

    /// How to answer for the body of number `index`, from 0.
    ///
    /// # Errors
    /// [`Error::Body`] with a field that no body has, [an output that it does not have](Error::Undefined), an accuracy that [cannot be
    /// had](Error::Unattainable), or a motion that leaves `f64`.
    pub fn plan(&self, index: usize) -> Result<Plan<'_>, Error> {
        let Some(body) = self.bodies.get(index) else {
            return Err(Error::TooFew {
                what: "bodies",
                count: self.bodies.len(),
                needed: index.saturating_add(1),
            });
        };
        Plan::new(self, body).map_err(|source| Error::Body { index, source: Box::new(source) })
    }

    /// Answers all of it, one body after the other ([`batch`](crate::batch) answers many side by side): `take` gets the number of
    /// each body with its states in order of time, or with what is wrong with it; then the next is answered.
    pub fn run(&self, mut take: impl FnMut(usize, Result<Answer, Error>)) {
        for index in 0..self.bodies.len() {
            match self.plan(index) {
                Ok(plan) => plan.states().for_each(|state| take(index, state)),
                Err(error) => take(index, Err(error)),
            }
        }
    }
}
