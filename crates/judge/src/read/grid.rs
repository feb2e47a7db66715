//! Times printed with few digits, put back to the steps that they are rounded from.

use crate::read::{Raw, Reading};
use crate::thresholds::*;
use nalgebra::Vector3;

/// Times that are, to their own printed digits, a whole number of equal steps from the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Grid {
    start: f64,
    /// Infinite where no step explains the times, which then stay as they are.
    pub step: f64,
    /// How far the step may be off, s.
    off: f64,
    /// Half a unit of the last decimal of the times, s.
    half: f64,
    /// The most significant digits that they have.
    digits: i32,
    pub named: bool,
    /// Whether the nearest place is tried before the place after the last row.
    nearest: bool,
    /// The place that the next row has, if none is missing.
    next: f64,
}

impl Grid {
    /// Where the printed digits make the steps uneven, and a step, the named one or the mean, explains all of
    /// the times.
    pub(crate) fn of(probe: &[Raw], named: Option<f64>) -> Option<Self> {
        let (first, last) = (probe.first()?, probe.last()?);
        // Of those printed without the zeros at their ends some have all the digits there are.
        let half = probe.iter().map(|raw| raw.printed.half).fold(f64::INFINITY, f64::min);
        let digits = probe.iter().map(|raw| raw.printed.digits).max()?;
        let digits = i32::try_from(digits).unwrap_or(i32::MAX);
        let steps = probe.windows(2).map(|rows| rows[1].t - rows[0].t);
        let least = steps.clone().fold(f64::INFINITY, f64::min);
        let most = steps.clone().fold(0.0, f64::max);
        let rounding = EVEN_TIMES * f64::EPSILON * last.t.abs().max(first.t.abs());
        // Even ones, and those with missing rows, are taken as they are.
        let even = most - least <= rounding && named.is_none_or(|named| (most - named).abs() <= rounding);
        if half <= rounding || even {
            return None;
        }
        let count = (probe.len() - 1) as f64;
        let mean = Self {
            start: first.t,
            step: (last.t - first.t) / count,
            off: 2.0 * half_of(last, half, digits) / count,
            half,
            digits,
            named: false,
            nearest: false,
            next: 0.0,
        };
        let named = named.map(|step| Self { step, off: 0.0, named: true, nearest: true, ..mean });
        let most = (count * MISSING_ROWS) as u32;
        let with_gaps = || (1..=most).find_map(|missing| mean.with_gaps(probe, count + f64::from(missing)));
        // Times that are multiples of a step already are exact, unless it is the unit of the last digit.
        let of_least = |step: f64| (step / least - (step / least).round()).abs() <= rounding / least;
        let is_exact = least > 3.0 * half && steps.clone().all(of_least);
        let fits = |grid: &Self| grid.places(probe).is_some();
        let open = Self { step: f64::INFINITY, off: 2.0 * half / least, ..mean };
        let other = || Some(mean).filter(fits).or_else(with_gaps).unwrap_or(open);
        named.filter(fits).or_else(|| (!is_exact).then(other))
    }

    /// A grid of this many steps, more than there are rows. The step is fitted to all times, because the
    /// rounding of the last time alone could shift a row to a wrong place.
    fn with_gaps(self, probe: &[Raw], count: f64) -> Option<Self> {
        let first = probe.first()?;
        let mut grid = Self { step: (probe.last()?.t - first.t) / count, ..self };
        let mut places = grid.places(probe)?;
        grid.nearest = true;
        let rows = places.len() as f64;
        let mean = probe.iter().map(|raw| raw.t - first.t).sum::<f64>() / rows;
        for _ in 0..3 {
            let centre = places.iter().sum::<f64>() / rows;
            let along = places.iter().zip(probe).map(|(place, raw)| (place - centre) * (raw.t - first.t));
            grid.step = along.sum::<f64>() / places.iter().map(|place| (place - centre).powi(2)).sum::<f64>();
            grid.start = first.t + mean - grid.step * centre;
            places = probe.iter().map(|raw| ((raw.t - grid.start) / grid.step).round()).collect();
        }
        grid.places(probe).map(|_| grid)
    }

    /// The places of the rows, if each is on one of its own.
    fn places(mut self, probe: &[Raw]) -> Option<Vec<f64>> {
        let place = |raw| {
            let place = self.time(raw).map(|x| x.0).filter(|place| *place >= self.next)?;
            self.next = place + 1.0;
            Some(place)
        };
        probe.iter().map(place).collect()
    }

    /// The place of a row and its unrounded time, if the recorded time is that time rounded. If the step is
    /// the mean of the rows, the place after the last row is tried first: where rounding is nearly half a
    /// step, the nearest place can be wrong.
    fn time(&self, raw: &Raw) -> Option<(f64, f64)> {
        let half = half_of(raw, self.half, self.digits);
        let nearest = ((raw.t - self.start) / self.step).round();
        let places = [if self.nearest { nearest } else { self.next }, nearest];
        let times = places.map(|place| (place, self.start + place * self.step));
        times.into_iter().find(|(_, time)| (time - raw.t).abs() <= PRINTED_HALVES * half)
    }

    /// A row at its time.
    pub(crate) fn put(&mut self, raw: &mut Raw) {
        // A row that is not on it, after all those looked at, keeps its own.
        if let Some((place, time)) = self.time(raw) {
            (raw.t, self.next) = (time, place + 1.0);
        }
    }

    /// By what share the times from row to row may be wrong: if the step is not known.
    pub(crate) const fn share(&self) -> f64 {
        if self.step.is_infinite() { self.off } else { 0.0 }
    }

    /// The rounding that a step so uncertain gives to spins and turns.
    pub(crate) fn floor(&self, probe: &[Raw], reading: &Reading, moments: &Vector3<f64>) -> f64 {
        let speed = probe.iter().map(|raw| reading.state(raw, moments).omega.norm()).fold(0.0, f64::max);
        if self.step.is_infinite() { 0.0 } else { self.off * reading.time * speed }
    }
}

/// Half a unit of the last digit that a time can have, s: for times that all have the same number of
/// decimals, or of significant digits.
fn half_of(raw: &Raw, half: f64, digits: i32) -> f64 {
    half.max(0.5 * raw.printed.above * 10.0_f64.powi(-digits))
}
