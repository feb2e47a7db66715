//! Jacobi's argument, reduced to one passage between two saddles.
//!
//! A saddle is where the motion passes the middle axis, a flip where its spin along that axis vanishes; the
//! two alternate every quarter period `K`. Near the separatrix a passage is long, and what counts is the
//! distance from the nearest of the two.

use crate::exact::cayley_klein::{ComplementaryPair, Pair};
use crate::exact::elliptic::{ComplementarySeries, Decay};
use crate::number::{DoubleDouble, Gather, Lane, Real, Rounding, gather_fields, splat};
use core::hint::black_box;

/// How Jacobi's argument runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Reduction<T = f64> {
    /// Half periods at the start, from the nearest flip; on the separatrix, which has none, the argument.
    pub(crate) start: DoubleDouble<T>,
    /// Half periods per unit of time, or the argument, likewise.
    pub(crate) rate: DoubleDouble<T>,
    /// From flip to saddle (on the separatrix the largest `f64`), and from flip to flip (there infinite).
    pub(crate) quarter: DoubleDouble<T>,
    pub(crate) half: DoubleDouble<T>,
    /// `pi/(2K')`.
    pub(crate) stretch: T,
    /// The square root of the complementary nome: `exp(-x)` at the saddle.
    pub(crate) nome_root: T,
    /// The sign of `cn` at the start.
    pub(crate) turn: T,
}

gather_fields!(Reduction { start, rate, quarter, half, stretch, nome_root, turn });

/// Where in a passage the argument is: `x`, its distance from the nearest flip or saddle, in two parts.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Passage<T: Rounding = f64> {
    x: [T; 2],
    near_saddle: T::Mask,
    /// Its sign, from the nearest flip.
    sign: T,
    /// The sign of `cn`.
    turn: T,
    /// Half periods since the start.
    pub(super) halves: DoubleDouble<T>,
}

/// The argument at one instant, with `exp(-x)`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ReducedArgument<T: Rounding = f64> {
    decay: Decay<T>,
    pub(super) passage: Passage<T>,
}

impl<T: Real> Reduction<T> {
    /// From the argument at the start, its rate per unit of time, `K` (infinite on the separatrix), `K'` and
    /// the sign of `cn` at the start.
    pub(crate) fn new(
        start: DoubleDouble<T>,
        rate: DoubleDouble<T>,
        quarter: DoubleDouble<T>,
        other: T,
        turn: T,
    ) -> Self {
        let pi = DoubleDouble::<T>::pi().hi();
        let stretch = pi / (other * 2.0);
        if !quarter.hi().finite() {
            // More than any argument, but not infinite, since it may be multiplied by zero.
            let far = DoubleDouble::from(splat::<T>(f64::MAX));
            return Self { start, rate, quarter: far, half: quarter, stretch, nome_root: T::zero(), turn };
        }
        let half = quarter.times_exact(splat(2.0));
        // (C9)
        let nome_root = (-(pi * 0.5) / (other / quarter.hi())).exp_and_exp_m1().0;
        Self { start: start / half, rate: rate / half, quarter, half, stretch, nome_root, turn }
    }

    /// From an argument at the start that is less by this much.
    pub(crate) fn back(self, shift: T) -> Self {
        let shift = if self.half.hi().finite() { shift / self.half.hi() } else { shift };
        Self { start: self.start - DoubleDouble::from(shift), ..self }
    }

    /// At a time, on the separatrix too.
    #[inline(always)]
    pub(crate) fn argument(&self, time: T) -> ReducedArgument<T> {
        self.reduced(if self.half.hi().finite() { self.at(time) } else { self.without_return(time) })
    }

    /// On the separatrix, where there is no half period to take off.
    // Not inlined: the separatrix is rare, and all other motions are faster without this code.
    #[inline(never)]
    fn without_return(&self, time: T) -> Passage<T> {
        // Beyond the end of the range the spin reached the middle axis long before: any argument that large
        // gives the same result.
        let (run, beyond) = (self.rate * time, splat::<T>(1e300));
        let end = DoubleDouble::from(beyond * self.rate.hi().sign() * time.sign());
        self.passage(
            (DoubleDouble::from(T::zero()), T::zero()),
            if run.hi().abs().lt(beyond) { run.plus(self.start) } else { end },
        )
    }
}

impl<T: Rounding> Reduction<T> {
    /// At a time, where the motion returns.
    #[inline(always)]
    pub(crate) fn at(&self, time: T) -> Passage<T> {
        // (C35)
        let (halves, by_four, rest) = self.rate.times_loosely(time).plus(self.start).whole_and_rest();
        self.passage((halves, by_four), self.half * rest)
    }

    #[inline(always)]
    fn passage(&self, (halves, by_four): (DoubleDouble<T>, T), u: DoubleDouble<T>) -> Passage<T> {
        let sign = u.hi().sign();
        let from_flip = u.times_exact(sign);
        // By a sign and a sum: of two cases the compiler makes a branch, often guessed wrong.
        let onwards = (self.quarter.hi() * 0.5 - from_flip.hi()).sign();
        let quarter = self.quarter.times_exact((T::one() - onwards) * 0.5);
        let distance = quarter.plus(from_flip.times_exact(onwards));
        // Rounding may leave it slightly beyond the saddle.
        let main = distance.hi();
        let x = main.not_below_zero() * self.stretch;
        Passage {
            x: [x, distance.lo() * self.stretch],
            near_saddle: onwards.lt(T::zero()),
            sign,
            // Two quarters each.
            turn: (by_four * 2.0).after_quarters(self.turn, self.turn).0,
            halves,
        }
    }

    /// With the exponentials.
    #[inline(always)]
    pub(super) fn reduced(&self, passage: Passage<T>) -> ReducedArgument<T> {
        let [x, rest] = passage.x;
        ReducedArgument { decay: Decay::new(x, rest, self.nome_root), passage }
    }
}

/// An argument by its exponentials from both ends of the passage.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exponentials {
    /// `exp(-X)` of its distance `X` from the nearest flip, and of what is left to the saddle.
    pub(crate) falling: f64,
    pub(crate) rising: f64,
    /// 1 less the square of each, small next to a flip and to a saddle.
    pub(crate) short_of_one: [f64; 2],
    /// The sign of the distance, and -1 after an odd number of half periods.
    pub(crate) sign: f64,
    pub(crate) turn: f64,
    /// Half periods since the start.
    pub(crate) halves: DoubleDouble,
}

impl Exponentials {
    pub(crate) fn at_flip(nome: f64) -> Self {
        let root = Lane::sqrt(nome);
        Self {
            falling: 1.0,
            rising: root,
            short_of_one: [0.0, 1.0 - nome],
            sign: 1.0,
            turn: 1.0,
            halves: DoubleDouble::ZERO,
        }
    }

    pub(crate) fn at_saddle(nome: f64) -> Self {
        let flip = Self::at_flip(nome);
        Self { falling: flip.rising, rising: 1.0, short_of_one: [1.0 - nome, 0.0], ..flip }
    }
}

impl ReducedArgument {
    #[inline(always)]
    pub(crate) fn exponentials(&self) -> Exponentials {
        let Self { decay, passage: Passage { near_saddle, sign, turn, halves, .. } } = *self;
        let (falling, rising) =
            if near_saddle { (decay.rising, decay.root) } else { (decay.root, decay.rising) };
        let short_of_one = if near_saddle {
            [1.0 - falling * falling, decay.short_of_one]
        } else {
            [decay.short_of_one, 1.0 - rising * rising]
        };
        Exponentials { falling, rising, short_of_one, sign, turn, halves }
    }
}

impl<T: Rounding> ReducedArgument<T> {
    /// The attitude's two numbers here.
    #[inline(always)]
    pub(super) fn pair(&self, pair: &ComplementaryPair<T>) -> Pair<T> {
        let [root, rising] = [self.decay.root, self.decay.rising];
        let Passage { near_saddle, sign, turn, .. } = self.passage;
        let [here, there] = if T::WIDTH == 1 {
            // From memory, as in `after_quarters`.
            [[root, rising], [rising, root]][black_box(usize::from(T::any(near_saddle))) % 2]
        } else {
            [T::select(near_saddle, rising, root), T::select(near_saddle, root, rising)]
        };
        pair.raw(here, there, sign, turn)
    }

    /// `sn`, `cn`, `dn` here.
    #[inline(always)]
    pub(super) fn values(&self, series: &ComplementarySeries<T>) -> [T; 3] {
        let Passage { near_saddle, sign, turn, .. } = self.passage;
        let [sn, cn, dn] = series.values(&self.decay, near_saddle);
        [turn * sign * sn, turn * cn, dn]
    }
}
