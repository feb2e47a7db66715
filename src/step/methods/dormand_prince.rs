//! The embedded pair of Dormand and Prince, orders 5 and 4 [DP80](crate::references), at a fixed step or with its error controlled.

use crate::body::{Rate, State};
use crate::error::{Error, finite, positive};
use crate::number::functions::fifth_root;
use crate::number::{Analytic, Field};
use crate::step::method::{Conserved, MethodInfo, check_square_underflow};
use crate::step::system::System;
use alloc::vec::Vec;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

pub(crate) const INFO: MethodInfo = MethodInfo {
    name: "Dormand-Prince 5",
    order: 5,
    implicit: false,
    conserved: Conserved::NONE,
    source: "DP80",
};

/// A whole number over another.
type Ratio = (i32, u32);

/// Each stage's weights of the slopes before it. The last row is the step of order 5.
const STAGES: [&[Ratio]; 6] = [
    &[(1, 5)],
    &[(3, 40), (9, 40)],
    &[(44, 45), (-56, 15), (32, 9)],
    &[(19_372, 6561), (-25_360, 2187), (64_448, 6561), (-212, 729)],
    &[(9017, 3168), (-355, 33), (46_732, 5247), (49, 176), (-5103, 18_656)],
    &[(35, 384), (0, 1), (500, 1113), (125, 192), (-2187, 6784), (11, 84)],
];

/// Weights of the seven slopes in the difference of the two orders: the estimate of the error.
const ERROR: [Ratio; 7] =
    [(71, 57_600), (0, 1), (-71, 16_695), (71, 1920), (-17_253, 339_200), (22, 525), (-1, 40)];

fn number<T: Field>((n, d): Ratio) -> T {
    let size = T::integer(n.unsigned_abs()) / T::integer(d);
    if n < 0 { -size } else { size }
}

fn combined<T: Analytic>(start: &State<T>, slopes: &[Rate<T>], weights: &[Ratio], h: &T) -> State<T> {
    slopes
        .iter()
        .zip(weights)
        .filter(|(_, weight)| weight.0 != 0)
        .fold(start.clone(), |sum, (slope, &weight)| sum.plus(slope, h.clone() * number::<T>(weight)))
}

/// The end of a step and the six slopes that it took, given the first.
fn stages<T: Analytic>(
    system: &System<T>,
    start: &State<T>,
    first: Rate<T>,
    h: &T,
) -> (State<T>, Vec<Rate<T>>) {
    let mut slopes = Vec::with_capacity(7);
    slopes.push(first);
    let [inner @ .., last] = &STAGES;
    for weights in inner {
        let here = combined(start, &slopes, weights, h);
        slopes.push(system.rate(&here));
    }
    (combined(start, &slopes, last, h), slopes)
}

pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    stages(system, start, system.rate(start), h).0
}

/// What a run with controlled error came to.
#[derive(Debug, Clone, PartialEq)]
pub struct Controlled {
    /// The motion at the end.
    pub end: State<f64>,
    /// Steps that were taken.
    pub steps: usize,
    /// Steps that were tried and found too coarse.
    pub rejected: usize,
}

/// Below this a step's error is rounding, and no step meets the tolerance.
pub const LEAST_TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// The most steps, taken or not, of one [`controlled`] run.
pub const MOST_STEPS: usize = 100_000_000;

/// The motion `duration` seconds after `start` (before, if negative), by steps that keep the estimated error of each, beside
/// the attitude's length and the momentum's size, below `tolerance`.
///
/// The first step is a guess, by how far the body turns; the others follow from the error of the one before. The tolerance is of a step, not
/// of the run: errors add up, and each run must be judged by what it reaches.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::PrincipalMoments;
/// use tumbling::exact::FreeMotion;
/// use tumbling::step::{State, System, controlled};
/// let (moments, omega) = (PrincipalMoments::new(1.0, 2.0, 2.5)?, Vector3::new(0.3, 2.0, 0.1));
/// let system = System::free(moments)?;
/// let start = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
/// let run = controlled(&system, &start, 10.0, 1e-10)?;
/// let truth = FreeMotion::new(moments, &omega)?.at(10.0)?;
/// assert!((run.end.attitude.coords - truth.attitude.coords).norm() < 1e-8);
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// # Errors
/// A duration that is not finite, a tolerance below [`LEAST_TOLERANCE`], a motion that leaves `f64`, an error that stays too large
/// however short the step, or more than [`MOST_STEPS`].
pub fn controlled(
    system: &System<f64>,
    start: &State<f64>,
    duration: f64,
    tolerance: f64,
) -> Result<Controlled, Error> {
    controlled_within(system, start, duration, tolerance, &mut { MOST_STEPS })
}

/// The same in no more steps, taken or not, than are left, off which they are taken.
pub(crate) fn controlled_within(
    system: &System<f64>,
    start: &State<f64>,
    duration: f64,
    tolerance: f64,
    left: &mut usize,
) -> Result<Controlled, Error> {
    finite("the duration", duration)?;
    positive("the tolerance", tolerance)?;
    if tolerance < LEAST_TOLERANCE {
        return Err(Error::Order {
            smaller: "rounding in a step",
            small: LEAST_TOLERANCE,
            larger: "the tolerance",
            large: tolerance,
        });
    }
    let mut run = Controlled { end: *start, steps: 0, rejected: 0 };
    if duration == 0.0 {
        return Ok(run);
    }
    check_square_underflow(&system.omega(&start.momentum), &duration)?;
    let mut slope = system.rate(start);
    // Lengths without a square, which would leave the range before they do.
    let length = |parts: &[f64]| parts.iter().fold(0.0, |sum: f64, x| sum.max(x.abs()));
    let lengths =
        |motion: &State<f64>| [length(motion.attitude.coords.as_slice()), length(motion.momentum.as_slice())];
    let over = |x: f64, y: f64| if x == 0.0 { 0.0 } else { x / y };
    // A body that starts at rest has no momentum to measure by; what a torque gives it in the step will do.
    let relative = |part: &State<f64>, whole: [f64; 2], gained: f64| {
        let [turn, momentum] = lengths(part);
        over(turn, whole[0]).max(over(momentum, whole[1] + gained))
    };
    // How fast it turns, and how fast a torque would have it turn. Should the guess be too long, its error will say so.
    let turning = length(slope.attitude.coords.as_slice());
    let [unit, _] = lengths(start);
    let torque = length(system.torque(start).as_slice());
    let pace = (2.0 * over(turning, unit)).max((torque * system.inverse().max()).sqrt());
    let guess = fifth_root(tolerance) / pace;
    let mut h = if guess < duration.abs() { guess.copysign(duration) } else { duration };
    let mut time = 0.0;
    while time != duration {
        if *left == 0 {
            return Err(Error::TooMany { what: "steps", count: run.steps + run.rejected });
        }
        *left -= 1;
        let last = (duration - time).abs() <= h.abs();
        let h_now = if last { duration - time } else { h };
        if !last && time + h_now == time {
            return Err(Error::NotConverged {
                what: "the step whose error meets the tolerance",
                iterations: run.steps + run.rejected,
                residual: h_now,
            });
        }
        let (end, mut slopes) = stages(system, &run.end, slope, &h_now);
        let end_slope = system.rate(&end);
        slopes.push(end_slope);
        let nothing = State { attitude: run.end.attitude * 0.0, momentum: run.end.momentum * 0.0 };
        let gained = length(slope.momentum.as_slice()) * h_now.abs();
        let off = combined(&nothing, &slopes, &ERROR, &h_now);
        let error = relative(&off, lengths(&run.end), gained) / tolerance;
        if !error.is_finite() {
            return Err(Error::OutOfRange { what: "the error of a step", value: error });
        }
        // As usual: aim a little below the tolerance, and change the step by no more than tenfold.
        let factor = (0.9 / fifth_root(error)).clamp(0.1, 10.0);
        if error <= 1.0 {
            (run.end, slope) = (end, end_slope);
            run.steps += 1;
            time = if last { duration } else { time + h_now };
        } else {
            run.rejected += 1;
        }
        h = h_now * factor;
    }
    Ok(run)
}
