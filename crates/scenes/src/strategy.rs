//! The ways to answer for a body.

use crate::step_control::StepControl;
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::{State, System};

/// The ways to answer, the cheapest first. Each holds what it uses.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Strategy {
    /// No output that moves is requested: all of it follows from what is conserved.
    Nothing,
    /// The outputs are constant: the spin of a steady motion, and the attitude of a body at rest.
    Constant {
        /// The spin in body axes, rad/s, where it is requested.
        spin: Option<Vector3<f64>>,
        /// The attitude, body to world, where it is requested.
        attitude: Option<UnitQuaternion<f64>>,
    },
    /// A steady rotation about a fixed axis.
    Rotation {
        /// The rotation.
        motion: Box<FreeMotion>,
        /// The spin in body axes, rad/s, where it is requested.
        spin: Option<Vector3<f64>>,
    },
    /// Two equal moments: sines and cosines.
    SymmetricTop(Box<FreeMotion>),
    /// Three different moments, the spin alone: Jacobi's functions.
    EllipticSpin(Box<FreeMotion>),
    /// The attitude too: theta functions.
    Elliptic(Box<FreeMotion>),
    /// The exact free motion between kicks of the torques.
    ExactDrift(Driven),
    /// Taylor series with their error controlled; collocation where damping is much faster than the motion.
    Adaptive(Driven),
}

impl Strategy {
    /// How a driven body is stepped.
    pub(crate) fn driven(&self) -> Option<&Driven> {
        match self {
            Self::ExactDrift(driven) | Self::Adaptive(driven) => Some(driven),
            _ => None,
        }
    }
}

/// A body under torques, how it is stepped, and what the trial runs showed.
#[derive(Debug, Clone, PartialEq)]
pub struct Driven {
    pub(crate) system: System<f64>,
    pub(crate) start: State<f64>,
    pub(crate) control: StepControl,
    /// Times at which steps end besides those requested, as they did in the trial runs; none where states are
    /// taken from series.
    pub(crate) stops: Vec<f64>,
    /// The largest difference between two trial runs of different steps.
    pub(crate) difference: f64,
    /// The number of steps of the run that was found good.
    pub(crate) steps: usize,
    /// The instructions of all trial runs.
    pub(crate) trials: f64,
    /// Whether losses are much faster than the motion.
    pub(crate) stiff: bool,
}

impl Driven {
    /// The longest step, s; none where a tolerance decides.
    #[must_use]
    pub fn step(&self) -> Option<f64> {
        match self.control {
            StepControl::ExactDrift(step) => Some(step),
            StepControl::Tolerance(_) => None,
        }
    }

    /// The tolerance of a step, where the error is controlled.
    #[must_use]
    pub fn tolerance(&self) -> Option<f64> {
        if let StepControl::Tolerance(tolerance) = self.control { Some(tolerance) } else { None }
    }

    /// The largest difference between two trial runs: the one that is taken and one of other steps.
    #[must_use]
    pub fn observed_difference(&self) -> f64 {
        self.difference
    }

    /// The number of steps of that run.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }
}
