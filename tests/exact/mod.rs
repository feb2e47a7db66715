//! The exact motion.

mod extremes;
mod flips;
mod geometry;
mod motion;
mod regime;
mod sensitivity;
mod top;

use crate::common::free_motion;
use nalgebra::{UnitQuaternion, Vector3};
use serde_json::Value;
use tumbling::exact::FreeMotion;

/// The rounding of one input, relative.
const ROUNDING: f64 = f64::EPSILON / 2.0;

fn motion(moments: [f64; 3], omega: [f64; 3]) -> FreeMotion {
    free_motion(moments, &omega.into())
}

/// The angle between two attitudes is at most twice this.
pub(crate) fn apart(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    let (a, b) = (a.coords, b.coords);
    (a - b).norm().min((a + b).norm())
}

fn distinct(m: &Vector3<f64>) -> bool {
    (0..3).all(|i| (m[i] / m[(i + 1) % 3] - 1.0).abs() > 0.02)
}

/// Numbers of the table, as the nearest `f64` to their 40 digits.
fn numbers(value: &Value) -> Vec<f64> {
    let number = |x: &Value| x.as_str().unwrap().parse().unwrap();
    value.as_array().unwrap().iter().map(number).collect()
}
