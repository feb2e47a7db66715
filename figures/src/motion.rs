//! Free motions, as the library's right engine steps them.

use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};
use tumbling::dynamics::stability::{Stability, of_spin};
use tumbling::step::Engine;
use tumbling::{Axis, Body, Error, Inertia};

/// A body with this spin (rad/s), with its axes along the world's.
pub(crate) fn spun(inertia: Inertia, omega: Vector3<f64>) -> Result<Body, Error> {
    Body::spinning(inertia, UnitQuaternion::identity(), &omega)
}

/// The growth rate (1/s) of a deviation from a spin `omega` (rad/s) about the middle axis.
pub(crate) fn growth(moments: &Vector3<f64>, omega: f64) -> Result<f64, Box<dyn std::error::Error>> {
    match of_spin((*moments).try_into()?, Axis::Middle, omega)? {
        Stability::Growth { rate } => Ok(rate),
        _ => Err("a middle axis that does not flip".into()),
    }
}

/// From a sequence of attitudes, the first one and those after each of `turns` whole turns about the axis
/// `about`. The turns are counted by the direction of another axis of the body, `watched`.
pub(crate) fn after_each_turn<E: From<&'static str>>(
    attitudes: impl IntoIterator<Item = Result<Matrix3<f64>, E>>,
    about: usize,
    watched: usize,
    turns: usize,
) -> Result<Vec<Matrix3<f64>>, E> {
    let (mut found, mut turned, mut last) = (Vec::new(), 0.0, None);
    for rotation in attitudes {
        let rotation = rotation?;
        let arrow = rotation.column(watched);
        let angle = arrow[(about + 2) % 3].atan2(arrow[(about + 1) % 3]);
        let step: f64 = angle - last.unwrap_or(angle);
        turned += step - TAU * ((step + PI) / TAU).floor();
        last = Some(angle);
        if turned >= TAU * found.len() as f64 {
            found.push(rotation);
        }
        if found.len() > turns {
            return Ok(found);
        }
    }
    Err("too short a flight".into())
}

/// A body thrown with one turn per second about one of its axes and a push (rad) to the side; its momentum is
/// along the world axis of the same number.
pub(crate) fn tossed(inertia: Inertia, about: usize, push: f64) -> Result<Body, Box<dyn std::error::Error>> {
    let mut omega = Vector3::zeros();
    omega[about] = push.cos() * TAU;
    omega[(about + 1) % 3] = push.sin() * TAU;
    let level = UnitQuaternion::rotation_between(&inertia.momentum(&omega), &Vector3::ith(about, 1.0));
    Ok(Body::spinning(inertia, level.ok_or("a momentum against its axis")?, &omega)?)
}

/// Pairs of time and body, `count` steps of `h` seconds.
pub(crate) fn free(body: &Body, h: f64, count: usize) -> Result<Vec<(f64, Body)>, Error> {
    timed(Engine::Turned, body, h, count)
}

/// Pairs of time and body, in steps of an engine, right or wrong.
pub(crate) fn timed(engine: Engine, body: &Body, h: f64, count: usize) -> Result<Vec<(f64, Body)>, Error> {
    let time = |i: usize| h * i as f64;
    Ok(engine.run(body, h, count)?.into_iter().enumerate().map(|(i, body)| (time(i), body)).collect())
}
