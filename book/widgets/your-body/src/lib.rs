//! Your body: a solid, or moments and products, and what follows: axes, which spin flips, and when.

use exchange::{Line, Numbers};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use std::f64::consts::TAU;
use tumbling::dynamics::stability::rate_squared;
use tumbling::exact::time_between_flips;
use tumbling::number::Analytic;
use tumbling::solid::{
    Ball, Capsule, Compound, Cone, Cuboid, Cylinder, Ellipsoid, MassProperties, Solid, ThinDisk, ThinPlate,
};
use tumbling::{Error, ErrorKind, Inertia, PrincipalMoments, Subject};

/// The reason why there is no answer, in the library's words but without its numbers.
pub static WHY: Line = Line::empty();

/// The pushes, as parts of the spin: 0.1 down to 1e-9.
const PUSHES: [f64; 9] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// Points of a path.
const POINTS: u32 = 96;

/// What the page asks:
///
/// 0. A body, by its kind: 0 box (edges), 1 ball (radius), 2 cylinder (radius, height), 3 tube (radius of
///    the hole, of the whole, height), 4 capsule (radius, length), 5 cone (radius, height), 6 ellipsoid
///    (semi-axes), 7 plate (edges), 8 disk (radius), each with its mass (kg) and its sizes (m) after it; or
///    9, moments: the mass, or zero where it is not known, then xx, yy, zz, xy, xz, yz (kg m²). The answer:
///    the tensor about the centre in that order; the moments, smallest first; their axes, three components
///    each; which moments are equal, 0 none, 1 all but the smallest, 2 all but the largest, 3 all; how fast a
///    push off the middle axis grows, per radian of spin; how fast one circles the axis of the smallest
///    moment, and of the largest, per radian; the semi-axes of the even ellipsoid of the same mass and
///    moments, m (of one kilogram where the mass is not known); and the time between flips for pushes from
///    0.1 to 1e-9 in turns (NaN: it never flips).
/// 1. Of moments, smallest first, the closed path round axis 0 or 2, on its positive or negative side, at
///    this share of the way to the separatrix: spins of equal energy, in parts of the longest.
/// 2. The gap, degrees, of spins between two axes (by their places) of a body with these moments: how many,
///    and for each the tangent of half its angle from the first.
/// 3. A tensor (xx, yy, zz, xy, xz, yz) turned by roll, pitch and yaw, rad, as a link of a robot has it.
/// 4. A box: its edges along x, y and z, m; its mass, kg; and its spin along them, rad/s. The answer: the
///    moments about x, y and z; the momentum along them, kg m²/s; and the gap between the two, degrees.
/// 5. A body of parts: how many, and for each its kind, mass, six numbers that its kind takes as above, with
///    zeros behind them, and the place of its origin, m. The answer is that of 0, about the common centre.
pub fn answer(what: u32, row: &Numbers) -> usize {
    let found = match what {
        0 => one(row).and_then(|whole| body(&whole)).map(|found| row.fill(&found)),
        5 => parts(row).and_then(|whole| body(&whole)).map(|found| row.fill(&found)),
        1 => Ok(path(row)),
        2 => gaps(row),
        4 => return the_box(row),
        _ => link(row).map(|found| row.fill(&found)),
    };
    found.unwrap_or_else(|why| {
        WHY.say(&words(&why));
        0
    })
}

const BEYOND: &str = ": its true value is beyond what a finite, nonzero floating-point number holds in full";

fn words(why: &Error) -> [&'static str; 2] {
    let rule = match why.kind() {
        ErrorKind::NotFinite => ": it must be a finite number",
        ErrorKind::OutOfBounds if why.subject() == Subject::PrincipalMoment => {
            ": it is too small for the others, zero or below"
        }
        ErrorKind::OutOfBounds => ": it must be above zero",
        ErrorKind::Unrepresentable => BEYOND,
        ErrorKind::Undefined => " is the zero vector: it has no direction",
        ErrorKind::Impossible => {
            ": no body has this tensor; of the principal moments two add up to at least the third"
        }
        _ => ": there is no such body",
    };
    [why.subject().words(), rule]
}

fn part(row: &Numbers, from: usize) -> Result<MassProperties, Error> {
    let [kind, mass, a, b, c] = row.take(from);
    let of = |solid: &dyn Solid| solid.with_mass(mass);
    match kind as u32 {
        0 => of(&Cuboid::new(a, b, c)?),
        1 => of(&Ball::new(a)?),
        2 => of(&Cylinder::new(a, b)?),
        3 => of(&Cylinder::hollow(a, b, c)?),
        4 => of(&Capsule::new(a, b)?),
        5 => of(&Cone::new(a, b)?),
        6 => of(&Ellipsoid::new(a, b, c)?),
        7 => of(&ThinPlate::new(a, b)?),
        8 => of(&ThinDisk::new(a)?),
        _ => {
            let inertia = Inertia::new(row.take(from + 2), row.take(from + 5))?;
            MassProperties::new(mass, &Vector3::zeros(), inertia)
        }
    }
}

/// Of moments alone the mass may be unknown.
fn one(row: &Numbers) -> Result<MassProperties, Error> {
    let [kind, mass] = row.take(0);
    if kind as u32 > 8 && (mass.is_nan() || mass <= 0.0) {
        row.set(1, 1.0);
    }
    part(row, 0)
}

fn parts(row: &Numbers) -> Result<MassProperties, Error> {
    let mut whole = Compound::new();
    for k in 0..row.get(0) as usize {
        let from = 1 + 11 * k; // past the end of the row all is NaN, and refused
        whole = whole.at(part(row, from)?, &Vector3::from(row.take(from + 8)));
    }
    whole.properties()
}

/// Which moments are equal, to 1e-12 of the largest; those are then made equal.
fn equal(m: &mut Vector3<f64>) -> f64 {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * m.z;
    match (near(m.x, m.y), near(m.y, m.z)) {
        (true, true) => {
            m.fill(m.y);
            3.0
        }
        (false, true) => {
            m.z = m.y;
            1.0
        }
        (true, false) => {
            m.x = m.y;
            2.0
        }
        _ => 0.0,
    }
}

/// The square root, and zero for a number below zero by rounding. (Machines differ in the sign of the zero
/// that `max` returns.)
fn root(x: f64) -> f64 {
    if x > 0.0 { x.sqrt() } else { 0.0 }
}

fn body(whole: &MassProperties) -> Result<[f64; 34], Error> {
    let (mass, inertia) = (whole.mass(), whole.inertia());
    let principal = inertia.principal();
    let mut m = principal.moments();
    let kind = equal(&mut m);
    let moments: PrincipalMoments = m.try_into()?;
    let growth = root(rate_squared(&1.0, &m.y, &m.x, &m.z));
    let circles = |about: f64, first: f64, second: f64| root(-rate_squared(&1.0, &about, &first, &second));
    let half = 0.5 * m.sum();
    let semiaxes = m.map(|moment| root(5.0 * (half - moment) / mass));
    let t = inertia.matrix();
    let mut found = [0.0; 34];
    let parts = [t.m11, t.m22, t.m33, t.m12, t.m13, t.m23, m.x, m.y, m.z];
    let rates =
        [kind, growth, circles(m.x, m.y, m.z), circles(m.z, m.x, m.y), semiaxes.x, semiaxes.y, semiaxes.z];
    let frame = principal.frame();
    let known = parts.iter().chain(frame.iter()).chain(&rates);
    for (place, &number) in found.iter_mut().zip(known) {
        *place = number;
    }
    for (place, push) in found[25..].iter_mut().zip(PUSHES) {
        let time =
            if kind == 0.0 { time_between_flips(moments, &Vector3::new(0.0, 1.0, push))? } else { None };
        *place = time.map_or(f64::NAN, |time| time / TAU);
    }
    Ok(found)
}

/// The cosine and sine of an angle by the tangent of its half.
fn circle(half: f64) -> (f64, f64) {
    let squared = half * half;
    ((1.0 - squared) / (1.0 + squared), 2.0 * half / (1.0 + squared))
}

/// With `u` the spin over the half axes of the ellipsoid, `|u| = 1` and `I1 u1² + I2 u2² + I3 u3² = c`:
/// across the axis an ellipse.
fn path(row: &Numbers) -> usize {
    let moments: [f64; 3] = row.take(0);
    let [axis, sign, share] = row.take(3);
    let axis = if axis == 0.0 { 0 } else { 2 };
    let across = |k: usize| moments.get(k).map_or(0.0, |moment| (moment - moments[axis]).abs());
    let (near, far) = (across(1), across(2 - axis));
    // Of a round body all paths are circles, up to the great one.
    let size = share * if near == far || near == 0.0 { far } else { near }.sqrt();
    for k in 0..=POINTS {
        // Four quarters of a circle, each by the tangents of half its angles.
        let (quarter, part) = (k / (POINTS / 4), k % (POINTS / 4));
        let (c, s) = circle(f64::from(part) / f64::from(POINTS / 4));
        let (c, s) = match quarter % 4 {
            0 => (c, s),
            1 => (-s, c),
            2 => (-c, -s),
            _ => (s, -c),
        };
        let mut u = [0.0; 3];
        u[2 - axis] = if far > 0.0 { size / far.sqrt() * c } else { 0.0 };
        u[1] = if near > 0.0 { size / near.sqrt() * s } else { 0.0 };
        u[axis] = sign * root(1.0 - u[1] * u[1] - u[2 - axis] * u[2 - axis]);
        for (i, part) in u.into_iter().enumerate() {
            let reach = (moments[0] / moments[i]).sqrt();
            row.set(3 * k as usize + i, part * reach);
        }
    }
    3 * (POINTS as usize + 1)
}

fn gaps(row: &Numbers) -> Result<usize, Error> {
    let [a, b, c, easy, hard, count] = row.take(0);
    let inertia = Inertia::from_moments(a, b, c)?;
    let count = count.clamp(0.0, 512.0) as usize;
    for k in 0..count {
        let (c, s) = circle(row.get(6 + k));
        let mut omega = Vector3::zeros();
        omega[easy.clamp(0.0, 2.0) as usize] = c;
        omega[hard.clamp(0.0, 2.0) as usize] += s;
        row.set(k, inertia.angle_to_momentum(&omega)?.to_degrees());
    }
    Ok(count)
}

fn the_box(row: &Numbers) -> usize {
    let omega = Vector3::from(row.take(4));
    let why = match boxed(row.take(0), &omega) {
        Ok((inertia, gap)) => {
            let ([x, y, z], l) = (inertia.matrix().diagonal().into(), inertia.momentum(&omega));
            if l.iter().all(|x| x.is_finite()) {
                return row.fill(&[x, y, z, l.x, l.y, l.z, gap.to_degrees()]);
            }
            ["the momentum", BEYOND]
        }
        Err(why) => words(&why),
    };
    WHY.say(&why);
    0
}

fn boxed([a, b, c, mass]: [f64; 4], omega: &Vector3<f64>) -> Result<(Inertia, f64), Error> {
    let inertia = Cuboid::new(a, b, c)?.with_mass(mass)?.inertia();
    Ok((inertia, inertia.angle_to_momentum(omega)?))
}

fn link(row: &Numbers) -> Result<[f64; 6], Error> {
    let inertia = Inertia::new(row.take(0), row.take(3))?;
    let angles: [f64; 3] = row.take(6);
    let [[cr, sr], [cp, sp], [cy, sy]] = angles.map(|angle| {
        let (s, c) = Analytic::sin_cos(&(0.5 * angle));
        [c, s]
    });
    let turn = Quaternion::new(
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    );
    let t: Matrix3<f64> = inertia.turned(UnitQuaternion::new_unchecked(turn))?.matrix();
    Ok([t.m11, t.m22, t.m33, t.m12, t.m13, t.m23])
}

exchange::page!(answer, WHY);

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(what: u32, question: &[f64]) -> Vec<f64> {
        let row = Numbers::empty();
        row.fill(question);
        let count = answer(what, &row);
        (0..count).map(|i| row.get(i)).collect()
    }

    #[test]
    fn the_box_of_the_book_flips_as_the_book_says() {
        let found = asked(0, &[0.0, 1.0, 2.0, 1.0, 3.0]);
        let twelfths: Vec<f64> = found[6..9].iter().map(|m| (m * 12.0).round()).collect();
        assert_eq!(twelfths, [5.0, 10.0, 13.0]);
        assert!((found[19] - (3.0_f64 * 5.0 / (13.0 * 5.0)).sqrt()).abs() < 1e-15);
        // Each push ten times smaller takes ln(100) / growth longer.
        let step = (found[33] - found[32]) * TAU * found[19];
        assert!((step / 100_f64.ln() - 1.0).abs() < 1e-6, "{step}");
    }

    #[test]
    fn parts_turn_about_their_common_centre() {
        // Balls of 1 kg and 3 kg, 4 m apart along z, far from the origin: 1 * 3² + 3 * 1² across z, and each
        // its own 2/5 m r². A part that is given by moments has a mass too.
        let ball = |mass: f64, z: f64| [1.0, mass, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 7.0, -2.0, z];
        let found = asked(5, &[&[2.0][..], &ball(1.0, 10.0), &ball(3.0, 14.0)].concat());
        let right = [12.4, 12.4, 0.4, 0.0, 0.0, 0.0, 0.4, 12.4, 12.4];
        assert!(found[..9].iter().zip(right).all(|(x, y)| (x - y).abs() < 1e-14), "{found:?}");
        let moments = [9.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        for (count, says) in [(0.0, "parts"), (1.0, "the mass: it must be above zero"), (1e9, "mass")] {
            assert!(asked(5, &[&[count][..], &moments].concat()).is_empty());
            assert!(WHY.said().contains(says), "{}", WHY.said());
        }
    }

    #[test]
    fn a_path_keeps_energy_and_momentum_and_the_last_one_passes_the_middle_axis() {
        let m = [1.0, 2.0, 3.5];
        for (axis, sign, share) in [(0.0, 1.0, 0.5), (2.0, -1.0, 0.7), (0.0, 1.0, 1.0)] {
            let path = asked(1, &[m[0], m[1], m[2], axis, sign, share]);
            let of = |w: &[f64], power: i32| (0..3).map(|i| m[i].powi(power) * w[i] * w[i]).sum::<f64>();
            let first: Vec<f64> = [1, 2].map(|power| of(&path[..3], power)).into();
            for w in path.chunks(3) {
                assert!((of(w, 1) - first[0]).abs() < 1e-12 && (of(w, 2) - first[1]).abs() < 1e-12);
            }
            // A closed curve without gaps.
            let far = |a: &[f64], b: &[f64]| (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max);
            assert!(path.chunks(3).zip(path.chunks(3).skip(1)).all(|(a, b)| far(a, b) < 0.1));
            assert!(far(&path[..3], &path[path.len() - 3..]) < 1e-15);
            let most = path.chunks(3).map(|w| w[1]).fold(0.0, f64::max);
            assert!((most - share * (m[0] / m[1]).sqrt()).abs() < 1e-12 || axis == 2.0, "{most}");
        }
    }

    #[test]
    fn a_quarter_turn_of_a_link_exchanges_two_moments() {
        let turned = asked(3, &[1.0, 2.0, 2.5, 0.1, 0.0, 0.0, 0.0, 0.0, TAU / 4.0]);
        let right = [2.0, 1.0, 2.5, -0.1, 0.0, 0.0];
        assert!(turned.iter().zip(right).all(|(x, y)| (x - y).abs() < 1e-15), "{turned:?}");
    }

    #[test]
    fn what_no_body_can_be_is_refused_in_words() {
        for question in
            [[0.0, 1.0, -2.0, 1.0, 3.0], [1.0, 1.0, f64::NAN, 0.0, 0.0], [3.0, 1.0, 2.0, 1.0, 1.0]]
        {
            assert!(asked(0, &question).is_empty());
            assert!(WHY.said().contains(": "), "{}", WHY.said());
        }
        assert!(asked(0, &[9.0, 0.0, 1.0, 2.0, 4.0, 0.0, 0.0, 0.0]).is_empty());
        assert!(WHY.said().contains("no body"), "{}", WHY.said());
    }

    #[test]
    fn what_is_wrong_with_a_box_is_told_in_the_words_of_the_library() {
        let edges = [1e-200, 1e-9, 0.02, 1.0, 17.3, 1e100, 1e200, 0.0, -1.0, f64::NAN];
        let mut named = 0;
        for a in edges {
            for b in edges {
                for mass in [0.0, 1e-320, 1.0, f64::INFINITY] {
                    for spin in [[1.0, 1.0, 0.0], [0.0; 3], [1e-160, 3e160, 0.1], [f64::NAN, 0.0, 1.0]] {
                        let Err(why) = boxed([a, b, 1.0, mass], &spin.into()) else { continue };
                        let ([what, rule], whole) = (words(&why), why.to_string());
                        assert!(whole.starts_with(what) && whole.ends_with(rule), "{whole}: {what}{rule}");
                        named += 1;
                    }
                }
            }
        }
        assert!(named > 500);
    }
}
