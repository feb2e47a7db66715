//! The instants of the flips of a free body, in order, without storing a list.

use crate::error::{Error, Refusal, Subject};
use crate::number::{DoubleDouble, times_power_of_two};
use core::iter::FusedIterator;
use core::ops::Range;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Beyond this number of flips from the start, consecutive numbers are not distinct in `f64`.
const LAST: f64 = 9_007_199_254_740_992.0;

/// Up to this number of flips, the rounded instants are all different: half a period is at least two units in
/// the last place of the time.
const LAST_APART: f64 = LAST / 4.0;

/// The instants when the spin along the middle axis is zero: once, or once for each half turn of the phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Clock {
    /// At this scaled time alone.
    Once(DoubleDouble),
    /// Where `offset + rate t` is an integer.
    Evenly { offset: DoubleDouble, rate: DoubleDouble },
}

/// The flips in an interval, in order of time from either end; see
/// [`FreeMotion::flips`](super::FreeMotion::flips).
///
/// Counting the flips and finding any one of them takes the same time, however many there are:
/// [`remaining`](Self::remaining), [`nth`](Iterator::nth), [`last`](Iterator::last).
/// [`count`](Iterator::count) and [`size_hint`](Iterator::size_hint) return the number as a `usize`, if it
/// fits.
#[derive(Debug, Clone)]
pub struct Flips {
    source: Option<(Clock, i32)>,
    /// The index of the first flip, and the increment from one flip to the next, forward in time.
    first: f64,
    step: f64,
    /// The remaining flips, counted from the first.
    left: Range<u64>,
}

impl Clock {
    fn step(&self) -> f64 {
        match self {
            Self::Evenly { rate, .. } if rate.hi() < 0.0 => -1.0,
            Self::Evenly { .. } | Self::Once(_) => 1.0,
        }
    }

    fn instant(&self, number: f64, exponent: i32) -> f64 {
        let scaled = match *self {
            Self::Once(time) => time,
            // (C36)
            Self::Evenly { offset, rate } => (DoubleDouble::from(number) - offset) / rate,
        };
        // A flip at the start is at 0, not at -0.
        times_power_of_two(scaled.hi(), -exponent) + 0.0
    }

    /// The index of the first flip after `t`; on the separatrix, 1 if that flip is over.
    fn first_after(&self, t: f64, exponent: i32, limit: f64) -> Result<f64, Error> {
        let Self::Evenly { offset, rate } = *self else {
            return Ok(if self.instant(0.0, exponent) > t { 0.0 } else { 1.0 });
        };
        let half_turns = (rate * times_power_of_two(t, exponent) + offset).hi();
        let room = limit - 8.0;
        Refusal::Order {
            smaller: Subject::FlipNumber,
            small: half_turns.abs(),
            larger: "the greatest for which the times of two flips differ in f64",
            large: room,
        }
        .when(half_turns.is_nan() || half_turns.abs() > room)?;
        // Starts one or two flips earlier; the rounded instants decide.
        let step = self.step();
        let mut number = if step > 0.0 { half_turns.floor() } else { half_turns.ceil() } - step;
        while self.instant(number, exponent) <= t {
            number += step;
        }
        Ok(number)
    }

    /// The first flip after `t`; infinite if it is beyond `f64`.
    pub(crate) fn next_after(&self, t: f64, exponent: i32) -> Result<Option<f64>, Error> {
        let number = self.first_after(t, exponent, LAST)?;
        let none = matches!(self, Self::Once(_)) && number > 0.0;
        Ok((!none).then(|| self.instant(number, exponent)))
    }
}

impl Flips {
    /// The flips after `from` and up to `to`.
    pub(crate) fn between(source: Option<(Clock, i32)>, from: f64, to: f64) -> Result<Self, Error> {
        let Some((clock, exponent)) = source else {
            return Ok(Self { source, first: 0.0, step: 1.0, left: 0..0 });
        };
        let number = |t: f64| clock.first_after(t, exponent, LAST_APART);
        let (first, end, step) = (number(from)?, number(to)?, clock.step());
        // A whole number below 2^53.
        Ok(Self { source, first, step, left: 0..((end - first) * step).max(0.0) as u64 })
    }

    /// The number of remaining flips, computed without visiting them.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::{PrincipalMoments, exact::FreeMotion};
    /// let motion = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 3.0)?, &Vector3::new(0.0, 10.0, 0.001))?;
    /// let flips = motion.flips(0.0, 1e9)?; // 31 years, one flip every 3.4805 s
    /// assert_eq!(flips.remaining(), 287_315_314);
    /// assert_eq!(flips.last().map(|t| format!("{t:.3}")).as_deref(), Some("999999999.263"));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    #[must_use]
    pub fn remaining(&self) -> u64 {
        self.left.end - self.left.start
    }

    fn instant(&self, n: u64) -> Option<f64> {
        self.source.map(|(clock, exponent)| clock.instant(self.first + self.step * n as f64, exponent))
    }
}

impl Iterator for Flips {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        self.left.next().and_then(|n| self.instant(n))
    }

    fn nth(&mut self, n: usize) -> Option<f64> {
        self.left.nth(n).and_then(|n| self.instant(n))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.left.size_hint()
    }

    fn count(self) -> usize {
        self.size_hint().0
    }

    fn last(mut self) -> Option<f64> {
        self.next_back()
    }
}

impl DoubleEndedIterator for Flips {
    fn next_back(&mut self) -> Option<f64> {
        self.left.next_back().and_then(|n| self.instant(n))
    }
}

impl FusedIterator for Flips {}
