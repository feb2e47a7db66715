//! Each engine's rule against what the engine itself did, step by step.

use crate::common::record::{H, Record};
use nalgebra::{Quaternion, Vector3};
use tumbling::step::{Method, State, System};
use tumbling_judge::records::RECORDED;
use tumbling_judge::{Limits, PHYSICS_ENGINES, PhysicsEngine};

/// Free motions of 20 s.
const STORIES: [&str; 4] = ["box-middle", "major", "middle", "minor"];
/// Two seconds each: faster than some engines allow, and under a torque.
const SHORT: [&str; 3] = ["fast", "wound", "pushed"];

fn engine(record: &str) -> &'static PhysicsEngine {
    PHYSICS_ENGINES.iter().find(|engine| engine.record == Some(record)).unwrap()
}

/// Bullet's multibody with its limit of 100 rad/s raised, as two of its motions are recorded too.
fn unbridled() -> PhysicsEngine {
    let bullet = engine("bullet-3.2.7-multibody");
    PhysicsEngine { limits: Limits { component: Some(1e9), ..bullet.limits }, ..*bullet }
}

/// Every engine that is recorded, with every record of it.
fn recorded() -> Vec<(PhysicsEngine, &'static str, &'static str)> {
    let mut all = Vec::new();
    for engine in PHYSICS_ENGINES {
        let Some(name) = engine.record.filter(|name| RECORDED.iter().any(|run| run.engine == *name)) else {
            continue;
        };
        let short = SHORT.iter().filter(|_| name != "mujoco-3.17.0-rk4");
        all.extend(STORIES.iter().chain(short).map(|&story| (*engine, name, story)));
    }
    all.extend(["major", "minor"].map(|story| (unbridled(), "bullet-3.2.7-multibody-1e9", story)));
    all
}

/// How far apart two attitudes are as turns, whichever sign their quaternions have.
fn attitudes_apart(a: &Quaternion<f64>, b: &Quaternion<f64>) -> f64 {
    (a - b).norm().min((a + b).norm())
}

/// The errors of one step: of the spin relative to the larger of its values before and after, of the attitude
/// relative to the angle turned where that is over 1, since its own rounding is as large.
fn errors(engine: &PhysicsEngine, system: &System<f64>, ends: [&State<f64>; 2], before: f64) -> [f64; 2] {
    let [ours, theirs] = ends;
    let omega = [ours, theirs].map(|motion| system.omega(&motion.momentum));
    let speed = omega[1].norm();
    let angle = if engine.limits.turn.is_some() { 1.0 } else { (speed * H).max(1.0) };
    [
        (omega[0] - omega[1]).norm() / speed.max(before).max(f64::MIN_POSITIVE),
        attitudes_apart(&ours.attitude, &theirs.attitude) / angle,
    ]
}

/// The greatest error of one step from any recorded row to the next, in rounding units, and how many such
/// steps there are.
fn one_step(engine: &PhysicsEngine, record: &Record) -> (f64, usize) {
    let (mut worst, mut count) = (0.0_f64, 0);
    for (from, to, reset) in record.pairs() {
        if reset {
            continue;
        }
        let start = record.motion(from);
        let end = engine.step(&record.system, &start, H).unwrap();
        let apart = |motion: &State<f64>| {
            let [spin, turn] = errors(engine, &record.system, [&end, motion], from.omega.norm());
            spin.max(turn) / f64::EPSILON
        };
        // A spin that grows a thousandfold in a step takes its rounding along: by as much as a step whose
        // start is four rounding units off, one way or another, the record may be off too.
        let four = 4.0 * f64::EPSILON;
        let jolted = [[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]].map(|signs| {
            let vector = start.momentum.component_mul(&Vector3::from(signs.map(|sign| 1.0 + four * sign)));
            apart(&engine.step(&record.system, &State { momentum: vector, ..start }, H).unwrap())
        });
        let excess = apart(&record.motion(to)) - jolted.into_iter().fold(0.0, f64::max);
        worst = worst.max(excess);
        count += 1;
    }
    (worst, count)
}

#[test]
fn every_recorded_step_of_every_engine_is_its_rules_step_to_rounding() {
    let mut steps = 0;
    for (engine, name, story) in recorded() {
        let (worst, count) = one_step(&engine, &Record::read(name, story));
        // The nearest wrong rule is 1e8 units off.
        assert!(worst < 20.0, "{name} {story}: {worst} rounding units");
        steps += count;
    }
    assert_eq!(steps, 8479);
}

#[test]
fn every_other_rule_misses_the_records_by_far_more_than_rounding() {
    for (right, name, story) in recorded().into_iter().filter(|(_, _, story)| STORIES.contains(story)) {
        let record = Record::read(name, story);
        for other in PHYSICS_ENGINES {
            let twins = [Method::ImplicitOneNewton, Method::LinearisedImplicit];
            let same = other.method == right.method
                || twins.contains(&other.method) && twins.contains(&right.method);
            if !same {
                let other = PhysicsEngine { limits: right.limits, ..*other };
                let missed = record.pairs().take(100).map(|(from, to, _)| {
                    let end = other.step(&record.system, &record.motion(from), H).unwrap();
                    let found = errors(&right, &record.system, [&end, &record.motion(to)], from.omega.norm());
                    found[0].max(found[1])
                });
                let most = missed.fold(0.0, f64::max);
                assert!(most > 1e-8, "{name} {story} is within {most:e} of {:?} too", other.method);
            }
        }
    }
}

#[test]
fn without_their_limits_the_rules_miss_what_bullet_and_rapier_do_to_a_fast_body() {
    for name in ["bullet-3.2.7-multibody", "bullet-3.2.7-rigid", "rapier3d-f64-0.36.1"] {
        let (bare, record) =
            (PhysicsEngine { limits: Limits::NONE, ..*engine(name) }, Record::read(name, "fast"));
        assert!(one_step(&bare, &record).0 > 1e10, "{name}");
    }
    // Rapier slows the body from 60 rad/s to an eighth of a turn a step, and it stays so.
    let record = Record::read("rapier3d-f64-0.36.1", "fast");
    let cap = 15.0 * std::f64::consts::PI;
    assert!(record.rows[1..].iter().all(|row| row.omega.norm() < cap * (1.0 + 1e-14)));
    assert!((record.rows[1].omega.norm() - cap).abs() < 0.02);
}

#[test]
fn mujoco_puts_a_body_back_to_rest_where_its_rule_is_refused_and_nowhere_else() {
    for (engine, name, story) in recorded() {
        let record = Record::read(name, story);
        let resets: Vec<_> = record.pairs().filter(|(_, _, reset)| *reset).collect();
        let expected = match (name, story) {
            ("mujoco-4.0.0-euler", "major") => vec![336],
            ("mujoco-4.0.0-euler", "minor") => vec![795],
            ("mujoco-4.0.0-euler", "fast") => vec![20],
            ("mujoco-4.0.0-euler", "wound") => vec![12],
            _ => Vec::new(),
        };
        assert_eq!(resets.iter().map(|(_, to, _)| to.step).collect::<Vec<_>>(), expected, "{name} {story}");
        for (from, to, _) in resets {
            assert!(engine.step(&record.system, &record.motion(from), H).is_err());
            assert_eq!(to.attitude, Quaternion::identity());
        }
    }
}

/// Our run and the record, from its first row on: the error at each recorded step, and how far a
/// run is by then that is jolted by some rounding units at every step.
fn followed(engine: &PhysicsEngine, record: &Record) -> Vec<(usize, f64, f64)> {
    let first = record.motion(&record.rows[0]);
    let (mut ours, mut jolted) = (first, [first, first, first]);
    let mut seed = 1_u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if seed >> 63 == 1 { 1.0 + 8.0 * f64::EPSILON } else { 1.0 - 8.0 * f64::EPSILON }
    };
    let apart = |a: &State<f64>, b: &State<f64>| {
        let spin = (a.momentum - b.momentum).norm() / a.momentum.norm().max(f64::MIN_POSITIVE);
        spin.max(attitudes_apart(&a.attitude, &b.attitude))
    };
    let mut result = Vec::new();
    let mut step = 0;
    let mut grown = 0.0_f64;
    for row in &record.rows {
        while step < row.step {
            let Ok(next) = engine.step(&record.system, &ours, H) else { return result };
            ours = next;
            for motion in &mut jolted {
                motion.momentum.apply(|x| *x *= noise());
                motion.attitude.coords.apply(|x| *x *= noise());
                let Ok(next) = engine.step(&record.system, motion, H) else { return result };
                *motion = next;
                grown = grown.max(apart(&ours, motion));
            }
            step += 1;
        }
        result.push((step, apart(&ours, &record.motion(row)), grown));
    }
    result
}

#[test]
fn whole_runs_follow_the_records_as_far_as_rounding_lets_any_run_follow() {
    // The last recorded step through which every error is below 1e-9, rounded down: 20 s are 1200 steps.
    let far = |name: &str, story: &str| match (name, story) {
        ("mujoco-4.0.0-euler", "box-middle") => 700,
        ("mujoco-4.0.0-euler", "major") => 320,
        ("mujoco-4.0.0-euler", "minor") => 720,
        ("mujoco-4.0.0-euler", "fast") => 16,
        ("mujoco-4.0.0-euler", "wound") => 10,
        ("bullet-3.2.7-multibody", "box-middle") => 600,
        ("bullet-3.2.7-multibody" | "bullet-3.2.7-multibody-1e9", "major") => 330,
        ("bullet-3.2.7-multibody" | "bullet-3.2.7-multibody-1e9", "minor") => 720,
        ("bullet-3.2.7-multibody", "fast" | "wound") => 60,
        ("rapier3d-f64-0.36.1", "box-middle") => 700,
        // Started one part in a thousand from the middle axis, with every flip a loss of digits.
        (_, "middle") => 230,
        (_, "fast" | "wound" | "pushed") => 119,
        _ => 1199,
    };
    for (engine, name, story) in recorded() {
        let record = Record::read(name, story);
        let run = followed(&engine, &record);
        for &(step, error, grown) in &run {
            assert!(
                error < 10.0 * grown + 16.0 * f64::EPSILON,
                "{name} {story} {step}: {error:e}, where {grown:e} is due to the start"
            );
        }
        let lost = run.iter().find(|(_, error, _)| *error > 1e-9).map_or(usize::MAX, |x| x.0);
        assert!(lost > far(name, story), "{name} {story}: only to {lost}");
    }
}
