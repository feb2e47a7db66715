//! Engines judged in memory: rows from an iterator, in single and in double precision, by the kit's stories.

use crate::common::{MOMENTS, csv, exact, judged};
use nalgebra::{Quaternion, Vector3};
use tumbling::PrincipalMoments;
use tumbling::attitude::product;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, PositionStage, State, System};
use tumbling_judge::{
    Confidence, Error, LawName, Options, Outcome, Precision, Row, Story, Verdict, assert_passes,
    judge_in_memory,
};

/// A library's method as an engine of some precision would have it, its state rounded after each step.
fn engine<T: Precision>(
    method: Method,
    story: &Story,
    h: f64,
) -> impl FnMut([T; 4], [T; 3]) -> ([T; 4], [T; 3]) {
    let system = System::free(PrincipalMoments::try_from(Vector3::from(story.moments)).unwrap()).unwrap();
    move |q, w| {
        let [w0, x, y, z] = q.map(T::get);
        let spin = Vector3::from(w.map(T::get));
        let start = State { attitude: Quaternion::new(w0, x, y, z), momentum: system.momentum(&spin) };
        let end = method.step(&system, &start, h).unwrap();
        let (q, spin) = (end.attitude, system.omega(&end.momentum));
        ([q.w, q.i, q.j, q.k].map(T::of), [spin.x, spin.y, spin.z].map(T::of))
    }
}

#[test]
fn a_record_in_memory_is_judged_as_the_same_in_text() {
    for spin in [[1.0, 2.0, 1.5], [0.1, 3.0, 0.2]] {
        let rows = exact(spin.into(), 0.01, 1000);
        let in_text = judged(&csv(&rows));
        let rows = rows.iter().map(|(t, q, w)| Row {
            time: *t,
            attitude: Some([q.w, q.i, q.j, q.k]),
            spin: (*w).into(),
        });
        let verdict = judge_in_memory(MOMENTS.into(), rows, &Options::default()).unwrap();
        assert_eq!(verdict.laws, in_text.laws);
        assert_eq!(verdict.diagnosis.unwrap().best, in_text.diagnosis.unwrap().best);
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
        ([q.w, q.i, q.j, q.k].map(T::of), [now.omega.x, now.omega.y, now.omega.z].map(T::of))
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
fn a_sphere_that_turns_by_its_spin_passes_and_one_that_does_not_fails() {
    let (story, h) = (Story::named("sphere-5").unwrap(), 1.0 / 60.0);
    for method in SOUND {
        assert_passes!(story.run::<f64>(h, engine(method, &story, h)));
        assert_passes!(story.run::<f32>(h, engine(method, &story, h)));
    }
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
            for answer in story.answers.iter().filter(|answer| answer.sensitivity[0] * missing < 0.5) {
                let [Some(spin), _] = story.within::<f64>(answer, h) else { panic!("{}", story.name) };
                let ratio = spin / (answer.sensitivity[0] * missing);
                assert!((0.99..1.3).contains(&ratio), "{} {h} {}: {ratio}", story.name, answer.time);
            }
        }
    }
}

#[test]
fn the_implicit_midpoint_in_single_precision_does_what_the_kit_allows() {
    let (mut held, mut least) = (0, f64::INFINITY);
    for story in Story::all() {
        let h = 1.0 / 60.0;
        let mut rows = story.rows::<f32>(h, engine(Method::ImplicitMidpoint, &story, h)).enumerate();
        for answer in &story.answers {
            let count = (answer.time / h).round() as usize;
            let (_, row) = rows.find(|(i, _)| *i == count).unwrap();
            let (spin, right) = (Vector3::from(row.spin).cast::<f64>(), Vector3::from(answer.spin));
            let off = (spin - right).norm() / right.norm();
            let Some(allowed) = story.within::<f32>(answer, h)[0] else { continue };
            assert!(off <= allowed, "{} at {}: {off:e}, allowed {allowed:e}", story.name, answer.time);
            held += 1;
            least = least.min(allowed / off);
        }
    }
    // No more is allowed than is needed, to a factor.
    assert!(least < 30.0, "{least}");
    assert!(held > 90, "{held}");
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
    assert!(message.contains("FAILED: ") && message.contains("Diagnosis: "), "{message}");
}

#[test]
fn what_is_no_record_is_refused_with_its_row() {
    let row = |time: f64, x: f64| Row { time, attitude: None, spin: [x, 2.0, 3.0] };
    let judged =
        |rows: &[Row<f64>]| judge_in_memory([1.0, 2.0, 2.5], rows.iter().copied(), &Options::default());
    assert!(matches!(judged(&[]), Err(Error::NoRows)));
    assert!(matches!(judged(&[row(0.0, 1.0)]), Err(Error::OneRow)));
    let error = judged(&[row(0.0, 1.0), row(0.1, 1.0), row(0.1, 1.0)]).unwrap_err().to_string();
    assert_eq!(error, "row 3: time does not increase: 0.1 s after 0.1 s");
    let ended = judged(&[row(0.0, 1.0), row(0.1, 1.0), row(0.2, f64::NAN), row(0.3, 1.0)]).unwrap();
    assert_eq!((ended.outcome, ended.record.rows), (Outcome::Failed, 2));
    assert!(ended.to_string().contains("row 3: a value is NaN"), "{ended}");
}

#[test]
fn a_step_that_is_no_rule_of_the_catalogue_is_not_named_as_one_alone() {
    // It keeps energy and momentum to rounding, and its pace is right to a high order: others come close.
    for (name, h) in [("box-1", 1.0 / 30.0), ("box-5", 1.0 / 120.0), ("smallest-1", 1.0 / 30.0)] {
        let story = Story::named(name).unwrap();
        let stage = PositionStage::new(&Vector3::from(story.moments)).unwrap();
        let mut state = None;
        let verdict = story.run::<f64>(h, |[w, x, y, z], spin| {
            let attitude = Quaternion::new(w, x, y, z);
            let turned =
                |q: Quaternion<f64>, v: Vector3<f64>| (q * Quaternion::from_imag(v) * q.conjugate()).imag();
            let omega = state.unwrap_or_else(|| turned(attitude, Vector3::from(spin)));
            let end = stage.step(&attitude, &omega, h);
            state = Some(end.omega);
            let (q, v) = (end.attitude, turned(end.attitude.conjugate(), end.omega));
            ([q.w, q.i, q.j, q.k], v.into())
        });
        let diagnosis = verdict.unwrap().diagnosis.unwrap();
        let alone = diagnosis.confidence == Confidence::ToRounding && diagnosis.alike.is_empty();
        assert!(!alone, "{name}: {:?}", diagnosis.best);
    }
}
