//! Every stepping method against the exact motion, and against its own description.

use super::{adaptive, changes, free, free_motion, start};
use nalgebra::{Quaternion, Vector3};
use tumbling::step::{Method, State, System};

#[test]
fn what_a_method_is_said_to_keep_it_keeps_to_rounding_and_the_rest_it_loses() {
    // Steps of a fifth of a radian and more, ten thousand of them, of a body that flips.
    let moments = Vector3::new(1.3, 2.0, 2.6);
    let system = free(moments);
    let from = start(&system, &Vector3::new(0.3, 2.0, -0.4));
    let (h, count) = (0.1, 10_000);
    for &method in Method::ALL {
        let keeps = method.info();
        let mut worst = [0.0_f64; 4];
        let mut motion = from;
        for _ in 0..count {
            motion = method.step(&system, &motion, h).unwrap();
            for (worst, found) in worst.iter_mut().zip(changes(&system, &from, &motion)) {
                *worst = worst.max(found);
            }
            if worst.iter().any(|x| *x > 1e3) {
                break;
            }
        }
        let said = [keeps.energy, keeps.momentum, keeps.direction, keeps.unit];
        let names = ["energy", "|L|", "L in the world", "|q|"];
        for ((name, said), worst) in names.iter().zip(said).zip(worst) {
            // A random walk of 1e4 roundings, or a line of them at worst.
            assert_eq!(worst < 3e-12, said, "{method:?}: {name} off by {worst:e}, said to be kept: {said}");
        }
        let there = run(method, &system, &from, h, 20);
        let back = run(method, &system, &there, -h, 20);
        let off =
            (back.momentum - from.momentum).norm() + (back.attitude.coords - from.attitude.coords).norm();
        assert_eq!(off < 1e-12, keeps.reversible, "{method:?}: the way back off by {off:e}");
    }
}

#[test]
fn a_spin_whose_squares_are_lost_is_refused_where_it_matters() {
    let moments = Vector3::new(1.0, 2.0, 2.6);
    let system = free(moments);
    let slow = start(&system, &(Vector3::new(0.3, 1.0, -0.4) * 1e-162));
    for &method in Method::ALL {
        // A step that turns it by a hundredth of a radian, and one in which it does not move.
        assert!(method.step(&system, &slow, 1e160).is_err(), "{method:?}");
        let end = method.step(&system, &slow, 0.01).unwrap();
        let moved =
            (end.attitude.coords - slow.attitude.coords).norm() + (end.momentum - slow.momentum).norm();
        assert!(moved < 1e-160, "{method:?}: {moved:e}");
    }
    assert!(adaptive(&system, &slow, 1e162, 1e-10, &mut 1_000_000).is_err());
}

#[test]
fn buss_augments_the_mean_spin_by_a_twelfth() {
    // The turn of a step is h w + h^2 w'/2 + h^3 (w'' / 6 + w' x w / 12) + ...: of the third power he keeps
    // the last term, so that h^3 w'' / 6 is all that is missing.
    let moments = Vector3::new(1.0, 2.0, 2.6);
    let omega = Vector3::new(0.9, 1.1, -0.7);
    let system = free(moments);
    let none = Vector3::zeros();
    let rate = |w: &Vector3<f64>| tumbling::dynamics::euler::angular_acceleration(&moments, w, &none);
    let e = 1e-4;
    let second = (rate(&(omega + rate(&omega) * e)) - rate(&(omega - rate(&omega) * e))) / (2.0 * e);
    // In the axes of the start the spin changes by w'' + w' x w, turned along with the body.
    let missing = second + omega.cross(&rate(&omega));
    let h = 1e-2;
    let end = Method::Buss.step(&system, &start(&system, &omega), h).unwrap();
    let truth = free_motion(moments, &omega).at(h).unwrap().attitude;
    let turn = |q: Quaternion<f64>| nalgebra::UnitQuaternion::new_normalize(q).scaled_axis();
    let off = (turn(truth.into_inner()) - turn(end.attitude)) / h.powi(3) * 6.0;
    assert!((off - missing).norm() < 0.03 * missing.norm(), "{off} {missing}");
}

fn run(method: Method, system: &System<f64>, from: &State<f64>, h: f64, count: usize) -> State<f64> {
    (0..count).fold(*from, |motion, _| method.step(system, &motion, h).unwrap())
}
