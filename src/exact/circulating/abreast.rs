//! Circulating motions side by side: what an instant needs of each, by lanes, the spin's part and the attitude's apart.

use super::way::Way;
use super::{Elliptic, Form, advanced, drifted};
use crate::exact::elliptic::{Hyperbolic, Trigonometric};
use crate::exact::klein::{self, HyperbolicPair, Pair, TrigonometricPair, phase};
use crate::number::double_double::DoubleDouble;
use crate::number::{Lane, gathered};
use alloc::vec::Vec;

/// Which way round the axes go, which differs from body to body.
#[derive(Debug, Clone, PartialEq)]
struct Axes<T> {
    /// Index of the axis circled.
    around: T,
    /// Above zero where across, middle and around follow each other in cyclic order.
    sense: T,
}

impl<T: Lane> Axes<T> {
    fn gathered(from: &[&Elliptic]) -> Self {
        let index = |e: &&Elliptic| f64::from(u8::try_from(e.axes[2]).unwrap_or(0));
        let cyclic = |e: &&Elliptic| (e.axes[0] + 1) % 3 == e.axes[1];
        Self { around: gathered(from, index), sense: gathered(from, |e| if cyclic(e) { 1.0 } else { -1.0 }) }
    }

    /// In the order of the body, from that which begins with the axis circled.
    #[inline(always)]
    fn arranged(&self, [first, second, third]: [T; 3]) -> [T; 3] {
        let (is_first, is_third) = (self.around.lt(T::splat(0.5)), T::splat(1.5).lt(self.around));
        let one_of = |first, second, third| T::select(is_first, first, T::select(is_third, third, second));
        [one_of(first, third, second), one_of(second, first, third), one_of(third, second, first)]
    }

    /// The spin from Jacobi's functions.
    #[inline(always)]
    fn spin(&self, amplitudes: &[T; 3], [sn, cn, dn]: [T; 3]) -> [T; 3] {
        let (across, middle) = (amplitudes[0] * cn, amplitudes[1] * sn);
        let cyclic = T::splat(0.0).lt(self.sense);
        let (next, last) = (T::select(cyclic, across, middle), T::select(cyclic, middle, across));
        self.arranged([amplitudes[2] * dn, next, last])
    }

    /// The turn since the start.
    #[inline(always)]
    fn turn(&self, [real, i, j, k]: [T; 4]) -> [T; 4] {
        let [x, y, z] = self.arranged([i, j, k]);
        klein::unit([real, x, y, z])
    }
}

/// The spins of bodies away from the separatrix.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Waving<T> {
    spin: Trigonometric<T>,
    start: [T; 2],
    turns: DoubleDouble<T>,
    amplitudes: [T; 3],
    axes: Axes<T>,
}

/// What their attitudes need besides.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WavingTurn<T> {
    pair: TrigonometricPair<T>,
    start: Pair<T>,
    drift: DoubleDouble<T>,
}

/// The spins of bodies near the separatrix.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lingering<T> {
    spin: Hyperbolic<T>,
    way: Way<T>,
    amplitudes: [T; 3],
    axes: Axes<T>,
}

/// What their attitudes need besides.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LingeringTurn<T> {
    pair: HyperbolicPair<T>,
    start: Pair<T>,
    drift: DoubleDouble<T>,
    step: T,
}

/// The two forms of circulating, of one body.
pub(crate) enum Going<'a> {
    Waving(&'a Elliptic),
    Lingering(&'a Elliptic),
    /// On the separatrix, or out of the range in which the spin comes out in one product.
    Alone,
}

impl Elliptic {
    pub(crate) fn going(&self) -> Going<'_> {
        let plain = self.unscale == [[1.0; 2]; 3];
        match &self.form {
            Form::Trigonometric { .. } if plain => Going::Waving(self),
            Form::Hyperbolic { way, .. } if plain && !way.endless() => Going::Lingering(self),
            _ => Going::Alone,
        }
    }

    fn trigonometric(&self) -> Option<(&Trigonometric, &TrigonometricPair, &[f64; 2], DoubleDouble)> {
        match &self.form {
            Form::Trigonometric { spin, pair, start, turns, .. } => Some((spin, pair, start, *turns)),
            Form::Hyperbolic { .. } => None,
        }
    }

    fn hyperbolic(&self) -> Option<(&Hyperbolic, &HyperbolicPair, &Way, f64)> {
        match &self.form {
            Form::Hyperbolic { spin, pair, way, step } => Some((spin, pair, way, *step)),
            Form::Trigonometric { .. } => None,
        }
    }
}

fn doubles<T: Lane, S>(from: &[S], of: impl Fn(&S) -> DoubleDouble) -> DoubleDouble<T> {
    DoubleDouble::parts(gathered(from, |s| of(s).hi()), gathered(from, |s| of(s).lo()))
}

fn amplitudes<T: Lane>(from: &[&Elliptic]) -> [T; 3] {
    [0, 1, 2].map(|n| gathered(from, |e| e.grand[n]))
}

impl<T: Lane> Waving<T> {
    /// Of those that go so; those that do not are left out.
    pub(crate) fn gathered(from: &[&Elliptic]) -> (Self, WavingTurn<T>) {
        let parts: Vec<_> = from.iter().filter_map(|e| e.trigonometric()).collect();
        let spins = Self {
            spin: Trigonometric::gathered(&parts, |p| p.0),
            start: [0, 1].map(|n| gathered(&parts, |p| p.2[n])),
            turns: doubles(&parts, |p| p.3),
            amplitudes: amplitudes(from),
            axes: Axes::gathered(from),
        };
        let turns = WavingTurn {
            pair: TrigonometricPair::gathered(&parts, |p| p.1),
            start: Pair::gathered(from, |e| &e.start),
            drift: doubles(from, |e| e.drift),
        };
        (spins, turns)
    }

    #[inline(always)]
    pub(crate) fn omega(&self, time: T) -> [T; 3] {
        let (sin, cos) = advanced(&self.start, self.turns * time);
        self.axes.spin(&self.amplitudes, self.spin.values(sin, cos))
    }

    #[inline(always)]
    pub(crate) fn at(&self, turn: &WavingTurn<T>, time: T) -> ([T; 3], [T; 4]) {
        let (sin, cos) = advanced(&self.start, self.turns * time);
        let nothing = T::splat(0.0);
        let phase = phase(drifted(turn.drift, time, DoubleDouble::parts(nothing, nothing)));
        let turned = turn.pair.raw(sin, cos).turned(phase);
        let spin = self.axes.spin(&self.amplitudes, self.spin.values(sin, cos));
        (spin, self.axes.turn(turned.since(&turn.start)))
    }
}

impl<T: Lane> Lingering<T> {
    /// Of those that go so; those that do not are left out.
    pub(crate) fn gathered(from: &[&Elliptic]) -> (Self, LingeringTurn<T>) {
        let parts: Vec<_> = from.iter().filter_map(|e| e.hyperbolic()).collect();
        let spins = Self {
            spin: Hyperbolic::gathered(&parts, |p| p.0),
            way: Way::gathered(&parts, |p| p.2),
            amplitudes: amplitudes(from),
            axes: Axes::gathered(from),
        };
        let turns = LingeringTurn {
            pair: HyperbolicPair::gathered(&parts, |p| p.1),
            start: Pair::gathered(from, |e| &e.start),
            drift: doubles(from, |e| e.drift),
            step: gathered(&parts, |p| p.3),
        };
        (spins, turns)
    }

    #[inline(always)]
    pub(crate) fn omega(&self, time: T) -> [T; 3] {
        self.axes.spin(&self.amplitudes, self.way.between_saddles(time).values(&self.spin))
    }

    #[inline(always)]
    pub(crate) fn at(&self, turn: &LingeringTurn<T>, time: T) -> ([T; 3], [T; 4]) {
        let place = self.way.between_saddles(time);
        let extra = DoubleDouble::product(place.halves, turn.step);
        let turned = place.pair(&turn.pair).turned(phase(drifted(turn.drift, time, extra)));
        let spin = self.axes.spin(&self.amplitudes, place.values(&self.spin));
        (spin, self.axes.turn(turned.since(&turn.start)))
    }
}
