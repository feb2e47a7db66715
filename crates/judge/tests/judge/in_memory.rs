//! Engines judged in memory: rows from an iterator, in single and in double precision, by the kit's stories.

use crate::common::exact;
use nalgebra::{Quaternion, Vector3, convert};
use num_traits::Float;
use tumbling::PrincipalMoments;
use tumbling::attitude::{product, rotation_matrix};
use tumbling::exact::FreeMotion;
use tumbling::number::Field;
use tumbling::step::{Method, PositionStage, State, System};
use tumbling_judge::{
    Base, Confidence, Description, Error, Kind, LawName, Options, Outcome, Precision, Row, Rule, Story,
    Verdict, assert_passes, judge, judge_described, judge_in_memory,
};

/// A library's method as an engine of some precision would have it, its state rounded after each step.
fn engine<T: Precision>(by: Method, story: &Story, h: f64) -> impl FnMut([T; 4], [T; 3]) -> ([T; 4], [T; 3]) {
    let system = System::free(PrincipalMoments::try_from(Vector3::from(story.moments)).unwrap()).unwrap();
    move |q, w| {
        let [w0, x, y, z] = q.map(Into::<f64>::into);
        let spin = Vector3::from(w.map(Into::<f64>::into));
        let start = State { attitude: Quaternion::new(w0, x, y, z), momentum: system.momentum(&spin) };
        let end = by.step(&system, &start, h).unwrap();
        let (q, spin) = (end.attitude, system.omega(&end.momentum));
        ([q.w, q.i, q.j, q.k].map(convert), [spin.x, spin.y, spin.z].map(convert))
    }
}

#[test]
fn spins_in_either_axes_and_attitudes_alone_are_judged_in_memory_as_in_text() {
    let rows = exact(Vector3::new(0.4, 2.0, 1.5), 0.01, 500);
    let kinds = [(Kind::SpinBody, "wx,wy,wz"), (Kind::SpinWorld, "wxw,wyw,wzw"), (Kind::Attitude, "x,y,z")];
    for (kind, names) in kinds {
        let mut text = format!("# engine: Any\n# inertia: 1 2 3\nt,qw,qx,qy,qz,{names}\n");
        let mut in_memory = Vec::new();
        for (t, q, w) in &rows {
            let v = if kind == Kind::SpinBody { *w } else { rotation_matrix(q) * w };
            let numbers = [*t, q.w, q.i, q.j, q.k, v.x, v.y, v.z];
            text += &format!("{}\n", numbers.map(|x| format!("{x:e}")).join(","));
            in_memory.push(Row { time: *t, attitude: Some([q.w, q.i, q.j, q.k]), spin: v.into() });
        }
        let in_text = judge(text.as_bytes(), &Options::default()).unwrap();
        let description = Description { kind, engine: Some("Any".into()), ..Description::default() };
        let of = |rows: &[Row<f64>]| {
            judge_described([1.0, 2.0, 3.0], description.clone(), rows.to_vec(), &Options::default())
        };
        let verdict = of(&in_memory).unwrap();
        assert_eq!((verdict.laws, verdict.record.engine), (in_text.laws, in_text.record.engine));
        assert_eq!(verdict.record.missing, in_text.record.missing);
        assert_eq!(verdict.diagnosis.unwrap().best, in_text.diagnosis.unwrap().best);
        in_memory[0].attitude = None;
        let refused = of(&in_memory);
        assert!(matches!(refused, Err(Error::Row { row: 1 | 2, .. })), "{refused:?}");
    }
}

/// The exact motion as an engine of some precision would have it.
fn exactly<T: Precision>(story: &Story, h: f64) -> impl FnMut([T; 4], [T; 3]) -> ([T; 4], [T; 3]) {
    let moments = PrincipalMoments::try_from(Vector3::from(story.moments)).unwrap();
    let motion = FreeMotion::new(moments, &story.spin.into()).unwrap();
    let [w, x, y, z] = story.attitude;
    let (start, mut count) = (Quaternion::new(w, x, y, z), 0.0);
    move |_, _| {
        count += 1.0;
        let now = motion.at(count * h).unwrap();
        let q = product(&start, &now.attitude);
        ([q.w, q.i, q.j, q.k].map(convert), [now.omega.x, now.omega.y, now.omega.z].map(convert))
    }
}

/// Methods whose errors of energy and momentum are those of rounding.
const SOUND: [Method; 5] = [
    Method::ImplicitMidpoint,
    Method::RotationSplitting2,
    Method::RotationSplitting4,
    Method::MoserVeselov6,
    Method::Gauss4,
];

#[test]
fn the_exact_motion_and_sound_methods_pass_every_story_in_both_precisions() {
    let h = 1.0 / 60.0;
    let stories = Story::all();
    assert_eq!(stories.len(), 22);
    for (story, method) in stories.iter().zip(SOUND.into_iter().cycle()) {
        assert_passes!(story.run::<f64>(h, exactly(story, h)));
        assert_passes!(story.run::<f32>(h, exactly(story, h)));
        assert_passes!(story.run::<f64>(h, engine(method, story, h)));
        assert_passes!(story.run::<f32>(h, engine(method, story, h)));
    }
    // Close to the separatrix a rounding of single precision is much.
    for push in ["push-1e-1", "push-1e-2", "push-1e-3"] {
        let story = Story::named(push).unwrap();
        for method in [Method::ImplicitMidpoint, Method::RotationSplitting4] {
            for h in [1.0 / 30.0, 1.0 / 60.0, 1.0 / 240.0, 1.0 / 1000.0] {
                assert_passes!(story.run::<f32>(h, engine(method, &story, h)));
            }
        }
    }
}

/// A constant spin is all that a sphere has; whether the attitude turns by it, and the direction of the
/// momentum, can still be wrong.
#[test]
fn a_sphere_that_does_not_turn_by_its_spin_fails() {
    let (story, h) = (Story::named("sphere-5").unwrap(), 1.0 / 60.0);
    let mut twice = engine::<f64>(Method::ImplicitMidpoint, &story, 2.0 * h);
    let outcome = |verdict: Result<Verdict, Error>| verdict.unwrap().outcome;
    assert_eq!(outcome(story.run(h, |q, w| (twice(q, w).0, w))), Outcome::Failed);
    assert_eq!(outcome(story.run::<f64>(h, |q, w| (q, w))), Outcome::Failed);
    // Damping is no part of the motion.
    let mut right = engine::<f64>(Method::ImplicitMidpoint, &story, h);
    let lessened = |w: [f64; 3]| w.map(|x| 0.999 * x);
    assert_eq!(outcome(story.run(h, |q, w| (right(q, w).0, lessened(w)))), Outcome::Failed);
}

/// The straight step of an attitude turns by `2 atan(w h / 2)` instead of `w h`: the share that is missing is
/// the pace that a rule of second order gets wrong.
#[test]
fn a_story_allows_the_pace_of_a_straight_turn_and_not_much_more() {
    for story in Story::all() {
        for h in [1.0 / 60.0, 1.0 / 120.0] {
            let turn = story.fastest * h;
            let missing = 1.0 - 2.0 * (turn / 2.0).atan() / turn;
            let default = Options::default();
            let Some(allowed) = story.options(h).allowed(LawName::Consistency) else { panic!("no limit") };
            let expected = missing.max(default.threshold);
            assert!((0.99..1.2).contains(&(allowed / expected)), "{} {h}: {allowed} {missing}", story.name);
        }
    }
}

#[test]
fn an_engine_that_is_wrong_fails_and_its_rule_is_named_from_memory() {
    let story = Story::named("box-5").unwrap();
    let h = 1.0 / 60.0;
    let of = |verdict: Verdict| (verdict.outcome, verdict.diagnosis.unwrap());
    let (outcome, diagnosis) = of(story.run::<f32>(h, engine(Method::SemiImplicitEuler, &story, h)).unwrap());
    assert_eq!((outcome, diagnosis.confidence), (Outcome::Failed, Confidence::ToRounding), "{diagnosis}");
    assert_eq!(diagnosis.best.rule.method(), Some((Method::SemiImplicitEuler, 1)));
    assert!(diagnosis.single);
    let message = std::panic::catch_unwind(|| {
        let story = Story::named("box-5").unwrap();
        assert_passes!(story.run::<f64>(1.0 / 60.0, |q, w| (q, w)));
    });
    let message = *message.unwrap_err().downcast::<String>().unwrap();
    assert!(message.contains("FAILED:") && message.contains("Diagnosis:"), "{message}");
}

#[test]
fn what_is_no_record_is_refused_with_its_row() {
    let row = |time: f64, x: f64| Row { time, attitude: None, spin: [x, 2.0, 3.0] };
    let judged =
        |rows: &[Row<f64>]| judge_in_memory([1.0, 2.0, 2.5], rows.iter().copied(), &Options::default());
    let empty = judged(&[]).unwrap_err();
    assert!(matches!(empty, Error::NoRows) && !empty.to_string().contains("column"), "{empty}");
    assert!(matches!(judged(&[row(0.0, 1.0)]), Err(Error::OneRow)));
    let error = judged(&[row(0.0, 1.0), row(0.1, 1.0), row(0.1, 1.0)]).unwrap_err().to_string();
    let wanted = "row 3: time does not increase: 0.1 s after 0.1 s. Write each instant once, in the order of time, and times with all their digits";
    assert_eq!(error, wanted);
    let ended = judged(&[row(0.0, 1.0), row(0.1, 1.0), row(0.2, f64::NAN), row(0.3, 1.0)]).unwrap();
    assert_eq!((ended.outcome, ended.record.rows), (Outcome::Failed, 2));
    assert!(ended.to_string().contains("row 3: a value is NaN"), "{ended}");
}

/// The library's position stage as an engine of precision `T` has it, in this number of steps from row to
/// row.
fn staged<T>(story: &Story, h: f64, steps: u32) -> Verdict
where
    T: Precision + Field + Float + From<f32>,
{
    let moments = Vector3::from(story.moments.map(convert));
    let stage = PositionStage::new(&moments).unwrap();
    let wide = |q: &Quaternion<T>| Quaternion::from_vector(q.coords.map(Into::<f64>::into));
    // The engine goes on with its own state, with the spin in world axes; the row is made from it.
    let mut state: Option<(Quaternion<T>, Vector3<T>)> = None;
    let verdict = story.run::<T>(h, |[w, x, y, z], spin| {
        let (mut attitude, mut omega) = state.unwrap_or_else(|| {
            let q = Quaternion::new(w, x, y, z);
            let omega = rotation_matrix(&wide(&q)) * Vector3::from(spin).map(Into::<f64>::into);
            (q, omega.map(convert))
        });
        for _ in 0..steps {
            let end = stage.step(&attitude, &omega, convert(h / f64::from(steps)));
            (attitude, omega) = (end.attitude, end.omega);
        }
        state = Some((attitude, omega));
        let body = rotation_matrix(&wide(&attitude)).tr_mul(&omega.map(Into::<f64>::into));
        let q = attitude.coords;
        ([q.w, q.x, q.y, q.z], [body.x, body.y, body.z].map(convert))
    });
    verdict.unwrap()
}

/// Its pace is right to a high order, and it keeps energy and momentum to rounding: others come close.
#[test]
fn the_position_stage_is_named_or_among_those_that_fit_whatever_its_steps_and_precision() {
    let is_it = |rule: &Rule, steps: u32| rule.base == Base::PositionStage(steps);
    let (mut named, mut among) = (0, 0);
    let mut held = |verdict: &Verdict, story: &str, h: f64, steps: u32| {
        assert_eq!(verdict.outcome, Outcome::Passed, "{story} {h} {steps}");
        let diagnosis = verdict.diagnosis.as_ref().unwrap();
        let others = diagnosis.alike.iter();
        let mut all = others.chain([&diagnosis.best.rule]);
        let silent = matches!(diagnosis.confidence, Confidence::NoneFits | Confidence::Accurate);
        let fits = all.any(|rule| is_it(rule, steps) || *rule == Rule::EXACT);
        assert!(silent || fits, "{story} {h} {steps}: {diagnosis}");
        let alone = diagnosis.alike.is_empty() && is_it(&diagnosis.best.rule, steps);
        (named, among) = (named + u32::from(alone), among + u32::from(fits && !alone));
    };
    for (name, h) in
        [("box-1", 1.0 / 30.0), ("box-5", 1.0 / 120.0), ("box-5", 1.0 / 30.0), ("smallest-1", 1.0 / 30.0)]
    {
        let story = Story::named(name).unwrap();
        for steps in [1, 2, 3, 4, 7, 8, 16] {
            held(&staged::<f64>(&story, h, steps), name, h, steps);
            held(&staged::<f32>(&story, h, steps), name, h, steps);
        }
    }
    println!("{named} named, {among} among those that fit");
    assert!(named >= 4 && named + among >= 50, "{named} {among}");
}
