//! Times that are wrong by one factor, and attitudes that turn otherwise than by their spin.

use crate::common::invented::Chance;
use crate::common::{Row, SPINS, exact_of, judged, written};
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude::{product, rotation_matrix, turn};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::step::{Method, PositionStage, State, System};
use tumbling_judge::{Alteration, Base, FileMistake, Outcome, Rule, Turn};

const BODIES: [[f64; 3]; 3] = [[1.0, 2.0, 2.5], [0.4, 1.0, 1.1], [3.0, 2.5, 1.0]];
const H: f64 = 0.01;

/// The rows of a body by a step, `None` by the exact motion.
fn run(moments: [f64; 3], spin: Vector3<f64>, method: Option<Method>) -> Vec<Row> {
    let Some(method) = method else { return exact_of(moments, spin, H, 599) };
    let system = System::free(Vector3::from(moments).try_into().unwrap()).unwrap();
    let mut state = State { attitude: Quaternion::identity(), momentum: system.momentum(&spin) };
    let row = |i: u32| {
        let row = (H * f64::from(i), state.attitude, system.omega(&state.momentum));
        state = method.step(&system, &state, H).unwrap();
        row
    };
    (0..600).map(row).collect()
}

/// Every `every`th row, its time multiplied.
fn timed(moments: [f64; 3], rows: &[Row], every: usize, times: f64) -> String {
    let rows: Vec<Row> = rows.iter().step_by(every).map(|(t, q, w)| (t * times, *q, *w)).collect();
    let [a, b, c] = moments;
    written(&format!("# inertia: {a} {b} {c}"), &rows, |t| format!("{t:?}"), |x| format!("{x:?}"))
}

/// A step taken twice, at half of the rate, a wrong number, and rows left out and not counted.
const WRONG: [(usize, f64); 6] = [(1, 0.2), (1, 0.5), (1, 2.0), (1, 5.0), (5, 0.2), (2, 0.5)];

#[test]
fn times_that_are_wrong_by_a_factor_are_said_first_and_the_rule_behind_them_is_named() {
    let methods =
        [None, Some(Method::SemiImplicitEuler), Some(Method::Rescaled), Some(Method::LinearisedImplicit)];
    for (moments, spin) in BODIES.into_iter().zip([SPINS[0], SPINS[1], SPINS[3]]) {
        for method in methods {
            let rows = run(moments, spin.into(), method);
            for (every, times) in WRONG {
                let verdict = judged(&timed(moments, &rows, every, times));
                let [FileMistake::Times(found)] = verdict.file_mistakes[..] else { panic!("{verdict}") };
                assert!((found * times - 1.0).abs() < 1e-12, "{verdict}");
                let first = verdict.to_string().lines().nth(1).unwrap().to_owned();
                assert!(first.starts_with("  The times are ") && first.contains("rows dt = "), "{verdict}");
                let found = verdict.diagnosis.as_ref().unwrap();
                let named: Vec<Rule> = [&[found.best.rule][..], &found.alike].concat();
                let own = method.map_or(Base::Exact, |method| Base::Method(method, every as u32));
                assert!(named.contains(&Rule::plain(own)), "{every} {times} {verdict}");
            }
        }
    }
}

#[test]
fn times_that_are_nearly_right_are_a_mistake_where_one_factor_is_all_that_is_wrong() {
    for (moments, spin) in BODIES.into_iter().zip([SPINS[0], SPINS[1], SPINS[3]]) {
        for method in [None, Some(Method::SemiImplicitEuler), Some(Method::Rescaled)] {
            for times in [1.05, 0.98] {
                let verdict = judged(&timed(moments, &run(moments, spin.into(), method), 1, times));
                let rule = verdict.diagnosis.as_ref().unwrap().best.rule;
                let Some(Alteration::Times(found)) = rule.alteration else { panic!("{verdict}") };
                assert!((found * times - 1.0).abs() < 1e-6, "{verdict}");
                let own = method.map_or(Base::Exact, |method| Base::Method(method, 1));
                assert!(rule.base == own && verdict.outcome == Outcome::Failed, "{verdict}");
            }
        }
    }
}

#[test]
fn times_rounded_by_nearly_half_of_a_step_are_put_back_to_it() {
    for method in [None, Some(Method::SemiImplicitEuler), Some(Method::ConstantSpin)] {
        let rows = run(BODIES[0], SPINS[3].into(), method);
        // 90 rows a second, written with two decimals.
        let rows: Vec<Row> = rows.iter().map(|(t, q, w)| (t / 0.9, *q, w * 0.9)).collect();
        let text = written("# inertia: 1 2 2.5", &rows, |t| format!("{t:.2}"), |x| format!("{x:?}"));
        let (verdict, right) = (judged(&text), judged(&timed(BODIES[0], &rows, 1, 1.0)));
        assert!((verdict.record.step.unwrap() * 90.0 - 1.0).abs() < 2e-3 && verdict.record.gaps.is_none());
        assert_eq!((verdict.outcome, &verdict.file_mistakes[..]), (right.outcome, &[][..]), "{verdict}");
        let said = verdict.to_string();
        let is_sure = verdict.diagnosis.as_ref().unwrap().confidence.names_a_rule();
        // Beside a rule that is not identified, engines would be taken for the record's.
        let is_open = said.contains("write all their digits") && !said.contains("Used by");
        assert!(!said.contains("too short") && (is_sure || is_open), "{said}");
    }
}

#[test]
fn rows_missing_among_times_of_few_digits_are_no_wrong_clock() {
    let rows = run(BODIES[0], SPINS[3].into(), None);
    for (rate, digits, every) in
        [(0.6, 3, 200), (0.6, 2, 200), (0.9, 2, 290), (0.6, 3, 6), (0.9, 2, 6), (0.6, 4, 6)]
    {
        // Nearly every sixth row leaves the step open.
        let is_there = |i: &usize| *i == 0 || !i.is_multiple_of(every) || i.is_multiple_of(7);
        let row = |i: usize| (rows[i].0 / rate, rows[i].1, rows[i].2 * rate);
        let left: Vec<Row> = (0..rows.len()).filter(is_there).map(row).collect();
        let text = written("# inertia: 1 2 2.5", &left, |t| format!("{t:.digits$}"), |x| format!("{x:?}"));
        let (verdict, said) = (judged(&text), judged(&text).to_string());
        assert_eq!((verdict.outcome, &verdict.file_mistakes[..]), (Outcome::Passed, &[][..]), "{said}");
        assert!(!said.contains("too long") && !said.contains("too short"), "{said}");
        match verdict.record.step {
            Some(step) if every > 6 => assert!((step * rate / H - 1.0).abs() < 2e-4, "{said}"),
            _ => assert!(every == 6 && said.contains("write all their digits"), "{said}"),
        }
    }
}

#[test]
fn of_spins_alone_wrong_times_and_a_wrong_term_are_both_said() {
    for (moments, spin) in BODIES.into_iter().zip([SPINS[0], SPINS[1], SPINS[3]]) {
        for method in [None, Some(Method::SemiImplicitEuler), Some(Method::LinearisedImplicit)] {
            let rows = run(moments, spin.into(), method);
            for (every, times) in WRONG {
                let text = timed(moments, &rows, every, times);
                let verdict = judged(&text.replacen("qw,qx,qy,qz", "a,b,c,d", 1));
                let rule = verdict.diagnosis.as_ref().unwrap().best.rule;
                let Some(Alteration::TermOrTimes(found)) = rule.alteration else { panic!("{verdict}") };
                assert!((found * times - 1.0).abs() < 0.01, "{verdict}");
                let said = verdict.to_string();
                assert!(said.contains("either ") && said.contains(", or times that are "), "{said}");
                assert!(said.contains("or record the attitude too"), "{said}");
            }
        }
    }
}

#[test]
fn of_spins_alone_a_rate_between_round_numbers_names_no_rule() {
    let moments = [0.99, 0.91, 0.28];
    let spin = Vector3::new(-40.0, 34.0, -33.0);
    for (digits, times, share) in
        [(5, 0.5, 1.0), (5, 2.0, 1.0), (9, 2.0, 1.0), (15, 0.5, 1.0), (12, 2.0, 0.5)]
    {
        let rows = &run(moments, share * spin, Some(Method::MoserVeselov2))[..235];
        let (time, number) = (|t| format!("{:?}", t * times), |x| format!("{x:.digits$e}"));
        let text = written("# inertia: 0.99 0.91 0.28", rows, time, number);
        let verdict = judged(&text.replacen("qw,qx,qy,qz", "a,b,c,d", 1));
        assert_eq!(verdict.outcome, Outcome::Failed, "{verdict}");
        assert!(!verdict.diagnosis.as_ref().unwrap().confidence.names_a_rule(), "{digits} {verdict}");
        assert!(verdict.to_string().contains("or record the attitude too"), "{verdict}");
    }
}

#[test]
fn an_attitude_that_is_turned_on_the_wrong_side_or_twice_is_named_with_its_remedy() {
    let moments = Vector3::from(BODIES[0]);
    let stage = PositionStage::new(&moments).unwrap();
    let system = System::free(moments.try_into().unwrap()).unwrap();
    let explicit = |q: &Quaternion<f64>, w: &Vector3<f64>| {
        let start = State { attitude: *q, momentum: system.momentum(w) };
        system.omega(&Method::SemiImplicitEuler.step(&system, &start, H).unwrap().momentum)
    };
    let staged = |q: &Quaternion<f64>, w: &Vector3<f64>| {
        let end = stage.step(q, &(rotation_matrix(q) * w), H);
        (end.attitude, end.omega)
    };
    let by = |w: Vector3<f64>| turn(&(w * H));
    type Step<'a> = Box<dyn Fn(&Quaternion<f64>, &Vector3<f64>) -> (Quaternion<f64>, Vector3<f64>) + 'a>;
    let cases: [(&str, Step<'_>); 5] = [
        ("wrong side (dq * q", Box::new(|q, w| (product(&by(explicit(q, w)), q), explicit(q, w)))),
        (
            "wrong side (q * dq",
            Box::new(|q, w| {
                let world = rotation_matrix(q) * explicit(q, w);
                let q = product(q, &by(world));
                (q, rotation_matrix(&q).tr_mul(&world))
            }),
        ),
        // The engine's own update is left in, before or after the stage.
        (
            "turned twice a step",
            Box::new(|q, w| {
                let (q, world) = staged(&product(q, &by(*w)), w);
                (q, rotation_matrix(&q).tr_mul(&world))
            }),
        ),
        (
            "turned twice a step",
            Box::new(|q, w| {
                let (q, world) = staged(q, w);
                let w = rotation_matrix(&q).tr_mul(&world);
                (product(&q, &by(w)), w)
            }),
        ),
        // The stage's attitude is not taken.
        (
            "turned by the new spin in the world",
            Box::new(|q, w| {
                let w = rotation_matrix(q).tr_mul(&staged(q, w).1);
                (product(q, &by(w)), w)
            }),
        ),
    ];
    for (name, step) in cases {
        let (mut q, mut w, mut rows) =
            (turn(&Vector3::new(0.3, -0.5, 0.2)), Vector3::new(1.0, 2.0, 1.5), Vec::new());
        for i in 0..400 {
            rows.push((H * f64::from(i), q, w));
            (q, w) = step(&q, &w);
        }
        let verdict = judged(&timed(BODIES[0], &rows, 1, 1.0));
        let found = verdict.diagnosis.as_ref().unwrap();
        assert!(verdict.file_mistakes.is_empty() && found.confidence.names_a_rule(), "{verdict}");
        assert!(found.best.rule.name().contains(name), "{name}: {verdict}");
        assert!(
            matches!(found.best.rule.alteration, Some(Alteration::Turned(turn)) if turn != Turn::Otherwise)
        );
        if name.contains("dq * q") {
            // Written as a momentum it is the record that it was.
            let momenta: Vec<Row> =
                rows.iter().map(|(t, q, w)| (*t, *q, w.component_mul(&moments))).collect();
            let text = timed(BODIES[0], &momenta, 1, 1.0).replacen("wx,wy,wz", "lx,ly,lz", 1);
            let said = judged(&text).diagnosis.unwrap().best.rule.name();
            assert!(said.contains(name), "{said}");
            // The spin alone shows that it changes too far, and not why.
            let said = judged(&timed(BODIES[0], &rows, 1, 0.5)).to_string();
            let either = "either twice the gyroscopic term, or times that are 2 times too short";
            assert!(said.contains(either), "{said}");
            assert!(said.contains("multiplies the attitude on the wrong side"), "{said}");
            assert!(said.contains("first correct how the attitude turns"), "{said}");
        }
        let remedy = if name.contains("side") { "q * dq if" } else { "own update" };
        assert!(found.advice[0].words.contains(remedy), "{verdict}");
    }
}

#[test]
fn noise_scatters_and_the_roundings_of_a_fine_run_turned_on_the_wrong_side_do_not() {
    let exact = run(BODIES[0], SPINS[3].into(), None);
    let mut chance = Chance(1);
    let noisy = exact.iter().map(|(t, q, w)| (*t, *q, w + chance.vector() * 1.5e-3));
    let said = judged(&timed(BODIES[0], &noisy.collect::<Vec<_>>(), 1, 1.0)).to_string();
    assert!(said.contains("The rows scatter") && said.contains("noisy sensor"), "{said}");
    // Friction of one size, which overshoots at rest.
    let (mut q, mut w) = (Quaternion::identity(), Vector3::new(0.3, 4.0, 0.5));
    let rubbed = (0..600).map(|i| {
        let row = (f64::from(i) / 60.0, q, w);
        w += angular_acceleration(&BODIES[0].into(), &w, &Vector3::zeros()) / 60.0;
        w -= w.normalize() * (1.2 / 60.0);
        q = product(&q, &turn(&(w / 60.0)));
        row
    });
    let said = judged(&timed(BODIES[0], &rubbed.collect::<Vec<_>>(), 1, 1.0)).to_string();
    assert!(said.contains("None of the known rules fits"), "{said}");

    let system = System::free(Vector3::from(BODIES[0]).try_into().unwrap()).unwrap();
    let mut q = Quaternion::identity();
    let wrong = exact.iter().map(|(t, _, w)| {
        let row = (*t, q, *w);
        let mut state = State { attitude: q, momentum: system.momentum(w) };
        for _ in 0..50 {
            let next = Method::RungeKutta4.step(&system, &state, H / 50.0).unwrap();
            let middle = system.omega(&((state.momentum + next.momentum) / 2.0));
            state = State { attitude: product(&turn(&(middle * (H / 50.0))), &state.attitude), ..next };
        }
        q = state.attitude;
        row
    });
    let text = written(
        "# inertia: 1 2 2.5",
        &wrong.collect::<Vec<_>>(),
        |t| format!("{t:?}"),
        |x| format!("{x:.11e}"),
    );
    let said = judged(&text).to_string();
    assert!(!said.contains("scatter") && said.contains("(dq * q, not q * dq)"), "{said}");
    assert!(said.contains("attitude on the wrong side") && !said.contains("Compare the engine"), "{said}");
}

#[test]
fn where_the_spin_stays_a_turn_twice_as_far_is_said_and_not_whether_step_or_times_are_wrong() {
    let rows = run(BODIES[0], SPINS[3].into(), Some(Method::ConstantSpin));
    for times in [0.5, 2.0, 10.0] {
        let said = judged(&timed(BODIES[0], &rows, 1, times)).to_string();
        let rule = format!("turned {} times as far as the spin says, no gyroscopic", 1.0 / times);
        assert!(said.contains(&rule) && !said.contains("twice a step, no"), "{said}");
        let seen = format!("about the spin's axis, and {:.3} times as far", 1.0 / times);
        assert!(said.contains(&seen) && !said.contains("times that are"), "{said}");
    }
    // What hardly turns is turned no number of times too far.
    let stays = rows.iter().map(|(t, _, w)| (*t, Quaternion::from_parts(1.0, w * (5e-16 * t)), *w));
    let said = judged(&timed(BODIES[0], &stays.collect::<Vec<_>>(), 1, 1.0)).to_string();
    assert!(!said.contains("turned 0 times") && !said.contains("momentum taken for"), "{said}");
}
