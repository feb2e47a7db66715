//! The text of a file from a scene.

use super::{OUTPUTS, torque};
use crate::initial_state::Start;
use crate::scene::Scene;
use crate::times::Times;
use std::fmt::Write as _;

/// A number that reads back to the bit.
pub(super) fn number(x: f64) -> String {
    format!("{x:?}")
}

pub(super) fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().copied().map(number).collect();
    format!("[{}]", numbers.join(", "))
}

/// The text of a file with the scene: [`read`](super::read) gives it back to the bit. A body whose numbers
/// are not all finite is written as it is, and refused by [`read`](super::read).
#[must_use]
pub fn write(scene: &Scene) -> String {
    let mut text = format!("accuracy = {}\n", number(scene.accuracy()));
    let _ = match scene.times() {
        Times::Given(times) => writeln!(text, "times = {} # s", list(times)),
        Times::Every { step, span } => {
            writeln!(text, "span = {} # s\nevery = {} # s", number(*span), number(*step))
        }
    };
    let outputs = scene.outputs();
    let requested = [
        outputs.spin,
        outputs.attitude,
        outputs.energy,
        outputs.angle_to_momentum,
        outputs.flips,
        outputs.polhode,
    ];
    let words: Vec<String> = OUTPUTS
        .iter()
        .zip(requested)
        .filter(|(_, requested)| *requested)
        .map(|(word, _)| format!("\"{word}\""))
        .collect();
    let _ = writeln!(text, "wants = [{}]", words.join(", "));
    for body in scene.bodies() {
        let _ = writeln!(text, "\n[[body]]\nmoments = {} # kg m²", list(body.moments.as_slice()));
        if body.products.iter().any(|product| product.to_bits() != 0) {
            let _ = writeln!(text, "products = {} # kg m²", list(body.products.as_slice()));
        }
        let q = body.attitude.quaternion();
        let _ = writeln!(text, "attitude = {}", list(&[q.w, q.i, q.j, q.k]));
        let _ = match &body.start {
            Start::Spin(spin) => writeln!(text, "spin = {} # rad/s, body axes", list(spin.as_slice())),
            Start::Momentum(momentum) => {
                writeln!(text, "momentum = {} # kg m²/s, world axes", list(momentum.as_slice()))
            }
        };
    }
    for torque in scene.torques() {
        let _ = write!(text, "\n[[torque]]\n{}", torque::write(torque));
    }
    text
}
