//! Your box: three sides, a mass and a spin, and what follows from them.

use exchange::{Numbers, Text};
use nalgebra::Vector3;
use tumbling::exact::{FreeMotion, Regime};
use tumbling::solid::{Cuboid, Solid};
use tumbling::{Axis, Error};

/// Why there is no answer, in the library's own words but for its numbers: to print them would weigh as much as all the rest.
pub static WHY: Text = Text::new();

/// Of the row it takes: the edges along x, y and z, m; the mass, kg; and the spin along them, rad/s.
///
/// It answers with the moments about x, y and z, kg m²; the momentum along them, kg m²/s; the gap, degrees; and what
/// becomes of the spin, left alone, as [`fate`] numbers it.
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
    let moments = inertia.matrix().diagonal();
    let momentum = inertia.momentum(&omega);
    if let Some(&value) = momentum.iter().find(|x| !x.is_finite()) {
        return Err(Error::OutOfRange { what: "the momentum", value });
    }
    let motion = FreeMotion::new(&moments, &omega)?;
    let [x, y, z] = moments.into();
    let fate = f64::from(fate([x, y, z], &omega, &motion.regime()));
    Ok([x, y, z, momentum.x, momentum.y, momentum.z, gap.to_degrees(), fate])
}

/// What becomes of a spin that is left alone. With 0, 1 or 2 for x, y or z: it circles that axis for ever. 3: it runs along the
/// separatrix. 4: two moments are equal, and it circles the third axis evenly. 5: all three are equal. 6: two are, and it
/// stays. 7 and the axis: it stays on an axis of the smallest or the largest moment. 10 and the axis: it stands on that of the middle one.
fn fate(moments: [f64; 3], omega: &Vector3<f64>, regime: &Regime) -> u8 {
    let [x, y, z] = moments;
    let [least, most] = [x.min(y).min(z), x.max(y).max(z)];
    let middle = x.max(y).min(x.min(y).max(z));
    let axis_of = |wanted: f64| {
        if x == wanted {
            0
        } else if y == wanted {
            1
        } else {
            2
        }
    };
    match regime {
        Regime::Circulating { about: Axis::Smallest, .. } => axis_of(least),
        Regime::Circulating { .. } => axis_of(most),
        Regime::Separatrix { .. } => 3,
        Regime::SymmetricTop { .. } => 4,
        _ if least == most => 5,
        _ if least == middle || middle == most => 6,
        _ => {
            let axis = if omega.x != 0.0 {
                0
            } else if omega.y != 0.0 {
                1
            } else {
                2
            };
            if moments[usize::from(axis)] == middle { 10 + axis } else { 7 + axis }
        }
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
