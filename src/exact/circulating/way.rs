//! Where the motion stands between two saddles: Jacobi's argument folded onto one passage.

use crate::exact::elliptic::{self, Decay, Hyperbolic};
use crate::exact::klein::{HyperbolicPair, Pair};
use crate::number::double_double::DoubleDouble;
use crate::number::{Lane, gathered};

/// Where Jacobi's argument stands, folded between the two saddles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Way<T = f64> {
    pub(super) start: DoubleDouble<T>,
    /// Half turns per unit of time, or on the separatrix, where there are none, the argument itself.
    pub(super) rate: DoubleDouble<T>,
    /// From flip to saddle, and from flip to flip: infinite on the separatrix.
    pub(super) quarter: DoubleDouble<T>,
    pub(super) half: DoubleDouble<T>,
    /// `pi/(2K')`.
    pub(super) stretch: T,
    /// The root of the complementary nome: `exp(-x)` at the saddle.
    pub(super) nome_root: T,
    /// Sign of the start after folding.
    pub(super) turn: T,
}

/// A place on the way: `exp(-x)` in full, from the nearer end.
pub(crate) struct Place<T: Lane = f64> {
    pub(super) decay: Decay<T>,
    far: T::Mask,
    side: T,
    turn: T,
    pub(crate) halves: T,
}

impl Way {
    /// On any way, also on the separatrix.
    #[inline(always)]
    pub(super) fn at(&self, time: f64) -> Place {
        if !self.endless() {
            return self.between_saddles(time);
        }
        // Past the end of the range the spin has long come to rest on the middle axis: any place far out will do.
        let run = self.rate * time;
        let end = DoubleDouble::from(1e300_f64.copysign(self.rate.hi()) * 1_f64.copysign(time));
        self.place(0.0, if run.hi().abs() < 1e300 { run.plus(self.start) } else { end })
    }

    /// Whether it is the separatrix.
    pub(crate) fn endless(&self) -> bool {
        self.quarter.hi().is_infinite()
    }
}

impl<T: Lane> Way<T> {
    /// Those of many, side by side.
    pub(crate) fn gathered<S>(from: &[S], of: impl Fn(&S) -> &Way) -> Self {
        let double = |of: &dyn Fn(&S) -> DoubleDouble| -> DoubleDouble<T> {
            DoubleDouble::parts(gathered(from, |s| of(s).hi()), gathered(from, |s| of(s).lo()))
        };
        Self {
            start: double(&|s| of(s).start),
            rate: double(&|s| of(s).rate),
            quarter: double(&|s| of(s).quarter),
            half: double(&|s| of(s).half),
            stretch: gathered(from, |s| of(s).stretch),
            nome_root: gathered(from, |s| of(s).nome_root),
            turn: gathered(from, |s| of(s).turn),
        }
    }

    /// On a way that comes to its end.
    #[inline(always)]
    pub(crate) fn between_saddles(&self, time: T) -> Place<T> {
        let (halves, left) = (self.rate * time).split();
        self.place(halves, (self.half * left).plus(self.start))
    }

    #[inline(always)]
    fn place(&self, mut halves: T, mut u: DoubleDouble<T>) -> Place<T> {
        let beyond = self.quarter.hi().lt(u.hi().abs());
        if T::any(beyond) {
            let side = u.hi().sign();
            u = DoubleDouble::select(beyond, u.plus(self.half.signed(-side)), u);
            halves = T::select(beyond, halves + side, halves);
        }
        let side = u.hi().sign();
        let size = u.signed(side);
        let far = (self.quarter.hi() * 0.5).lt(size.hi());
        let from_end = DoubleDouble::select(far, self.quarter.plus(size.signed(T::splat(-1.0))), size);
        let nothing = T::splat(0.0);
        let odd = nothing.lt((halves - (halves * 0.5).round_ties_even() * 2.0).abs());
        // Rounding may leave it a hair beyond the saddle.
        let left = from_end.hi();
        let x = T::select(nothing.lt(left), left, nothing) * self.stretch;
        Place {
            decay: Decay::new(x, from_end.lo() * self.stretch, self.nome_root),
            far,
            side,
            turn: T::select(odd, -self.turn, self.turn),
            halves,
        }
    }
}

impl Place {
    pub(super) fn spin(&self, spin: &Hyperbolic) -> elliptic::Values {
        let [sn, cn, dn] = self.values(spin);
        elliptic::Values { sn, cn, dn }
    }
}

impl<T: Lane> Place<T> {
    /// The attitude's two numbers here.
    #[inline(always)]
    pub(crate) fn pair(&self, pair: &HyperbolicPair<T>) -> Pair<T> {
        let [root, rising] = [self.decay.root, self.decay.rising];
        pair.raw(T::select(self.far, rising, root), T::select(self.far, root, rising), self.side, self.turn)
    }

    /// `sn`, `cn`, `dn` here.
    #[inline(always)]
    pub(crate) fn values(&self, spin: &Hyperbolic<T>) -> [T; 3] {
        let [sn, cn, dn] = spin.values(&self.decay, self.far);
        [self.turn * self.side * sn, self.turn * cn, dn]
    }
}
