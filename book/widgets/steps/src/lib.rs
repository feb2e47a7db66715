//! Methods and steps: a method's result for a motion at a given step, and how its errors grow with the step.
//! The exact motion shown with it comes from another module, the tumble's.

use exchange::Numbers;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::sync::{Mutex, PoisonError};
use tumbling::attitude::angle_between;
use tumbling::step::{Method, State, System};
use tumbling::{Error, ErrorKind};

/// The name of a method, or the subject of the library's error.
pub static WORDS: Words = Words(Mutex::new(""));

/// A text that is part of the library and needs no memory of its own.
pub struct Words(Mutex<&'static str>);

impl Words {
    fn say(&self, text: &'static str) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = text;
    }

    /// What was last said.
    #[must_use]
    pub fn said(&self) -> &'static str {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Where the text begins in the module's memory, and how many bytes it is.
    #[must_use]
    pub fn place(&self) -> (usize, usize) {
        (self.said().as_ptr().addr(), self.said().len())
    }
}

/// The most steps in one answer.
const MOST: usize = 4000;

/// What comes before the samples in an answer on a run.
const HEAD: usize = 6;

/// 0, what a method says of itself: which of [`Method::ALL`]. Its name is the text; the answer its order, and
/// whether it is implicit and keeps the energy, the length of the momentum, its direction, the attitude's
/// length and the way back, 1 or 0. There is no answer where there is no such method.
///
/// 1, a run: a body's moments about x, y and z, kg m², the spin along them, rad/s, until when, s, in how many
/// steps, which method, and the attitude that it should end with, real part first. The answer: how many
/// steps were taken; why no more: 0 for no reason, 1 if something was not found, 2 if something left what an
/// `f64` holds, 3 for other reasons, and the text says what; the greatest errors of the energy and of the
/// length of the momentum, in parts of them; the attitude's at the end, degrees; the greatest spin about x;
/// and the spin about x at the start and after each step.
///
/// 2, on from a state: the moments about x, y and z, kg m², the attitude, real part first, the momentum along
/// the body's axes, kg m²/s, which method, the step, s, and how many steps. The answer: how many were taken,
/// the attitude and the momentum then, and the spin along the body's axes, rad/s.
pub fn answer(what: u32, row: &Numbers) -> usize {
    if what == 0 {
        let Some(method) = Method::ALL.get(row.get(0) as usize) else { return 0 };
        let info = method.info();
        WORDS.say(info.name);
        let kept = [info.energy, info.momentum, info.direction, info.unit, info.reversible];
        let yes = |it: bool| f64::from(u8::from(it));
        let at = row.fill(&[f64::from(info.order), yes(info.implicit)]);
        return row.fill_from(at, &kept.map(yes));
    }
    let moments = Vector3::from(row.take::<3>(0));
    let place = if what == 2 { 10 } else { 8 };
    let Some(&method) = Method::ALL.get(row.get(place) as usize) else { return 0 };
    let asked = if what == 2 { go_on } else { run };
    moments.try_into().and_then(System::free).map_or(0, |system| asked(method, &system, row))
}

fn go_on(method: Method, system: &System<f64>, row: &Numbers) -> usize {
    let ([w, i, j, k], [step, count]) = (row.take(3), row.take(11));
    let mut motion = State { attitude: Quaternion::new(w, i, j, k), momentum: row.take(7).into() };
    let mut taken = 0;
    while taken < (count as usize).min(MOST) {
        let Ok(next) = method.step(system, &motion, step) else { break };
        motion = next;
        taken += 1;
    }
    let State { attitude: q, momentum } = motion;
    let at = row.fill(&[taken as f64, q.w, q.i, q.j, q.k]);
    let at = row.fill_from(at, momentum.as_slice());
    row.fill_from(at, system.omega(&momentum).as_slice())
}

fn run(method: Method, system: &System<f64>, row: &Numbers) -> usize {
    let omega = Vector3::from(row.take::<3>(3));
    let [until, count] = row.take(6);
    let [w, i, j, k] = row.take(9);
    let truth = UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k));
    let mut motion = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    let energy = |motion: &State<f64>| motion.momentum.dot(&system.omega(&motion.momentum));
    let (energy_before, length_before) = (energy(&motion), motion.momentum.norm());
    let (mut energy_off, mut length_off, mut greatest) = (0.0_f64, 0.0_f64, omega.x.abs());
    let count = (count as usize).clamp(1, MOST);
    let step = until / count as f64;
    let mut taken = 0;
    let mut why = 0.0;
    row.set(HEAD, omega.x);
    while taken < count {
        match method.step(system, &motion, step) {
            Ok(next) => motion = next,
            Err(error) => {
                why = refused(&error);
                break;
            }
        }
        taken += 1;
        energy_off = energy_off.max((energy(&motion) / energy_before - 1.0).abs());
        length_off = length_off.max((motion.momentum.norm() / length_before - 1.0).abs());
        let spin = system.omega(&motion.momentum).x;
        greatest = greatest.max(spin.abs());
        row.set(HEAD + taken, spin);
    }
    let off = angle_between(&UnitQuaternion::new_normalize(motion.attitude), &truth).to_degrees();
    row.fill(&[taken as f64, why, energy_off, length_off, off, greatest]);
    HEAD + 1 + taken
}

/// Why a step was refused, as a number; its subject, as the text. The library's own sentence contains
/// numbers, and the code to print them is larger than all the methods.
fn refused(error: &Error) -> f64 {
    WORDS.say(error.subject().words());
    match error.kind() {
        ErrorKind::NotConverged => 1.0,
        ErrorKind::Unrepresentable => 2.0,
        _ => 3.0,
    }
}

exchange::page!(answer, WORDS);

#[cfg(test)]
mod tests {
    use super::*;
    use tumbling::exact::FreeMotion;

    /// The box's, kg m².
    const MOMENTS: Vector3<f64> = Vector3::new(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0);

    /// A run of ten seconds of the box, gently spun about all axes.
    fn ran(method: Method, count: f64) -> (usize, Numbers) {
        let place = Method::ALL.iter().position(|&m| m == method).unwrap();
        let truth = FreeMotion::new(MOMENTS.try_into().unwrap(), &Vector3::new(1.0, 1.0, 1.0))
            .unwrap()
            .at(10.0)
            .unwrap()
            .attitude;
        let row = Numbers::empty();
        let start = [MOMENTS.x, MOMENTS.y, MOMENTS.z, 1.0, 1.0, 1.0, 10.0, count, place as f64];
        row.fill(&[&start[..], &[truth.w, truth.i, truth.j, truth.k]].concat());
        let places = answer(1, &row);
        (places, row)
    }

    #[test]
    fn errors_fall_by_the_order_that_the_library_gives() {
        for &method in Method::ALL {
            let order = method.info().order;
            let off = |count: f64| ran(method, count).1.get(4);
            // The shortest steps whose errors are still above rounding.
            let Some(count) =
                [1600.0, 800.0, 400.0, 200.0, 100.0].into_iter().find(|&n| off(2.0 * n) > 1e-10)
            else {
                continue;
            };
            if order > 0 {
                let fall = off(count) / off(2.0 * count);
                assert!((fall.log2() - f64::from(order)).abs() < 0.25, "{method:?} at {count}: {fall}");
            }
        }
    }

    #[test]
    fn what_is_kept_stays_kept() {
        for &method in Method::ALL {
            let (places, row) = ran(method, 100.0);
            assert_eq!(places, HEAD + 101, "{method:?}");
            let keeps = method.info();
            assert_eq!(keeps.energy, row.get(2) < 1e-13, "{method:?}: {}", row.get(2));
            assert_eq!(keeps.momentum, row.get(3) < 1e-13, "{method:?}: {}", row.get(3));
        }
    }

    #[test]
    fn a_step_too_long_is_refused_and_said_so() {
        let (places, row) = ran(Method::MoserVeselov2, 1.0);
        assert_eq!((row.get(0), row.get(1)), (0.0, 1.0));
        assert_eq!(places, HEAD + 1);
        assert!(WORDS.said().contains("Moser-Veselov"), "{}", WORDS.said());
    }
}
