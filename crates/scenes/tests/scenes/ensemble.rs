//! Many bodies answer as each of them would alone, to the bit.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use std::sync::Mutex;
use tumbling::exact::{Batch, Instant, Regime};
use tumbling_scenes::ensemble::{Chunk, Ensemble, FourLanes, INSTANTS, Solver, TILE};
use tumbling_scenes::{InitialState, Start};

fn state(moments: [f64; 3], omega: [f64; 3]) -> InitialState {
    InitialState::spinning(moments.into(), omega.into())
}

fn turned(state: InitialState, angles: [f64; 3]) -> InitialState {
    let attitude = UnitQuaternion::from_euler_angles(angles[0], angles[1], angles[2]);
    InitialState { attitude, ..state }
}

/// A body of every kind, in every order of its axes, both ways round, at every size, some of them turned.
fn every_kind() -> Vec<InitialState> {
    let mut all = Vec::new();
    let kinds: [([f64; 3], [f64; 3]); 12] = [
        ([2.0, 2.0, 2.0], [0.3, -1.0, 0.7]),
        ([1.0, 2.0, 2.5], [0.0, 0.0, 0.0]),
        ([1.0, 2.0, 2.5], [0.0, -3.0, 0.0]),
        ([2.0, 2.0, 3.0], [0.4, 0.5, -1.0]),
        ([2.0, 2.0, 1.0], [0.4, 0.5, 1.0]),
        ([1.0, 2.0, 2.5], [0.2, 0.3, 1.1]),
        ([1.0, 2.0, 2.5], [1.3, 0.2, -0.1]),
        ([1.0, 2.0, 2.5], [0.01, 1.0, 0.02]),
        ([1.0, 2.0, 2.5], [0.02, -1.0, 1e-3]),
        ([1.0, 2.0, 2.5], [1e-90, 1.0, 2e-90]),
        ([1.0, 2.0, 2.5], [1e-9, 1e-9, 1.0]),
        // 6 (6-4) w3² = 3 (4-3) w1² exactly.
        ([3.0, 4.0, 6.0], [2.0, 1.0, 1.0]),
    ];
    for (k, (moments, omega)) in kinds.into_iter().enumerate() {
        for (n, order) in
            [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]].into_iter().enumerate()
        {
            for scale in [1.0, -1.0, 1e-150, 1e150, 1e-200] {
                let body = state(order.map(|i| moments[i]), order.map(|i| scale * omega[i]));
                all.push(if (k + n) % 2 == 0 { body } else { turned(body, [0.3, -1.0, 2.0]) });
            }
        }
    }
    all
}

fn bits(instant: &Instant) -> [u64; 7] {
    let (w, q) = (instant.omega, instant.attitude);
    [w.x, w.y, w.z, q.w, q.i, q.j, q.k].map(f64::to_bits)
}

/// Times about the length of the motion, short and long, before and at the start.
fn times_of(speed: f64) -> Vec<f64> {
    [0.0, 1e-300, 0.37, -2.0, 11.0, 1e3, -1e9, 1e17, 1e300]
        .map(|t: f64| (t / speed).clamp(-1e305, 1e305))
        .to_vec()
}

fn answers<W: Solver>(all: &[InitialState], times: &[f64]) -> Vec<Option<W::Answer>> {
    let mut found = vec![None; all.len() * times.len()];
    Ensemble::<W>::prepare(all.len(), |k| all[k], |_| {})
        .in_order(
            times,
            |_| {},
            |chunk| {
                for (time, body, state) in chunk.states() {
                    assert!(found[time * all.len() + body].replace(state).is_none(), "answered twice");
                }
            },
        )
        .unwrap();
    found
}

#[test]
fn bodies_of_every_kind_and_size_answer_in_lanes_as_each_does_alone_to_the_bit() {
    let all = every_kind();
    let regimes: Vec<Regime> = all.iter().map(|body| body.motion().unwrap().regime()).collect();
    let kinds: std::collections::HashSet<_> = regimes.iter().map(std::mem::discriminant).collect();
    assert_eq!(kinds.len(), 5, "a kind is missing");
    for speed in [1.0, 1e-150, 1e150] {
        let times = times_of(speed);
        let (four, one) = (answers::<Batch<FourLanes>>(&all, &times), answers::<Batch<f64>>(&all, &times));
        let spins = answers::<Batch<FourLanes, Vector3<f64>>>(&all, &times);
        for (k, &t) in times.iter().enumerate() {
            for (n, body) in all.iter().enumerate() {
                let alone = body.motion().unwrap();
                let at = k * all.len() + n;
                let label = format!("{body:?} at {t:e}");
                let expected = alone.at(t).unwrap();
                let found = four[at].unwrap();
                // The signs of zeros too.
                assert_eq!(bits(&found), bits(&expected), "{label}");
                assert_eq!(bits(&one[at].unwrap()), bits(&expected), "{label}");
                let sign_and_size = |w: Vector3<f64>| <[f64; 3]>::from(w).map(f64::to_bits);
                let omega = alone.omega(t).unwrap();
                assert_eq!(sign_and_size(spins[at].unwrap()), sign_and_size(omega), "{label}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn neighbours_and_their_number_change_no_bit_of_an_answer(
        spins in proptest::collection::vec(proptest::array::uniform3(-3.0_f64..3.0), 1..40),
        shift in 0_usize..40,
        t in -1e3_f64..1e3,
    ) {
        let body = |w: &[f64; 3]| turned(state([1.0, 1.3 + 0.1 * w[0].abs(), 1.9], *w), [w[1], w[2], w[0]]);
        let all: Vec<InitialState> = spins.iter().map(body).collect();
        let mut moved = all.clone();
        moved.rotate_left(shift % all.len());
        let (before, after) = (answers::<Batch<FourLanes>>(&all, &[t]), answers::<Batch<FourLanes>>(&moved, &[t]));
        for n in 0..all.len() {
            let there = (n + all.len() - shift % all.len()) % all.len();
            prop_assert_eq!(bits(&before[n].unwrap()), bits(&after[there].unwrap()));
            let alone = answers::<Batch<FourLanes>>(&all[n..=n], &[t]);
            prop_assert_eq!(bits(&before[n].unwrap()), bits(&alone[0].unwrap()));
            prop_assert_eq!(bits(&before[n].unwrap()), bits(&all[n].motion().unwrap().at(t).unwrap()));
        }
    }

    // Independent: momentum in the world and energy, which the motion keeps.
    #[test]
    fn momentum_and_energy_of_each_of_many_stay(
        spins in proptest::collection::vec(proptest::array::uniform3(-3.0_f64..3.0), 1..9),
        t in -1e3_f64..1e3,
    ) {
        let all: Vec<InitialState> = spins.iter().map(|w| turned(state([1.0, 1.7, 2.1], *w), *w)).collect();
        for (found, body) in answers::<Batch<FourLanes>>(&all, &[t]).into_iter().zip(&all) {
            let found = found.unwrap();
            let Start::Spin(omega) = body.start else { panic!() };
            let world = |w: &Vector3<f64>, q: &UnitQuaternion<f64>| q * body.moments.component_mul(w);
            let (start, now) = (world(&omega, &body.attitude), world(&found.omega, &found.attitude));
            prop_assert!((start - now).norm() <= 3e-15 * (1.0 + start.norm()), "{start} {now}");
            let energy = |w: &Vector3<f64>| body.moments.component_mul(w).dot(w);
            prop_assert!((energy(&omega) - energy(&found.omega)).abs() <= 6e-15 * (1.0 + energy(&omega)));
        }
    }
}

#[test]
fn one_impossible_body_among_many_is_named_and_the_others_are_answered() {
    let bodies = 5 * TILE + 7;
    let wrong = 3 * TILE + 100;
    let one = |k: usize| {
        if k == wrong {
            return state([1.0, 1.0, 3.0], [1.0, 0.0, 0.0]);
        }
        state([1.0, 1.5, 2.0], [0.1, 1.0 + 1e-3 * k as f64, if k == 2 { f64::NAN } else { 0.2 }])
    };
    let ensemble = Ensemble::instants(bodies, one, |_| {});
    let refused = ensemble.refused();
    assert_eq!(refused.iter().map(|r| r.body).collect::<Vec<_>>(), [2, wrong]);
    for (refused, words) in refused.iter().zip(["NaN: it must be a finite number", "1 + 1 >= 3"]) {
        assert!(refused.error.to_string().contains(words), "{}", refused.error);
    }
    let mut seen = 0;
    ensemble
        .in_order(
            &[0.5],
            |_| {},
            |chunk| {
                for (_, body, instant) in chunk.states() {
                    seen += 1;
                    if body == 2 || body == wrong {
                        assert!(instant.omega.x.is_nan() && instant.attitude.w.is_nan());
                    } else {
                        assert_eq!(instant, one(body).motion().unwrap().at(0.5).unwrap());
                    }
                }
            },
        )
        .unwrap();
    assert_eq!(seen, bodies);
}

#[test]
fn an_attitude_that_is_no_unit_quaternion_is_refused() {
    let attitude = UnitQuaternion::new_unchecked(Quaternion::new(2.0, 0.0, 0.0, 0.0));
    let one = |_| InitialState { attitude, ..state([1.0, 1.5, 2.0], [1.0, 1.0, 1.0]) };
    assert_eq!(Ensemble::spins(3, one, |_| {}).refused().len(), 3);
}

#[test]
fn no_bodies_and_no_times_give_nothing_and_a_time_that_is_no_number_is_refused_before_any_answer() {
    let one = |_| state([1.0, 1.5, 2.0], [0.1, 1.0, 0.2]);
    let none = Ensemble::instants(0, one, |_| panic!("nothing to tell"));
    assert!(none.is_empty() && none.refused().is_empty());
    none.each(&[1.0], |_| (), |_| panic!("no bodies")).unwrap();
    let some = Ensemble::spins(TILE + 1, one, |_| {});
    some.in_order(&[], |_| (), |_| panic!("no times")).unwrap();
    some.each(&[], |_| (), |_| panic!("no times")).unwrap();
    for wrong in [f64::NAN, f64::INFINITY] {
        let times = [vec![1.0; 3 * INSTANTS], vec![wrong]].concat();
        let put = |_: Chunk<'_, Vector3<f64>>| panic!("an answer");
        assert!(some.each(&times, |_| (), put).unwrap_err().to_string().contains("finite number"));
        assert!(some.in_order(&times, |_| (), put).unwrap_err().to_string().contains("finite number"));
    }
}

#[test]
fn chunks_cover_every_body_and_time_once_and_progress_ends_at_the_end() {
    let (bodies, times) = (2 * TILE + 3, (0..2 * INSTANTS + 5).map(|k| 0.1 * k as f64).collect::<Vec<_>>());
    let one = |k: usize| state([1.0, 1.5, 2.0], [0.1, 1.0, 0.001 * k as f64]);
    let prepared = Mutex::new(0);
    let ensemble = Ensemble::instants(bodies, one, |p| {
        let mut most = prepared.lock().unwrap();
        *most = (*most).max(p.done);
        assert_eq!(p.of, bodies);
    });
    assert_eq!(*prepared.lock().unwrap(), bodies);
    let (seen, answered) = (Mutex::new(vec![0; bodies * times.len()]), Mutex::new(0));
    ensemble
        .each(
            &times,
            |p| {
                let mut most = answered.lock().unwrap();
                *most = (*most).max(p.done);
            },
            |chunk| {
                assert!(chunk.answers.len() <= TILE * INSTANTS);
                for (time, body, instant) in chunk.states() {
                    seen.lock().unwrap()[time * bodies + body] += 1;
                    assert_eq!(instant, one(body).motion().unwrap().at(times[time]).unwrap());
                }
            },
        )
        .unwrap();
    assert!(seen.lock().unwrap().iter().all(|&n| n == 1));
    assert_eq!(*answered.lock().unwrap(), bodies * times.len());
}
