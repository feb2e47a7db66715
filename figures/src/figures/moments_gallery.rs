//! The named bodies, each drawn to a scale of its own, with its three moments as bars.

use super::{Drawing, Picture, edges_of, ink_of};
use crate::draw::{Canvas, Cuboid, Fill, Label, P, Pen, View};
use crate::ink::Ink;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;
use tumbling::body::named::{self, NamedBody};
use tumbling::{Axis, PrincipalAxes};

/// Where one body is drawn.
struct Cell<'a> {
    canvas: &'a Canvas,
    view: View,
}

impl Cell<'_> {
    /// A box from one corner to the opposite one, m.
    fn cuboid(&self, low: [f64; 3], high: [f64; 3]) {
        let (low, high) = (Vector3::from(low), Vector3::from(high));
        let solid = Cuboid { rotation: Matrix3::identity(), half: (high - low) * 0.5 };
        let view = self.view.moved(&((low + high) * 0.5));
        solid.draw(self.canvas, &view, None, Pen::new(Ink::Text, 1.1));
    }

    /// A round bar from one point to another, as thick as it is.
    fn bar(&self, from: [f64; 3], to: [f64; 3], radius: f64) {
        let [a, b] = [from, to].map(|p| self.view.at(&p.into()));
        let wide = 2.0 * radius * self.view.scale();
        self.canvas.line(a, b, Pen::new(Ink::Text, wide + 2.0));
        self.canvas.line(a, b, Pen::new(Ink::Surface, wide));
    }

    fn line(&self, points: impl IntoIterator<Item = [f64; 3]>, width: f64) {
        let points: Vec<P> = points.into_iter().map(|p| self.view.at(&p.into())).collect();
        self.canvas.path(&points, Pen::new(Ink::Text, width));
    }
}

/// How a body that is no box is drawn: points to the metre, what of it falls at the middle of its cell, and its
/// shape, with the sizes that [`bodies`] gives it.
type Shape = (f64, [f64; 3], fn(&Cell<'_>));

fn shape(name: &str) -> Option<Shape> {
    Some(match name {
        "the hammer" => (310.0, [0.0, 0.0, 0.16], |c| {
            c.bar([0.0, 0.0, 0.014], [0.0, 0.0, 0.28], 0.0145);
            c.cuboid([-0.05, -0.016, 0.29], [0.05, 0.016, 0.322]);
        }),
        "the tennis racket" => (150.0, [0.0, 0.0, 0.34], racket),
        "the wing nut" => (2300.0, [0.008, 0.0, 0.0], wing_nut),
        "the T-handle" => (880.0, [0.02, 0.0, 0.0], |c| {
            c.bar([0.05, 0.0, 0.0], [0.006, 0.0, 0.0], 0.006);
            c.bar([0.0, 0.0, -0.044], [0.0, 0.0, 0.044], 0.006);
        }),
        _ => return None,
    })
}

fn racket(c: &Cell<'_>) {
    let (wide, long, middle) = (0.122, 0.165, 0.520);
    for i in -4..=4 {
        let at = 0.2 * f64::from(i);
        let half = (1.0 - at * at).sqrt();
        c.line([-half, half].map(|s| [wide * at, 0.0, middle + long * s]), 0.5);
        c.line([-half, half].map(|s| [wide * s, 0.0, middle + long * at]), 0.5);
    }
    let hoop = (0..=72).map(|i| {
        let (s, c) = (TAU * f64::from(i) / 72.0).sin_cos();
        [wide * c, 0.0, middle + long * s]
    });
    c.line(hoop, 3.0);
    for side in [-1.0, 1.0] {
        c.line([[side * 0.012, 0.0, 0.190], [side * 0.080, 0.0, 0.395]], 3.0);
    }
    c.cuboid([-0.017, -0.0145, 0.0], [0.017, 0.0145, 0.190]);
}

fn wing_nut(c: &Cell<'_>) {
    let (radius, hole, height) = (0.00825, 0.0045, 0.0068);
    let ring = |r: f64, x: f64| -> Vec<P> {
        (0..48)
            .map(|i| {
                let (s, cos) = (TAU * f64::from(i) / 48.0).sin_cos();
                c.view.at(&Vector3::new(x, r * cos, r * s))
            })
            .collect()
    };
    let edge = Some(Pen::new(Ink::Text, 1.1));
    c.cuboid([0.0059, -0.00165, -0.0181], [0.0177, 0.00165, -radius]);
    for i in 0..=12 {
        let outline = if i == 0 || i == 12 { edge } else { None };
        c.canvas.area(&ring(radius, height * f64::from(i) / 12.0), Fill::new(Ink::Surface), outline);
    }
    c.canvas.area(&ring(hole, height), Fill::new(Ink::Text).opacity(0.5), edge);
    c.cuboid([0.0059, -0.00165, radius], [0.0177, 0.00165, 0.0181]);
}

fn bars(canvas: &Canvas, left: f64, top: f64, principal: &PrincipalAxes) {
    let most = principal.moment(Axis::Largest);
    for (i, axis) in [Axis::Smallest, Axis::Middle, Axis::Largest].into_iter().enumerate() {
        #[allow(clippy::cast_precision_loss)]
        let y = top + 25.0 * i as f64;
        let moment = principal.moment(axis);
        let length = 88.0 * moment / most;
        let corners = [(left, y), (left + length, y), (left + length, y + 14.0), (left, y + 14.0)];
        canvas.area(&corners, Fill::new(ink_of(axis)), None);
        canvas.label(
            (left - 7.0, y + 13.0),
            &Label::new(format!("$I_{}$", i + 1)).size(15.5).ink(ink_of(axis)).end(),
        );
        canvas.label((left + length + 6.0, y + 12.5), &Label::new(plain(moment)).size(14.5));
    }
}

/// Three figures, and a power of ten where the number would be long.
fn plain(moment: f64) -> String {
    if moment > 0.1 {
        return format!("{moment:.3}");
    }
    #[allow(clippy::cast_possible_truncation)]
    let thirds = (moment.log10() / 3.0).floor() as i32;
    let mantissa = moment / 1000_f64.powi(thirds);
    format!(
        "{mantissa:.*}·{}",
        if mantissa < 10.0 {
            2
        } else if mantissa < 100.0 {
            1
        } else {
            0
        },
        super::power_of_ten(3 * thirds)
    )
}

pub(super) fn draw() -> Drawing {
    let canvas = Canvas::new(610);
    let mut said = Vec::new();
    canvas.label((20.0, 26.0), &Label::new("principal moments (kg m²), each body to its own scale"));
    for (i, body) in named::all().iter().enumerate() {
        #[allow(clippy::cast_precision_loss)]
        let (x, y) = (20.0 + 335.0 * (i % 2) as f64, 50.0 + 140.0 * (i / 2) as f64);
        said.push(one(&canvas, (x, y), body)?);
    }
    Ok(Picture {
        canvas,
        description: format!(
            "Eight bodies and their principal moments in kg m², smallest, middle and largest, as three bars beside a drawing of each. {}.",
            said.join("; ")
        ),
    })
}

/// One body in its cell; returns its words.
fn one(canvas: &Canvas, corner: P, body: &NamedBody) -> Result<String, Box<dyn std::error::Error>> {
    let properties = body.properties()?;
    let principal = properties.inertia().principal();
    let centre = (corner.0 + 52.0, corner.1 + 62.0);
    let view = |scale| View::new(centre, scale, -58.0, 20.0);
    if let Some((scale, middle, shape)) = shape(body.name()) {
        shape(&Cell { canvas, view: view(scale).moved_back(&middle.into()) });
    } else {
        let half = edges_of(&properties) * 0.5;
        Cell { canvas, view: view(48.0 / half.z) }.cuboid((-half).into(), half.into());
    }
    let name = body.name().trim_start_matches("the ");
    canvas.label((corner.0 + 128.0, corner.1 + 22.0), &Label::new(name));
    bars(canvas, corner.0 + 128.0, corner.1 + 34.0, &principal);
    let [a, b, c] = [Axis::Smallest, Axis::Middle, Axis::Largest].map(|axis| principal.moment(axis));
    Ok(format!("{name}: {a:.3e}, {b:.3e}, {c:.3e}"))
}
