//! What an answer costs: processor instructions, as they were counted.

use super::plan::{Driven, Plan, Way};

/// Processor instructions that an answer is expected to take.
///
/// They were counted by valgrind (`cargo run --release -- measure scenes`; the record is `measure/record/scenes.csv`) on one
/// machine, an x86-64, and are rounded here; on another they differ, their ratios less. Of a driven body the steps are those of the run that
/// was tried, or more where states are asked for more often.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Once, to make the plan.
    pub once: f64,
    /// For each state.
    pub state: f64,
}

/// A step of Dormand and Prince's pair under a torque, those tried in vain included.
pub(super) const PAIR: f64 = 7000.0;
/// It starts anew at each state: with so many steps at least.
pub(super) const ANEW: f64 = 2.0;
/// A step of Moser and Veselov's method between two half kicks.
pub(super) const KICKED: f64 = 1500.0;
/// A step that linearises the damping.
pub(super) const LINEARISED: f64 = 860.0;
/// A step by the exact flow between two half kicks.
pub(super) const FLOW: f64 = 11_000.0;

/// A plan with elliptic functions: two thirds of it for looking closely at how exact they can be, where that is in question.
const ELLIPTIC: f64 = 28_000.0;

impl Plan<'_> {
    /// What it is expected to cost.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn cost(&self) -> Cost {
        let wants = self.scene.wants;
        let driven = |driven: &Driven| {
            let (each, least) = (driven.by.price_of_step(), driven.by.least_steps());
            let steps = driven.steps as f64;
            let states = self.scene.times.count() as f64;
            Cost { once: driven.trials, state: each * (steps / states).max(least) }
        };
        match &self.way {
            Way::Nothing if wants.flips => Cost { once: ELLIPTIC, state: 150.0 },
            Way::Nothing | Way::Constant { .. } => Cost { once: 1900.0, state: 120.0 },
            Way::Rotation(_) => Cost { once: 2500.0, state: 400.0 },
            Way::SymmetricTop(_) if wants.attitude => Cost { once: 3100.0, state: 1000.0 },
            Way::SymmetricTop(_) => Cost { once: 3100.0, state: 430.0 },
            Way::EllipticSpin(_) => Cost { once: ELLIPTIC, state: 720.0 },
            Way::Elliptic(_) => Cost { once: ELLIPTIC, state: 1250.0 },
            Way::Stepper(one) | Way::Stiff(one) | Way::Flow(one) | Way::Controlled(one) => driven(one),
        }
    }
}
