//! The laws that the numbers of this crate must obey, on random ones.

use crate::reader::read;
use nalgebra::{Quaternion, Vector3};
use num_traits::{One, Zero};
use proptest::prelude::*;
use tumbling::number::Field;
use tumbling::step::PositionStage;
use tumbling_proofs::{
    BigInt, BigRational, Derivation, Fraction, Monomial, Polynomial, Rational, Relations, Series, Symbol,
};

fn rational() -> impl Strategy<Value = Rational> {
    (-30_i64..30, 1_i64..12).prop_map(|(n, d)| Rational::new(n, d))
}

fn polynomial() -> impl Strategy<Value = Polynomial> {
    let power = || prop_oneof![3 => Just(0_u32), 2 => Just(1), 1 => Just(2), 1 => Just(3)];
    let term = (-9_i64..10, 1_i64..6, power(), power(), power()).prop_map(|(n, d, i, j, k)| {
        let powers = [("I1", i), ("omega2", j), ("x", k)];
        let monomial = powers.iter().fold(Monomial::default(), |m, (name, power)| {
            m.times(&Monomial::power(Symbol::new(name), *power))
        });
        Polynomial::term(monomial, BigRational::new(BigInt::from(n), BigInt::from(d)))
    });
    proptest::collection::vec(term, 0..5)
        .prop_map(|terms| terms.into_iter().fold(Polynomial::zero(), |sum, term| sum + term))
}

fn fraction() -> impl Strategy<Value = Fraction> {
    let nonzero = polynomial().prop_filter("a denominator of zero", |p| !p.is_zero());
    (polynomial(), nonzero).prop_map(|(n, d)| Fraction::new(n, d))
}

fn series() -> impl Strategy<Value = Series<Rational>> {
    proptest::collection::vec(rational(), 5).prop_map(|a| Series::new(a, 4))
}

fn ring_laws<T: Field>(a: &T, b: &T, c: &T) -> Result<(), TestCaseError> {
    let [a, b, c] = [a, b, c].map(|x| || x.clone());
    prop_assert_eq!((a() + b()) + c(), a() + (b() + c()));
    prop_assert_eq!(a() + b(), b() + a());
    prop_assert_eq!((a() * b()) * c(), a() * (b() * c()));
    prop_assert_eq!(a() * b(), b() * a());
    prop_assert_eq!(a() * (b() + c()), a() * b() + a() * c());
    prop_assert_eq!(a() + T::zero(), a());
    prop_assert_eq!(a() * T::one(), a());
    prop_assert!((a() + -a()).is_zero());
    prop_assert_eq!(a() - b(), a() + -b());
    let mut d = a();
    d += b();
    d *= c();
    d -= a();
    prop_assert_eq!(d, (a() + b()) * c() - a());
    Ok(())
}

fn field_laws<T: Field>(a: &T, b: &T) -> Result<(), TestCaseError> {
    let [a, b] = [a, b].map(|x| || x.clone());
    prop_assert_eq!((a() / b()) * b(), a());
    prop_assert_eq!(b() / b(), T::one());
    let mut c = a();
    c /= b();
    prop_assert_eq!(c, a() / b());
    Ok(())
}

/// A point that is no root of anything small.
fn point() -> [(&'static str, Rational); 3] {
    [("I1", Rational::new(101, 37)), ("omega2", Rational::new(-211, 53)), ("x", Rational::new(307, 71))]
}

proptest! {
    #[test]
    fn rationals_are_a_field(a in rational(), b in rational(), c in rational()) {
        ring_laws(&a, &b, &c)?;
        if !b.is_zero() {
            field_laws(&a, &b)?;
        }
    }

    #[test]
    fn fractions_are_a_field(a in fraction(), b in fraction(), c in fraction()) {
        ring_laws(&a, &b, &c)?;
        if !b.is_zero() {
            field_laws(&a, &b)?;
        }
    }

    #[test]
    fn series_are_a_field_but_for_divisors_that_start_at_zero(a in series(), b in series(), c in series()) {
        ring_laws(&a, &b, &c)?;
        if b.coefficient(0).is_some_and(|first| !first.is_zero()) {
            field_laws(&a, &b)?;
        } else {
            prop_assert!((a / b).is_undefined());
        }
    }

    #[test]
    fn the_value_of_a_sum_or_product_is_the_sum_or_product_of_values(p in polynomial(), q in polynomial()) {
        let at = |p: &Polynomial| p.at(&point());
        prop_assert_eq!(at(&(&p + &q)), at(&p) + at(&q));
        prop_assert_eq!(at(&(&p - &q)), at(&p) - at(&q));
        prop_assert_eq!(at(&(&p * &q)), at(&p) * at(&q));
        prop_assert_eq!(at(&p.pow(3)), at(&p) * at(&p) * at(&p));
    }

    #[test]
    fn the_value_of_a_fraction_is_the_fraction_of_values(p in fraction(), q in fraction()) {
        let at = |p: &Fraction| p.at(&point());
        prop_assume!(!at(&p).is_undefined() && !at(&q).is_undefined());
        prop_assert_eq!(at(&(&p + &q)), at(&p) + at(&q));
        prop_assert_eq!(at(&(&p * &q)), at(&p) * at(&q));
        if !at(&q).is_zero() {
            prop_assert_eq!(at(&(&p / &q)), at(&p) / at(&q));
        }
    }

    #[test]
    fn a_product_over_a_factor_is_the_other_factor(p in polynomial(), q in polynomial()) {
        prop_assume!(!q.is_zero());
        prop_assert_eq!((&p * &q).exact_quotient(&q), Some(p.clone()));
        // A remainder below every term of the divisor is noticed.
        if !q.is_one() && q.as_constant().is_none() {
            prop_assert_eq!((&p * &q + Polynomial::one()).exact_quotient(&q), None);
        }
    }

    #[test]
    fn derivatives_obey_the_product_and_quotient_rules(p in fraction(), q in fraction()) {
        let x = Symbol::new("x");
        let rate = |p: &Fraction| p.derivative(&x);
        prop_assert_eq!(rate(&(&p * &q)), rate(&p) * &q + &p * &rate(&q));
        if !q.is_zero() {
            prop_assert_eq!(rate(&(&p / &q)), (rate(&p) * &q - &p * &rate(&q)) / (&q * &q));
        }
    }

    #[test]
    fn an_integral_undoes_a_derivative(p in polynomial(), a in polynomial(), b in polynomial()) {
        let x = Symbol::new("x");
        prop_assert_eq!(p.antiderivative(&x).derivative(&x), p.clone());
        let rise = p.substitute(&x, &b) - p.substitute(&x, &a);
        prop_assert_eq!(p.derivative(&x).integral(&x, &a, &b), rise);
    }

    #[test]
    fn reducing_keeps_the_value_wherever_the_relation_holds(p in polynomial(), t in rational()) {
        // Every rational t gives a point of the circle: ((1 - t²)/(1 + t²), 2t/(1 + t²)).
        let circle = Relations::circle("I1", "x");
        let one = Rational::from(1);
        let square = &t * &t;
        let bottom = &one + &square;
        let values = [
            ("I1", (&one - &square) / bottom.clone()),
            ("x", (&t + &t) / bottom),
            ("omega2", Rational::new(5, 3)),
        ];
        let reduced = circle.reduce(&p);
        prop_assert!(reduced.degree_in(&"I1".into()) < 2);
        prop_assert_eq!(reduced.at(&values), p.at(&values));
        let multiple = &p * &(Polynomial::variable("I1").pow(2) + Polynomial::variable("x").pow(2) - Polynomial::one());
        prop_assert!(circle.reduce(&multiple).is_zero());
    }

    #[test]
    fn what_is_printed_reads_back_as_the_same(p in polynomial(), q in fraction()) {
        prop_assert_eq!(read(&p.to_string()), p.into());
        prop_assert_eq!(read(&q.to_string()), q);
    }

    #[test]
    fn a_common_sign_is_the_sign_at_positive_values(p in polynomial(), i in 1_i64..50, j in 1_i64..50, k in 1_i64..50) {
        let values = [("I1", Rational::new(i, 7)), ("omega2", Rational::new(j, 5)), ("x", Rational::new(k, 3))];
        if let Some(sign) = p.common_sign() {
            prop_assert!(p.at(&values) * Rational::from(i64::from(sign)) > Rational::from(0));
        }
    }
}

proptest! {
    // Fractions within fractions grow: fewer of them.
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn substituting_in_a_product_is_the_product_of_substituted(p in fraction(), q in fraction(), y in fraction()) {
        let put = |p: &Fraction| p.substitute(&"x".into(), &y);
        let (a, b) = (put(&p), put(&q));
        prop_assume!(!a.is_undefined() && !b.is_undefined());
        prop_assert_eq!(put(&(&p * &q)), a.clone() * b.clone());
        prop_assert_eq!(put(&(&p + &q)), a + b);
    }
}

#[test]
fn a_division_by_zero_spreads_and_equals_nothing() {
    let x = Fraction::variable("x");
    let lost = x.clone() / (x.clone() - x.clone());
    for spread in [
        lost.clone() + x.clone(),
        x.clone() - lost.clone(),
        lost.clone() * Fraction::zero(),
        Fraction::zero() / lost.clone(),
        x.clone() / lost.clone(),
        lost.derivative(&"x".into()),
        lost.substitute(&"x".into(), &Fraction::one()),
        lost.pow(0),
        -lost.clone(),
    ] {
        assert!(spread.is_undefined() && !spread.is_zero(), "{spread}");
        assert_ne!(spread, spread.clone());
    }
    let lost = Rational::new(1, 0);
    assert!((lost.clone() * Rational::zero()).is_undefined());
    assert!(lost.partial_cmp(&Rational::zero()).is_none());
    let h = Series::<Rational>::step(3);
    let lost = Series::one() / h.clone();
    assert!(lost.is_undefined() && (lost.clone() * Series::zero()).is_undefined() && lost != lost.clone());
    assert!((h / lost).is_undefined());
}

#[test]
fn a_bad_relation_is_refused() {
    let x = Polynomial::variable("x");
    let own = Relations::new(vec![("x", x.clone())]);
    assert_eq!(own.unwrap_err().to_string(), "the rule for x^2 brings x back");
    let round = Relations::new(vec![("x", Polynomial::variable("y")), ("y", x)]);
    assert_eq!(round.unwrap_err().to_string(), "the rule for y^2 brings x back");
    let twice = Relations::new(vec![("x", Polynomial::one()), ("x", Polynomial::zero())]);
    assert!(twice.is_err());
}

#[test]
fn the_relations_are_constant_under_their_own_derivations() {
    let rate = Derivation::elliptic(&Fraction::one());
    for constant in ["cn^2 + sn^2", "dn^2 + m sn^2"] {
        let constant = read(constant);
        assert!(rate.of(&constant).is_zero());
    }
    let hyperbolic = Relations::circle("sech", "tanh");
    let constant = read("sech^2 + tanh^2");
    assert!(hyperbolic.reduce_fraction(&Derivation::hyperbolic(&Fraction::one()).of(&constant)).is_zero());
}

/// The sum of what is added to the rate under the three roots, without signs, and the largest of the bends,
/// at the longest time for which the position stage takes a single part.
fn at_the_longest_part(moments: Vector3<f64>, spin: Vector3<f64>) -> (f64, f64) {
    let stage = PositionStage::new(&moments).unwrap();
    let alone = |h: f64| stage.step(&Quaternion::identity(), &spin, h).parts == 1;
    let (mut h, mut beyond) = (0.0, 1e9);
    while (beyond - h) / beyond > 1e-12 {
        let middle = if h == 0.0 { beyond / 2.0 } else { (h + beyond) / 2.0 };
        if alone(middle) { h = middle } else { beyond = middle }
    }
    let coupling = [0, 1, 2].map(|i| {
        let difference = moments[(i + 1) % 3] - moments[(i + 2) % 3];
        // About the length of a rod nothing turns the spin.
        if moments[i] == 0.0 { 0.0 } else { difference / moments[i] }
    });
    let turn = spin * h;
    let under = |i: usize| (coupling[(i + 1) % 3] * coupling[(i + 2) % 3] * turn[i] * turn[i]).abs();
    let bend = |i: usize| (coupling[i] * turn[(i + 1) % 3]).abs();
    ([0, 1, 2].map(under).iter().sum(), [0, 1, 2].map(bend).into_iter().fold(0.0, f64::max))
}

proptest! {
    /// On this rests that `position-stage-roots-are-real` speaks of every step: moments that no solid has,
    /// too.
    #[test]
    fn a_part_of_a_step_is_as_short_as_its_proof_assumes(
        moments in [-9.0..9.0_f64, -9.0..9.0, -9.0..9.0],
        rod in 0_usize..12,
        spin in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0],
        small in 0_usize..4,
    ) {
        let mut moments = Vector3::from(moments.map(f64::exp));
        let mut spin = Vector3::from(spin);
        if rod < 3 {
            moments = Vector3::repeat(moments.x);
            moments[rod] = 0.0;
        }
        if small < 3 {
            spin[small] *= 1e-6;
        }
        prop_assume!(spin.norm() > 1e-3);
        let (under, bend) = at_the_longest_part(moments, spin);
        prop_assert!(under <= 0.51 * 0.51, "{moments:?} {spin:?}: {under}");
        prop_assert!(bend <= 0.51, "{moments:?} {spin:?}: {bend}");
    }
}
