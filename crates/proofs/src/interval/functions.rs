//! Roots, sines, arctangents, exponentials and logarithms of intervals.

use super::arithmetic::root;
use super::{Interval, whole};
use num_traits::{One, Zero};

/// The number of terms of each series; the next term bounds its remainder.
const TERMS: i32 = 24;

/// The sum of `sign^n x^(2n+1) / (2n+1)`: the arctangent, or with a positive sign its hyperbolic sister, for
/// `|x| < 1/2`.
fn odd_powers(x: Interval, sign: i32) -> Interval {
    let square = x.square() * whole(sign);
    let mut sum = Interval::zero();
    let mut power = x;
    for n in 0..TERMS {
        sum += power * (whole(1) / whole(2 * n + 1));
        power *= square;
    }
    // The terms fall by a factor of four at least, so that the rest is below twice the first term left off.
    let rest = power.abs() * whole(2);
    sum + rest.hull(-rest)
}

fn logarithm_of_2() -> Interval {
    whole(2) * odd_powers(whole(1) / whole(3), 1)
}

impl Interval {
    /// The square root; all numbers if it may not exist.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.low < 0.0 || self.low.is_nan() {
            return if self.low.is_nan() { self } else { Self::ALL };
        }
        Self { low: root(self.low).0, high: root(self.high).1 }
    }

    /// The two ends, each an interval by itself.
    fn ends(self) -> [Self; 2] {
        [self.low, self.high].map(|end| Self { low: end, high: end })
    }

    /// From the values at the ends, of a function that rises.
    fn rising(self, f: impl Fn(Self) -> Self) -> Self {
        let [low, high] = self.ends().map(f);
        Self { low: low.low, high: high.high }
    }

    /// Sine and cosine of an angle in radians.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        if self.low.is_nan() {
            return (self, self);
        }
        let middle = self.low + 0.5 * (self.high - self.low);
        let quarters = (middle / std::f64::consts::FRAC_PI_2).round();
        if quarters.is_nan() || quarters.abs() >= 1e9 {
            let any = Self { low: -1.0, high: 1.0 };
            return (any, any);
        }
        let point = Self { low: middle, high: middle };
        let turns = whole(quarters as i32);
        let (sine, cosine) = small_sin_cos(point - turns * Self::PI / whole(2));
        let (sine, cosine) = match (quarters as i32).rem_euclid(4) {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        };
        // Neither changes faster than its angle.
        let off = (self - point).abs();
        let around = |x: Self| (x + off.hull(-off)).clamped(-1.0, 1.0);
        (around(sine), around(cosine))
    }

    /// The arctangent, in radians.
    #[must_use]
    pub fn atan(self) -> Self {
        let half_turn = Self::PI / whole(2);
        let once = |mut x: Self| {
            if x.low.is_infinite() || x.high.is_infinite() {
                return (-half_turn).hull(half_turn);
            }
            for _ in 0..3 {
                x = x / (Self::one() + (Self::one() + x.square()).sqrt());
            }
            whole(8) * odd_powers(x, -1)
        };
        self.rising(once)
    }

    /// The angle from the first axis to the point `(x, self)`, in radians; within a turn where the point may
    /// lie on the axis' other side.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let quarter = Self::PI / whole(2);
        if x.low > 0.0 || Self::none([self, x]) {
            (self / x).atan()
        } else if self.low > 0.0 {
            quarter - (x / self).atan()
        } else if self.high < 0.0 {
            -quarter - (x / self).atan()
        } else {
            (-Self::PI).hull(Self::PI)
        }
    }

    /// The angle whose cosine it is, in radians; no number where it is no cosine.
    #[must_use]
    pub fn acos(self) -> Self {
        let within = self.clamped(-1.0, 1.0);
        let sine = ((Self::one() - within) * (Self::one() + within)).not_negative().sqrt();
        let angle = sine.atan2(within);
        angle.clamped(0.0, Self::PI.high)
    }

    /// The exponential, and the exponential less 1.
    pub fn exp_and_exp_m1(self) -> (Self, Self) {
        if !(self.low > -1e4 && self.high < 1e4) {
            return (Self::ALL, Self::ALL);
        }
        let both = |x: Self| {
            let twos = (x.low * std::f64::consts::LOG2_E).round();
            let part = x - whole(twos) * logarithm_of_2();
            // The sum of x^n/n!, of which each term is less than a half of the one before.
            let (mut term, mut less) = (part, Self::zero());
            for n in 2..=TERMS {
                less += term;
                term *= part * (whole(1) / whole(n));
            }
            let rest = term.abs() * whole(2);
            let less = less + rest.hull(-rest);
            if twos == 0.0 {
                return (Self::one() + less, less);
            }
            let half = (twos as i32) / 2;
            let power = [half, twos as i32 - half].map(|e| whole(2_f64.powi(e)));
            let power = (Self::one() + less) * power[0] * power[1];
            (power, power - Self::one())
        };
        (self.rising(|x| both(x).0), self.rising(|x| both(x).1))
    }

    /// The natural logarithm; all numbers if it may not exist.
    #[must_use]
    pub fn ln(self) -> Self {
        if self.low <= 0.0 || self.high.is_infinite() {
            return Self::ALL;
        }
        // ln(1/2^k x) by the hyperbolic arctangent of (x - 1)/(x + 1), which is a fifth at most.
        let near_one = |x: Self| whole(2) * odd_powers((x - Self::one()) / (x + Self::one()), 1);
        self.rising(|x| {
            // These products are exact, of the smallest floats too.
            let (mut x, mut powers) = (x, 0);
            while x.high > 1.5 {
                x = Self { low: 0.5 * x.low, high: 0.5 * x.high };
                powers += 1;
            }
            while x.low < 0.7 {
                x = Self { low: 2.0 * x.low, high: 2.0 * x.high };
                powers -= 1;
            }
            near_one(x) + whole(powers) * logarithm_of_2()
        })
    }

    /// An angle in radians, in degrees.
    #[must_use]
    pub fn to_degrees(self) -> Self {
        self * whole(180) / Self::PI
    }

    /// An angle in degrees, in radians.
    #[must_use]
    pub fn to_radians(self) -> Self {
        self * Self::PI / whole(180)
    }
}

/// Sine and cosine by their series, of an angle below one.
fn small_sin_cos(x: Interval) -> (Interval, Interval) {
    let square = -x.square();
    let (mut sine, mut cosine) = (Interval::zero(), Interval::zero());
    let mut term = Interval::one();
    for n in 0..TERMS / 2 {
        cosine += term;
        let odd = term * (whole(1) / whole(2 * n + 1));
        sine += odd;
        term = odd * square * (whole(1) / whole(2 * n + 2));
    }
    let rest = term.abs() * whole(2);
    let rest = rest.hull(-rest);
    ((sine + rest) * x, cosine + rest)
}
