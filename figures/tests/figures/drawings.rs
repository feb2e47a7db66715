//! What every figure of the book owes its readers.

use crate::DRAWN;
use std::path::Path;
use tumbling_figures::registry;

#[test]
fn every_committed_figure_is_what_would_be_drawn_today() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let committed =
        |name: &str| std::fs::read_to_string(folder.join(format!("{name}.svg"))).unwrap_or_default();
    let stale: Vec<_> =
        DRAWN.iter().filter(|(name, svg)| **svg != committed(name)).map(|(name, _)| *name).collect();
    let names = stale.join(" ");
    assert!(stale.is_empty(), "redraw these with `cargo run -- figures {names}` and look at them");
}

#[test]
fn names_are_unique_and_fit_for_files() {
    for (i, figure) in registry().iter().enumerate() {
        assert!(figure.name.bytes().all(|b| b.is_ascii_lowercase() || b == b'-'), "{}", figure.name);
        assert!(registry()[..i].iter().all(|other| other.name != figure.name), "{} twice", figure.name);
    }
}

#[test]
fn a_figure_says_what_it_shows_and_takes_its_colours_from_the_page() {
    for figure in registry() {
        let svg = &DRAWN[figure.name];
        let name = figure.name;
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{name}");
        for part in [
            format!("role=\"img\" aria-labelledby=\"{name}-title {name}-desc\""),
            format!("<title id=\"{name}-title\">{}</title>", figure.shows),
            format!("<desc id=\"{name}-desc\">"),
            "viewBox=\"0 0 ".into(),
        ] {
            assert!(svg.contains(&part), "{name} lacks {part}");
        }
        let described = svg.split("-desc\">").nth(1).and_then(|rest| rest.split("</desc>").next()).unwrap();
        assert!((80..1200).contains(&described.len()), "{name} is described in {} bytes", described.len());
        for id in svg.split(" id=\"").skip(1) {
            assert!(id.starts_with(&format!("{name}-")), "{name} has an id not its own");
        }
        // Outside its own style sheet, which holds only when it stands alone, every colour has a name.
        let (head, marks) = svg.split_once("</style>").unwrap();
        assert!(head.contains("<style>svg:root{"), "{name}");
        for (at, _) in marks.match_indices('#') {
            let before = &marks[..at];
            assert!(before.rfind("var(--fig-") > before.rfind(')'), "{name}: a fixed colour");
        }
        assert!(!marks.contains("NaN") && !marks.contains("inf"), "{name}");
        // It loads nothing and runs nothing.
        for outside in ["<script", "<image", "<foreignObject", "href", "http"] {
            assert!(!marks.contains(outside), "{name} contains `{outside}`");
        }
        assert!(svg.len() < 80_000, "{name} has {} bytes", svg.len());
    }
}

#[test]
fn nothing_is_drawn_outside_the_sheet() {
    for figure in registry() {
        let svg = &DRAWN[figure.name];
        let size = svg.split("viewBox=\"0 0 ").nth(1).and_then(|rest| rest.split('"').next()).unwrap();
        let (w, h) = size.split_once(' ').unwrap();
        let (w, h): (i64, i64) = (w.parse().unwrap(), h.parse().unwrap());
        let inside = |x: i64, y: i64| (0..=w).contains(&x) && (0..=h).contains(&y);
        for path in svg.split(" d=\"M").skip(1) {
            // Many crosses may stand in one path, each with a start of its own.
            for part in path.split(['"', 'z']).next().unwrap().split('M') {
                let data = part.replace('-', " -").replace('l', " ");
                let numbers: Vec<i64> = data.split_whitespace().map(|n| n.parse().unwrap()).collect();
                let (mut x, mut y) = (numbers[0], numbers[1]);
                assert!(inside(x, y), "{}: {x} {y}", figure.name);
                for step in numbers[2..].chunks(2) {
                    (x, y) = (x + step[0], y + step[1]);
                    assert!(inside(x, y), "{}: {x} {y}", figure.name);
                }
            }
        }
    }
}

#[test]
fn the_worked_example_is_described_by_its_known_numbers() {
    // From the box's edges 2, 1, 3: 10/12, 13/12, 5/12; atan(13/10) = 52.43 degrees.
    for (name, numbers) in
        [("box-moments", ["0.833 ", "1.083 ", "0.417 "]), ("box-arrows", [" 45° ", " 52.4°", " 7.4°"])]
    {
        let svg = &DRAWN[name];
        let described = svg.split("</desc>").next().unwrap();
        for number in numbers {
            assert!(described.contains(number), "{name}: {number}");
        }
    }
}
