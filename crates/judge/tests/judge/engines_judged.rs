//! Every recorded engine judged: the diagnosis names the rule that the engine goes by.

use crate::common::judged;
use crate::common::record::{engine, reset};
use std::sync::LazyLock;
use tumbling::step::Method;
use tumbling_engines::{RECORDED, Recorded};
use tumbling_judge::{Confidence, LawName, Outcome, Verdict};

/// Every record's name and verdict, judged once for all tests.
static JUDGED: LazyLock<Vec<(String, Verdict)>> = LazyLock::new(|| {
    let read = |run: &Recorded| (format!("{}--{}", run.engine, run.story), judged(run.text));
    RECORDED.iter().map(read).collect()
});

/// A record as it stands in its file.
fn text(name: &str) -> &'static str {
    let (engine, story) = name.split_once("--").unwrap();
    RECORDED.iter().find(|run| (run.engine, run.story) == (engine, story)).unwrap().text
}

/// A record of Bullet is one of MuJoCo's rule as well: both lead, the engine that made it first.
#[test]
fn of_two_engines_with_the_same_steps_both_are_named_first() {
    let text = text("bullet-3.2.7-rigid--box-middle");
    let of_header = |header: &str| {
        let words = judged(&format!("{header}{text}")).to_string();
        words.lines().skip(1).take(3).map(|line| line.trim().to_string()).collect::<Vec<_>>()
    };
    let (bullet, mujoco) = ("Bullet 3.2.7 (pybullet), rigid body", "MuJoCo 4.0.0, implicitfast");
    let order = |line: &str| line.find(bullet).zip(line.find(mujoco)).unwrap();
    let lines = of_header("");
    let ends = |lines: &[String], words: &str| assert!(lines[0].ends_with(words), "{lines:?}");
    ends(&lines, "with: one Newton step; or, with the same steps in this record: linearised implicit.");
    assert!(order(&lines[1]).0 < order(&lines[1]).1, "{lines:?}");
    let lines = of_header("# engine: MuJoCo, built by us\n");
    ends(&lines, "with: linearised implicit; or, with the same steps in this record: one Newton step.");
    assert!(order(&lines[1]).0 > order(&lines[1]).1 && lines[2].contains("three exact turns"), "{lines:?}");
}

#[test]
fn every_record_in_the_folder_is_listed() {
    let mut names: Vec<String> =
        std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../engines/data"))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter_map(|name| name.strip_suffix(".csv").map(str::to_string))
            .collect();
    names.sort();
    let listed = RECORDED.iter().map(|run| format!("{}--{}", run.engine, run.story));
    assert_eq!(names, listed.collect::<Vec<_>>());
}

#[test]
fn the_diagnosis_of_every_recorded_engine_names_its_rule() {
    for (name, verdict) in JUDGED.iter() {
        let (record, story) = name.split_once("--").unwrap();
        let engine = engine(record.trim_end_matches("-1e9"));
        let diagnosis = verdict.diagnosis.as_ref().unwrap();
        let twins = [Method::ImplicitOneNewton, Method::LinearisedImplicit];
        let (method, parts) = diagnosis.best.rule.method().unwrap();
        let same = method == engine.method
            || story != "pushed" && twins.contains(&method) && twins.contains(&engine.method);
        assert!(same && parts == engine.parts, "{name}: {}", diagnosis.best.rule.name());
        let most = diagnosis.best.percentile_95;
        assert_eq!(diagnosis.confidence, Confidence::ToRounding, "{name}: {most:e}");
        assert!(diagnosis.ratio().unwrap() > 1e5, "{name}: {:?}", diagnosis.second);
    }
}

#[test]
fn the_file_of_no_engine_is_misread_and_only_the_four_resets_are_seen() {
    for (name, verdict) in JUDGED.iter() {
        assert_eq!(verdict.file_mistakes, [], "{name}");
        let (record, story) = name.split_once("--").unwrap();
        let found = verdict.resets.iter().map(|reset| (reset.time * 60.0).round() as usize);
        assert!(found.eq(reset(record, story)), "{name}: {:?}", verdict.resets);
        assert!(verdict.resets.iter().all(|reset| reset.to_rest));
    }
}

/// The changes of energy, momentum and `2 E I2 / L^2` from a record's first row to its last, as shares,
/// straight from its text.
fn by_hand(name: &str) -> [f64; 3] {
    let text = text(name);
    let moments: Vec<f64> =
        text.split("moments ").nth(1).unwrap().split(' ').take(3).map(|x| x.parse().unwrap()).collect();
    let of = |line: &str| -> [f64; 2] {
        let spin: Vec<f64> = line.split(',').skip(5).map(|x| x.parse().unwrap()).collect();
        let sum = |power: i32| (0..3).map(|i| moments[i].powi(power) * spin[i] * spin[i]).sum::<f64>();
        [sum(1), sum(2)]
    };
    let ([e0, l0], [e1, l1]) = (of(text.lines().nth(2).unwrap()), of(text.lines().last().unwrap()));
    [e1 / e0 - 1.0, (l1 / l0).sqrt() - 1.0, (e1 / l1) / (e0 / l0) - 1.0]
}

#[test]
fn an_engine_that_turns_a_fast_body_by_less_than_its_spin_is_named() {
    for (name, verdict) in JUDGED.iter() {
        let mut all = verdict.complaints.iter().map(ToString::to_string);
        let named = all.any(|complaint| complaint.contains("does not turn by the spin"));
        // 60 rad/s at 60 Hz are one radian a step. Bullet turns by 2 atan(4 tan(pi/8) / pi), 3 in 100 less.
        let less = name.starts_with("bullet") && name.ends_with("--fast");
        assert!(named || !less, "{name}: {:?}", verdict.complaints);
        let is_fast = name.ends_with("--wound") || name.ends_with("--fast");
        assert!(!named || is_fast || name.contains("-multibody"), "{name}");
    }
}

#[test]
fn the_laws_that_the_engines_break_are_those_that_their_records_show() {
    for (name, verdict) in JUDGED.iter() {
        if name.ends_with("pushed") || !verdict.resets.is_empty() {
            continue;
        }
        let laws = [LawName::Energy, LawName::Momentum, LawName::Separatrix];
        for (law, expected) in laws.into_iter().zip(by_hand(name)) {
            let found = verdict.laws.iter().find(|x| x.name == law).unwrap().last;
            let off = (found - expected).abs() / (1.0 + expected.abs());
            assert!(off < 1e-12, "{name} {law:?}: {found} {expected}");
        }
    }
    for (name, verdict) in JUDGED.iter() {
        if name.contains("-rk4--") && !name.ends_with("wound") && !name.ends_with("pushed") {
            assert_eq!(verdict.outcome, Outcome::Passed, "{name}");
        }
        if name.ends_with("pushed") {
            assert_eq!(verdict.outcome, Outcome::NothingToJudge, "{name}");
        }
    }
}

#[test]
fn a_limit_that_was_raised_is_read_off_the_record() {
    let verdict = judged(text("bullet-3.2.7-multibody-1e9--major"));
    assert!(verdict.to_string().contains("spin is cut at 1.0000e9 rad/s"), "{verdict}");
}
