use crate::{Figure, registry};
use tumbling_bodies::BodyModel;

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

fn drawn(figure: &Figure, model: &BodyModel) -> Option<crate::picture::Picture> {
    figure.picture_of(model).ok().and_then(Result::ok)
}

#[test]
fn no_letters_of_any_body_lie_on_others_or_leave_the_sheet() {
    let mut wrong = Vec::new();
    for (name, text) in BODIES {
        let mut model = BodyModel::from_toml(text, "".as_ref()).unwrap();
        model.name = name.into();
        for figure in registry() {
            let Some(picture) = drawn(figure, &model) else { continue };
            for (place, area) in picture.canvas.collisions() {
                wrong.push(format!("{}, {name}: {area:.1} square points at {place:?}", figure.name));
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
        let said = drawn(tosses, &BodyModel::from_toml(text, "".as_ref()).unwrap()).unwrap().description;
        let turns = ["smallest: ", "largest: ", "middle: "].map(|axis| {
            let seen = said.split(axis).nth(1).unwrap().split([';', '.']).next().unwrap();
            seen.starts_with("dark") && seen.contains("light")
        });
        assert_eq!(turns, [false, false, true], "{name}: {said}");
    }
}
