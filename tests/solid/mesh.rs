//! Solids bounded by triangles: the divergence theorem against closed forms, to rounding at every size.

use super::shared::{assert_same, moved, size, together, vector};
use super::surface::{both, brick, inside_out, solid, turned_and_carried};
use crate::common::{number_after, refused};
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::ErrorKind;
use tumbling::solid::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_meshed_box_is_the_box_wherever_it_lies(
        a in size(), b in size(), c in size(), low in vector(-5.0..5.0), angles in proptest::array::uniform3(-3.0..3.0_f64),
    ) {
        let edges = Vector3::new(a, b, c);
        let turn = UnitQuaternion::from_euler_angles(angles[0], angles[1], angles[2]);
        let (mut corners, faces) = brick(low, edges);
        corners.iter_mut().for_each(|v| *v = turn * *v);
        let mesh = Mesh::new(&corners, &faces).unwrap().with_density(2.0).unwrap();
        let cuboid = Cuboid::new(a, b, c).unwrap().with_density(2.0).unwrap();
        let placed = moved(&cuboid, &(low + edges * 0.5)).unwrap().turned(turn).unwrap();
        // The corners are rounded at their distance, up to 20 m, on edges from 0.1 m up.
        assert_same("box", &mesh, &placed, 1e-12, 20.0);
    }

    #[test]
    fn a_cavity_takes_away_what_would_fill_it(
        at in vector(0.05..0.4), hole in vector(0.1..0.5),
    ) {
        let (low, edges) = (Vector3::new(-1.0, 2.0, 0.5), Vector3::new(2.0, 1.0, 3.0));
        let (start, size) = (at.component_mul(&edges), hole.component_mul(&edges));
        let hollow = solid(&both(brick(low, edges), inside_out(brick(low + start, size)))).unwrap();
        let filling = solid(&brick(low + start, size)).unwrap();
        let full = solid(&brick(low, edges)).unwrap().with_density(3.0).unwrap();
        let parts = [hollow.with_density(3.0).unwrap(), filling.with_density(3.0).unwrap()];
        assert_same("filled", &together(&parts).unwrap(), &full, 1e-13, 3.0);
    }
}

#[test]
fn a_mesh_far_from_the_origin_keeps_its_digits() {
    // The corners are exact at 2^30 m away, so the solid is exactly the same.
    let far = Vector3::new(2.0_f64.powi(30), -(2.0_f64.powi(30)), 2.0_f64.powi(29));
    let (low, edges) = (Vector3::new(1.0, 2.0, -3.0), Vector3::new(0.5, 2.0, 1.25));
    let near = solid(&brick(low, edges)).unwrap().with_density(1.0).unwrap();
    let away = solid(&brick(low + far, edges)).unwrap().with_density(1.0).unwrap();
    assert_same("far box", &away, &moved(&near, &far).unwrap(), 4e-16, 1.0);
}

// A wire: the integrals are the cuboid's, and no moment is a difference of larger numbers.
#[test]
fn a_meshed_needle_keeps_the_digits_of_its_smallest_moment() {
    for edges in [1e-3, 1e-8, 1e-60].map(|thin| Vector3::new(1.1, 0.7 * thin, 0.9 * thin)) {
        let mesh = solid(&brick(edges * -0.3, edges)).unwrap().with_mass(2.0).unwrap();
        let cuboid = Cuboid::new(edges.x, edges.y, edges.z).unwrap().with_mass(2.0).unwrap();
        let [found, expected] = [mesh, cuboid].map(|solid| solid.inertia().matrix()[(0, 0)]);
        assert!((found / expected - 1.0).abs() < 1e-14, "{edges}: {found:e}, {expected:e}");
    }
}

// Half the corners belong to a speck 1 km off: their mean is 500 m from the centre.
#[test]
fn a_speck_far_away_does_not_blur_the_solid() {
    let (edges, speck) = (Vector3::new(0.5, 2.0, 1.25), Vector3::repeat(2.0_f64.powi(-13)));
    let (low, away) = (Vector3::new(0.25, 0.0, -1.0), Vector3::new(600.0, -640.0, 480.0));
    let mesh = solid(&both(brick(low, edges), brick(away, speck))).unwrap().with_density(1.0).unwrap();
    let part = |low: Vector3<f64>, e: Vector3<f64>| {
        let cuboid = Cuboid::new(e.x, e.y, e.z).unwrap().with_density(1.0).unwrap();
        moved(&cuboid, &(low + e * 0.5)).unwrap()
    };
    let parts = [part(low, edges), part(away, speck)];
    assert_same("with a speck", &mesh, &together(&parts).unwrap(), 1e-14, 1.0);
}

#[test]
fn a_mesh_of_any_size_is_measured_or_out_of_range() {
    for scale in [1e-100, 1e70] {
        let mesh = solid(&brick(Vector3::zeros(), Vector3::new(2.0, 1.0, 3.0) * scale)).unwrap();
        let moments = mesh.with_mass(12.0).unwrap().inertia().matrix().diagonal();
        let expected = Vector3::new(10.0, 13.0, 5.0) * scale * scale;
        assert!((moments - expected).amax() <= 1e-14 * expected.amax(), "{moments:e}");
    }
    let huge = solid(&brick(Vector3::zeros(), Vector3::new(2.0, 1.0, 3.0) * 1e200)).unwrap();
    refused(huge.measure(), ErrorKind::Unrepresentable, "the volume comes out as inf");
    refused(huge.with_mass(1.0), ErrorKind::Unrepresentable, "a moment of inertia comes out as inf");
}

#[test]
fn a_tetrahedron_is_the_mesh_of_its_faces_in_either_order_of_its_corners() {
    let [a, b, c, d] =
        [[0.1, -0.4, 0.2], [1.3, 0.2, -0.1], [-0.2, 0.9, 0.3], [0.4, 0.1, 1.7]].map(Vector3::from);
    let mesh = Mesh::new(&[a, b, c, d], &[[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]]).unwrap();
    for corners in [[a, b, c, d], [b, a, c, d]] {
        let solid = Tetrahedron::new(corners).unwrap();
        assert!((solid.measure().unwrap() / mesh.measure().unwrap() - 1.0).abs() < 1e-14);
        assert_same("corners", &solid.with_mass(0.7).unwrap(), &mesh.with_mass(0.7).unwrap(), 1e-14, 1.0);
    }
}

// A bow tie's prism: its upper half, nearly as large as the lower and farther from their centre, is inside
// out.
#[test]
fn a_surface_through_itself_is_refused_where_no_body_has_such_a_tensor() {
    let outline = [[-1.0, 0.0], [1.0, 0.0], [-0.95, 1.95], [0.95, 1.95]];
    let corner = |x: f64| outline.map(|[y, z]| Vector3::new(x, y, z));
    let corners = [corner(0.0), corner(1.0)].concat();
    let mut faces = vec![[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7]];
    for i in 0..4 {
        let j = (i + 1) % 4;
        faces.extend([[i, j, j + 4], [i, j + 4, i + 4]]);
    }
    let error = refused(Mesh::new(&corners, &faces), ErrorKind::Impossible, "the triangle inequality");
    assert!(number_after(&error, "fails by ") > number_after(&error, "rounding ("));
    assert!(!error.to_string().contains("within"), "no digits were rounded: {error}");
}

// A wedge so thin that its volume is a known number of its own rounding bounds: the bound is half a unit for
// each of eight roundings a face and one addition each, on the sum of all terms taken positive.
#[test]
fn a_mesh_and_a_tetrahedron_are_flat_when_their_volume_is_within_its_own_rounding_and_only_then() {
    let tilted = |x: f64, y: f64, up: f64| Vector3::new(x, y, 0.1 * x + 0.3 * y + up);
    let faces = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];
    let wedge =
        |up: f64| [tilted(0.0, 0.1, 0.0), tilted(1.0, 0.2, 0.0), tilted(0.3, 1.0, 0.0), tilted(0.7, 0.9, up)];
    let both = |up: f64| {
        let mesh = Mesh::new(&wedge(up), &faces).map(|mesh| mesh.measure().unwrap());
        [mesh, Tetrahedron::new(wedge(up)).map(|solid| solid.measure().unwrap())]
    };
    // Each coordinate is up to 1, off by up to half a unit, and the base is about half a square metre: at
    // 1e-17 nothing is left of the height, at 1e-13 three digits of it are.
    for volume in [0.0, 1e-17, 5e-17, -1e-16].into_iter().flat_map(both) {
        let error = refused(volume, ErrorKind::BadMesh, "not above zero by more than rounding");
        let (volume, tolerance) = (number_after(&error, "comes out as "), number_after(&error, "rounding ("));
        assert!(volume.abs() <= 1.05 * tolerance && tolerance > 1e-17 && tolerance < 1e-15, "{error}");
    }
    for up in [1e-14, 1e-13] {
        let base = 0.5 * (1.0 * 0.9 - 0.3 * 0.1);
        for volume in both(up) {
            assert!((volume.clone().unwrap() - base * up / 3.0).abs() < 1e-16, "{volume:?}");
        }
    }
}

// A flat body has I1 + I2 = I3; its moments, off by rounding, may exceed that by a little.
#[test]
fn a_body_as_flat_as_can_be_passes_however_it_lies() {
    let mut exceeded = 0;
    for i in 0..200 {
        let angles = [0.1 + 0.37 * f64::from(i), 1.3 * f64::from(i), -0.7 * f64::from(i)];
        let plate = brick(Vector3::new(-0.3, -0.6, 0.0), Vector3::new(0.7, 1.3, 3e-9));
        let mesh = solid(&turned_and_carried(plate, angles, Vector3::zeros())).unwrap();
        let moments = mesh.with_mass(1.0).unwrap().inertia().principal().moments();
        exceeded += usize::from(moments[2] - moments[1] > moments[0]);
    }
    assert!(exceeded > 0, "none of the plates tries the rule");
}
