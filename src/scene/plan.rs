//! How to answer for one body.

use super::by::By;
use super::states::States;
use super::{Polhode, Principal, Scene, Toss, Wants, driven, free};
use crate::error::{Error, Refusal, finite};
use crate::exact::{Flips, FreeMotion, Precession, Turn};
use crate::inertia::{Inertia, PrincipalMoments};
use crate::step::{Method, State, System};
use nalgebra::{UnitQuaternion, Vector3};

/// The ways to answer, the cheapest first. Each holds what it uses.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Way {
    /// Nothing that moves is asked for: all of it follows from what is conserved.
    Nothing,
    /// What is asked for stands still: the spin of a steady motion, and the attitude of a body at rest.
    Constant {
        /// The spin in body axes, rad/s, where it is asked for.
        spin: Option<Vector3<f64>>,
        /// The attitude, body to world, where it is asked for.
        attitude: Option<UnitQuaternion<f64>>,
    },
    /// An even turn about one fixed axis.
    Rotation(Rotation),
    /// Two equal moments: sines and cosines.
    SymmetricTop(Top),
    /// Three different moments, the spin alone: Jacobi's functions.
    EllipticSpin(Box<FreeMotion>),
    /// The attitude too.
    Elliptic(Box<FreeMotion>),
    /// Steps of a method, with the torques as kicks between.
    Stepper(Driven),
    /// The exact free motion between kicks of the torques.
    Flow(Driven),
    /// Dormand and Prince's pair with its error controlled.
    Controlled(Driven),
    /// Damping much faster than the motion: steps of a method that it does not limit.
    Stiff(Driven),
}

/// A steady turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotation {
    pub(super) turn: Turn,
    pub(super) clock: f64,
    pub(super) spin: Option<Vector3<f64>>,
}

/// The motion of a symmetric top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Top {
    pub(super) precession: Precession,
    pub(super) clock: f64,
}

/// A body under torques, how it is stepped, and what was seen when that was tried.
#[derive(Debug, Clone, PartialEq)]
pub struct Driven {
    pub(super) system: System<f64>,
    pub(super) start: State<f64>,
    pub(super) by: By,
    /// The largest difference seen between two runs of different steps.
    pub(super) seen: f64,
    /// Steps of the run that was found good.
    pub(super) steps: usize,
    /// What all runs that were tried took, in instructions.
    pub(super) trials: f64,
    /// Whether damping is much faster than the motion.
    pub(super) stiff: bool,
}

impl Driven {
    /// The stepping method; none where the exact motion goes between kicks.
    #[must_use]
    pub fn method(&self) -> Option<Method> {
        match self.by {
            By::Steps(method, _) => Some(method),
            By::Control(_) => Some(Method::DormandPrince5),
            By::Flow(_) => None,
        }
    }

    /// The longest step, s; none where it follows from a tolerance.
    #[must_use]
    pub fn step(&self) -> Option<f64> {
        match self.by {
            By::Steps(_, step) | By::Flow(step) => Some(step),
            By::Control(_) => None,
        }
    }

    /// The tolerance of a step, where the error is controlled.
    #[must_use]
    pub fn tolerance(&self) -> Option<f64> {
        if let By::Control(tolerance) = self.by { Some(tolerance) } else { None }
    }

    /// How far apart two runs were at most, the one that is taken and one of other steps.
    #[must_use]
    pub fn seen(&self) -> f64 {
        self.seen
    }

    /// How many steps that run took.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }
}

/// How to answer for one body of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan<'a> {
    pub(super) scene: &'a Scene,
    pub(super) body: Principal,
    pub(super) way: Way,
    /// Where it does not change.
    pub(super) energy: Option<f64>,
    pub(super) gap: Option<f64>,
    pub(super) inertia: Inertia,
}

impl<'a> Plan<'a> {
    pub(super) fn new(scene: &'a Scene, toss: &Toss) -> Result<Self, Error> {
        let body = toss.principal()?;
        let (wants, end) = (scene.wants, scene.times.end());
        let free = scene.torques.is_empty();
        let moves = wants.spin || wants.attitude || wants.energy || wants.gap;
        let way = if free {
            free::way(&body, wants, end, scene.accuracy)?
        } else {
            refuse_of_driven(wants)?;
            if moves { driven::way(&body, scene)? } else { Way::Nothing }
        };
        let inertia = Inertia::from(body.moments);
        let energy = if wants.energy && free { Some(energy(body.moments, &body.omega)?) } else { None };
        if wants.gap && body.omega == Vector3::zeros() {
            return Err(Refusal::Undefined {
                what: "the angle between spin and momentum",
                why: "a body at rest has neither",
            }
            .into());
        }
        let steady =
            matches!(way, Way::Nothing | Way::Constant { .. } | Way::Rotation(_) | Way::SymmetricTop(_));
        let gap = if wants.gap && steady { Some(inertia.angle_to_momentum(&body.omega)?) } else { None };
        Ok(Self { scene, body, way, energy, gap, inertia })
    }

    /// The way chosen.
    #[must_use]
    pub fn way(&self) -> &Way {
        &self.way
    }

    /// The kinetic energy, J, where it is asked for and stays.
    #[must_use]
    pub fn energy(&self) -> Option<f64> {
        self.energy
    }

    /// The angle between spin and momentum, rad, where it is asked for and stays.
    #[must_use]
    pub fn gap(&self) -> Option<f64> {
        self.gap
    }

    /// The states asked for, in order, one at a time.
    #[must_use]
    pub fn states(&self) -> States<'_> {
        States::new(self)
    }

    /// The flips up to the end of the scene, in order, without a step of the motion.
    ///
    /// # Errors
    /// Under a torque, or as [`FreeMotion::flips`].
    pub fn flips(&self) -> Result<Flips, Error> {
        refuse_driven(self.scene, FLIPS)?;
        let end = self.scene.times.end();
        match &self.way {
            Way::EllipticSpin(motion) | Way::Elliptic(motion) => motion.flips(0.0, end),
            _ => FreeMotion::new(self.body.moments, &self.body.omega)?.flips(0.0, end),
        }
    }

    /// The path of the spin in the body, from energy and momentum alone.
    ///
    /// # Errors
    /// Under a torque, or a time once around beyond `f64`.
    pub fn polhode(&self) -> Result<Polhode, Error> {
        refuse_driven(self.scene, POLHODE)?;
        Polhode::of(&self.body)
    }
}

const FLIPS: &str = "the list of flips";
const POLHODE: &str = "the polhode";
const WHY: &str = "a torque acts: what it follows from is not conserved";

fn refuse_driven(scene: &Scene, what: &'static str) -> Result<(), Error> {
    if scene.torques.is_empty() { Ok(()) } else { Err(Refusal::Undefined { what, why: WHY }.into()) }
}

fn refuse_of_driven(wants: Wants) -> Result<(), Error> {
    match (wants.flips, wants.polhode) {
        (true, _) => Err(Refusal::Undefined { what: FLIPS, why: WHY }.into()),
        (_, true) => Err(Refusal::Undefined { what: POLHODE, why: WHY }.into()),
        _ => Ok(()),
    }
}

/// Half of `w . I w`.
pub(super) fn energy(moments: PrincipalMoments, omega: &Vector3<f64>) -> Result<f64, Error> {
    let energy = crate::dynamics::observe::energy(omega, &moments.vector().component_mul(omega));
    finite("the energy", energy).map_err(|_| Refusal::OutOfRange { what: "the energy", value: energy }.into())
}
