//! Carlson's integral of intervals.

use super::Interval;
use crate::Rational;
use num_traits::One;

/// Carlson's integral of the first kind, of three numbers of which one at most is zero.
///
/// If each number is replaced by the mean of itself and `sqrt(xy) + sqrt(yz) + sqrt(zx)`, divided by four,
/// the integral is unchanged and the three numbers approach each other. The integral lies between the inverse
/// roots of the largest and the smallest. Source: [Car95](tumbling::references).
///
/// ```
/// use tumbling_proofs::{Interval, given, interval::elliptic::carlson_first};
/// // Of a circle: half of pi.
/// let quarter = carlson_first(given!(0), given!(1), given!(1));
/// assert!((quarter * given!(2) - Interval::PI).has_zero() && quarter.width() < 1e-13);
/// ```
#[must_use]
pub fn carlson_first(x: Interval, y: Interval, z: Interval) -> Interval {
    let mut numbers = [x, y, z].map(Interval::not_negative);
    let quarter = Rational::new(1, 4);
    for _ in 0..ROUNDS {
        let [a, b, c] = numbers.map(Interval::sqrt);
        let mean = a * b + b * c + c * a;
        numbers = numbers.map(|number| (number + mean) * Interval::from(quarter.clone()));
    }
    let [x, y, z] = numbers;
    Interval::one() / x.hull(y).hull(z).sqrt()
}

/// Each round brings the numbers together by a factor of four at least, once they are of one size.
const ROUNDS: usize = 40;
