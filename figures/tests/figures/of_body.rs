//! Figures of other bodies than the book's.

use tumbling_bodies::BodyModel;
use tumbling_figures::{registry, report};

/// Bodies from a dice to a planetoid, with what is special about each.
const BODIES: [(&str, &str); 13] = [
    ("a phone", "sides = [0.077, 0.0078, 0.16]\nmass = 0.2"),
    ("a dice", "sides = [0.009, 0.0091, 0.0092]\nmass = 0.001"),
    (
        "a satellite",
        "moments = [0.0421, 0.0418, 0.0067]\nproducts = [2.1e-4, -3.4e-4, 1.3e-4]\nmass = 4\nsides = [0.1, 0.1, 0.34]",
    ),
    ("a hammer", "body = 'hammer'"),
    ("a racket", "body = 'tennis-racket'"),
    ("a pen", "sides = [0.0072, 0.0075, 0.14]\nmass = 0.008"),
    ("a coin", "shape = 'cylinder'\nradius = 0.012\nheight = 0.002\nmass = 0.007"),
    ("a ball", "shape = 'ball'\nradius = 0.11\nmass = 0.43"),
    ("an asteroid", "shape = 'ellipsoid'\nsemiaxes = [620, 500, 384]\nmass = 1e12"),
    ("a larger one", "shape = 'ellipsoid'\nsemiaxes = [6200, 5000, 3840]\nmass = 1e15"),
    ("a space station", "sides = [109, 73, 20]\nmass = 4.2e5"),
    ("numbers alone", "moments = [1, 2, 2.999]"),
    ("a body with a name that is far too long for any line", "sides = [1, 2, 3]\nmass = 1e5"),
];

#[test]
fn no_letters_of_any_body_lie_on_others_or_leave_the_sheet() {
    let mut wrong = Vec::new();
    for (name, text) in BODIES {
        let mut model = BodyModel::from_toml(text, "".as_ref()).unwrap();
        model.name = name.into();
        for figure in registry() {
            if let Some(over) = figure.overlap_for(&model).filter(|over| *over > 1e-6) {
                wrong.push(format!("{}, {name}: {over:.1} square points", figure.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_body_that_never_flips_has_no_figure_of_flips_and_the_refusal_says_why() {
    let coin = BodyModel::from_toml(BODIES[6].1, "".as_ref()).unwrap();
    let refused: Vec<_> = registry()
        .iter()
        .filter_map(|figure| Some((figure.name, figure.draw_for(&coin).err()?.to_string())))
        .filter(|(_, why)| why.contains("never flips"))
        .map(|(name, _)| name)
        .collect();
    assert_eq!(refused, ["wobble-growth", "flip-time", "jacobi"]);
    let fixed = registry().iter().find(|figure| figure.name == "drift").unwrap();
    assert!(fixed.draw_for(&coin).unwrap_err().to_string().contains("not one body"));
}

#[test]
fn a_body_of_its_own_is_seen_to_turn_over_in_the_toss_about_its_middle_axis_alone() {
    let tosses = registry().iter().find(|figure| figure.name == "three-tosses").unwrap();
    for (name, text) in BODIES.iter().filter(|(name, _)| ["a phone", "a hammer", "a racket"].contains(name)) {
        let svg = tosses.draw_for(&BodyModel::from_toml(text, "".as_ref()).unwrap()).unwrap();
        let said = svg.split("-desc\">").nth(1).unwrap().split("</desc>").next().unwrap();
        let turns = ["smallest: ", "largest: ", "middle: "].map(|axis| {
            let seen = said.split(axis).nth(1).unwrap().split([';', '.']).next().unwrap();
            seen.starts_with("dark") && seen.contains("light")
        });
        assert_eq!(turns, [false, false, true], "{name}: {said}");
    }
}

fn page(text: &str) -> String {
    report(&BodyModel::from_toml(text, "".as_ref()).unwrap(), true).unwrap()
}

#[test]
fn the_box_of_the_book_has_the_numbers_of_the_book() {
    let page = page("name = 'a <box>'\nsides = [2, 1, 3]\nmass = 1");
    for held in [
        "How it turns: a &lt;box&gt;",
        "<td>0.833</td><td>0.000</td><td>0.000</td>",
        "<th scope=\"row\">3 largest</th><td>1.083</td>",
        // sqrt((13 - 10) (10 - 5) / (13 * 5)) of the spin: 0.480, so ln(10) / 0.480 / 2π turns.
        "becomes ten times as large in 0.763 turns (763 ms), and 20.5 times in each turn",
        "<strong>unstable, it flips.</strong>",
    ] {
        assert!(page.contains(held), "{held}");
    }
    // It reads nothing from elsewhere: the only address is the name of SVG.
    assert!(page.matches("://").count() == page.matches("http://www.w3.org/2000/svg").count());
    assert!(!page.contains("NaN"));
    // The drawings of the body and of its paths are cropped, the plot is not.
    assert!(page.matches("viewBox=\"0 ").count() == 1 && page.matches("viewBox=").count() == 3);
    // Turned by a right angle, its products are rounding.
    let turned = self::page("turn = [0, 0, 1, 90]\nsides = [2, 1, 3]\nmass = 1");
    assert!(turned.contains("<td>1.083</td><td>0.000</td><td>0.000</td>"));
    let pupils = report(&BodyModel::load("phone").unwrap(), false).unwrap();
    assert!(!pupils.contains("engine") && page.contains("The step that an engine needs"));
}

/// The numbers were computed apart, from Legendre's integral by the arithmetic-geometric mean.
#[test]
fn a_phone_and_a_satellite_have_the_numbers_of_another_computation() {
    let phone = page("sides = [0.077, 0.0078, 0.16]\nmass = 0.2");
    for held in [
        "ten times as large in 0.469 turns (469 ms), and 136 times",
        "circles the axis once in 1.27 turns (1.27 s)",
        "circles the axis once in 1.01 turns (1.01 s)",
        "10⁻¹</th><td>1.40</td><td>1.40</td>",
        "10⁻²</th><td>2.34</td><td>2.34</td>",
        "10⁻⁹</th><td>8.91</td><td>8.91</td>",
        "smallest to largest: 42.90° at 23.6°",
        "smallest to middle: 38.43° at 25.8°",
        "middle to largest: 5.89° at 42.1°",
    ] {
        assert!(phone.contains(held), "{held}");
    }
    let satellite =
        page("moments = [0.0421, 0.0418, 0.0067]\nproducts = [2.1e-4, -3.4e-4, 1.3e-4]\nspin = 0.5");
    for held in [
        "<td>0.00670</td><td>0.010</td>",
        "<td>0.04169</td><td>−0.454</td>",
        "ten times as large in 1.45 turns (18.2 s), and 4.89 times",
        "once in 3.9 turns (49.1 s)",
        "10⁻⁹</th><td>349.8</td><td>27.83</td>",
    ] {
        assert!(satellite.contains(held), "{held}");
    }
}

#[test]
fn a_coin_and_a_ball_never_flip_and_a_body_of_numbers_alone_has_its_page() {
    for text in [
        "shape = 'cylinder'\nradius = 0.012\nheight = 0.002\nmass = 0.007",
        "shape = 'ball'\nradius = 0.1\nmass = 1",
    ] {
        assert!(page(text).contains("It never flips"));
    }
    assert!(page("moments = [1, 2, 2.5]").contains("mass and size not given"));
    assert!(page("moments = [1, 2, 2.5]\nmass = 3").contains("<p>3 kg. Times"));
    // Of a plate (c - a) (c - b) is ab.
    assert!(page("moments = [1, 2, 3]").contains("circles the axis once a turn (1 s)"));
}
