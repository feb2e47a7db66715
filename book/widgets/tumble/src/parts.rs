//! What the page draws: the parts of a body, as the library has them.

use exchange::Numbers;
use tumbling::body::named::{self, NamedBody, Part, Section};

/// How many numbers describe a part.
pub(crate) const SIZE: usize = 8;

/// The bodies of the page, by their places among the library's: the box, the book, the phone, the tennis
/// racket, the wing nut.
const PLACES: [usize; 5] = [0, 1, 2, 5, 6];

pub(crate) fn body(which: f64) -> Option<&'static NamedBody> {
    named::all().get(*PLACES.get(which as usize)?)
}

/// The parts of a body, of [`SIZE`] numbers each; m and kg. A bar: 0, its ends' x, z, x, z, its width in the
/// xz plane and its thickness along y, its mass. A tube along x: 1, its ends' x, its inner and its outer
/// radius, twice 0, its mass.
pub(crate) fn answer(which: f64, row: &Numbers) -> usize {
    let mut place = 0;
    if let Some(body) = body(which) {
        body.each_part(&mut |part| {
            for number in numbers(&part) {
                row.set(place, number);
                place += 1;
            }
        });
    }
    place
}

fn numbers(part: &Part) -> [f64; SIZE] {
    let ([from, to], mass) = (part.ends(), part.mass());
    match part.section {
        Section::Ring { inner, outer } => [1.0, from.x, to.x, inner, outer, 0.0, 0.0, mass],
        _ => {
            let [wide, thick] = part.drawn();
            [0.0, from.x, from.z, to.x, to.z, wide, thick, mass]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Rotation3, UnitQuaternion, Vector3};
    use tumbling::solid::{Compound, Cuboid, MassProperties, Solid, ThinRod, Tube};

    /// A body put together from its parts; bars that lean, and strings, as thin rods if so asked.
    fn made(which: usize, thin: bool) -> MassProperties {
        let row = Numbers::new();
        let count = answer(which as f64, &row);
        assert!(count > 0 && count.is_multiple_of(SIZE) && count <= exchange::ROOM);
        let mut body = Compound::new();
        for part in 0..count / SIZE {
            let [kind, a, b, c, d, wide, thick, mass] = row.take(SIZE * part);
            let turned = |direction: Vector3<f64>| {
                let (y, z) = (Vector3::y(), direction.normalize());
                UnitQuaternion::from_rotation_matrix(&Rotation3::from_basis_unchecked(&[y.cross(&z), y, z]))
            };
            if kind == 1.0 {
                let tube = Tube::new(c, d, b - a).unwrap().with_mass(mass).unwrap();
                body = body.with(tube, Vector3::new(0.5 * (a + b), 0.0, 0.0), turned(Vector3::x()));
                continue;
            }
            let (from, to) = (Vector3::new(a, 0.0, b), Vector3::new(c, 0.0, d));
            let long = (to - from).norm();
            let solid = if wide == 0.0 || (thin && a != c) {
                ThinRod::new(long).unwrap().with_mass(mass)
            } else {
                Cuboid::new(wide, thick, long).unwrap().with_mass(mass)
            };
            body = body.with(solid.unwrap(), 0.5 * (from + to), turned(to - from));
        }
        body.properties().unwrap()
    }

    #[test]
    fn the_drawn_parts_make_the_bodies_of_the_book() {
        let names = ["the box", "the book", "the phone", "the tennis racket", "the wing nut"];
        for (which, name) in names.into_iter().enumerate() {
            let theirs = body(which as f64).unwrap();
            assert_eq!(theirs.name(), name);
            let theirs = theirs.properties().unwrap();
            let tensor = theirs.inertia().matrix();
            let size = tensor.amax();
            let ours = made(which, true);
            assert!((ours.mass() / theirs.mass() - 1.0).abs() < 1e-13, "{which}: {}", ours.mass());
            assert!((ours.centre() - theirs.centre()).amax() < 1e-15, "{which}: {}", ours.centre());
            let off = (ours.inertia().matrix() - tensor).amax();
            assert!(off < 1e-13 * size, "{which}: {off} relative to {size}");
            // As thick as it is drawn the racket's frame is no line: that changes its moments by less than
            // one part in a hundred.
            for (axis, (thick, right)) in
                made(which, false).inertia().matrix().diagonal().iter().zip(&tensor.diagonal()).enumerate()
            {
                assert!((thick / right - 1.0).abs() < 0.01, "{which}, axis {axis}: {thick}, not {right}");
            }
        }
    }

    #[test]
    fn what_is_no_body_has_no_parts() {
        let row = Numbers::new();
        for odd in [5.0, 1e300, f64::INFINITY] {
            assert_eq!(answer(odd, &row), 0, "{odd}");
        }
    }
}
