//! The cost of an answer and of a step, in counted processor instructions.

use crate::plan::{Plan, Strategy};

/// The expected number of processor instructions for an answer.
///
/// Counted by valgrind (`cargo run --release -p tumbling-measure --example scene_costs`; the record is
/// `crates/measure/record/scenes.csv`) on one machine, an x86-64, and rounded; on other machines the counts
/// differ, and their ratios differ less. The number of steps of a driven body is that of its trial run, or
/// more where states are requested more often.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Once, to make the plan.
    pub once: f64,
    /// For each state.
    pub state: f64,
}

/// A plan with elliptic functions: two thirds of it are the sensitivities that bound the accuracy, which are
/// computed only where the accuracy is in doubt.
const ELLIPTIC: f64 = 28_000.0;

impl Plan<'_> {
    /// The expected cost.
    #[must_use]
    pub fn cost(&self) -> Cost {
        let outputs = self.scene.outputs();
        if let Some(driven) = &self.driven {
            let states = self.scene.times().count();
            let all = run(driven.tolerance, states, driven.steps, driven.stiff);
            return Cost { once: driven.trials, state: all / states as f64 };
        }
        let (once, state) = match self.strategy {
            Strategy::Nothing if outputs.flips => (ELLIPTIC, 85.0),
            Strategy::Nothing | Strategy::Constant => (3000.0, 114.0),
            Strategy::Rotation => (3100.0, 325.0),
            Strategy::SymmetricTop if outputs.attitude => (3800.0, 765.0),
            Strategy::SymmetricTop => (3800.0, 335.0),
            Strategy::EllipticSpin => (ELLIPTIC, 475.0),
            Strategy::Elliptic | Strategy::Adaptive => (ELLIPTIC, 830.0),
        };
        Cost { once, state }
    }
}

/// A step by Taylor series under a torque, rejected ones included, whose order rises with the digits of the
/// tolerance.
fn series(tolerance: f64) -> f64 {
    let binary_digits = 1023.0 - (tolerance.to_bits() >> 52 & 0x7ff) as f64;
    let order = 5.0 + 0.4 * binary_digits;
    2200.0 + 37.0 * order * order
}

/// A number of states in a number of such steps, most of them by collocation where damping is stiff.
pub(crate) fn run(tolerance: f64, states: u64, steps: usize, stiff: bool) -> f64 {
    // Before the first step; for a state between the ends of two; and a collocation in steps by series.
    const BEGIN: f64 = 35_000.0;
    const WITHIN: f64 = 500.0;
    let dearer = if stiff { 3.5 } else { 1.0 };
    BEGIN + dearer * series(tolerance) * steps as f64 + WITHIN * states as f64
}
