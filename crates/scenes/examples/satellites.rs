//! Ten thousand satellites in an orbit of 90 minutes, each with a tensor, an attitude and a spin of its own,
//! under gravity gradient for a day: how far they point from the earth then.
//!
//! ```sh
//! cargo run --release -p tumbling-scenes --features threads --example satellites
//! ```

use nalgebra::{UnitQuaternion, Vector3};
use std::{error::Error, f64::consts::TAU, ops::ControlFlow};
use tumbling::step::Torque;
use tumbling_scenes::{Answer, InitialState, Outputs, Scene, Start, Times, batch};

const DAY: f64 = 86_400.0;

fn main() -> Result<(), Box<dyn Error>> {
    let orbit = Vector3::new(0.0, 0.0, TAU / 5400.0); // rad/s
    let mut seed = 1_u64;
    let mut number = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 33) as f64 / f64::from(1 << 30) - 1.0 // from -1 to 1
    };
    let mut random = || Vector3::from_fn(|_, _| number());
    let bodies = (0..10_000).map(|_| InitialState {
        attitude: UnitQuaternion::from_scaled_axis(random() * 0.3),
        start: Start::Spin(orbit + random() * 2e-4),
        ..InitialState::spinning(Vector3::new(10.0, 40.0, 45.0) + random(), orbit) // kg m²
    });
    let gradient = Torque::gravity_gradient(&Vector3::x(), &orbit);
    let outputs = Outputs { attitude: true, ..Outputs::NOTHING };
    let scene = Scene::new(bodies, vec![gradient], Times::Given(vec![DAY]), outputs, 1e-6)?;
    let earth = UnitQuaternion::from_scaled_axis(orbit * DAY) * Vector3::x();
    // From the long axis, whose ends are alike, to the earth.
    let off = |at: &Answer| at.attitude.map(|turn| (turn * Vector3::x()).dot(&earth).abs().min(1.0).acos());
    let of_block =
        |block: &batch::Block<'_>| block.states().filter_map(|(_, at)| off(at)).collect::<Vec<_>>();
    let mut angles = Vec::new();
    batch::run(&scene, of_block, |some| {
        angles.extend(some);
        ControlFlow::Continue(())
    });
    angles.sort_by(f64::total_cmp);
    let within = |k: usize| angles.get(k * angles.len() / 10).copied().unwrap_or(f64::NAN).to_degrees();
    println!("half point within {:.1}° of the earth, nine in ten within {:.1}°", within(5), within(9));
    Ok(())
}
