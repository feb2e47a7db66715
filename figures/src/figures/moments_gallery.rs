//! The named bodies, each drawn to a scale of its own, with its three moments as bars.

use super::{Drawing, ink_of};
use crate::draw::{Canvas, Cuboid, Fill, Ink, Label, P, Pen, View};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;
use tumbling::body::named::{NamedBody, Part, Section};
use tumbling::{Axis, PrincipalAxes};

/// Where one body is drawn.
struct Cell<'a> {
    canvas: &'a Canvas,
    view: View,
}

/// The two ends of a part, m.
fn ends(part: &Part) -> [Vector3<f64>; 2] {
    [part.middle - 0.5 * part.along, part.middle + 0.5 * part.along]
}

impl Cell<'_> {
    /// Parts with faces, from far to near, in front of parts that are drawn as lines.
    fn body(&self, mut parts: Vec<Part>) {
        for name in ["main string", "cross string"] {
            // Every second one: all of them would be a grey patch.
            for string in parts.iter().filter(|part| part.name == name).step_by(2) {
                self.line(ends(string), 0.5);
            }
        }
        self.line(parts.iter().filter(|part| part.name == "hoop").flat_map(ends), 3.0);
        for bar in parts.iter().filter(|part| part.name == "throat bar") {
            self.line(ends(bar), 3.0);
        }
        parts.sort_by(|a, b| a.middle.z.total_cmp(&b.middle.z).then(b.middle.x.total_cmp(&a.middle.x)));
        for part in &parts {
            match part.section {
                Section::Line => {}
                Section::Rectangle { wide, thick } => {
                    self.cuboid(&part.middle, 0.5 * Vector3::new(wide, thick, part.along.norm()));
                }
                Section::Round { radius } => self.round(part, radius),
                Section::Ring { inner, outer } => self.tube(part, inner, outer),
            }
        }
    }

    /// A box about `middle` with these half edges, m.
    fn cuboid(&self, middle: &Vector3<f64>, half: Vector3<f64>) {
        let solid = Cuboid { rotation: Matrix3::identity(), half };
        solid.draw(self.canvas, &self.view.moved(middle), None, Pen::new(Ink::Text, 1.1));
    }

    /// A round bar, as thick as it is; its pen rounds the ends.
    fn round(&self, part: &Part, radius: f64) {
        let [from, to] = ends(part);
        let rounded = part.along * (radius / part.along.norm());
        let [a, b] = [from + rounded, to - rounded].map(|p| self.view.at(&p));
        let wide = 2.0 * radius * self.view.scale();
        self.canvas.line(a, b, Pen::new(Ink::Text, wide + 2.0));
        self.canvas.line(a, b, Pen::new(Ink::Surface, wide));
    }

    /// A tube along x, seen from its far end.
    fn tube(&self, part: &Part, inner: f64, outer: f64) {
        let [from, to] = ends(part);
        let ring = |radius: f64, x: f64| -> Vec<P> {
            (0..48)
                .map(|i| {
                    let (sin, cos) = (TAU * f64::from(i) / 48.0).sin_cos();
                    self.view.at(&Vector3::new(x, radius * cos, radius * sin))
                })
                .collect()
        };
        let edge = Some(Pen::new(Ink::Text, 1.1));
        for i in 0..=12 {
            let outline = if i == 0 || i == 12 { edge } else { None };
            let x = from.x + (to.x - from.x) * f64::from(i) / 12.0;
            self.canvas.area(&ring(outer, x), Fill::new(Ink::Surface), outline);
        }
        self.canvas.area(&ring(inner, to.x), Fill::new(Ink::Text).opacity(0.5), edge);
    }

    fn line(&self, points: impl IntoIterator<Item = Vector3<f64>>, width: f64) {
        let points: Vec<P> = points.into_iter().map(|p| self.view.at(&p)).collect();
        self.canvas.path(&points, Pen::new(Ink::Text, width));
    }
}

/// The position of a body that is not a box: the scale in points per metre, and its point at the middle of
/// the cell.
fn placed(name: &str) -> Option<(f64, [f64; 3])> {
    Some(match name {
        "the hammer" => (310.0, [0.0, 0.0, 0.16]),
        "the tennis racket" => (150.0, [0.0, 0.0, 0.34]),
        "the wing nut" => (2300.0, [0.008, 0.0, 0.0]),
        "the T-handle" => (880.0, [0.02, 0.0, 0.0]),
        _ => return None,
    })
}

/// A unit in which all of a body's moments are short numbers, and how many of it are a kg m².
fn unit(largest: f64) -> (&'static str, f64) {
    match largest {
        x if x >= 0.1 => ("kg m²", 1.0),
        x if x >= 1e-4 => ("kg cm²", 1e4),
        _ => ("g cm²", 1e7),
    }
}

fn bars(canvas: &Canvas, left: f64, top: f64, principal: &PrincipalAxes) {
    let most = principal.moment(Axis::Largest);
    let (_, per) = unit(most);
    for (i, axis) in Axis::ALL.into_iter().enumerate() {
        let y = top + 25.0 * i as f64;
        let moment = principal.moment(axis);
        let length = 200.0 * moment / most;
        canvas.tiles(&[[left, y, left + length, y + 14.0]], Fill::new(ink_of(axis)), None);
        canvas.label((left - 7.0, y + 13.0), &Label::new(format!("$I_{}$", i + 1)).ink(ink_of(axis)).end());
        canvas.label((left + length + 6.0, y + 13.0), &Label::new(three_digits(moment * per)));
    }
}

/// Three figures.
fn three_digits(x: f64) -> String {
    let whole = x.log10().floor().max(0.0) as usize;
    format!("{x:.*}", if x < 1.0 { 3 } else { 2_usize.saturating_sub(whole) })
}

pub(super) fn draw() -> Drawing {
    let canvas = Canvas::sized(500, 922);
    let mut said = Vec::new();
    for (i, body) in NamedBody::ALL.into_iter().enumerate() {
        said.push(one(&canvas, (14.0, 14.0 + 114.0 * i as f64), body)?);
    }
    canvas.described(format!(
        "Eight bodies and their principal moments in kg m², smallest, middle and largest, as three bars beside a drawing of each. {}.",
        said.join("; ")
    ))
}

/// One body in its cell; returns its words.
fn one(canvas: &Canvas, corner: P, body: NamedBody) -> Result<String, Box<dyn std::error::Error>> {
    let principal = body.properties()?.inertia().principal();
    let view = |scale| View::new((corner.0 + 62.0, corner.1 + 54.0), scale, -58.0, 20.0);
    let (mut parts, full_name) = (Vec::new(), body.to_string());
    body.each_part(&mut |part| parts.push(part));
    let longest = parts.iter().map(|part: &Part| part.along.norm()).fold(0.0, f64::max);
    let (scale, middle) = placed(&full_name).unwrap_or((96.0 / longest, [0.0; 3]));
    Cell { canvas, view: view(scale).moved_back(&middle.into()) }.body(parts);
    let name = full_name.trim_start_matches("the ");
    let (unit, _) = unit(principal.moment(Axis::Largest));
    canvas.label((corner.0 + 140.0, corner.1 + 20.0), &Label::new(format!("{name} ({unit})")));
    bars(canvas, corner.0 + 168.0, corner.1 + 30.0, &principal);
    let [a, b, c] = [Axis::Smallest, Axis::Middle, Axis::Largest].map(|axis| principal.moment(axis));
    Ok(format!("{name}: {a:.3e}, {b:.3e}, {c:.3e}"))
}
