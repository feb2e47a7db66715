//! The free motion of a body, enclosed: its spin at a time, its flips and its period.

use super::elliptic::{carlson_first, jacobi, quarter_period};
use super::geometry::length;
use super::{Interval, whole};
use crate::Rational;
use nalgebra::Vector3;
use num_traits::{One, Zero};
use std::cmp::Ordering;

/// A motion in Jacobi's functions, of a body with three different moments that is neither steady nor on the
/// separatrix. Source: [LL76](tumbling::references), section 37.
#[derive(Debug, Clone)]
pub struct FreeMotion {
    /// Which axes of the body the spin circles, is the middle one, and is the other end.
    axes: [usize; 3],
    /// Of dn, sn and cn, in the same order.
    amplitudes: [Interval; 3],
    /// The complement of the modulus.
    complement: Interval,
    quarter: Interval,
    /// Of the argument at time 0, and what it gains in a second.
    phase: Interval,
    rate: Interval,
    starts_at_a_flip: bool,
}

/// The order of the axes by their moments, if it is certain.
fn sorted(moments: &Vector3<Interval>) -> Option<[usize; 3]> {
    let mut axes = [0, 1, 2];
    axes.sort_by(|&i, &j| moments[i].partial_cmp(&moments[j]).unwrap_or(Ordering::Equal));
    let [low, middle, high] = axes;
    (moments[low] < moments[middle] && moments[middle] < moments[high]).then_some(axes)
}

impl FreeMotion {
    /// From the principal moments (kg m²) and the spin (rad/s) along their axes, in any order; nothing where
    /// the intervals leave open which kind of motion it is.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling_proofs::{Interval, given, interval::motion::FreeMotion};
    /// let moments: Vector3<Interval> = Vector3::new(given!(10), given!(13), given!(5));
    /// let omega = Vector3::new(given!(10), given!(1), given!(0));
    /// let motion = FreeMotion::new(&moments, &omega).unwrap();
    /// assert_eq!(format!("{:.2} s", motion.between_flips()), "1.38 s");
    /// ```
    #[must_use]
    pub fn new(moments: &Vector3<Interval>, omega: &Vector3<Interval>) -> Option<Self> {
        let zero = Interval::zero();
        let [low, middle, high] = sorted(moments)?;
        let root = |i: usize, j: usize| (moments[i] * (moments[i] - moments[j]).abs()).sqrt();
        // The discriminant's two terms: their difference says which end the spin circles.
        let ends = [(high, root(high, middle) * omega[high]), (low, root(low, middle) * omega[low])];
        let [large, small] = ends.map(|(_, term)| term.abs());
        let (end, other) = match large.partial_cmp(&small)? {
            Ordering::Greater => (high, low),
            Ordering::Less => (low, high),
            Ordering::Equal => return None,
        };
        let discriminant = ((large - small).abs() * (large + small)).sqrt();
        let apart = |i: usize, j: usize| (moments[i] - moments[j]).abs();
        let (across, along) = (
            Vector3::new(root(other, end) * omega[other], root(middle, end) * omega[middle], zero),
            Vector3::new(root(middle, other) * omega[middle], root(end, other) * omega[end], zero),
        );
        let (around, circled) = (length(&across), length(&along));
        if !(around > zero && circled > zero && discriminant > zero) {
            return None;
        }
        let complement = (apart(end, other) / apart(end, middle)).sqrt() * discriminant / circled;
        let quarter = quarter_period(complement.clamped(0.0, 1.0), complement.ln());
        let product = moments[low] * moments[middle] * moments[high];
        let speed = (apart(end, middle) / product).sqrt() * circled;
        let cyclic = (other + 1) % 3 == middle;
        let backwards =
            [!cyclic, omega[end] < zero, end == low].iter().filter(|&&flag| flag).count() % 2 == 1;
        let rate = if backwards { -speed } else { speed };
        let sign = whole(if omega[end] < zero { -1 } else { 1 });
        let amplitudes =
            [sign * circled / root(end, other), around / root(middle, end), around / root(other, end)];
        let phase = phase(across.map(|x| x / around), along.y / circled, quarter)?;
        Some(Self {
            axes: [end, middle, other],
            amplitudes,
            complement: complement.clamped(0.0, 1.0),
            quarter,
            phase,
            rate,
            starts_at_a_flip: omega[middle].is_zero(),
        })
    }

    /// The spin at a time (s), rad/s.
    #[must_use]
    pub fn omega(&self, t: Interval) -> Vector3<Interval> {
        let (sn, cn, dn) = jacobi(self.phase + self.rate * t, self.complement);
        let [end, middle, other] = self.axes;
        let mut omega = Vector3::from_element(Interval::zero());
        omega[end] = self.amplitudes[0] * dn;
        omega[middle] = self.amplitudes[1] * sn;
        omega[other] = self.amplitudes[2] * cn;
        omega
    }

    /// The time from one flip to the next, s.
    #[must_use]
    pub fn between_flips(&self) -> Interval {
        whole(2) * self.quarter / self.rate.abs()
    }

    /// The time of a flip after the start, counted from 0, s: the zeros of sn. A start at a flip is none of
    /// them. All numbers where it is open whether one has passed.
    #[must_use]
    pub fn flip(&self, number: u32) -> Interval {
        let (zero, half) = (Interval::zero(), whole(2) * self.quarter);
        let ahead = if self.rate > zero { self.phase } else { -self.phase };
        let to_come = (-1..=2).map(|halves| whole(halves) * half - ahead);
        // A start at a flip is one of these zeros itself.
        let mut open = to_come.filter(|gap| !(*gap < zero || (self.starts_at_a_flip && gap.has_zero())));
        let Some(first) = open.next().filter(|gap| *gap > zero) else { return Interval::ALL };
        first / self.rate.abs() + whole(number) * self.between_flips()
    }

    /// The number of flips from the start to this time, s, if that is certain: as an interval of one number.
    #[must_use]
    pub fn flips_until(&self, end: Interval) -> Interval {
        let mut count = 0;
        while count < 1_000_000 && self.flip(count) < end {
            count += 1;
        }
        if self.flip(count) > end { whole(count) } else { Interval::ALL }
    }
}

/// The argument between `-K` and `3 K` of this sine and cosine amplitude and this dn.
fn phase(across: Vector3<Interval>, dn: Interval, quarter: Interval) -> Option<Interval> {
    let (cn, sn) = (across.x, across.y);
    let least = sn * carlson_first(cn.square(), dn.square(), Interval::one());
    if cn >= Interval::zero() || cn.low() >= 0.0 {
        Some(least)
    } else if cn.high() <= 0.0 {
        Some(whole(2) * quarter - least)
    } else {
        None
    }
}

/// The time between the flips of a body (its moments in order of size) that spins about its middle axis and
/// is pushed about the hardest, by less than a billionth of the spin, s. By the logarithm of that part, so
/// that a push may be smaller than any float.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling_proofs::{Interval, given, interval::motion::between_flips_after_a_push};
/// let moments = Vector3::new(given!(5), given!(10), given!(13));
/// let push = given!(Interval: 1e-9).ln();
/// assert_eq!(format!("{:.2} s", between_flips_after_a_push(&moments, given!(10), push)), "9.05 s");
/// ```
#[must_use]
pub fn between_flips_after_a_push(moments: &Vector3<Interval>, spin: Interval, push: Interval) -> Interval {
    let [low, middle, high] = [moments.x, moments.y, moments.z];
    if !(Interval::zero() < low && low < middle && middle < high && push < whole(-20)) {
        return Interval::ALL;
    }
    // k' is this many times the push, but for a factor 1/sqrt(1 + (this push)^2).
    let lever = ((high - low) * high / (middle * (middle - low))).sqrt();
    let tiny = Interval::one().hull(Interval::one() + Interval::from(Rational::new(1, 1_000_000_000_000)));
    if lever.high() >= 100.0 {
        return Interval::ALL;
    }
    let rate = (spin.abs()) * ((high - middle) * (middle - low) / (low * high)).sqrt();
    whole(2) * (whole(4).ln() - lever.ln() - push) * tiny / (rate * tiny)
}
