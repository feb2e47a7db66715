//! Ten thousand satellites in an orbit of 90 minutes, each with a tensor, an attitude and a spin of its own,
//! under gravity gradient for a day, on all cores: how many of them can never turn over, and how far their
//! long axes point from the earth then.
//!
//! ```sh
//! cargo run --release --example satellites
//! ```

use nalgebra::{DVector, UnitQuaternion, Vector3};
use std::{f64::consts::TAU, thread};
use tumbling::step::{Stepper, Torque};
use tumbling::{Body, Error, Inertia};

const RATE: f64 = TAU / 5400.0; // rad/s

/// Whether a satellite has too little energy to turn over, and its angle from the earth after a day, degrees.
fn flown(k: usize) -> Result<(bool, f64), Error> {
    // From -1 to 1, evenly, since no two roots of primes have a rational ratio.
    let even = |primes: [f64; 3]| Vector3::from(primes).map(|p| 2.0 * (k as f64 * p.sqrt()).fract() - 1.0);
    let (orbit, m) = (Vector3::z() * RATE, Vector3::new(10.0, 40.0, 45.0) + even([2.0, 3.0, 5.0])); // kg m²
    let (turn, spin) = (even([7.0, 11.0, 13.0]) * 0.5, orbit + even([17.0, 19.0, 23.0]) * 1e-3);
    let turn = UnitQuaternion::from_scaled_axis(turn);
    let body = Body::spinning(Inertia::from_moments(m.x, m.y, m.z)?, turn, &spin)?;
    let gradient = Torque::gravity_gradient(&Vector3::x(), &orbit);
    let mut stepper = Stepper::adaptive(&body, 1e-9, 10_000)?.with_torques([gradient])?;
    stepper.step_to(86_400.0)?; // 16 orbits: the earth is where it was
    // Jacobi's integral, in units of half the square of the orbit's rate: what a circular orbit keeps.
    let jacobi = |body: &Body| {
        let earth = body.attitude().inverse_transform_vector(&Vector3::x());
        let free = body.energy() - RATE * body.momentum_world().z;
        2.0 * free / RATE.powi(2) + 3.0 * earth.dot(&(body.inertia().matrix() * earth))
    };
    let (start, there) = (jacobi(&body), stepper.body()?);
    assert!((jacobi(&there) - start).abs() < 1e-9 * stepper.steps_of_run() as f64 * m.z, "satellite {k}");
    // At rest with its long axis along the orbit, it is on the pass between one end and the other.
    Ok((start < 3.0 * m.y - m.z, (there.attitude() * Vector3::x()).x.abs().min(1.0).acos().to_degrees()))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let given = std::env::args().nth(1).unwrap_or("10000".into());
    let count = given.parse().map_err(|_| format!("`{given}` is no number of satellites"))?;
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let fly = |core: usize| (core..count).step_by(cores).map(flown).collect::<Result<Vec<_>, _>>();
    let flown = thread::scope(|scope| {
        let threads: Vec<_> = (0..cores).map(|core| scope.spawn(move || fly(core))).collect();
        threads.into_iter().map(|thread| thread.join().expect("no panic")).collect::<Result<Vec<_>, _>>()
    })?;
    for (held, can) in [(true, "can never turn over"), (false, "can")] {
        let off = flown.iter().flatten().filter(|one| one.0 == held).map(|one| one.1);
        let off = DVector::from_vec(off.collect());
        println!("{} {can}: {:.1}° ± {:.1}° from the earth", off.len(), off.mean(), off.variance().sqrt());
    }
    Ok(())
}
