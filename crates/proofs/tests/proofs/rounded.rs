//! The errors of the library's floats, compared with fractions and intervals.

use num_traits::Zero;
use proptest::prelude::*;
use tumbling::PrincipalMoments;
use tumbling::exact::FreeMotion;
use tumbling::laws::{Lane, Real, Rounding};
use tumbling_proofs::interval::forward::{bound, bound_of_all};
use tumbling_proofs::interval::motion;
use tumbling_proofs::tested::{Rounded, every_path};
use tumbling_proofs::{Interval, Rational};

fn fraction(x: f64) -> Rational {
    Rational::of_f64(x)
}

fn point(x: f64) -> Interval {
    fraction(x).into()
}

fn exact(x: f64) -> Rounded {
    Rounded::given(point(x))
}

/// Whether on a path this is what is computed where the exact number is that one.
fn holds(found: impl Fn() -> Rounded, computed: f64, exact: &Rational) -> bool {
    let off = fraction(computed) - exact.clone();
    let holds = |x: &Rounded| x.at.contains(&fraction(computed)) && x.off.contains(&off);
    every_path(found).unwrap().iter().any(holds)
}

/// A number computed as `x` that is off by `off`, among others around it.
fn number(x: f64, off: f64, wide: f64) -> (Rounded, Rational) {
    let around = |x: f64, wide: f64| point(x - wide).hull(point(x + wide));
    (
        Rounded { at: around(x, wide * x.abs()), off: around(off, 0.1 * off.abs()) },
        fraction(x) - fraction(off),
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Against exact fractions. At points and without an error before it, what is left is the operation's
    /// own rounding.
    #[test]
    fn each_operation_is_off_by_no_more_than_it_says(
        a in prop_oneof![-9.0..9.0_f64, Just(3.0), -1e-160..1e-160],
        b in prop_oneof![-9.0..9.0_f64, Just(0.1), 1e-170..1e-150_f64],
        off in prop_oneof![Just(0.0), -1e-12..1e-12_f64],
        wide in prop_oneof![Just(0.0), Just(1e-3)],
    ) {
        let ((x, p), (y, q)) = (number(a, off * a, wide), number(b, 0.7 * off * b, wide));
        prop_assert!(holds(|| x + y, a + b, &(p.clone() + q.clone())));
        prop_assert!(holds(|| x - y, a - b, &(p.clone() - q.clone())));
        prop_assert!(holds(|| x * y, a * b, &(p.clone() * q.clone())));
        if b != 0.0 {
            prop_assert!(holds(|| x / y, a / b, &(p.clone() / q.clone())));
        }
        let (high, parts) = (a + b, a.sum_in_two(b));
        let left = p.clone() + q.clone() - fraction(high);
        prop_assert!(holds(|| x.sum_in_two(y)[1], parts[1], &left));
        let parts = a.quick_sum_in_two(b);
        prop_assert!(holds(|| x.quick_sum_in_two(y)[1], parts[1], &left));
        let [high, low] = a.product_in_two(b);
        prop_assert!(holds(|| x.product_in_two(y)[1], low, &(p.clone() * q.clone() - fraction(high))));
        let one = || { let [high, low] = x.product_in_two(y); Rounded::in_one(high, low)[0] };
        prop_assert!(holds(one, high, &(p.clone() * q)));
        let [whole, left] = a.whole_and_left();
        prop_assert!(holds(|| x.whole_and_left()[1], left, &(p - fraction(whole))));
    }

    /// The platform's functions are right to a unit, too. Of the exact result there is an enclosure.
    #[test]
    fn each_function_is_off_by_no_more_than_it_says(
        a in 0.01..0.7_f64,
        b in 0.1..2.0_f64,
        off in prop_oneof![Just(0.0), -1e-12..1e-12_f64],
    ) {
        let ((x, p), (y, q)) = (number(a, off, 0.0), number(b, -off, 1e-9));
        let [p, q] = [p, q].map(Interval::from);
        let agree = |x: Rounded, computed: f64, truth: Interval| {
            let off = exact(computed).at - truth;
            off.high() >= x.off.low() && off.low() <= x.off.high() && x.off.width() < 1e-11
        };
        prop_assert!(agree(x.sqrt(), a.sqrt(), p.sqrt()));
        prop_assert!(agree(Real::sin_cos(x).0, a.sin(), p.sin_cos().0));
        prop_assert!(agree(Real::sin_cos(x).1, a.cos(), p.sin_cos().1));
        prop_assert!(agree(x.atan2(y), a.atan2(b), p.atan2(q)));
        prop_assert!(agree(x.hypot(y), a.hypot(b), (p.square() + q.square()).sqrt()));
        prop_assert!(agree(Real::exp_and_exp_m1(-x).0, (-a).exp(), (-p).exp_and_exp_m1().0));
        prop_assert!(agree(Real::exp_and_exp_m1(-x).1, (-a).exp_m1(), (-p).exp_and_exp_m1().1));
        let (sine, cosine) = (exact(0.6) * x).sin_cos_of_quarter();
        let (s, c) = (0.6 * a).sin_cos_of_quarter();
        let angle = Interval::PI * exact(0.3).at * p;
        prop_assert!(agree(sine, s, angle.sin_cos().0) && agree(cosine, c, angle.sin_cos().1));
        let [power, less] = (x * 9.0).decay(exact(1e-20));
        let [f, g] = (a * 9.0).decay(1e-20);
        let (p, l) = (-(p * exact(9.0).at + exact(1e-20).at)).exp_and_exp_m1();
        prop_assert!(agree(power, f, p) && agree(less, g, l));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// The library itself, against the enclosure of the same floats' exact motion.
    #[test]
    fn what_is_measured_is_below_the_bound(body in 0..4_usize, part in 0.0..1.0_f64) {
        let (_, moments, omega) = motion::BODIES[body];
        let (enclosed, late) = motion::of_floats(moments, omega, 1.0).unwrap();
        let [i, j, k] = moments;
        let t = part * late;
        let here = point(t);
        let [spin, attitude] = bound(&moments.map(point).into(), &omega.map(point).into(), here).unwrap();
        let found = FreeMotion::new(PrincipalMoments::new(i, j, k).unwrap(), &omega.into()).unwrap().at(t).unwrap();
        let (w, turn) = enclosed.at(here);
        let apart = |x: f64, y: Interval| (point(x) - y).square();
        let total = |parts: [Interval; 3]| parts.into_iter().fold(Interval::zero(), |sum, x| sum + x).sqrt().low();
        prop_assert!(total([0, 1, 2].map(|n| apart(found.omega[n], w[n]))) <= spin);
        let q = found.attitude.coords;
        let sign = if turn.coords[3].low() + turn.coords[3].high() < 0.0 { -1.0 } else { 1.0 } * 1_f64.copysign(q[3]);
        prop_assert!(2.0 * total([0, 1, 2].map(|n| apart(sign * q[n], turn.coords[n]))) <= attitude);
    }
}

#[test]
fn no_bound_is_given_where_the_motion_or_a_sign_is_open() {
    assert!(bound_of_all([1.0, 2.0, 2.0 + 1e-13], [1.0, 2.0, 3.0], 1e-12, 1.0).is_err());
    assert!(bound_of_all([1.0, 2.0, 3.0], [1.0, 0.0, 3.0], 1e-12, 1.0).is_err());
}
