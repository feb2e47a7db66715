//! Intervals against exact fractions, identities and the library's closed form.

use nalgebra::Vector3;
use num_traits::{One, Zero};
use proptest::prelude::*;
use tumbling::number::Ring;
use tumbling_proofs::interval::motion::{FreeMotion, Open};
use tumbling_proofs::{Interval, Rational, given};

fn exact(x: f64) -> Rational {
    Rational::of_f64(x)
}

fn point(x: f64) -> Interval {
    exact(x).into()
}

/// Floats of every size, subnormal ones too, and whole numbers.
fn float() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-1.0..1.0_f64, -40..40_i32).prop_map(|(x, power)| x * 2_f64.powi(power)),
        (-1.0..1.0_f64, -1070..1000_i32).prop_map(|(x, power)| x * 2_f64.powi(power)),
        (-9..9_i32).prop_map(f64::from),
    ]
}

/// Two ends in order.
fn interval() -> impl Strategy<Value = Interval> {
    (float(), float()).prop_map(|(a, b)| point(a).hull(point(b)))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn sums_products_and_quotients_contain_the_exact_fraction(a in float(), b in float()) {
        let (x, y) = (point(a), point(b));
        prop_assert!((x + y).contains(&(exact(a) + exact(b))));
        prop_assert!((x - y).contains(&(exact(a) - exact(b))));
        prop_assert!((x * y).contains(&(exact(a) * exact(b))));
        prop_assert!(x.square().contains(&(exact(a) * exact(a))) && x.square().low() >= 0.0);
        if b != 0.0 {
            prop_assert!((x / y).contains(&(exact(a) / exact(b))));
        }
    }

    #[test]
    fn an_operation_on_floats_is_off_by_one_float_at_most(a in 0.1..1e9_f64, b in -1e9..-0.1_f64) {
        for result in [point(a) + point(b), point(a) * point(b), point(a) / point(b), point(a).sqrt()] {
            prop_assert!(result.high() <= result.low().next_up());
        }
    }

    #[test]
    fn what_lies_in_the_operands_lies_in_the_result(a in interval(), b in interval(), s in 0.0..1.0, t in 0.0..1.0) {
        let within = |x: Interval, share: f64| (x.low() + share * (x.high() - x.low())).clamp(x.low(), x.high());
        let (p, q) = (within(a, s), within(b, t));
        prop_assert!((a + b).contains(&(exact(p) + exact(q))));
        prop_assert!((a * b).contains(&(exact(p) * exact(q))));
        if !b.has_zero() {
            prop_assert!((a / b).contains(&(exact(p) / exact(q))));
        }
        prop_assert!(a.abs().contains(&exact(p.abs())) && a.square().contains(&(exact(p) * exact(p))));
    }

    #[test]
    fn a_root_lies_between_floats_whose_squares_surround_it(x in 0.0..1e300_f64) {
        let root = point(x).sqrt();
        prop_assert!(exact(root.low()) * exact(root.low()) <= exact(x));
        prop_assert!(exact(root.high()) * exact(root.high()) >= exact(x));
    }

    /// Against their series in exact fractions: fifty terms, of which no further one is above 1e-29.
    #[test]
    fn functions_contain_their_series_and_little_more(k in -512_i64..512, n in 500_i64..2000) {
        let over = |n: i64, by: i64| Rational::from(n) / Rational::from(by);
        let sum = |first: Rational, next: &dyn Fn(i64) -> Rational| {
            let mut term = first;
            (1..=50).fold(Rational::zero(), |sum, n| {
                let sum = sum + term.clone();
                term = term.clone() * next(n);
                sum
            })
        };
        let (x, y) = (over(k, 1024), over(n - 1000, n + 1000));
        let square = |x: &Rational| x.clone() * x.clone();
        let (one, p) = (Rational::one(), Interval::from(x.clone()));
        let arc = |x: &Rational, sign: i64| {
            sum(x.clone(), &|n| square(x) * over(sign * (2 * n - 1), 2 * n + 1))
        };
        for (found, series) in [
            (p.exp_and_exp_m1().0, sum(one.clone(), &|n| x.clone() * over(1, n))),
            (p.exp_and_exp_m1().1, sum(one.clone(), &|n| x.clone() * over(1, n)) - one.clone()),
            (p.sin_cos().0, sum(x.clone(), &|n| square(&x) * over(-1, 2 * n * (2 * n + 1)))),
            (p.sin_cos().1, sum(one.clone(), &|n| square(&x) * over(-1, 2 * n * (2 * n - 1)))),
            (p.atan(), arc(&x, -1)),
            (Interval::from(over(n, 1000)).ln(), arc(&y, 1) * Rational::from(2)),
        ] {
            let [low, high, off] = [found.low(), found.high(), 1e-29].map(exact);
            prop_assert!(low <= series.clone() + off.clone() && series <= high + off, "{found:e} {k} {n}");
            prop_assert!(found.width() < 2e-14, "{found:e} {k} {n}");
        }
    }

    #[test]
    fn functions_obey_their_addition_theorems_narrowly(a in -30.0..30.0_f64, b in 0.01..30.0_f64) {
        let (x, y) = (point(a), point(b));
        let ((s, c), (t, d)) = (x.sin_cos(), y.sin_cos());
        let (sine, cosine) = (x + y).sin_cos();
        prop_assert!((sine - (s * d + c * t)).has_zero() && (cosine - (c * d - s * t)).has_zero());
        prop_assert!((s.square() + c.square() - Interval::one()).has_zero() && s.width() < 1e-13);
        let logarithm = y.ln() + (y.square() + Interval::one()).ln();
        let both = (y * (y.square() + Interval::one())).ln();
        prop_assert!((logarithm - both).has_zero() && both.width() < 1e-13);
        // arctan(b) + arctan(1/b) is a right angle; the arctangent of a quotient is the angle.
        let right = y.atan() + (Interval::one() / y).atan();
        prop_assert!((right * given!(2) - Interval::PI).has_zero() && right.width() < 1e-13);
        prop_assert!((t.atan2(d) - y).has_zero() || b > 3.0);
        prop_assert!((d.acos() - y).has_zero() || b > 3.0);
    }
}

#[test]
fn a_motion_on_the_border_is_left_open() {
    let moments = Vector3::new(given!(5), given!(10), given!(13));
    let spin = |x, y, z| FreeMotion::new(&moments, &Vector3::new(x, y, z));
    assert_eq!(spin(given!(0), given!(1), given!(0)).unwrap_err(), Open::Spin, "steady");
    let even = Vector3::new(given!(5), given!(5), given!(9));
    assert_eq!(FreeMotion::new(&even, &even).unwrap_err(), Open::Moments);
    assert_eq!(spin(Interval::ALL, given!(1), given!(0)).unwrap_err(), Open::Spin);
}

#[test]
fn numbers_are_printed_only_as_far_as_they_are_certain() {
    let [a, b]: [Interval; 2] = [given!(0.6449), given!(0.6451)];
    assert_eq!(format!("{:.2}", a), "0.64");
    assert_eq!(format!("{:.2}", a.hull(b)), "[0.64, 0.65]");
    assert_eq!(format!("{:.1}", given!(Interval: -0.01).hull(given!(0.01))), "0.0");
    assert_eq!(format!("{:.0e}", given!(Interval: 3.0000001e-13)), "3e-13");
    assert_eq!(format!("{:.1}", Interval::ALL), "[-inf, inf]");
    assert!(a < b && a.hull(b).partial_cmp(&b).is_none() && a != a.hull(b));
}

#[test]
fn fractions_are_printed_as_decimals_to_the_nearest() {
    let printed = |n: i64, d: i64, digits: usize| format!("{:.digits$}", Rational::new(n, d));
    assert_eq!(printed(10, 12, 3), "0.833");
    assert_eq!(printed(-1, 8, 3), "-0.125");
    assert_eq!(printed(-1, 8, 2), "-0.12");
    assert_eq!(printed(3, 8, 2), "0.38");
    assert_eq!(printed(-1, 1000, 2), "0.00");
    assert_eq!(printed(5000, 3, 0), "1667");
    assert_eq!(printed(1, 0, 1), "undefined");
    assert_eq!(Rational::new(3, 23).to_string(), "3/23");
}

#[test]
fn the_smallest_float_has_a_logarithm() {
    let powers = given!(Interval: 2).ln() * given!(-1074);
    let least = point(f64::from_bits(1)).ln();
    assert!((least - powers).has_zero() && least.width() < 1e-11, "{least:?}");
}

#[test]
fn bounds_that_contradict_a_number_leave_none_and_nothing_hides_it() {
    let two = given!(Interval: 2);
    for none in [two.acos(), (-two).not_negative(), two.clamped(-1.0, 1.0)] {
        let (sine, cosine) = none.sin_cos();
        let with_another = [
            none + two,
            two - none,
            none * two,
            none * Interval::zero(),
            two / none,
            none / Interval::zero(),
            none.hull(two),
        ];
        let alone =
            [none.abs(), none.square(), none.sqrt(), none.ln(), none.atan(), two.atan2(none), sine, cosine];
        for x in with_another.into_iter().chain(alone).chain([none.clamped(-1.0, 1.0), none.min_of(two)]) {
            assert!(x.low().is_nan() && x.high().is_nan(), "{x:?}");
            assert!(x.partial_cmp(&two).is_none() && !x.has_zero());
        }
        assert_eq!(format!("{none:.3}"), "NaN");
    }
    assert_eq!(format!("{:.3}", (two / given!(4)).acos()), "1.047");
}

#[test]
fn whole_numbers_stay_points() {
    assert_eq!(Interval::integer(12), given!(12));
    assert_eq!(Interval::zero() * Interval::ALL.clamped(-1.0, 1.0), Interval::zero());
    assert_eq!(given!(Interval: 7) * given!(6) / given!(21), given!(2));
}
