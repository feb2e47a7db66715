//! Shells that are turned and nested as the surface of a solid, and others.

use super::shared::vector;
use super::surface::{Surface, both, brick, cube, inside_out, solid, turned_and_carried, welded};
use crate::common::{number_after, refused};
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::solid::*;
use tumbling::{Error, ErrorKind};

/// The shells' first face, volume and the winding number found next to it.
fn misplaced(surface: &Surface) -> (usize, f64, f64) {
    let error = refused(solid(surface), ErrorKind::BadMesh, "is turned or placed wrongly");
    let number = |words| number_after(&error, words);
    (number("shell that face ") as usize, number("of volume "), number("enclose a point "))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    // Shells within shells, their turns drawn: a solid only if they alternate, beginning with a solid one.
    #[test]
    fn nested_shells_are_a_solid_only_if_solid_and_cavity_alternate(
        inward in proptest::collection::vec(any::<bool>(), 2..5), apart in any::<bool>(),
        angles in proptest::array::uniform3(-3.0..3.0_f64), by in vector(-50.0..50.0),
    ) {
        let mut surface = Surface::default();
        let mut volume = 0.0;
        for (depth, &inward) in inward.iter().enumerate() {
            let edge = [4.0, 2.5, 1.5, 0.3][depth];
            let shell = cube([-0.5 * edge - 0.1, -0.5 * edge, -0.5 * edge + 0.05], edge);
            volume += if inward { -edge.powi(3) } else { edge.powi(3) };
            surface = both(surface, if inward { inside_out(shell) } else { shell });
        }
        if apart {
            surface = both(surface, cube([9.0, 0.5, 0.3], 1.0));
            volume += 1.0;
        }
        let alternate = inward.iter().enumerate().all(|(depth, &inward)| inward == (depth % 2 == 1));
        match solid(&turned_and_carried(surface, angles, by)) {
            Ok(mesh) => {
                prop_assert!(alternate);
                prop_assert!((mesh.measure().unwrap() - volume).abs() < 1e-10);
            }
            Err(error) if error.to_string().starts_with("the volume comes out as") => prop_assert!(volume < 1e-9),
            Err(error) => {
                prop_assert_eq!(error.kind(), ErrorKind::BadMesh);
                let winding = number_after(&error, "enclose a point ");
                prop_assert!(!alternate && !(0.0..=1.0).contains(&winding));
            }
        }
    }
}

#[test]
fn shells_that_are_turned_or_nested_wrongly_are_refused_and_named() {
    let (whole, inner) = (cube([0.0; 3], 2.0), cube([0.5; 3], 1.0));
    // The inside twice over: which shell is looked at first does not matter.
    assert_eq!(misplaced(&both(whole.clone(), inner.clone())), (12, 1.0, 2.0));
    assert_eq!(misplaced(&both(inner.clone(), whole.clone())), (0, 1.0, 2.0));
    // A cavity in a cavity.
    let hollow = both(whole.clone(), inside_out(inner));
    let deeper = inside_out(cube([0.75; 3], 0.5));
    assert_eq!(misplaced(&both(hollow, deeper)), (24, -0.125, -1.0));
    let outside = both(whole, inside_out(cube([5.0, 0.0, 0.0], 1.0)));
    let error = solid(&outside).unwrap_err();
    assert_eq!(misplaced(&outside), (12, -1.0, -1.0));
    assert_eq!(
        error.to_string(),
        "the shell that face 12 belongs to, of volume -1.0, is turned or placed wrongly: next to it the shells \
         enclose a point -1 times, and it must be 0 (outside the solid) or 1 (inside); a shell of negative volume \
         is a cavity and must lie in the solid"
    );
}

// Touching from without is a solid; turned inside out, the part that touches is not.
#[test]
fn a_part_that_touches_along_an_edge_or_a_face_is_judged_as_one_apart_from_it() {
    let whole = cube([0.0; 3], 2.0);
    for part in [cube([2.0, 2.0, 0.0], 2.0), cube([2.0, 0.0, 0.0], 2.0), cube([2.0, 0.5, 0.5], 1.0)] {
        let volume = 8.0 + solid(&part).unwrap().measure().unwrap();
        let (right, wrong) = (both(whole.clone(), part.clone()), both(whole.clone(), inside_out(part)));
        for right in [right.clone(), welded(right)] {
            assert_eq!(solid(&right).unwrap().measure().unwrap(), volume);
        }
        if volume < 16.0 {
            assert_eq!(misplaced(&wrong), (12, -1.0, -1.0));
            assert_eq!(misplaced(&welded(wrong)), (12, -1.0, -1.0));
        }
    }
    let edge_on =
        both(whole.clone(), inside_out(brick(Vector3::new(2.0, 2.0, 0.0), Vector3::new(1.0, 1.0, 2.0))));
    assert_eq!(misplaced(&edge_on), (12, -2.0, -1.0));
    assert_eq!(misplaced(&welded(edge_on)), (12, -2.0, -1.0));
    // From within: a cavity that opens to the outside makes a cup, one that is filled again the whole.
    let cavity = brick(Vector3::new(0.5, 0.5, 1.0), Vector3::new(1.0, 1.0, 1.0));
    let cup = both(whole, inside_out(cavity.clone()));
    assert_eq!(solid(&cup).unwrap().measure().unwrap(), 7.0);
    assert_eq!(solid(&both(cup, cavity)).unwrap().measure().unwrap(), 8.0);
}

#[test]
fn a_speck_on_the_face_of_a_body_ten_trillion_times_its_size_is_a_solid() {
    let surface = both(cube([0.0; 3], 1e3), cube([1e3, 300.0, 300.0], 1e-10));
    assert!(solid(&surface).is_ok());
    for i in 0..40 {
        let turn = [0.3 + f64::from(i), -1.1 * f64::from(i), 2.0];
        let lying = turned_and_carried(surface.clone(), turn, Vector3::new(-30.0, 0.0, 7.0));
        assert!(solid(&lying).is_ok(), "{i}");
    }
}

// Two cubes that share a whole face, listed both ways, close only together.
#[test]
fn parts_that_share_a_face_are_one_shell() {
    let pair = welded(both(cube([5.0, 0.0, 0.0], 1.0), cube([6.0, 0.0, 0.0], 1.0)));
    assert_eq!(solid(&pair).unwrap().measure().unwrap(), 2.0);
    let wrong = both(cube([0.0; 3], 2.0), inside_out(pair));
    assert_eq!(misplaced(&wrong), (12, -2.0, -1.0));
}

/// Tetrahedra, each at its place and of its size, every second one turned inside out if `cavities`.
fn tetrahedra(
    count: usize,
    cavities: bool,
    place: impl Fn(usize) -> (Vector3<f64>, f64),
) -> Result<Mesh, Error> {
    let corners =
        [Vector3::new(-1.0, -1.0, -1.0), Vector3::x() * 3.0, Vector3::y() * 3.0, Vector3::z() * 3.0];
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for k in 0..count {
        let (middle, size) = place(k);
        vertices.extend(corners.map(|corner| middle + corner * size));
        let at = |face: [usize; 3]| face.map(|i| 4 * k + i);
        let inward = cavities && k % 2 == 1;
        let own = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]].map(at);
        faces.extend(own.map(|[a, b, c]| if inward { [a, c, b] } else { [a, b, c] }));
    }
    Mesh::new(&vertices, &faces)
}

#[test]
fn thousands_of_shells_side_by_side_are_a_solid_and_as_many_in_one_another_are_refused_with_their_number() {
    let row = tetrahedra(4000, false, |k| (Vector3::new((k % 100) as f64, (k / 100) as f64, 0.0) * 4.0, 1.0));
    let one = tetrahedra(1, false, |_| (Vector3::zeros(), 1.0)).unwrap().measure().unwrap();
    assert!((row.unwrap().measure().unwrap() / (4000.0 * one) - 1.0).abs() < 1e-12);
    let nested = |count: usize| tetrahedra(count, true, |k| (Vector3::zeros(), 1.0 - k as f64 / 20_000.0));
    refused(nested(8_000), ErrorKind::TooMany, "8000 shells");
    let whole: f64 =
        (0..100).map(|k| (1.0 - f64::from(k) / 20_000.0).powi(3) * if k % 2 == 1 { -one } else { one }).sum();
    assert!((nested(100).unwrap().measure().unwrap() / whole - 1.0).abs() < 1e-10);
}
