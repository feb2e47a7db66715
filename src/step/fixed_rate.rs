//! A step at a fixed rate, for games and simulations: accurate at 60 Hz for ordinary bodies and spins.

use super::adaptive::unit_length;
use super::methods::moser_veselov::Prepared;
use crate::body::State;
use crate::error::{Error, Refusal, Subject};
use crate::inertia::ascending;
use crate::number::Analytic;
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

/// One step of `h` seconds: [Moser and Veselov's](crate::step::Method::MoserVeselov8), divided into enough
/// parts that each turns the body by less than half a radian; with a torque, the free step lies between two
/// half kicks. At 60 Hz a steady spin below 30 rad/s needs only one part.
///
/// Free motion keeps energy, momentum in the world and the attitude's length to rounding, so that a stable
/// spin stays stable; the attitude returned has length 1.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::step::{State, System, fixed_rate};
/// use tumbling::{PrincipalMoments, dynamics::observe};
/// let system = System::free(PrincipalMoments::new(1.0, 2.0, 3.0)?)?;
/// // Ten minutes about the axis of the largest moment, with a nutation: at 60 Hz a naive engine turns it
/// // about the middle one.
/// let mut motion = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.1, 0.2, 30.0) };
/// let start = motion.clone();
/// for _ in 0..36_000 {
///     motion = fixed_rate(&system, &motion, 1.0 / 60.0)?;
/// }
/// let energy = |state: &State<f64>| observe::energy(&system.omega(&state.momentum), &state.momentum);
/// assert!((energy(&motion) / energy(&start) - 1.0).abs() < 1e-12);
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// # Errors
/// A step of more than 1000 parts: 500 radians. A needle whose smallest moment is below 1000 roundings of the
/// others (in `f32`, a rod longer than 112 of its diameters): once its momentum is rotated, no digits of the
/// spin about its length remain. A motion beyond the range of `f64`, a body so thin that the squares of its
/// moments are, or an attitude of length zero.
pub fn fixed_rate<T: Analytic>(system: &System<T>, start: &State<T>, h: T) -> Result<State<T>, Error> {
    let square = start.attitude.coords.dot(&start.attitude.coords).size();
    if !(1e-30..=1e30).contains(&square) {
        return brought_to_length_1(system, start, h);
    }
    if system.is_free() { drifted(system, start, &h) } else { kicked(system, start, &h) }
}

/// From an attitude the square of whose length may leave the range of numbers.
#[cold]
fn brought_to_length_1<T: Analytic>(system: &System<T>, start: &State<T>, h: T) -> Result<State<T>, Error> {
    let mut unit = start.clone().checked()?;
    unit_length(&mut unit.attitude)?;
    fixed_rate(system, &unit, h)
}

// Not inlined: the code of a free body is the shorter for it.
#[inline(never)]
fn kicked<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Result<State<T>, Error> {
    let half = h.clone() / T::integer(2);
    let end = drifted(system, &system.kick(start, half.clone()), h)?;
    system.adjoint_kick(&end, half).checked()
}

/// A spin that the motion never passes, in squares: of the curve that energy and momentum leave, each axis'
/// largest component.
#[inline]
fn fastest<T: Analytic>(system: &System<T>, omega: &Vector3<T>) -> f64 {
    let (moments, omega) = (system.moments().map(|x| x.size()), omega.map(|x| x.size()));
    let order = ascending(&moments);
    let [a, b, c] = order.map(|i| moments[i]);
    let [x, y, z] = order.map(|i| omega[i] * omega[i]);
    // What the square of one component can add to another's at constant energy and momentum, by ratios of
    // moments, which no unit of mass overflows; zero for equal moments.
    let share = |from: f64, [weight, over]: [f64; 2], [apart, span]: [f64; 2]| {
        if from == 0.0 || apart == 0.0 { 0.0 } else { from * (weight / over) * (apart / span) }
    };
    let first = x + share(y, [b, a], [c - b, c - a]);
    let last = z + share(y, [b, c], [b - a, c - a]);
    let middle = y + share(x, [a, b], [c - a, c - b]).min(share(z, [c, b], [c - a, b - a]));
    first + middle + last
}

/// In as many parts as keep the turn of each below [`LONGEST`].
// Not inlined: the code of a step in one part is the shorter for it.
#[inline(never)]
fn in_parts<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Result<State<T>, Error> {
    // Energy and momentum stay, and so does this: the parts do not change on the way.
    let turn = fastest(system, &system.omega(&start.momentum)).sqrt() * h.size();
    let parts = (turn / LONGEST).ceil().max(1.0);
    Refusal::NotBelow { what: Subject::TurnOfStep, value: turn, limit: MOST_PARTS * LONGEST }
        .when(turn.is_nan() || parts > MOST_PARTS)?;
    let part = h.clone() / T::integer(parts as u32);
    let prepared = Prepared::new(system, &start.momentum, &part, ORDER)?;
    (0..parts as u32).try_fold(start.clone(), |motion, _| prepared.step(&motion))
}

/// The free motion in the time of a step.
#[inline]
fn drifted<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Result<State<T>, Error> {
    let inverse = &system.inverse;
    // No more than the energy allows about the smallest moment: cheap, and enough for most.
    let [x, y, z] = [&inverse.x, &inverse.y, &inverse.z].map(Analytic::size);
    let larger = |a: f64, b: f64| if b > a { b } else { a };
    let largest = larger(larger(x, y), z);
    let square = start.momentum.dot(&system.omega(&start.momentum)).size() * largest * h.size() * h.size();
    let mut motion = if square <= LONGEST * LONGEST {
        Prepared::new(system, &start.momentum, h, ORDER)?.step(start)?
    } else {
        in_parts(system, start, h)?
    };
    let square = motion.attitude.coords.dot(&motion.attitude.coords);
    let off = square.clone() - T::one();
    // A step of one part leaves it next to 1, where the next term of the series is below rounding.
    let near = off.size() < 0.5 * T::rounding().sqrt();
    let inverse = if near { T::one() - off / T::integer(2) } else { T::one() / square.sqrt() };
    motion.attitude.coords.apply(|x| *x *= inverse.clone());
    // An attitude is finite where its square is, and costs no sum of its own.
    let size = motion.momentum.iter().fold(square.size(), |sum, x| sum + x.size());
    if size.is_finite() { Ok(motion) } else { motion.checked() }
}
