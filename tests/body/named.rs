//! The book's named bodies: what they weigh, how they lie, and how near they are to measured ones.

use nalgebra::Vector3;
use tumbling::Axis;
use tumbling::body::named::NamedBody;

#[test]
fn every_named_body_flips_about_x_and_lies_along_z() {
    for body in NamedBody::ALL {
        let principal = body.properties().unwrap().inertia().principal();
        for (axis, direction) in
            [(Axis::Smallest, Vector3::z()), (Axis::Middle, Vector3::x()), (Axis::Largest, Vector3::y())]
        {
            assert!((principal.axis(axis) - direction).amax() < 1e-12, "{body} {axis:?}");
        }
        let [a, b, c] = <[f64; 3]>::from(principal.moments());
        // Clearly apart: by a twentieth of the largest at least, so that it flips within a toss.
        assert!(b - a > 0.05 * c && c - b > 0.05 * c, "{body}: {a} {b} {c}");
    }
}

// Brody's Wilson T-2000, another racket of the same kind: ours must be of its size, not its copy.
#[test]
fn the_tennis_racket_is_within_a_seventh_of_a_measured_one() {
    let racket = NamedBody::TennisRacket.properties().unwrap();
    let moments = racket.inertia().principal().moments();
    for (ours, measured) in moments.iter().zip([0.00121, 0.01638, 0.01748]) {
        assert!((ours / measured - 1.0).abs() < 1.0 / 7.0, "{ours} {measured}");
    }
    // All but the handle's thickness lies in one plane: the two smaller moments nearly make the largest.
    let flatness = (moments[0] + moments[1] - moments[2]) / moments[2];
    assert!(flatness > 0.0 && flatness < 0.01, "{flatness}");
}

#[test]
fn the_wing_nut_weighs_what_the_table_says_within_a_tenth() {
    let mass = NamedBody::WingNut.properties().unwrap().mass();
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
    let handle = NamedBody::THandle.properties().unwrap();
    let tensor = handle.inertia().matrix() * 1e9;
    assert!((handle.centre().x * 1e3 - centre).abs() < 1e-12);
    assert!((tensor[(0, 0)] / along_stem - 1.0).abs() < 1e-13, "{tensor} {along_stem}");
    assert!((tensor[(2, 2)] / along_bar - 1.0).abs() < 1e-13, "{tensor} {along_bar}");
}

/// `m/12 (b² + c²)` about each edge of a box of `edges` (mm) and `mass` (g), in kg m².
fn box_moments(mass: f64, [a, b, c]: [f64; 3]) -> Vector3<f64> {
    Vector3::new(b * b + c * c, c * c + a * a, a * a + b * b) * (mass / 12.0 * 1e-9)
}

// Makers' pages: iPhone 15, 71.6 x 7.80 x 147.6 mm, 171 g; Siri Remote (2nd generation), 35 x 9.25 x 136 mm,
// 63 g. A B-format paperback is 129 x 198 mm; 160 leaves of 80 g/m² and two covers of 250 g/m², each leaf
// 0.125 mm.
#[test]
fn the_book_the_phone_and_the_remote_control_are_boxes_of_their_published_sizes() {
    let leaf: f64 = 0.129 * 0.198;
    let paper = leaf * (160.0 * 80.0 + 2.0 * 250.0);
    assert_eq!(paper.round(), 340.0);
    for (body, mass, edges) in [
        (NamedBody::Book.properties(), 340.0, [129.0, 160.0 * 0.125, 198.0]),
        (NamedBody::Phone.properties(), 171.0, [71.6, 7.80, 147.6]),
        (NamedBody::RemoteControl.properties(), 63.0, [35.0, 9.25, 136.0]),
    ] {
        let body = body.unwrap();
        assert!((body.mass() * 1e3 - mass).abs() < 1e-12 * mass, "{}", body.mass());
        let (tensor, expected) = (body.inertia().matrix(), box_moments(mass, edges));
        assert!(
            (tensor - nalgebra::Matrix3::from_diagonal(&expected)).amax() < 1e-14 * expected.amax(),
            "{tensor}"
        );
    }
}

// A steel block of 100 x 32 x 32 mm on an ash stick 29 mm thick and 290 mm long, in grams and millimetres.
#[test]
fn the_hammer_is_its_head_and_its_handle() {
    let head = 7.85e-3 * 100.0 * 32.0 * 32.0;
    let handle = 0.68e-3 * std::f64::consts::PI * 14.5 * 14.5 * 290.0;
    let centre = (head * 306.0 + handle * 145.0) / (head + handle);
    let lever = head * (306.0 - centre).powi(2) + handle * (145.0 - centre).powi(2);
    let stick = handle * (3.0 * 14.5 * 14.5 + 290.0 * 290.0) / 12.0;
    let about_x = head * 2.0 * 32.0 * 32.0 / 12.0 + stick + lever;
    let about_y = head * (1e4 + 32.0 * 32.0) / 12.0 + stick + lever;
    let about_z = head * (1e4 + 32.0 * 32.0) / 12.0 + handle * 14.5 * 14.5 / 2.0;
    let hammer = NamedBody::Hammer.properties().unwrap();
    assert!((hammer.mass() * 1e3 / (head + handle) - 1.0).abs() < 1e-14);
    assert!((hammer.centre() * 1e3 - Vector3::new(0.0, 0.0, centre)).amax() < 1e-11);
    let (tensor, expected) = (hammer.inertia().matrix() * 1e9, Vector3::new(about_x, about_y, about_z));
    assert!(
        (tensor - nalgebra::Matrix3::from_diagonal(&expected)).amax() < 1e-13 * about_x,
        "{tensor} {expected}"
    );
}

// The parts by integrals: an elliptic hoop and strings as sums over many points, not the library's bars.
#[test]
fn the_tennis_racket_is_its_hoop_strings_throat_and_handle() {
    // Mass points in the xz plane, in metres and kilograms.
    let mut points: Vec<(f64, f64, f64)> = Vec::new();
    let mut line = |mass: f64, from: [f64; 2], to: [f64; 2]| {
        // Simpson's weights are exact for a line's second moments.
        for (share, t) in [(1.0 / 6.0, 0.0), (4.0 / 6.0, 0.5), (1.0 / 6.0, 1.0)] {
            let at = |k: usize| from[k] + (to[k] - from[k]) * t;
            points.push((mass * share, at(0), at(1)));
        }
    };
    let corner = |i: f64| {
        let angle = std::f64::consts::TAU * i / 48.0;
        [0.122 * angle.cos(), 0.520 + 0.165 * angle.sin()]
    };
    for i in 0..48 {
        line(0.150 / 48.0, corner(f64::from(i)), corner(f64::from(i + 1)));
    }
    let places = |n: i32| (1..=n).map(move |i| -1.0 + 2.0 * f64::from(i) / f64::from(n + 1));
    let half = |at: f64| (1.0 - at * at).sqrt();
    let length: f64 =
        places(16).map(|at| 0.330 * half(at)).chain(places(19).map(|at| 0.244 * half(at))).sum();
    for at in places(16) {
        let reach = 0.165 * half(at);
        line(0.017 * 2.0 * reach / length, [0.122 * at, 0.520 - reach], [0.122 * at, 0.520 + reach]);
    }
    for at in places(19) {
        let reach = 0.122 * half(at);
        line(0.017 * 2.0 * reach / length, [-reach, 0.520 + 0.165 * at], [reach, 0.520 + 0.165 * at]);
    }
    line(0.025, [0.012, 0.190], [0.080, 0.395]);
    line(0.025, [-0.012, 0.190], [-0.080, 0.395]);
    line(0.110, [0.0, 0.0], [0.0, 0.190]);
    let mass: f64 = points.iter().map(|p| p.0).sum();
    let centre = points.iter().map(|p| p.0 * p.2).sum::<f64>() / mass;
    let wide: f64 = points.iter().map(|p| p.0 * p.1 * p.1).sum::<f64>() + 0.110 * 0.034 * 0.034 / 12.0;
    let long: f64 = points.iter().map(|p| p.0 * (p.2 - centre).powi(2)).sum();
    let thick = 0.110 * 0.029 * 0.029 / 12.0;
    let racket = NamedBody::TennisRacket.properties().unwrap();
    assert!((racket.mass() - 0.327).abs() < 1e-14 && (mass - 0.327).abs() < 1e-14);
    assert!((racket.centre() - Vector3::new(0.0, 0.0, centre)).amax() < 1e-14);
    let expected = Vector3::new(long + thick, wide + long, wide + thick);
    let tensor = racket.inertia().matrix();
    assert!((tensor - nalgebra::Matrix3::from_diagonal(&expected)).amax() < 1e-15, "{tensor} {expected}");
}
