//! Films, read back: what is drawn at an instant is the motion at that instant.

use nalgebra::{Rotation3, Vector3};
use std::f64::consts::TAU;
use tumbling::step::Engine;
use tumbling::{Axis, Body};
use tumbling_bodies::BodyModel;
use tumbling_figures::film::{Camera, Film, Request};

/// Without symmetry: a hammer, as the book has it.
fn hammer() -> BodyModel {
    BodyModel::load("hammer").unwrap()
}

/// The point of the first filled head in this ink: an arrow's tip, in points of the sheet.
fn tip(svg: &str, ink: &str) -> [f64; 2] {
    let head = svg.lines().find(|line| line.contains(&format!("style=\"fill:var(--fig-{ink},"))).unwrap();
    let point = head.strip_prefix("<path d=\"M").unwrap().split('l').next().unwrap();
    let (x, y) = point.split_once(' ').unwrap();
    [x, y].map(|number| number.parse::<f64>().unwrap() / 10.0)
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[test]
fn the_drawn_arrow_is_the_spin_of_a_body_stepped_through_time() {
    let (model, push) = (hammer(), 0.05);
    let request =
        Request { push: Some(push), camera: Some(Camera::Room), seconds: Some(3.0), ..Request::default() };
    let film = Film::new(&model, &request).unwrap();
    let principal = model.principal();
    let omega = (principal.axis(Axis::Middle) + push * principal.axis(Axis::Largest)) * TAU;
    let start = film.motion().attitude(0.0).unwrap();
    let momentum = start * model.inertia.momentum(&omega);
    assert!((momentum / momentum.norm() - Vector3::z()).norm() < 1e-12, "the momentum points upwards");
    let body = Body::spinning(model.inertia, start, &omega).unwrap();
    // Stepped, not by the closed form that the film uses: 2400 steps, a frame each eighth of them.
    let steps = 2400;
    let run = Engine::Turned.run(&body, film.shows() / f64::from(steps), steps as usize).unwrap();
    let mut seen = Vec::new();
    for i in (0..=steps).step_by(300) {
        let svg = film.frame(f64::from(i) / f64::from(steps)).unwrap();
        let drawn = tip(&svg, "omega");
        let expected = film.projection().tip(&run[i as usize].omega_world());
        assert!(apart(drawn, expected) < 1.0, "at step {i}: {drawn:?}, not {expected:?}");
        seen.push(drawn);
        let up = tip(&svg, "momentum");
        assert!(apart(up, tip(&film.frame(0.0).unwrap(), "momentum")) < 0.2, "the momentum moved");
    }
    assert!(seen.iter().any(|&at| apart(at, seen[0]) > 20.0), "the spin never moved");
}

#[test]
fn seen_from_the_body_the_spin_keeps_to_body_axes() {
    let model = hammer();
    let film = Film::new(&model, &Request { camera: Some(Camera::Body), ..Request::default() }).unwrap();
    let up = Rotation3::rotation_between(&model.principal().axis(Axis::Middle), &Vector3::z()).unwrap();
    for share in [0.0, 0.21, 0.5, 0.83] {
        let omega = film.motion().omega(share * film.shows()).unwrap();
        let expected = film.projection().tip(&(up * omega));
        assert!(apart(tip(&film.frame(share).unwrap(), "omega"), expected) < 1.0, "{share}");
    }
}

#[test]
fn arrows_are_projected_from_infinitely_far_with_z_upwards() {
    let film = Film::new(&hammer(), &Request::default()).unwrap();
    let centre = film.projection().tip(&Vector3::zeros());
    let seen = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| {
        let at = film.projection().tip(&axis);
        [at[0] - centre[0], at[1] - centre[1]]
    });
    // Three perpendicular arrows of one length: their shadows' squares add up to twice its square, and
    // right and up are perpendicular and equally long.
    let sum = |i: usize, j: usize| seen.iter().map(|at| at[i] * at[j]).sum::<f64>();
    assert!((sum(0, 0) / sum(1, 1) - 1.0).abs() < 1e-12 && sum(0, 1).abs() < 1e-12 * sum(0, 0));
    assert!(seen[2][0].abs() < 1e-12 && seen[2][1] < 0.0);
}

/// Numbers of the attributes or paths of a line.
fn numbers(line: &str) -> Vec<f64> {
    let plain = line.split("style").next().unwrap().replace('-', " -");
    let words = plain.split(|c: char| !c.is_ascii_digit() && c != '-' && c != '.');
    words.filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn the_spin_is_seen_from_where_the_body_is() {
    let (model, axis) = (hammer(), Axis::Smallest);
    let request = Request { axis, push: Some(0.3), camera: Some(Camera::Room), ..Request::default() };
    let film = Film::new(&model, &request).unwrap();
    let centre = film.projection().tip(&Vector3::zeros());
    for share in [0.1, 0.37, 0.8] {
        let attitude = film.motion().attitude(share * film.shows()).unwrap();
        let at = film.projection().tip(&(attitude * model.principal().axis(axis)));
        let svg = film.frame(share).unwrap();
        let pin = |at: &&str| at.contains("stroke:var(--fig-axis-min") && at.contains("stroke-width:50");
        let pin = numbers(svg.lines().find(pin).unwrap());
        let (x, y) = (at[0] - centre[0], at[1] - centre[1]);
        let aside = (x * pin[3] - y * pin[2]) / x.hypot(y) / pin[2].hypot(pin[3]);
        assert!(aside.abs() < 0.02, "{share}: {aside}");
    }
}

#[test]
fn a_steady_spin_is_a_point_of_the_ellipsoid_at_its_axis() {
    // Its principal axes are y, z and x.
    let model = BodyModel::from_toml("sides = [1, 3, 2]\nmass = 1", "".as_ref()).unwrap();
    for (axis, ink) in Axis::ALL.into_iter().zip(["min", "mid", "max"]) {
        let film = Film::new(&model, &Request { axis, push: Some(0.0), ..Request::default() }).unwrap();
        let svg = film.frame(0.3).unwrap();
        let circle = |ink: &str| {
            let mark = |line: &&str| line.starts_with("<circle") && line.contains(ink);
            let at = numbers(svg.lines().rfind(mark).unwrap());
            [at[0] / 10.0, at[1] / 10.0]
        };
        let (spin, end) = (circle("--fig-omega"), circle(&format!("--fig-axis-{ink}")));
        // The mark is at the end of the axis that is seen.
        let other = [2.0 * 524.0 - end[0], 2.0 * 190.0 - end[1]];
        assert!(apart(spin, end).min(apart(spin, other)) < 1.0, "{axis:?}: {spin:?}, not {end:?}");
    }
}

#[test]
fn a_body_of_any_shape_fills_the_height_or_the_width_that_it_has() {
    for model in ["hammer", "book", "tennis-racket"].map(|name| BodyModel::load(name).unwrap()) {
        let film = Film::new(&model, &Request::default()).unwrap();
        let centre = film.projection().tip(&Vector3::zeros());
        let (mut most, mut pin) = (0.0_f64, 1.0_f64);
        for share in (0..40).map(|i| f64::from(i) / 40.0) {
            // The body stands first, up to the trace of the spin.
            let svg = film.frame(share).unwrap();
            let pins = svg.lines().filter(|line| line.contains("stroke-width:50")).map(numbers);
            let long: Vec<f64> = pins.map(|pin| pin[2].hypot(pin[3])).collect();
            pin = pin.min(long[long.len() - 1] / long[0]);
            let drawn = svg.split("<g fill").nth(1).unwrap().lines();
            let body = drawn.take_while(|line| !line.contains("fig-omega"));
            for line in body.filter(|line| line.contains("fill:var(--fig-surface")) {
                let mut at = centre.map(|x| -x);
                for step in numbers(line).chunks_exact(2) {
                    at = [at[0] + step[0] / 10.0, at[1] + step[1] / 10.0];
                    most = most.max(at[0].abs() / 192.0).max(at[1].abs() / 118.0);
                }
            }
        }
        assert!((0.97..1.01).contains(&most), "{}: {most}", model.name);
        // A pin is seen from where it leaves the body. A racket has nothing around it to hide it.
        assert_eq!(pin > 0.9, model.name == "the tennis racket", "{}: {pin}", model.name);
    }
}

/// Of each thing of a drawing but its clock: its look, and of a path the box around it, since rounding
/// decides which points a path drops.
fn timeless(svg: &str) -> Vec<(String, [f64; 4])> {
    let path = |line: &str| {
        let (points, look) = line.strip_prefix("<path d=\"")?.split_once('"')?;
        let (mut at, mut around) = ([0.0; 2], [f64::INFINITY, f64::INFINITY, -f64::INFINITY, -f64::INFINITY]);
        for step in numbers(points).chunks_exact(2) {
            at = [at[0] + step[0], at[1] + step[1]];
            around = [around[0].min(at[0]), around[1].min(at[1]), around[2].max(at[0]), around[3].max(at[1])];
        }
        Some((look.to_string(), around))
    };
    let lines = svg.lines().filter(|line| !line.contains(">t = "));
    lines.map(|line| path(line).unwrap_or_else(|| (line.into(), [0.0; 4]))).collect()
}

/// Whether two drawings look alike, to a few tenths of a pixel.
fn alike(one: &str, other: &str) -> bool {
    let (one, other) = (timeless(one), timeless(other));
    let near = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 3.0);
    one.len() == other.len() && one.iter().zip(other).all(|(a, b)| a.0 == b.0 && near(a.1, b.1))
}

#[test]
fn a_film_that_closes_starts_again_with_its_first_drawing() {
    for camera in [None, Some(Camera::Body), Some(Camera::Momentum)] {
        for (body, axis) in [("book", Axis::Middle), ("hammer", Axis::Middle), ("hammer", Axis::Smallest)] {
            let model = BodyModel::load(body).unwrap();
            let film = Film::new(&model, &Request { camera, axis, ..Request::default() }).unwrap();
            let (first, again) = (film.frame(0.0).unwrap(), film.frame(1.0).unwrap());
            let half = film.frame(0.5).unwrap();
            assert!(alike(&first, &again) && !alike(&first, &half), "{body} {axis:?} {camera:?}");
            assert!(film.explained().unwrap().contains("without a seam"), "{}", film.explained().unwrap());
        }
    }
}

#[test]
fn left_to_itself_a_film_takes_the_push_with_which_the_body_comes_back_in_the_room() {
    let film = Film::new(&hammer(), &Request::default()).unwrap();
    assert_eq!(film.camera(), Camera::Room);
    let attitude = |share: f64| film.motion().attitude(share * film.shows()).unwrap();
    let apart = |share| attitude(share).angle_to(&attitude(0.0));
    assert!(apart(1.0) < 1e-9 && apart(0.5) > 1.0, "{} {}", apart(1.0), apart(0.5));
}

#[test]
fn bodies_with_equal_moments_and_steady_spins_are_filmed_too() {
    let model = |text: &str| BodyModel::from_toml(text, "".as_ref()).unwrap();
    for (body, push, turns) in [
        ("shape = 'cylinder'\nradius = 0.012\nheight = 0.002\nmass = 0.007", Some(0.3), None),
        ("shape = 'ball'\nradius = 1\nmass = 2", Some(0.3), Some((1.0_f64 + 0.09).sqrt())),
        ("sides = [1, 2, 3]\nmass = 1e15", Some(0.0), Some(1.0)),
    ] {
        for axis in Axis::ALL {
            let film = Film::new(&model(body), &Request { axis, push, ..Request::default() }).unwrap();
            let (first, again) = (film.frame(0.0).unwrap(), film.frame(1.0).unwrap());
            assert!(alike(&first, &again) && !first.contains("NaN"), "{body} {axis:?}");
            if let Some(turns) = turns {
                assert!((film.shows() * turns - 1.0).abs() < 1e-9, "{body} {axis:?}: {} s", film.shows());
            }
        }
    }
}

#[test]
fn a_push_that_leaves_a_gap_is_seen_turning_along_unless_the_room_was_requested() {
    let request = Request { push: Some(0.05), ..Request::default() };
    assert_eq!(Film::new(&hammer(), &request).unwrap().camera(), Camera::Momentum);
    let room = Film::new(&hammer(), &Request { camera: Some(Camera::Room), ..request }).unwrap();
    assert_eq!(room.camera(), Camera::Room);
    assert!(room.explained().unwrap().contains("does not close"), "{}", room.explained().unwrap());
}

#[test]
fn a_turn_takes_a_second_of_the_film_at_any_spin() {
    let film =
        |spin| Film::new(&hammer(), &Request { spin, push: Some(0.03), ..Request::default() }).unwrap();
    for spin in [1e-3, TAU, 500.0] {
        let (film, usual) = (film(spin), film(TAU));
        assert!((film.seconds() / usual.seconds() - 1.0).abs() < 1e-9);
        assert!((film.shows() * spin / (usual.shows() * TAU) - 1.0).abs() < 1e-9);
    }
}

#[test]
fn what_cannot_be_filmed_is_refused_in_a_sentence() {
    let usual = Request::default();
    for (request, words) in [
        (Request { spin: 0.0, ..usual }, "a spin of 0 rad/s: nothing would move"),
        (Request { seconds: Some(-1.0), ..usual }, "-1 seconds: a film takes from 0.1 to 600"),
        (Request { spin: 1e300, ..usual }, "a spin of 1e300 rad/s: films go from 1e-12 to 1e12"),
        (Request { push: Some(f64::NAN), ..usual }, "a push of NaN: a share of the spin, from -100 to 100"),
    ] {
        assert_eq!(Film::new(&hammer(), &request).unwrap_err().to_string(), words);
    }
}
