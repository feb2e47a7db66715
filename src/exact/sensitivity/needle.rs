//! Thin needles that spin fast about themselves while they hardly turn over.
//!
//! Their momentum is small relative to its change when the spin changes, so computing the rotation from the
//! conservation of momentum would subtract large, nearly equal terms. Here the rotation is summed over steps
//! instead, and over whole periods by doubling.

use super::series::{Request, span};
use super::{Derivatives, FreeMotion, Motion, SpinDerivatives};
use crate::error::Error;
use nalgebra::Vector3;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// If the turn about the momentum, divided by the angle of the spin, is less than this, summation is more
/// accurate.
const SLOW: f64 = 1.0;
/// Above this a number of periods is not exact.
const COUNTABLE: f64 = 9_007_199_254_740_992.0;

impl Derivatives {
    /// Over this span and the next one.
    fn then(&self, next: &Self) -> Self {
        Self {
            back: next.back * self.back,
            turn: next.back * self.turn + next.turn * self.spin.spin,
            turn_by_tensor: next.back * self.turn_by_tensor
                + next.turn * self.spin.by_tensor
                + next.turn_by_tensor,
            spin: SpinDerivatives {
                spin: next.spin.spin * self.spin.spin,
                by_tensor: next.spin.spin * self.spin.by_tensor + next.spin.by_tensor,
                energy: [0.0; 6],
            },
        }
    }
}

impl FreeMotion {
    /// The derivatives of the attitude over scaled `time`, if this is such a motion, with those of the spin.
    pub(super) fn slow_turn(
        &self,
        moments: &[f64; 3],
        omega: &[f64; 3],
        time: f64,
        tensor: bool,
    ) -> Option<Result<Derivatives, Error>> {
        let speed = Vector3::from(*omega).norm();
        let momentum = Vector3::from(*moments).component_mul(&Vector3::from(*omega)).norm();
        let (spun, tipped) = (speed * time.abs(), momentum * time.abs() / Vector3::from(*moments).max());
        if spun * tipped > SLOW {
            return None;
        }
        let period = match &self.law {
            Motion::AtRest => return None,
            // Any will do.
            Motion::Steady(_) => 1.0 / speed,
            Motion::Symmetric(top) => 1.0 / top.nutation_turns().abs(),
            Motion::Elliptic(motion) => 2.0 * motion.half_period()?,
        };
        let period = period.copysign(time);
        let mut count = (time / period).trunc();
        if count > COUNTABLE {
            return None;
        }
        let across = |time: f64| -> Derivatives {
            let request = Request { attitude: true, tensor };
            span(moments, omega, time, [speed * time; 2], request).1
        };
        let mut found = across(if count > 0.0 { time - count * period } else { time });
        let mut power = (count > 0.0).then(|| across(period));
        while let Some(whole) = power {
            let half = (0.5 * count).trunc();
            if count > 2.0 * half {
                found = whole.then(&found);
            }
            count = half;
            power = (count > 0.0).then(|| whole.then(&whole));
        }
        // Beyond short spans the closed form has the spin to more digits.
        let now = self.scaled(&self.omega_along(time));
        Some(
            self.spin_derivatives(moments, omega, &now, time, tensor)
                .map(|spin| Derivatives { spin, ..found }),
        )
    }
}
