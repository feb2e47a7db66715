//! What the page draws: the parts of which a body consists, as large and as heavy as in the library's `bodies`.

use exchange::Numbers;
use std::f64::consts::{PI, TAU};

/// How many numbers tell of a part.
pub(crate) const SIZE: usize = 8;

/// Edges along x, y and z, m, and mass, kg: the box, the book, the phone.
pub(crate) const CUBOIDS: [([f64; 3], f64); 3] =
    [([2.0, 1.0, 3.0], 1.0), ([0.129, 0.020, 0.198], 0.340), ([0.0716, 0.0078, 0.1476], 0.171)];

/// Density of steel, kg/m³.
const STEEL: f64 = 7850.0;

/// Where the parts of an answer go.
struct Parts<'a>(&'a Numbers, usize);

impl Parts<'_> {
    fn add(&mut self, part: [f64; SIZE]) {
        for number in part {
            self.0.set(self.1, number);
            self.1 += 1;
        }
    }

    /// A bar in the xz plane from one `[x, z]` to another, so wide in that plane, and so thick along y. One
    /// without width is a string.
    fn bar(&mut self, [x, z]: [f64; 2], [to_x, to_z]: [f64; 2], wide: f64, thick: f64, mass: f64) {
        self.add([0.0, x, z, to_x, to_z, wide, thick, mass]);
    }
}

/// The parts of a body, of [`SIZE`] numbers each; m and kg. A bar: 0, its ends' x, z, x, z, its width in
/// the xz plane and its thickness along y, its mass. A tube along x: 1, its ends' x, its inner and its outer radius, twice 0, its mass.
pub(crate) fn answer(which: f64, row: &Numbers) -> usize {
    let mut parts = Parts(row, 0);
    match which as usize {
        3 => racket(&mut parts),
        4 => wing_nut(&mut parts),
        which => {
            if let Some(([a, b, c], mass)) = CUBOIDS.get(which) {
                parts.bar([0.0, -0.5 * c], [0.0, 0.5 * c], *a, *b, *mass);
            }
        }
    }
    parts.1
}

fn racket(parts: &mut Parts<'_>) {
    let (wide, long, middle) = (0.122, 0.165, 0.520);
    let corner = |i: u32| {
        let (sin, cos) = (TAU * f64::from(i) / 48.0).sin_cos();
        [wide * cos, middle + long * sin]
    };
    for i in 0..48 {
        parts.bar(corner(i), corner(i + 1), 0.016, 0.016, 0.150 / 48.0);
    }
    // 16 strings along and 19 across, of one mass a metre.
    let chord = |i: u32, count: u32| {
        let at = f64::from(2 * i) / f64::from(count + 1) - 1.0;
        (at, (1.0 - at * at).sqrt())
    };
    let chords = |count: u32| (1..=count).map(|i| chord(i, count).1).sum::<f64>();
    let per_metre = 0.0085 / (chords(16) * long + chords(19) * wide);
    for (count, across) in [(16, wide), (19, long)] {
        for i in 1..=count {
            let (at, half) = chord(i, count);
            let end = |side: f64| {
                if count == 16 {
                    [across * at, middle + side * long * half]
                } else {
                    [side * wide * half, middle + across * at]
                }
            };
            let reach = if count == 16 { long } else { wide };
            parts.bar(end(-1.0), end(1.0), 0.0, 0.0, per_metre * 2.0 * reach * half);
        }
    }
    for side in [-1.0, 1.0] {
        parts.bar([side * 0.012, 0.190], [side * 0.080, 0.395], 0.014, 0.014, 0.025);
    }
    parts.bar([0.0, 0.0], [0.0, 0.190], 0.034, 0.029, 0.110);
}

fn wing_nut(parts: &mut Parts<'_>) {
    let (hole, radius, height, top, span) = (0.0045, 0.00825, 0.0068, 0.0177, 0.0362);
    let (wing, thick) = (0.0118, 0.0033);
    let (x, far) = (top - 0.5 * wing, 0.5 * span);
    let mass = STEEL * PI * (radius * radius - hole * hole) * height;
    parts.add([1.0, 0.0, height, hole, radius, 0.0, 0.0, mass]);
    let mass = STEEL * wing * thick * (far - radius);
    parts.bar([x, -far], [x, -radius], wing, thick, mass);
    parts.bar([x, radius], [x, far], wing, thick, mass);
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Rotation3, UnitQuaternion, Vector3};
    use tumbling::body::named;
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
        let theirs =
            [named::the_box(), named::book(), named::phone(), named::tennis_racket(), named::wing_nut()];
        for (which, theirs) in theirs.into_iter().enumerate() {
            let theirs = theirs.unwrap();
            let tensor = theirs.inertia().matrix();
            let size = tensor.amax();
            let ours = made(which, true);
            assert!((ours.mass() / theirs.mass() - 1.0).abs() < 1e-13, "{which}: {}", ours.mass());
            assert!((ours.centre() - theirs.centre()).amax() < 1e-15, "{which}: {}", ours.centre());
            let off = (ours.inertia().matrix() - tensor).amax();
            assert!(off < 1e-13 * size, "{which}: {off} beside {size}");
            // As thick as it is drawn the racket's frame is no line: that changes its moments by less than one part in a hundred.
            for (axis, (thick, right)) in
                made(which, false).inertia().matrix().diagonal().iter().zip(&tensor.diagonal()).enumerate()
            {
                assert!((thick / right - 1.0).abs() < 0.01, "{which}, axis {axis}: {thick} beside {right}");
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
