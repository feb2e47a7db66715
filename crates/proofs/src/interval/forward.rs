//! Bounds on the error of the library's free motion computed with floats, for all floats in a box.
//!
//! The closed form runs on numbers that propagate their rounding errors, over boxes of moments, spins and
//! times at once. The bounds assume two things. First, in the preparation of the motion, the library's
//! exponential, `exp(x) - 1`, sine, cosine, arctangent and length of two numbers are right to a unit in the
//! last place, which tests sample. Second, the remainders of the series are as stated. For the theta sums,
//! and for exponential, sine and cosine at an instant, they are argued next to each in the library's code and
//! compared with sums of many more terms, at samples in exact fractions (`tests/proofs/rests.rs`). For the
//! mean and for Carlson's series they are only argued. Everything else follows from IEEE 754.

use super::Interval;
use super::motion::{self, Open};
use super::paths::every_path;
use super::rounded::Rounded;
use crate::Rational;
use nalgebra::Vector3;
use num_traits::Zero;
use tumbling::exact;
use tumbling::laws::ClosedForm;

/// Bounds on the errors of the computed spin (rad/s) and the computed attitude (radians), for all floats in
/// these intervals of moments (kg m²), spin (rad/s) and time (s); infinite where no bound is found.
///
/// ```
/// use tumbling_proofs::interval::{forward, motion::of_floats};
/// let [spin, attitude] = forward::bound_of_all([1.0, 2.0, 3.0], [0.5, 1.0, 2.0], 1e-12, 1.0).unwrap();
/// assert!(spin < 2e-14 && attitude < 1e-13);
/// ```
///
/// # Errors
/// Intervals that leave open which kind of motion it is, or in which a component of the spin can be zero.
pub fn bound(moments: &Vector3<Interval>, omega: &Vector3<Interval>, t: Interval) -> Result<[f64; 2], Open> {
    motion::FreeMotion::new(moments, omega)?;
    if omega.iter().any(|w| w.has_zero()) {
        return Err(Open::Spin);
    }
    let given = |v: &Vector3<Interval>| (*v).map(Rounded::given).into();
    let size = |x: &[Rounded]| x.iter().fold(Interval::zero(), |sum, x| sum + x.off.square()).sqrt().high();
    let mut most = [0.0_f64; 2];
    let motions = every_path(|| ClosedForm::new(given(moments), given(omega)));
    for motion in motions.unwrap_or_else(|| vec![None]) {
        let motion = motion.ok_or(Open::Spin)?;
        let Some(instants) = every_path(|| motion.at(Rounded::given(t))) else {
            return Ok([f64::INFINITY; 2]);
        };
        for (spin, turn) in instants {
            // Of a quaternion at this distance from one of length one the angle is off by twice the arcsine.
            let apart = size(turn.coords.as_slice());
            let off = [size(spin.as_slice()), 2.0 * apart * (1.0 + 0.6 * apart * apart)];
            most = [0, 1].map(|k| if off[k] >= most[k] || off[k].is_nan() { off[k] } else { most[k] });
        }
    }
    Ok(most)
}

/// The relative half widths of the boxes in [`table`], by its rows: in much wider boxes too many of the
/// code's comparisons are undecided.
pub const SHARES: [f64; 5] = [1e-10, 1e-10, 1e-11, 1e-10, 1e-12];

/// [`bound`] for all bodies and spins that differ from the given ones by at most `share` in each number
/// (relative), at all times from 0 to `flips` times the time between flips of the given body.
///
/// # Errors
/// As [`bound`].
pub fn bound_of_all(moments: [f64; 3], omega: [f64; 3], share: f64, flips: f64) -> Result<[f64; 2], Open> {
    let near_one = Interval { low: (1.0 - share).next_down(), high: (1.0 + share).next_up() };
    let around = |x: [f64; 3]| Vector3::from(x.map(|x| Interval { low: x, high: x } * near_one));
    let (_, late) = motion::of_floats(moments, omega, flips)?;
    bound(&around(moments), &around(omega), Interval { low: 0.0, high: late })
}

/// The rows of the book's table, one for each body except the one next to the separatrix: the relative half
/// width, the bound on the spin, divided by its largest component at the start, and the bounds on the
/// attitude up to one flip and up to a billion; rounded up.
///
/// # Errors
/// As [`bound`].
pub fn table() -> Result<Vec<String>, Open> {
    let up = |x: f64| {
        let unit = 10_f64.powf(x.log10().floor());
        format!("{:.0e}", (x / unit).ceil() * unit)
    };
    let moving = motion::BODIES.into_iter().filter(|(.., omega)| !omega.contains(&0.0));
    let row = |((name, moments, omega), share): (motion::Body, f64)| {
        let size = omega.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let [_, first] = bound_of_all(moments, omega, share, 1.0)?;
        let [spin, last] = bound_of_all(moments, omega, share, 1e9)?;
        Ok(format!("| {name} | {share:.0e} | {} | {} | {} |", up(spin / size), up(first), up(last)))
    };
    moving.zip(SHARES).map(row).collect()
}

/// Of each of [`motion::BODIES`] moments and spin, four times, and spin and attitude then, to 40 digits.
const TRUTHS: &str = include_str!("../../../../tests/data/late.json");

/// The rows of the book's table, one for each body of [`table`]: the difference of the library's spin from 40
/// digits, divided by its largest component at the start, at the worst of four times; and of its attitude, in
/// radians, after one flip and after a billion. `None` where these digits are missing.
#[must_use]
pub fn measured() -> Option<Vec<String>> {
    let numbers: Vec<_> = TRUTHS.split('"').filter(|text| text.parse::<f64>().is_ok()).collect();
    let row = |((name, moments, omega), truth): (motion::Body, &[&str])| {
        let motion = exact::FreeMotion::new(moments.try_into().ok()?, &omega.into()).ok()?;
        let apart = |x: &[f64], from: usize, sign: i64| {
            let off = |(x, truth): (&f64, &&str)| {
                let truth = Rational::of_decimal(&truth.replace('+', ""))? * Rational::from(sign);
                Some((Rational::of_f64(*x) - truth).to_f64().powi(2))
            };
            Some(x.iter().zip(&truth[from..]).map(off).sum::<Option<f64>>()?.sqrt())
        };
        let mut found = [[0.0; 2]; 4];
        for (k, found) in found.iter_mut().enumerate() {
            let now = motion.at(truth[6 + k].parse().ok()?).ok()?;
            let [x, y, z, w] = now.attitude.coords.into();
            let [turn, other] = [1, -1].map(|sign| apart(&[w, x, y, z], 22 + 4 * k, sign));
            *found = [apart(now.omega.as_slice(), 10 + 3 * k, 1)?, 2.0 * turn?.min(other?)];
        }
        let size = omega.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let spin = found.iter().fold(0.0, |a: f64, x| a.max(x[0]));
        Some(format!("| {name} | {:.0e} | {:.0e} | {:.0e} |", spin / size, found[0][1], found[3][1]))
    };
    let bodies = motion::BODIES.into_iter().zip(numbers.chunks_exact(46));
    bodies.filter(|((.., omega), _)| !omega.contains(&0.0)).map(row).collect()
}
