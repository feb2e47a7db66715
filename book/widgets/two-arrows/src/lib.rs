//! Two arrows: a spin that turns from one principal axis of a body to another, and the momentum, which leaves
//! the spin on the way; and masses that are moved, and the resulting tensor.

use exchange::Numbers;
use nalgebra::{Matrix3, Vector3};
use tumbling::body::named::{self, Even};
use tumbling::inertia::point_mass;
use tumbling::solid::{Ball, Cuboid, Cylinder, Shape, ThinPlate};

/// The edges along x and y of a thin plate, twice as wide as high.
const PLATE: Even<2> = Even { sizes: [2.0, 1.0], mass: 1.0 };

/// The radius and the length along z of a pencil.
const PENCIL: Even<2> = Even { sizes: [0.0035, 0.18], mass: 0.005 };

/// The radius of a ball.
const BALL: Even<1> = Even { sizes: [0.5], mass: 1.0 };

/// The moments of a body, kg m², and its size along its axes, m. The bodies are those of the book.
fn body(which: f64) -> (Vector3<f64>, [f64; 3]) {
    let cuboid = |body: Even<3>| (Cuboid::moments(&body.mass, body.sizes.each_ref()), body.sizes);
    match which as u32 {
        0 => {
            let Even { sizes, mass } = PLATE;
            (ThinPlate::moments(&mass, sizes.each_ref()), [sizes[0], sizes[1], 0.0])
        }
        1 => cuboid(named::THE_BOX),
        2 => cuboid(named::BOOK),
        3 => cuboid(named::PHONE),
        4 => {
            let Even { sizes, mass } = PENCIL;
            (Cylinder::moments(&mass, sizes.each_ref()), [2.0 * sizes[0], 2.0 * sizes[0], sizes[1]])
        }
        _ => {
            let Even { sizes, mass } = BALL;
            (Ball::moments(&mass, sizes.each_ref()), [2.0 * sizes[0]; 3])
        }
    }
}

/// 0, two arrows. Of the row it takes: which body (the plate, the box, the book, the phone, a pencil, a
/// ball); between which two of its principal axes (0 the smallest and the middle moment, 1 the middle and the
/// largest, 2 the smallest and the largest); and the spin along the lighter and along the heavier of them,
/// rad/s, neither below zero.
///
/// It answers with the angles of spin and momentum from the lighter axis and the gap, degrees; the momentum
/// along the two axes, kg m²/s; the two moments, kg m²; the body's size along the two, m; which body axes
/// the two are, 0, 1 or 2; and all three moments and sizes, along x, y and z.
///
/// 1, point masses: a twist, N m; an axis, of any length; how many; and of each its mass, kg, and its place
/// from their common centre, m. The answer: the tensor, xx, yy, zz, xy, xz, yz, kg m²; the momentum for a
/// spin of 1 rad/s about the axis; the moment about it; and how much faster the twist has it turn each
/// second, on an axle there, rad/s². No answer where nothing resists: all masses lie on the axle.
pub fn answer(what: u32, row: &Numbers) -> usize {
    if what == 1 {
        return masses(row);
    }
    let [which, between, along, up] = row.take(0);
    let (moments, size) = body(which);
    let at = row.fill(&arrows(which, between as u32, [along, up]));
    row.fill_from(row.fill_from(at, moments.as_slice()), &size)
}

fn masses(row: &Numbers) -> usize {
    let [twist, x, y, z, count] = row.take(0);
    let axis = Vector3::new(x, y, z).normalize();
    let piece = |i: usize| point_mass(&row.get(5 + 4 * i), &Vector3::from(row.take(6 + 4 * i)));
    let t: Matrix3<f64> = (0..(count as usize).min(64)).map(piece).sum();
    let momentum = t * axis;
    let about = axis.dot(&momentum);
    let at = row.fill(&[t.m11, t.m22, t.m33, t.m12, t.m13, t.m23]);
    let at = row.fill_from(at, momentum.as_slice());
    if about > 0.0 { row.fill_from(at, &[about, twist / about]) } else { 0 }
}

/// Along principal axes, each component of the momentum is that of the spin times its own moment. These
/// moments need no check, and a gap that a widget shows is not small: `tests` below compare both with the
/// library's checked functions.
fn arrows(which: f64, between: u32, spin: [f64; 2]) -> [f64; 11] {
    let (moments, size) = body(which);
    let [least, middle, most] = ordered(moments.into());
    let axes = match between {
        0 => [least, middle],
        1 => [middle, most],
        _ => [least, most],
    };
    let of = |values: [f64; 3]| axes.map(|axis| values.get(axis).copied().unwrap_or(0.0));
    let [moments, size] = [of(moments.into()), of(size)];
    let momentum = [moments[0] * spin[0], moments[1] * spin[1]];
    let angle = |[along, up]: [f64; 2]| up.atan2(along).to_degrees();
    let [from, to] = [angle(spin), angle(momentum)];
    [
        from,
        to,
        (to - from).abs(),
        momentum[0],
        momentum[1],
        moments[0],
        moments[1],
        size[0],
        size[1],
        axes[0] as f64,
        axes[1] as f64,
    ]
}

/// The axes of the smallest, the middle and the largest moment. Of equal ones the earlier comes first.
fn ordered([x, y, z]: [f64; 3]) -> [usize; 3] {
    let place = |earlier: bool, other: bool| usize::from(earlier) + usize::from(other);
    let places = [place(y < x, z < x), place(x <= y, z < y), place(x <= z, y <= z)];
    let who = |place: usize| places.iter().position(|&p| p == place).unwrap_or(0);
    [who(0), who(1), who(2)]
}

exchange::page!(answer);

#[cfg(test)]
mod tests {
    use super::*;
    use tumbling::solid::{Cuboid, Solid, ThinPlate};
    use tumbling::{Inertia, body::named};

    #[test]
    fn the_arrows_are_those_of_the_checked_library() {
        for which in 0..6 {
            for between in 0..3 {
                for degrees in 0..=90 {
                    let (up, along) = f64::from(degrees).to_radians().sin_cos();
                    let found = arrows(f64::from(which), between, [along, up]);
                    let [x, y, z] = body(f64::from(which)).0.into();
                    let inertia = Inertia::from_moments(x, y, z).unwrap();
                    let mut omega = Vector3::zeros();
                    omega[found[9] as usize] = along;
                    omega[found[10] as usize] = up;
                    let momentum = inertia.momentum(&omega);
                    let along = [found[9], found[10]].map(|axis| momentum[axis as usize]);
                    assert_eq!(along, [found[3], found[4]]);
                    let gap = inertia.angle_to_momentum(&omega).unwrap().to_degrees();
                    let off = (gap - found[2]).abs();
                    assert!(off < 1e-12, "body {which}, {between}, {degrees}: {gap}, off by {off}");
                    assert!(found[5] <= found[6]);
                }
            }
        }
    }

    #[test]
    fn masses_resist_as_the_sum_of_their_squared_distances_from_the_axle_says() {
        let points = [(1.0, [0.9, 0.4, -0.2]), (2.0, [-0.5, 0.1, 0.3]), (0.5, [0.2, -1.2, -0.8])];
        let row = Numbers::empty();
        let (twist, axis) = (3.0, Vector3::new(2.0, -1.0, 0.5));
        let at = row.fill(&[twist, axis.x, axis.y, axis.z, 3.0]);
        points.iter().fold(at, |at, (mass, place)| row.fill_from(row.fill_from(at, &[*mass]), place));
        assert_eq!(answer(1, &row), 11);
        let about = points.map(|(mass, r)| mass * Vector3::from(r).cross(&axis.normalize()).norm_squared());
        assert!((row.get(9) - about.iter().sum::<f64>()).abs() < 1e-15);
        assert!((row.get(10) - twist / row.get(9)).abs() < 1e-15);
        row.fill(&[1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 5.0, 0.0, 0.0]);
        assert_eq!(answer(1, &row), 0);
    }

    #[test]
    fn the_bodies_are_those_of_the_book() {
        let same = |which: f64, properties: tumbling::MassProperties| {
            let [ours, theirs] = [body(which).0, properties.inertia().matrix().diagonal()];
            assert!((ours - theirs).amax() <= 4.0 * f64::EPSILON * theirs.amax(), "{which}: {ours} {theirs}");
        };
        same(0.0, ThinPlate::new(2.0, 1.0).unwrap().with_mass(1.0).unwrap());
        same(1.0, Cuboid::new(2.0, 1.0, 3.0).unwrap().with_mass(1.0).unwrap());
        same(1.0, named::NamedBody::TheBox.properties().unwrap());
        same(2.0, named::NamedBody::Book.properties().unwrap());
        same(3.0, named::NamedBody::Phone.properties().unwrap());
    }
}
