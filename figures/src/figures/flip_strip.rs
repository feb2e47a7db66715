use super::{Drawing, Picture};
use crate::draw::{Canvas, Cuboid, Fill, Label, Pen, View};
use crate::ink::Ink;
use crate::motion;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use std::f64::consts::TAU;
use tumbling::Body;
use tumbling::body::named;
use tumbling::dynamics::observe::sign_changes;

/// The push, rad; the spin is a turn a second.
const PUSH: f64 = 0.05;

/// The book upright at the identity: its width along x, its thickness along y, its height along z.
fn draw_book(canvas: &Canvas, view: &View, edges: &Vector3<f64>, rotation: Matrix3<f64>) {
    let solid = Cuboid { rotation, half: edges * 0.5 };
    let edge = Pen::new(Ink::Text, 1.2);
    for (axis, sign) in [(0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0), (2, -1.0), (2, 1.0)] {
        if !solid.faces(view, axis, sign) {
            continue;
        }
        let corners = solid.face(axis, sign).map(|p| view.at(&p));
        canvas.area(&corners, Fill::new(Ink::Paper), None);
        match (axis, sign > 0.0) {
            // The front cover, with its title.
            (1, false) => {
                canvas.area(&corners, Fill::new(Ink::Text).opacity(0.78), Some(edge));
                let title = [(-0.6, 0.3), (0.7, 0.3), (0.7, 0.66), (-0.6, 0.66)];
                let title = title.map(|(x, z)| view.at(&solid.point(x, -1.0, z)));
                canvas.area(&title, Fill::new(Ink::Paper), None);
            }
            // The back cover, plain.
            (1, true) => canvas.area(&corners, Fill::new(Ink::Surface), Some(edge)),
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
    let head = rotation.column(2);
    Rotation3::from_axis_angle(&Vector3::x_axis(), head.y.atan2(head.z)).matrix() * rotation
}

pub(super) fn draw() -> Drawing {
    let inertia = named::NamedBody::Book.properties()?.inertia();
    let edges = Vector3::from(named::BOOK.sizes);
    // Along x, its middle axis, but for the push.
    let omega = Vector3::new(PUSH.cos(), PUSH.sin(), 0.0) * TAU;
    let momentum = inertia.momentum(&omega);
    let level = UnitQuaternion::rotation_between(&momentum, &Vector3::x()).ok_or("a momentum against x")?;
    let body = Body::spinning(inertia, level, &omega)?;
    let run = motion::free(&body, 0.001, 2000)?;
    let flip = sign_changes(run.iter().map(|(t, b)| (*t, b.omega_body().x)));
    let flip = *flip.first().ok_or("the book did not flip")?;

    let canvas = Canvas::new(392);
    let rows =
        [("what you see", 104.0), ("the same, from a camera that goes round with the tumbling", 264.0)];
    for (words, y) in rows {
        canvas.label((20.0, y - 74.0), &Label::new(words));
        canvas.arrow((14.0, y), (670.0, y), Pen::new(Ink::Momentum, 2.0));
        canvas.label((662.0, y - 10.0), &Label::new("$!L$").ink(Ink::Momentum).end());
    }
    for i in 0..9_u32 {
        let (t, b) = run[i as usize * 250];
        let x = 48.0 + 69.5 * f64::from(i);
        for (row, rotation) in [(0, b.rotation()), (1, without_tumbling(&b.rotation()))] {
            let view = View::new((x, rows[row].1), 320.0, -90.0 + 22.0, 18.0);
            draw_book(&canvas, &view, &edges, rotation);
        }
        canvas.label((x, 342.0), &Label::new(format!("{t:.2}")).size(15.5).middle());
    }
    canvas.label((340.0, 372.0), &Label::new("time $t$ (s), thrown at one turn a second").middle());
    let [w, t, h] = [edges.x, edges.y, edges.z].map(|edge| 1000.0 * edge);
    Ok(Picture {
        canvas,
        description: format!(
            "A book of {w:.0} by {h:.0} by {t:.0} mm, thrown end over end at one turn a second, about its middle axis but for {PUSH} \
             rad, drawn every quarter of a second for two seconds. Above, as you see it. Below, from a camera that goes round \
             with the tumbling: the front cover with its title faces you at first; it turns away, edge on about {flip:.2} s after \
             the throw, and then the plain back cover faces you, the spine on the other side. The angular momentum, an orange \
             arrow along which the tumbling turns, never moves."
        ),
    })
}
