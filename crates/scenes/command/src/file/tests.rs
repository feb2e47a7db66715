//! Scenes in files: what is wrong is named by line and field.

use super::File;
use nalgebra::Vector3;
use proptest::prelude::*;
use std::path::Path;
use tumbling::step::Torque;
use tumbling_bodies::{BodyModel, Error};
use tumbling_scenes::{Error as SceneError, Field, InitialState, Start};

fn read(text: &str) -> Result<File, Error> {
    super::read(text.to_owned(), Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../files")))
}

proptest! {
    #[test]
    fn no_text_breaks_the_reader(text in "\\PC*", at in 0..200_usize, with in "[\\[\\]=\"0-9a-z\n.#e-]{0,4}") {
        let _ = read(&text);
        let good = include_str!("../../../files/heavy-top.toml");
        let at = (0..=at.min(good.len())).rev().find(|&at| good.is_char_boundary(at)).unwrap();
        let _ = read(&[&good[..at], &with, &good[at..]].concat());
    }
}

const GOOD: &str = "accuracy = 1e-9\nspan = 1.0\nevery = 0.5\nwants = [\"spin\"]\n\n[[body]]\nmoments = [1, 2.0, 2.5]\nspin = [0.1, 1.0, 0.2]\n";

fn refusal(from: &str, to: &str) -> String {
    let text = GOOD.replacen(from, to, 1);
    assert_ne!(text, GOOD, "{from}");
    read(&text).unwrap_err().to_string()
}

#[test]
fn a_wrong_file_is_refused_by_line_field_and_what_was_expected() {
    assert!(read(GOOD).is_ok());
    let torque = |text: &str| refusal("\n\n[[body]]", &format!("\n\n[[torque]]\n{text}\n[[body]]"));
    for (message, expected) in [
        (refusal("accuracy", "acuracy"), "line 1, `acuracy`: no such field. Did you mean `accuracy`?"),
        (refusal("moments", "momets"), "line 7, `momets`: no such field. Did you mean `moments`?"),
        (refusal("spin = [", "omega = ["), "line 8, `omega`: no such field. Did you mean `spin`?"),
        (refusal("every", "dt"), "line 3, `dt`: no such field. Did you mean `every`?"),
        (refusal("accuracy = 1e-9\n", ""), "`accuracy` is missing; it stands above the first `[[...]]`"),
        (
            refusal("[[body]]", "[body]"),
            "line 6, `body`: a list is expected here, not map: each table of a list begins with `[[body]]`",
        ),
        (refusal("[[body]]", "[torque]\n[[body]]"), "line 6, `torque`: a list is expected here"),
        (refusal("every = 0.5", "every = 1e-300"), "line 3, `every`: the number of states is"),
        (refusal("span = 1.0", "span = 1e308"), "line 2, `span`: the number of states is inf"),
        (refusal("1e-9", "\"fine\""), "line 1, `accuracy`: a number is expected here, not string \"fine\""),
        (refusal("1e-9", "2.0"), "line 1, `accuracy`: the accuracy is 2.0"),
        (refusal("1e-9", "1e-17"), "line 1, `accuracy`: an accuracy of 1e-17 is requested"),
        (refusal("span = 1.0", "span = -1.0"), "line 2, `span`: the span is -1.0: it must not be below zero"),
        (refusal("every = 0.5\n", ""), "line 2, `span`: `every` is missing, which goes with it"),
        (refusal("every = 0.5", "every = 0"), "line 3, `every`: the time between states is 0.0"),
        (refusal("span = 1.0\nevery = 0.5", "times = [2.0, 1.0]"), "line 2, `times`: a time is 2.0: it must"),
        (refusal("span = 1.0", "times = [1.0]"), "line 2, `times`: either `times` or `every` and `span`"),
        (refusal("\"spin\"", "\"spni\""), "line 4, `wants`: `spni` is not known here. Did you mean `spin`?"),
        (refusal("\"spin\"", "1"), "line 4, `wants`: a text is expected here"),
        (refusal("[1, 2.0, 2.5]", "[1, 2.0]"), "line 7, `moments`: 3 numbers are expected here, not 2"),
        (refusal("2.5]", "inf]"), "line 7, `moments`: inf is no finite number"),
        (refusal("2.5]", "1e999]"), "line 7"),
        (refusal("0.1, 1.0", "1e-400, 1.0"), "line 8, `spin`: 1e-400 is too near zero"),
        (refusal("spin = [0.1, 1.0, 0.2]\n", ""), "line 6: `spin` or `momentum` of this body is missing"),
        (refusal("moments = [1", "moments = [1,, 1"), "line 7"),
        (torque("pull = [1, 0, 0]"), "line 7, `pull`: no such field."),
        (
            torque("arm = [1, 0, 0]"),
            "line 7, `arm`: it is a part of `arm` with `field`, or `arm` with `rest` with `stiffness`",
        ),
        (torque(""), "line 6: the kind of this torque"),
        (torque("from = 1"), "line 6: the kind of this torque"),
        (torque("field = [1, 0, 0]"), "line 7, `field`: it is a part of `arm` with `field`, or `moment`"),
        (
            torque("moment = [1, 0, 0]"),
            "line 7, `moment`: it is a part of `moment` with `field`, and the rest is missing",
        ),
        (torque("arm = [1, 0, 0]\nrest = [1, 0, 0]"), "line 7, `arm`: it is a part of `arm` with `rest`"),
        (torque("arm = [1, 0, 0]\nstiffness = 2"), "line 7, `arm`: it is a part of"),
        (torque("rest = [1, 0, 0]\nstiffness = 2"), "line 7, `rest`: it is a part of"),
        (
            torque("arm = [1, 0, 0]\nmoment = [1, 0, 0]\nfield = [1, 0, 0]"),
            "line 6, `torque`: one kind of torque is expected",
        ),
        (torque("toward = [1, 0, 0]"), "line 7, `toward`: it is a part of `toward` with `orbit`, or `to"),
        (torque("damping = [1, 1, 1]\nfrom = 2\nto = 1"), "line 8, `from`: the start of a torque"),
        (torque("in-body = [1, 0, 0]\nuntil = 1"), "line 8, `until`: no such field. Did you mean `to`?"),
        (torque("dissipation = 1\nin-body = [1, 0, 0]"), "line 6, `torque`: one kind of torque is expected"),
    ] {
        assert!(message.starts_with(expected), "{message}\nwhere expected: {expected}");
    }
    for alone in "stiffness=2|orbit=[1,0,0]|amplitude=[1,0,0]|rate=1|phase=1|strength=1".split('|') {
        let (field, _) = alone.split_once('=').unwrap();
        let message = torque(alone);
        assert!(message.starts_with(&format!("line 7, `{field}`: it is a part of")), "{message}");
    }
    for none in ["", "body = []\n"] {
        let error = read(&format!("accuracy = 0.1\nspan = 0\nevery = 1\nwants = []\n{none}")).unwrap_err();
        assert_eq!(
            (error.line, error.why.as_str()),
            (None, "`body` is missing; each begins with `[[body]]`")
        );
    }
}

/// Each field of each kind of torque, made bad so that the library refuses it, and made infinite.
#[test]
fn each_field_of_a_torque_made_bad_in_turn_is_the_field_that_is_named() {
    let kinds = [
        "in-body = [1, 0, 0]",
        "in-world = [1, 0, 0]",
        "arm = [1, 0, 0]\nfield = [0, 0, 1]",
        "moment = [1, 0, 0]\nfield = [0, 0, 1]",
        "arm = [1, 0, 0]\nrest = [0, 0, 1e10]\nstiffness = 1",
        "damping = [1, 1, 1]",
        "dissipation = 1",
        "toward = [1, 0, 0]\norbit = [0, 0, 1]",
        "toward = [1, 0, 0]\nstrength = 1",
        "amplitude = [1, 0, 0]\nrate = 1\nphase = 1",
    ];
    let refused = [
        ("stiffness", "1e300"),
        ("damping", "[1, -1, 1]"),
        ("dissipation", "-1"),
        ("toward", "[2, 0, 0]"),
        ("orbit", "[0, 0, 1e200]"),
        ("strength", "-1"),
        ("from", "8"),
    ];
    let mut named = 0;
    for kind in kinds {
        let whole = format!("from = 1\nto = 2\n{kind}");
        for (line, given) in whole.lines().enumerate() {
            let (field, value) = given.split_once(" = ").unwrap();
            let bad = refused.iter().filter(|(name, _)| *name == field).map(|(_, bad)| (*bad).to_owned());
            let infinite = if value.starts_with('[') { "[inf, 0, 0]" } else { "inf" };
            for bad in bad.chain([infinite.to_owned()]) {
                let text = whole.replacen(given, &format!("{field} = {bad}"), 1);
                let error = read(&format!("{GOOD}[[torque]]\n{text}\n")).unwrap_err();
                let place = (error.line, error.field.as_deref());
                assert_eq!(place, (Some(10 + line), Some(field)), "{text}\n{error}");
                named += 1;
            }
        }
    }
    assert!(named > 40, "{named}");
}

/// One of three torques, one field of a body: neither the first nor the list.
#[test]
fn what_the_library_refuses_is_named_at_its_own_line() {
    let torques =
        "[[torque]]\nin-body = [1, 0, 0]\n[[torque]]\nfield = [1, 0, 0]\narm = [0, 1, 0]\n\n[[torque]]\n";
    let with = |last: &str| refusal("[[body]]", &format!("{torques}{last}\n[[body]]"));
    assert!(
        with("damping = [0, -2, 0]").starts_with("line 13, `damping`: a damping coefficient is -2.0"),
        "{}",
        with("damping = [0, -2, 0]")
    );
    assert!(with("\ndissipation = -3").starts_with("line 14, `dissipation`: the strength"));
    let body = |from: &str, to: &str| {
        let file = read(&GOOD.replacen(from, to, 1)).unwrap();
        let error = file.scene.plan(0).unwrap_err();
        file.error(0, &error).to_string()
    };
    for (message, expected) in [
        (body("2.5]", "9.5]"), "line 7, `moments`: body 0: no body has principal moments"),
        (body("[1, 2.0, 2.5]", "[0, 2, 2]"), "line 7, `moments`: body 0"),
        (
            body("moments = [1, 2.0, 2.5]", "moments = [1, -2.0, 2.5]\nproducts = [0.1, 0, 0]"),
            "line 7, `moments`: body 0: the moment Iyy is -2.0",
        ),
        (body("spin = [", "products = [5, 0, 0]\nspin = ["), "line 8, `products`: body 0"),
        (
            body("moments = [1, 2.0, 2.5]", "moments = [0, 0, 0]\nproducts = [1, 0, 0]"),
            "line 7, `moments`: body 0",
        ),
        (body("spin = [", "attitude = [1, 1, 0, 0]\nspin = ["), "line 8, `attitude`: body 0"),
        (
            body(
                "moments = [1, 2.0, 2.5]\nspin = [0.1, 1.0, 0.2]",
                "moments = [1e-9, 2, 2]\nmomentum = [1e300, 0, 0]",
            ),
            "line 8, `momentum`: body 0",
        ),
        (body("1e-9", "1e-15"), "line 6: body 0: an accuracy of 1e-15"),
    ] {
        assert!(message.starts_with(expected), "{message}\nwhere expected: {expected}");
    }
}

#[test]
fn many_bodies_are_read_each_with_its_own_line() {
    let head = "accuracy = 1e-9\ntimes = [1]\nwants = []\n";
    let body = "[[body]]\nmoments = [1, 2, 2.5]\nspin = [0, 1, 0]\n";
    let file = read(&(head.to_owned() + &body.repeat(100_000))).unwrap();
    assert_eq!(file.scene.bodies().len(), 100_000);
    for index in [0, 1, 49_999, 99_999] {
        let wrong = |field| {
            let source = Box::new(SceneError::Undefined { what: "", why: "" });
            file.error(index, &SceneError::Field { field, source }).line
        };
        let line = 4 + 3 * index;
        let found = [Field::Moments, Field::Spin, Field::Attitude].map(wrong);
        assert_eq!(found, [line + 1, line + 2, line].map(Some));
    }
}

/// By its name, from its file, as a solid, as parts, by a link: whatever a file of a body holds.
#[test]
fn a_body_of_a_scene_is_what_the_crate_of_bodies_reads() {
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../examples/bodies");
    let model = |text: &str| BodyModel::from_toml(text, Path::new("")).unwrap();
    let part = "[[body.part]]\nsides = [1, 2, 3]\nmass = 2\nat = [0, 0, 1]\n";
    for (text, expected) in [
        ("body = 'phone'", BodyModel::load("phone").unwrap()),
        (
            "body = '../../../examples/bodies/phone.toml'",
            BodyModel::load(&format!("{examples}/phone.toml")).unwrap(),
        ),
        ("body = '../../../examples/bodies/hammer.urdf#hammer'", BodyModel::load("hammer").unwrap()),
        ("urdf = '../../../examples/bodies/hammer.urdf'", BodyModel::load("hammer").unwrap()),
        (
            "shape = 'cone'\nradius = 1\nheight = 2\nmass = 3",
            model("shape = 'cone'\nradius = 1\nheight = 2\nmass = 3"),
        ),
        ("moments = [2, 3, 4]\nturn = [0, 0, 1, 90]", model("moments = [3, 2, 4]")),
        (&part.replace("at", "# "), model("sides = [1, 2, 3]\nmass = 2")),
        (&part.repeat(2), model("sides = [1, 2, 3]\nmass = 4")),
    ] {
        let head = "accuracy = 1e-9\ntimes = [1]\nwants = ['spin']\n[[body]]\nspin = [1, 2, 3]\n";
        let file = read(&format!("{head}{text}\n")).unwrap_or_else(|wrong| panic!("{text}: {wrong}"));
        let [InitialState { moments, products, start: Start::Spin(_), .. }] = *file.scene.bodies() else {
            panic!("{text}")
        };
        let tensor = expected.inertia.matrix();
        let off = (moments - tensor.diagonal()).amax().max(products.amax());
        assert!(off < 1e-5 * moments.amax(), "{text}: {moments} {tensor}");
    }
    for (text, words) in [
        ("body = 'phon'", "line 6, `body`: `phon` is neither a body of the book"),
        ("shape = 'ball'\nradius = 1", "line 6, `shape`: `mass` (kg) or `density`"),
        (
            "shape = 'ball'\nradius = 'one'\nmass = 1",
            "line 7, `radius`: a number is expected here, or one with its unit such as \"77 mm\" (mm, cm, m), not `one`",
        ),
        ("moments = [2, 3, 4]\nmass = -1", "line 7, `mass`: the mass is -1.0"),
    ] {
        let head = "accuracy = 1e-9\ntimes = [1]\nwants = ['spin']\n[[body]]\nspin = [1, 2, 3]\n";
        let error = read(&format!("{head}{text}\n")).unwrap_err().to_string();
        assert!(error.starts_with(words), "{text}: {error}");
    }
    let speed = read(&GOOD.replace("spin = [0.1, 1.0, 0.2]", "spin = 3")).unwrap_err().to_string();
    assert_eq!(speed, "line 8, `spin`: three numbers are expected here, along the body's axes");
}

/// What has a name of its own in a file is the library's torque of that name.
#[test]
fn a_spring_a_magnet_an_orbit_and_a_thruster_are_the_librarys() {
    let text = "\n[[torque]]\narm = [1, 2, 3]\nrest = [0, 0.5, 1]\nstiffness = 0.3\n\
                [[torque]]\nmoment = [1, 2, 3]\nfield = [0, 0.5, 1]\n\
                [[torque]]\ntoward = [0, 0.6, 0.8]\norbit = [0.1, 0.2, 0.3]\n\
                [[torque]]\ntoward = [0, 0.6, 0.8]\nstrength = 0.7\n\
                [[torque]]\nin-world = [1, 2, 3]\nfrom = 0.125\nto = 0.25\n\
                [[torque]]\ndissipation = 0.5\nto = 0.25\n";
    let (a, b) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.0, 0.5, 1.0));
    let (direction, orbit) = (Vector3::new(0.0, 0.6, 0.8), Vector3::new(0.1, 0.2, 0.3));
    let expected = [
        Torque::spring(&a, &b, 0.3),
        Torque::Aligning { arm: a, field: b },
        Torque::gravity_gradient(&direction, &orbit),
        Torque::GravityGradient { strength: 0.7, direction, orbit: Vector3::zeros() },
        Torque::during(0.125, 0.25, Torque::InWorld(a)),
        Torque::during(f64::NEG_INFINITY, 0.25, Torque::Dissipation(0.5)),
    ];
    assert_eq!(read(&(GOOD.to_owned() + text)).unwrap().scene.torques(), expected);
}
