//! A step for a game: right at 60 Hz, for ordinary bodies and spins.

use super::methods::moser_veselov::Prepared;
use crate::body::State;
use crate::error::Error;
use crate::inertia::ascending;
use crate::step::system::System;
use nalgebra::Vector3;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The order at which the moments are preprocessed.
const ORDER: u32 = 8;

/// The longest turn of one part of a step, radians.
const LONGEST: f64 = 0.5;

/// The most parts of one step.
const MOST_PARTS: f64 = 1000.0;

/// One step of a game's clock: [Moser and Veselov's](crate::step::Method::MoserVeselov8), in as many parts as keep the turn of each below half a
/// radian; with a torque, all of it between two half kicks. At 60 Hz a steady spin has 30 rad/s before a second part is needed.
///
/// Free motion keeps energy, momentum in the world and the attitude's length to rounding, so that a stable spin stays stable for ever; the
/// attitude comes back with length 1.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::PrincipalMoments;
/// use tumbling::step::{State, System, fixed_rate};
/// let system = System::free(PrincipalMoments::new(1.0, 2.0, 3.0)?)?;
/// // Ten minutes about the axis of the largest moment, with a wobble: at 60 Hz a naive engine turns it about the middle one.
/// let mut motion = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.1, 0.2, 30.0) };
/// let start = motion.clone();
/// for _ in 0..36_000 {
///     motion = fixed_rate(&system, &motion, 1.0 / 60.0)?;
/// }
/// let energy = |motion: &State<f64>| 0.5 * motion.momentum.dot(&system.omega(&motion.momentum));
/// assert!((energy(&motion) / energy(&start) - 1.0).abs() < 1e-12);
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// # Errors
/// A step of more than 1000 parts: 500 radians. A motion that leaves `f64`, a body so thin that squares of its moments do, or an attitude of
/// no length.
pub fn fixed_rate(system: &System<f64>, start: &State<f64>, h: f64) -> Result<State<f64>, Error> {
    if system.is_free() {
        return drifted(system, start, h);
    }
    let end = drifted(system, &system.kick(start, 0.5 * h), h)?;
    system.adjoint_kick(&end, 0.5 * h).checked()
}

/// A spin that the motion never passes, in squares: of the curve that energy and momentum leave, each axis' largest component.
#[inline]
fn fastest(system: &System<f64>, omega: &Vector3<f64>) -> f64 {
    let moments = system.moments();
    let order = ascending(moments);
    let [a, b, c] = order.map(|i| moments[i]);
    let [x, y, z] = order.map(|i| omega[i] * omega[i]);
    // What one component gives up, the other may take; by ratios of moments, which no unit of mass overflows. Of a sphere nothing is given.
    let share = |from: f64, [weight, over]: [f64; 2], [apart, beside]: [f64; 2]| {
        if from == 0.0 || apart == 0.0 { 0.0 } else { from * (weight / over) * (apart / beside) }
    };
    let first = x + share(y, [b, a], [c - b, c - a]);
    let last = z + share(y, [b, c], [b - a, c - a]);
    let middle = y + share(x, [a, b], [c - a, c - b]).min(share(z, [c, b], [c - a, b - a]));
    first + middle + last
}

/// The free motion in the time of a step.
#[inline]
fn drifted(system: &System<f64>, start: &State<f64>, h: f64) -> Result<State<f64>, Error> {
    let inverse = system.inverse();
    // Energy and momentum stay, and so does this: the parts do not change on the way.
    let omega = system.omega(&start.momentum);
    // No more than the energy allows about the smallest moment: cheap, and enough for most.
    let rough = (start.momentum.dot(&omega) * inverse.max()).sqrt() * h.abs();
    let turn = if rough <= LONGEST { rough } else { fastest(system, &omega).sqrt() * h.abs() };
    let parts = if turn <= LONGEST { 1.0 } else { (turn / LONGEST).ceil() };
    if parts.is_nan() || parts > MOST_PARTS {
        return Err(Error::OutOfRange { what: "the turn of a step", value: turn });
    }
    let prepared = Prepared::new(inverse, &start.momentum, &(h / parts), ORDER)?;
    let mut motion = prepared.step(start)?;
    for _ in 1..parts as u32 {
        motion = prepared.step(&motion)?;
    }
    motion.attitude *= 1.0 / motion.attitude.norm();
    motion.checked()
}
