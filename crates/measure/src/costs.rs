//! The cost of a scene for different outputs, in processor instructions. The example `scene_costs` counts
//! them.

use crate::AnyError;
use crate::record::Record;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use tumbling::step::Torque;
use tumbling_scenes::{Error, InitialState, Outputs, Scene, Times};

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

/// The number of states of each scene.
pub const STATES: u32 = 960;

/// The free scene with nothing left out.
pub const GENERAL: &str = "three moments";

/// The scenes and their names, the cheapest first: from nothing that moves to a torque.
///
/// # Errors
/// A scene that the library refuses.
pub fn scenes() -> Result<Vec<(&'static str, Scene)>, Error> {
    let uneven = Vector3::new(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0);
    let (ball, coin) = (Vector3::new(0.4, 0.4, 0.4), Vector3::new(0.5, 0.5, 1.0));
    let (tumbling, along, oblique) =
        (Vector3::new(1.0, 0.01, 0.01), Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.3, 0.2, 1.0));
    let spin = Outputs { spin: true, ..Outputs::NOTHING };
    let both = Outputs { attitude: true, ..spin };
    let kept = Outputs { energy: true, flips: true, ..Outputs::NOTHING };
    let all = [
        ("energy and flips alone", uneven, tumbling, kept, None),
        ("ball; spin alone", ball, oblique, spin, None),
        ("principal spin; spin alone", uneven, along, spin, None),
        ("two equal moments; spin alone", coin, oblique, spin, None),
        ("three moments; spin alone", uneven, tumbling, spin, None),
        ("ball", ball, oblique, both, None),
        ("principal spin", uneven, along, both, None),
        ("two equal moments", coin, oblique, both, None),
        (GENERAL, uneven, tumbling, both, None),
        ("three moments and a weight; to 1e-2", uneven, tumbling, both, Some(1e-2)),
        ("three moments and a weight; to 1e-8", uneven, tumbling, both, Some(1e-8)),
    ];
    let apart = 1.0 / 60.0;
    let scene = |(name, moments, omega, outputs, weighted): (&'static str, _, _, _, Option<f64>)| {
        let weight = weighted.map(|_| Torque::gravity(&Vector3::new(0.05, 0.0, 0.1), 0.5));
        let times = Times::every(apart, f64::from(STATES - 1) * apart);
        let body = InitialState::spinning(moments, omega);
        let torques = weight.into_iter().collect();
        Ok((name, Scene::new([body], torques, times, outputs, weighted.unwrap_or(1e-9))?))
    };
    all.into_iter().map(scene).collect()
}
