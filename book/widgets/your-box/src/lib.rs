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
/// It answers with the moments about x, y and z, kg m²; the momentum along them, kg m²/s; and the gap,
/// degrees. The tumble's module answers how the spin goes on when nothing acts.
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
            row.fill(&[x, y, z, momentum.x, momentum.y, momentum.z, gap.to_degrees()])
        }
        Err(why) => {
            WHY.say(&why);
            0
        }
    }
}

const BEYOND: &str = ": its true value is beyond what a finite, nonzero floating-point number holds in full";

fn words(why: &Error) -> [&'static str; 2] {
    let rule = match why.kind() {
        ErrorKind::NotFinite => ": it must be a finite number",
        ErrorKind::OutOfBounds => ": it must be above zero",
        ErrorKind::Unrepresentable => BEYOND,
        ErrorKind::Undefined => " is the zero vector: it has no direction",
        _ => ": there is no such body",
    };
    [why.subject().words(), rule]
}

fn found([a, b, c, mass]: [f64; 4], omega: &Vector3<f64>) -> Result<(Inertia, f64), Error> {
    let inertia = Cuboid::new(a, b, c)?.with_mass(mass)?.inertia();
    Ok((inertia, inertia.angle_to_momentum(omega)?))
}

exchange::page!(answer, WHY);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_is_told_in_the_words_of_the_library() {
        let edges = [1e-200, 1e-9, 0.02, 1.0, 17.3, 1e100, 1e200, 0.0, -1.0, f64::NAN];
        let mut named = 0;
        for a in edges {
            for b in edges {
                for mass in [0.0, 1e-320, 1.0, f64::INFINITY] {
                    for spin in [[1.0, 1.0, 0.0], [0.0; 3], [1e-160, 3e160, 0.1], [f64::NAN, 0.0, 1.0]] {
                        let Err(why) = found([a, b, 1.0, mass], &spin.into()) else { continue };
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
