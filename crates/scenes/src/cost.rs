//! What an answer costs: processor instructions, as counted.

use crate::plan::Plan;
use crate::strategy::{Driven, Strategy};

/// Processor instructions that an answer is expected to take.
///
/// Counted by valgrind (`cargo run --release -- measure scenes`; the record is `crates/measure/record/scenes.csv`) on one machine, an x86-64,
/// and rounded; on another they differ, their ratios less. The steps of a driven body are those of its trial run, or more where states
/// are requested more often.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Once, to make the plan.
    pub once: f64,
    /// For each state.
    pub state: f64,
}

/// A step of Dormand and Prince's pair under a torque, rejected ones included.
pub(crate) const PAIR: f64 = 7000.0;
/// It restarts at each state, with at least this number of steps.
pub(crate) const RESTART: f64 = 2.0;
/// A step of Moser and Veselov's method between two half kicks.
pub(crate) const KICKED: f64 = 1500.0;
/// A step that linearises the damping.
pub(crate) const LINEARISED: f64 = 860.0;
/// A step by the exact drift between two half kicks.
pub(crate) const DRIFT: f64 = 11_000.0;

/// The fifth root of a number above zero, for estimates: of rounded operations alone, so that every machine plans alike.
pub(crate) fn fifth_root(x: f64) -> f64 {
    // y^4 = x/y: each round leaves a quarter of the logarithm's error.
    (0..16).fold(x.sqrt().sqrt(), |root, _| (x / root).sqrt().sqrt())
}

/// A plan with elliptic functions: two thirds of it for the sensitivities that bound their accuracy, where that is in question.
const ELLIPTIC: f64 = 46_000.0;

impl Plan<'_> {
    /// The expected cost.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn cost(&self) -> Cost {
        let outputs = self.scene.outputs();
        let driven = |driven: &Driven| {
            let (each, least) = (driven.control.price_of_step(), driven.control.least_steps());
            let steps = driven.steps as f64;
            let states = self.scene.times().count() as f64;
            Cost { once: driven.trials, state: each * (steps / states).max(least) }
        };
        match &self.strategy {
            Strategy::Nothing if outputs.flips => Cost { once: ELLIPTIC, state: 150.0 },
            Strategy::Nothing | Strategy::Constant { .. } => Cost { once: 1900.0, state: 120.0 },
            Strategy::Rotation(_) => Cost { once: 2500.0, state: 490.0 },
            Strategy::SymmetricTop(_) if outputs.attitude => Cost { once: 3100.0, state: 1000.0 },
            Strategy::SymmetricTop(_) => Cost { once: 3100.0, state: 430.0 },
            Strategy::EllipticSpin(_) => Cost { once: ELLIPTIC, state: 720.0 },
            Strategy::Elliptic(_) => Cost { once: ELLIPTIC, state: 1250.0 },
            Strategy::FixedStep(one)
            | Strategy::Stiff(one)
            | Strategy::ExactDrift(one)
            | Strategy::Adaptive(one) => driven(one),
        }
    }
}
