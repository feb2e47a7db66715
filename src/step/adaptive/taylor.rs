//! Steps by Taylor series; the length of a step is limited by the size of the last terms.

use super::law::{Law, Rates};
use super::series::{LENGTH, MOST, Now, Series, in_units};
use super::sums::each;
use super::{Run, TRIES, exponential, largest, logarithm, ratio};
use crate::body::State;
use crate::error::Error;
use crate::number::{exponent, times_power_of_two};
use alloc::boxed::Box;
use nalgebra::{Quaternion, Vector3};

/// The series about the start of the last step, and about its end.
#[derive(Debug, Clone)]
pub(super) struct Taylor {
    /// The law, with time in units of `unit` seconds, a power of two.
    law: Law,
    unit: f64,
    rates: Rates,
    now: Now,
    /// Whether `now` is the current time of the run.
    ready: bool,
    series: Box<Series<LENGTH>>,
    /// The first-order series about the end of the other: it measures the error.
    next: Series<2>,
    /// The highest power that a step takes.
    most: usize,
}

impl Taylor {
    /// `None` where the law is not a polynomial.
    pub(super) fn new(run: &Run) -> Option<Self> {
        let law = Law::of(&run.system, 1.0)?;
        let varied = run.variation.is_some();
        let (series, next) = (Box::new(Series::new(&law, varied)), Series::new(&law, varied));
        let (rates, now) = (Rates::of(&run.system, &law), Now::default());
        Some(Self { law, unit: 1.0, rates, now, ready: false, series, next, most: order(run.tolerance) })
    }

    /// Begins another piece of the run in the same memory, if the series are of the same terms.
    pub(super) fn renew(&mut self, run: &Run) -> bool {
        let Some(law) = Law::of(&run.system, 1.0) else { return false };
        let fits = self.series.fits(&law);
        if fits {
            self.rates = Rates::of(&run.system, &law);
            (self.law, self.unit, self.ready) = (law, 1.0, false);
        }
        fits
    }

    /// Begins the series of a step at the current state.
    fn begin(&mut self, run: &Run) {
        let spin = run.system.omega(&run.state.momentum).map(|x| x * self.unit).into();
        self.series.begin(&self.law, &self.now, &run.state.attitude, spin);
        if let (Some(own), Some(start)) = (&mut self.series.variations, &run.variation) {
            own.begin(&in_units(start, self.unit));
        }
        self.series.extend_to(1, &self.law);
    }

    /// Begins the variations at the end of a step of `x` units; returns the difference between the rates of
    /// the series and those of the law there.
    #[inline(never)]
    fn end_variations(&mut self, x: f64) -> f64 {
        let Some([value, rate]) = self.series.variations.as_ref().map(|own| own.at(x)) else { return 0.0 };
        if let Some(next) = &mut self.next.variations {
            next.begin(&value);
        }
        self.next.extend_to(1, &self.law);
        let both = self.series.variations.as_ref().zip(self.next.variations.as_ref());
        both.map_or(0.0, |(own, next)| own.off(&next.coefficient(1), &rate))
    }

    /// Computes the coefficients about the current state; returns about the longest step, in units, that
    /// keeps the last terms below the tolerance.
    fn fill(&mut self, weights: &[f64; 3], left: f64, tolerance: f64) -> f64 {
        let (mut power, mut below) = (left, false);
        if left > 1.0 {
            self.series.extend_to(self.most, &self.law);
        } else {
            // Less than one unit remains: fewer coefficients may suffice. They are computed three at a time.
            for order in 2..=self.most {
                if self.series.order < order {
                    self.series.extend_to((order + 2).min(self.most), &self.law);
                }
                power *= left;
                let small = self.series.size(order, weights) * power <= 0.1 * tolerance;
                if small && below {
                    return left;
                }
                below = small;
            }
        }
        // All divisions are of numbers known before the last coefficients.
        let goal = logarithm(tolerance);
        let longest = |order| (goal - logarithm(self.series.size(order, weights))) * (1.0 / order as f64);
        let [last, before] = [self.most, self.most - 1].map(longest);
        let longest = exponential(if last < before { last } else { before });
        // A last step that is somewhat longer is better than a very short one after it.
        if left < 1.1 * longest { left } else { longest }
    }

    /// The end of a step of `x` units at a time (s after the start of the run), and the error of the step,
    /// refused above `limit`: the difference between the rates of the series and of the law at the end of the
    /// series. From it follows the next term of the series, which is added.
    fn end(&mut self, run: &Run, x: f64, time: f64, scale: f64, limit: f64) -> (State<f64>, f64) {
        let [q, w, dq, dw] = self.series.at(x);
        let mut end = self.moved(run, &run.state, &q, &w);
        self.now.set(&self.law, time);
        let spin = run.system.omega(&end.momentum).map(|x| x * self.unit).into();
        self.next.begin(&self.law, &self.now, &end.attitude, spin);
        self.next.extend_to(1, &self.law);
        let (turned, spun) = (&self.next.attitude.up[1], &self.next.spin.up[1]);
        let (per, share) = (1.0 / self.unit, x / (self.series.order as f64 + 1.0));
        let (turned, spun) = (each(|i| (turned[i] - dq[i]) * share), each(|i| (spun[i] - dw[i]) * share));
        let pushed = |i: usize| spun[i] * run.system.moments()[i] * per;
        let error = largest(&[largest(&turned), ratio(largest(&[pushed(0), pushed(1), pushed(2)]), scale)]);
        if error > limit || error.is_nan() {
            return (end, error);
        }
        self.series.append(x, &turned, &spun);
        end = self.moved(run, &run.state, &each(|i| q[i] + turned[i]), &each(|i| w[i] + spun[i]));
        let stretched = run.settle(&mut end);
        let varied = if run.variation.is_some() { share.abs() * self.end_variations(x) } else { 0.0 };
        (end, largest(&[error, stretched, varied]))
    }

    /// The state after these changes of attitude and spin, in units.
    fn moved(&self, run: &Run, start: &State<f64>, q: &[f64; 4], w: &[f64; 4]) -> State<f64> {
        let (s, per) = (&start.attitude.coords, 1.0 / self.unit);
        State {
            attitude: Quaternion::new(s.w + q[0], s.x + q[1], s.y - q[3], s.z + q[2]),
            momentum: Vector3::from_fn(|i, _| start.momentum[i] + run.system.moments()[i] * w[i] * per),
        }
    }

    /// The state `time` seconds after the start of the last step, where the body was in the state `start`.
    pub(super) fn within(&self, run: &Run, start: &State<f64>, time: f64) -> State<f64> {
        let [q, w] = self.series.value(time / self.unit);
        let mut there = self.moved(run, start, &q, &w);
        run.project(&mut there);
        there
    }

    /// Whether the momentum has significant digits, and the scale for its error. A body at rest has no
    /// momentum, so the momentum gained from a torque counts too. The momentum of a body that drag has
    /// brought to rest has no digits below `least`. Where torques cancel, as for a body that hangs at rest,
    /// their remaining sum is rounding.
    fn scale(&self, run: &Run, unit: f64) -> (bool, f64) {
        let least = f64::MIN_POSITIVE / run.tolerance;
        let (torque, moments) = (self.series.torque(&self.law), run.system.moments());
        let gained = [torque[0] * moments.x, torque[1] * moments.y, torque[2] * moments.z];
        let held = largest(run.state.momentum.as_slice()) + largest(&gained) / unit;
        let rounding =
            self.rates.acceleration * largest(moments.as_slice()) * unit * 8.0 * f64::EPSILON / run.tolerance;
        (held > least, held.max(least).max(rounding))
    }

    /// Takes one step; halves it until its error is within the tolerance (or 32 `f64::EPSILON`, if that is
    /// more).
    pub(super) fn advance(&mut self, run: &mut Run) -> Result<(), Error> {
        let remaining = run.duration - run.time;
        let decay = self.rates.fastest_decay(&run.state.momentum);
        let rate = self.rates.fastest(&run.system.omega(&run.state.momentum), decay);
        // The unit should be within a factor of four of the time in which the motion changes; otherwise it is
        // chosen again.
        let rate_in_units = rate * self.unit;
        let unit = if (0.5..=4.0).contains(&rate_in_units) {
            self.unit
        } else if rate > 0.0 && rate.is_finite() {
            times_power_of_two(1.0, -exponent(rate))
        } else {
            // Not below the numbers whose inverse is finite.
            run.ahead().abs().max(f64::MIN_POSITIVE)
        };
        // Accelerations are multiplied by the square of the unit: below this limit they would lose their
        // digits.
        if unit * unit < f64::MIN_POSITIVE / f64::EPSILON && run.ahead().abs() > unit {
            return Err(run.no_step(unit));
        }
        if unit != self.unit {
            self.law = Law::of(&run.system, unit).unwrap_or_else(|| self.law.clone());
            (self.unit, self.ready) = (unit, false);
        }
        if !core::mem::take(&mut self.ready) {
            self.now.set(&self.law, run.time);
        }
        self.begin(run);
        let (moves, scale) = self.scale(run, unit);
        let weights = [0, 1, 2].map(|i| ratio(run.system.moments()[i].abs() / unit, scale).min(f64::MAX));
        let per = 1.0 / unit;
        let left = remaining.abs() * per;
        let mut x = self.fill(&weights, left, run.tolerance);
        if !(x * unit).is_finite() {
            x = run.ahead().abs() / unit;
        }
        let limit = run.tolerance.max(32.0 * f64::EPSILON);
        for _ in 0..TRIES {
            let (h, next) = run.fitted((x * unit).copysign(remaining))?;
            let signed = h * per;
            let (end, error) = self.end(run, signed, next, scale, limit);
            if error <= limit {
                self.series.order += 1;
                run.count_stiffness(if moves { decay * h.abs() } else { 0.0 });
                if let Some(flips) = &mut run.flips {
                    let spin = self.series.spin(flips.axis);
                    flips.find(&spin[..=self.series.order], signed, run.from + run.time, unit);
                }
                run.take(end, h, next);
                if let (Some(variation), Some(variations)) = (&mut run.variation, &self.next.variations) {
                    **variation = in_units(&variations.coefficient(0), 1.0 / self.unit);
                }
                self.ready = true;
                return Ok(());
            }
            run.rejected += 1;
            x = 0.5 * x.min(left);
        }
        Err(run.no_step(x * unit))
    }
}

/// The order that needs the fewest operations for this tolerance of a step.
fn order(tolerance: f64) -> usize {
    let digits = -logarithm(tolerance) / core::f64::consts::LN_10;
    ((5.0 + 1.3 * digits) as usize).clamp(6, MOST)
}
