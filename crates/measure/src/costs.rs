//! The cost of a scene for different outputs, in processor instructions. The example `scene_costs` counts
//! them.

use crate::AnyError;
use crate::record::Record;
use serde::{Deserialize, Serialize};

/// What one scene costs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cost {
    /// The name of the scene.
    pub scene: String,
    /// Instructions for its plan.
    pub plan: f64,
    /// Instructions for a state.
    pub state: f64,
}

/// The committed record.
///
/// # Errors
/// A record that cannot be read.
pub fn recorded() -> Result<Record<Cost>, AnyError> {
    Record::read(include_str!("../record/scenes.csv"))
}

/// What the scene of this name costs.
///
/// # Errors
/// A name that the record does not have.
pub fn of<'a>(costs: &'a [Cost], scene: &str) -> Result<&'a Cost, String> {
    costs.iter().find(|cost| cost.scene == scene).ok_or_else(|| format!("{scene} is not in the record"))
}

/// The record of these costs.
#[must_use]
pub fn record(rows: Vec<Cost>) -> Record<Cost> {
    let what = [
        ("what", "what a scene costs by what is requested"),
        ("plan; state", "processor instructions, counted by valgrind: for a plan, for each of its states"),
    ];
    Record { head: crate::setup::head(&what), rows }
}

/// What a result of a batch of free bodies takes, ns, and what the machine would need for parts of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Share {
    /// What is requested.
    pub answer: String,
    /// A result of the batch.
    pub result: f64,
    /// As many products and sums from registers.
    pub arithmetic: f64,
    /// Writing as many bytes.
    pub writing: f64,
}

impl Share {
    /// The time that the slower of the two takes as a share of that of the result: 1 would be all that the
    /// machine can do.
    #[must_use]
    pub fn of_the_machine(&self) -> f64 {
        self.arithmetic.max(self.writing) / self.result
    }
}

/// The committed record of shares: spin alone, then spin and attitude.
///
/// # Errors
/// A record that cannot be read.
pub fn recorded_shares() -> Result<Record<Share>, AnyError> {
    Record::read(include_str!("../record/share.csv"))
}

/// The record of these shares.
#[must_use]
pub fn shares(rows: Vec<Share>) -> Record<Share> {
    let what = [
        ("what", "what a result of a batch of 256 free bodies takes, by what is requested"),
        ("result; arithmetic; writing", "ns: the batch; its products and sums alone; its bytes alone"),
    ];
    Record { head: crate::setup::head(&what), rows }
}

/// The free scene with nothing left out.
pub const GENERAL: &str = "three moments";
