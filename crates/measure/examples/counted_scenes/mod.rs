//! The scenes whose costs are counted, for the example that counts and for the test of its record.

use nalgebra::Vector3;
use tumbling::step::Torque;
use tumbling_measure::costs::GENERAL;
use tumbling_scenes::{Error, InitialState, Outputs, Scene, Times};

/// The number of states of each scene.
pub const STATES: u32 = 960;

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
