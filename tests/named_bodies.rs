//! The book's named bodies: what they weigh, how they lie, and how near they are to measured ones.

use nalgebra::Vector3;
use tumbling::{Axis, bodies};

#[test]
fn every_named_body_flips_about_x_and_lies_along_z() {
    let names: Vec<_> = bodies::all().iter().map(|b| b.name()).collect();
    assert_eq!(
        names,
        [
            "the box",
            "the book",
            "the phone",
            "the remote control",
            "the hammer",
            "the tennis racket",
            "the wing nut",
            "the T-handle"
        ]
    );
    for body in bodies::all() {
        let name = body.name();
        let principal = body.properties().unwrap().inertia().principal();
        for (axis, direction) in
            [(Axis::Smallest, Vector3::z()), (Axis::Middle, Vector3::x()), (Axis::Largest, Vector3::y())]
        {
            assert!((principal.axis(axis) - direction).amax() < 1e-12, "{name} {axis:?}");
        }
        let [a, b, c] = <[f64; 3]>::from(principal.moments());
        // Clearly apart: by a twentieth of the largest at least, so that it flips within a toss.
        assert!(b - a > 0.05 * c && c - b > 0.05 * c, "{name}: {a} {b} {c}");
        assert!(!body.sizes_from().is_empty());
    }
}

#[test]
fn the_box_has_the_moments_of_the_worked_example() {
    let the_box = bodies::the_box().unwrap();
    let moments = the_box.inertia().matrix().diagonal() * 12.0;
    assert_eq!(moments, Vector3::new(10.0, 13.0, 5.0));
}

// Brody's Wilson T-2000, another racket of the same kind: ours must be of its size, not its copy.
#[test]
fn the_tennis_racket_is_within_a_seventh_of_a_measured_one() {
    let racket = bodies::tennis_racket().unwrap();
    let moments = racket.inertia().principal().moments();
    for (ours, measured) in moments.iter().zip([0.00121, 0.01638, 0.01748]) {
        assert!((ours / measured - 1.0).abs() < 1.0 / 7.0, "{ours} {measured}");
    }
    assert!((racket.mass() - 0.327).abs() < 1e-12);
    // All but the handle's thickness lies in one plane: the two smaller moments nearly make the largest.
    let flatness = (moments[0] + moments[1] - moments[2]) / moments[2];
    assert!(flatness > 0.0 && flatness < 0.01, "{flatness}");
}

#[test]
fn the_wing_nut_weighs_what_the_table_says_within_a_tenth() {
    let mass = bodies::wing_nut().unwrap().mass();
    assert!((mass / 0.0135 - 1.0).abs() < 0.1, "{mass}");
}

// Independent: the two parts by hand, in grams and millimetres.
#[test]
fn the_t_handle_is_its_crossbar_and_its_stem() {
    let density = 7.85e-3;
    let area = std::f64::consts::PI * 36.0;
    let (bar, stem) = (density * area * 100.0, density * area * 50.0);
    let centre = stem * 31.0 / (bar + stem);
    let along_stem = bar * (3.0 * 36.0 + 1e4) / 12.0 + stem * 18.0;
    let along_bar = bar * (18.0 + centre * centre)
        + stem * ((3.0 * 36.0 + 2500.0) / 12.0 + (31.0 - centre) * (31.0 - centre));
    let handle = bodies::t_handle().unwrap();
    let tensor = handle.inertia().matrix() * 1e9;
    assert!((handle.centre().x * 1e3 - centre).abs() < 1e-12);
    assert!((tensor[(0, 0)] / along_stem - 1.0).abs() < 1e-13, "{tensor} {along_stem}");
    assert!((tensor[(2, 2)] / along_bar - 1.0).abs() < 1e-13, "{tensor} {along_bar}");
}
