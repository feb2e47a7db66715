//! Jacobi's functions near and on the separatrix: theta sums in hyperbolic functions, after Jacobi's
//! imaginary transformation.

use crate::number::functions::powi;
use crate::number::{Gather, Rounding, Series, gather_fields, splat};
use core::hint::black_box;

/// A decaying exponential of the argument: `E = exp(-2x)` with `1 - E` and the square root of `E`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Decay<T = f64> {
    /// `exp(-x)`.
    pub(crate) root: T,
    /// `exp(-2x)`.
    square: T,
    /// `1 - exp(-2x)`, small where `x` is.
    pub(crate) short_of_one: T,
    /// The root of the complementary nome divided by `exp(-x)`: the same exponential from the other end of
    /// the passage.
    pub(crate) rising: T,
}

impl<T: Rounding> Decay<T> {
    /// From `x = main + rest >= 0` and the square root of the complementary nome.
    #[inline(always)]
    pub(crate) fn new(main: T, rest: T, nome_root: T) -> Self {
        let [root, less] = main.decay(rest);
        // At a saddle this is zero, not -0: the remainder takes its sign.
        let short_of_one = T::zero() - less * (less + 2.0);
        Self { root, square: root * root, short_of_one, rising: nome_root / root }
    }
}

/// The spin's theta functions as sums in the complementary nome `p`, which must be at most 0.02; the nome is
/// then above 0.08.
///
/// ```
/// use tumbling::laws::ComplementarySeries;
/// // theta_2 at the start of a passage, without its first factor: 1 + p² + p⁶.
/// assert_eq!(ComplementarySeries::constants(0.5_f64)[0], 1.265625);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComplementarySeries<T = f64> {
    nome: T,
    /// As polynomials in the sum of the growing and the falling exponential: `theta_3, theta_4 = even ± odd`.
    outer: [T; 4],
    /// `theta_2` and `theta_1` without `cosh x` and `sinh x`, likewise.
    inner: [T; 3],
    /// The factors that give `sn`, `cn` and `dn` from the quotients: up to half the quarter period, and
    /// beyond.
    pub(super) near_flip: [T; 3],
    pub(super) near_saddle: [T; 3],
}

gather_fields!(ComplementarySeries { nome, outer, inner, near_flip, near_saddle });

impl<T: Series> ComplementarySeries<T> {
    /// `theta_2` without its first factor, `theta_3` and `theta_4` where the argument is zero.
    pub fn constants(p: T) -> [T; 3] {
        let n = T::integer;
        let p2 = p.clone() * p.clone();
        let p4 = p2.clone() * p2.clone();
        let odd = n(2) * (p.clone() + p4.clone() * p4.clone() * p.clone());
        let even = (n(1) + n(2) * p4.clone()).up_to(|| n(3) * powi(p.clone(), 16));
        let second = (n(1) + p2.clone() + p2 * p4).up_to(|| n(2) * powi(p.clone(), 12));
        [second, even.clone() + odd.clone(), even - odd]
    }

    /// From the nome and the complement of the modulus. If `stretch` is not 1, the complement must be
    /// multiplied by it, and `cn` and `dn` are then multiplied by it too.
    pub fn new(p: T, complement: T, stretch: T) -> Self {
        let [second, third, fourth] = Self::constants(p.clone());
        let n = T::integer;
        let power = |k| powi(p.clone(), k);
        let sine = third.clone() / fourth.clone();
        Self {
            // (C28), with twice the nome times cosh 2x for the variable.
            outer: [n(1) - n(2) * power(4), power(2), n(1) - n(3) * power(8), power(6)],
            inner: [n(1) - power(2) - power(6), power(4), p.clone() - power(5)],
            nome: p,
            // (C29)
            near_flip: [
                sine.clone(),
                stretch.clone() * (second.clone() / fourth.clone()),
                stretch * (second.clone() / third.clone()),
            ],
            // (C30)
            near_saddle: [
                sine,
                complement.clone() * (third.clone() * third.clone() / (fourth * second.clone())),
                complement * (third / second),
            ],
        }
    }

    /// The four sums without their first exponential: those of the odd multiples, alternating (a hyperbolic
    /// sine) and not (a cosine), then those of the even multiples, alternating and not. From `e = exp(-2x)`,
    /// 1 less it, and `growing = p/e`.
    #[inline(always)]
    pub fn sums(&self, e: T, short_of_one: T, growing: T) -> [T; 4] {
        let p = || self.nome.clone();
        let g = growing + p() * e.clone();
        let square = g.clone() * g.clone();
        let ([a, b, c, d], [f, h, k]) = (self.outer.clone(), self.inner.clone());
        // The next are 2 p¹⁶ cosh 8x, and p¹² sinh 7x and cosh 7x over sinh x and cosh x.
        let even = (a + b * square.clone()).up_to(|| T::integer(2) * powi(p(), 12) * powi(g.clone(), 4));
        let odd = g.clone() * (c + d * square.clone());
        let inner = (f + h * square).up_to(|| T::integer(3) * powi(p(), 9) * powi(g.clone(), 3));
        let inner_odd = g.clone() * k;
        [
            short_of_one * (inner.clone() - inner_odd.clone()),
            (e + T::one()) * (inner + inner_odd),
            even.clone() - odd.clone(),
            even + odd,
        ]
    }

    /// The terms of `sn`, `cn` and `dn`, from `exp(-x)` and those sums: nearer to the flip, where `x` is the
    /// distance from it, and nearer to the saddle, where `x` is the distance from the saddle.
    #[inline(always)]
    pub fn parts(&self, root: T, [sine, cosine, alternating, plain]: [T; 4]) -> [Parts<T>; 2] {
        let (one, half) = (T::one(), T::one() / T::integer(2));
        let (flip, saddle) = (self.near_flip.clone(), self.near_saddle.clone());
        let above = [sine.clone(), alternating.clone(), plain.clone()];
        [
            Parts {
                factors: flip,
                above,
                under: cosine.clone(),
                rise: one,
                fall: T::integer(2) * root.clone(),
            },
            Parts {
                factors: saddle,
                above: [alternating, sine, cosine],
                under: plain * root.clone(),
                rise: root,
                fall: half,
            },
        ]
    }
}

/// The terms of `sn`, `cn` and `dn`.
#[derive(Debug, Clone, Copy)]
pub struct Parts<T> {
    factors: [T; 3],
    /// The sums in the numerators, and the denominator.
    above: [T; 3],
    under: T,
    /// The factor of `sn`, and that of the other two.
    rise: T,
    fall: T,
}

impl<T: Series> Parts<T> {
    /// `sn`, `cn`, `dn`, so that the small ones keep their digits.
    #[inline(always)]
    pub fn quotients(self) -> [T; 3] {
        let ([s, c, d], [first, second, third]) = (self.factors, self.above);
        // (C29), (C30)
        let inverse = T::one() / self.under;
        let fall = self.fall * inverse.clone();
        [s * first * (self.rise * inverse), c * second * fall.clone(), d * third * fall]
    }
}

impl<T: Rounding> ComplementarySeries<T> {
    /// The four sums at this argument.
    #[inline(always)]
    pub(super) fn sums_of(&self, x: &Decay<T>) -> [T; 4] {
        self.sums(x.square, x.short_of_one, x.rising * x.rising)
    }

    /// `sn`, `cn`, `dn` for `x`, the argument times `pi/(2K')`, up to half the quarter period; at a `saddle`,
    /// `x` is the distance of the argument from the quarter period, times the same.
    #[inline(always)]
    pub(crate) fn values(&self, x: &Decay<T>, saddle: T::Mask) -> [T; 3] {
        let sums = self.sums_of(x);
        if T::WIDTH == 1 {
            // From memory, as in `after_quarters`: the same parts, two sums changed for the two others.
            let one = black_box(usize::from(T::any(saddle))) % 2;
            let sum = |k: usize| sums[(k + 2 * one) % 4];
            let (factors, rise) = ([self.near_flip, self.near_saddle][one], [T::one(), x.root][one]);
            let fall = [x.root * 2.0, splat(0.5)][one];
            let above = [sum(0), sum(2), sum(3)];
            return Parts { factors, above, under: sum(1) * rise, rise, fall }.quotients();
        }
        let [flip, at_saddle] = self.parts(x.root, sums);
        let one = |yes: T, no: T| T::select(saddle, yes, no);
        let three = |[a, b, c]: [T; 3], [x, y, z]: [T; 3]| [one(a, x), one(b, y), one(c, z)];
        Parts {
            factors: three(at_saddle.factors, flip.factors),
            above: three(at_saddle.above, flip.above),
            under: one(at_saddle.under, flip.under),
            rise: one(at_saddle.rise, flip.rise),
            fall: one(at_saddle.fall, flip.fall),
        }
        .quotients()
    }
}
