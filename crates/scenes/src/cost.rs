//! What an answer costs: processor instructions, as counted.

use crate::plan::Plan;
use crate::strategy::{Driven, Strategy};

/// Processor instructions that an answer is expected to take.
///
/// Counted by valgrind (`cargo run --release -- measure scenes`; the record is
/// `crates/measure/record/scenes.csv`) on one machine, an x86-64, and rounded; on another they differ, their
/// ratios less. The steps of a driven body are those of its trial run, or more where states are requested
/// more often.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Once, to make the plan.
    pub once: f64,
    /// For each state.
    pub state: f64,
}

/// A plan with elliptic functions: two thirds of it for the sensitivities that bound their accuracy, where
/// that is in question.
const ELLIPTIC: f64 = 28_500.0;

impl Plan<'_> {
    /// The expected cost.
    #[must_use]
    pub fn cost(&self) -> Cost {
        let outputs = self.scene.outputs();
        let driven = |driven: &Driven| {
            let states = self.scene.times().count();
            let all = driven.control.price(states, driven.steps, driven.stiff);
            Cost { once: driven.trials, state: all / states as f64 }
        };
        match &self.strategy {
            Strategy::Nothing if outputs.flips => Cost { once: ELLIPTIC, state: 132.0 },
            Strategy::Nothing | Strategy::Constant { .. } => Cost { once: 1900.0, state: 85.0 },
            Strategy::Rotation { .. } => Cost { once: 2200.0, state: 405.0 },
            Strategy::SymmetricTop(_) if outputs.attitude => Cost { once: 2900.0, state: 930.0 },
            Strategy::SymmetricTop(_) => Cost { once: 2900.0, state: 400.0 },
            Strategy::EllipticSpin(_) => Cost { once: ELLIPTIC, state: 635.0 },
            Strategy::Elliptic(_) => Cost { once: ELLIPTIC, state: 1220.0 },
            Strategy::ExactDrift(one) | Strategy::Adaptive(one) => driven(one),
        }
    }
}
