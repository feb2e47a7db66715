//! The energy of an engine whose tensor never turns, as a measurement shows it, enclosed.
//!
//! Its spin obeys Euler's equations in the world, and the closed form encloses it. The attitude follows the
//! spin, and here is turned through each short part of the time, `h`, by `h w` with the spin `w` at the
//! part's middle. So turns a frame whose rotation vector is `s w + (s² - s h)/2 w'` at the time `s` of the
//! part, `v`. Its spin differs from the rate of `v`, which is `w + (s - h/2) w'`, by `1/2 + |v|/6` times
//! `s²/2 |w x w'|` at most, and that from the true one by `(s - h/2)²/2 |w''|`. The integral of both bounds
//! the angle that the two frames come apart by.

use super::motion::FreeMotion;
use super::{Interval, whole};
use nalgebra::{Matrix3, Quaternion, Vector3};
use num_traits::{One, Zero};
use tumbling::attitude::{product, rotation_matrix};
use tumbling::dynamics::observe::energy;

/// The number of equal parts in which the attitude is turned from one instant to the next.
const PARTS: u32 = 8;

/// Bounds of the spin and of its first two rates, rad/s, rad/s² and rad/s³: the spin is largest where all
/// energy is about the axis of the smallest moment. Of a vector the squares of the products of two components
/// sum up to a third of its fourth power at most.
fn bounds(moments: &Vector3<Interval>, omega: &Vector3<Interval>) -> [Interval; 3] {
    let least = moments.iter().fold(moments.x, |a, b| a.min_of(*b));
    let spin = (energy(omega, &moments.component_mul(omega)) * whole(2) / least).sqrt();
    let factor = |a: usize| ((moments[(a + 1) % 3] - moments[(a + 2) % 3]) / moments[a]).abs();
    let factor = -[factor(1), factor(2)].iter().fold(-factor(0), |a, b| a.min_of(-*b));
    let rate = factor * spin.square() / whole(3).sqrt();
    [spin, rate, whole(2).sqrt() * factor * spin * rate]
}

/// The smallest and the largest energy at `instants` instants, `apart` seconds from each other, relative to
/// the energy at the start, for the principal moments (kg m²) and the spin (rad/s) along their axes. `None`
/// where the closed form encloses no motion.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling_proofs::{Interval, given, interval::frozen};
/// let moments = Vector3::<Interval>::new(given!(10), given!(13), given!(5));
/// let omega = Vector3::new(given!(1), given!(1), given!(1));
/// let [low, _] = frozen::energies(&moments, &omega, 100, given!(0.01)).unwrap();
/// assert_eq!(format!("{low:.2}"), "0.86");
/// ```
#[must_use]
pub fn energies(
    moments: &Vector3<Interval>,
    omega: &Vector3<Interval>,
    instants: u32,
    apart: Interval,
) -> Option<[Interval; 2]> {
    let motion = FreeMotion::new(moments, omega).ok()?;
    let (tensor, part) = (Matrix3::from_diagonal(moments), apart / whole(PARTS));
    let first = energy(omega, &(tensor * omega));
    let [spin, rate, second] = bounds(moments, omega);
    let share = Interval::one() / whole(2) + part * spin / whole(6);
    let comes_apart = part * part * part * (share * spin * rate / whole(6) + second / whole(24));
    // By an angle the energy changes at most by this.
    let spread = moments.iter().fold(moments.x, |a, b| a.hull(*b)).width();
    let per_angle = Interval { low: 0.0, high: spread } * spin.square() / first;
    let (zero, one) = (Interval::zero(), Interval::one());
    let mut attitude = Quaternion::new(one, zero, zero, zero);
    let (mut off, mut least, mut greatest) = (zero, one, one);
    for n in 0..instants * PARTS {
        let middle = motion.omega(part * (whole(n) + Interval::one() / whole(2)));
        let (turned, width) = turn(&attitude, &middle, part);
        attitude = turned;
        off = off + comes_apart + width;
        if (n + 1) % PARTS == 0 {
            let now = motion.omega(part * whole(n + 1));
            let size = attitude.coords.iter().fold(Interval::zero(), |sum, x| sum + x.square());
            let rotation = rotation_matrix(&attitude).map(|x| x / size);
            let shown = energy(&now, &(rotation * tensor * rotation.transpose() * now)) / first;
            let shown = shown + (per_angle * off).hull(-(per_angle * off));
            least = least.min_of(shown);
            greatest = -(-greatest).min_of(-shown);
        }
    }
    Some([least, greatest])
}

/// The attitude turned in the world by a spin for this long, as floats, and the angle that they are off by.
fn turn(q: &Quaternion<Interval>, spin: &Vector3<Interval>, h: Interval) -> (Quaternion<Interval>, Interval) {
    let speed = super::geometry::length(spin);
    let (sin, cos) = (speed * h / whole(2)).sin_cos();
    let [x, y, z] = spin.map(|w| w * sin / speed).into();
    let turned = product(&Quaternion::new(cos, x, y, z), q);
    let width: f64 = turned.coords.iter().map(|x| x.width()).sum();
    let middle = |x: Interval| {
        let middle = x.low + 0.5 * (x.high - x.low);
        Interval { low: middle, high: middle }
    };
    // Of a quaternion of length one, near enough, an angle is twice its change; and of its sum of four.
    let off = Interval { low: 0.0, high: 4.0 * width };
    (Quaternion::from_vector(turned.coords.map(middle)), off.hull(Interval::zero()))
}
