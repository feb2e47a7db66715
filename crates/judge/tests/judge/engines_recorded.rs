//! Each engine's rule against what the engine itself did, step by step.

use crate::common::record::{H, Record, engine, reset};
use nalgebra::{Quaternion, Vector3};
use tumbling::step::{State, System};
use tumbling_engines::{Limits, PHYSICS_ENGINES, PhysicsEngine, RECORDED};

/// Free motions of 20 s.
const STORIES: [&str; 4] = ["box-middle", "major", "middle", "minor"];
/// Two seconds each: faster than some engines allow, and under a torque.
const SHORT: [&str; 3] = ["fast", "wound", "pushed"];

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
        assert!(resets.iter().map(|(_, to, _)| to.step).eq(reset(name, story)), "{name} {story}");
        for (from, to, _) in resets {
            assert!(engine.step(&record.system, &record.motion(from), H).is_err());
            assert_eq!(to.attitude, Quaternion::identity());
        }
    }
}
