//! Bounds on the difference between a computation with floats and exact arithmetic, for all floats in a box.
//!
//! A [`Rounded`] number holds two intervals: in the first lies what is computed, in the second how much more
//! that is than the same formula gives without rounding. Each operation passes both on and adds its own
//! rounding: half a unit in the last place of the largest result, and half of the smallest float where it can
//! underflow. A number in two parts is one that is exact, the first, and a second that has the error of both.

use super::Interval;
use super::arithmetic::safe;
use super::paths::choose;
use super::real::one_lane;
use crate::field;
use num_traits::Zero;
use std::cmp::Ordering;
use tumbling::laws::{Lane, Real, Rounding, Series};

/// What is computed, and how much more that is than without rounding.
#[derive(Debug, Clone, Copy)]
pub struct Rounded {
    /// The computed value.
    pub at: Interval,
    /// The computed value minus the exact one.
    pub off: Interval,
}

/// The number of parts into which a turn with undecided phase is divided.
const PARTS: f64 = 16.0;

/// The smallest float.
const TINY: f64 = 5e-324;

fn exact(x: f64) -> Rounded {
    Rounded::given(Interval { low: x, high: x })
}

/// From the negative to the positive of the largest size in it.
fn within(x: Interval) -> Interval {
    let size = x.abs();
    size.hull(-size)
}

/// What this many units in the last place of the largest number in it are at most, both ways.
fn units(x: Interval, number: f64) -> Interval {
    let most = x.abs().high;
    // Of the power of two above, so that it holds of the next one too.
    let unit = if most < f64::INFINITY { most.next_up() - most } else { most };
    within(Interval { low: 0.0, high: number * unit })
}

field!(Rounded, exact, and floats);

impl Rounded {
    /// Floats in this interval; as inputs they are exact.
    pub fn given(at: Interval) -> Self {
        Self { at, off: Interval::zero() }
    }

    /// The value without rounding.
    fn truth(self) -> Interval {
        self.at - self.off
    }

    /// All numbers that are computed values, exact values, or between the two.
    fn both(self) -> Interval {
        self.at.hull(self.truth())
    }

    /// Rounded to the nearest float, unless it is known to be one.
    fn to_nearest(at: Interval, off: Interval, exactly: bool) -> Self {
        if at.low == at.high || (exactly && at.abs().high < f64::INFINITY) {
            Self { at, off }
        } else {
            Self { at, off: off + units(at, 0.5) }
        }
    }

    /// A product or quotient or root, of which the smallest can underflow.
    fn scaled(at: Interval, off: Interval, exactly: bool) -> Self {
        let found = Self::to_nearest(at, off, exactly);
        if at.is_zero() || (!at.has_zero() && safe(at.low) && safe(at.high)) {
            return found;
        }
        Self { off: found.off + Interval { low: -TINY, high: TINY }, ..found }
    }

    /// The result of a function that is right to a unit in the last place.
    fn function(at: Interval, off: Interval) -> Self {
        let unit = units(at, 1.0);
        Self { at: at + unit, off: off + unit }
    }

    /// A power of two, by which a product is exact.
    fn is_power_of_two(self) -> bool {
        self.at.point().is_some_and(|x| x != 0.0 && x.to_bits() << 12 == 0)
    }

    fn plus(self, other: Self) -> Self {
        let at = self.at + other.at;
        let nothing = self.at.is_zero() || other.at.is_zero();
        // Of two numbers of which each is at most twice the other the difference is exact.
        let [a, b] = [self.at, -other.at];
        let near = |a: Interval, b: Interval| {
            a.low > 0.0 && b.low > 0.0 && a.high <= 2.0 * b.low && b.high <= 2.0 * a.low
        };
        Self::to_nearest(at, self.off + other.off, nothing || near(a, b) || near(-a, -b))
    }
    fn minus(self) -> Self {
        Self { at: -self.at, off: -self.off }
    }
    fn times(self, other: Self) -> Self {
        let exactly = self.is_power_of_two() || other.is_power_of_two();
        Self::scaled(self.at * other.at, self.off_product(other), exactly)
    }
    /// By how much the product of what is computed is more.
    fn off_product(self, other: Self) -> Interval {
        self.at * other.off + self.off * other.truth()
    }
    fn over(self, other: Self) -> Self {
        let off = (self.off - self.truth() / other.truth() * other.off) / other.at;
        Self::scaled(self.at / other.at, off, other.is_power_of_two())
    }
    fn zero_for_certain(&self) -> bool {
        self.at.is_zero()
    }

    /// Its sign if that is certain for both the computed and the exact value.
    fn one_sign(self) -> Option<f64> {
        let both = self.both();
        if both.low >= 0.0 { Some(1.0) } else { (both.high <= 0.0).then_some(-1.0) }
    }

    /// A number about which nothing is known.
    fn open() -> Self {
        Self { at: Interval::ALL, off: Interval::ALL }
    }
}

/// If it is undecided which is larger, either.
impl PartialOrd for Rounded {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.at.partial_cmp(&other.at).or_else(|| Some([Ordering::Less, Ordering::Greater][choose(2)]))
    }
}

impl PartialEq for Rounded {
    fn eq(&self, other: &Self) -> bool {
        self.at.partial_cmp(&other.at).map_or_else(|| choose(2) == 0, Ordering::is_eq)
    }
}

impl Series for Rounded {
    fn up_to(self, rest: impl FnOnce() -> Self) -> Self {
        Self { off: self.off + within(rest().both()), ..self }
    }
}

impl Lane for Rounded {
    one_lane!(exact);
    fn lane(&self, _: usize) -> f64 {
        // Of several numbers, one whose power of two is infinite, so that nothing is concluded.
        self.at.point().unwrap_or(1024.0)
    }
    fn lt(self, other: Self) -> bool {
        if self.at.low >= other.at.high { false } else { self.at.high < other.at.low || choose(2) == 0 }
    }
    fn abs(self) -> Self {
        match self.one_sign() {
            Some(sign) if sign < 0.0 => -self,
            Some(_) => self,
            None => Self { at: self.at.abs(), off: within(self.off) },
        }
    }
    fn sign(self) -> Self {
        let negative = self.at.high < 0.0 || (self.at.low <= 0.0 && choose(2) == 0);
        exact(if negative { -1.0 } else { 1.0 })
    }
    fn sqrt(self) -> Self {
        let at = self.at.sqrt();
        Self::scaled(at, self.off / (at + self.truth().sqrt()), false)
    }
    fn round_ties_even(self) -> Self {
        let [low, high] = [self.at.low, self.at.high].map(f64::round_ties_even);
        if high - low < 8.0 {
            return exact(low + choose((high - low) as usize + 1) as f64);
        }
        Self::given(Interval { low, high })
    }
    fn two_product_error(self, other: Self, _: Self) -> Self {
        self.product_in_two(other)[1]
    }
}

impl Rounding for Rounded {
    one_lane!();
    fn after_quarters(self, sin: Self, cos: Self) -> (Self, Self) {
        let quarters = self.at.point().unwrap_or_else(|| choose(4) as f64).rem_euclid(4.0);
        [(sin, cos), (cos, -sin), (-sin, -cos), (-cos, sin)][quarters as usize]
    }
    fn whole_and_left(self) -> [Self; 2] {
        let whole = self.round_ties_even();
        let left = (self.at - whole.at).clamped(-0.5, 0.5);
        let parts = (left.width() * PARTS).round().max(1.0);
        let edge = |k: f64| (left.low + left.width() * (k / parts)).min(left.high);
        let k = choose(parts as usize) as f64;
        let part = left.clamped(edge(k), if k + 1.0 < parts { edge(k + 1.0) } else { left.high });
        [whole, Self { at: part, off: self.off }]
    }
    fn less_near(self, other: Self) -> Self {
        let at = self.at - other.at;
        let most = units(self.at.hull(other.at), 4.0);
        Self { at: at.clamped(most.low, most.high), off: self.off - other.off }
    }
    fn sum_in_two(self, other: Self) -> [Self; 2] {
        let at = self.at + other.at;
        let size = |x: Self| x.at.abs().high;
        let least = size(self).min(size(other));
        let left = if at.low == at.high { Interval::zero() } else { units(at, 0.5).clamped(-least, least) };
        [Self::given(at), Self { at: left, off: self.off + other.off }]
    }
    fn quick_sum_in_two(self, other: Self) -> [Self; 2] {
        let [high, low] = self.sum_in_two(other);
        let (a, b) = (self.at.abs(), other.at.abs());
        if a.low >= b.high || self.at.is_zero() {
            return [high, low];
        }
        // Of a first that is smaller the two steps to the rest are rounded: each to a unit of the second.
        let slip = units(b + b, 1.0);
        [high, Self { at: low.at + slip, off: low.off + slip }]
    }
    fn product_in_two(self, other: Self) -> [Self; 2] {
        let at = self.at * other.at;
        if at.low == at.high {
            return [Self::given(at), Self { at: Interval::zero(), off: self.off_product(other) }];
        }
        let underflow = Interval { low: -TINY, high: TINY };
        [Self::given(at), Self { at: units(at, 0.5) + underflow, off: self.off_product(other) + underflow }]
    }
    fn in_one(high: Self, low: Self) -> [Self; 2] {
        [Self { at: high.at, off: high.off - low.truth() }, Self { at: low.at, off: low.at }]
    }
    fn near(self) -> Self {
        Self::given(self.at)
    }
    fn not_below_zero(self) -> Self {
        Self { at: self.at.clamped(0.0, f64::INFINITY), off: self.off.hull(Interval::zero()) }
    }
}

impl Real for Rounded {
    fn pi_in_two() -> [Self; 2] {
        const REST: f64 = 1.224_646_799_147_353_2e-16;
        let off = Interval { low: REST - REST.next_up(), high: REST - REST.next_down() };
        [exact(std::f64::consts::PI), Self { at: exact(REST).at, off }]
    }
    fn times_power_of_two(self, exponent: i32) -> Self {
        let half = exponent / 2;
        [half, exponent - half].iter().fold(self, |x, e| x * exact(2_f64.powi(*e)))
    }
    fn exponent(self) -> i32 {
        let size = self.at.abs();
        if size.is_zero() {
            return 0;
        }
        let [low, high] = [size.low, size.high].map(Real::exponent);
        low + choose((high - low) as usize + 1) as i32
    }
    fn exp_and_exp_m1(self) -> (Self, Self) {
        let (power, less) = self.at.exp_and_exp_m1();
        let off = -(power * (-self.off).exp_and_exp_m1().1);
        (Self::function(power, off), Self::function(less, off))
    }
    fn sin_cos(self) -> (Self, Self) {
        let ((sine, cosine), (sines, cosines)) = (self.at.sin_cos(), self.both().sin_cos());
        (Self::function(sine, self.off * cosines), Self::function(cosine, -(self.off * sines)))
    }
    fn atan2(self, x: Self) -> Self {
        let (ys, xs) = (self.both(), x.both());
        let off = (xs * self.off - ys * x.off) / (xs.square() + ys.square());
        Self::function(self.at.atan2(x.at), off)
    }
    fn hypot(self, other: Self) -> Self {
        let (a, b) = (self.both(), other.both());
        let off = (a * self.off + b * other.off) / (a.square() + b.square()).sqrt();
        Self::function((self.at.square() + other.at.square()).sqrt(), off)
    }
    fn at_most_one(self) -> Self {
        Self { at: self.at.clamped(f64::NEG_INFINITY, 1.0), off: self.off.hull(Interval::zero()) }
    }
    fn with_sign(self, of: Self) -> Self {
        match of.one_sign() {
            Some(sign) => self.abs() * exact(sign),
            None => Self::open(),
        }
    }
    fn of_one_sign(self) -> Self {
        if self.one_sign().is_some() { self } else { Self::open() }
    }
    // Without rounding it is zero, so that what is computed is the error.
    fn but_for_rounding(self) -> Self {
        let off = self.off.hull(Interval::zero());
        Self { at: off, off }
    }
    fn has_all_digits(self) -> bool {
        self.at.low > f64::MIN_POSITIVE
    }
}
