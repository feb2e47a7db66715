//! Thin needles that spin fast about themselves while they hardly turn over.
//!
//! Their momentum is small beside what a change of the spin adds to it, so that what the momentum's constancy says about
//! the turn is a small difference of large terms. Here the turn is added up from steps instead, and over whole
//! periods by doubling.

use super::series::short;
use super::{FreeMotion, Law};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Where the momentum turns the body by less than this over the angle of the spin, adding up is the better way.
const SLOW: f64 = 1.0;
/// Above this a number of periods is not exact.
const COUNTABLE: f64 = 9_007_199_254_740_992.0;

/// What a span of the motion does: to a change of the spin and to the turn, by the spin before it and by the moments.
struct Map {
    spin: Matrix3<f64>,
    spin_by_moments: Matrix3<f64>,
    turn: Matrix3<f64>,
    turn_by_moments: Matrix3<f64>,
    attitude: UnitQuaternion<f64>,
}

impl Map {
    fn then(&self, next: &Self) -> Self {
        let rotation = self.attitude.to_rotation_matrix().into_inner();
        Self {
            spin: next.spin * self.spin,
            spin_by_moments: next.spin * self.spin_by_moments + next.spin_by_moments,
            turn: self.turn + rotation * (next.turn * self.spin),
            turn_by_moments: self.turn_by_moments
                + rotation * (next.turn * self.spin_by_moments + next.turn_by_moments),
            attitude: self.attitude * next.attitude,
        }
    }
}

impl FreeMotion {
    /// The turns in the world over scaled `time`, if this is such a motion.
    pub(super) fn slow_turn(
        &self,
        moments: &[f64; 3],
        omega: &[f64; 3],
        time: f64,
    ) -> Option<[Vector3<f64>; 6]> {
        let speed = Vector3::from(*omega).norm();
        let momentum = Vector3::from(*moments).component_mul(&Vector3::from(*omega)).norm();
        let (spun, tipped) = (speed * time.abs(), momentum * time.abs() / Vector3::from(*moments).max());
        if spun * tipped > SLOW {
            return None;
        }
        let period = match &self.law {
            Law::AtRest => return None,
            // Any will do.
            Law::Steady(_) => 1.0 / speed,
            Law::Symmetric(top) => 1.0 / top.wobble_turns().abs(),
            Law::Elliptic(motion) => 2.0 * motion.half_period()?,
        };
        let period = period.copysign(time);
        let mut count = (time / period).trunc();
        if count > COUNTABLE {
            return None;
        }
        let rest = if count > 0.0 { time - count * period } else { time };
        let mut map = self.map(moments, omega, rest, speed);
        let mut power = if count > 0.0 { Some(self.map(moments, omega, period, speed)) } else { None };
        while let Some(whole) = power {
            let half = (0.5 * count).trunc();
            if count > 2.0 * half {
                map = whole.then(&map);
            }
            count = half;
            power = (count > 0.0).then(|| whole.then(&whole));
        }
        let columns = [map.turn, map.turn_by_moments];
        Some([0, 1, 2, 3, 4, 5].map(|k| columns[k / 3].column(k % 3).into()))
    }

    fn map(&self, moments: &[f64; 3], omega: &[f64; 3], time: f64, speed: f64) -> Map {
        let short = short(moments, omega, time, speed * time);
        let attitude = self.turned(time);
        let turn = short.turn.map(|turn| attitude * turn);
        let spin = &short.change.spin;
        Map {
            spin: Matrix3::from_columns(&spin[..3]),
            spin_by_moments: Matrix3::from_columns(&spin[3..]),
            turn: Matrix3::from_columns(&turn[..3]),
            turn_by_moments: Matrix3::from_columns(&turn[3..]),
            attitude,
        }
    }
}
