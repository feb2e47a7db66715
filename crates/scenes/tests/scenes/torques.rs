//! Every torque of a scene, held against a Runge-Kutta solver of its own that knows the law in world axes.

use crate::common::{ALL, BOTH, one, states};
use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};
use tumbling::step::Torque;
use tumbling_scenes::{InitialState, Scene, Start, Strategy, Times};

/// A torque in world axes, of the time, the attitude and the tensor in world axes.
type Law = fn(f64, &UnitQuaternion<f64>, &Matrix3<f64>) -> Vector3<f64>;

/// Attitude and spin (body axes) at each of the times, by steps of the classical Runge-Kutta rule on
/// `L' = torque` and `q' = w q / 2`, all in world axes. No step goes over one of the `breaks`.
fn solved(
    body: &InitialState,
    law: Law,
    times: &[f64],
    breaks: &[f64],
) -> Vec<(UnitQuaternion<f64>, Vector3<f64>)> {
    let tensor = body.body().unwrap().inertia().matrix();
    let inverse = tensor.try_inverse().unwrap();
    let turned = |tensor: &Matrix3<f64>, q: &UnitQuaternion<f64>| {
        let rotation = q.to_rotation_matrix();
        rotation * tensor * rotation.transpose()
    };
    let rate = |time: f64, q: &Quaternion<f64>, l: &Vector3<f64>| {
        let unit = UnitQuaternion::new_normalize(*q);
        let omega = turned(&inverse, &unit) * l;
        (Quaternion::from_imag(omega) * q * 0.5, law(time, &unit, &turned(&tensor, &unit)))
    };
    let Start::Spin(omega) = body.start else { panic!() };
    let (mut q, mut l, mut now) = (body.attitude.into_inner(), body.attitude * (tensor * omega), 0.0);
    let mut stops: Vec<f64> = times.iter().chain(breaks).copied().collect();
    stops.sort_by(f64::total_cmp);
    let mut found = Vec::new();
    for stop in stops {
        let steps = ((stop - now) / 1e-3).ceil();
        let h = (stop - now) / steps.max(1.0);
        for step in 0..steps as u32 {
            // Inside of the step, so that a torque that switches at its end is not asked there.
            let inside = |part: f64| now + h * (f64::from(step) + 1e-9 + (1.0 - 2e-9) * part);
            let (a, e) = rate(inside(0.0), &q, &l);
            let (b, f) = rate(inside(0.5), &(q + a * (h / 2.0)), &(l + e * (h / 2.0)));
            let (c, g) = rate(inside(0.5), &(q + b * (h / 2.0)), &(l + f * (h / 2.0)));
            let (d, k) = rate(inside(1.0), &(q + c * h), &(l + g * h));
            q += (a + (b + c) * 2.0 + d) * (h / 6.0);
            l += (e + (f + g) * 2.0 + k) * (h / 6.0);
        }
        now = stop;
        if times.contains(&stop) {
            let unit = UnitQuaternion::new_normalize(q);
            found.push((unit, inverse * (unit.inverse() * l)));
        }
    }
    found
}

/// Measured in axes other than its principal ones, and turned in the world.
fn lopsided() -> InitialState {
    InitialState {
        moments: Vector3::new(1.0, 1.75, 2.25),
        products: Vector3::new(0.125, -0.25, 0.0625),
        attitude: UnitQuaternion::from_euler_angles(0.3, -0.7, 1.9),
        start: Start::Spin(Vector3::new(0.5, 1.5, -0.75)),
    }
}

const TIMES: [f64; 5] = [0.25, 1.0, 1.75, 2.5, 4.0];

fn held(torques: Vec<Torque<f64>>, law: Law, breaks: &[f64]) {
    let right = solved(&lopsided(), law, &TIMES, breaks);
    for accuracy in [1e-3, 1e-6, 1e-9] {
        let scene = one(lopsided(), torques.clone(), Times::Given(TIMES.to_vec()), ALL, accuracy);
        let plan = scene.plan(0).unwrap();
        let mut fastest = 0.0_f64;
        for (state, (attitude, spin)) in states(&plan).iter().zip(&right) {
            fastest = fastest.max(spin.norm());
            let turned = state.attitude.unwrap().angle_to(attitude);
            let spun = (state.spin.unwrap() - spin).norm() / fastest;
            // The solver's own error is some 1e-11.
            let off = turned.max(spun);
            assert!(off < accuracy, "{off:e} of {accuracy:e} at {} s: {}", state.time, plan.explain());
        }
    }
}

const ARM: Vector3<f64> = Vector3::new(0.3, -0.5, 0.8);
const REST: Vector3<f64> = Vector3::new(0.0, 0.6, 0.8);

const ORBIT: Vector3<f64> = Vector3::new(0.5, 0.25, -0.25);

fn toward() -> Vector3<f64> {
    // Square to the orbit's normal.
    ORBIT.cross(&Vector3::x()).normalize()
}

/// `n x I n`, with `n` along the way to the attracting body, which goes round.
fn pull(time: f64, tensor: &Matrix3<f64>) -> Vector3<f64> {
    let n = Rotation3::from_axis_angle(&Unit::new_normalize(ORBIT), ORBIT.norm() * time) * toward();
    n.cross(&(tensor * n))
}

/// One thruster within the first second, one across two of the times, a spring that lets go; and for all of
/// the time a magnet in its field, a body that goes round and one that stands still, and a push to and fro.
#[test]
fn torques_of_every_kind_at_once_move_a_body_by_their_laws_while_they_act() {
    let torques = vec![
        Torque::during(0.5, 0.75, Torque::InBody(ARM * 5.0)),
        Torque::during(1.5, 2.625, Torque::InWorld(REST * -2.0)),
        Torque::during(f64::NEG_INFINITY, 2.0, Torque::spring(&ARM, &REST, 4.0)),
        Torque::Aligning { arm: ARM * 2.0, field: REST * 1.5 },
        Torque::gravity_gradient(&toward(), &ORBIT),
        Torque::GravityGradient { strength: 2.0, direction: REST, orbit: Vector3::zeros() },
        Torque::Periodic { amplitude: ARM * 3.0, rate: 2.5, phase: 0.75 },
    ];
    let law: Law = |time, q, tensor| {
        let arm = q * ARM;
        let mut torque = arm.cross(&REST) * 3.0 + arm * (3.0 * (2.5 * time + 0.75).cos());
        torque += pull(time, tensor) * (3.0 * ORBIT.norm_squared()) + REST.cross(&(tensor * REST)) * 2.0;
        if (0.5..0.75).contains(&time) {
            torque += arm * 5.0;
        }
        if (1.5..2.625).contains(&time) {
            torque -= REST * 2.0;
        }
        if time < 2.0 {
            torque += arm.cross(&REST) * 4.0;
        }
        torque
    };
    held(torques, law, &[0.5, 0.75, 1.5, 2.625, 2.0]);
}

#[test]
fn what_never_acts_is_left_out_and_windows_within_windows_are_one() {
    let push = || Torque::InBody(Vector3::x());
    let scene = |torques: Vec<Torque<f64>>| one(lopsided(), torques, Times::every(1.0, 2.0), BOTH, 1e-9);
    let kept = |torque: Torque<f64>| scene(vec![torque]).torques().to_vec();
    assert_eq!(kept(Torque::during(1.0, 1.0, push())), []);
    assert_eq!(kept(Torque::during(0.0, 1.0, Torque::during(2.0, 3.0, push()))), []);
    assert_eq!(kept(Torque::during(0.0, 1.0, Torque::InBody(Vector3::zeros()))), []);
    let still = Torque::GravityGradient { strength: 0.0, direction: REST, orbit: ORBIT };
    assert_eq!(kept(still), []);
    for nothing in
        [Torque::gravity(&Vector3::z(), 0.0), Torque::Damping(Vector3::zeros()), Torque::Dissipation(0.0)]
    {
        assert_eq!(kept(nothing), []);
    }
    assert_eq!(kept(Torque::during(f64::NEG_INFINITY, f64::INFINITY, push())), [push()]);
    let nested = Torque::during(0.0, 2.0, Torque::during(1.0, 3.0, push()));
    assert_eq!(kept(nested), [Torque::during(1.0, 2.0, push())]);
    // A body that no torque moves is answered in closed form.
    let scene = scene(vec![Torque::during(1.0, 1.0, push())]);
    assert_eq!(scene.plan(0).unwrap().strategy(), Strategy::Elliptic);
}

#[test]
fn a_function_is_refused_in_a_window_too_and_what_is_not_valid_by_its_number() {
    let new = |torque| Scene::new([lopsided()], vec![torque], Times::every(1.0, 2.0), BOTH, 1e-9);
    let law = Torque::function(|_, _, _| Vector3::x());
    let scene = new(Torque::during(0.0, 1.0, law)).unwrap();
    let message = scene.plan(0).unwrap_err().to_string();
    assert!(message.starts_with("body 0: the motion under a torque given by a function"), "{message}");
    let uneven = Torque::Damping(Vector3::new(1.0, 2.0, 2.0));
    let message = new(Torque::during(0.0, 1.0, uneven)).unwrap().plan(0).unwrap_err().to_string();
    assert!(message.starts_with("body 0: damping that differs from axis to axis"), "{message}");
    let message = new(Torque::during(2.0, 1.0, Torque::InBody(ARM))).unwrap_err().to_string();
    assert!(message.starts_with("torque 0: the start of a torque"), "{message}");
}
