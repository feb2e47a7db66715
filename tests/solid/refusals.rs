//! Bad sizes: each shape answers with an error that names the value and the rule, and never panics.

use crate::common::{any_vector, anything, refused};
use proptest::prelude::*;
use tumbling::solid::*;
use tumbling::{Error, ErrorKind};

pub type Made = Result<Box<dyn Solid>, Error>;

fn boxed<S: Solid + 'static>(made: Result<S, Error>) -> Made {
    made.map(|s| Box::new(s) as Box<dyn Solid>)
}

/// Every shape from the same three sizes.
pub fn every_shape(a: f64, b: f64, c: f64) -> Vec<(&'static str, Made)> {
    vec![
        ("cuboid", boxed(Cuboid::new(a, b, c))),
        ("ball", boxed(Ball::new(a))),
        ("hollow sphere", boxed(Ball::hollow(a, b))),
        ("ellipsoid", boxed(Ellipsoid::new(a, b, c))),
        ("cylinder", boxed(Cylinder::new(a, b))),
        ("tube", boxed(Cylinder::hollow(a, b, c))),
        ("capsule", boxed(Capsule::new(a, b))),
        ("cone", boxed(Cone::new(a, b))),
        ("rod", boxed(ThinRod::new(a))),
        ("plate", boxed(ThinPlate::new(a, b))),
        ("disk", boxed(ThinDisk::new(a))),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn any_numbers_at_all_give_a_shape_with_finite_properties_or_a_typed_error(
        a in anything(), b in anything(), c in anything(), mass in anything(),
        corners in proptest::array::uniform4(any_vector()),
    ) {
        let mut shapes = every_shape(a, b, c);
        shapes.push(("tetrahedron", boxed(Tetrahedron::new(corners))));
        let faces = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];
        shapes.push(("mesh", boxed(Mesh::new(&corners, &faces))));
        for (name, shape) in shapes {
            let Ok(shape) = shape else { continue };
            prop_assert!(shape.measure().map_or(true, |v| v.is_finite() && v >= 0.0), "{}", name);
            for made in [shape.with_mass(mass), shape.with_density(mass)] {
                let Ok(p) = made else { continue };
                prop_assert!(p.mass().is_finite() && p.mass() > 0.0, "{}", name);
                prop_assert!(p.centre().iter().all(|x| x.is_finite()), "{}", name);
                let tensor = p.inertia().matrix();
                prop_assert!(tensor.iter().all(|x| x.is_finite()), "{}: {}", name, tensor);
                prop_assert!(tensor.diagonal().min() >= 0.0 && tensor.diagonal().max() > 0.0, "{}", name);
            }
        }
    }
}

#[test]
fn a_size_that_is_no_size_is_named() {
    for (bad, zero_may_be) in
        [(f64::NAN, false), (f64::INFINITY, false), (f64::NEG_INFINITY, false), (-1.0, false), (0.0, true)]
    {
        for (place, sizes) in [[bad, 2.0, 2.0], [1.0, bad, 2.0], [1.0, 2.0, bad]].into_iter().enumerate() {
            let [a, b, c] = sizes;
            for (name, made) in every_shape(a, b, c) {
                let takes = match name {
                    "ball" | "rod" | "disk" => 1,
                    "cuboid" | "ellipsoid" | "tube" => 3,
                    _ => 2,
                };
                let a_hole_or_no_length =
                    matches!((name, place), ("hollow sphere" | "tube", 0) | ("capsule", 1));
                if place >= takes || (zero_may_be && a_hole_or_no_length) {
                    assert!(made.is_ok(), "{name} {sizes:?}");
                    continue;
                }
                let kind = if bad.is_finite() { ErrorKind::OutOfBounds } else { ErrorKind::NotFinite };
                refused(made.map(drop), kind, &format!(" is {bad:?}: it must"));
            }
        }
    }
}

#[test]
fn a_mass_or_density_that_is_none_is_named() {
    for (name, made) in every_shape(1.0, 2.0, 3.0) {
        let shape = made.expect("sober sizes");
        for bad in [f64::NAN, f64::INFINITY, -3.0, 0.0] {
            for (what, error) in [
                ("the mass", shape.with_mass(bad).unwrap_err()),
                ("the density", shape.with_density(bad).unwrap_err()),
            ] {
                assert!(error.to_string().starts_with(&format!("{what} is ")), "{name}: {error}");
            }
        }
    }
}

#[test]
fn a_hole_larger_than_the_whole_is_refused_with_both_radii() {
    for error in [Ball::hollow(3.0, 2.0).unwrap_err(), Cylinder::hollow(3.0, 2.0, 1.0).unwrap_err()] {
        assert_eq!(error.to_string(), "the inner radius is 3.0: it must be at most the outer radius, 2.0");
    }
}
