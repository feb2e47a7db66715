//! A step at a fixed rate, for games and simulations: accurate at 60 Hz for ordinary bodies and spins.

use super::adaptive::unit_length;
use crate::attitude::product;
use crate::body::State;
use crate::error::{Error, Refusal, Subject};
use crate::number::Analytic;
use crate::step::system::System;
use nalgebra::Quaternion;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The longest turn of one part of a step, radians.
const LONGEST: f64 = 0.5;

/// The most parts of one step.
const MOST_PARTS: f64 = 1000.0;

/// One step of `h` seconds: [Moser and Veselov's](crate::step::Method::MoserVeselov10), divided into enough
/// parts that each turns the body by at most half a radian; with a torque, the free step lies between two
/// half kicks. The turn is that of a bound on every later spin of the same energy and momentum.
///
/// Its equation is solved in closed form, by the addition theorem of Jacobi's functions, as in the
/// [`PositionStage`](crate::step::PositionStage): nothing is iterated. The rates of the flips and of the turn
/// about the momentum are of order 10.
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
/// A step of more than 1000 parts: 500 radians by that bound. A needle whose smallest moment is below 1000
/// roundings of the others (in `f32`, a rod longer than 112 of its diameters): once its momentum is rotated,
/// no digits of the spin about its length remain. A motion beyond the range of `f64`, a body so thin that the
/// squares of its moments are, or an attitude of length zero.
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

/// The free motion in the time of a step.
#[inline]
fn drifted<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Result<State<T>, Error> {
    let corrections = &system.corrections;
    let momentum = corrections.in_units(&start.momentum, h)?;
    let square = corrections.most(&momentum);
    if square <= LONGEST * LONGEST {
        turned(start, &corrections.turn(&momentum))
    } else {
        in_parts(system, start, h, square.sqrt())
    }
}

/// In as many parts as keep the turn of each at or below [`LONGEST`].
// Not inlined: the code of a step in one part is the shorter for it.
#[inline(never)]
fn in_parts<T: Analytic>(system: &System<T>, start: &State<T>, h: &T, turn: f64) -> Result<State<T>, Error> {
    // The bound is a sum of the energy and of the momentum's square: the parts do not change on the way.
    let parts = (turn / LONGEST).ceil();
    Refusal::NotBelow { what: Subject::TurnOfStep, value: turn, limit: MOST_PARTS * LONGEST }
        .when(turn.is_nan() || parts > MOST_PARTS)?;
    let part = h.clone() / T::integer(parts as u32);
    (0..parts as u32).try_fold(start.clone(), |motion, _| {
        let momentum = system.corrections.in_units(&motion.momentum, &part)?;
        turned(&motion, &system.corrections.turn(&momentum))
    })
}

/// The body turned by a quaternion of any length, its momentum kept in the world; brought to length 1.
#[inline(always)]
fn turned<T: Analytic>(start: &State<T>, turn: &Quaternion<T>) -> Result<State<T>, Error> {
    let (q, tangents) = (&start.attitude, turn.coords.xyz());
    let (length, square) = (q.coords.dot(&q.coords), turn.coords.dot(&turn.coords));
    let both = length.clone() * square;
    // The root and the division do not wait for each other.
    let over = T::one() / both.clone();
    let factor = both.sqrt() * over.clone();
    let twice = (length.clone() + length) * over;
    let across = tangents.cross(&start.momentum).map(|x| x * twice.clone());
    let momentum = &start.momentum - across.map(|x| x * turn.coords.w.clone()) + tangents.cross(&across);
    let attitude = Quaternion::from_vector(product(q, turn).coords.map(|x| x * factor.clone()));
    // An attitude is finite where its factor is, and costs no sum of its own.
    let size = momentum.iter().fold(factor.size(), |sum, x| sum + x.size());
    let end = State { attitude, momentum };
    if size.is_finite() { Ok(end) } else { end.checked() }
}
