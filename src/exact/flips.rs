//! When a free body flips: every instant, in order, without a list.

use crate::double::Double;
use crate::error::Error;
use crate::scale::times_power_of_two;

/// Beyond this many flips from the start an `f64` cannot number them one by one.
const LAST: f64 = 9_007_199_254_740_992.0;

/// The instants when the spin along the middle axis vanishes: one, or one at each half turn of the phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Clock {
    /// At this scaled time alone.
    Once(Double),
    /// At all whole numbers of `offset + rate t`.
    Evenly { offset: Double, rate: Double },
}

/// The flips in an interval, in order of time; see [`FreeMotion::flips`](super::FreeMotion::flips).
#[derive(Debug, Clone)]
pub struct Flips {
    source: Option<(Clock, i32)>,
    /// Number of the next flip, of the last, and the step from one to the next, forward in time.
    next: f64,
    last: f64,
    step: f64,
    from: f64,
    to: f64,
}

impl Clock {
    fn instant(&self, number: f64, exponent: i32) -> f64 {
        let scaled = match *self {
            Self::Once(time) => time,
            Self::Evenly { offset, rate } => (Double::from(number) - offset) / rate,
        };
        times_power_of_two(scaled.value(), -exponent)
    }

    /// The number of half turns at a time, which is a whole number at each flip.
    fn count_at(&self, t: f64, exponent: i32) -> f64 {
        match *self {
            Self::Once(_) => 0.0,
            Self::Evenly { offset, rate } => (rate * times_power_of_two(t, exponent) + offset).value(),
        }
    }
}

impl Flips {
    /// Those after `from` and up to `to`.
    pub(crate) fn between(source: Option<(Clock, i32)>, from: f64, to: f64) -> Result<Self, Error> {
        let Some((clock, exponent)) = source else {
            return Ok(Self { source, next: 0.0, last: -1.0, step: 1.0, from, to });
        };
        let (first, last) = (clock.count_at(from, exponent), clock.count_at(to, exponent));
        let beyond = [first, last].into_iter().find(|x| !x.is_finite() || x.abs() > LAST - 4.0);
        if let Some(value) = beyond {
            return Err(Error::OutOfRange { what: "the number of flips from the start", value });
        }
        let step = match clock {
            Clock::Evenly { rate, .. } if rate.value() < 0.0 => -1.0,
            _ => 1.0,
        };
        // One more at each end; whether it belongs is decided by its instant.
        let (next, last) = match clock {
            Clock::Once(_) => (0.0, 0.0),
            Clock::Evenly { .. } if step > 0.0 => (first.floor() - 1.0, last.ceil() + 1.0),
            Clock::Evenly { .. } => (first.ceil() + 1.0, last.floor() - 1.0),
        };
        Ok(Self { source, next, last, step, from, to })
    }
}

impl Iterator for Flips {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        let (clock, exponent) = self.source?;
        while (self.last - self.next) * self.step >= 0.0 {
            let t = clock.instant(self.next, exponent);
            self.next += self.step;
            if t > self.to {
                break;
            }
            if t > self.from {
                return Some(t);
            }
        }
        self.source = None;
        None
    }
}
