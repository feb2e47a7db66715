//! Quantities derived from a motion: its kinetic energy and its flips.

use crate::number::Field;
use alloc::vec::Vec;
use nalgebra::Vector3;

/// Kinetic energy, J: half of `w . L`, the same in body and world axes as long as both vectors share them.
///
/// ```
/// use nalgebra::Vector3;
/// let (omega, momentum) = (Vector3::new(1.0, 1.0, 0.0), Vector3::new(2.0, 4.0, 0.0));
/// let energy = tumbling::dynamics::observe::energy(&omega, &momentum);
/// assert_eq!(energy, 3.0);
/// ```
#[must_use]
pub fn energy<T: Field>(omega: &Vector3<T>, momentum: &Vector3<T>) -> T {
    omega.dot(momentum) / T::integer(2)
}

/// The instants at which a sampled quantity changes sign, by linear interpolation between samples; a flip is
/// a change of sign of the spin along the middle axis.
///
/// `samples` are pairs of time and value, in order of time. A value of exactly zero has the sign of the value
/// before it. So where a sample is zero and the next has the opposite sign, the change is at the zero. A zero
/// in the first sample is not a change, just as an interval does not contain a flip at its start. After a
/// zero in the last sample it is unknown whether the sign changes. Pairs that are not finite are ignored.
///
/// ```
/// use tumbling::dynamics::observe::sign_changes;
/// let times = sign_changes([(0.0, 2.0), (1.0, 1.0), (2.0, -1.0), (3.0, 0.0), (4.0, -1.0), (5.0, 3.0)]);
/// assert_eq!(times, [1.5, 4.25]);
/// ```
#[must_use]
pub fn sign_changes(samples: impl IntoIterator<Item = (f64, f64)>) -> Vec<f64> {
    let mut crossings = Vec::new();
    let mut last = (0.0, 0.0);
    let mut below: Option<bool> = None;
    for (t, x) in samples {
        if !(t.is_finite() && x.is_finite()) {
            continue;
        }
        if x != 0.0 {
            if below.is_some_and(|below| below != (x < 0.0)) {
                let (t0, x0): (f64, f64) = last;
                // The share of the interval, and the mean of the ends, without a sum that could overflow.
                let share = if x0 == 0.0 { 0.0 } else { 1.0 / (1.0 + (x / x0).abs()) };
                // Rounding could take it beyond the samples, and so past the next change.
                crossings.push((t0 * (1.0 - share) + t * share).clamp(t0.min(t), t0.max(t)));
            }
            below = Some(x < 0.0);
        }
        last = (t, x);
    }
    crossings
}
