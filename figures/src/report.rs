//! A page about one body: its axes and moments, which spin flips and when, and the step that an engine needs.

mod engine;
mod style;

use crate::draw::escaped;
use crate::of_body::{Kind, NAMES, Subject, gaps, moments, polhodes};
use crate::picture::{Picture, raised, with_powers};
use crate::{ink, units};
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use tumbling::Axis;
use tumbling::dynamics::stability::{Stability, of_spin};
use tumbling_bodies::BodyModel;

/// A complete HTML page about a body, with its drawings inside, for a screen and for one sheet of A4; on
/// request with the step that an engine needs.
///
/// # Errors
/// What the library or the drawing backend reported.
pub fn report(body: &BodyModel, engine: bool) -> Result<String, Box<dyn Error>> {
    let subject = Subject::new(body)?;
    let name = escaped(&body.name);
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>How it turns: {name}</title>\n<style>{}{}</style>\n\
         </head>\n<body>\n<main>\n<h1>How it turns: {name}</h1>\n",
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
            "<p>A tensor as given is that of no body; the nearest possible one is taken, {} of its largest moment away.</p>",
            units::number(body.moved, 2)
        );
    }
    // Each with the rows of its sheet that may be shown: the page has the names and moments beside them.
    let pictures = [
        ("body", "The body and its principal axes", moments::draw(&subject)?, [520, 4680]),
        ("polhodes", "The paths that its spin can take", polhodes::draw(&subject)?, [340, 4420]),
        ("gap", "The gap between spin and momentum", gaps::draw(&subject)?, [340, 4460]),
    ];
    let mut drawn = pictures.into_iter().map(|(name, title, Picture { canvas, description }, rows)| {
        let [left, top, wide, high] = if name == "gap" { [0, 340, 5000, 4120] } else { canvas.view(rows) };
        let svg = canvas.finish(name, title, &with_powers(&description));
        let (head, rest) = svg.split_once("viewBox=\"0 0 ").unwrap_or((&svg, ""));
        let rest = rest.split_once('"').map_or("", |(_, rest)| rest);
        format!("<figure>{head}viewBox=\"{left} {top} {wide} {high}\"{rest}</figure>\n")
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
        "<section><h2>Tensor and axes</h2>\n<table><caption>Inertia tensor in its own axes, {unit}</caption>\n\
         <tr><td></td><th scope=\"col\">x</th><th scope=\"col\">y</th><th scope=\"col\">z</th></tr>\n"
    );
    for (axis, entries) in ["x", "y", "z"].into_iter().zip(entries.chunks(3)) {
        out += &row(axis, entries);
    }
    let (written, unit) = units::moments(subject.moments.vector().as_slice());
    let _ = writeln!(
        out,
        "</table>\n<table><caption>Principal moments, {unit}, and the directions of their axes</caption>\n\
         <tr><td></td><th scope=\"col\">moment</th><th scope=\"col\">x</th><th scope=\"col\">y</th><th scope=\"col\">z</th></tr>"
    );
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
                    units::TIME.say(10_f64.ln() / rate),
                    units::number(each, 3)
                )
            }
            Stability::Libration { rate } => {
                let turns = format!("in {} turns", units::number(subject.spin / rate, 3));
                let turns = if turns == "in 1 turns" { "a turn".into() } else { turns };
                let time = units::TIME.say(TAU / rate);
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
        out += "<p>It never flips: at least two of its principal moments are equal.</p></section>\n";
        return Ok(out);
    }
    let times: Result<Vec<_>, _> = (1..=9).map(|n| subject.flip_time(10_f64.powi(-n))).collect();
    let times = times?;
    let (second, unit) = units::TIME.of(times[0]);
    let [turns, times] = [TAU / subject.spin, second].map(|unit| units::column(&times, unit));
    let _ = writeln!(
        out,
        "<table><caption>Spun about axis 2 with a slip about axis 3</caption>\n<tr><th scope=\"col\">slip, as a part of the spin</th>\
         <th scope=\"col\">time between flips, {unit}</th><th scope=\"col\">turns</th></tr>"
    );
    for (exponent, cells) in (1..).zip(times.into_iter().zip(turns)) {
        out += &row(&raised(-exponent), &<[String; 2]>::from(cells));
    }
    out += "</table>\n";
    Ok(out + "</section>\n")
}
