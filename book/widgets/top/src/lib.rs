//! The top: a drum on a light pin under its weight, by the closed form at any instant, and step by step.

use exchange::{Line, Numbers};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::attitude::turn;
use tumbling::exact::{LagrangeTop, TopRegime};
use tumbling::step::{State, System, Torque, rk4};
use tumbling::{Error, PrincipalMoments};

/// Why there is no answer.
pub static WHY: Line = Line::empty();

/// The chapter's top: the moments about its point, across its axis and along it, kg m².
const ACROSS: f64 = 2e-4;
const ALONG: f64 = 5e-5;
/// The distance from the point to the centre of mass, m; the weight, N; and the gravitational acceleration,
/// m/s².
const ARM: f64 = 0.04;
const WEIGHT: f64 = 1.0;
const GRAVITY: f64 = 9.81;
/// The time in seconds in which drag reduces the spin to 1/e.
const SLOWED: f64 = 8.0;

/// The most samples in one answer of each kind, and the most steps.
const MOST_INSTANTS: f64 = 1000.0;
const MOST_SAMPLES: f64 = 800.0;
const MOST_STEPS: f64 = 20_000.0;

/// What the page asks. A start is three numbers: the spin about the axis, rad/s; the lean of the axis from
/// the vertical, degrees; and the rate at which the axis goes round the vertical, rad/s, NaN for the slower
/// of the two at which the lean stays.
///
/// 0. What a start leads to: the kind of motion, as [`kind`] counts them; the least and the greatest lean,
///    degrees; the period of the nutation, s (NaN: there is none); the mean rate at which the axis goes
///    round, rad/s; that of the start; the critical spin; and the drum, m: its radius, and how far above
///    the point it begins and ends.
/// 1. A start, from when, s, until when, and a number of instants: the attitude at each (w, x, y, z), by the
///    closed form.
/// 2. A start: its attitude and its momentum along the body's axes.
/// 3. Whether there is drag, 1 or 0; the step, s; how many steps from one sample to the next; how many
///    samples; attitude and momentum. The answer: how many samples there are, fewer if the motion leaves
///    what an `f64` holds; attitude and momentum after them; and of each sample the attitude, of length 1,
///    and the spin about the axis, rad/s.
pub fn answer(what: u32, row: &Numbers) -> usize {
    let found = match what {
        0 => facts(row.take(0), row),
        1 => exact(row.take(0), row.take(3), row),
        2 => start(row.take(0)).map(|(attitude, omega, _)| {
            let [q, l] =
                [attitude.coords, Vector3::new(ACROSS, ACROSS, ALONG).component_mul(&omega).push(0.0)];
            row.fill(&[q.w, q.x, q.y, q.z, l.x, l.y, l.z])
        }),
        _ => stepped(row.take(0), row.take(4), row),
    };
    found.unwrap_or_else(|Why(words)| {
        WHY.say(&words);
        0
    })
}

/// Reports an error.
struct Why([&'static str; 2]);

impl From<Error> for Why {
    fn from(error: Error) -> Self {
        Self([error.subject().words(), " has no answer"])
    }
}

/// The attitude, the spin along the body's axes, and the rate at which the axis goes round.
fn start([spin, lean, round]: [f64; 3]) -> Result<(UnitQuaternion<f64>, Vector3<f64>, f64), Why> {
    let attitude = turn(&Vector3::new(lean.to_radians(), 0.0, 0.0));
    let (half_cos, half_sin) = (attitude.w, attitude.i);
    let round = if round.is_nan() { steady(spin, half_cos * half_cos - half_sin * half_sin)? } else { round };
    let omega = Vector3::new(0.0, round * 2.0 * half_sin * half_cos, spin);
    Ok((UnitQuaternion::new_unchecked(attitude), omega, if omega.y == 0.0 { 0.0 } else { round }))
}

/// The slower rate at which a lean with this cosine is constant.
fn steady(spin: f64, cosine: f64) -> Result<f64, Why> {
    let momentum = ALONG * spin;
    let square = momentum * momentum - 4.0 * ACROSS * cosine * WEIGHT * ARM;
    let sum = momentum + square.sqrt();
    if square >= 0.0 && sum > 0.0 {
        return Ok(2.0 * WEIGHT * ARM / sum);
    }
    Err(Why(["At this lean it spins too slowly", " to go round at a steady rate"]))
}

fn moments() -> Result<PrincipalMoments, Error> {
    PrincipalMoments::new(ACROSS, ACROSS, ALONG)
}

fn top(given: [f64; 3]) -> Result<(LagrangeTop, f64), Why> {
    let (attitude, omega, round) = start(given)?;
    let arm = Vector3::new(0.0, 0.0, ARM);
    Ok((LagrangeTop::new(moments()?, attitude, &omega, &arm, WEIGHT)?, round))
}

/// 0 free, 1 asleep, 2 upright and unstable, 3 hanging, 4 steady, 5 wavy, 6 with cusps, 7 with loops, 8 a
/// pendulum, 9 from upright and back. A nod that no reader could see counts as none.
fn kind(top: &LagrangeTop) -> f64 {
    let [least, greatest] = top.lean();
    match top.regime() {
        TopRegime::Free => 0.0,
        TopRegime::Sleeping { stable: true } => 1.0,
        TopRegime::Sleeping { stable: false } => 2.0,
        TopRegime::Hanging => 3.0,
        TopRegime::Pendulum => 8.0,
        TopRegime::Separatrix => 9.0,
        _ if greatest - least < 1e-7 => 4.0,
        TopRegime::Cusped => 6.0,
        TopRegime::Looping => 7.0,
        _ => 5.0,
    }
}

/// The drum of these moments about the point: its radius, and half its height, m.
fn drum() -> [f64; 2] {
    let mass = WEIGHT / GRAVITY;
    let square = 2.0 * ALONG / mass;
    // About its centre of mass, across: mass (3 r² + h²)/12.
    let height = 12.0 * (ACROSS / mass - ARM * ARM) - 3.0 * square;
    [square.sqrt(), 0.5 * height.sqrt()]
}

fn facts(given: [f64; 3], row: &Numbers) -> Result<usize, Why> {
    let (top, round) = top(given)?;
    let [least, greatest] = top.lean().map(f64::to_degrees);
    let critical = (4.0 * ACROSS * WEIGHT * ARM).sqrt() / ALONG;
    let [radius, half] = drum();
    Ok(row.fill(&[
        kind(&top),
        least,
        greatest,
        top.period()?.unwrap_or(f64::NAN),
        top.precession_rate(),
        round,
        critical,
        radius,
        ARM - half,
        ARM + half,
    ]))
}

fn exact(given: [f64; 3], [from, to, count]: [f64; 3], row: &Numbers) -> Result<usize, Why> {
    let (top, _) = top(given)?;
    let count = count.clamp(1.0, MOST_INSTANTS);
    let each = if count > 1.0 { (to - from) / (count - 1.0) } else { 0.0 };
    for i in 0..count as usize {
        let q = top.attitude(from + i as f64 * each)?;
        for (k, part) in [q.w, q.i, q.j, q.k].into_iter().enumerate() {
            row.set(4 * i + k, part);
        }
    }
    Ok(4 * count as usize)
}

fn stepped([drag, step, each, count]: [f64; 4], state: [f64; 7], row: &Numbers) -> Result<usize, Why> {
    let mut torques = vec![Torque::gravity(&Vector3::new(0.0, 0.0, ARM), WEIGHT)];
    if drag == 1.0 {
        torques.push(Torque::Damping(Vector3::repeat(ALONG / SLOWED)));
    }
    let system = System::of_numbers(moments()?.vector(), torques); // right as they stand: nothing to check
    let [w, x, y, z, l @ ..] = state;
    let mut state = State { attitude: Quaternion::new(w, x, y, z), momentum: Vector3::from(l) };
    let count = count.clamp(1.0, MOST_SAMPLES) as usize;
    let each = each.clamp(1.0, MOST_STEPS / count as f64) as usize;
    const HEAD: usize = 8;
    let mut taken = 0;
    while taken < count {
        for _ in 0..each {
            state = rk4(&state, step, |state| system.rate(state), State::plus);
        }
        let q = state.attitude.coords / state.attitude.norm();
        let spin = system.omega(&state.momentum).z;
        if !(q.sum() + state.momentum.sum()).is_finite() {
            break;
        }
        for (k, part) in [q.w, q.x, q.y, q.z, spin].into_iter().enumerate() {
            row.set(HEAD + 5 * taken + k, part);
        }
        taken += 1;
    }
    let (q, l) = (state.attitude, state.momentum);
    row.fill(&[taken as f64, q.w, q.i, q.j, q.k, l.x, l.y, l.z]);
    Ok(HEAD + 5 * taken)
}

exchange::page!(answer, WHY);

#[cfg(test)]
mod tests {
    use super::*;
    use tumbling::solid::{Cylinder, Solid as _};

    const STEADY: f64 = f64::NAN;

    /// What a start leads to.
    fn told(start: [f64; 3]) -> [f64; 10] {
        let row = Numbers::empty();
        row.fill(&start);
        assert_eq!(answer(0, &row), 10);
        row.take(0)
    }

    #[test]
    fn a_start_makes_its_kind_of_motion() {
        for (start, expected) in [
            ([200.0, 30.0, 0.0], 6.0),
            ([200.0, 30.0, STEADY], 4.0),
            ([200.0, 30.0, 3.0], 5.0),
            ([200.0, 30.0, -6.0], 7.0),
            ([120.0, 0.0, 0.0], 1.0),
            ([110.0, 0.0, 0.0], 2.0),
            ([0.0, 40.0, 3.0], 8.0),
            ([0.0, 100.0, STEADY], 8.0),
        ] {
            assert_eq!(told(start)[0], expected, "{start:?}");
        }
        // 0.04 = 4.3238 (5e-5 x 200 - 2e-4 x 4.3238 cos 30°).
        assert!((told([200.0, 30.0, STEADY])[5] - 4.3238).abs() < 1e-4);
        // The square root of 4 x 2e-4 x 0.04, over 5e-5.
        assert!((told([0.0, 0.0, 0.0])[6] - 113.137).abs() < 1e-3);
    }

    #[test]
    fn without_spin_it_balances_upright() {
        let row = Numbers::empty();
        row.fill(&[0.0, 0.0, 0.0, 1.5, 1.5, 1.0]);
        assert_eq!((answer(1, &row), row.take(0)), (4, [1.0, 0.0, 0.0, 0.0]));
    }

    #[test]
    fn too_slow_for_a_steady_rate_is_said_so() {
        let row = Numbers::empty();
        row.fill(&[100.0, 30.0, STEADY]);
        assert_eq!(answer(0, &row), 0);
        assert!(WHY.said().contains("too slowly"), "{}", WHY.said());
    }

    #[test]
    fn the_drum_that_is_drawn_has_the_moments_that_move() {
        let [radius, half] = drum();
        let drum = Cylinder::new(radius, 2.0 * half).unwrap().with_mass(WEIGHT / GRAVITY).unwrap();
        let tensor = drum.about(&Vector3::new(0.0, 0.0, -ARM)).unwrap();
        let expected = nalgebra::Matrix3::from_diagonal(&Vector3::new(ACROSS, ACROSS, ALONG));
        assert!((tensor.matrix() - expected).amax() < 1e-18, "{}", tensor.matrix());
    }

    /// The stepped attitudes and spins, a sample every `each` steps.
    fn run(start: [f64; 3], drag: f64, step: f64, each: f64, count: f64) -> Vec<[f64; 5]> {
        let row = Numbers::empty();
        row.fill(&start);
        assert_eq!(answer(2, &row), 7);
        let state: [f64; 7] = row.take(0);
        row.fill(&[&[drag, step, each, count][..], &state].concat());
        assert!(answer(3, &row) > 0);
        (0..row.get(0) as usize).map(|i| row.take(8 + 5 * i)).collect()
    }

    #[test]
    fn stepped_finely_it_is_where_the_closed_form_has_it() {
        let start = [170.0, 50.0, -4.0];
        let samples = run(start, 0.0, 2e-4, 20.0, 250.0);
        let row = Numbers::empty();
        row.fill(&[start[0], start[1], start[2], 0.0, 1.0, 251.0]);
        assert_eq!(answer(1, &row), 4 * 251);
        for (i, sample) in samples.iter().enumerate() {
            let exact: [f64; 4] = row.take(4 * (i + 1));
            let same: f64 = exact.iter().zip(sample).map(|(a, b)| a * b).sum();
            assert!(same.abs() > 1.0 - 1e-9, "{i}: {same}");
        }
    }

    #[test]
    fn drag_takes_the_spin_and_wakes_a_sleeping_top() {
        let samples = run([150.0, 1.0, 0.0], 1.0, 1e-3, 20.0, 500.0);
        let lean = |s: &[f64; 5]| (1.0 - 2.0 * (s[1] * s[1] + s[2] * s[2])).acos().to_degrees();
        for (i, sample) in samples.iter().enumerate() {
            let seconds = 0.02 * (i + 1) as f64;
            assert!((sample[4] / (150.0 * (-seconds / SLOWED).exp()) - 1.0).abs() < 1e-6, "{seconds}");
            // The spin is critical after 8 ln(150/113) = 2.3 s.
            assert!(seconds > 2.3 || lean(sample) < 5.0, "{seconds}");
        }
        assert!(samples.iter().map(lean).fold(0.0, f64::max) > 30.0);
    }
}
