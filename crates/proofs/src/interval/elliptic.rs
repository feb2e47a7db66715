//! Elliptic integrals and functions of intervals, by the complement of the modulus.

use super::{Interval, whole};
use crate::Rational;
use num_traits::{One, Zero};

/// Carlson's integral of the first kind, of three numbers of which one at most is zero.
///
/// Each number replaced by the mean of itself and `sqrt(xy) + sqrt(yz) + sqrt(zx)`, over four, the integral
/// stays and the three come together; it lies between the inverse roots of the largest and the smallest.
/// Source: [Car95](tumbling::references).
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

/// The quarter period K, by the complement `k'` of the modulus, whose logarithm is given too.
///
/// Below a thousandth `ln(4/k') < K < (1 + k'^2/4) ln(4/k')`, source: [DLMF](tumbling::references), 19.9.2.
#[must_use]
pub fn quarter_period(complement: Interval, logarithm: Interval) -> Interval {
    if complement.high() > 1e-3 {
        return carlson_first(Interval::zero(), complement.square(), Interval::one());
    }
    let least = whole(2) * whole(2).ln() - logarithm;
    let most = Interval::one() + complement.square() / whole(4);
    least * Interval::one().hull(most)
}

/// Jacobi's sn, cn and dn of `u`, by the complement of the modulus.
///
/// Gauss's transformation makes the modulus smaller, quadratically; of a modulus near zero the amplitude lies
/// between `k' u` and `u`. Source: [DLMF](tumbling::references), 22.7.2 to 22.7.4.
///
/// ```
/// use tumbling_proofs::{Interval, given, interval::elliptic::jacobi};
/// // With k = 1/2 at u = 1, as a Runge-Kutta solution of their equations in 40 digits has it.
/// let (sn, cn, dn) = jacobi(given!(1), given!(Interval: 0.75).sqrt());
/// assert_eq!(format!("{sn:.10} {cn:.10} {dn:.10}"), "0.8226355781 0.5685689981 0.9114920057");
/// ```
#[must_use]
pub fn jacobi(u: Interval, complement: Interval) -> (Interval, Interval, Interval) {
    descend(u, complement, 12)
}

fn descend(u: Interval, complement: Interval, rounds: usize) -> (Interval, Interval, Interval) {
    let one = Interval::one();
    let parameter = ((one - complement) * (one + complement)).not_negative();
    if rounds == 0 || parameter.high() < 1e-16 {
        let amplitude = u * complement.hull(one);
        let (sn, cn) = amplitude.sin_cos();
        return (sn, cn, (one - parameter * sn.square()).not_negative().sqrt());
    }
    let modulus = (one - complement) / (one + complement);
    let next = (whole(2) * complement.sqrt() / (one + complement)).clamped(0.0, 1.0);
    let (sn, cn, dn) = descend(u / (one + modulus), next, rounds - 1);
    let part = modulus * sn.square();
    let below = one + part;
    let within = |x: Interval| x.clamped(-1.0, 1.0);
    (within((one + modulus) * sn / below), within(cn * dn / below), within((one - part) / below))
}
