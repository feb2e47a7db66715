//! Mistakes that turn and gyroscopic change show together: times that are wrong by one factor; and one of the
//! engine that looks like the file's, an attitude that is turned by its spin in the other axes.

use crate::read::reading::{Reading, Step, alike};
use crate::read::{Pair, median, middle_and_most};
use crate::thresholds::*;
use nalgebra::Vector3;
use tumbling::attitude::{product, rotation_matrix};
use tumbling::exact::FreeMotion;

/// The nearest whole number, and the ratio that it stands for: itself, or one over it.
fn whole(ratio: f64) -> [f64; 2] {
    let count = ratio.max(1.0 / ratio).round().max(1.0);
    [count, if ratio < 1.0 { 1.0 / count } else { count }]
}

/// The nearest whole number above one, or one over it, where that is small enough to be told from a unit;
/// else a number that nothing is near to.
pub(super) fn in_whole_numbers(ratio: f64) -> f64 {
    let [count, whole] = whole(ratio);
    if (2.0..=WHOLE_SURE).contains(&count) { whole } else { f64::INFINITY }
}

/// To four places after the point.
pub(crate) fn to_four_places(x: f64) -> f64 {
    (x * 1e4).round() / 1e4
}

/// By how much times are wrong that are too short by a factor, and the words for it: of the times, and of the
/// spins that would look the same.
pub(crate) fn by_how_much(times: f64) -> (f64, [&'static str; 2]) {
    let (size, words) =
        if times.abs() < 1.0 { (1.0 / times, ["long", "large"]) } else { (times, ["short", "small"]) };
    (to_four_places(size), words)
}

/// The whole number, one over one, or fraction that a ratio found from rows is next to.
pub(crate) fn rounded(ratio: f64) -> Option<f64> {
    let [count, whole] = whole(ratio);
    let near = |x: &f64, share: f64| (ratio / x - 1.0).abs() < share;
    if near(&whole, WHOLE_NEAR) && count <= WHOLE_MOST {
        return Some(whole);
    }
    let fractions = (2..=10).map(f64::from).map(|under| (ratio * under).round() / under);
    fractions.into_iter().find(|x| near(x, FRACTION_NEAR))
}

/// The whole number, or one over one, that a ratio is next to where each step turns by this much, rad: the
/// errors of the steps grow with the square of that, and are larger than what parts most fractions.
fn whole_of_long_turns(ratio: f64, turn: f64) -> Option<f64> {
    let [count, whole] = whole(ratio);
    let half = ratio.max(1.0 / ratio) * 2.0;
    let is_half = (half / half.round() - 1.0).abs() < FRACTION_NEAR;
    let slack = (TURN_ERROR * turn * turn).min(0.5 / count);
    (count > 1.0 && !is_half && (ratio / whole - 1.0).abs() < slack).then_some(whole)
}

/// How many times as far as the spin says the attitude turns about it, in the middle step.
pub(crate) fn times_the_turn(pairs: &[Pair]) -> f64 {
    median(&mut pairs.iter().filter_map(|pair| {
        let mean = (pair.from.omega + pair.to.omega) / 2.0;
        Some(pair.turn()?.dot(&mean) / (mean.norm_squared() * pair.h)).filter(|x| x.is_finite())
    }))
}

/// Whether a limit on turns, or a straight step, may be why a fast body turns this many times as far.
pub(crate) fn is_limited(ratio: f64, pairs: &[Pair]) -> bool {
    let [share, turn] = TURN_LIMITED;
    (share..1.0).contains(&ratio)
        && median(&mut pairs.iter().map(|pair| pair.from.omega.norm() * pair.h)) > turn
}

impl Reading {
    /// With times that are right by one factor, if by this factor both the attitude turns and the spin
    /// changes otherwise than they say: of a wrong spin or term one of them would.
    pub(super) fn paced(self, pairs: &[Step], moments: &Vector3<f64>) -> Option<Self> {
        let own = self.pairs(pairs, moments);
        let ratio = times_the_turn(&own);
        let turn = median(&mut own.iter().filter_map(Pair::turn).map(|turn| turn.norm()));
        let known = whole_of_long_turns(ratio, turn).or(rounded(ratio));
        // Where a step's own error is as large as what parts fractions, another number is not known.
        let times = known.or((TURN_ERROR * turn * turn < FRACTION_NEAR).then_some(ratio))?;
        let limited = is_limited(ratio, &own);
        if !(times.is_normal() && times > 0.0) || limited || self.with_units(ratio) != self {
            return None;
        }
        let mut way = self;
        way.time = times;
        let all = way.pairs(pairs, moments);
        let (alike, size) = by_exact_motion(&all, moments, false);
        let [apart, otherwise] = [times, 1.0 / times].map(|x| (x - 1.0).abs());
        let off = all.iter().filter_map(Pair::inconsistency).collect();
        // What times next to that ratio leave is the steps' own error.
        let agree = TURNS_AGREE + (ratio / times - 1.0).abs();
        let one = middle_and_most(off).is_some_and(|[half, most]| half < agree && most < PACE_APART);
        let changes = one && alike > LAW_AGREES && (size - 1.0).abs() < PACE_OF_LAW.min(otherwise / 2.0);
        (apart > PACE_APART && changes).then_some(way)
    }

    /// Whether the spin goes by its law as it is named, by far more than as another way has it.
    pub(super) fn goes_by_law_unlike(self, other: &Self, pairs: &[Step], moments: &Vector3<f64>) -> bool {
        let law = |way: &Self| {
            let of = |in_world| by_exact_motion(&way.pairs(pairs, moments), moments, in_world).0;
            f64::max(of(false), of(true))
        };
        law(&self) > LAW_AGREES.max(law(other) + SIDES_APART)
    }
}

/// How much the changes of spin are like the exact motion's, and how large in these: as the body sees them,
/// or as the body before the step sees those in the world.
fn by_exact_motion(pairs: &[Pair], moments: &Vector3<f64>, in_world: bool) -> (f64, f64) {
    // Of a spin that blows up the few last steps would be all that counts.
    let slow = |pair: &&Pair| pair.from.omega.norm() * pair.h <= LONG_TURN;
    alike(&mut pairs.iter().filter(slow).filter_map(|Pair { from, to, h }| {
        let end = FreeMotion::new((*moments).try_into().ok()?, &from.omega).ok()?.at(*h).ok()?;
        let [mut seen, mut own] = [to.omega, end.omega];
        if in_world {
            let turned = product(&from.attitude?.conjugate(), &to.attitude?);
            seen = rotation_matrix(&turned) * seen / turned.norm_squared();
            own = rotation_matrix(&end.attitude) * own;
        }
        Some((seen - from.omega, own - from.omega))
    }))
}
