//! How to answer for one body.

use crate::error::Error;
use crate::initial_state::{InitialState, Principal};
use crate::outputs::Outputs;
use crate::scene::Scene;
use crate::strategy::Strategy;
use crate::{driven, free};
use nalgebra::Vector3;
use tumbling::dynamics::observe;
use tumbling::exact::Polhode;
use tumbling::exact::{Flips, FreeMotion};
use tumbling::{Inertia, PrincipalMoments};

/// How to answer for one body of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) body: Principal,
    pub(crate) strategy: Strategy,
    /// Where it does not change.
    pub(crate) energy: Option<f64>,
    pub(crate) angle_to_momentum: Option<f64>,
}

impl Scene {
    /// How to answer for the body of number `index`, from 0.
    ///
    /// # Errors
    /// [`Error::Body`] with a field that no body has, [an output that it does not have](Error::Undefined), an
    /// accuracy that [cannot be had](Error::Unattainable), or a motion that leaves `f64`.
    pub fn plan(&self, index: usize) -> Result<Plan<'_>, Error> {
        let Some(body) = self.bodies().get(index) else {
            return Err(Error::TooFew {
                what: "bodies",
                count: self.bodies().len(),
                needed: index.saturating_add(1),
            });
        };
        Plan::new(self, body).map_err(|source| Error::Body { index, source: Box::new(source) })
    }
}

impl<'a> Plan<'a> {
    pub(crate) fn new(scene: &'a Scene, state: &InitialState) -> Result<Self, Error> {
        let body = state.principal()?;
        let outputs = scene.outputs();
        let free = scene.torques().is_empty();
        let strategy = if free {
            free::strategy(&body, outputs, scene.times().end(), scene.accuracy())?
        } else {
            refuse_of_driven(outputs)?;
            if outputs.states() { driven::strategy(&body, scene)? } else { Strategy::Nothing }
        };
        let energy = if outputs.energy && free { Some(energy(body.moments, &body.omega)?) } else { None };
        if outputs.angle_to_momentum && body.omega == Vector3::zeros() {
            return Err(Error::Undefined {
                what: "the angle between spin and momentum",
                why: "a body at rest has neither",
            });
        }
        let steady = matches!(
            strategy,
            Strategy::Nothing
                | Strategy::Constant { .. }
                | Strategy::Rotation { .. }
                | Strategy::SymmetricTop(_)
        );
        let angle_to_momentum = if outputs.angle_to_momentum && steady {
            Some(Inertia::from(body.moments).angle_to_momentum(&body.omega)?)
        } else {
            None
        };
        Ok(Self { scene, body, strategy, energy, angle_to_momentum })
    }

    /// The strategy chosen.
    #[must_use]
    pub fn strategy(&self) -> &Strategy {
        &self.strategy
    }

    /// The kinetic energy, J, where it is requested and constant.
    #[must_use]
    pub fn energy(&self) -> Option<f64> {
        self.energy
    }

    /// The angle between spin and momentum, rad, where it is requested and constant.
    #[must_use]
    pub fn angle_to_momentum(&self) -> Option<f64> {
        self.angle_to_momentum
    }

    /// The free motion that the states are taken from, along the body's principal axes and from their
    /// attitude at the start; none where nothing moves, or under a torque.
    ///
    /// The motions of many such bodies may be answered [side by side](tumbling::exact::Batch) and each answer
    /// completed by [`state`](Self::state).
    #[must_use]
    pub fn motion(&self) -> Option<FreeMotion> {
        self.free_motion().copied()
    }

    pub(crate) fn free_motion(&self) -> Option<&FreeMotion> {
        match &self.strategy {
            Strategy::Rotation { motion, .. }
            | Strategy::SymmetricTop(motion)
            | Strategy::EllipticSpin(motion)
            | Strategy::Elliptic(motion) => Some(motion),
            _ => None,
        }
    }

    /// The flips up to the end of the scene, in order, without a step of the motion.
    ///
    /// # Errors
    /// Under a torque, or as [`FreeMotion::flips`].
    pub fn flips(&self) -> Result<Flips, Error> {
        refuse_driven(self.scene, FLIPS)?;
        let end = self.scene.times().end();
        Ok(match self.free_motion() {
            Some(motion) => motion.flips(0.0, end)?,
            None => FreeMotion::new(self.body.moments, &self.body.omega)?.flips(0.0, end)?,
        })
    }

    /// The path of the spin in the body, along its principal axes, from energy and momentum alone.
    ///
    /// # Errors
    /// Under a torque, or a period beyond `f64`.
    pub fn polhode(&self) -> Result<Polhode, Error> {
        refuse_driven(self.scene, POLHODE)?;
        Ok(Polhode::new(self.body.moments, &self.body.omega)?)
    }
}

const FLIPS: &str = "the list of flips";
const POLHODE: &str = "the polhode";
const WHY: &str = "a torque acts: what it follows from is not conserved";

fn refuse_driven(scene: &Scene, what: &'static str) -> Result<(), Error> {
    if scene.torques().is_empty() { Ok(()) } else { Err(Error::Undefined { what, why: WHY }) }
}

fn refuse_of_driven(outputs: Outputs) -> Result<(), Error> {
    match (outputs.flips, outputs.polhode) {
        (true, _) => Err(Error::Undefined { what: FLIPS, why: WHY }),
        (_, true) => Err(Error::Undefined { what: POLHODE, why: WHY }),
        _ => Ok(()),
    }
}

/// Half of `w . I w`, J.
pub(crate) fn energy(moments: PrincipalMoments, omega: &Vector3<f64>) -> Result<f64, Error> {
    let energy = observe::energy(omega, &moments.vector().component_mul(omega));
    if energy.is_finite() { Ok(energy) } else { Err(Error::OutOfRange { what: "the energy", value: energy }) }
}
