use super::{Drawing, Picture};
use crate::draw::{Canvas, Cuboid, Fill, Label, Pen, View};
use crate::ink::Ink;
use crate::motion;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::TAU;
use tumbling::observe::sign_changes;
use tumbling::{Body, Inertia};

/// A book: width, height, thickness, m.
const BOOK: [f64; 3] = [0.17, 0.24, 0.035];

/// The push, rad; the spin is a turn a second.
const PUSH: f64 = 0.05;

/// Upright, its front cover to the viewer, the momentum to the right.
const STANDING: Matrix3<f64> = Matrix3::new(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0);

fn book(canvas: &Canvas, view: &View, rotation: Matrix3<f64>) {
    let solid = Cuboid { rotation, half: Vector3::from(BOOK.map(|x| 0.5 * x)) };
    let edge = Pen::new(Ink::Text, 1.2);
    let on_cover = |points: [(f64, f64); 4]| points.map(|(x, y)| view.at(&solid.point(x, y, 1.0)));
    for (axis, sign) in [(0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0), (2, -1.0), (2, 1.0)] {
        if !solid.faces(view, axis, sign) {
            continue;
        }
        let corners = solid.face(axis, sign).map(|p| view.at(&p));
        canvas.area(&corners, Fill::new(Ink::Paper), None);
        match (axis, sign > 0.0) {
            // The front cover, with its title.
            (2, true) => {
                canvas.area(&corners, Fill::new(Ink::Text).opacity(0.78), Some(edge));
                let title = on_cover([(-0.6, 0.3), (0.7, 0.3), (0.7, 0.66), (-0.6, 0.66)]);
                canvas.area(&title, Fill::new(Ink::Paper), None);
            }
            // The back cover, plain.
            (2, false) => canvas.area(&corners, Fill::new(Ink::Surface), Some(edge)),
            // The spine.
            (0, false) => canvas.area(&corners, Fill::new(Ink::Text).opacity(0.5), Some(edge)),
            // The edges of the pages.
            _ => canvas.area(&corners, Fill::new(Ink::Paper), Some(edge)),
        }
    }
}

/// The same attitude without its tumbling about the momentum (world x): turned back until the book's head
/// is as near to up as that allows.
fn without_tumbling(rotation: &Matrix3<f64>) -> Matrix3<f64> {
    let head = rotation.column(1);
    Rotation3::from_axis_angle(&Vector3::x_axis(), -head.z.atan2(head.y)).matrix() * rotation
}

pub(super) fn draw() -> Drawing {
    let [w, h, t] = BOOK.map(|x| x * x);
    let inertia = Inertia::from_moments((h + t) / 12.0, (w + t) / 12.0, (w + h) / 12.0)?;
    let omega = Vector3::new(PUSH.cos(), 0.0, PUSH.sin()) * TAU;
    let momentum = inertia.momentum(&omega);
    let level = UnitQuaternion::rotation_between(&momentum, &Vector3::x()).ok_or("a momentum against x")?;
    let body = Body::spinning(inertia, level, &omega)?;
    let run = motion::free(&body, 0.001, 2400)?;
    let flip = sign_changes(run.iter().map(|(t, b)| (*t, b.omega_body().x)));
    let flip = *flip.first().ok_or("the book did not flip")?;

    let canvas = Canvas::new(400);
    let rows = [("what you see", 108.0), ("the same, from a camera that goes round with the tumbling", 272.0)];
    for (words, y) in rows {
        canvas.label((20.0, y - 74.0), &Label::new(words));
        canvas.arrow((14.0, y), (668.0, y), Pen::new(Ink::Momentum, 2.0));
    }
    canvas.label((662.0, 108.0 - 10.0), &Label::new("$!L$").ink(Ink::Momentum).end());
    canvas.label((662.0, 272.0 - 10.0), &Label::new("$!L$").ink(Ink::Momentum).end());
    for i in 0..9_u32 {
        let (t, b) = run[i as usize * 250];
        let x = 50.0 + 71.0 * f64::from(i);
        for (row, rotation) in [(0, b.rotation()), (1, without_tumbling(&b.rotation()))] {
            let view = View::new((x, rows[row].1), 270.0, -90.0 + 22.0, 18.0);
            book(&canvas, &view, STANDING * rotation);
        }
        canvas.label((x, 350.0), &Label::new(format!("{t:.2}")).size(15.5).middle());
    }
    canvas.label((334.0, 378.0), &Label::new("time $t$ (s); the book was thrown at one turn a second").middle());
    Ok(Picture {
        canvas,
        description: format!(
            "A book of {:.0} by {:.0} by {:.1} cm, thrown end over end at one turn a second about its middle axis, {PUSH} rad off, \
             drawn every quarter of a second. Above, as you see it. Below, from a camera that goes round with the tumbling: the \
             front cover with its title is seen until after {:.2} s it turns away, and the back cover is seen instead, spine to the \
             other side. The angular momentum, an orange arrow, never moved.",
            100.0 * BOOK[0],
            100.0 * BOOK[1],
            100.0 * BOOK[2],
            flip
        ),
    })
}
