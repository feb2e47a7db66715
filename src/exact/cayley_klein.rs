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
//! These are the Cayley-Klein parameters ([KS97](crate::references)); [vZS07](crate::references) have the
//! rotation matrix in theta functions of the nome itself. It is so since `|a|² = (1 + n)/2` and `|b|² = (1 -
//! n)/2`, with `n` the momentum's share along the circled axis, have their zeros where `n` is -1 and 1. The
//! length is found by making the quaternion one of length 1; nothing has to be integrated, no angle unwound.

use crate::number::double_double::DoubleDouble;
use crate::number::functions::{atan2, exp_and_exp_m1, hypot, powi, sin_cos};
use crate::number::{Gather, Lane, gather_fields, splat};

/// `a + b j`, not of length 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair<T = f64> {
    pub(crate) a: [T; 2],
    pub(crate) b: [T; 2],
}

gather_fields!(Pair { a, b });

#[inline(always)]
pub(crate) fn times<T: Lane>(x: [T; 2], y: [T; 2]) -> [T; 2] {
    [x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]]
}

#[inline(always)]
pub(crate) fn conjugate<T: Lane>(x: [T; 2]) -> [T; 2] {
    [x[0], -x[1]]
}

impl<T: Lane> Pair<T> {
    #[inline(always)]
    pub(crate) fn length(&self) -> T {
        (self.a[0] * self.a[0] + self.a[1] * self.a[1] + self.b[0] * self.b[0] + self.b[1] * self.b[1]).sqrt()
    }

    /// Turned about `i` by twice the angle whose cosine and sine are given.
    #[inline(always)]
    pub(crate) fn turned(&self, phase: [T; 2]) -> Self {
        Self { a: times(phase, self.a), b: times(phase, self.b) }
    }

    pub(crate) fn scaled(&self, factor: T) -> Self {
        Self { a: self.a.map(|x| factor * x), b: self.b.map(|x| factor * x) }
    }

    /// `conj(start) self` as a quaternion of length 1 to a few roundings: the real part, and those along `i`,
    /// `j`, `k`.
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

/// What both forms are made from.
pub(crate) struct Shape {
    /// Whether the across, the middle and the circled axis follow each other in cyclic order, `s = 1`, and
    /// whether the spin along the circled one is positive.
    pub(crate) cyclic: bool,
    pub(crate) forward: bool,
    /// `|b/a|` at the saddle, where the spin's across component vanishes.
    pub(crate) tilt: f64,
    /// Where the zero lies: `2B = pi y/K` in sines and cosines, `pi y/(4K')` in hyperbolic functions.
    pub(crate) depth: f64,
}

impl Shape {
    fn sense(&self) -> f64 {
        if self.cyclic { 1.0 } else { -1.0 }
    }
}

/// The two theta functions in sines and cosines, as polynomials in `cos 2z`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DirectPair<T = f64> {
    a_real: [T; 4],
    a_imaginary: [T; 3],
    b_along_sin: [T; 3],
    b_along_cos: [T; 3],
    sense: T,
}

gather_fields!(DirectPair { a_real, a_imaginary, b_along_sin, b_along_cos, sense });

impl DirectPair {
    /// `q` is the nome and `shape.depth = pi y/K`, twice the imaginary shift.
    pub(crate) fn new(q: f64, shape: &Shape) -> Self {
        let (fall, less) = exp_and_exp_m1(-shape.depth);
        // q exp(2B) is at most 1; where both underflow, what it multiplies is nothing.
        let rise = if q == 0.0 { 0.0 } else { (q / fall).min(1.0) };
        let s = shape.sense();
        let (q2, q6, q8) = (q * q, powi(q, 6), powi(q, 8));
        let (q15, q18) = (powi(q, 15), powi(q, 18));
        // (C22)
        // 2 q^(2n²) cosh 2nB and sinh.
        let up = [q * rise, q6 * rise * rise, q15 * powi(rise, 3)];
        let down = [q2 * fall, q8 * fall * fall, q18 * powi(fall, 3)];
        let cosh = [0, 1, 2].map(|n| up[n] + down[n]);
        let sinh = [0, 1, 2].map(|n| s * (up[n] - down[n]));
        // (C22)
        let a_real = [1.0 - cosh[1], -cosh[0] + 3.0 * cosh[2], 2.0 * cosh[1], -4.0 * cosh[2]];
        let a_imaginary = [-sinh[0] + sinh[2], 2.0 * sinh[1], -4.0 * sinh[2]];
        // (C23)
        // 2 exp(-B) q^(2n(n+1)) cosh (2n+1)B and sinh.
        let (q3, q4, q10, q12) = (powi(q, 3), powi(q, 4), powi(q, 10), powi(q, 12));
        let c = [1.0 + fall, q3 * rise + q4 * fall * fall, q10 * rise * rise + q12 * powi(fall, 3)];
        let d = [-less, q3 * rise - q4 * fall * fall, q10 * rise * rise - q12 * powi(fall, 3)];
        let b_along_sin = [c[0] - c[1] - c[2], -2.0 * c[1] + 2.0 * c[2], 4.0 * c[2]];
        let b_along_cos = [d[0] + d[1] - d[2], -2.0 * d[1] - 2.0 * d[2], 4.0 * d[2]].map(|x| -s * x);
        let mut pair = Self { a_real, a_imaginary, b_along_sin, b_along_cos, sense: s };
        let at_middle = pair.raw(1.0, 0.0);
        // (C24)
        let amplitude = shape.tilt * at_middle.a[0] / hypot(at_middle.b[0], at_middle.b[1]);
        let amplitude = if shape.forward { amplitude } else { -amplitude };
        pair.b_along_sin = pair.b_along_sin.map(|x| x * amplitude);
        pair.b_along_cos = pair.b_along_cos.map(|x| x * amplitude);
        pair
    }

    /// How fast the angle of `a` turns with `z` where `z` is zero.
    pub(crate) fn turning_at_zero(&self) -> f64 {
        let sum = |p: &[f64]| p.iter().sum::<f64>();
        // (C25)
        2.0 * sum(&self.a_imaginary) / sum(&self.a_real)
    }
}

impl<T: Lane> DirectPair<T> {
    /// From sine and cosine of `z`.
    #[inline(always)]
    pub(crate) fn raw(&self, sin: T, cos: T) -> Pair<T> {
        let c = (cos - sin) * (cos + sin);
        let cubic = |p: &[T; 4]| (p[0] + p[1] * c) + (c * c) * (p[2] + p[3] * c);
        let square = |p: &[T; 3]| p[0] + c * (p[1] + c * p[2]);
        let real = sin * square(&self.b_along_sin);
        let imaginary = cos * square(&self.b_along_cos);
        Pair {
            a: [cubic(&self.a_real), sin * 2.0 * cos * square(&self.a_imaginary)],
            b: in_sense(self.sense, real, imaginary),
        }
    }
}

/// `b`, whose axes follow each other one way or the other.
#[inline(always)]
fn in_sense<T: Lane>(sense: T, real: T, imaginary: T) -> [T; 2] {
    let cyclic = splat::<T>(0.0).lt(sense);
    [T::select(cyclic, real, imaginary), T::select(cyclic, imaginary, -real)]
}

/// The two theta functions in hyperbolic functions, after the imaginary transformation: sums in
/// `e = exp(-x)` and `r = p² exp(x)`, where `x` is Jacobi's argument times `pi/(2K')`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ComplementaryPair<T = f64> {
    /// The nome `p = exp(-pi K/(2K'))`, that is the value of both `e` and `r` at the saddle.
    nome: T,
    rising: [[T; 5]; 2],
    falling: [[T; 4]; 2],
    amplitude: T,
    sense: T,
}

gather_fields!(ComplementaryPair { nome, rising, falling, amplitude, sense });

impl ComplementaryPair {
    /// `shape.depth = pi y/(4K')`.
    pub(crate) fn new(nome: f64, shape: &Shape) -> Self {
        let p = nome;
        // Sines and cosines of the odd multiples, each from the two before.
        let (sin, cos) = sin_cos(shape.depth);
        let twice = 2.0 * (cos - sin) * (cos + sin);
        let (mut s, mut c) = ([-sin, sin, 0.0, 0.0, 0.0, 0.0], [cos, cos, 0.0, 0.0, 0.0, 0.0]);
        for n in 2..6 {
            (s[n], c[n]) = (twice * s[n - 1] - s[n - 2], twice * c[n - 1] - c[n - 2]);
        }
        let (s, c) = (&s[1..], &c[1..]);
        // (C32)
        let up = [1.0, 1.0, powi(p, 2), powi(p, 6), powi(p, 12)];
        let down = [1.0, powi(p, 2), powi(p, 6), powi(p, 12)];
        let mut pair = Self {
            nome,
            rising: [[0, 1, 2, 3, 4].map(|n| up[n] * c[n]), [0, 1, 2, 3, 4].map(|n| up[n] * s[n])],
            falling: [[0, 1, 2, 3].map(|n| down[n] * c[n]), [0, 1, 2, 3].map(|n| down[n] * s[n])],
            amplitude: 1.0,
            sense: shape.sense(),
        };
        let middle = pair.raw(nome, 1.0, 1.0, 1.0);
        let length = |x: [f64; 2]| hypot(x[0], x[1]);
        let amplitude = shape.tilt * length(middle.a) / length(middle.b);
        pair.amplitude = if shape.forward { amplitude } else { -amplitude };
        pair
    }

    /// At the saddle, where `e = r = p`: the angle of `a`, and how fast it turns with `x`.
    pub(crate) fn angle_and_turning_at_saddle(&self) -> (f64, f64) {
        let (p, p2) = (self.nome, self.nome * self.nome);
        let p = [1.0, p, p2, p * p2, p2 * p2];
        let sum = |wave: usize, weigh: bool| {
            let mut total = [0.0; 2];
            for (n, (term, power)) in self.rising[wave].iter().zip(p).enumerate() {
                total[0] += if weigh { n as f64 } else { 1.0 } * term * power;
            }
            for (n, (term, power)) in (1..).zip(self.falling[wave].iter().zip(&p[1..])) {
                total[1] += if weigh { -f64::from(n) } else { 1.0 } * term * power;
            }
            total
        };
        let (c, s, dc, ds) = (sum(0, false), sum(1, false), sum(0, true), sum(1, true));
        let a = [c[0] + c[1], self.sense * (s[1] - s[0])];
        let change = [dc[0] + dc[1], self.sense * (ds[1] - ds[0])];
        let turning = (a[0] * change[1] - a[1] * change[0]) / (a[0] * a[0] + a[1] * a[1]);
        // (C33)
        (atan2(a[1], a[0]), turning)
    }
}

impl<T: Lane> ComplementaryPair<T> {
    /// From `e = exp(-|x|)`, `p exp(|x|)`, the sign of `x`, and that of `b` after an odd number of half
    /// turns.
    #[inline(always)]
    pub(crate) fn raw(&self, e: T, rise: T, sign: T, turn: T) -> Pair<T> {
        let r = self.nome * rise;
        let r2 = r * r;
        // Sums with equal signs, and alternating.
        let up = |p: &[T; 5]| {
            let even = p[0] + r2 * (p[2] + r2 * p[4]);
            let odd = r * (p[1] + r2 * p[3]);
            (even + odd, even - odd)
        };
        let e2 = e * e;
        let down = |p: &[T; 4]| {
            let (even, odd) = (e * (p[0] + e2 * p[2]), e2 * (p[1] + e2 * p[3]));
            (even + odd, even - odd)
        };
        let [(cos_up, cos_up_alternating), (sin_up, sin_up_alternating)] =
            [up(&self.rising[0]), up(&self.rising[1])];
        let [(cos_down, cos_down_alternating), (sin_down, sin_down_alternating)] =
            [down(&self.falling[0]), down(&self.falling[1])];
        let real = turn * self.amplitude * sign * (cos_up_alternating - cos_down_alternating);
        let imaginary = -turn * self.amplitude * self.sense * (sin_up_alternating + sin_down_alternating);
        Pair {
            a: [cos_up + cos_down, sign * self.sense * (sin_down - sin_up)],
            b: in_sense(self.sense, real, imaginary),
        }
    }
}

/// Cosine and sine of the common phase.
#[inline(always)]
pub(crate) fn phase_factor<T: Lane>(turns: DoubleDouble<T>) -> [T; 2] {
    let (sin, cos) = crate::exact::elliptic::sin_cos_of_turns(turns);
    [cos, sin]
}
