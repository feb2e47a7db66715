//! What became of the recorded bodies, and what becomes of them by the engines' rules.

use crate::common::record::{H, Record};
use nalgebra::Vector3;
use tumbling::attitude::rotation_matrix;
use tumbling::step::{Method, State, System};
use tumbling_judge::PHYSICS_ENGINES;

fn world(motion: &State<f64>) -> Vector3<f64> {
    rotation_matrix(&motion.attitude) * motion.momentum
}

fn energy(system: &System<f64>, state: &State<f64>) -> f64 {
    tumbling::dynamics::observe::energy(&system.omega(&state.momentum), &state.momentum)
}

/// What became of a body: energy and `|L|` relative to those at the start, and `2 E I2 / L^2`, which is
/// `I2/I3` for a body that spins about its largest moment, `I2/I1` about its smallest, and 1 where it flips.
fn fate(system: &System<f64>, start: &State<f64>, end: &State<f64>) -> [f64; 3] {
    let mut moments = *system.moments();
    moments.as_mut_slice().sort_by(f64::total_cmp);
    [
        energy(system, end) / energy(system, start),
        end.momentum.norm() / start.momentum.norm(),
        2.0 * energy(system, end) * moments.y / end.momentum.norm_squared(),
    ]
}

fn sign_changes(signs: impl Iterator<Item = f64>) -> usize {
    let signs: Vec<f64> = signs.collect();
    signs.windows(2).filter(|w| w[0].signum() != w[1].signum()).count()
}

/// Fate after 20 s; by how many degrees `L` was turned at most on the way; sign changes of the spin's main
/// component. Found from the whole records (of every step), to these digits.
const FATES: [(&str, &str, [f64; 4], usize); 14] = [
    ("mujoco-4.0.0-euler", "box-middle", [7.661, 2.768, 1.0, 6.506], 8),
    ("mujoco-4.0.0-euler", "middle", [9.211, 3.035, 1.0, 11.883], 7),
    ("mujoco-4.0.0-implicitfast", "box-middle", [0.3725, 0.6109, 0.9983, 4.842], 8),
    ("mujoco-4.0.0-implicitfast", "major", [0.9976, 0.9993, 0.6667, 0.591], 0),
    ("mujoco-4.0.0-implicitfast", "middle", [0.3568, 0.5974, 0.9996, 5.712], 7),
    ("mujoco-4.0.0-implicitfast", "minor", [0.9854, 0.983, 2.0, 2.118], 0),
    ("mujoco-4.0.0-rk4", "box-middle", [1.0, 1.0, 1.0, 0.0], 8),
    ("mujoco-4.0.0-rk4", "major", [1.0, 1.0, 0.6674, 0.001], 0),
    ("mujoco-4.0.0-rk4", "middle", [1.0, 1.0, 1.0, 0.0], 7),
    ("mujoco-4.0.0-rk4", "minor", [1.0, 1.0, 1.9613, 0.0], 0),
    ("rapier3d-f64-0.36.1", "box-middle", [1.0, 1.0, 1.0, 0.762], 7),
    ("rapier3d-f64-0.36.1", "major", [1.421, 1.0, 0.9481, 4.578], 0),
    ("rapier3d-f64-0.36.1", "middle", [1.0, 1.0, 1.0, 2.323], 7),
    ("rapier3d-f64-0.36.1", "minor", [0.8476, 1.0, 1.6623, 0.106], 0),
];

#[test]
fn the_fates_of_the_recorded_bodies_are_the_fates_by_the_rules() {
    for (name, story, expected, changes) in FATES {
        let record = Record::read(name, story);
        let engine = PHYSICS_ENGINES.iter().find(|engine| engine.record == Some(name)).unwrap();
        let (first, last) = (&record.rows[0], record.rows.last().unwrap());
        assert_eq!(last.step, 1200);
        let start = record.motion(first);
        let recorded = fate(&record.system, &start, &record.motion(last));
        let turned = |motion: &State<f64>| world(&start).angle(&world(motion)).to_degrees();
        let most = record.rows.iter().map(|row| turned(&record.motion(row))).fold(0.0, f64::max);
        let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 4e-4;
        assert!((0..3).all(|k| near(recorded[k], expected[k])), "{name} {story} {recorded:?}");
        // Of the rows that are kept the one where L is turned most may be missing.
        assert!(most < expected[3] + 6e-4 && most > 0.85 * expected[3] - 6e-4, "{name} {story} {most}");
        let main = first.omega.iamax();
        assert_eq!(sign_changes(record.rows.iter().map(|row| row.omega[main])), changes, "{name} {story}");

        let (mut motion, mut signs, mut most) = (start, vec![first.omega[main]], 0.0_f64);
        for _ in 0..1200 {
            motion = engine.step(&record.system, &motion, H).unwrap();
            signs.push(motion.momentum[main]);
            most = most.max(turned(&motion));
        }
        let ours = fate(&record.system, &start, &motion);
        assert!((0..3).all(|k| near(ours[k], expected[k])), "{name} {story} {ours:?}");
        // In these stories the digits of the start are lost by the end, and two runs of one rule differ in it
        // by degrees.
        let apart = if story == "middle" { 0.5 } else { 6e-4 };
        assert!((most - expected[3]).abs() < apart, "{name} {story} {most}");
        assert_eq!(sign_changes(signs.into_iter()), changes, "{name} {story}");
    }
}

// Every one of these spins is stable, and the exact motion keeps it for ever.
#[test]
fn the_explicit_rule_loses_a_stable_spin_within_twenty_seconds_and_the_others_do_not() {
    for story in ["major", "minor"] {
        let record = Record::read("mujoco-4.0.0-rk4", story);
        let start = record.motion(&record.rows[0]);
        let grown = |method: Method| {
            let mut motion = start;
            let mut most = 1.0_f64;
            for _ in 0..1200 {
                let Ok(next) = method.step(&record.system, &motion, H) else { return f64::INFINITY };
                motion = next;
                most = most.max(energy(&record.system, &motion) / energy(&record.system, &start));
            }
            most
        };
        assert!(grown(Method::SemiImplicitEuler) > 1e8, "{story}");
        let rules = PHYSICS_ENGINES.iter().map(|engine| engine.method);
        for method in rules.filter(|&method| method != Method::SemiImplicitEuler) {
            assert!(grown(method) < 2.0, "{story} {method:?}");
        }
    }
}

// Both go by one Newton step of implicit Euler. The documentation of MuJoCo 4.0.0 says that by this rule the
// energy of a free body never rises.
#[test]
fn two_engines_are_recorded_to_multiply_the_energy_of_a_fast_body_in_its_first_step() {
    for name in ["mujoco-4.0.0-implicitfast", "bullet-3.2.7-rigid"] {
        let record = Record::read(name, "wound");
        let energies: Vec<f64> =
            record.rows.iter().map(|row| energy(&record.system, &record.motion(row))).collect();
        // 100 rad/s at 60 Hz: 1.7 rad a step.
        assert!((record.rows[0].omega.norm() * H - 1.675).abs() < 0.001);
        assert!((energies[1] / energies[0] - 3.5848).abs() < 1e-4, "{name} {}", energies[1] / energies[0]);
    }
}
