//! When a free body flips, how often, and how fast the push grows that makes it: to the ends of the number range.

use crate::common::*;
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::PrincipalMoments;
use tumbling::dynamics::observe::sign_changes;
use tumbling::exact::{FreeMotion, Regime, time_between_flips};

fn motion(moments: [f64; 3], omega: [f64; 3]) -> FreeMotion {
    FreeMotion::new(moments.try_into().unwrap(), &omega.into()).unwrap()
}

fn motion_near_the_middle(push: f64) -> FreeMotion {
    motion([1.0, 2.0, 3.0], [0.0, 10.0, push])
}

/// Time goes as one over the spin: so slow a body's first flip is the ordinary one's, scaled, and within the range
/// of numbers although three half periods are not.
#[test]
fn the_slowest_spin_there_is_has_its_next_flip() {
    let ordinary = motion([1.0, 2.0, 3.0], [0.3125, 1.0, -0.1875]).next_flip(0.0).unwrap().unwrap();
    for power in [1000, 1021, 1022] {
        let slow = 2_f64.powi(-power);
        let flip = motion([1.0, 2.0, 3.0], [0.3125 * slow, slow, -0.1875 * slow]).next_flip(0.0).unwrap();
        assert!((flip.unwrap() * slow / ordinary - 1.0).abs() < 4.0 * f64::EPSILON, "2^-{power}: {flip:?}");
    }
    // A hundred times slower it lies beyond the range.
    let error = motion([1.0, 2.0, 3.0], [3e-311, 1e-310, -2e-311]).next_flip(0.0).unwrap_err();
    assert!(error.to_string().contains("the time of the next flip"), "{error}");
    // So does the next one after the last instant that there is.
    assert!(motion([1.0, 2.0, 3.0], [0.3, 1.0, -0.2]).next_flip(f64::MAX).is_err());
}

#[test]
fn no_two_flips_come_at_the_same_instant_however_late() {
    let motion = motion([1.0, 2.0, 3.0], [0.3, 1.0, -0.2]);
    let half = motion.period().unwrap().unwrap() / 2.0;
    let mut answered = 0;
    for count in [1e15_f64, 2.2e15, 3e15, 4.6e15, 8.9e15] {
        for sign in [-1.0, 1.0] {
            let from = sign * count * half;
            let Ok(flips) = motion.flips(from, from + 40.0 * half) else { continue };
            let times: Vec<f64> = flips.collect();
            answered += 1;
            assert!(times.windows(2).all(|pair| pair[0] < pair[1]), "{count:e}: {times:?}");
            assert!((39..=41).contains(&times.len()), "{count:e}: {}", times.len());
        }
    }
    assert!(answered >= 4);
    // One by one they can be asked for further out: always a later instant.
    let mut t = 8.9e15 * half;
    for _ in 0..10 {
        let next = motion.next_flip(t).unwrap().unwrap();
        assert!(next > t && next - t < 4.0 * half, "{t} {next}");
        t = next;
    }
    assert!(motion.next_flip(1e17 * half).unwrap_err().to_string().contains("the number of flips"));
}

/// A wobble about the axis of the largest or smallest moment does not grow; next to the middle axis a push does, at
/// the rate of the linear law, sqrt((I3-I2)(I2-I1)/(I1 I3)) w2, but for what the finite push changes.
#[test]
fn only_a_push_off_the_middle_axis_has_a_rate_of_growth() {
    for wobble in [[0.01, 0.02, 1.0], [1.0, 0.01, -0.02], [0.3, 0.4, 1.0], [1.0, 0.4, 0.3], [1.0, 1.0, 1.0]] {
        assert_eq!(motion([1.0, 2.0, 3.0], wobble).growth_rate().unwrap(), None, "{wobble:?}");
    }
    let saddle = 10.0 / 3_f64.sqrt();
    for push in [0.5, 1e-3, 1e-9, 1e-300, 5e-324] {
        let rate = motion_near_the_middle(push).growth_rate().unwrap().unwrap();
        // rate² = (I3-I2)(L² - 2 E I1)/(I1 I2 I3), with L² - 2 E I1 = 200 + 6 push² here.
        let rate_by_law = saddle * (1.0 + 0.03 * push * push).sqrt();
        assert!((rate / rate_by_law - 1.0).abs() <= 1e-15, "{push:e}: {rate}");
    }
}

proptest! {
    #[test]
    fn a_rate_of_growth_is_that_of_the_middle_axis_and_only_of_motions_close_by(
        m in moments(), omega in generic_spin(), push in 0.0..0.5_f64,
    ) {
        let mut order = [0, 1, 2];
        order.sort_by(|&a: &usize, &b: &usize| m[a].total_cmp(&m[b]));
        let [a, b, c] = order;
        let mut omega = omega * push;
        omega[b] = 1.0;
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let Regime::Elliptic { complement, .. } = motion.regime() else { return Ok(()) };
        let rate = motion.growth_rate().unwrap();
        prop_assert_eq!(rate.is_some(), complement <= 0.1);
        let Some(rate) = rate else { return Ok(()) };
        // Of the steady spin about the middle axis with the same momentum (the linear law).
        let spin = m.component_mul(&omega).norm() / m[b];
        let saddle = spin * ((m[c] - m[b]) * (m[b] - m[a]) / (m[a] * m[c])).sqrt();
        let above = rate / saddle - 1.0;
        prop_assert!(above > -1e-12 && above <= 0.6 * complement * complement + 1e-12, "{above:e} {complement}");
    }
}

/// Counting by arithmetic, and by going through them one by one.
#[test]
fn flips_are_counted_without_being_visited() {
    let motion = motion([1.0, 2.0, 3.0], [0.3, 1.0, -0.2]);
    let half = motion.period().unwrap().unwrap() / 2.0;
    for (from, to) in [(0.0, 55.5), (-20.0, 30.0), (7.0, 7.0), (9.0, -9.0), (-1e9, 60.0 - 1e9)] {
        let flips = motion.flips(from, to).unwrap();
        let mut by_one = flips.clone();
        let mut times = Vec::new();
        while let Some(t) = by_one.next() {
            times.push(t);
            assert_eq!(by_one.remaining() as usize + times.len(), flips.remaining() as usize);
        }
        assert_eq!(by_one.next(), None);
        assert_eq!(
            (flips.size_hint(), flips.remaining()),
            ((times.len(), Some(times.len())), times.len() as u64)
        );
        assert_eq!((flips.clone().count(), flips.clone().last()), (times.len(), times.last().copied()));
        assert!(times.iter().all(|&t| t > from && t <= to) && times.is_sorted());
        assert!((times.len() as f64 - (to - from).max(0.0) / half).abs() <= 1.0, "{from} {to}");
        let backwards: Vec<f64> = flips.clone().rev().collect();
        assert!(backwards.iter().eq(times.iter().rev()));
        for n in 0..times.len() + 2 {
            let mut flips = flips.clone();
            assert_eq!(flips.nth(n), times.get(n).copied());
            assert_eq!(flips.next(), times.get(n + 1).copied());
        }
        // An end that is a flip belongs to the interval, a beginning that is one does not.
        if let [first, .., last] = times[..] {
            assert_eq!(motion.flips(first, last).unwrap().remaining() as usize, times.len() - 1);
        }
    }
    // A thousand million million of them, in no time.
    let many = motion.flips(-1e15 * half, 1e15 * half).unwrap();
    assert!((many.remaining() as f64 - 2e15).abs() <= 1.0);
    let mut middle = many.clone();
    let at = middle.nth(1_000_000_000_000_000).unwrap();
    assert!(at.abs() < 2.0 * half && middle.next().unwrap() > at && many.last().unwrap() > 0.99e15 * half);
    // The one flip of the separatrix, and the none of a wobble that is none.
    let once =
        FreeMotion::new(PrincipalMoments::new(3.0, 4.0, 6.0).unwrap(), &Vector3::new(2.0, 1.0, 1.0)).unwrap();
    let flip = once.next_flip(-1e9).unwrap().unwrap();
    let count = |from, to| once.flips(from, to).unwrap().remaining();
    assert_eq!([count(-1e300, 1e300), count(flip, 1.0), count(-1.0, flip), count(1.0, -1.0)], [1, 0, 1, 0]);
    let steady =
        FreeMotion::new(PrincipalMoments::new(3.0, 4.0, 6.0).unwrap(), &Vector3::new(0.0, 1.0, 0.0)).unwrap();
    assert_eq!((steady.flips(0.0, 1e300).unwrap().remaining(), steady.next_flip(0.0).unwrap()), (0, None));
}

#[test]
fn an_axis_that_is_none_is_named_by_its_number() {
    let error = motion([1.0, 2.0, 3.0], [0.3, 1.0, -0.2]).angles_to_momentum(7).unwrap_err();
    assert_eq!(error.to_string(), "there is no principal axis number 7: they are numbered 0, 1 and 2");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    // A spin whose middle component is exactly 0 at the start flips at time 0 exactly, and from there at every half period:
    // whichever way it is asked.
    #[test]
    fn a_flip_at_the_start_is_at_zero_exactly(
        m in moments(), x in -3.0..3.0_f64, z in -3.0..3.0_f64, zero in prop_oneof![Just(0.0), Just(-0.0)],
    ) {
        let mut order = [0, 1, 2];
        order.sort_by(|&a: &usize, &b: &usize| m[a].total_cmp(&m[b]));
        let mut omega = Vector3::zeros();
        (omega[order[0]], omega[order[1]], omega[order[2]]) = (x, zero, z);
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let Some(half) = time_between_flips(m.try_into().unwrap(), &omega).unwrap() else { return Ok(()) };
        // The first after the start is a half period later, the last before it one earlier; at the start is one of its own.
        let near = |t: f64, expected: f64| (t / expected - 1.0).abs() <= 4.0 * f64::EPSILON;
        let next = motion.next_flip(0.0).unwrap().unwrap();
        prop_assert!(near(next, half), "{next:e} {half:e}");
        prop_assert_eq!(motion.next_flip(-0.5 * half).unwrap().map(f64::to_bits), Some(0.0_f64.to_bits()));
        let around: Vec<f64> = motion.flips(-1.5 * half, 1.5 * half).unwrap().collect();
        prop_assert!(around.len() == 3 && around[1].to_bits() == 0, "{around:?}");
        prop_assert!(near(around[0], -half) && near(around[2], half), "{around:?}");
        prop_assert_eq!(motion.flips(0.0, 0.5 * half).unwrap().count(), 0);
        prop_assert_eq!(motion.flips(-0.5 * half, 0.0).unwrap().collect::<Vec<_>>(), [0.0]);
        // Samples of the spin change sign as often, from the start on and across it.
        let middle = |t: f64| (t, motion.omega(t).unwrap()[order[1]]);
        let sampled = |from: i32, to: i32| sign_changes((from..=to).map(|k| middle(0.1 * half * f64::from(k))));
        prop_assert_eq!(sampled(0, 35).len(), motion.flips(0.0, 3.5 * half).unwrap().count());
        let changes = sampled(-5, 5);
        prop_assert_eq!(changes, [0.0]);
    }

    // So does a flip just before or just after the start: with the middle component at 1e-9 of the others the flip is where the
    // component at its rate at the start vanishes.
    #[test]
    fn a_flip_next_to_the_start_keeps_its_digits(m in moments(), x in 0.1..3.0_f64, z in -3.0..-0.1_f64, power in -300.0..-9.0_f64) {
        let mut order = [0, 1, 2];
        order.sort_by(|&a: &usize, &b: &usize| m[a].total_cmp(&m[b]));
        let [low, middle, high] = order;
        for signs in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
            let mut omega = Vector3::zeros();
            (omega[low], omega[middle], omega[high]) = (signs[0] * x, 10_f64.powf(power), signs[1] * z);
            let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
            let Regime::Elliptic { .. } = motion.regime() else { return Ok(()) };
            let (first, second) = ((middle + 1) % 3, (middle + 2) % 3);
            let rate = (m[first] - m[second]) / m[middle] * omega[first] * omega[second];
            let expected = -omega[middle] / rate;
            let half = time_between_flips(m.try_into().unwrap(), &omega).unwrap().unwrap();
            let found = motion.next_flip(-0.25 * half).unwrap().unwrap();
            // The complementary series drops, so close to a flip, a term of 5 p^6 = 1.4e-10 at most, with p its nome.
            prop_assert!((found / expected - 1.0).abs() <= 1.4e-10, "{found:e} {expected:e}");
        }
    }
}
