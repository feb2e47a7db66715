//! Free motions, as the library's right engine steps them.

use nalgebra::{UnitQuaternion, Vector3};
use tumbling::dynamics::stability::{Stability, of_spin};
use tumbling::step::Engine;
use tumbling::{Axis, Body, Error, Inertia};

/// A body upright in the world with this spin, rad/s.
pub(crate) fn spun(inertia: Inertia, omega: Vector3<f64>) -> Result<Body, Error> {
    Body::spinning(inertia, UnitQuaternion::identity(), &omega)
}

/// How fast a push grows on a spin `omega` (rad/s) about the middle axis, 1/s.
pub(crate) fn growth(moments: &Vector3<f64>, omega: f64) -> Result<f64, Box<dyn std::error::Error>> {
    match of_spin((*moments).try_into()?, Axis::Middle, omega)? {
        Stability::Growth { rate } => Ok(rate),
        _ => Err("a middle axis that does not flip".into()),
    }
}

/// Pairs of time and body, `count` steps of `h` seconds.
pub(crate) fn free(body: &Body, h: f64, count: usize) -> Result<Vec<(f64, Body)>, Error> {
    timed(Engine::Turned, body, h, count)
}

/// The same as some engine has it.
pub(crate) fn timed(engine: Engine, body: &Body, h: f64, count: usize) -> Result<Vec<(f64, Body)>, Error> {
    let time = |i: usize| h * i as f64;
    Ok(engine.run(body, h, count)?.into_iter().enumerate().map(|(i, body)| (time(i), body)).collect())
}
