use super::{BOX_EDGES, Drawing, document_box, ink_of};
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, Plot};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use tumbling::{Axis, Error, Inertia};

/// The box's tensor in world axes after a turn about z.
fn world(inertia: &Inertia, degrees: f64) -> Result<Matrix3<f64>, Error> {
    Ok(inertia.turned(UnitQuaternion::from_axis_angle(&Vector3::z_axis(), degrees.to_radians()))?.matrix())
}

pub(super) fn draw() -> Drawing {
    let inertia = document_box()?;
    let canvas = Canvas::sized(500, 530);
    let plot = Plot::new(&canvas, [52.0, 176.0, 440.0, 456.0], 0.0..180.0, -0.32..1.2);
    plot.x_axis((0..=4).map(|i| (f64::from(45 * i), format!("{}°", 45 * i))), "turn of the box about $z$");
    plot.y_axis([0.0, 0.5, 1.0].map(|y| (y, format!("{y:.1}"))), "");
    canvas.label((14.0, 150.0), &Label::new("entries of the world’s tensor $R I R^T$ (kg m²)"));
    for i in 0..=4 {
        picture(&canvas, (plot.at(45.0 * f64::from(i), 0.0).0, 64.0), 45.0 * f64::from(i));
    }
    let ink = |width: f64| Pen::new(Ink::Text, width);
    let entries = [
        ((0, 0), "xx", ink(2.6)),
        ((1, 1), "yy", ink(2.6).dashed()),
        ((0, 1), "xy", ink(2.6).dotted()),
        ((2, 2), "zz", Pen::new(ink_of(Axis::Smallest), 2.2).dash_dotted()),
    ];
    for (entry, name, pen) in entries {
        let points: Result<Vec<_>, Error> =
            (0..=180).map(f64::from).map(|d| Ok((d, world(&inertia, d)?[entry]))).collect();
        let points = points?;
        let (_, last) = points[180];
        let end = plot.at(180.0, last);
        plot.curve(points, pen)?;
        let text = format!("$I_{{{name}}}$");
        canvas.label((end.0 + 10.0, end.1 + 5.0), &Label::new(text).ink(pen.ink()));
    }
    let at_45 = world(&inertia, 45.0)?;
    let mark =
        |degrees: f64, value: f64, down: f64, text: String| -> Result<(), Box<dyn std::error::Error>> {
            plot.dots([(degrees, value)], 4.0, Ink::Text)?;
            let p = plot.at(degrees, value);
            canvas.label((p.0, p.1 + down), &Label::new(text).middle().size(15.5));
            Ok(())
        };
    mark(45.0, at_45[(0, 0)], 24.0, format!("{:.3}", at_45[(0, 0)]))?;
    mark(45.0, at_45[(0, 1)], 24.0, format!("−{:.3}", at_45[(0, 1)].abs()))?;
    let [start, quarter] = [world(&inertia, 0.0)?, world(&inertia, 90.0)?];
    canvas.described(format!(
        "The box seen along z at five attitudes, turned by 0°, 45°, 90°, 135° and 180° about z, and below them the entries of its \
         tensor in world axes. Ixx goes from {:.3} to {:.3} and back, Iyy the other way, both {:.3} at 45°, where the product Ixy \
         is −{:.3} kg m²; Izz stays {:.3}. After half a turn all are as at the start. The tensor in the body's own axes never \
         changes.",
        start[(0, 0)],
        quarter[(0, 0)],
        at_45[(0, 0)],
        at_45[(0, 1)].abs(),
        start[(2, 2)]
    ))
}

/// The box from above, with its own two axes.
fn picture(canvas: &Canvas, centre: P, degrees: f64) {
    let (s, c) = degrees.to_radians().sin_cos();
    let turned = |x: f64, y: f64| (centre.0 + x * c - y * s, centre.1 - (x * s + y * c));
    let (a, b) = (BOX_EDGES[0] * 17.0, BOX_EDGES[1] * 17.0);
    let corners = [turned(-a, -b), turned(a, -b), turned(a, b), turned(-a, b)];
    canvas.area(&corners, Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.3)));
    for (axis, tip, word, name) in [
        (Axis::Middle, turned(a + 12.0, 0.0), turned(a - 9.0, -9.0), "$x$"),
        (Axis::Largest, turned(0.0, b + 15.0), turned(11.0, b - 4.0), "$y$"),
    ] {
        canvas.arrow(centre, tip, Pen::new(ink_of(axis), 2.0));
        canvas.label((word.0, word.1 + 5.0), &Label::new(name).ink(ink_of(axis)).middle().size(15.5));
    }
}
