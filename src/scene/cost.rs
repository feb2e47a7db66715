//! What an answer costs: processor instructions, as they were counted.

use super::plan::{Driven, Plan, Way};
use crate::step::Method;

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

/// A step of Dormand and Prince's pair under a torque.
pub(super) const PAIR: f64 = 4000.0;
/// A step of Moser and Veselov's method between two half kicks.
pub(super) const KICKED: f64 = 1500.0;
/// A step by the exact flow between two half kicks.
pub(super) const FLOW: f64 = 11_000.0;

impl Plan<'_> {
    /// What it is expected to cost.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn cost(&self) -> Cost {
        let driven = |driven: &Driven, each: f64| {
            let steps = driven.steps as f64;
            let states = self.scene.times.count() as f64;
            // The last run that was tried, and the coarser one before it: half of it.
            Cost { once: 1.5 * steps * each, state: each * (steps / states).max(1.0) }
        };
        match &self.way {
            Way::Nothing => Cost { once: 1000.0, state: 50.0 },
            Way::Constant { .. } => Cost { once: 1000.0, state: 50.0 },
            Way::Rotation(_) => Cost { once: 1500.0, state: 300.0 },
            Way::SymmetricTop(_) if self.scene.wants.attitude => Cost { once: 2000.0, state: 700.0 },
            Way::SymmetricTop(_) => Cost { once: 2000.0, state: 200.0 },
            Way::EllipticSpin(_) => Cost { once: 10_000.0, state: 500.0 },
            Way::Elliptic(_) => Cost { once: 10_000.0, state: 1300.0 },
            Way::Stepper(one) | Way::Stiff(one) if one.method() != Method::LinearisedImplicit => {
                driven(one, KICKED)
            }
            Way::Stepper(one) | Way::Stiff(one) => driven(one, KICKED),
            Way::Flow(one) => driven(one, FLOW),
            Way::Controlled(one) => driven(one, PAIR),
        }
    }
}
