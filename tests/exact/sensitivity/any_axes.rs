//! Sensitivities of bodies in any axes: with products of inertia, turned, at any attitude.

use super::condition;
use crate::common::*;
use nalgebra::{Matrix3, Matrix6, UnitQuaternion, Vector3, Vector6};
use proptest::prelude::*;
use tumbling::exact::FreeMotion;
use tumbling::{Body, Inertia};

/// A tensor, spin and attitude at the start.
fn motion_of(tensor: &Matrix3<f64>, omega: &Vector3<f64>, attitude: &UnitQuaternion<f64>) -> FreeMotion {
    let body = Body::spinning(Inertia::try_from(*tensor).unwrap(), *attitude, omega).unwrap();
    FreeMotion::of(&body).unwrap()
}

/// The entries of a tensor in the order of the derivatives.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

fn entry(k: usize) -> Matrix3<f64> {
    let (i, j) = ENTRIES[k];
    Matrix3::from_fn(|a, b| f64::from((a, b) == (i, j) || (a, b) == (j, i)))
}

/// How the six entries of a tensor change when the body's axes are turned.
fn turned_entries(turn: &Matrix3<f64>) -> Matrix6<f64> {
    Matrix6::from_fn(|row, column| {
        let (i, j) = ENTRIES[row];
        (turn * entry(column) * turn.transpose())[(i, j)]
    })
}

fn twice(block: &Matrix3<f64>) -> Matrix6<f64> {
    let mut both = Matrix6::zeros();
    both.fixed_view_mut::<3, 3>(0, 0).copy_from(block);
    both.fixed_view_mut::<3, 3>(3, 3).copy_from(block);
    both
}

/// All that a motion answers at one time, in body axes; flips relative to the time.
struct Answers {
    omega: Vector3<f64>,
    attitude: UnitQuaternion<f64>,
    flips: Vec<f64>,
    transition: Matrix6<f64>,
    by_tensor: Matrix6<f64>,
}

fn answers(motion: &FreeMotion, t: f64) -> Answers {
    let at = motion.at(t).unwrap();
    assert!((motion.omega(t).unwrap() - at.omega).norm() < 1e-14);
    Answers {
        omega: at.omega,
        attitude: at.attitude,
        flips: motion.flips(t.min(0.0), t.max(0.0)).unwrap().collect(),
        transition: motion.state_transition(t).unwrap(),
        by_tensor: motion.sensitivities(t).unwrap().1,
    }
}

/// That one motion answers as the other does, seen from axes of the body that are turned to it, to what
/// `part` of the moments makes of the answers.
fn answer_alike(
    one: &Answers,
    other: &Answers,
    turn: &UnitQuaternion<f64>,
    largest: f64,
    part: f64,
) -> Result<(), String> {
    let turning = turn.to_rotation_matrix().into_inner();
    let (grown, kicked) = (1.0 + one.transition.norm(), 1.0 + one.by_tensor.norm() * largest);
    let answer = part * kicked;
    let mut off = vec![
        ("spin", (other.omega - turn * one.omega).norm(), answer),
        ("attitude", (other.attitude * turn).angle_to(&one.attitude), answer),
    ];
    let expected = twice(&turning) * one.transition * twice(&turning.transpose());
    off.push(("transition", (other.transition - expected).norm(), answer * grown));
    let expected = twice(&turning) * one.by_tensor * turned_entries(&turning.transpose());
    off.push(("by tensor", (other.by_tensor - expected).norm() * largest, answer * kicked * grown));
    // A flip at the very end may be on either side of it.
    if one.flips.len() == other.flips.len() {
        off.extend(one.flips.iter().zip(&other.flips).map(|(a, b)| ("flip", (a - b).abs(), answer * 1e2)));
    }
    match off.into_iter().find(|(_, off, bound)| off.is_nan() || off > bound) {
        Some((what, off, bound)) => Err(format!("{what}: {off:e}, allowed {bound:e}")),
        None => Ok(()),
    }
}

#[test]
fn a_small_product_of_inertia_changes_no_answer_by_much() {
    let omega = Vector3::new(0.3, -0.7, 0.4);
    let start = UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9);
    for moments in
        [[0.05, 0.03, 0.07], [0.07, 0.05, 0.03], [0.03, 0.07, 0.05], [0.05, 0.05, 0.07], [0.05, 0.05, 0.05]]
    {
        let with = |k: usize, product: f64| {
            let tensor = Matrix3::from_diagonal(&moments.into()) + entry(k) * product;
            answers(&motion_of(&tensor, &omega, &start), 9.0)
        };
        let none = with(3, 0.0);
        for (k, product) in [(3, 1e-18_f64), (4, 1e-16), (5, -1e-14), (3, 1e-12), (4, -1e-12), (5, 1e-10)] {
            let part = product.abs() / 0.03 + 64.0 * f64::EPSILON;
            let same = answer_alike(&none, &with(k, product), &UnitQuaternion::identity(), 0.07, part);
            assert_eq!(same, Ok(()), "{moments:?} {product:e}");
        }
    }
}

/// Any axes of a body, and those in another order.
fn axes() -> impl Strategy<Value = UnitQuaternion<f64>> {
    let third = |sign: f64| {
        UnitQuaternion::from_scaled_axis(Vector3::repeat(sign * std::f64::consts::TAU / 27_f64.sqrt()))
    };
    prop_oneof![attitude(), Just(third(1.0)), Just(third(-1.0))]
}

proptest! {
    // Seen from other axes of the body the motion is the same: with the tensor and the spin turned.
    #[test]
    fn every_answer_turns_with_the_axes_of_the_body(
        m in moments(), omega in generic_spin(), turn in axes(), t in -8.0..8.0_f64, kind in 0..5_usize,
    ) {
        let m = match kind {
            0 => Vector3::new(m.x, m.x, m.z.min(1.9 * m.x)), // a top
            1 => Vector3::repeat(m.x),
            2 => Vector3::new(m.x, m.y, m.x + m.y), // a plate
            _ => m,
        };
        let (tensor, other) = (Matrix3::from_diagonal(&m), turned(&m, turn));
        let start = UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9);
        let one = answers(&motion_of(&tensor, &omega, &start), t);
        let other = answers(&motion_of(&other, &(turn * omega), &(start * turn.inverse())), t);
        // The tensor and the spin are rounded in the turned axes.
        let part = 64.0 * f64::EPSILON * condition(&omega, t);
        let same = answer_alike(&one, &other, &turn, m.max(), part);
        prop_assert!(same.is_ok(), "{same:?}");
    }

    // Independent: differences of the motion of whole tensors with products of inertia, extrapolated once.
    #[test]
    fn the_derivatives_by_the_tensor_are_differences_of_the_motion(
        m in moments(), omega in generic_spin(), turn in attitude(), t in -4.0..4.0_f64, k in 0..6_usize,
    ) {
        let tensor = turned(&m, turn);
        let start = UnitQuaternion::identity();
        let motion = motion_of(&tensor, &omega, &start);
        let size = m.min();
        let between = |h: f64| {
            let [before, after] = [-h, h].map(|h| motion_of(&(tensor + entry(k) * h), &omega, &start).at(t).unwrap());
            let turned = (before.attitude.inverse() * after.attitude).scaled_axis();
            let spun = after.omega - before.omega;
            Vector6::new(turned.x, turned.y, turned.z, spun.x, spun.y, spun.z) / (2.0 * h)
        };
        let (h, found) = (1e-4 * size, motion.sensitivities(t).unwrap().1);
        let expected = (between(0.5 * h) * 4.0 - between(h)) / 3.0;
        let scale = 1.0 + found.norm() * size;
        prop_assert!((found.column(k) - expected).norm() * size <= 1e-7 * scale * scale * scale, "{found} {expected}");
    }
}
