//! The attitude of an asymmetric body: two complex numbers that are theta functions of the phase.
//!
//! With the circled axis as `i` and the next two in cyclic order as `j` and `k = i j`, write the quaternion that
//! takes the body to axes with `i` along the momentum as `a + b j`. Both complex numbers are, up to one
//! common length and one common phase that grows evenly with time, single theta functions of the nome squared
//! [KS97; vZS07 has the same for the rotation matrix]:
//!
//! ```text
//! a ~ theta_4(z - i s B),   b ~ theta_1(z - i s B)
//! ```
//!
//! since `|a|² = (1 + n)/2` and `|b|² = (1 - n)/2`, with `n` the momentum's share along the circled axis, have their
//! zeros where `n` is -1 and 1. The length is found by making the quaternion one of length 1; nothing has to
//! be integrated, no angle unwound.

use crate::double::Double;
use nalgebra::Quaternion;

/// `a + b j`, not of length 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair {
    pub(crate) a: [f64; 2],
    pub(crate) b: [f64; 2],
}

fn times(x: [f64; 2], y: [f64; 2]) -> [f64; 2] {
    [x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]]
}

fn conjugate(x: [f64; 2]) -> [f64; 2] {
    [x[0], -x[1]]
}

impl Pair {
    pub(crate) fn length(&self) -> f64 {
        (self.a[0] * self.a[0] + self.a[1] * self.a[1] + self.b[0] * self.b[0] + self.b[1] * self.b[1]).sqrt()
    }

    /// Turned about `i` by twice the angle whose cosine and sine are given.
    pub(crate) fn turned(&self, phase: [f64; 2]) -> Self {
        Self { a: times(phase, self.a), b: times(phase, self.b) }
    }

    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self { a: self.a.map(|x| factor * x), b: self.b.map(|x| factor * x) }
    }

    /// `conj(start) self` as a quaternion of length 1, with `i` along the body axis number `axis`.
    pub(crate) fn since(&self, start: &Self, axis: usize) -> Quaternion<f64> {
        let (a0, b0) = (start.a, start.b);
        let dot = [
            times(conjugate(a0), self.a),
            times(b0, conjugate(self.b)),
            times(conjugate(a0), self.b),
            times(b0, conjugate(self.a)),
        ];
        let over = 1.0 / self.length();
        let real = (dot[0][0] + dot[1][0]) * over;
        let mut vector = [0.0; 3];
        vector[axis] = (dot[0][1] + dot[1][1]) * over;
        vector[(axis + 1) % 3] = (dot[2][0] - dot[3][0]) * over;
        vector[(axis + 2) % 3] = (dot[2][1] - dot[3][1]) * over;
        unit(Quaternion::new(real, vector[0], vector[1], vector[2]))
    }
}

/// One of length 1 to a few roundings brought to length 1 as near as its components can be.
pub(crate) fn unit(q: Quaternion<f64>) -> Quaternion<f64> {
    let [x, y, z, w] = [q.coords.x, q.coords.y, q.coords.z, q.coords.w];
    // Sorted into pairs so that the sum stays short; the excess itself has all the digits it needs.
    let excess = ((w * w - 0.5) + x * x) + ((y * y - 0.5) + z * z);
    q * (1.0 - 0.5 * excess)
}

/// What both forms are made from.
pub(crate) struct Shape {
    /// Whether the across, the middle and the circled axis follow each other in cyclic order, `s = 1`, and
    /// whether the spin along the circled one is positive.
    pub(crate) cyclic: bool,
    pub(crate) forward: bool,
    /// `|b/a|` at the middle of the way, where the spin's across component vanishes.
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
pub(crate) struct TrigonometricPair {
    a_real: [f64; 4],
    a_imaginary: [f64; 3],
    b_along_sin: [f64; 3],
    b_along_cos: [f64; 3],
    cyclic: bool,
}

impl TrigonometricPair {
    /// `q` is the nome and `shape.depth = pi y/K`, twice the imaginary shift.
    pub(crate) fn new(q: f64, shape: &Shape) -> Self {
        let fall = (-shape.depth).exp();
        // q exp(2B) is at most 1; where both underflow, what it multiplies is nothing.
        let rise = if q == 0.0 { 0.0 } else { (q / fall).min(1.0) };
        let s = shape.sense();
        let (q2, q6, q8) = (q * q, q.powi(6), q.powi(8));
        let (q15, q18) = (q.powi(15), q.powi(18));
        // 2 q^(2n²) cosh 2nB and sinh.
        let up = [q * rise, q6 * rise * rise, q15 * rise.powi(3)];
        let down = [q2 * fall, q8 * fall * fall, q18 * fall.powi(3)];
        let cosh = [0, 1, 2].map(|n| up[n] + down[n]);
        let sinh = [0, 1, 2].map(|n| s * (up[n] - down[n]));
        let a_real = [1.0 - cosh[1], -cosh[0] + 3.0 * cosh[2], 2.0 * cosh[1], -4.0 * cosh[2]];
        let a_imaginary = [-sinh[0] + sinh[2], 2.0 * sinh[1], -4.0 * sinh[2]];
        // 2 exp(-B) q^(2n(n+1)) cosh (2n+1)B and sinh.
        let (q3, q4, q10, q12) = (q.powi(3), q.powi(4), q.powi(10), q.powi(12));
        let c = [1.0 + fall, q3 * rise + q4 * fall * fall, q10 * rise * rise + q12 * fall.powi(3)];
        let d =
            [-(-shape.depth).exp_m1(), q3 * rise - q4 * fall * fall, q10 * rise * rise - q12 * fall.powi(3)];
        let b_along_sin = [c[0] - c[1] - c[2], -2.0 * c[1] + 2.0 * c[2], 4.0 * c[2]];
        let b_along_cos = [d[0] + d[1] - d[2], -2.0 * d[1] - 2.0 * d[2], 4.0 * d[2]].map(|x| -s * x);
        let mut pair = Self { a_real, a_imaginary, b_along_sin, b_along_cos, cyclic: shape.cyclic };
        let at_middle = pair.raw(1.0, 0.0);
        let amplitude = shape.tilt * at_middle.a[0] / at_middle.b[0].hypot(at_middle.b[1]);
        let amplitude = if shape.forward { amplitude } else { -amplitude };
        pair.b_along_sin = pair.b_along_sin.map(|x| x * amplitude);
        pair.b_along_cos = pair.b_along_cos.map(|x| x * amplitude);
        pair
    }

    /// From sine and cosine of `z`.
    pub(crate) fn raw(&self, sin: f64, cos: f64) -> Pair {
        let c = (cos - sin) * (cos + sin);
        let cubic = |p: &[f64; 4]| (p[0] + p[1] * c) + (c * c) * (p[2] + p[3] * c);
        let square = |p: &[f64; 3]| p[0] + c * (p[1] + c * p[2]);
        let real = sin * square(&self.b_along_sin);
        let imaginary = cos * square(&self.b_along_cos);
        Pair {
            a: [cubic(&self.a_real), 2.0 * sin * cos * square(&self.a_imaginary)],
            b: if self.cyclic { [real, imaginary] } else { [imaginary, -real] },
        }
    }

    /// How fast the angle of `a` turns with `z` where `z` is zero.
    pub(crate) fn turning_at_zero(&self) -> f64 {
        let sum = |p: &[f64]| p.iter().sum::<f64>();
        2.0 * sum(&self.a_imaginary) / sum(&self.a_real)
    }
}

/// The two theta functions in hyperbolic functions, after the imaginary transformation: sums in
/// `e = exp(-x)` and `r = p² exp(x)`, where `x` is Jacobi's argument times `pi/(2K')`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HyperbolicPair {
    /// The nome `p = exp(-pi K/(2K'))`, that is the value of both `e` and `r` at the middle of the way.
    nome: f64,
    rising: [[f64; 5]; 2],
    falling: [[f64; 4]; 2],
    amplitude: f64,
    cyclic: bool,
    sense: f64,
}

impl HyperbolicPair {
    /// `shape.depth = pi y/(4K')`.
    pub(crate) fn new(nome: f64, shape: &Shape) -> Self {
        let p = nome;
        let waves = |n: i32| (f64::from(2 * n + 1) * shape.depth).sin_cos();
        let (s, c): (Vec<f64>, Vec<f64>) = (0..5).map(waves).unzip();
        let up = [1.0, 1.0, p.powi(2), p.powi(6), p.powi(12)];
        let down = [1.0, p.powi(2), p.powi(6), p.powi(12)];
        let mut pair = Self {
            nome,
            rising: [[0, 1, 2, 3, 4].map(|n| up[n] * c[n]), [0, 1, 2, 3, 4].map(|n| up[n] * s[n])],
            falling: [[0, 1, 2, 3].map(|n| down[n] * c[n]), [0, 1, 2, 3].map(|n| down[n] * s[n])],
            amplitude: 1.0,
            cyclic: shape.cyclic,
            sense: shape.sense(),
        };
        let middle = pair.raw(nome, 1.0, 1.0);
        let length = |x: [f64; 2]| x[0].hypot(x[1]);
        let amplitude = shape.tilt * length(middle.a) / length(middle.b);
        pair.amplitude = if shape.forward { amplitude } else { -amplitude };
        pair
    }

    /// The nome, the value of `e` at the middle of the way.
    pub(crate) fn nome(&self) -> f64 {
        self.nome
    }

    /// From `e = exp(-|x|)`, the sign of `x`, and that of `b` after an odd number of half turns.
    pub(crate) fn raw(&self, e: f64, side: f64, turn: f64) -> Pair {
        let r = if self.nome == 0.0 { 0.0 } else { self.nome * (self.nome / e) };
        let r2 = r * r;
        // Sums with all signs alike, and alternating.
        let up = |p: &[f64; 5]| {
            let even = p[0] + r2 * (p[2] + r2 * p[4]);
            let odd = r * (p[1] + r2 * p[3]);
            (even + odd, even - odd)
        };
        let e2 = e * e;
        let down = |p: &[f64; 4]| {
            let (even, odd) = (e * (p[0] + e2 * p[2]), e2 * (p[1] + e2 * p[3]));
            (even + odd, even - odd)
        };
        let [(cos_up, cos_up_alternating), (sin_up, sin_up_alternating)] =
            [up(&self.rising[0]), up(&self.rising[1])];
        let [(cos_down, cos_down_alternating), (sin_down, sin_down_alternating)] =
            [down(&self.falling[0]), down(&self.falling[1])];
        let real = turn * self.amplitude * side * (cos_up_alternating - cos_down_alternating);
        let imaginary = -turn * self.amplitude * self.sense * (sin_up_alternating + sin_down_alternating);
        Pair {
            a: [cos_up + cos_down, side * self.sense * (sin_down - sin_up)],
            b: if self.cyclic { [real, imaginary] } else { [imaginary, -real] },
        }
    }

    /// At the middle of the way, where `e = r = p`: the angle of `a`, and how fast it turns with `x`.
    pub(crate) fn angle_and_turning_at_middle(&self) -> (f64, f64) {
        let p = self.nome;
        let sum = |wave: usize, weigh: bool| {
            let mut total = [0.0; 2];
            for n in 0..5 {
                let k = n as i32;
                let weight = if weigh { f64::from(k) } else { 1.0 };
                total[0] += weight * self.rising[wave][n] * p.powi(k);
            }
            for n in 0..4 {
                let k = n as i32 + 1;
                let weight = if weigh { f64::from(-k) } else { 1.0 };
                total[1] += weight * self.falling[wave][n] * p.powi(k);
            }
            total
        };
        let (c, s, dc, ds) = (sum(0, false), sum(1, false), sum(0, true), sum(1, true));
        let a = [c[0] + c[1], self.sense * (s[1] - s[0])];
        let change = [dc[0] + dc[1], self.sense * (ds[1] - ds[0])];
        let turning = (a[0] * change[1] - a[1] * change[0]) / (a[0] * a[0] + a[1] * a[1]);
        (a[1].atan2(a[0]), turning)
    }
}

/// Cosine and sine of the common phase.
pub(crate) fn phase(turns: Double) -> [f64; 2] {
    let (sin, cos) = crate::elliptic::sin_cos_of_turns(turns);
    [cos, sin]
}
