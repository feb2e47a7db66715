//! Prints as JSON the bits of what `tests/test_motion.py` asks of the Python package.

use nalgebra::{Matrix3, Matrix6, Quaternion, UnitQuaternion, Vector3};
use tumbling::exact::{FreeMotion, LagrangeTop};
use tumbling::solid::{Mesh, Solid};
use tumbling::step::{Stepper, Torque};
use tumbling::{Body, Error, Inertia, PrincipalMoments};

const TIMES: [f64; 4] = [0.0, 0.7, 13.5, 1e4];

/// Attitudes with the scalar first, then spins.
fn states(at: impl IntoIterator<Item = (UnitQuaternion<f64>, Vector3<f64>)>) -> Vec<f64> {
    let (q, w): (Vec<_>, Vec<_>) =
        at.into_iter().map(|(q, w)| ([q.w, q.i, q.j, q.k], <[f64; 3]>::from(w))).unzip();
    q.into_iter().flatten().chain(w.into_iter().flatten()).collect()
}

fn rows(matrix: Matrix6<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

fn free(body: &Body) -> Result<Vec<f64>, Error> {
    let motion = FreeMotion::of(body)?;
    let at = TIMES.map(|t| motion.at(t).map(|at| (at.attitude, at.omega)));
    let both = [motion.sensitivities(TIMES[1])?, motion.sensitivities(TIMES[2])?];
    let matrices = both.iter().map(|both| both.0).chain(both.iter().map(|both| both.1));
    let at = states(at.into_iter().collect::<Result<Vec<_>, _>>()?);
    Ok([at, matrices.flat_map(rows).collect(), motion.flips(0.0, 50.0)?.collect()].concat())
}

fn stepped(body: &Body) -> Result<Vec<f64>, Error> {
    let gravity = Torque::gravity(&Vector3::new(0.1, 0.2, 0.3), 4.0);
    let mut stepper = Stepper::adaptive(body, 1e-12, 100_000)?.with_torques([gravity])?;
    let mut at = Vec::new();
    for t in &TIMES[..3] {
        let state = stepper.step_to(*t)?;
        at.push((UnitQuaternion::new_unchecked(state.attitude), stepper.omega()));
    }
    Ok([states(at), stepper.flips(40.0)?, rows(stepper.step_with_transition(1.0)?)].concat())
}

fn batch() -> Result<Vec<f64>, Error> {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.6)?;
    let spin = |k: i32| Vector3::new(0.3, 2.0, 0.1).map(|w| f64::from(k) * w / 40.0);
    let motions = (1..=40).map(|k| FreeMotion::new(moments, &spin(k))).collect::<Result<Vec<_>, _>>()?;
    let at = TIMES.iter().flat_map(|&t| motions.iter().map(move |motion| motion.at(t)));
    Ok(states(at.map(|at| at.map(|at| (at.attitude, at.omega))).collect::<Result<Vec<_>, _>>()?))
}

fn top(attitude: UnitQuaternion<f64>) -> Result<Vec<f64>, Error> {
    let inertia = Inertia::from_moments(2e-4, 2e-4, 5e-5)?;
    let body = Body::spinning(inertia, attitude, &Vector3::new(0.1, 0.0, 150.0))?;
    let top = LagrangeTop::of(&body, &Vector3::new(0.0, 0.0, 0.04), 0.981)?;
    let at = TIMES.map(|t| top.at(t).map(|at| (at.attitude, at.omega)));
    Ok([states(at.into_iter().collect::<Result<Vec<_>, _>>()?), top.lean().to_vec()].concat())
}

fn mesh() -> Result<Vec<f64>, Error> {
    let corners = [[0.0; 3], [4.0, 0.0, 0.0], [0.3, 4.0, 0.0], [0.0, 0.1, 6.0]].map(Vector3::from);
    let mesh = Mesh::new(&corners, &[[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]])?;
    Ok(mesh.with_mass(1.7)?.inertia().matrix().as_slice().to_vec())
}

fn main() -> Result<(), Error> {
    let attitude = UnitQuaternion::new_unchecked(Quaternion::new(0.8, 0.2, -0.4, 0.4));
    let tensor = Inertia::try_from(Matrix3::new(3.0, 0.5, 0.0, 0.5, 2.0, 0.1, 0.0, 0.1, 4.0))?;
    let body = Body::spinning(tensor, attitude, &Vector3::new(0.1, 2.0, 0.3))?;
    let all = [
        ("free", free(&body)?),
        ("stepped", stepped(&body)?),
        ("batch", batch()?),
        ("top", top(attitude)?),
        ("mesh", mesh()?),
    ];
    let bits = |numbers: &[f64]| {
        numbers.iter().map(|x| format!("\"{:x}\"", x.to_bits())).collect::<Vec<_>>().join(", ")
    };
    let all = all.map(|(name, numbers)| format!("\"{name}\": [{}]", bits(&numbers)));
    println!("{{\"times\": {TIMES:?}, {}}}", all.join(", "));
    Ok(())
}
