//! Your box: three sides, a mass and a spin, and what follows from them.

use exchange::{Numbers, Text};
use nalgebra::Vector3;
use tumbling::Error;
use tumbling::solid::{Cuboid, Solid};

/// Why there is no answer, in the library's own words but for its numbers: to print them would weigh as much as all the rest.
pub static WHY: Text = Text::new();

/// Of the row it takes: the edges along x, y and z, m; the mass, kg; and the spin along them, rad/s.
///
/// It answers with the moments about x, y and z, kg m²; the momentum along them, kg m²/s; the gap, degrees; and which
/// axis the spin, left alone, circles for ever: 0, 1 or 2 for x, y or z, 3 where it runs along the separatrix, 4 where two moments are equal.
pub fn answer(_what: u32, row: &Numbers) -> usize {
    match found(row.take(0), row.take(4)) {
        Ok(found) => row.fill(&found),
        Err(why) => {
            WHY.say(words(&why).concat());
            0
        }
    }
}

fn words(why: &Error) -> [&'static str; 2] {
    match *why {
        Error::NotFinite { what, .. } => [what, ": it must be a finite number"],
        Error::NotPositive { what, .. } => [what, ": it must be above zero"],
        Error::OutOfRange { what, .. } => {
            [what, ": its true value is beyond what a finite, nonzero f64 holds in full"]
        }
        Error::ZeroVector { what } => [what, " is the zero vector: it has no direction"],
        Error::Singular { .. } => {
            ["the smallest principal moment is zero beside the largest", ": momentum does not determine spin"]
        }
        _ => ["there is no such body", ""],
    }
}

fn found([a, b, c, mass]: [f64; 4], omega: [f64; 3]) -> Result<[f64; 8], Error> {
    let inertia = Cuboid::new(a, b, c)?.with_mass(mass)?.inertia();
    let omega = Vector3::from(omega);
    let gap = inertia.gap(&omega)?;
    let [x, y, z] = inertia.matrix().diagonal().into();
    let momentum = inertia.momentum(&omega);
    Ok([x, y, z, momentum.x, momentum.y, momentum.z, gap.to_degrees(), circled([x, y, z], &omega, &momentum)])
}

/// Twice the energy times the middle moment is above the square of the momentum where the spin circles the axis of the smallest
/// moment, and below it where it circles that of the largest.
fn circled(moments: [f64; 3], omega: &Vector3<f64>, momentum: &Vector3<f64>) -> f64 {
    let [x, y, z] = moments;
    let [least, most] = [x.min(y).min(z), x.max(y).max(z)];
    let middle = x.max(y).min(x.min(y).max(z));
    if least == middle || middle == most {
        return 4.0;
    }
    let depth = middle * omega.dot(momentum) / momentum.norm_squared();
    let wanted = if depth > 1.0 {
        least
    } else if depth < 1.0 {
        most
    } else {
        return 3.0;
    };
    moments.iter().position(|&moment| moment == wanted).map_or(4.0, |axis| axis as f64)
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
                        let Err(why) = found([a, b, 1.0, mass], spin) else { continue };
                        let ([what, rule], whole) = (words(&why), why.to_string());
                        let known = !matches!(why, Error::Singular { .. });
                        assert!(
                            !known || whole.starts_with(what) && whole.ends_with(rule),
                            "{whole}: {what}{rule}"
                        );
                        told += 1;
                    }
                }
            }
        }
        assert!(told > 500);
    }
}
