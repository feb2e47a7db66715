//! Lists of triangles that are no closed surface with one side in and one side out.

use super::surface::{brick, cube, inside_out, solid};
use crate::common::{any_vector, number_after, refused};
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::ErrorKind;
use tumbling::solid::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_faces_at_all_are_a_solid_or_a_typed_error(
        faces in proptest::collection::vec(proptest::array::uniform3(0_usize..6), 0..12),
        corners in proptest::collection::vec(any_vector(), 0..7),
    ) {
        if let Ok(mesh) = Mesh::new(&corners, &faces) {
            let _ = mesh.with_mass(1.0);
        }
        let turned = Mesh::new(&[Vector3::x(), Vector3::y(), Vector3::z(), Vector3::repeat(1.0)], &faces);
        if let Ok(mesh) = turned {
            prop_assert!(mesh.measure().unwrap() > 0.0);
        }
    }
}

#[test]
fn a_surface_that_is_none_is_refused_for_what_is_wrong_with_it() {
    let (corners, faces) = brick(Vector3::zeros(), Vector3::new(1.0, 2.0, 3.0));
    let refuse = |faces: &[[usize; 3]], words| refused(Mesh::new(&corners, faces), ErrorKind::BadMesh, words);

    refused(Mesh::new(&corners, &faces[..3]), ErrorKind::OutOfBounds, "3 faces given: at least 4 needed");
    refused(Mesh::new(&corners[..3], &faces), ErrorKind::OutOfBounds, "3 vertices given: at least 4 needed");

    let mut bad = faces.clone();
    bad[5] = [0, 8, 1];
    refuse(&bad, "face 5 is (0, 8, 1): it must name three different vertices below 8");
    bad[5] = [usize::MAX, 0, 1];
    refuse(&bad, "face 5 is (18446744073709551615, 0, 1)");
    bad[5] = [4, 0, 4];
    refuse(&bad, "face 5 is (4, 0, 4): it must name three different vertices below 8");

    // A hole: the face missing is (0, 2, 3), so its three edges have one face each.
    let open = refuse(&faces[1..], "belongs to 1 face(s)");
    for end in ["from vertex ", "to vertex "] {
        assert!([0.0, 2.0, 3.0].contains(&number_after(&open, end)), "{open}");
    }
    // A fin: one face more on three edges.
    let mut fin = faces.clone();
    fin.push([0, 1, 6]);
    assert!([1.0, 3.0].contains(&number_after(&refuse(&fin, "the edge from vertex"), "belongs to ")));

    let mut flipped = faces.clone();
    flipped[4].swap(0, 1);
    let inside_out_face = refuse(&flipped, "one of them is turned inside out");
    for end in ["from vertex ", "to vertex "] {
        let vertex = number_after(&inside_out_face, end) as usize;
        assert!(faces[4].contains(&vertex), "{inside_out_face}");
    }

    let turned = inside_out((corners.clone(), faces.clone()));
    let error = refused(solid(&turned), ErrorKind::BadMesh, "not above zero");
    let (volume, tolerance) = (number_after(&error, "comes out as "), number_after(&error, "rounding ("));
    assert!((volume + 6.0).abs() < 1e-14 && tolerance < 1e-13, "{volume} {tolerance}");
    let squashed: Vec<_> = corners.iter().map(|v| Vector3::new(v.x, v.y, v.x + 0.1 * v.y)).collect();
    refused(Mesh::new(&squashed, &faces), ErrorKind::BadMesh, "the volume comes out as");

    let mut unfinite = corners.clone();
    unfinite[6].y = f64::NAN;
    refused(Mesh::new(&unfinite, &faces), ErrorKind::NotFinite, "part 6: the vertex is NaN");
}

#[test]
fn a_corner_that_no_face_uses_changes_nothing() {
    let (mut corners, faces) = brick(Vector3::zeros(), Vector3::new(1.0, 2.0, 3.0));
    let plain = Mesh::new(&corners, &faces).unwrap().with_mass(1.0).unwrap();
    corners.push(Vector3::new(1e9, 1e9, 1e9));
    assert_eq!(Mesh::new(&corners, &faces).unwrap().with_mass(1.0).unwrap(), plain);
}

#[test]
fn a_face_listed_twice_is_refused_in_whatever_order_its_corners_are_named() {
    let (corners, faces) = cube([0.0; 3], 1.0);
    let mut twice = faces.clone();
    let [a, b, c] = faces[7];
    twice.push([b, c, a]);
    let again = format!("face 12, ({b}, {c}, {a}), is face 7 again");
    refused(Mesh::new(&corners, &twice), ErrorKind::BadMesh, &again);
    // Every face twice closes along every edge; it is still no solid of twice the density.
    let all = [faces.clone(), faces].concat();
    refused(Mesh::new(&corners, &all), ErrorKind::BadMesh, "is face 0 again");
}
