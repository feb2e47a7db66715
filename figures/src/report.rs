//! One page on one body: what it is, which spin flips and how fast, and the step that an engine needs.

mod engine;
mod style;

use crate::draw::escaped;
use crate::of_body::{Kind, NAMES, Subject, gaps, moments, polhodes};
use crate::picture::{raised, with_powers};
use crate::units;
use crate::{ink, picture};
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use tumbling::Axis;
use tumbling::dynamics::stability::{Stability, of_spin};
use tumbling_bodies::BodyModel;

/// A complete HTML page on a body, with its drawings inside, for a screen and for one sheet of A4; with the
/// step that an engine needs, if that is meant too.
///
/// # Errors
/// What the library or the drawing backend reported.
pub fn report(body: &BodyModel, engine: bool) -> Result<String, Box<dyn Error>> {
    let subject = Subject::new(body)?;
    let name = escaped(&body.name);
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>How {name} turns</title>\n<style>{}{}</style>\n\
         </head>\n<body>\n<main>\n<h1>How {name} turns</h1>\n",
        ink::style_of(":root"),
        style::PAGE
    );
    let _ = writeln!(
        page,
        "<p>{}. Times are for a spin of {}; at twice the spin each is half as long. The axes are numbered by their moments: \
         1 the smallest, 2 the middle, 3 the largest.</p>",
        escaped(&subject.sizes()),
        units::turning(subject.spin)
    );
    if body.moved > 0.0 {
        let _ = writeln!(
            page,
            "<p>The tensor as given is that of no body; the nearest possible one is taken, {} of the largest moment away.</p>",
            units::number(body.moved, 2)
        );
    }
    // Each with the rows of its sheet that are shown: the page has the names and moments beside them.
    let pictures = [
        ("body", "The body and its principal axes", moments::draw(&subject)?, "520 5000 4160"),
        ("polhodes", "The paths that its spin can take", polhodes::draw(&subject)?, "340 5000 4080"),
        ("gap", "The gap between spin and momentum", gaps::draw(&subject)?, "340 5000 4120"),
    ];
    let mut drawn = pictures.into_iter().map(|(name, title, picture, rows)| {
        let picture::Picture { canvas, description } = picture;
        let svg = canvas.finish(name, title, &with_powers(&description));
        let (head, rest) = svg.split_once("viewBox=\"0 0 ").unwrap_or((&svg, ""));
        let rest = rest.split_once('"').map_or("", |(_, rest)| rest);
        format!("<figure>{head}viewBox=\"0 {rows}\"{rest}</figure>\n")
    });
    let two: String = drawn.by_ref().take(2).collect();
    let numbers = tensor(&subject) + &stability(&subject)?;
    let pairs = [two, numbers, drawn.collect::<String>() + &flips(&subject)?];
    page.extend(pairs.map(|pair| format!("<div class=\"pair\">\n{pair}</div>\n")));
    page += &if engine { engine::section(&subject)? } else { String::new() };
    page += "</main>\n</body>\n</html>\n";
    Ok(page)
}

/// A row of a table.
fn row(head: &str, cells: &[String]) -> String {
    let cells: String = cells.iter().map(|cell| format!("<td>{cell}</td>")).collect();
    format!("<tr><th scope=\"row\">{head}</th>{cells}</tr>\n")
}

/// The tensor in the body's axes, the moments and where their axes point.
fn tensor(subject: &Subject<'_>) -> String {
    let matrix = subject.model.inertia.matrix();
    let matrix = matrix.map(|x| if x.abs() < 1e-15 * matrix.amax() { 0.0 } else { x }); // but rounding
    let (entries, unit) = units::moments(matrix.transpose().as_slice());
    let mut out = format!(
        "<section><h2>Tensor and axes</h2>\n<table><caption>Inertia tensor in its own axes, {unit}</caption>\n"
    );
    out += "<tr><td></td><th scope=\"col\">x</th><th scope=\"col\">y</th><th scope=\"col\">z</th></tr>\n";
    for (axis, entries) in ["x", "y", "z"].into_iter().zip(entries.chunks(3)) {
        out += &row(axis, entries);
    }
    let (written, unit) = units::moments(subject.moments.vector().as_slice());
    let _ = writeln!(
        out,
        "</table>\n<table><caption>Principal moments, {unit}, and the directions of their axes</caption>"
    );
    out += "<tr><td></td><th scope=\"col\">moment</th><th scope=\"col\">x</th><th scope=\"col\">y</th><th scope=\"col\">z</th></tr>\n";
    for k in 0..3 {
        let along = subject.frame.column(k).into_owned();
        let direction = along.iter().map(|x| format!("{x:.3}").replace("-0.000", "0.000").replace('-', "−"));
        let cells: Vec<String> = std::iter::once(written[k].clone()).chain(direction).collect();
        out += &row(&format!("{} {}", k + 1, NAMES[k]), &cells);
    }
    out += "</table>\n";
    let centre = subject.model.centre;
    if centre != Vector3::zeros() {
        let at = units::place(&centre);
        let _ = writeln!(out, "<p>Its centre of mass is at {at} from the origin of these axes.</p>");
    }
    out + "</section>\n"
}

/// About which axis spin flips, and how fast a slip grows.
fn stability(subject: &Subject<'_>) -> Result<String, Box<dyn Error>> {
    let mut out = String::from("<section><h2>Which spin flips</h2>\n<ul>\n");
    for axis in Axis::ALL {
        let fate = match of_spin(subject.moments, axis, subject.spin)? {
            Stability::Growth { rate } => {
                let each = (TAU * rate / subject.spin).exp();
                format!(
                    "<strong>unstable, it flips.</strong> A slip becomes ten times as large in {} turns ({}), and {} times in each turn.",
                    units::number(10_f64.ln() * subject.spin / (rate * TAU), 3),
                    units::time(10_f64.ln() / rate),
                    units::number(each, 3)
                )
            }
            Stability::Libration { rate } => {
                let turns = format!("in {} turns", units::number(subject.spin / rate, 3));
                let turns = if turns == "in 1 turns" { "a turn".into() } else { turns };
                let time = units::time(TAU / rate);
                format!(
                    "stable. After a slip the spin circles the axis once {turns} ({time}), and stays as near."
                )
            }
            _ => "one of the equal moments. A slip neither grows nor circles.".into(),
        };
        let _ =
            writeln!(out, "<li>Axis {}, the {} moment: {fate}</li>", axis as usize + 1, NAMES[axis as usize]);
    }
    out += "</ul>\n";
    out += match subject.kind {
        Kind::Three => {
            "<p>With friction inside, and no torque, the spin ends about axis 3: the least energy for its momentum.</p>\n"
        }
        Kind::Round(_) => {
            "<p>Two moments are equal: the spin circles the third axis evenly, and no spin flips.</p>\n"
        }
        Kind::Ball => "<p>All moments are equal: every spin stays as it is.</p>\n",
    };
    Ok(out + "</section>\n")
}

/// The time between flips for pushes of 1e-1 to 1e-9.
fn flips(subject: &Subject<'_>) -> Result<String, Box<dyn Error>> {
    let mut out = String::from("<section><h2>Time between flips</h2>\n");
    if subject.kind != Kind::Three {
        return Ok(
            out + "<p>It never flips: at least two of its principal moments are equal.</p></section>\n"
        );
    }
    out += "<table><caption>Spun about axis 2 with a slip about axis 3</caption>\n<tr><th scope=\"col\">slip, as a part of the spin</th>\
            <th scope=\"col\">time between flips</th><th scope=\"col\">turns</th></tr>\n";
    for exponent in 1..=9 {
        let time = subject.flip_time(10_f64.powi(-exponent))?;
        let turns = units::number(time * subject.spin / TAU, 3);
        out += &row(&raised(-exponent), &[units::time(time), turns]);
    }
    out += "</table>\n";
    Ok(out + "</section>\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(text: &str) -> String {
        report(&BodyModel::from_toml(text, "".as_ref()).unwrap(), true).unwrap()
    }

    #[test]
    fn the_box_of_the_book_has_the_numbers_of_the_book() {
        let page = page("name = 'a <box>'\nsides = [2, 1, 3]\nmass = 1");
        for held in [
            "How a &lt;box&gt; turns",
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
            "10⁻¹</th><td>1.4 s</td><td>1.4</td>",
            "10⁻²</th><td>2.34 s</td><td>2.34</td>",
            "10⁻⁹</th><td>8.91 s</td><td>8.91</td>",
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
            "10⁻⁹</th><td>5.83 min</td><td>27.8</td>",
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
        // Of a plate (c - a) (c - b) is ab.
        assert!(page("moments = [1, 2, 3]").contains("circles the axis once a turn (1 s)"));
    }
}
