//! Steps by Taylor series, as long as their last terms allow.

use super::columns::Columns;
use super::law::Law;
use super::logarithm::logarithm;
use super::series::{MOST, Series};
use super::{Engine, Run, largest, over};
use crate::body::State;
use crate::error::Error;
use crate::number::Analytic;
use crate::number::functions::exp;
use crate::number::power_of_two::{exponent, times_power_of_two};
use crate::step::system::System;
use nalgebra::{Quaternion, Vector3};
use num_traits::FromPrimitive;

/// How often a step is tried again, shorter, before it is refused.
const TRIES: usize = 60;

/// The series about the start of the last step.
#[derive(Debug, Clone)]
pub(super) struct Taylor<T: nalgebra::Scalar> {
    law: Law<T>,
    /// The same in units of time of this number of seconds, a power of two.
    in_units: Law<T>,
    unit: f64,
    series: Series<T>,
    /// The highest power that a step takes.
    most: usize,
}

impl<T: Analytic + Copy + FromPrimitive> Taylor<T> {
    /// None where the law is no polynomial.
    pub(super) fn new(system: &System<T>, tolerance: f64) -> Option<Self> {
        let law = Law::of(system)?;
        Some(Self { law, in_units: law, unit: 0.0, series: Series::new(), most: order(tolerance) })
    }

    /// The coefficients about the state now; the longest step that keeps the last of them below the
    /// tolerance, in units.
    fn fill(&mut self, weights: &[f64; 3], columns: Option<&Columns<T>>, far: f64, tolerance: f64) -> f64 {
        let mut power = 1.0;
        let mut below = false;
        for order in 1..=self.most {
            self.series.extend(&self.in_units);
            if far > 1.0 {
                continue;
            }
            // To the end is less than a unit: it may take fewer coefficients.
            power *= far;
            let small = self.series.size(order, weights, columns) * power <= 0.1 * tolerance;
            if small && below {
                return far;
            }
            below = small;
        }
        let goal = logarithm(tolerance);
        let size = |order: usize| self.series.size(order, weights, columns);
        let longest = |order: usize| (goal - logarithm(size(order))) / order as f64;
        let [last, before] = [self.most, self.most - 1].map(longest);
        exp(if last < before { last } else { before })
    }

    /// The end of a step of `x` units, and its error: how far the series is from the law there.
    fn end(
        &self,
        run: &Run<'_, T>,
        columns: Option<&Columns<T>>,
        x: T,
        unit: T,
        scale: f64,
    ) -> (State<T>, f64) {
        let [q, w, dq, dw] = self.series.at(x);
        let start = &run.state;
        let s = &start.attitude.coords;
        let mut end = State {
            attitude: Quaternion::new(s.w + q[3], s.x + q[0], s.y + q[1], s.z + q[2]),
            momentum: Vector3::from_fn(|i, _| start.momentum[i] + self.law.moments[i] * w[i] / unit),
        };
        end.momentum.apply(|x| {
            if columns.is_none() && x.size() > 0.0 && x.size() < smallest::<T>() {
                *x = T::zero();
            }
        });
        let stretched = run.project(&mut end);
        let rate =
            run.system.rate_after(&end, &Run::number(run.time + (x * unit).size().copysign(run.duration)));
        let r = &rate.attitude.coords;
        let turned = [r.x * unit - dq[0], r.y * unit - dq[1], r.z * unit - dq[2], r.w * unit - dq[3]];
        let pushed: [T; 3] =
            core::array::from_fn(|i| rate.momentum[i] * unit - self.law.moments[i] * dw[i] / unit);
        let share = x.size() / (self.series.order as f64 + 1.0);
        let error = share * largest(&[largest(&turned), over(largest(&pushed), scale)]);
        let slopes = columns.map_or(0.0, |columns| {
            let spun: [T; 3] = core::array::from_fn(|i| pushed[i] * unit / self.law.moments[i]);
            share * columns.share(turned.iter().chain(&spun))
        });
        (end, largest(&[error, stretched, slopes]))
    }
}

impl<T: Analytic + Copy + FromPrimitive> Taylor<T> {
    /// The state `time` seconds after the start of the last step, where the body was in the state `start`.
    pub(super) fn within(&self, run: &Run<'_, T>, start: &State<T>, time: f64) -> State<T> {
        let unit = Run::number(self.unit);
        let [q, w] = self.series.value(Run::number(time / self.unit));
        let s = &start.attitude.coords;
        let mut there = State {
            attitude: Quaternion::new(s.w + q[3], s.x + q[0], s.y + q[1], s.z + q[2]),
            momentum: Vector3::from_fn(|i, _| start.momentum[i] + self.law.moments[i] * w[i] / unit),
        };
        run.project(&mut there);
        there
    }
}

/// Below this a momentum has too few digits left to decay, and is zero.
fn smallest<T: Analytic>() -> f64 {
    if T::rounding() > f64::EPSILON { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE }
}

/// The order that takes the fewest operations for a tolerance of a step.
fn order(tolerance: f64) -> usize {
    let digits = -logarithm(tolerance) / core::f64::consts::LN_10;
    ((5.0 + 1.3 * digits) as usize).clamp(6, MOST)
}

impl<T: Analytic + Copy + FromPrimitive> Engine<T> for Taylor<T> {
    fn advance(&mut self, run: &mut Run<'_, T>) -> Result<(), Error> {
        let remaining = run.duration - run.time;
        let omega = run.system.omega(&run.state.momentum);
        let loss = self.law.loss(&run.state.momentum);
        let rate = self.law.rate(&omega, loss);
        let unit = if rate > 0.0 && rate.is_finite() {
            times_power_of_two(1.0, -exponent(rate))
        } else {
            remaining.abs()
        };
        let in_units = Run::number(unit);
        if unit != self.unit {
            (self.in_units, self.unit) = (self.law.in_units(in_units), unit);
        }
        let now = *run.system.time() + Run::number(run.time);
        let spin: [T; 3] = omega.map(|x| x * in_units).into();
        self.series.begin(&self.in_units, &run.state.attitude, spin, self.law.direction(now));
        // What the momentum is measured by: a body at rest has none, so that which a torque gives it counts;
        // one that drag brought to rest has no digits below the least.
        let gained = run.system.torque_after(&run.state, &Run::number(run.time));
        let held = largest(run.state.momentum.as_slice()) + largest(gained.as_slice()) * unit;
        let least = smallest::<T>() / run.tolerance;
        let scale = held.max(least);
        let weights = [0, 1, 2].map(|i| over(self.law.moments[i].size() / unit, scale).min(f64::MAX));
        let far = remaining.abs() / unit;
        let attitude = run.state.attitude.coords.as_slice();
        let columns = run.watch.slopes.map(|slopes| Columns::of(slopes, attitude, &spin));
        let columns = columns.as_ref();
        let mut x = self.fill(&weights, columns, far, run.tolerance);
        for _ in 0..TRIES {
            let (h, last) = run.fitted((x * unit).copysign(remaining))?;
            let signed = if last { far } else { x }.copysign(remaining);
            let (end, error) = self.end(run, columns, Run::number(signed), in_units, scale);
            if error <= run.tolerance.max(32.0 * T::rounding()) {
                run.count_losses(if held > least { loss * h.abs() } else { 0.0 });
                if let Some(flips) = &mut run.watch.flips {
                    let spin = self.series.spin(flips.axis());
                    flips.see(&spin[..=self.series.order], signed, run.time, unit);
                }
                run.take(end, h, last);
                return Ok(());
            }
            run.rejected += 1;
            x = 0.5 * x.min(far);
        }
        Err(run.no_step(x * unit))
    }
}
