//! Jacobi's functions near and on the separatrix: theta sums in hyperbolic functions, after Jacobi's
//! imaginary transformation.

use crate::number::functions::powi;
use crate::number::{Gather, Lane, Series, gather_fields};

/// A decaying exponential of the argument: `E = exp(-2x)` with `1 - E` and the square root of `E`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Decay<T = f64> {
    /// `exp(-x)`.
    pub(crate) root: T,
    /// `exp(-2x)`.
    square: T,
    /// `1 - exp(-2x)`, small where `x` is.
    pub(crate) short_of_one: T,
    /// The root of the complementary nome over `exp(-x)`: this exponential from the other end of the passage.
    pub(crate) rising: T,
}

impl<T: Lane> Decay<T> {
    /// Of `x = main + rest >= 0`, with the root of the complementary nome.
    #[inline(always)]
    pub(crate) fn new(main: T, rest: T, nome_root: T) -> Self {
        let [root, less] = main.decay(rest);
        Self { root, square: root * root, short_of_one: -less * (less + 2.0), rising: nome_root / root }
    }
}

/// The spin's theta functions as sums in the complementary nome `p`, for one of at most 0.02: that is a nome
/// above 0.08.
///
/// ```
/// use tumbling::laws::ComplementarySeries;
/// // theta_2 at the start of a passage, without its first factor: 1 + p² + p⁶.
/// assert_eq!(ComplementarySeries::constants(0.5_f64)[0], 1.265625);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComplementarySeries<T = f64> {
    /// Powers of `p`: the second, the fourth, the first.
    powers: [T; 3],
    /// What makes `sn`, `cn` and `dn` of the quotients: up to half the quarter period, and beyond.
    pub(super) near_flip: [T; 3],
    pub(super) near_saddle: [T; 3],
}

gather_fields!(ComplementarySeries { powers, near_flip, near_saddle });

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

    /// From the nome and the complement of the modulus. For a `stretch` other than 1 the complement is times
    /// that, and `cn` and `dn` come out so too.
    pub fn new(p: T, complement: T, stretch: T) -> Self {
        let [second, third, fourth] = Self::constants(p.clone());
        let p2 = p.clone() * p.clone();
        let sine = third.clone() / fourth.clone();
        Self {
            powers: [p2.clone(), p2.clone() * p2, p],
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
        let [p2, p4, p] = [0, 1, 2].map(|k| move || self.powers[k].clone());
        let (square, one) = (e.clone() * e.clone(), T::one);
        // exp(-x) times twice sinh and cosh of 3x is exp(2x) (1 ∓ E³), of 5x is exp(4x) (1 ∓ E⁵); differences
        // by 1 - E, which has all its digits where they are small.
        let (b, c) = (p() * growing.clone(), p4() * growing.clone() * growing.clone());
        let (cube, fourth) = (e.clone() * square.clone(), square.clone() * square.clone());
        let quotient = e.clone() + one() + square.clone();
        let longer = quotient.clone() + (cube.clone() + fourth.clone());
        // The next are exp(6x) (1 ∓ E⁷), times the nome to the twelfth.
        let next = || T::integer(2) * powi(growing.clone(), 3) * powi(p(), 9);
        let seventh = || longer.clone() + fourth.clone() * (e.clone() + square.clone());
        // (C28)
        let sine = short_of_one.clone() - b.clone() * short_of_one.clone() * quotient
            + c.clone() * short_of_one.clone() * longer.clone();
        let sine = sine.up_to(|| next() * short_of_one * seventh());
        let cosine =
            (e.clone() + one()) + b * (cube.clone() + one()) + c * (e.clone() * fourth.clone() + one());
        let cosine = cosine.up_to(|| next() * (one() + cube.clone() * fourth.clone()));
        // p cosh 2x = growing (1 + E²)/2 and so on; p⁴ cosh 4x, p⁹ cosh 6x; the next is p¹⁶ cosh 8x.
        let first = growing.clone() + p() * e;
        let second = p2() * (growing.clone() * growing.clone() + p2() * square);
        let third = growing.clone() * growing.clone() * growing.clone() + p2() * p() * cube;
        let third = p4() * p2() * third;
        let (even, odd) = (second + one(), first + third);
        let even = even.up_to(|| T::integer(2) * powi(p(), 12) * (powi(growing, 4) + p4() * fourth));
        [sine, cosine, even.clone() - odd.clone(), even + odd]
    }

    /// What `sn`, `cn` and `dn` are made of, from `exp(-x)` and those sums: nearer to the flip, where `x` is
    /// the distance from it, and nearer to the saddle, where it is the distance from that.
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

/// What `sn`, `cn` and `dn` are made of.
#[derive(Debug, Clone, Copy)]
pub struct Parts<T> {
    factors: [T; 3],
    /// The sums above, and what is below.
    above: [T; 3],
    under: T,
    /// What `sn` is times, and the other two.
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

impl<T: Lane> ComplementarySeries<T> {
    /// The four sums at this argument.
    #[inline(always)]
    pub(super) fn sums_of(&self, x: &Decay<T>) -> [T; 4] {
        self.sums(x.square, x.short_of_one, x.rising * x.rising)
    }

    /// `sn`, `cn`, `dn` where `x` is the argument times `pi/(2K')`, up to half the quarter period; or, at a
    /// `saddle`, what is left of it to the quarter period.
    #[inline(always)]
    pub(crate) fn values(&self, x: &Decay<T>, saddle: T::Mask) -> [T; 3] {
        let [flip, at_saddle] = self.parts(x.root, self.sums_of(x));
        let one = |yes: T, no: T| T::select(saddle, yes, no);
        let three = |yes: [T; 3], no: [T; 3]| [0, 1, 2].map(|n| T::select(saddle, yes[n], no[n]));
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
