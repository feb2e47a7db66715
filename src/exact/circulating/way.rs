//! Where the motion stands between two saddles: Jacobi's argument folded onto one passage.

use crate::exact::elliptic::{self, Decay, Hyperbolic};
use crate::exact::klein::{HyperbolicPair, Pair};
use crate::number::double_double::Double;
use crate::number::{Lane, gathered};

/// Where Jacobi's argument stands, folded between the two saddles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Way<T = f64> {
    pub(super) start: Double<T>,
    /// Half turns per unit of time, or on the separatrix, where there are none, the argument itself.
    pub(super) rate: Double<T>,
    /// From flip to saddle, and from flip to flip: infinite on the separatrix.
    pub(super) quarter: Double<T>,
    pub(super) half: Double<T>,
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
        let end = Double::from(1e300_f64.copysign(self.rate.value()) * 1_f64.copysign(time));
        self.place(0.0, if run.value().abs() < 1e300 { run.plus(self.start) } else { end })
    }

    /// Whether it is the separatrix.
    pub(crate) fn endless(&self) -> bool {
        self.quarter.value().is_infinite()
    }
}

impl<T: Lane> Way<T> {
    /// Those of many, side by side.
    pub(crate) fn gathered<S>(from: &[S], of: impl Fn(&S) -> &Way) -> Self {
        let double = |of: &dyn Fn(&S) -> Double| -> Double<T> {
            Double::parts(gathered(from, |s| of(s).value()), gathered(from, |s| of(s).rest()))
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
    fn place(&self, mut halves: T, mut u: Double<T>) -> Place<T> {
        let beyond = self.quarter.value().below(u.value().size());
        if T::any(beyond) {
            let side = u.value().sign();
            u = Double::choose(beyond, u.plus(self.half.signed(-side)), u);
            halves = T::choose(beyond, halves + side, halves);
        }
        let side = u.value().sign();
        let size = u.signed(side);
        let far = (self.quarter.value() * 0.5).below(size.value());
        let from_end = Double::choose(far, self.quarter.plus(size.signed(T::of(-1.0))), size);
        let nothing = T::of(0.0);
        let odd = nothing.below((halves - (halves * 0.5).whole() * 2.0).size());
        // Rounding may leave it a hair beyond the saddle.
        let left = from_end.value();
        let x = T::choose(nothing.below(left), left, nothing) * self.stretch;
        Place {
            decay: Decay::new(x, from_end.rest() * self.stretch, self.nome_root),
            far,
            side,
            turn: T::choose(odd, -self.turn, self.turn),
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
        pair.raw(T::choose(self.far, rising, root), T::choose(self.far, root, rising), self.side, self.turn)
    }

    /// `sn`, `cn`, `dn` here.
    #[inline(always)]
    pub(crate) fn values(&self, spin: &Hyperbolic<T>) -> [T; 3] {
        let [sn, cn, dn] = spin.values(&self.decay, self.far);
        [self.turn * self.side * sn, self.turn * cn, dn]
    }
}
