//! The remainder of each series, and the bound on it that the library states: its code runs on numbers that
//! are exact except for these remainders, and is compared with sums of many more terms.

use num_rational::BigRational as Exact;
use num_traits::{Signed, ToPrimitive, Zero};
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, PI};
use tumbling::laws::{
    ComplementaryPair, ComplementarySeries, DirectPair, DirectSeries, Lane, Rounding, Series,
};
use tumbling_proofs::field;

/// An exact number, and a bound on the effect of the remainders on it. Both are never freed, since a lane
/// must be `Copy`.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bounded(&'static [Exact; 2]);

thread_local! {
    /// The number of remainders that are still omitted.
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

field!(Bounded, exact, and floats);

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

impl Rounding for Bounded {
    fn nearest(self) -> Self {
        self.round_ties_even()
    }
}

/// Checks that no result differs from the truth by more than its remainders, and that at each place the
/// largest remainder is below rounding, and at most ten times the largest difference.
fn rests_hold<const N: usize>(name: &str, found: &[([Bounded; N], [Exact; N])]) {
    for n in 0..N {
        let [mut most, mut largest] = [Exact::zero(), Exact::zero()];
        for (sums, truths) in found {
            let [middle, rest] = sums[n].0;
            let off = (middle - &truths[n]).abs();
            let numbers = [&off, rest].map(|x| x.to_f64().unwrap());
            assert!(&off <= rest, "{name} {n}: off by {:e}, with a rest of {:e}", numbers[0], numbers[1]);
            (most, largest) = (most.max(rest.clone()), largest.max(off));
        }
        let size = found.iter().map(|(_, truths)| truths[n].abs()).max().unwrap();
        let rounding = size * ratio(1, 2).pow(53) + float(1e-300);
        assert!(most <= rounding, "{name} {n}: a rest of {:e}", most.to_f64().unwrap());
        let times = (&most / &largest).to_f64().unwrap();
        assert!(times <= 10.0, "{name} {n}: the largest rest is {times} times the largest difference");
    }
}

/// The sum of a power series, whose terms are each the one before times `next(n)`.
fn series(first: Exact, next: impl Fn(i64) -> Exact) -> Exact {
    let mut terms = vec![first];
    (1..32).for_each(|n| terms.push(terms.last().unwrap() * next(n)));
    terms.into_iter().sum()
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
    let near = |k: i64| {
        let x = ratio(k, 64);
        let truth = series(ratio(1, 1), |n| -&x * ratio(1, n));
        (given(&x).decay(exact(0.0)), [truth.clone(), truth - ratio(1, 1)])
    };
    rests_hold("exponential", &(0..=22).map(near).collect::<Vec<_>>());
    // Whole powers of two, where nothing is left but what the parts of the logarithm lack.
    for n in [1, 5, 28] {
        let x = arctangent(3, 1) * ratio(2 * n, 1);
        let main = float(x.to_f64().unwrap());
        let [power, _] = given(&main).decay(given(&(x - &main)));
        rests_hold("logarithm", &[([power], [ratio(1, 2).pow(n as i32)])]);
    }
    // Beyond what is computed the exponential is zero here.
    rests_hold("far out", &[(exact(800.0).decay(exact(0.0)), [0, -1].map(|n| ratio(n, 1)))]);
}

#[test]
fn sine_and_cosine_of_a_part_of_a_turn_leave_out_no_more_than_their_rests() {
    let quarter = arctangent(5, -1) * ratio(8, 1) - arctangent(239, -1) * ratio(2, 1);
    // The last bits of the circle's constant; then, without them, the sums.
    for (left_out, quarter) in [(0, quarter), (1, float(FRAC_PI_2))] {
        let at = |k: i64| {
            let part = ratio(k, 16);
            LEFT_OUT.set(left_out);
            let (sine, cosine) = given(&part).sin_cos_of_quarter();
            let x = part * &quarter;
            let next = |n: i64| -(&x * &x) * ratio(1, n * (n + 1));
            let waves = [series(x.clone(), |n| next(2 * n)), series(ratio(1, 1), |n| next(2 * n - 1))];
            ([sine, cosine], waves)
        };
        rests_hold("part of a turn", &(1..=8).map(at).collect::<Vec<_>>());
    }
}

/// The sum over `n` from zero of `q^(a n² + b n) (x^-n + sign x^(n + b/a)) w_n`, the odd ones times
/// `alternating`, and where `b` is zero the first by half; with weights, of its derivative by `-log x`.
fn theta(
    [alternating, sign]: [i64; 2],
    (q, a, b): (&Exact, i32, i32),
    (x, weigh): (&Exact, i32),
    w: &[Exact],
) -> Exact {
    let of = |n: i32| {
        let size = |n: i32| ratio(n.into(), 1).pow(weigh) * x.pow(-n);
        let both = (size(n) + size(-n - b / a) * ratio(sign, 1)) / ratio(1 + i64::from(n == 0 && b == 0), 1);
        q.pow(a * n * n + b * n) * both * &w[n as usize] * ratio(alternating, 1).pow(n)
    };
    (0..14).map(of).sum()
}

/// `w_0`, `w_1` and so on, of which each is `twice` the one before less the one before that.
fn waves(before: Exact, first: Exact, twice: &Exact) -> Vec<Exact> {
    let mut all = vec![before, first];
    (1..20).for_each(|n| all.push(twice * &all[n] - &all[n - 1]));
    all.split_off(1)
}

/// Of angles from 0 to a quarter turn sine and cosine, then cosine and sine of the double; cosines and sines
/// of all even multiples, and sines and cosines of all odd ones.
fn angles() -> impl Iterator<Item = ([[Exact; 2]; 2], [Vec<Exact>; 4])> {
    (0..=6).map(|k| {
        let (one, two, t) = (ratio(1, 1), ratio(2, 1), ratio(k * k, 36));
        let length = &one + &t * &t;
        let [sin, cos] = [&two * &t / &length, (&one - &t * &t) / &length];
        let [c, s] = [&cos * &cos - &sin * &sin, &two * &sin * &cos];
        let of = |before: &Exact, first: &Exact| waves(before.clone(), first.clone(), &(&c * &two));
        let all = [of(&c, &one), of(&-&s, &Exact::zero()), of(&-&sin, &sin), of(&cos, &cos)];
        ([[sin, cos], [c, s]], all)
    })
}

/// The largest nome of a series, rounded up, by its logarithm at the library's border between both, and two
/// smaller ones.
fn nomes(log_at: fn(f64) -> f64) -> [(Exact, Exact); 3] {
    let source = include_str!("../../../../src/exact/elliptic.rs");
    let number = source.split("NOME_RATIO: f64 = ").nth(1).and_then(|rest| rest.split(';').next());
    let largest = (log_at(number.unwrap().parse().unwrap()).exp() * 1e4).ceil() as i64;
    [(largest, 10_000), (3, 100), (1, 1000)].map(|(a, b)| (ratio(a, b), ratio(1, 1)))
}

#[test]
fn the_direct_sums_leave_out_no_more_than_their_rests() {
    for (q, one) in nomes(|border| -PI * border) {
        let sums = DirectSeries::new(given(&q));
        let at = |([_, [c, _]], [even, ..]): ([[Exact; 2]; 2], [Vec<Exact>; 4])| {
            let both = |sign: i64| theta([sign, 1], (&q, 1, 0), (&one, 0), &even);
            // Sines and cosines of the odd multiples, over the first.
            let odd = |sign: i64| {
                let w = waves(ratio(sign, 2), ratio(1, 2), &(&c * ratio(2, 1)));
                theta([sign, 1], (&q, 1, 1), (&one, 0), &w)
            };
            (sums.thetas(given(&c)), [both(1), both(-1), odd(1), odd(-1)])
        };
        rests_hold("direct sums", &angles().map(at).collect::<Vec<_>>());
    }
}

#[test]
fn the_direct_pair_leaves_out_no_more_than_its_rests() {
    for (q, one) in nomes(|border| -PI * border) {
        let mut found = Vec::new();
        // From no depth to the greatest, and both orders of the axes.
        for (f, sense) in [(one.clone(), 1), (ratio(1, 2), -1), (q.clone(), 1), (q.clone(), -1)] {
            let sense = ratio(sense, 1);
            let fall = [&f, &(&f - &one)].map(given);
            let pair = DirectPair::new(given(&q), fall, given(&(&q / &f)), given(&sense));
            for ([angle, double], [even, even_sine, sine, cosine]) in angles() {
                let of = |b: i32, sign: i64, w: &[Exact]| theta([-1, sign], (&q, 2, b), (&f, 0), w);
                let [turned, along] = [&sense * of(0, -1, &even_sine), -&sense * of(2, -1, &cosine)];
                let sums = pair.sums(double.each_ref().map(given), angle.each_ref().map(given));
                found.push((sums, [of(0, 1, &even), turned, of(2, 1, &sine), along]));
            }
        }
        rests_hold("direct pair", &found);
    }
}

#[test]
fn the_complementary_sums_leave_out_no_more_than_their_rests() {
    for (root, one) in nomes(|border| -FRAC_PI_2 / border) {
        let p = &root * &root;
        let of = |sign: i64, both: i64, b: i32, e: &Exact| {
            theta([sign, both], (&p, 1, b), (e, 0), &[(); 20].map(|()| ratio(1, 1)))
        };
        let truth = [of(1, 1, 1, &one) / ratio(2, 1), of(1, 1, 0, &one), of(-1, 1, 0, &one)];
        rests_hold("constants", &[(ComplementarySeries::constants(given(&p)), truth)]);
        let sums = ComplementarySeries::new(given(&p), exact(1.0), exact(1.0));
        // From the flip to the middle between it and the saddle.
        let at = |k: i64| {
            let e = &root + (&one - &root) * ratio(k, 5);
            let found = sums.sums(given(&e), given(&(&one - &e)), given(&(&p / &e)));
            (found, [of(-1, -1, 1, &e), of(1, 1, 1, &e), of(-1, 1, 0, &e), of(1, 1, 0, &e)])
        };
        rests_hold("complementary sums", &(0..=5).map(at).collect::<Vec<_>>());
    }
}

#[test]
fn the_complementary_pair_leaves_out_no_more_than_its_rests() {
    for (p, one) in nomes(|border| -FRAC_PI_2 / border) {
        let (mut found, mut at_saddle) = (Vec::new(), Vec::new());
        for (([[sin, cos], _], [_, _, sine, cosine]), sense) in angles().zip([1, -1].into_iter().cycle()) {
            let waves = ComplementaryPair::waves(given(&sin), given(&cos));
            let pair = ComplementaryPair::new(given(&p), waves, exact(sense as f64));
            let turned = sine.iter().map(|x| x * ratio(-sense, 1)).collect::<Vec<_>>();
            for k in 0..=5 {
                let e = &p + (&one - &p) * ratio(k, 5);
                let of = |signs: [i64; 2], weigh: i32, w: &[Exact]| theta(signs, (&p, 1, 1), (&e, weigh), w);
                let a = |weigh: i32| [of([1, 1], weigh, &cosine), of([1, -1], weigh, &turned)];
                let b = [of([-1, -1], 0, &cosine), of([-1, 1], 0, &turned)];
                let sums = pair.sums(given(&e), given(&(&p * &p / &e)));
                found.push((sums, [a(0), b].concat().try_into().unwrap()));
                if k == 0 {
                    let ([re, im], [d_re, d_im]) = (a(0), a(1));
                    let square = &re * &re + &im * &im;
                    at_saddle.push(([pair.turning_at_saddle()], [(re * d_im - im * d_re) / square]));
                }
            }
        }
        rests_hold("complementary pair", &found);
        rests_hold("at the saddle", &at_saddle);
    }
}
