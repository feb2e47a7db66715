use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, polar};
use std::f64::consts::FRAC_PI_2;

/// The turn that is seen, rad.
const TURN: f64 = 0.7;

fn body(canvas: &Canvas, centre: P, angle: f64, opacity: f64) {
    let corner = |x: f64, y: f64| {
        let along = polar(centre, x, angle);
        polar(along, y, angle + FRAC_PI_2)
    };
    let corners = [corner(-82.0, -46.0), corner(82.0, -46.0), corner(82.0, 46.0), corner(-82.0, 46.0)];
    canvas.area(
        &corners,
        Fill::new(Ink::Surface).opacity(opacity),
        Some(Pen::new(Ink::Text, 1.3).opacity(opacity)),
    );
    // A mark, so that the body is seen to turn.
    canvas.disc(corner(64.0, 0.0), 6.0, Fill::new(Ink::Text).opacity(opacity), None);
}

fn arrow(canvas: &Canvas, centre: P, angle: f64, opacity: f64) {
    let tip = polar(centre, 128.0, angle);
    if opacity < 1.0 {
        canvas.line(centre, tip, Pen::new(Ink::Momentum, 3.0).dashed().opacity(opacity));
    } else {
        canvas.arrow(centre, tip, Pen::new(Ink::Momentum, 3.6));
    }
}

pub(super) fn draw() -> Drawing {
    let canvas = Canvas::sized(500, 300);
    let [room, riding] = [(120.0, 190.0), (380.0, 190.0)];
    let sweep = |centre: P, r: f64, from: f64, to: f64, ink: Ink| {
        let points: Vec<P> =
            (0..=40).map(|i| polar(centre, r, from + (to - from) * f64::from(i) / 40.0)).collect();
        canvas.arrow_along(&points, Pen::new(ink, 2.2));
    };
    body(&canvas, room, 0.0, 0.45);
    body(&canvas, room, TURN, 1.0);
    arrow(&canvas, room, FRAC_PI_2, 1.0);
    sweep(room, 100.0, 0.04, TURN - 0.06, Ink::Omega);
    body(&canvas, riding, 0.0, 1.0);
    arrow(&canvas, riding, FRAC_PI_2, 0.7);
    arrow(&canvas, riding, FRAC_PI_2 - TURN, 1.0);
    sweep(riding, 112.0, FRAC_PI_2 - 0.06, FRAC_PI_2 - TURN + 0.1, Ink::Momentum);
    for centre in [room, riding] {
        canvas.disc(centre, 4.5, Fill::new(Ink::Omega), None);
    }
    canvas.label((room.0, 26.0), &Label::new("seen from the room").bold().middle());
    canvas.label((riding.0, 26.0), &Label::new("seen from the body").bold().middle());
    canvas.label((room.0 + 10.0, 74.0), &Label::new("$!v$ stays").ink(Ink::Momentum));
    canvas.label((room.0 + 92.0, 128.0), &Label::new("$!ω$").ink(Ink::Omega));
    canvas.label((riding.0 - 14.0, 74.0), &Label::new("$!v$ turns").ink(Ink::Momentum).end());
    canvas.label((riding.0 - 14.0, 96.0), &Label::new("at −$!ω$ × $!v$").ink(Ink::Momentum).end());
    canvas.described(
        "The same turn seen twice. Left, from the room: a body with a mark turns counter-clockwise about the axis of its \
                      spin, and an arrow fixed in the room stays. Right, from the body: the body stays, and the arrow has turned \
                      clockwise by the same angle."
    )
}
