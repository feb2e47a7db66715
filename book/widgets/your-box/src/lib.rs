//! Your box: three sides, a mass and a spin, and what follows from them.

use exchange::{Line, Numbers};
use nalgebra::Vector3;
use tumbling::solid::{Cuboid, Solid};
use tumbling::{Error, ErrorKind, Inertia};

/// Why there is no answer, in the library's own words but for its numbers: to print them would weigh as much
/// as all the rest.
pub static WHY: Line = Line::new();

/// Of the row it takes: the edges along x, y and z, m; the mass, kg; and the spin along them, rad/s.
///
/// It answers with the moments about x, y and z, kg m²; the momentum along them, kg m²/s; the gap, degrees;
/// and what becomes of the spin, left alone, as [`fate`] numbers it.
pub fn answer(_what: u32, row: &Numbers) -> usize {
    let omega = Vector3::from(row.take(4));
    let momentum_and_gap =
        found(row.take(0), &omega).map_err(|why| words(&why)).and_then(|(inertia, gap)| {
            let momentum = inertia.momentum(&omega);
            let finite = momentum.iter().all(|x| x.is_finite());
            if finite { Ok((inertia, momentum, gap)) } else { Err(["the momentum", BEYOND]) }
        });
    match momentum_and_gap {
        Ok((inertia, momentum, gap)) => {
            let [x, y, z] = inertia.matrix().diagonal().into();
            let fate = f64::from(fate([x, y, z], omega.into()));
            row.fill(&[x, y, z, momentum.x, momentum.y, momentum.z, gap.to_degrees(), fate])
        }
        Err(why) => {
            WHY.say(&why);
            0
        }
    }
}

const BEYOND: &str = ": its true value is beyond what a finite, nonzero f64 holds in full";

fn words(why: &Error) -> [&'static str; 2] {
    let rule = match why.kind() {
        ErrorKind::NotFinite => ": it must be a finite number",
        ErrorKind::OutOfBounds => ": it must be above zero",
        ErrorKind::Unrepresentable => BEYOND,
        ErrorKind::Undefined => " is the zero vector: it has no direction",
        _ => ": there is no such body",
    };
    [why.subject(), rule]
}

fn found([a, b, c, mass]: [f64; 4], omega: &Vector3<f64>) -> Result<(Inertia, f64), Error> {
    let inertia = Cuboid::new(a, b, c)?.with_mass(mass)?.inertia();
    Ok((inertia, inertia.angle_to_momentum(omega)?))
}

/// What becomes of a spin that is left alone. With 0, 1 or 2 for x, y or z: it circles that axis for ever. 3:
/// it runs along the separatrix. 4: two moments are equal, and it circles the third axis evenly. 5: all three
/// are equal. 6: two are, and it stays. 7 and the axis: it stays on an axis of the smallest or the largest
/// moment. 10 and the axis: it stands on that of the middle one.
///
/// The spin circles the axis of the smallest moment where `2 E I2 > L²`, that is where
/// `w1² I1 (I2 - I1) > w3² I3 (I3 - I2)`; with the roots of both sides, all relative to the greatest,
/// nothing leaves the range. The library's own answer needs the whole motion prepared, which would triple
/// this module; a test holds the two to each other.
fn fate(moments: [f64; 3], omega: [f64; 3]) -> u8 {
    let mut order = [0, 1, 2];
    order.sort_unstable_by(|&a, &b| moments[a].total_cmp(&moments[b]));
    let greatest = moments[order[2]];
    let [least, middle, most] = order.map(|axis| moments[axis] / greatest);
    let steady = omega.iter().filter(|&&w| w != 0.0).count() == 1;
    if least == most {
        return 5;
    }
    if least == middle || middle == most {
        let single = order[if least == middle { 2 } else { 0 }];
        let along = omega[single] != 0.0;
        let across = (0..3).any(|axis| axis != single && omega[axis] != 0.0);
        return if along && across { 4 } else { 6 };
    }
    if steady {
        let axis = (0..3).find(|&axis| omega[axis] != 0.0).unwrap_or(0);
        return if axis == order[1] { 10 } else { 7 } + axis as u8;
    }
    let fastest = omega.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
    let [w1, _, w3] = order.map(|axis| (omega[axis] / fastest).abs());
    let [one, three] = [w1 * (least * (middle - least)).sqrt(), w3 * (most * (most - middle)).sqrt()];
    if one == three {
        3
    } else if one > three {
        order[0] as u8
    } else {
        order[2] as u8
    }
}

exchange::page!(answer, WHY);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_is_told_in_the_words_of_the_library() {
        let edges = [1e-200, 1e-9, 0.02, 1.0, 17.3, 1e100, 1e200, 0.0, -1.0, f64::NAN];
        let mut told = 0;
        for a in edges {
            for b in edges {
                for mass in [0.0, 1e-320, 1.0, f64::INFINITY] {
                    for spin in [[1.0, 1.0, 0.0], [0.0; 3], [1e-160, 3e160, 0.1], [f64::NAN, 0.0, 1.0]] {
                        let Err(why) = found([a, b, 1.0, mass], &spin.into()) else { continue };
                        let ([what, rule], whole) = (words(&why), why.to_string());
                        assert!(whole.starts_with(what) && whole.ends_with(rule), "{whole}: {what}{rule}");
                        told += 1;
                    }
                }
            }
        }
        assert!(told > 500);
    }

    #[test]
    fn what_becomes_of_a_spin_is_what_the_exact_motion_does() {
        use tumbling::Axis;
        use tumbling::exact::{FreeMotion, Regime};
        let mut tried = [0; 13];
        // Three edges and three components of the spin, all ways, as digits of a number.
        for n in 1..64 * 125 {
            let edge = |k: u32| [0.5, 1.0, 2.0, 3.0][(n % 64) / 4_usize.pow(k) % 4];
            let spin = |k: u32| [0.0, 1e-3, 0.4, -1.0, 2.5][n / 64 / 5_usize.pow(k) % 5];
            let omega = Vector3::new(spin(0), spin(1), spin(2));
            if omega == Vector3::zeros() {
                continue;
            }
            let body = Cuboid::new(edge(0), edge(1), edge(2)).unwrap().with_mass(1.0).unwrap();
            let moments = body.inertia().matrix().diagonal();
            let found = fate(moments.into(), omega.into());
            let mut order = [0_u8, 1, 2];
            order.sort_by(|&a, &b| moments[usize::from(a)].total_cmp(&moments[usize::from(b)]));
            let right = match FreeMotion::new(moments.try_into().unwrap(), &omega).unwrap().regime() {
                Regime::Elliptic { about: Axis::Smallest, .. } => order[0]..=order[0],
                Regime::Elliptic { .. } => order[2]..=order[2],
                Regime::Separatrix { .. } => 3..=3,
                Regime::SymmetricTop { .. } => 4..=4,
                _ => 5..=12,
            };
            // On the separatrix but for the rounding of the moments, either answer will do.
            let [one, two, three] = order.map(|axis| moments[usize::from(axis)]);
            let of = |axis: u8, size: f64| omega[usize::from(axis)].abs() * size.sqrt();
            let [up, down] = [of(order[0], one * (two - one)), of(order[2], three * (three - two))];
            let tie = found == 3 && (up - down).abs() < 1e-14 * up;
            assert!(tie || right.contains(&found), "{moments}, {omega}: {found}, not {right:?}");
            tried[usize::from(found)] += 1;
        }
        let all = [0, 1, 2, 4, 5, 6, 7, 8, 9, 10, 11, 12];
        assert!(all.iter().all(|&fate: &usize| tried[fate] > 0), "{tried:?}");
    }
}
