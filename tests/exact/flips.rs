//! When a free body flips, and how often: to the ends of the number range.

use super::{distinct, motion};
use crate::common::*;
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::PrincipalMoments;
use tumbling::dynamics::observe::sign_changes;
use tumbling::exact::{Regime, time_between_flips};

proptest! {
    #[test]
    fn flips_are_where_the_middle_spin_vanishes_one_beat_apart(m in moments(), omega in generic_spin(), from in -50.0..50.0_f64) {
        prop_assume!(distinct(&m));
        let motion = free_motion(m, &omega);
        let beat = time_between_flips(m.try_into().unwrap(), &omega).unwrap().unwrap();
        prop_assert!((motion.period().unwrap().unwrap() / beat - 2.0).abs() < 1e-15);
        let times: Vec<f64> = motion.flips(from, from + 5.5 * beat).unwrap().collect();
        prop_assert!(times.len() == 5 || times.len() == 6);
        prop_assert_eq!(motion.next_flip(from).unwrap(), Some(times[0]));
        let mut order = [0, 1, 2];
        order.sort_by(|&a: &usize, &b: &usize| m[a].total_cmp(&m[b]));
        for pair in times.windows(2) {
            prop_assert!(((pair[1] - pair[0]) / beat - 1.0).abs() < 1e-11);
        }
        for &t in &times {
            prop_assert!(t > from && motion.omega(t).unwrap()[order[1]].abs() < 1e-11, "{t}");
        }
    }
}

/// Time goes as one over the spin: so slow a body's first flip is the ordinary one's, scaled, and within the
/// range of numbers although three half periods are not.
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
    // One by one they can be requested further out: always a later instant.
    let mut t = 8.9e15 * half;
    for _ in 0..10 {
        let next = motion.next_flip(t).unwrap().unwrap();
        assert!(next > t && next - t < 4.0 * half, "{t} {next}");
        t = next;
    }
    assert!(motion.next_flip(1e17 * half).unwrap_err().to_string().contains("the number of flips"));
}

/// A push of the smallest number there is: after the saddle has been left, cn = 1/cosh of the time to the
/// flip, and the flip comes ln(4/k')/rate after the start (mathematics, to terms of the order of the push).
#[test]
fn a_subnormal_push_flips_when_the_logarithm_says() {
    let motion = motion([1.0, 2.0, 3.0], [0.0, 10.0, 5e-324]);
    let rate = 10.0 / 3_f64.sqrt();
    // k'² = 2 (3 push²)/(200), with D = 3 (3-2) push² and Q² = 2 (2-1) 100; the spin starts in the middle
    // between two flips.
    let expected = (4_f64.ln() - 0.5 * 0.03_f64.ln() - f64::ln(5e-324)) / rate;
    let flip = motion.next_flip(0.0).unwrap().unwrap();
    assert!((flip / expected - 1.0).abs() < 1e-14, "{flip} {expected}");
    let moments = PrincipalMoments::new(1.0, 2.0, 3.0).unwrap();
    let apart = time_between_flips(moments, &Vector3::new(0.0, 10.0, 5e-324)).unwrap().unwrap();
    assert!((0.5 * apart / expected - 1.0).abs() < 1e-14, "{apart} {expected}");
    // As it passes, the spin is all across and around: on the separatrix, w1² = 3 w3² and energy is shared.
    let across = motion.omega(flip).unwrap();
    assert!(across.y.abs() < 1e-9 && (across.x.abs() / (3_f64.sqrt() * across.z.abs()) - 1.0).abs() < 1e-12);
    assert!((motion.omega(2.0 * flip).unwrap().y + 10.0).abs() < 1e-13);
    // Before it is felt, the push grows as cosh of the rate.
    let early = motion.omega(3.0).unwrap().z;
    assert!((early / ((rate * 3.0).cosh() * 5e-324) - 1.0).abs() < 1e-7, "{early:e}");
}

/// With I1 (I2 - I1) next to I3 (I3 - I2) and two pushes alike, the motion is nearer to the separatrix by far
/// than the push is to nothing: the least spin it passes is below all numbers, and the scale that undoes it
/// has to come in two parts.
#[test]
fn the_least_push_of_a_slow_spin_grows_to_a_whole_flip() {
    // 0.7 · 0.3 = c (c - 1) for c = (1 + sqrt(1.84))/2.
    let c = 0.5 * (1.0 + 1.84_f64.sqrt());
    for (push, power) in [(5e-324, -99), (-5e-324, -100), (5e-324, -101), (5e-324, -102)] {
        let slow = 2_f64.powi(power);
        let motion = motion([0.7, 1.0, c], [5e-324, slow, push]);
        let Regime::Elliptic { complement, .. } = motion.regime() else { panic!("{:?}", motion.regime()) };
        assert!(complement < 1e-298, "{complement:e}");
        let flip = motion.next_flip(0.0).unwrap().unwrap();
        let w = motion.omega(flip).unwrap() / slow;
        // All of energy and momentum is across and around: I1 w1² + I3 w3² = 1 and I1² w1² + I3² w3² = 1.
        let [x, z] = [(c - 1.0) / (0.7 * (c - 0.7)), 0.3 / (c * (c - 0.7))].map(f64::sqrt);
        assert!(
            w.y.abs() < 1e-12 && (w.x.abs() / x - 1.0).abs() < 1e-13 && (w.z.abs() / z - 1.0).abs() < 1e-13,
            "{w:?}"
        );
    }
}

/// After a billion flips the phase is as good as the rate: half a unit in each input, times the phase.
#[test]
fn after_a_billion_flips_the_spin_is_where_the_count_of_flips_says() {
    let motion = motion([1.0, 2.0, 3.0], [0.3, 1.0, -0.2]);
    let half = motion.period().unwrap().unwrap() / 2.0;
    let far = motion.next_flip(1e9 * half).unwrap().unwrap();
    let spin = motion.omega(far).unwrap();
    // The time itself is rounded to 2e-7 of a second, which turns the phase by as much.
    assert!(spin.y.abs() < 4.0 * ulp(far), "{}", spin.y);
    let near = motion.next_flip(0.0).unwrap().unwrap();
    assert!((motion.omega(near).unwrap().x.abs() - spin.x.abs()).abs() < 1e-6);
}

/// Counted by arithmetic, and by visiting the flips one by one.
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
        // A flip at the end of an interval belongs to it, a flip at its beginning does not.
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
    assert!(motion.flips(0.0, 1e300).is_err());
    // The one flip of the separatrix, and none of a steady spin.
    let once = free_motion([3.0, 4.0, 6.0], &Vector3::new(2.0, 1.0, 1.0));
    let flip = once.next_flip(-1e9).unwrap().unwrap();
    let count = |from, to| once.flips(from, to).unwrap().remaining();
    assert_eq!([count(-1e300, 1e300), count(flip, 1.0), count(-1.0, flip), count(1.0, -1.0)], [1, 0, 1, 0]);
    let steady = free_motion([3.0, 4.0, 6.0], &Vector3::new(0.0, 1.0, 0.0));
    assert_eq!((steady.flips(0.0, 1e300).unwrap().remaining(), steady.next_flip(0.0).unwrap()), (0, None));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    // A spin whose middle component is exactly 0 at the start flips at time 0 exactly, and from there at
    // every half period, by each of the four functions.
    #[test]
    fn a_flip_at_the_start_is_at_zero_exactly(
        m in moments(), x in -3.0..3.0_f64, z in -3.0..3.0_f64, zero in prop_oneof![Just(0.0), Just(-0.0)],
    ) {
        let mut order = [0, 1, 2];
        order.sort_by(|&a: &usize, &b: &usize| m[a].total_cmp(&m[b]));
        let mut omega = Vector3::zeros();
        (omega[order[0]], omega[order[1]], omega[order[2]]) = (x, zero, z);
        let motion = free_motion(m, &omega);
        let Some(half) = time_between_flips(m.try_into().unwrap(), &omega).unwrap() else { return Ok(()) };
        // The first after the start is a half period later, the last before it one earlier; at the start is
        // one of its own.
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

    // So does a flip just before or just after the start: with the middle component at 1e-9 of the others the
    // flip is where the component at its rate at the start vanishes.
    #[test]
    fn a_flip_next_to_the_start_keeps_its_digits(m in moments(), x in 0.1..3.0_f64, z in -3.0..-0.1_f64, power in -300.0..-9.0_f64) {
        let mut order = [0, 1, 2];
        order.sort_by(|&a: &usize, &b: &usize| m[a].total_cmp(&m[b]));
        let [low, middle, high] = order;
        for signs in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
            let mut omega = Vector3::zeros();
            (omega[low], omega[middle], omega[high]) = (signs[0] * x, 10_f64.powf(power), signs[1] * z);
            let motion = free_motion(m, &omega);
            let Regime::Elliptic { .. } = motion.regime() else { return Ok(()) };
            let (first, second) = ((middle + 1) % 3, (middle + 2) % 3);
            let rate = (m[first] - m[second]) / m[middle] * omega[first] * omega[second];
            let expected = -omega[middle] / rate;
            let half = time_between_flips(m.try_into().unwrap(), &omega).unwrap().unwrap();
            let found = motion.next_flip(-0.25 * half).unwrap().unwrap();
            // The complementary series drops, so close to a flip, a term of 5 p^6 = 1.4e-10 at most, with p
            // its nome.
            prop_assert!((found / expected - 1.0).abs() <= 1.4e-10, "{found:e} {expected:e}");
        }
    }
}
