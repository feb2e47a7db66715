//! Flips of adaptive runs: free, where a pendulum turns back, where the spin is zero for a while, and where
//! runs meet.

use super::driven::tilted;
use super::spinning;
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, Stepper, Torque};
use tumbling::{Body, ErrorKind, Inertia};

#[test]
fn flips_of_a_free_body_in_steps_are_those_of_the_closed_form_forth_and_back() {
    let body = tilted();
    let exact = FreeMotion::of(&body).unwrap();
    // The finer run has the highest order.
    for (end, tolerance) in [(40.0, 1e-13), (-40.0, 4.0 * f64::EPSILON)] {
        let mut stepper = Stepper::adaptive(&body, tolerance, 10_000).unwrap();
        let flips = stepper.flips(end).unwrap();
        let mut expected: Vec<f64> = exact.flips(f64::min(end, 0.0), f64::max(end, 0.0)).unwrap().collect();
        if end < 0.0 {
            expected.reverse();
        }
        assert!(expected.len() > 4 && flips.len() == expected.len(), "{flips:?} {expected:?}");
        for (flip, expected) in flips.iter().zip(&expected) {
            assert!((flip - expected).abs() < 1e-10, "{flip} {expected}");
        }
        assert_eq!(stepper.time(), end);
    }
    let mut fixed = Stepper::new(&body, Method::Gauss6).unwrap();
    assert_eq!(fixed.flips(1.0).unwrap_err().kind(), ErrorKind::Undefined);
    assert_eq!(fixed.at(0.0).unwrap_err().kind(), ErrorKind::Undefined);
}

#[test]
fn a_driven_swing_through_the_middle_axis_flips_where_its_pendulum_stands_still() {
    // A compass needle with its field and its moment along x swings about z, the middle axis: the spin
    // changes its sign where the pendulum turns back, every half period from the first quarter on.
    let (moment, pull, angle) = (2.0_f64, 3.0_f64, 1.2_f64);
    let inertia = Inertia::from_moments(1.5, 2.6, moment).unwrap();
    let attitude = UnitQuaternion::identity();
    // Through the bottom with the spin that just reaches the angle.
    let spin = 2.0 * (pull / moment).sqrt() * (0.5 * angle).sin();
    let body = Body::spinning(inertia, attitude, &Vector3::new(0.0, 0.0, spin)).unwrap();
    let (mut a, mut g) = (1.0_f64, (0.5 * angle).cos());
    for _ in 0..6 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    let period = std::f64::consts::TAU * (moment / pull).sqrt() / a;
    let mut stepper = Stepper::adaptive(&body, 1e-14, 1000).unwrap();
    stepper =
        stepper.with_torques([Torque::Aligning { arm: Vector3::x(), field: Vector3::x() * pull }]).unwrap();
    let flips = stepper.flips(2.0 * period).unwrap();
    let expected = [0.25, 0.75, 1.25, 1.75].map(|share| share * period);
    assert_eq!(flips.len(), 4, "{flips:?}");
    for (flip, expected) in flips.iter().zip(expected) {
        assert!((flip - expected).abs() < 1e-12, "{flip} {expected}");
    }
}

/// A body that spins at 1 rad/s about its middle axis, with -1 rad/s² on it in these times.
fn pushed(times: &[[f64; 2]]) -> Stepper {
    let body = spinning([1.0, 2.0, 3.0], &Vector3::y());
    let push = |&[start, end]: &[f64; 2]| Torque::during(start, end, Torque::InBody(Vector3::y() * -2.0));
    Stepper::adaptive(&body, 1e-12, 1000).unwrap().with_torques(times.iter().map(push)).unwrap()
}

#[test]
fn a_spin_that_is_zero_where_two_steps_meet_flips_where_it_leaves_zero() {
    let flips = |times: &[[f64; 2]]| pushed(times).flips(4.0).unwrap();
    assert_eq!(flips(&[[0.0, 1.0], [1.0, 2.0]]), [1.0]);
    assert_eq!(flips(&[[0.0, 1.0], [2.0, 3.0]]), [2.0]);
    // At the middle of a step, and not at all.
    assert_eq!(flips(&[[0.0, 2.0]]), [1.0]);
    assert!(flips(&[[0.0, 1.0]]).is_empty());
}

#[test]
fn a_flip_where_one_call_ends_and_the_next_begins_is_one_flip() {
    // Back the way it came there is none.
    for (end, expected) in [(2.0, &[1.0][..]), (0.5, &[])] {
        let mut stepper = pushed(&[[0.0, 4.0]]);
        assert!(stepper.flips(1.0).unwrap().is_empty());
        assert_eq!(stepper.omega(), Vector3::zeros());
        assert_eq!(stepper.flips(end).unwrap(), expected);
    }
    // A run in pieces that end at the flips, or next to them, has those of the whole.
    let free = || Stepper::adaptive(&tilted(), 1e-12, 10_000).unwrap();
    let whole = free().flips(40.0).unwrap();
    assert!(whole.len() > 4);
    for off in [0.0, 1e-15, -1e-15, 1e-12, -1e-12] {
        let (mut stepper, mut found) = (free(), Vec::new());
        for time in whole.iter().map(|time| time * (1.0 + off)).chain([40.0]) {
            found.extend(stepper.flips(time).unwrap());
        }
        assert_eq!(found.len(), whole.len(), "{off}: {found:?} {whole:?}");
        for (one, other) in found.iter().zip(&whole) {
            assert!((one - other).abs() < 1e-10, "{off}: {one} {other}");
        }
    }
}
