//! How much of each shape there is, shapes against other shapes, and sizes to the ends of the range. That the
//! moments are the integrals of the shapes is proven for all sizes.

use super::refusals::every_shape as made;
use super::shared::{assert_same, decades, size};
use crate::common::refused;
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::solid::*;
use tumbling::{ErrorKind, Inertia};

const MASS: f64 = 0.7;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn shapes_that_lose_a_size_become_simpler_shapes(a in size(), c in size()) {
        // No formula rounds more than 13 times, each time by half a unit at most.
        let rounding = 2.0 * 13.0 * 0.5 * f64::EPSILON;
        let same = |what: &str, p: MassProperties, q: MassProperties| assert_same(what, &p, &q, rounding, 1.0);
        let of = |s: &dyn Solid| s.with_mass(MASS).unwrap();
        same("capsule without length", of(&Capsule::new(a, 0.0).unwrap()), of(&Ball::new(a).unwrap()));
        same("hollow sphere without hole", of(&Ball::hollow(0.0, a).unwrap()), of(&Ball::new(a).unwrap()));
        same("round ellipsoid", of(&Ellipsoid::new(a, a, a).unwrap()), of(&Ball::new(a).unwrap()));
        same("tube without hole", of(&Cylinder::hollow(0.0, a, c).unwrap()), of(&Cylinder::new(a, c).unwrap()));
        same("flat cylinder", of(&Cylinder::new(a, 1e-30).unwrap()), of(&ThinDisk::new(a).unwrap()));
        same("flat box", of(&Cuboid::new(a, c, 1e-30).unwrap()), of(&ThinPlate::new(a, c).unwrap()));
        let shell = of(&Ball::hollow(a, a).unwrap()).inertia().matrix()[(0, 0)];
        prop_assert!((shell - 2.0 / 3.0 * MASS * a * a).abs() <= rounding * shell);
    }

    #[test]
    fn inertia_grows_with_the_mass_and_the_square_of_the_size_to_the_last_bit(
        s in proptest::array::uniform3(size()), size_up in -160_i32..160, mass_up in -160_i32..160,
    ) {
        let (grow, heavier) = (2_f64.powi(size_up), 2_f64.powi(mass_up));
        let [a, b, c] = s.map(|x| x * grow);
        for (small, large) in every_shape(s[0], s[1], s[2]).iter().zip(every_shape(a, b, c)) {
            let small = small.with_mass(MASS).unwrap().inertia().matrix();
            let large = large.with_mass(MASS * heavier).unwrap().inertia().matrix();
            prop_assert_eq!(small * heavier * grow * grow, large);
        }
    }

    // The judge is the strict check for given moments, a few units in the last place.
    #[test]
    fn over_a_hundred_and_fifty_decades_a_shape_is_possible_or_out_of_range(
        a in decades(), b in decades(), c in decades(), mass in decades(),
    ) {
        for shape in every_shape(a, b, c) {
            match shape.with_mass(mass) {
                Ok(p) => prop_assert!(Inertia::try_from(p.inertia().matrix()).is_ok(), "{p:?}"),
                Err(e) => prop_assert_eq!(e.kind(), ErrorKind::Unrepresentable, "{}", e),
            }
        }
    }
}

/// Every shape, hollow ones with a hole, and a tetrahedron.
fn every_shape(a: f64, b: f64, c: f64) -> Vec<Box<dyn Solid>> {
    let corners = [Vector3::zeros(), Vector3::x() * a, Vector3::y() * b, Vector3::z() * c];
    let tetrahedron: Box<dyn Solid> = Box::new(Tetrahedron::new(corners).unwrap());
    made(a, a + b, c).into_iter().map(|(_, shape)| shape.unwrap()).chain([tetrahedron]).collect()
}

/// By the textbook's formulas, of radius or edge `a`, height, edge or outer radius `b`, and `c`.
#[test]
fn a_shape_of_even_density_weighs_its_measure_times_that() {
    let ([a, b, c], pi) = ([0.7_f64, 1.1, 1.9], std::f64::consts::PI);
    let ball = |r: f64| 4.0 / 3.0 * pi * r.powi(3);
    let disk = pi * a * a;
    let tube = pi * (b * b - a * a) * c;
    let measures = [
        a * b * c,
        ball(a),
        ball(b) - ball(a),
        4.0 / 3.0 * pi * a * b * c,
        disk * b,
        tube,
        disk * b + ball(a),
        disk * b / 3.0,
        a,
        a * b,
        disk,
    ];
    for ((name, shape), measure) in made(a, b, c).into_iter().zip(measures) {
        let shape = shape.unwrap();
        let found = [shape.measure().unwrap(), shape.with_density(3.0).unwrap().mass() / 3.0];
        assert!(found.iter().all(|x| (x / measure - 1.0).abs() < 2e-15), "{name}: {found:?}, not {measure}");
    }
}

#[test]
fn a_body_smaller_than_any_atom_or_larger_than_the_sky_has_its_moments() {
    // 2/5 m r^2 from exact powers of ten.
    for (radius, mass, moment) in [
        (1e-100, 1.0, 4e-201),
        (1e70, 1e-90, 4e49),
        (1e-150, 1e290, 4e-11),
        (1e150, 1e-290, 4e9),
        (5e-324, 1e308, 0.0),
    ] {
        let ball = Ball::new(radius).unwrap().with_mass(mass);
        if moment == 0.0 {
            refused(ball, ErrorKind::Unrepresentable, "comes out as 0.0");
        } else {
            let got = ball.unwrap().inertia().matrix()[(1, 1)];
            assert!((got - moment).abs() <= 1e-15 * moment, "{got:e} {moment:e}");
        }
    }
    let beyond = Ball::new(1e200).unwrap();
    refused(beyond.measure(), ErrorKind::Unrepresentable, "the volume comes out as inf");
    refused(beyond.with_mass(1.0), ErrorKind::Unrepresentable, "a moment of inertia comes out as inf");
    refused(beyond.with_density(1e-300), ErrorKind::Unrepresentable, "the volume comes out as inf");
    // A needle whose thin side alone vanishes in f64 is refused, not made an ideal rod.
    let needle = Cuboid::new(1e-170, 1e-170, 1.0).unwrap().with_mass(1.0);
    refused(needle, ErrorKind::Unrepresentable, "a moment of inertia comes out as 0.0");
}

#[test]
fn a_shell_without_thickness_has_mass_but_no_density() {
    for shell in [&Ball::hollow(2.0, 2.0).unwrap() as &dyn Solid, &Cylinder::hollow(2.0, 2.0, 3.0).unwrap()] {
        assert_eq!(shell.measure(), Ok(0.0));
        assert!(shell.with_mass(1.0).is_ok());
        refused(shell.with_density(1.0), ErrorKind::OutOfBounds, "the volume is 0.0");
    }
}

#[test]
fn the_volume_of_a_thin_shell_does_not_cancel_away() {
    // A millimetre of water round a ball of a thousand kilometres: 4 pi r^2 d (1 + d/r + ...).
    let (r, d) = (1_048_576.0_f64, 2.0_f64.powi(-10));
    let expected = 4.0 * std::f64::consts::PI * (r * r * d + r * d * d);
    let got = Ball::hollow(r, r + d).unwrap().measure().unwrap();
    assert!((got - expected).abs() <= 1e-15 * expected, "{got} {expected}");
}
