//! Jacobi's functions near and on the separatrix: theta sums in hyperbolic functions, after Jacobi's
//! imaginary transformation.

use super::Values;

/// A decaying exponential of the argument: `E = exp(-2x)` with `1 - E` and the root of `E` beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Decay {
    /// `exp(-x)`.
    pub(crate) root: f64,
    /// `exp(-2x)`.
    square: f64,
    /// `1 - exp(-2x)`, small where `x` is.
    gap: f64,
    /// The root of the complementary nome over `exp(-x)`: this exponential seen from the other end of the way.
    pub(crate) rising: f64,
}

impl Decay {
    /// Of `x = main + rest >= 0`, with the root of the complementary nome.
    pub(crate) fn new(main: f64, rest: f64, nome_root: f64) -> Self {
        // Beyond 700 the exponential is nothing beside any f64; so far out the rest can be large, and says nothing.
        let (main, rest) = if main < 700.0 { (main, rest) } else { (700.0, 0.0) };
        let (power, change) = exp_parts(-main, -rest);
        let root = power + power * change;
        // exp(-x) - 1, exact in its small digits where the power of two is 1.
        let less = (power - 1.0) + power * change;
        Self { root, square: root * root, gap: -less * (2.0 + less), rising: nome_root / root }
    }
}

/// `exp(x + rest) = power (1 + change)` with a power of two and `|change| <= 0.42`, for `|x| <= 700`.
fn exp_parts(x: f64, rest: f64) -> (f64, f64) {
    // The logarithm of 2 in two parts, the first with room for an exponent's eleven bits.
    const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
    const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
    let twos = (x * std::f64::consts::LOG2_E).round_ties_even();
    let r = (x - twos * LN_2_HIGH) + (rest - twos * LN_2_LOW);
    // The series of exp(r) - 1 - r, over r²: what is left out is below 1e-17 of it for |r| <= 0.35.
    let a = const {
        let mut a = [0.5; 12];
        let mut n = 1;
        while n < 12 {
            a[n] = a[n - 1] / (n + 2) as f64;
            n += 1;
        }
        a
    };
    let (r2, r4) = (r * r, (r * r) * (r * r));
    let four = |k: usize| (a[k] + a[k + 1] * r) + r2 * (a[k + 2] + a[k + 3] * r);
    let series = four(0) + r4 * (four(4) + r4 * four(8));
    let power = f64::from_bits(((twos as i64 + 1023) as u64) << 52);
    (power, r + r2 * series)
}

/// The sums for a complementary nome `p` of at most 0.02, that is the direct nome above 0.08.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Hyperbolic {
    /// Powers of `p`: the second, the fourth, the first.
    powers: [f64; 3],
    /// What makes `sn`, `cn` and `dn` of the quotients: up to half the quarter period, and beyond.
    near: [f64; 3],
    far: [f64; 3],
}

impl Hyperbolic {
    /// `complement` is `2^shift k'`; `cn` and `dn` come out times `2^shift` too.
    pub(crate) fn new(p: f64, complement: f64, shift: i32) -> Self {
        let p2 = p * p;
        let p4 = p2 * p2;
        let (third, fourth) = (1.0 + 2.0 * p + 2.0 * p4, 1.0 - 2.0 * p + 2.0 * p4);
        let second = 1.0 + p2 + p2 * p4;
        let stretch = crate::scale::times_power_of_two(1.0, shift);
        Self {
            powers: [p2, p4, p],
            near: [third / fourth, stretch * (second / fourth), stretch * (second / third)],
            far: [
                third / fourth,
                complement * (third * third / (fourth * second)),
                complement * (third / second),
            ],
        }
    }

    /// The four sums without their first exponential: those of the odd multiples, alternating (a hyperbolic
    /// sine) and not (a cosine), then those of the even multiples, alternating and not.
    fn sums(&self, x: &Decay) -> [f64; 4] {
        let [p2, p4, p] = self.powers;
        let (e, gap, growing) = (x.square, x.gap, x.rising * x.rising);
        let square = e * e;
        // exp(-x) times twice sinh and cosh of 3x is exp(2x) (1 ∓ E³), of 5x is exp(4x) (1 ∓ E⁵).
        let (b, c) = (p * growing, p4 * growing * growing);
        let (cube, fifth) = (e * square, e * square * square);
        let sine = gap - b * gap * (1.0 + e + square) + c * (1.0 - fifth);
        let cosine = (1.0 + e) + b * (1.0 + cube) + c * (1.0 + fifth);
        // p cosh 2x = growing (1 + E²)/2 and so on; p⁴ cosh 4x, p⁹ cosh 6x.
        let first = growing + p * e;
        let second = p2 * (growing * growing + p2 * square);
        let third = p4 * p2 * (growing * growing * growing + p2 * p * cube);
        let (even, odd) = (1.0 + second, first + third);
        [sine, cosine, even - odd, even + odd]
    }

    /// The three functions where `x` is the argument times `pi/(2K')`, up to half the quarter period; or, if
    /// `far`, what is left of it to the quarter period, so that the small ones keep their digits there.
    pub(crate) fn at(&self, x: &Decay, far: bool) -> Values {
        let [sine, cosine, alternating, plain] = self.sums(x);
        let [s, c, d] = if far { self.far } else { self.near };
        let (rise, fall) = if far { (x.root, 0.5) } else { (1.0, 2.0 * x.root) };
        let (first, second, third, under) = if far {
            (alternating, sine, cosine, plain * x.root)
        } else {
            (sine, alternating, plain, cosine)
        };
        let over = 1.0 / under;
        let fall = fall * over;
        Values { sn: s * first * (rise * over), cn: c * second * fall, dn: d * third * fall }
    }
}
