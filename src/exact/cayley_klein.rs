//! The attitude of an asymmetric body: two complex numbers that are theta functions of the phase.
//!
//! With the circled axis as `i` and the next two in cyclic order as `j` and `k = i j`, write the quaternion
//! that takes the body to axes with `i` along the momentum as `a + b j`. Both complex numbers are, up to one
//! common length and one common phase that grows evenly with time, single theta functions of the nome
//! squared:
//!
//! ```text
//! a ~ theta_4(z - i s B),   b ~ theta_1(z - i s B)
//! ```
//!
//! These are the Cayley-Klein parameters ([KS97](crate::references)); [vZS07](crate::references) states the
//! rotation matrix in theta functions of the nome itself. The reason: with `n` the component of the
//! momentum's direction along the circled axis, `|a|² = (1 + n)/2` and `|b|² = (1 - n)/2` are zero where `n`
//! is -1 and 1. The quaternion is normalized to length 1 at the end; no integration and no unwrapping of an
//! angle is needed.

use crate::number::functions::powi;
use crate::number::{DoubleDouble, Gather, Real, Rounding, Series, gather_fields, splat};
use core::array::from_fn;

/// `a + b j`, not of length 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair<T = f64> {
    pub(crate) a: [T; 2],
    pub(crate) b: [T; 2],
}

gather_fields!(Pair { a, b });

#[inline(always)]
pub(crate) fn times<T: Rounding>(x: [T; 2], y: [T; 2]) -> [T; 2] {
    [x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]]
}

#[inline(always)]
pub(crate) fn conjugate<T: Rounding>(x: [T; 2]) -> [T; 2] {
    [x[0], -x[1]]
}

impl<T: Rounding> Pair<T> {
    #[inline(always)]
    pub(crate) fn length(&self) -> T {
        (self.a[0] * self.a[0] + self.a[1] * self.a[1] + self.b[0] * self.b[0] + self.b[1] * self.b[1]).sqrt()
    }

    /// Rotated about `i` by twice the angle with this cosine and sine.
    #[inline(always)]
    pub(crate) fn turned(&self, phase: [T; 2]) -> Self {
        Self { a: times(phase, self.a), b: times(phase, self.b) }
    }

    pub(crate) fn scaled(&self, factor: T) -> Self {
        Self { a: self.a.map(|x| factor * x), b: self.b.map(|x| factor * x) }
    }

    /// `conj(start) self` as a quaternion of length 1 to a few roundings: the real part, then the components
    /// along `i`, `j`, `k`.
    #[inline(always)]
    pub(crate) fn since(&self, start: &Self) -> [T; 4] {
        let (a0, b0) = (start.a, start.b);
        // (C26)
        let dot = [
            times(conjugate(a0), self.a),
            times(b0, conjugate(self.b)),
            times(conjugate(a0), self.b),
            times(b0, conjugate(self.a)),
        ];
        let inverse = splat::<T>(1.0) / self.length();
        [
            (dot[0][0] + dot[1][0]) * inverse,
            (dot[0][1] + dot[1][1]) * inverse,
            (dot[2][0] - dot[3][0]) * inverse,
            (dot[2][1] - dot[3][1]) * inverse,
        ]
    }
}

/// The input of both forms.
pub(crate) struct Shape<T = f64> {
    /// Whether the across, the middle and the circled axis are in cyclic order, `s = 1`, and whether the spin
    /// along the circled axis is positive.
    pub(crate) cyclic: bool,
    pub(crate) forward: bool,
    /// `|b/a|` at the saddle, where the spin's across component vanishes.
    pub(crate) tilt: T,
    /// The position of the zero: `2B = pi y/K` in sines and cosines, `pi y/(4K')` in hyperbolic functions.
    pub(crate) depth: T,
}

impl<T: Real> Shape<T> {
    fn sense(&self) -> T {
        splat(if self.cyclic { 1.0 } else { -1.0 })
    }

    /// The factor of `b`, from both numbers at the saddle.
    fn amplitude(&self, saddle: &Pair<T>) -> T {
        let square = |[x, y]: [T; 2]| x * x + y * y;
        // (C24)
        let amplitude = self.tilt * (square(saddle.a) / square(saddle.b)).sqrt();
        if self.forward { amplitude } else { -amplitude }
    }
}

/// The attitude's two theta functions as sums in the nome, in sines and cosines: as polynomials in `cos 2z`.
///
/// ```
/// use tumbling::laws::DirectPair;
/// // Where the zero is at no depth, a is theta_4 of the nome squared: 1 - 2q² + 2q⁸ at z = 0, for q of 0.1.
/// let pair = DirectPair::new(0.1, [1.0, 0.0], 0.1, 1.0);
/// let [a_1, ..] = pair.sums([1.0, 0.0], [0.0, 1.0]);
/// assert!((a_1 - 0.980_000_02_f64).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DirectPair<T = f64> {
    a_real: [T; 4],
    a_imaginary: [T; 3],
    b_along_sin: [T; 3],
    b_along_cos: [T; 3],
}

gather_fields!(DirectPair { a_real, a_imaginary, b_along_sin, b_along_cos });

impl<T: Series> DirectPair<T> {
    /// `2 q^(2n²) cosh 2nB` and the sine: from the nome, `exp(-2B)`, and the nome times `exp(2B)`.
    pub fn waves(q: &T, fall: &T, rise: &T) -> [[T; 3]; 2] {
        let power = |k| powi(q.clone(), k);
        let fall = |k| powi(fall.clone(), k);
        let rise = |k| powi(rise.clone(), k);
        // (C22)
        let up = [q.clone() * rise(1), power(6) * rise(1) * rise(1), power(15) * rise(3)];
        let down = [q.clone() * q.clone() * fall(1), power(8) * fall(1) * fall(1), power(18) * fall(3)];
        sums_and_differences(up, down)
    }

    /// `2 exp(-B) q^(2n(n+1)) cosh (2n+1)B` and the sine, from the same and `exp(-2B) - 1`.
    pub fn odd_waves(q: &T, [fall, less]: [&T; 2], rise: &T) -> [[T; 3]; 2] {
        let power = |k| powi(q.clone(), k);
        let (f, r) = (|| fall.clone(), || rise.clone());
        // (C23)
        let up = [power(3) * r(), power(10) * r() * r()];
        let down = [power(4) * f() * f(), power(12) * powi(f(), 3)];
        let [[c1, c2], [d1, d2]] = sums_and_differences(up, down);
        [[T::one() + f(), c1, c2], [-less.clone(), d1, d2]]
    }

    /// From the nome, `exp(-2B)` with what it is more than 1, the nome times `exp(2B)`, and the sense: 1
    /// where the across, the middle and the circled axis follow each other in cyclic order, otherwise -1.
    pub fn new(q: T, [fall, less]: [T; 2], rise: T, sense: T) -> Self {
        let n = T::integer;
        let [[h1, h2, h3], sinh] = Self::waves(&q, &fall, &rise);
        let [l1, l2, l3] = sinh.map(|x| sense.clone() * x);
        // The next terms: one wave, four over that of 2z, and seven over that of z.
        let rest = |most: u32| n(2) * n(most) * powi(q.clone(), 28);
        let odd_rest = || n(8) * powi(q.clone(), 21);
        // (C22)
        let a_real = [(n(1) - h2.clone()).up_to(|| rest(1)), -h1 + n(3) * h3.clone(), n(2) * h2, -n(4) * h3];
        let a_imaginary = [(-l1 + l3.clone()).up_to(|| rest(4)), n(2) * l2, -n(4) * l3];
        // (C23)
        let [[c0, c1, c2], [d0, d1, d2]] = Self::odd_waves(&q, [&fall, &less], &rise);
        let b_along_sin =
            [(c0 - c1.clone() - c2.clone()).up_to(odd_rest), -n(2) * c1 + n(2) * c2.clone(), n(4) * c2];
        let along_cos =
            [(d0 + d1.clone() - d2.clone()).up_to(odd_rest), -n(2) * d1 - n(2) * d2.clone(), n(4) * d2];
        let b_along_cos = along_cos.map(|x| -sense.clone() * x);
        Self { a_real, a_imaginary, b_along_sin, b_along_cos }
    }

    /// The real and the imaginary part of `a`, and those of `b` where the sense is 1 (otherwise `b` is `-i`
    /// times them), from cosine and sine of `2z`, and sine and cosine of `z`.
    #[inline(always)]
    pub fn sums(&self, [cos_2z, sin_2z]: [T; 2], [sin, cos]: [T; 2]) -> [T; 4] {
        let c = || cos_2z.clone();
        let cubic = |[p, q, r, s]: [T; 4]| (p + q * c()) + (c() * c()) * (r + s * c());
        let square = |[p, q, r]: [T; 3]| p + c() * (q + c() * r);
        [
            cubic(self.a_real.clone()),
            sin_2z * square(self.a_imaginary.clone()),
            sin * square(self.b_along_sin.clone()),
            cos * square(self.b_along_cos.clone()),
        ]
    }

    /// The rate of the angle of `a` with respect to `z` at `z = 0`.
    pub fn turning_at_zero(&self) -> T {
        let sum = |p: &[T]| p.iter().fold(T::zero(), |sum, x| sum + x.clone());
        // (C25)
        T::integer(2) * sum(&self.a_imaginary) / sum(&self.a_real)
    }
}

/// Twice hyperbolic cosines and sines, of rising and falling exponentials.
fn sums_and_differences<T: Series, const N: usize>(up: [T; N], down: [T; N]) -> [[T; N]; 2] {
    let both = |sign: bool| {
        from_fn(|n| {
            let (up, down) = (up[n].clone(), down[n].clone());
            if sign { up + down } else { up - down }
        })
    };
    [both(true), both(false)]
}

impl<T: Real> DirectPair<T> {
    /// `q` is the nome and `shape.depth = pi y/K`, twice the imaginary shift.
    pub(crate) fn of_shape(q: T, shape: &Shape<T>) -> Self {
        let (fall, less) = (-shape.depth).exp_and_exp_m1();
        // `q exp(2B)` is at most 1; where both factors underflow, the product is negligible.
        let rise = if q == T::zero() { T::zero() } else { (q / fall).at_most_one() };
        let mut pair = Self::new(q, [fall, less], rise, shape.sense());
        let amplitude = shape.amplitude(&pair.raw(T::one(), T::zero()));
        pair.b_along_sin = pair.b_along_sin.map(|x| x * amplitude);
        pair.b_along_cos = pair.b_along_cos.map(|x| x * amplitude);
        pair
    }
}

impl<T: Rounding> DirectPair<T> {
    /// From sine and cosine of `z`.
    #[inline(always)]
    pub(crate) fn raw(&self, sin: T, cos: T) -> Pair<T> {
        let doubled = [(cos - sin) * (cos + sin), sin * 2.0 * cos];
        let [a, turned, real, imaginary] = self.sums(doubled, [sin, cos]);
        Pair { a: [a, turned], b: [real, imaginary] }
    }
}

/// The attitude's two theta functions in hyperbolic functions, after the imaginary transformation: sums in
/// `e = exp(-x)` and `r = p² exp(x)`, where `x` is Jacobi's argument times `pi/(2K')`.
///
/// ```
/// use tumbling::laws::ComplementaryPair;
/// // At the saddle e and r are p; where the zero is at no depth, a is 1 + 2p + 2p⁴ there, for p of 0.1.
/// let pair = ComplementaryPair::new(0.1, ComplementaryPair::waves(0.0_f64, 1.0), 1.0);
/// let [a_1, ..] = pair.sums(0.1, 0.1);
/// assert!((a_1 - 1.200_2_f64).abs() < 1e-8);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComplementaryPair<T = f64> {
    /// The nome `p = exp(-pi K/(2K'))`, that is the value of both `e` and `r` at the saddle.
    nome: T,
    rising: [[T; 5]; 2],
    falling: [[T; 4]; 2],
    amplitude: T,
}

gather_fields!(ComplementaryPair { nome, rising, falling, amplitude });

impl<T: Series> ComplementaryPair<T> {
    /// Cosines and sines of the first five odd multiples, each from the two before.
    pub fn waves(sin: T, cos: T) -> [[T; 5]; 2] {
        let n = T::integer;
        let twice = n(2) * (cos.clone() - sin.clone()) * (cos.clone() + sin.clone());
        let multiples = |first: [T; 2]| {
            let [mut before, mut last] = first;
            from_fn(|k| {
                if k > 0 {
                    let next = twice.clone() * last.clone() - before.clone();
                    (before, last) = (last.clone(), next);
                }
                last.clone()
            })
        };
        [multiples([cos.clone(), cos]), multiples([-sin.clone(), sin])]
    }

    /// From the nome, those cosines and sines, and the sense: 1 where the across, the middle and the circled
    /// axis follow each other in cyclic order, otherwise -1.
    pub fn new(nome: T, waves: [[T; 5]; 2], sense: T) -> Self {
        let power = |k| powi(nome.clone(), k);
        // (C32)
        let up = [T::one(), T::one(), power(2), power(6), power(12)];
        let [cos, sin] = waves;
        let waves = [cos, sin.map(|x| sense.clone() * x)];
        let rising = waves.each_ref().map(|w| from_fn(|n| up[n].clone() * w[n].clone()));
        let falling = waves.each_ref().map(|w| from_fn(|n| up[n + 1].clone() * w[n].clone()));
        Self { rising, falling, amplitude: T::one(), nome }
    }

    /// The real and the imaginary part of `a`, and those of `b` where the sense is 1 (otherwise `b` is `-i`
    /// times them), on the near side of the flip, from `e` and `r`.
    #[inline(always)]
    pub fn sums(&self, e: T, r: T) -> [T; 4] {
        let (r2, e2) = (r.clone() * r.clone(), e.clone() * e.clone());
        // The next are the nome to the twentieth times the fifth powers, with waves of size 1.
        let rest = || {
            let fifth = powi(r.clone(), 5) + powi(e.clone(), 5);
            T::integer(2) * powi(self.nome.clone(), 20) * fifth
        };
        // Sums with equal signs, and alternating.
        let up = |p: &[T; 5]| {
            let p = |k: usize| p[k].clone();
            let even = p(0) + r2.clone() * (p(2) + r2.clone() * p(4));
            let odd = r.clone() * (p(1) + r2.clone() * p(3));
            (even.clone() + odd.clone(), even - odd)
        };
        let down = |p: &[T; 4]| {
            let p = |k: usize| p[k].clone();
            let (even, odd) =
                (e.clone() * (p(0) + e2.clone() * p(2)), e2.clone() * (p(1) + e2.clone() * p(3)));
            (even.clone() + odd.clone(), even - odd)
        };
        let [(cos_up, cos_up_alternating), (sin_up, sin_up_alternating)] = self.rising.each_ref().map(up);
        let [(cos_down, cos_down_alternating), (sin_down, sin_down_alternating)] =
            self.falling.each_ref().map(down);
        [
            (cos_up + cos_down).up_to(rest),
            (sin_down - sin_up).up_to(rest),
            (cos_up_alternating - cos_down_alternating).up_to(rest),
            -(sin_up_alternating + sin_down_alternating).up_to(rest),
        ]
    }

    /// The rate of the angle of `a` with respect to `x` at the saddle, where `e = r = p`.
    pub fn turning_at_saddle(&self) -> T {
        let p = || self.nome.clone();
        let [re, im, ..] = self.sums(p(), p());
        let (mut power, mut change) = (T::one(), [T::zero(), T::zero()]);
        for n in 1..5 {
            power *= p();
            let terms = |wave: usize| [self.rising[wave][n].clone(), self.falling[wave][n - 1].clone()];
            let ([c, d], [s, t], weight) = (terms(0), terms(1), T::integer(n as u32) * power.clone());
            change[0] += weight.clone() * (c - d);
            change[1] -= weight * (s + t);
        }
        let [d_re, d_im] = change.map(|x| x.up_to(|| T::integer(32) * powi(p(), 25)));
        let square = re.clone() * re.clone() + im.clone() * im.clone();
        // (C34)
        (re * d_im - im * d_re) / square
    }
}

impl<T: Real> ComplementaryPair<T> {
    /// `shape.depth = pi y/(4K')`.
    pub(crate) fn of_shape(nome: T, shape: &Shape<T>) -> Self {
        let (sin, cos) = shape.depth.sin_cos();
        let mut pair = Self::new(nome, Self::waves(sin, cos), shape.sense());
        let one = T::one();
        pair.amplitude = shape.amplitude(&pair.raw(nome, one, one, one));
        pair
    }

    /// The angle of `a` at the saddle.
    pub(crate) fn angle_at_saddle(&self) -> T {
        let [re, im, ..] = self.sums(self.nome, self.nome);
        // (C33)
        im.atan2(re)
    }
}

impl<T: Rounding> ComplementaryPair<T> {
    /// From `e = exp(-|x|)`, `p exp(|x|)`, the sign of `x`, and that of `b` after an odd number of half
    /// turns.
    #[inline(always)]
    pub(crate) fn raw(&self, e: T, rise: T, sign: T, turn: T) -> Pair<T> {
        let [a, turned, real, imaginary] = self.sums(e, self.nome * rise);
        let amplitude = turn * self.amplitude;
        Pair { a: [a, sign * turned], b: [amplitude * sign * real, amplitude * imaginary] }
    }
}

/// Cosine and sine of the common phase.
#[inline(always)]
pub(crate) fn phase_factor<T: Rounding>(turns: DoubleDouble<T>) -> [T; 2] {
    let (sin, cos) = crate::exact::elliptic::sin_cos_of_turns(turns);
    [cos, sin]
}
