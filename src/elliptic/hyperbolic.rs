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
}

impl Decay {
    /// Of `x = main + rest >= 0`.
    pub(crate) fn new(main: f64, rest: f64) -> Self {
        if main < 0.3 {
            let gap = -(-2.0 * (main + rest)).exp_m1();
            let square = 1.0 - gap;
            return Self { root: square.sqrt(), square, gap };
        }
        // Beyond 700 there is only what an f64 cannot hold beside the rest.
        let root = (-main.min(700.0)).exp() * (1.0 - rest);
        let square = root * root;
        Self { root, square, gap: 1.0 - square }
    }
}

/// The sums for a complementary nome `p` of at most 0.02, that is the direct nome above 0.08.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Hyperbolic {
    /// Powers of `p`: the second, fourth, first.
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
        let (e, gap) = (x.square, x.gap);
        let growing = if p == 0.0 { 0.0 } else { p / e };
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

    /// The three functions up to half the quarter period: `x` is the argument times `pi/(2K')`.
    pub(crate) fn near(&self, x: &Decay) -> Values {
        let [sine, cosine, alternating, plain] = self.sums(x);
        let over = 1.0 / cosine;
        let [s, c, d] = self.near;
        let rise = 2.0 * x.root * over;
        Values { sn: s * sine * over, cn: c * alternating * rise, dn: d * plain * rise }
    }

    /// The three functions at `K - u`, where `x` belongs to `u`, so that the small ones keep their digits.
    pub(crate) fn far(&self, x: &Decay) -> Values {
        let [sine, cosine, alternating, plain] = self.sums(x);
        let over = 1.0 / plain;
        let [s, c, d] = self.far;
        let fall = 0.5 / x.root * over;
        Values { sn: s * alternating * over, cn: c * sine * fall, dn: d * cosine * fall }
    }
}
