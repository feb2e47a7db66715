//! The tumble: a body spun about one of its axes with a push across it, at any instant, by the exact motion.

mod beside;
mod bodies;
mod cross;
mod parts;
mod path;

use bodies::Chosen;
use exchange::{Line, Numbers};
use nalgebra::Vector3;
use std::sync::{Mutex, PoisonError};
use tumbling::body::named::NamedBody;
use tumbling::exact::{FreeMotion, Regime, time_between_flips};
use tumbling::number::Analytic;
use tumbling::{Axis, Error, ErrorKind, Subject};

/// The reason why there is no answer, in the library's words but without its numbers: the code to print them
/// would be half as large as all the rest.
pub static WHY: Line = Line::empty();

/// The motion last prepared, which later questions are about, and the axis that it was spun about.
static MOTION: Mutex<Option<(FreeMotion, usize, Vector3<f64>)>> = Mutex::new(None);

/// How many of the next flips are given.
const NEXT: usize = 3;
/// Most flips given for a stretch of time, and most samples of it.
const MOST_FLIPS: usize = 64;
const MOST_SAMPLES: f64 = 1000.0;

/// What the page asks:
///
/// 0. Prepare the motion of a body, by its place in [`bodies::BODIES`] and after it, with this spin,
///    rad/s, a push as a share of it, and the axis that it is spun about: 0, the middle one, with the
///    push about that of the largest moment; 1, that of the smallest moment, or 2, of the largest, with
///    the push about the middle one; or 3: the spin is the three numbers of places 7 to 9, rad/s. Places
///    4 to 6 are the edges, m, or the moments, kg m², of a body of the reader's own. The answer: the time
///    between flips, s (NaN: it never flips); the moments; the centre of mass; the momentum, kg m²/s,
///    which is fixed in the world; which axis the spin circles, 0, 1 or 2, or 3 where it stands still;
///    twice the energy into the square of the momentum, kg m²; what a spin is to be multiplied by to lie
///    on the ellipsoid of the polhodes; the spin at the start; and the axis that it is spun about, 0, 1
///    or 2 for x, y or z.
/// 1. The instant `t`: spin along the body's axes, attitude (w, x, y, z), spin in the world, how often it has
///    flipped since time 0, and the next three flips (NaN where there is none).
/// 2. A stretch of time, `from`, `to`, and how many samples: how many flips, their times, and at the samples
///    the spin along the axis that it was spun about.
/// 3. The polhode around axis 0, 1 or 2 of this `L²/2E`, at a number of points: those of that axis' positive
///    side, on the ellipsoid of energy whose longest half axis is 1.
///
/// 4, 5 and 8. For other widgets, of any body: see [`beside::answer`], which counts them 0, 1 and 2.
///
/// 6. The parts of a body, for its drawing: which, and the three numbers of one of the reader's own. See
///    [`parts::answer`].
/// 7. The moments and the centre of mass of a body, asked in the same way. See [`bodies::answer`].
/// 9. The path of the spin of the prepared motion, in the body and in the world. See [`path::path`].
/// 10. The tensor in the world, and how the spin changes, at an instant. See [`path::turned`].
/// 11. The two crossed rods in a turning frame, at an instant. See [`cross::pulls`].
/// 12. Their moments. See [`cross::moments`].
pub fn answer(what: u32, row: &Numbers) -> usize {
    let [which, own @ ..] = row.take::<4>(0);
    let found = match what {
        0 => prepared(row.take(0), row),
        1 => instant(row.get(0)).map(|found| row.fill(&found)),
        2 => stretch(row.take(0), row),
        4 | 5 => return beside::answer(what - 4, row),
        6 => return parts::answer(which, own, row),
        7 => bodies::answer(which, own, row),
        8 => return beside::answer(2, row),
        9 => path::path(row.take(0), row),
        10 => path::turned(which, row),
        11 => cross::pulls(row.take(0), row),
        12 => return row.fill(cross::moments().as_slice()),
        _ => Ok(polhode(row.take(0), row)),
    };
    found.unwrap_or_else(|Why(words)| {
        WHY.say(&words);
        0
    })
}

/// Reports an error, and the rule that was broken.
struct Why([&'static str; 2]);

/// `tests` below compare these words with the library's, except for the triangle rule, which the library
/// prints with numbers.
impl From<Error> for Why {
    fn from(error: Error) -> Self {
        let rule = match error.kind() {
            ErrorKind::NotFinite => ": it must be a finite number",
            ErrorKind::Unrepresentable => {
                ": its true value is beyond what a finite, nonzero floating-point number holds in full"
            }
            ErrorKind::OutOfBounds => match error.subject() {
                Subject::EdgeX | Subject::EdgeY | Subject::EdgeZ | Subject::PrincipalMoment => {
                    ": it must be above zero"
                }
                _ => ": it must be at most the greatest for which the times of two flips differ in f64",
            },
            ErrorKind::Impossible => ": no body has them: two of them must add up to at least the third",
            _ => ": there is no answer to this",
        };
        Self([error.subject().words(), rule])
    }
}

/// Which of x, y, z the spin and the push are along: x has the middle moment, y the largest, z the smallest.
fn spun(about: f64) -> (usize, usize) {
    match about as u32 {
        1 => (2, 0),
        2 => (1, 0),
        _ => (0, 1),
    }
}

fn motion() -> Result<(FreeMotion, usize, Vector3<f64>), Why> {
    MOTION.lock().unwrap_or_else(PoisonError::into_inner).ok_or(Why(["a motion", " must be prepared first"]))
}

/// The moments and the centre of mass of a body; those of the box where there is no such body.
fn body(which: f64, own: [f64; 3]) -> Result<(Vector3<f64>, Vector3<f64>), Why> {
    Ok(Chosen::new(which, own).unwrap_or(Ok(Chosen::Named(NamedBody::TheBox)))?.moments())
}

/// The spin at the start, and which of x, y, z it is about: of one given in full that of its greatest part.
fn start([spin, push, about]: [f64; 3], given: Vector3<f64>) -> (Vector3<f64>, usize) {
    if about == 3.0 {
        return (given, given.iamax());
    }
    let (along, across) = spun(about);
    let mut parts = [0.0; 3];
    (parts[along], parts[across]) = (spin, spin * push);
    (Vector3::from(parts), along)
}

fn prepared([which, spin, push, about, a, b, c, x, y, z]: [f64; 10], row: &Numbers) -> Result<usize, Why> {
    let (moments, centre) = body(which, [a, b, c])?;
    let (omega, along) = start([spin, push, about], Vector3::new(x, y, z));
    let motion = FreeMotion::new(moments.try_into()?, &omega)?;
    let beat = if along == 0 { time_between_flips(moments.try_into()?, &omega)? } else { None };
    *MOTION.lock().unwrap_or_else(PoisonError::into_inner) = Some((motion, along, moments));

    let around = match motion.regime() {
        Regime::Elliptic { about: Axis::Smallest, .. } => 2.0,
        Regime::Elliptic { about: Axis::Largest, .. } => 1.0,
        _ => 3.0,
    };
    // Of a spin of size 1, so that no square is beyond `f64`.
    let size = omega.amax();
    let unit = if size > 0.0 { omega / size } else { omega };
    let energy = moments.dot(&unit.component_mul(&unit)); // twice it
    let depth = moments.component_mul(&unit).norm_squared() / energy;
    let onto = (moments.z / energy).sqrt() / size;
    let momentum = moments.component_mul(&omega);
    let mut at = row.fill(&[beat.unwrap_or(f64::NAN)]);
    for vector in [moments, centre, momentum, Vector3::new(around, depth, onto), omega] {
        at = row.fill_from(at, vector.as_slice());
    }
    Ok(row.fill_from(at, &[along as f64]))
}

fn instant(t: f64) -> Result<[f64; 11 + NEXT], Why> {
    let (motion, along, _) = motion()?;
    let now = motion.at(t)?;
    let world = now.attitude * now.omega;
    // A push along the middle axis never carries a spin about another from its side: what changes sign is its
    // wobble.
    let flips = along == 0;
    let count = if flips { motion.flips(t.min(0.0), t.max(0.0))?.remaining() } else { 0 };
    let mut next = [f64::NAN; NEXT];
    let mut after = t;
    for flip in next.iter_mut().filter(|_| flips) {
        let Some(time) = motion.next_flip(after)? else { break };
        (*flip, after) = (time, time);
    }
    let ([x, y, z], q) = (now.omega.into(), now.attitude);
    let [a, b, c] = next;
    Ok([x, y, z, q.w, q.i, q.j, q.k, world.x, world.y, world.z, count as f64, a, b, c])
}

fn stretch([from, to, samples]: [f64; 3], row: &Numbers) -> Result<usize, Why> {
    let (motion, along, _) = motion()?;
    let mut place = 1;
    if along == 0 {
        for flip in motion.flips(from, to)?.take(MOST_FLIPS) {
            row.set(place, flip);
            place += 1;
        }
    }
    row.set(0, (place - 1) as f64);
    let samples = samples.clamp(2.0, MOST_SAMPLES);
    for i in 0..samples as u32 {
        let part = f64::from(i) / (samples - 1.0);
        row.set(place, motion.at(from + part * (to - from))?.omega[along]);
        place += 1;
    }
    Ok(place)
}

/// In the components of the spin each times the root of its moment, the energy is a sphere and the momentum
/// an elliptic cone about the axis that is circled.
fn polhode([around, depth, points]: [f64; 3], row: &Numbers) -> usize {
    let of_box = || body(0.0, [0.0; 3]).map_or([f64::NAN; 3], |(moments, _)| moments.into());
    let moments: [f64; 3] = motion().map_or_else(|_| of_box(), |(.., moments)| moments.into());
    let axes = match around as u32 {
        0 => [0, 1, 2],
        1 => [1, 2, 0],
        _ => [2, 0, 1],
    };
    let [about, first, second] = axes.map(|axis: usize| moments.get(axis).copied().unwrap_or(f64::NAN));
    // Of two equal moments each spin between their axes stays: the path is a point.
    let amplitude = |moment: f64| {
        if moment == about { 0.0 } else { ((depth - about) / (moment - about)).clamp(0.0, 1.0).sqrt() }
    };
    let (wide, high) = (amplitude(first), amplitude(second));
    let points = points.clamp(2.0, MOST_SAMPLES) as u32;
    for i in 0..points {
        let (sin, cos) = Analytic::sin_cos(&(std::f64::consts::TAU * f64::from(i) / f64::from(points)));
        let (x, y) = (wide * cos, high * sin);
        let along = (1.0 - x * x - y * y).max(0.0).sqrt();
        for ((axis, value), moment) in axes.into_iter().zip([along, x, y]).zip([about, first, second]) {
            row.set(3 * i as usize + axis, value * (moments[2] / moment).sqrt());
        }
    }
    3 * points as usize
}

exchange::page!(answer, WHY);

#[cfg(test)]
mod tests {
    use super::*;

    /// Held by a test that prepares a motion: there is one for all.
    pub(crate) static ALONE: Mutex<()> = Mutex::new(());

    /// By symmetry: at time 0 the spin is at its most along x, so that it is nothing half a beat later and
    /// earlier, and each beat from there.
    #[test]
    fn one_more_flip_is_counted_at_each_half_beat_before_and_after_the_start() {
        let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        let row = Numbers::empty();
        for (which, spin, push) in [(3.0, 10.0, 0.3), (4.0, -7.3, 0.01)] {
            row.fill(&[which, spin, push, 0.0]);
            assert_eq!(answer(0, &row), 17);
            let beat = row.get(0);
            let half = |count: u32| (f64::from(count) + 0.5) * beat;
            for flip in 0..5 {
                for (share, count) in [(-1e-6, flip), (1e-6, flip + 1)] {
                    for way in [1.0, -1.0] {
                        let t = way * (half(flip) + share * beat);
                        row.set(0, t);
                        assert_eq!(answer(1, &row), 14);
                        assert_eq!(row.get(10), f64::from(count), "{which}, at {t}");
                        let side = if count % 2 == 0 { 1.0 } else { -1.0 };
                        assert!(row.get(0) * side * spin > 0.0, "{which}, at {t}: {}", row.get(0));
                        if way > 0.0 {
                            for later in 0..NEXT as u32 {
                                let (given, right) = (row.get(11 + later as usize), half(count + later));
                                let off = (given - right).abs();
                                assert!(off < 1e-9 * beat, "{which}, at {t}: {given}, not {right}");
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_wrong_is_told_in_the_words_of_the_library() {
        let moments = body(0.0, [0.0; 3]).unwrap_or_else(|_| unreachable!()).0;
        let motion = FreeMotion::new(moments.try_into().unwrap(), &Vector3::new(10.0, 0.1, 0.0)).unwrap();
        let wrong = [
            FreeMotion::new(moments.try_into().unwrap(), &Vector3::new(f64::NAN, 0.0, 0.0)).unwrap_err(),
            time_between_flips(moments.try_into().unwrap(), &Vector3::new(1e-320, 1e-322, 0.0)).unwrap_err(),
            motion.at(f64::INFINITY).unwrap_err(),
            motion.next_flip(1e300).unwrap_err(),
            motion.flips(0.0, 1e300).unwrap_err(),
        ];
        for why in wrong {
            let whole = why.to_string();
            let Why([what, rule]) = why.into();
            assert!(whole.starts_with(what) && whole.contains(rule), "{whole}: {what}{rule}");
        }
    }

    #[test]
    fn spun_about_the_smallest_or_the_largest_moment_no_body_ever_turns_over() {
        let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        let row = Numbers::empty();
        for which in 0..7 {
            for (about, along) in [(1.0, 2), (2.0, 1)] {
                for push in [1e-3, 0.4, 1.0] {
                    row.fill(&[f64::from(which), -7.3, push, about]);
                    assert_eq!(answer(0, &row), 17);
                    assert!(row.get(0).is_nan());
                    assert_eq!(row.get(10), along as f64, "it circles the axis that it is spun about");
                    row.fill(&[0.0, 40.0, 500.0]);
                    assert_eq!(answer(2, &row), 501);
                    assert_eq!(row.get(0), 0.0);
                    assert!((0..500).all(|i| row.get(1 + i) < 0.0), "{which}, about {about}, push {push}");
                    row.set(0, 12.3);
                    assert_eq!(answer(1, &row), 14);
                    assert!(row.get(10) == 0.0 && (11..14).all(|i| row.get(i).is_nan()));
                }
            }
        }
    }

    #[test]
    fn the_polhode_passes_through_the_spin_of_every_instant() {
        let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        let row = Numbers::empty();
        let push = 0.3;
        row.fill(&[3.0, 10.0, push, 0.0]);
        assert_eq!(answer(0, &row), 17);
        let [beat, x, y, z] = row.take(0);
        let [around, depth, onto] = row.take(10);
        row.fill(&[around, depth, 1000.0]);
        assert_eq!(answer(3, &row), 3000);
        let points: Vec<Vector3<f64>> = (0..1000).map(|i| row.take(3 * i).into()).collect();
        for point in &points {
            let [a, b, c] = [x * point.x.powi(2), y * point.y.powi(2), z * point.z.powi(2)];
            assert!(((a + b + c) / z - 1.0).abs() < 1e-13, "on the ellipsoid of energy: {point}");
            let momentum = (x * a + y * b + z * c) / (z * depth);
            assert!((momentum - 1.0).abs() < 1e-13, "of the same momentum: {point}");
        }
        for part in 0..50 {
            row.set(0, 0.0437 * f64::from(part) * beat);
            assert_eq!(answer(1, &row), 14);
            let spin = onto * Vector3::from(row.take(0));
            let nearest = points.iter().map(|point| (point - spin).norm()).fold(f64::MAX, f64::min);
            assert!(nearest < 2e-3, "{part}: {nearest}");
        }
    }
}
