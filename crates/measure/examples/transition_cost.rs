//! The state transition's cost: how long a step of an adaptive stepper takes with its 6 x 6 matrix, in times
//! of the step alone.
//!
//! `cargo run --release -p tumbling-measure --example transition_cost`

use nalgebra::{UnitQuaternion, Vector3};
use std::hint::black_box;
use std::time::Instant;
use tumbling::step::{Stepper, Torque};
use tumbling::{Body, Error, Inertia};

/// The least time of 20 runs of 10 steps of 10 s, s.
fn seconds(stepper: &Stepper, step: impl Fn(&mut Stepper) -> Result<(), Error>) -> Result<f64, Error> {
    let mut least = f64::INFINITY;
    for _ in 0..20 {
        let (mut stepper, start) = (stepper.clone(), Instant::now());
        for _ in 0..10 {
            step(&mut stepper)?;
        }
        least = least.min(start.elapsed().as_secs_f64());
        black_box(&stepper);
    }
    Ok(least)
}

fn main() -> Result<(), Error> {
    let inertia = Inertia::from_moments(1.0, 2.0, 2.5)?;
    let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(0.1, 2.0, 0.3))?;
    let stories = [
        ("free", None),
        ("heavy top", Some(Torque::gravity(&Vector3::new(0.1, 0.2, 0.3), 4.0))),
        ("damped", Some(Torque::Damping(Vector3::new(0.1, 0.2, 0.3)))),
        ("gravity gradient", Some(Torque::gravity_gradient(&Vector3::x(), &Vector3::new(0.0, 0.0, 0.3)))),
    ];
    for (name, torque) in stories {
        for tolerance in [1e-8, 1e-12] {
            let stepper =
                Stepper::<f64>::adaptive(&body, tolerance, 100_000)?.with_torques(torque.clone())?;
            let alone = seconds(&stepper, |stepper| stepper.step(10.0).map(drop))?;
            let both = seconds(&stepper, |stepper| stepper.step_with_transition(10.0).map(drop))?;
            println!("{name:16} tolerance {tolerance:e}: {:.1} times", both / alone);
        }
    }
    Ok(())
}
