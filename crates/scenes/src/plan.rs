//! How to answer for one body.

use crate::driven;
use crate::error::Error;
use crate::free;
use crate::initial_state::{Checked, InitialState};
use crate::scene::Scene;
use nalgebra::Vector3;
use tumbling::exact::{Flips, FreeMotion, Polhode};
use tumbling::step::Stepper;

/// How to answer for one body of a scene.
#[derive(Debug, Clone)]
pub struct Plan<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) start: Checked,
    pub(crate) strategy: Strategy,
    /// Of a free body, if it is used.
    pub(crate) motion: Option<Box<FreeMotion>>,
    /// Of a body under torques that is stepped.
    pub(crate) driven: Option<Driven>,
    /// Where it does not change.
    pub(crate) energy: Option<f64>,
    pub(crate) angle_to_momentum: Option<f64>,
}

impl Scene {
    /// How to answer for the body of number `index`, from 0.
    ///
    /// # Errors
    /// [`Error::Body`] with a field that no body has, [an output that it does not have](Error::Undefined), an
    /// accuracy that [cannot be reached](Error::Unattainable), trial runs that take [too many
    /// steps](Error::OutOfSteps) or [do not agree](Error::Disagreement), or a motion beyond the range of
    /// `f64`.
    pub fn plan(&self, index: usize) -> Result<Plan<'_>, Error> {
        let of_body = |source| Error::Body { index, source: Box::new(source) };
        let body = self.bodies().get(index).ok_or_else(|| {
            let rule = format!("it must be below the number of bodies, {}", self.bodies().len());
            of_body(Error::Value { what: "the number of a body", value: index as f64, rule })
        })?;
        Plan::new(self, body).map_err(of_body)
    }
}

impl<'a> Plan<'a> {
    fn new(scene: &'a Scene, state: &InitialState) -> Result<Self, Error> {
        let start = state.checked()?;
        let outputs = scene.outputs();
        let free = scene.torques().is_empty();
        let of_motion = outputs.attitude || outputs.spin || outputs.angle_to_momentum || outputs.flips;
        let (mut strategy, mut motion, mut driven) = (Strategy::Nothing, None, None);
        if free && of_motion {
            let found = Box::new(state.motion()?);
            strategy = free::strategy(&start, &found, outputs, scene.times().end(), scene.accuracy())?;
            motion = Some(found);
        } else if !free {
            refuse_polhode_of_driven(scene, outputs.polhode)?;
            if of_motion || outputs.energy {
                strategy = Strategy::Adaptive;
                driven = Some(driven::chosen(&start, &state.body()?, scene)?);
            }
        }
        if outputs.angle_to_momentum && start.omega == Vector3::zeros() {
            let (what, why) = ("the angle between spin and momentum", "a body at rest has neither");
            return Err(Error::Undefined { what, why });
        }
        let steady = matches!(
            strategy,
            Strategy::Nothing | Strategy::Constant | Strategy::Rotation | Strategy::SymmetricTop
        );
        let kept =
            (outputs.angle_to_momentum && steady).then(|| start.inertia.angle_to_momentum(&start.omega));
        let energy = (outputs.energy && free).then(|| start.energy(&start.omega));
        Ok(Self {
            scene,
            start,
            strategy,
            motion,
            driven,
            energy: energy.transpose()?,
            angle_to_momentum: kept.transpose()?,
        })
    }

    /// The strategy chosen.
    #[must_use]
    pub fn strategy(&self) -> Strategy {
        self.strategy
    }

    /// How a body under torques is stepped.
    #[must_use]
    pub fn driven(&self) -> Option<&Driven> {
        self.driven.as_ref()
    }

    /// The flips up to the end of the scene, in order: the instants at which the spin along the middle axis
    /// changes sign. For a free body no motion is stepped. A body with two equal moments has no flips.
    ///
    /// # Errors
    /// The errors of [`FreeMotion::flips`], or under a torque of
    /// [`Stepper::flips`](tumbling::step::Stepper::flips).
    pub fn flips(&self) -> Result<FlipTimes, Error> {
        let end = self.scene.times().end();
        if let Some(motion) = &self.motion {
            return Ok(FlipTimes::Free(motion.flips(0.0, end)?));
        }
        if self.scene.torques().is_empty() {
            let motion = FreeMotion::new(self.start.moments, &self.start.along)?;
            return Ok(FlipTimes::Free(motion.flips(0.0, end)?));
        }
        let found = match &self.driven {
            Some(driven) if self.start.can_flip() => driven.stepper.clone().flips(end)?,
            _ => Vec::new(),
        };
        Ok(FlipTimes::Driven(found.into_iter()))
    }

    /// The path of the spin in the body, along its principal axes, from energy and momentum alone.
    ///
    /// # Errors
    /// A torque acts, or the period is beyond `f64`.
    pub fn polhode(&self) -> Result<Polhode, Error> {
        refuse_polhode_of_driven(self.scene, true)?;
        Ok(Polhode::new(self.start.moments, &self.start.along)?)
    }
}

fn refuse_polhode_of_driven(scene: &Scene, requested: bool) -> Result<(), Error> {
    let why = "a torque acts: what it follows from is not conserved";
    let refused = Err(Error::Undefined { what: "the polhode", why });
    if requested && !scene.torques().is_empty() { refused } else { Ok(()) }
}

/// Instants of flips, s, in order.
#[derive(Debug, Clone)]
pub enum FlipTimes {
    /// Of a free body, each computed as it is reached.
    Free(Flips),
    /// Of a body under torques.
    Driven(std::vec::IntoIter<f64>),
}

impl FlipTimes {
    /// The number of remaining flips, without computing each.
    #[must_use]
    pub fn remaining(&self) -> u64 {
        match self {
            Self::Free(flips) => flips.remaining(),
            Self::Driven(flips) => flips.len() as u64,
        }
    }
}

impl Iterator for FlipTimes {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        match self {
            Self::Free(flips) => flips.next(),
            Self::Driven(flips) => flips.next(),
        }
    }
}

/// The ways to answer, the cheapest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Strategy {
    /// No output that changes with time is requested: all outputs follow from conserved quantities.
    Nothing,
    /// The outputs are constant: the spin of a steady motion, and the attitude of a body at rest.
    Constant,
    /// A steady rotation about a fixed axis.
    Rotation,
    /// Two equal moments: sines and cosines.
    SymmetricTop,
    /// Three different moments, the spin alone: Jacobi's functions.
    EllipticSpin,
    /// The attitude too: theta functions.
    Elliptic,
    /// Taylor series with their error controlled; collocation where damping is much faster than the motion.
    Adaptive,
}

/// A body under torques: how it is stepped, and what the trial runs showed.
#[derive(Debug, Clone)]
pub struct Driven {
    /// At the start.
    pub(crate) stepper: Stepper,
    pub(crate) tolerance: f64,
    pub(crate) difference: f64,
    pub(crate) steps: usize,
    /// The instructions of all trial runs.
    pub(crate) trials: f64,
    /// Whether damping is much faster than the motion.
    pub(crate) stiff: bool,
}

impl Driven {
    /// The largest difference between the trial run used and those that it was compared with: one with
    /// another tolerance and, where one of the two has the least, two of a slightly changed body.
    #[must_use]
    pub fn observed_difference(&self) -> f64 {
        self.difference
    }

    /// The number of steps of the run used.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }
}
