//! What the tests of scenes share.

use tumbling::step::Torque;
use tumbling_scenes::{Answer, InitialState, Outputs, Plan, Scene, Times};

pub const ALL: Outputs =
    Outputs { spin: true, attitude: true, energy: true, angle_to_momentum: true, ..Outputs::NOTHING };

pub const SPIN: Outputs = Outputs { spin: true, ..Outputs::NOTHING };

pub const BOTH: Outputs = Outputs { spin: true, attitude: true, ..Outputs::NOTHING };

pub fn one(
    body: InitialState,
    torques: Vec<Torque<f64>>,
    times: Times,
    outputs: Outputs,
    accuracy: f64,
) -> Scene {
    Scene::new([body], torques, times, outputs, accuracy).unwrap()
}

pub fn states(plan: &Plan<'_>) -> Vec<Answer> {
    plan.states().collect::<Result<_, _>>().unwrap()
}

/// The larger of the attitudes' angle and the spins' difference as a share.
pub fn apart(a: &Answer, b: &Answer) -> f64 {
    let (w, v) = (a.spin.unwrap(), b.spin.unwrap());
    let turn = match (a.attitude, b.attitude) {
        (Some(p), Some(q)) => p.angle_to(&q),
        _ => 0.0,
    };
    ((w - v).norm() / w.norm().max(v.norm()).max(f64::MIN_POSITIVE)).max(turn)
}
