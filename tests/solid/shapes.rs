//! Each shape against its integral by the definition, against other shapes, and against exact arithmetic.

use super::cloud::{Cloud, assert_integrates, assert_same, decades, gauss, size, slices};
use super::refusals::every_shape as made;
use crate::common::refused;
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::solid::*;
use tumbling::{ErrorKind, Inertia};

const MASS: f64 = 0.7;

fn check(what: &str, solid: &impl Solid, cloud: &Cloud) {
    let properties = solid.with_mass(MASS).expect("sober sizes");
    assert_integrates(what, properties, solid.measure().expect("sober sizes"), cloud);
    let by_density = solid.with_density(3.0).expect("sober sizes");
    let mass = 3.0 * cloud.measure();
    assert!((by_density.mass() - mass).abs() <= 1e-12 * mass, "{what}: mass by density");
    assert_integrates(what, by_density, solid.measure().expect("sober sizes"), cloud);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn round_shapes_have_the_moments_of_their_integrals(a in size(), b in size(), c in size()) {
        let ball = |r: f64| slices([-r, r], 0.0, |z| [r * r - z * z; 2]);
        check("ball", &Ball::new(a).unwrap(), &ball(a));
        let outer = a + b;
        check("hollow sphere", &Ball::hollow(a, outer).unwrap(), &ball(outer).and(-1.0, &ball(a)));
        let squash = |z: f64| 1.0 - z * z / (c * c);
        check("ellipsoid", &Ellipsoid::new(a, b, c).unwrap(), &slices([-c, c], 0.0, |z| {
            [a * a * squash(z), b * b * squash(z)]
        }));
        let half = 0.5 * c;
        check("cylinder", &Cylinder::new(a, c).unwrap(), &slices([-half, half], 0.0, |_| [a * a; 2]));
        check("tube", &Cylinder::hollow(a, outer, c).unwrap(), &slices([-half, half], a / outer, |_| [outer * outer; 2]));
        let narrowing = |z: f64| (a * (1.0 - z / c)).powi(2);
        check("cone", &Cone::new(a, c).unwrap(), &slices([0.0, c], 0.0, |z| [narrowing(z); 2]));
        let cap = |z: f64| a * a - (z.abs() - half).powi(2);
        let capsule = slices([-half, half], 0.0, |_| [a * a; 2])
            .and(1.0, &slices([half, half + a], 0.0, |z| [cap(z); 2]))
            .and(1.0, &slices([-half - a, -half], 0.0, |z| [cap(z); 2]));
        check("capsule", &Capsule::new(a, c).unwrap(), &capsule);
    }

    #[test]
    fn flat_faced_and_thin_shapes_have_the_moments_of_their_integrals(a in size(), b in size(), c in size()) {
        let line = |l: f64| gauss(-0.5 * l, 0.5 * l);
        let mut cuboid = Cloud::default();
        let mut plate = Cloud::default();
        for (x, dx) in line(a) {
            for (y, dy) in line(b) {
                plate.0.push((dx * dy, Vector3::new(x, y, 0.0)));
                cuboid.0.extend(line(c).iter().map(|(z, dz)| (dx * dy * dz, Vector3::new(x, y, *z))));
            }
        }
        check("cuboid", &Cuboid::new(a, b, c).unwrap(), &cuboid);
        check("plate", &ThinPlate::new(a, b).unwrap(), &plate);
        let rod = Cloud(line(c).iter().map(|(z, dz)| (*dz, Vector3::new(0.0, 0.0, *z))).collect());
        check("rod", &ThinRod::new(c).unwrap(), &rod);
        let mut disk = slices([0.0, 1.0], 0.0, |_| [a * a; 2]);
        disk.0.iter_mut().for_each(|(_, p)| p.z = 0.0);
        check("disk", &ThinDisk::new(a).unwrap(), &disk);
    }

    // Gauss on a cube folded onto the tetrahedron: u, (1-u) v, (1-u)(1-v) w.
    #[test]
    fn a_tetrahedron_has_the_moments_of_its_integral(corners in proptest::array::uniform4(super::cloud::vector(-2.0..2.0))) {
        let [a, b, c, d] = corners;
        let six_volume = (b - a).dot(&(c - a).cross(&(d - a))).abs();
        prop_assume!(six_volume > 1e-2);
        let mut cloud = Cloud::default();
        for (u, du) in gauss(0.0, 1.0) {
            for (v, dv) in gauss(0.0, 1.0) {
                for (w, dw) in gauss(0.0, 1.0) {
                    let (s, t) = (1.0 - u, (1.0 - u) * (1.0 - v));
                    let point = a + (b - a) * u + (c - a) * (s * v) + (d - a) * (t * w);
                    cloud.0.push((six_volume * s * t * du * dv * dw, point));
                }
            }
        }
        check("tetrahedron", &Tetrahedron::new(corners).unwrap(), &cloud);
        check("its mirror order", &Tetrahedron::new([b, a, c, d]).unwrap(), &cloud);
    }

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
