//! Elliptic functions against their definitions and a table computed with 1400 digits.

use super::*;
use crate::exact::cayley_klein::{ComplementaryPair, DirectPair, Pair, Shape};
use crate::number::functions::{cosh, exp, hypot};
use crate::number::power_of_two::{exponent, times_power_of_two};
use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::f64::consts::{FRAC_PI_2, PI, TAU};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
use proptest::prelude::*;
use serde_json::Value;

/// Half a unit in the last place, relative: the rounding of one number.
const ROUNDING: f64 = f64::EPSILON / 2.0;

fn table(part: &str) -> Vec<Vec<f64>> {
    let text = include_str!("../../../tests/data/elliptic.json");
    let file: Value = serde_json::from_str(text).unwrap();
    let number = |x: &Value| x.as_str().unwrap().parse::<f64>().unwrap();
    let row = |row: &Value| row.as_array().unwrap().iter().map(number).collect();
    file[part].as_array().unwrap().iter().map(row).collect()
}

/// Jacobi's three functions for one complementary modulus, by the series that an elliptic motion would take.
struct Jacobi {
    quarter: DoubleDouble,
    series: Series,
}

enum Series {
    Direct(DirectSeries),
    /// With `pi/(2K')` and the square root of the complementary nome.
    Complementary(ComplementarySeries, f64, f64),
}

#[derive(Debug)]
struct Values {
    sn: f64,
    cn: f64,
    dn: f64,
}

impl Jacobi {
    fn new(complement: f64) -> Self {
        let modulus = ((1.0 - complement) * (1.0 + complement)).sqrt();
        let root = DoubleDouble::from(complement).sqrt();
        let quarter = match complement {
            0.0 => DoubleDouble::from(f64::INFINITY),
            _ => quarter_period_from_root(DoubleDouble::from(complement), root),
        };
        let other = quarter_period(modulus);
        let ratio = other / quarter.hi();
        let series = if ratio >= NOME_RATIO {
            Series::Direct(DirectSeries::new(exp(-PI * ratio)))
        } else {
            let p = exp(-FRAC_PI_2 / ratio);
            Series::Complementary(ComplementarySeries::new(p * p, complement, 1.0), PI / (2.0 * other), p)
        };
        Self { quarter, series }
    }

    fn at(&self, u: f64) -> Values {
        let [sn, cn, dn] = match &self.series {
            Series::Direct(series) => {
                let (sin, cos) = sin_cos_of_turns(DoubleDouble::from(u) / (self.quarter * 4.0));
                series.values(sin, cos)
            }
            Series::Complementary(series, stretch, nome_root) => {
                let (halves, left) = (DoubleDouble::from(u) / (self.quarter * 2.0)).split();
                let returns = self.quarter.hi().is_finite();
                let v = if returns { self.quarter * 2.0 * left } else { DoubleDouble::from(u) };
                let near_saddle = v.abs().hi() > 0.5 * self.quarter.hi();
                let distance = if near_saddle { self.quarter - v.abs() } else { v.abs() };
                let x = Decay::new(distance.hi().max(0.0) * stretch, distance.lo() * stretch, *nome_root);
                let [sn, cn, dn] = series.values(&x, near_saddle);
                let turn = if halves % 2.0 == 0.0 { 1.0 } else { -1.0 };
                [turn * 1_f64.copysign(v.hi()) * sn, turn * cn, dn]
            }
        };
        Values { sn, cn, dn }
    }

    fn quarter_period(&self) -> f64 {
        self.quarter.hi()
    }
}

/// `R_F(x, y, z)`, homogeneous of degree -1/2: with the largest brought near 1.
fn carlson_rf(x: f64, y: f64, z: f64) -> f64 {
    let half = exponent(x.max(y).max(z)) / 2;
    let root = |a: f64| times_power_of_two(a, -2 * half).sqrt();
    times_power_of_two(rf_of_roots(root(x), root(y), root(z)), -half)
}

/// Each is right to 8 roundings of itself and of the argument, whatever it does to it: so the small ones next
/// to the saddle keep their digits, down to 1e-300.
#[test]
fn the_three_functions_agree_with_the_table_from_the_circle_to_the_separatrix() {
    for row in table("jacobi") {
        let [complement, u, sn, cn, dn] = row[..] else { panic!("five numbers") };
        let ours = Jacobi::new(complement).at(u);
        let square = 1.0 - complement * complement;
        for (ours, exact, derivative) in
            [(ours.sn, sn, cn * dn), (ours.cn, cn, sn * dn), (ours.dn, dn, square * sn * cn)]
        {
            let bound = 8.0 * ROUNDING * (exact.abs() + (u * derivative).abs());
            assert!((ours - exact).abs() <= bound, "k' = {complement:e}, u = {u}: {ours:e} {exact:e}");
        }
    }
}

#[test]
fn the_complete_integral_is_right_to_a_rounding_down_to_a_complement_of_1e_minus_300() {
    for row in table("complete") {
        let ours = Jacobi::new(row[0]).quarter_period();
        assert!((ours / row[1] - 1.0).abs() <= 2.0 * ROUNDING, "k' = {:e}: {ours} {}", row[0], row[1]);
    }
}

#[test]
fn carlsons_integral_agrees_with_the_table() {
    for row in table("carlson_rf") {
        let ours = carlson_rf(row[0], row[1], row[2]);
        assert!((ours / row[3] - 1.0).abs() <= 6.0 * ROUNDING, "{row:?}: {ours}");
    }
}

proptest! {
    #[test]
    fn the_squares_add_up(power in 0.0..300.0_f64, part in -6.0..6.0_f64) {
        let complement = 10_f64.powf(-power);
        let jacobi = Jacobi::new(complement);
        let at = jacobi.at(part * jacobi.quarter_period());
        prop_assert!((at.sn * at.sn + at.cn * at.cn - 1.0).abs() < 3e-15);
        // dn² = k'² + k² cn², all terms positive: so it holds relatively, where all of them are tiny too.
        let hypot = hypot(complement, (1.0 - complement * complement).sqrt() * at.cn);
        prop_assert!((at.dn / hypot - 1.0).abs() < 3e-15, "{at:?}");
    }
}

#[test]
fn without_a_modulus_they_are_the_circles_and_on_the_separatrix_hyperbolic() {
    assert_eq!(Jacobi::new(1.0).quarter_period(), FRAC_PI_2);
    assert_eq!(Jacobi::new(0.0).quarter_period(), f64::INFINITY);
    for u in [-3.0, -0.1, 0.0, 0.7, 2.0] {
        let (circle, limit) = (Jacobi::new(1.0).at(u), Jacobi::new(0.0).at(u));
        assert!((circle.sn - u.sin()).abs() < 1e-15 && (circle.cn - u.cos()).abs() < 1e-15);
        assert!((limit.sn - u.tanh()).abs() < 1e-15 && (limit.cn * cosh(u) - 1.0).abs() < 1e-15);
    }
    // R_F(x, x, x) = 1/sqrt(x), to the ends of the range.
    for x in [f64::MAX, 1e300, 1e-300, 5e-324] {
        assert!((carlson_rf(x, x, x) * x.sqrt() - 1.0).abs() < 1e-15, "{x:e}");
    }
}

/// At small arguments `sn u` is `u` itself, however small.
#[test]
fn the_smallest_arguments_are_their_own_sines() {
    for complement in [0.01, 0.1, 0.2, 0.3, 0.4, 0.5, 0.9] {
        for u in [1e-9, 1e-12, 1e-16, 1e-17, 1e-30, 1e-300] {
            let off = Jacobi::new(complement).at(u).sn / u - 1.0;
            assert!(off.abs() < 2e-15, "{complement} {u:e}: {off:e}");
        }
    }
}

/// Signed errors in roundings: of one value, the worst and the mean over the rows of the table.
#[derive(Default)]
struct Errors {
    worst: f64,
    sum: f64,
    count: f64,
}

impl Errors {
    fn add(&mut self, ours: f64, truth: &Value, size: f64) {
        // The digits beyond an f64 matter here.
        let text = truth.as_str().unwrap();
        let near: f64 = text.parse().unwrap();
        let off = ((ours - near) - beyond(text, near)) / (size * ROUNDING);
        self.worst = self.worst.max(off.abs());
        self.sum += off;
        self.count += 1.0;
    }
}

/// A decimal number less the `f64` next to it.
fn beyond(text: &str, near: f64) -> f64 {
    let exact = |text: &str| {
        let (digits, power) = text.split_once('e').map_or((text, 0), |(d, p)| (d, p.parse().unwrap()));
        let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
        let number: num_bigint::BigInt = format!("{whole}{part}").parse().unwrap();
        let ten = |n: i32| num_rational::BigRational::from_integer(10.into()).pow(n);
        num_rational::BigRational::from_integer(number) * ten(power - part.len() as i32)
    };
    let rest = exact(text) - num_rational::BigRational::from_float(near).unwrap();
    num_traits::ToPrimitive::to_f64(&rest).unwrap()
}

/// All that is summed in either series, next to the border at which the other takes over, where it is
/// longest: every constant and every sum to 40 digits. A term that is left out shows in the mean over
/// many nomes, where roundings cancel.
#[test]
fn at_the_border_no_sum_leaves_out_more_than_a_part_of_a_rounding() {
    let table: Value = serde_json::from_str(include_str!("../../../tests/data/border.json")).unwrap();
    let mut errors: BTreeMap<String, Errors> = BTreeMap::new();
    let mut compare = |name: &str, ours: &[f64], truth: &[Value], size: Option<f64>| {
        for (k, (&ours, truth)) in ours.iter().zip(truth).enumerate() {
            errors.entry(format!("{name} {k}")).or_default().add(ours, truth, size.unwrap_or(ours.abs()));
        }
    };
    let list = |x: &Value| x.as_array().unwrap().clone();
    let rows = |name: &str| table[name].as_array().unwrap().clone();
    let input = |x: &Value| x.as_str().unwrap().parse::<f64>().unwrap();
    for row in rows("direct") {
        let series = DirectSeries::new(input(&row[0]));
        compare("direct sum", &series.thetas(input(&row[1])), &list(&row[2]), None);
        compare("direct factor", &series.factors, &list(&row[3]), None);
    }
    for row in rows("complementary") {
        let (root, x) = (input(&row[0]), input(&row[1]));
        let series = ComplementarySeries::new(root * root, 1.0, 1.0);
        compare("complementary sum", &series.sums_of(&Decay::new(x, 0.0, root)), &list(&row[2]), None);
        compare("near", &series.near_flip, &list(&row[3]), None);
        compare("far", &series.near_saddle, &list(&row[4]), None);
    }
    let shape = |depth: f64| Shape { cyclic: true, forward: true, tilt: 1.0, depth };
    for row in rows("direct_pair") {
        let pair = DirectPair::of_shape(input(&row[0]), &shape(input(&row[1])));
        let Pair { a: [w, x], b: [y, z] } = pair.raw(input(&row[2]), input(&row[3]));
        compare("direct pair", &[w, x, y, z], &list(&row[4]), Some(1.0));
        compare("direct turning", &[pair.turning_at_zero()], &[row[5].clone()], Some(1.0));
    }
    for row in rows("complementary_pair") {
        let [root, depth, e] = [0, 1, 2].map(|k| input(&row[k]));
        let pair = ComplementaryPair::of_shape(root, &shape(depth));
        let Pair { a: [w, x], b: [y, z] } = pair.raw(e, root / e, 1.0, 1.0);
        compare("complementary pair", &[w, x, y, z], &list(&row[3]), Some(1.0));
        let (angle, turning) = (pair.angle_at_saddle(), pair.turning_at_saddle());
        compare("angle at the saddle", &[angle], &[row[4].clone()], Some(1.0));
        compare("turning at the saddle", &[turning], &[row[5].clone()], Some(1.0));
    }
    assert_eq!(errors.len(), 4 + 3 + 4 + 3 + 3 + 4 + 1 + 4 + 2);
    for (name, Errors { worst, sum, count }) in errors {
        let mean = sum / count;
        assert!(worst < 5.0 && mean.abs() < 1.0, "{name}: {worst} roundings, {mean} in the mean");
    }
}

proptest! {
    // Independent: the platform's own sine and cosine.
    #[test]
    fn sine_and_cosine_of_turns_are_those_of_the_angle(turns in -0.6_f64..0.6) {
        let (sin, cos) = sin_cos_of_turns(DoubleDouble::from(turns));
        let (s, c) = (turns * TAU).sin_cos();
        prop_assert!((sin - s).abs() < 1e-15 && (cos - c).abs() < 1e-15, "{sin} {s} {cos} {c}");
    }

    #[test]
    fn whole_turns_change_nothing(turns in -0.5_f64..0.5, whole in -(1_i64 << 40)..(1 << 40)) {
        let many = DoubleDouble::sum(whole as f64, turns);
        prop_assert_eq!(sin_cos_of_turns(many), sin_cos_of_turns(DoubleDouble::from(turns)));
    }
}

#[test]
fn quarter_turns_are_exact_and_their_neighbours_keep_all_digits() {
    assert_eq!(sin_cos_of_turns(DoubleDouble::from(0.25)), (1.0, 0.0));
    assert_eq!(sin_cos_of_turns(DoubleDouble::from(-0.25)), (-1.0, 0.0));
    assert_eq!(sin_cos_of_turns(DoubleDouble::from(7.5)).1, -1.0);
    let beyond = 2_f64.powi(-50);
    let (_, cos) = sin_cos_of_turns(DoubleDouble::sum(1e6 + 0.25, beyond));
    assert!((cos / (-TAU * beyond) - 1.0).abs() < 1e-15, "{cos}");
}
