//! An error in the course of time, in little room, and how it grows.

use crate::laws::{Growth, Stretch, Stretches};
use crate::thresholds::*;

/// The size of an error over a record of any length.
#[derive(Debug, Clone)]
pub(crate) struct Curve {
    stretches: Stretches<(f64, f64)>,
    /// The error in the last row, with its sign.
    pub last: f64,
    /// The least and the greatest error, with their signs; zero is one of them.
    pub range: [f64; 2],
}

/// The end of a stretch, s, and the most that the error was in it.
impl Stretch for (f64, f64) {
    fn join(&self, next: &Self) -> Self {
        (self.0.max(next.0), self.1.max(next.1))
    }
}

impl Curve {
    pub(crate) const fn new() -> Self {
        Self { stretches: Stretches::new(STRETCHES), last: 0.0, range: [0.0; 2] }
    }

    /// The error at a time after all before it.
    pub(crate) fn push(&mut self, t: f64, error: f64) {
        self.last = error;
        self.range = [self.range[0].min(error), self.range[1].max(error)];
        self.stretches.push((t, error.abs()));
    }

    /// The greatest size.
    pub(crate) fn most(&self) -> f64 {
        self.stretches.all.iter().map(|x| x.1).fold(0.0, f64::max)
    }

    /// How it grows, if what is below `rounding` is none. A logarithm of a ratio (`of_ratio`) that grows
    /// evenly is a quantity that grows or decays exponentially.
    pub(crate) fn growth(&self, rounding: f64, of_ratio: bool) -> Growth {
        let most = self.most();
        if most <= rounding {
            return Growth::Rounding;
        }
        let end = self.stretches.all.last().map_or(0.0, |x| x.0);
        let mut greatest = 0.0_f64;
        // The greatest so far, from a sixteenth of the time on.
        let so_far = self.stretches.all.iter().map(|x| {
            greatest = greatest.max(x.1);
            (x.0, greatest)
        });
        let late = so_far.filter(|&(t, size)| t >= GROWTH_FROM * end && t > 0.0 && size > 0.0);
        let envelope: Vec<(f64, f64)> = late.collect();
        let at = |share: f64| envelope.iter().find(|x| x.0 >= share * end).map_or(most, |x| x.1);
        if most < BOUNDED * at(0.5) {
            // A quantity a tenth larger or smaller, or more, which never comes near to what it was again.
            let later = self.stretches.all.iter().filter(|x| x.0 >= end / 2.0);
            let least = later.map(|x| x.1).fold(f64::INFINITY, f64::min);
            let one_way = self.range[1].min(-self.range[0]) < STAYED * most;
            let great = of_ratio && one_way && most > GROWN && least > STAYED * most;
            return if great { Growth::Stayed } else { Growth::Bounded };
        }
        let ([fast, linear], [even_most, fast_most]) = (POWERS, OF_ITSELF);
        let ([_, power], of_power) = line(envelope.iter().map(|&(t, size)| (t.ln(), size.ln())));
        let ([_, exponential], of_exponential) = line(envelope.iter().map(|&(t, size)| (t, size.ln())));
        let even = |rate: f64| {
            if of_ratio && most > even_most { Growth::Exponential { rate } } else { Growth::Linear { rate } }
        };
        if power >= fast {
            if of_exponential < of_power && most > EXPONENTIAL * at(EXPONENTIAL_FROM) {
                let rate = if of_ratio { self.last / end } else { exponential };
                return Growth::Exponential { rate };
            }
            return if of_ratio && most > fast_most {
                Growth::Exponential { rate: self.last / end }
            } else {
                Growth::Power { power }
            };
        }
        if power >= linear {
            return even(self.last / end);
        }
        Growth::RandomWalk { rate: most / end.sqrt() }
    }
}

/// The line nearest to points, by its value at zero and its slope, and the mean square of what is left.
pub(super) fn line(points: impl Iterator<Item = (f64, f64)> + Clone) -> ([f64; 2], f64) {
    let n = points.clone().map(|_| 1.0).sum::<f64>().max(1.0);
    let (x, y) = points.clone().fold((0.0, 0.0), |sum, p| (sum.0 + p.0 / n, sum.1 + p.1 / n));
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for p in points {
        xx += (p.0 - x) * (p.0 - x);
        xy += (p.0 - x) * (p.1 - y);
        yy += (p.1 - y) * (p.1 - y);
    }
    let slope = if xx > 0.0 { xy / xx } else { 0.0 };
    ([y - slope * x, slope], ((yy - slope * xy) / n).max(0.0))
}
