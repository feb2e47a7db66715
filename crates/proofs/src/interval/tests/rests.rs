//! What each series leaves out, and what the library says that this is at most: its code runs on numbers that
//! are exact but for these rests, and is compared with sums of many more terms.

use crate::interval::real::field;
use num_rational::BigRational as Exact;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cell::Cell;
use std::f64::consts::TAU;
use tumbling::laws::{ComplementaryPair, ComplementarySeries, DirectPair, DirectSeries};
use tumbling::number::{Lane, Series};

/// An exact number, and how much the rests can change it. Both are never freed, since a lane must be `Copy`.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bounded(&'static [Exact; 2]);

thread_local! {
    /// How many rests are still left out.
    static LEFT_OUT: Cell<usize> = const { Cell::new(0) };
}

fn bounded(middle: Exact, rest: Exact) -> Bounded {
    Bounded(Box::leak(Box::new([middle, rest])))
}

fn given(x: &Exact) -> Bounded {
    bounded(x.clone(), Exact::zero())
}

fn exact(x: f64) -> Bounded {
    given(&float(x))
}

fn float(x: f64) -> Exact {
    Exact::from_float(x).unwrap()
}

fn ratio(a: i64, b: i64) -> Exact {
    Exact::new(a.into(), b.into())
}

field!(Bounded, exact);

impl Bounded {
    fn plus(self, other: Self) -> Self {
        let ([a, r], [b, s]) = (self.0, other.0);
        bounded(a + b, r + s)
    }
    fn minus(self) -> Self {
        bounded(-&self.0[0], self.0[1].clone())
    }
    fn times(self, other: Self) -> Self {
        let ([a, r], [b, s]) = (self.0, other.0);
        bounded(a * b, a.abs() * s + r * b.abs() + r * s)
    }
    fn over(self, other: Self) -> Self {
        let ([a, r], [b, s]) = (self.0, other.0);
        assert!(&b.abs() > s);
        bounded(a / b, (r * b.abs() + a.abs() * s) / (b.abs() * (b.abs() - s)))
    }
    fn zero_for_certain(&self) -> bool {
        self.0.iter().all(Exact::is_zero)
    }
}

impl Series for Bounded {
    fn up_to(self, rest: impl FnOnce() -> Self) -> Self {
        if LEFT_OUT.get() > 0 {
            LEFT_OUT.set(LEFT_OUT.get() - 1);
            return self;
        }
        let [a, r] = rest().0;
        bounded(self.0[0].clone(), &self.0[1] + a.abs() + r)
    }
}

impl Lane for Bounded {
    type Mask = bool;
    const WIDTH: usize = 1;
    fn from_lanes(mut of: impl FnMut(usize) -> f64) -> Self {
        exact(of(0))
    }
    fn lane(&self, _: usize) -> f64 {
        self.0[0].to_f64().unwrap()
    }
    fn lt(self, other: Self) -> bool {
        self.0[0] < other.0[0]
    }
    fn any(mask: bool) -> bool {
        mask
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    fn abs(self) -> Self {
        bounded(self.0[0].abs(), self.0[1].clone())
    }
    fn sign(self) -> Self {
        exact(1_f64.copysign(self.lane(0)))
    }
    fn round_ties_even(self) -> Self {
        exact(self.lane(0).round_ties_even())
    }
    fn sqrt(self) -> Self {
        unreachable!("no series takes a root")
    }
    fn two_product_error(self, _: Self, _: Self) -> Self {
        unreachable!("no series needs what rounding left")
    }
}

/// That all results differ from the truth by no more than their rests, and that the largest rest is at most
/// ten times the largest difference.
fn rests_hold(name: &str, found: Vec<(Bounded, Exact)>) {
    let [mut most, mut largest] = [Exact::zero(), Exact::zero()];
    for (sum, truth) in found {
        let [middle, rest] = sum.0;
        let off = (middle - truth).abs();
        let numbers = [&off, rest].map(|x| x.to_f64().unwrap());
        assert!(&off <= rest, "{name}: off by {:e}, with a rest of {:e}", numbers[0], numbers[1]);
        (most, largest) = (most.max(rest.clone()), largest.max(off));
    }
    let times = (&most / &largest).to_f64().unwrap();
    assert!(times <= 10.0, "{name}: the largest rest is {times} times the largest difference");
}

/// [`rests_hold`] for each place of the arrays.
fn all_rests_hold<const N: usize>(name: &str, found: &[([Bounded; N], [Exact; N])]) {
    for n in 0..N {
        rests_hold(&format!("{name}, {n}"), found.iter().map(|(a, b)| (a[n], b[n].clone())).collect());
    }
}

/// The power series `sum_n c_n`, with `c_0 = first` and each term the one before times `next(n)`.
fn series(first: Exact, next: impl Fn(i64) -> Exact) -> Exact {
    let (mut sum, mut term) = (Exact::zero(), first);
    for n in 1..32 {
        sum += &term;
        term *= next(n);
    }
    sum
}

fn sin_cos_exact(x: &Exact) -> [Exact; 2] {
    let squared = -(x * x);
    let from = |k: i64| move |n: i64| ratio(1, (2 * n + k - 1) * (2 * n + k));
    let wave = |first: Exact, k: i64| series(first, |n| &squared * from(k)(n));
    [wave(x.clone(), 1), wave(Exact::one(), 0)]
}

/// The exponential of a small number.
fn exp_exact(x: &Exact) -> Exact {
    series(Exact::one(), |n| x * ratio(1, n))
}

/// The arctangent of `1/n` for `sign = -1`, the hyperbolic one for 1: to 200 bits, so that what is made of it
/// stays short.
fn arctangent(n: i64, sign: i64) -> Exact {
    let term = |k: i64| ratio(sign.pow(k as u32), 2 * k + 1) * ratio(1, n).pow(2 * k as i32 + 1);
    let unit = ratio(1, 2).pow(200);
    ((0..70).map(term).sum::<Exact>() / &unit).round() * unit
}

#[test]
fn the_exponential_leaves_out_no_more_than_its_rest() {
    // All numbers whose nearest power of two is 1.
    let found: Vec<_> = (0..=22)
        .map(|k| {
            let x = ratio(k, 64);
            let truth = exp_exact(&-&x);
            (given(&x).decay(exact(0.0)), [truth.clone(), truth - Exact::one()])
        })
        .collect();
    all_rests_hold("exponential", &found);
    // Whole powers of two, where nothing is left but what the parts of the logarithm lack.
    let log = arctangent(3, 1) * ratio(2, 1);
    for n in [1, 5, 28] {
        let x = &log * ratio(n, 1);
        let main = float(x.to_f64().unwrap());
        let [power, _] = given(&main).decay(given(&(x - &main)));
        rests_hold("logarithm", vec![(power, ratio(1, 2).pow(n as i32))]);
    }
    // Beyond what is computed: exp(-800) is zero here.
    let far = exact(800.0).decay(exact(0.0));
    rests_hold("far out", vec![(far[0], Exact::zero())]);
    assert!(far[1].0[1] >= far[0].0[1]);
}

#[test]
fn sine_and_cosine_of_a_part_of_a_turn_leave_out_no_more_than_their_rests() {
    let two_pi = arctangent(5, -1) * ratio(32, 1) - arctangent(239, -1) * ratio(8, 1);
    let parts = |left_out: usize, turn: &Exact, of: i64| -> Vec<([Bounded; 2], [Exact; 2])> {
        let at = |k: i64| {
            let part = ratio(k, of);
            LEFT_OUT.set(left_out);
            let (sine, cosine) = given(&part).sin_cos_of_part();
            ([sine, cosine], sin_cos_exact(&(part * turn)))
        };
        (1..=8).map(at).collect()
    };
    // The last bits of the circle's constant; then, without them, the sums.
    all_rests_hold("part of a turn", &parts(0, &two_pi, 64));
    all_rests_hold("series", &parts(1, &float(TAU), 64));
}

/// Enough of `terms(n)`, the odd ones negative where `sign` is.
fn sum(sign: i64, terms: impl Fn(usize) -> Exact) -> Exact {
    (0..14).map(|n| terms(n) * ratio(sign, 1).pow(n as i32)).sum()
}

/// `w_0`, `w_1` and so on, of which each is `twice` the one before less the one before that.
fn waves(before: Exact, first: Exact, twice: &Exact) -> Vec<Exact> {
    let mut all = vec![before, first];
    for n in 1..20 {
        all.push(twice * &all[n] - &all[n - 1]);
    }
    all.split_off(1)
}

/// Sines and cosines of angles from 0 to a quarter turn.
fn angles() -> impl Iterator<Item = [Exact; 2]> {
    (0..=6).map(|k| {
        let t = ratio(k, 6);
        let square = &t * &t;
        let length = Exact::one() + &square;
        [ratio(2, 1) * t / &length, (Exact::one() - square) / length]
    })
}

/// Cosine and sine of `2z`; then cosines and sines of all `2nz`, and sines and cosines of all `(2n+1)z`.
fn double([sin, cos]: &[Exact; 2]) -> ([Exact; 2], [Vec<Exact>; 4]) {
    let (c, s) = (cos * cos - sin * sin, ratio(2, 1) * sin * cos);
    let twice = &c * ratio(2, 1);
    let all = [
        waves(c.clone(), Exact::one(), &twice),
        waves(-s.clone(), Exact::zero(), &twice),
        waves(-sin.clone(), sin.clone(), &twice),
        waves(cos.clone(), cos.clone(), &twice),
    ];
    ([c, s], all)
}

/// Nomes up to the largest of the direct series, exp(-0.775 pi) = 0.08762.
fn nomes() -> [Exact; 3] {
    [ratio(877, 10_000), ratio(3, 100), ratio(1, 1000)]
}

/// Roots of complementary nomes up to the largest, exp(-pi/1.55) = 0.13176.
fn roots() -> [Exact; 3] {
    [ratio(1318, 10_000), ratio(5, 100), ratio(1, 1000)]
}

fn power(x: &Exact, n: usize) -> Exact {
    x.pow(n as i32)
}

#[test]
fn the_direct_sums_leave_out_no_more_than_their_rests() {
    for q in nomes() {
        let sums = DirectSeries::new(given(&q));
        let both =
            |sign: i64, w: &[Exact]| sum(sign, |n| power(&q, n * n) * &w[n] * ratio(2, 1)) - Exact::one();
        let odd = |sign: i64, w: &[Exact]| sum(sign, |n| power(&q, n * (n + 1)) * &w[n]);
        let found: Vec<_> = angles()
            .map(|angle| {
                let ([c, _], [even, ..]) = double(&angle);
                // Sines and cosines of the odd multiples, over the first.
                let [sine, cosine] = [-1, 1].map(|n| waves(ratio(n, 1), Exact::one(), &(&c * ratio(2, 1))));
                let truth = [both(1, &even), both(-1, &even), odd(1, &cosine), odd(-1, &sine)];
                (sums.thetas(given(&c)), truth)
            })
            .collect();
        all_rests_hold("direct sums", &found);
    }
}

#[test]
fn the_direct_pair_leaves_out_no_more_than_its_rests() {
    for q in nomes() {
        let mut found = Vec::new();
        // From no depth to the greatest, and both orders of the axes.
        for (f, sense) in [(ratio(1, 1), 1), (ratio(1, 2), -1), (q.clone(), 1), (q.clone(), -1)] {
            let sense = ratio(sense, 1);
            let less = &f - Exact::one();
            let pair = DirectPair::new(given(&q), [&f, &less].map(given), given(&(&q / &f)), given(&sense));
            let fall = |n: usize, sign: i64, more: usize| {
                power(&f, n).recip() + power(&f, n + more) * ratio(sign, 1)
            };
            for angle in angles() {
                let (doubled, [even, even_sine, sine, cosine]) = double(&angle);
                let outer =
                    |sign: i64, w: &[Exact]| sum(-1, |n| power(&q, 2 * n * n) * fall(n, sign, 0) * &w[n]);
                let inner = |sign: i64, w: &[Exact]| {
                    sum(-1, |n| power(&q, 2 * n * (n + 1)) * fall(n, sign, 1) * &w[n])
                };
                let truth = [
                    outer(1, &even) - Exact::one(),
                    &sense * outer(-1, &even_sine),
                    inner(1, &sine),
                    -&sense * inner(-1, &cosine),
                ];
                found.push((pair.sums(doubled.each_ref().map(given), angle.each_ref().map(given)), truth));
            }
        }
        all_rests_hold("direct pair", &found);
    }
}

#[test]
fn the_complementary_sums_leave_out_no_more_than_their_rests() {
    for root in roots() {
        let p = &root * &root;
        let plain = |sign: i64| sum(sign, |n| power(&p, n * n) * ratio(2, 1)) - Exact::one();
        let second = sum(1, |n| power(&p, n * (n + 1)));
        let constants = ComplementarySeries::constants(given(&p));
        all_rests_hold("constants", &[(constants, [second, plain(1), plain(-1)])]);
        let sums = ComplementarySeries::new(given(&p), exact(1.0), exact(1.0));
        // From the flip to the middle between it and the saddle.
        let found: Vec<_> = (0..=5)
            .map(|k| {
                let e = &root + (Exact::one() - &root) * ratio(k, 5);
                let odd = |sign: i64| {
                    let wave = |n| power(&e, n).recip() + power(&e, n + 1) * ratio(sign, 1);
                    sum(sign, |n| power(&p, n * (n + 1)) * wave(n))
                };
                let even = |sign: i64| {
                    let wave = |n| power(&e, n).recip() + power(&e, n);
                    sum(sign, |n| power(&p, n * n) * wave(n)) - Exact::one()
                };
                let less = Exact::one() - &e;
                let found = sums.sums(given(&e), given(&less), given(&(&p / &e)));
                (found, [odd(-1), odd(1), even(-1), even(1)])
            })
            .collect();
        all_rests_hold("complementary sums", &found);
    }
}

#[test]
fn the_complementary_pair_leaves_out_no_more_than_its_rests() {
    for p in roots() {
        let (mut found, mut at_saddle) = (Vec::new(), Vec::new());
        for (angle, sense) in angles().zip([1, -1].into_iter().cycle()) {
            let (_, [_, _, sine, cosine]) = double(&angle);
            let [sin, cos] = angle.each_ref().map(given);
            let pair =
                ComplementaryPair::new(given(&p), ComplementaryPair::waves(sin, cos), exact(sense as f64));
            let sense = ratio(sense, 1);
            for k in 0..=5 {
                let e = &p + (Exact::one() - &p) * ratio(k, 5);
                // With the weights of the terms, to differentiate.
                let total = |alternating: i64, sign: i64, w: &[Exact], weigh: usize| {
                    let weight = |n: usize| ratio(n as i64, 1).pow(weigh as i32);
                    let term = |n| {
                        weight(n) * power(&e, n).recip() + weight(n + 1) * power(&e, n + 1) * ratio(sign, 1)
                    };
                    sum(alternating, |n| power(&p, n * (n + 1)) * term(n) * &w[n])
                };
                let truth = [
                    total(1, 1, &cosine, 0),
                    -&sense * total(1, -1, &sine, 0),
                    total(-1, -1, &cosine, 0),
                    -&sense * total(-1, 1, &sine, 0),
                ];
                if k == 0 {
                    let [a, change] = pair.at_saddle();
                    let rates = [total(1, -1, &cosine, 1), -&sense * total(1, 1, &sine, 1)];
                    let [re, im, ..] = truth.clone();
                    let [d_re, d_im] = rates;
                    at_saddle.push(([a[0], a[1], change[0], change[1]], [re, im, d_re, d_im]));
                }
                found.push((pair.sums(given(&e), given(&(&p * &p / &e))), truth));
            }
        }
        all_rests_hold("complementary pair", &found);
        all_rests_hold("at the saddle", &at_saddle);
    }
}
