//! What the page draws: the parts of a body, as the library has them.

use crate::bodies::{BALL, Chosen, OWN_MASS};
use exchange::Numbers;
use tumbling::body::named::{Part, Section};

/// How many numbers describe a part.
pub(crate) const SIZE: usize = 8;

/// The parts of a body, of [`SIZE`] numbers each; m and kg. A bar: 0, its ends' x, z, x, z, its width in the
/// xz plane and its thickness along y, its mass. A tube along x: 1, its ends' x, its inner and its outer
/// radius, twice 0, its mass. A ball about the origin: 2, its radius, five times 0, its mass. A round bar: 3,
/// its ends' x, z, x, z, its radius, 0, its mass.
///
/// There is no answer where there is no such body.
pub(crate) fn answer(which: f64, own: [f64; 3], row: &Numbers) -> usize {
    let mut place = 0;
    let mut put = |numbers: [f64; SIZE]| {
        for number in numbers {
            row.set(place, number);
            place += 1;
        }
    };
    match Chosen::new(which, own) {
        Some(Ok(Chosen::Named(body))) => body.each_part(&mut |part| put(numbers(&part))),
        Some(Ok(Chosen::Ball)) => put([2.0, BALL, 0.0, 0.0, 0.0, 0.0, 0.0, OWN_MASS]),
        Some(Ok(Chosen::Box { edges: [wide, thick, long], .. })) => {
            put([0.0, 0.0, -0.5 * long, 0.0, 0.5 * long, wide, thick, OWN_MASS]);
        }
        _ => {}
    }
    place
}

fn numbers(part: &Part) -> [f64; SIZE] {
    let (from, to) = (part.middle - 0.5 * part.along, part.middle + 0.5 * part.along);
    let mass = part.mass;
    match part.section {
        Section::Ring { inner, outer } => [1.0, from.x, to.x, inner, outer, 0.0, 0.0, mass],
        Section::Round { radius } => [3.0, from.x, from.z, to.x, to.z, radius, 0.0, mass],
        Section::Rectangle { wide, thick } => [0.0, from.x, from.z, to.x, to.z, wide, thick, mass],
        Section::Line => {
            // A racket's frame is drawn as thick as it is, a string as a line.
            let thick = match part.name {
                "hoop" => 0.016,
                "throat bar" => 0.014,
                _ => 0.0,
            };
            [0.0, from.x, from.z, to.x, to.z, thick, thick, mass]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bodies::BODIES;
    use nalgebra::{Rotation3, UnitQuaternion, Vector3};
    use tumbling::solid::{Compound, Cuboid, Cylinder, MassProperties, Solid, ThinRod};

    /// A body put together from its parts; bars that lean, and strings, as thin rods if so asked.
    fn made(which: usize, thin: bool) -> MassProperties {
        let row = Numbers::empty();
        let count = answer(which as f64, [0.0; 3], &row);
        assert!(count > 0 && count.is_multiple_of(SIZE) && count <= exchange::ROOM);
        let mut body = Compound::new();
        for part in 0..count / SIZE {
            let [kind, a, b, c, d, wide, thick, mass] = row.take(SIZE * part);
            let turned = |direction: Vector3<f64>| {
                let (y, z) = (Vector3::y(), direction.normalize());
                UnitQuaternion::from_rotation_matrix(&Rotation3::from_basis_unchecked(&[y.cross(&z), y, z]))
            };
            if kind == 1.0 {
                let tube = Cylinder::hollow(c, d, b - a).unwrap().with_mass(mass).unwrap();
                let along_x = tube.turned(turned(Vector3::x())).unwrap();
                body = body.at(along_x, &Vector3::new(0.5 * (a + b), 0.0, 0.0));
                continue;
            }
            let (from, to) = (Vector3::new(a, 0.0, b), Vector3::new(c, 0.0, d));
            let long = (to - from).norm();
            let solid = if kind == 3.0 {
                Cylinder::new(wide, long).unwrap().with_mass(mass)
            } else if wide == 0.0 || (thin && a != c) {
                ThinRod::new(long).unwrap().with_mass(mass)
            } else {
                Cuboid::new(wide, thick, long).unwrap().with_mass(mass)
            };
            let leaning = solid.unwrap().turned(turned(to - from)).unwrap();
            body = body.at(leaning, &(0.5 * (from + to)));
        }
        body.properties().unwrap()
    }

    #[test]
    fn the_drawn_parts_make_the_bodies_of_the_book() {
        for (which, theirs) in BODIES.into_iter().enumerate() {
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
        let row = Numbers::empty();
        for odd in [10.0, 1e300, f64::INFINITY] {
            assert_eq!(answer(odd, [1.0; 3], &row), 0, "{odd}");
        }
        assert_eq!(answer(8.0, [1.0, 0.0, 2.0], &row), 0);
        assert_eq!(answer(9.0, [1.0, 2.0, 3.5], &row), 0);
    }

    #[test]
    fn a_box_of_the_readers_own_is_drawn_with_the_moments_that_it_has() {
        let row = Numbers::empty();
        assert_eq!(answer(8.0, [3.0, 1.0, 2.0], &row), SIZE);
        assert_eq!(row.take(0), [0.0, 0.0, -1.5, 0.0, 1.5, 2.0, 1.0, 1.0]);
        assert_eq!(answer(9.0, [5.0 / 12.0, 13.0 / 12.0, 10.0 / 12.0], &row), SIZE);
        let [.., long, wide, thick, _] = row.take::<SIZE>(0);
        for (drawn, right) in [(wide, 2.0), (thick, 1.0), (2.0 * long, 3.0)] {
            assert!((drawn - right).abs() < 1e-14, "{drawn}, not {right}");
        }
    }
}
