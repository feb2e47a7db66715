use super::{BOX_EDGES, Drawing, document_box};
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, polar};
use nalgebra::Vector3;

const CENTRE: P = (128.0, 352.0);
/// Pixels of a metre of the box.
const METRE: f64 = 108.0;

/// The place of the tip of an arrow from the centre.
fn tip(x: f64, y: f64) -> P {
    const UNIT: f64 = 250.0;
    (CENTRE.0 + UNIT * x, CENTRE.1 - UNIT * y)
}

pub(super) fn draw() -> Drawing {
    let inertia = document_box()?;
    let omega = Vector3::new(1.0, 1.0, 0.0);
    let momentum = inertia.momentum(&omega);
    let [w_angle, l_angle] = [omega, momentum].map(|v| v.y.atan2(v.x));
    let gap = inertia.angle_to_momentum(&omega)?.to_degrees();

    let canvas = Canvas::sized(500, 450);
    the_box(&canvas);
    components(&canvas, &omega, &momentum);
    arrows(&canvas, &omega, &momentum, gap);
    canvas.described(format!(
        "The box, {:.0} m by {:.0} m, seen along z. The spin (1, 1, 0) is a blue arrow from its centre at {:.0}° from x. \
         The momentum ({:.3}, {:.3}, 0) is an orange arrow from the same point at {:.1}°: each component of the spin is \
         multiplied by its own moment, so it leans to the y edge. The gap between them is {gap:.1}°.",
        BOX_EDGES[0],
        BOX_EDGES[1],
        w_angle.to_degrees(),
        momentum.x,
        momentum.y,
        l_angle.to_degrees()
    ))
}

fn the_box(canvas: &Canvas) {
    let centre = CENTRE;
    let [a, b, _] = BOX_EDGES.map(|edge| 0.5 * edge * METRE);
    let corners = [(-a, -b), (a, -b), (a, b), (-a, b)].map(|(x, y)| (centre.0 + x, centre.1 + y));
    canvas.area(&corners, Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.2)));
    let axis = Pen::new(Ink::Faint, 1.2).dash_dotted();
    canvas.line((centre.0 - a - 20.0, centre.1), (470.0, centre.1), axis);
    canvas.line((centre.0, centre.1 + b + 20.0), (centre.0, 40.0), axis);
    canvas.label((476.0, centre.1 + 5.0), &Label::new("$x$"));
    canvas.label((centre.0 - 5.0, 30.0), &Label::new("$y$"));
    let label = Label::new(format!("$a$ = {:.0} m", BOX_EDGES[0])).middle();
    canvas.label((centre.0 - 0.5 * a, centre.1 + b + 24.0), &label);
    canvas.label((centre.0 - a + 10.0, centre.1 + 30.0), &Label::new(format!("$b$ = {:.0} m", BOX_EDGES[1])));
}

/// Each component of the momentum is that of the spin times its own moment.
fn components(canvas: &Canvas, omega: &Vector3<f64>, momentum: &Vector3<f64>) {
    let centre = CENTRE;
    let guide = |ink| Pen::new(ink, 1.2).dashed();
    let (w_tip, l_tip) = (tip(omega.x, omega.y), tip(momentum.x, momentum.y));
    canvas.line(l_tip, (l_tip.0, centre.1), guide(Ink::Momentum));
    canvas.line(l_tip, (centre.0, l_tip.1), guide(Ink::Momentum));
    canvas.line(w_tip, (w_tip.0, centre.1), guide(Ink::Omega));
    canvas.line(w_tip, (centre.0, w_tip.1), guide(Ink::Omega));
    let l = |name, part| Label::new(format!("$L_{name}$ = {part:.3}")).ink(Ink::Momentum);
    let w = |name, part| Label::new(format!("$ω_{name}$ = {part:.0}")).ink(Ink::Omega);
    canvas.label((centre.0 - 10.0, l_tip.1 + 2.0), &l('y', momentum.y).end());
    canvas.label((centre.0 - 10.0, w_tip.1 + 10.0), &w('y', omega.y).end());
    canvas.label((l_tip.0 - 2.0, centre.1 + 24.0), &l('x', momentum.x).middle());
    canvas.label((w_tip.0 + 26.0, centre.1 + 24.0), &w('x', omega.x));
}

fn arrows(canvas: &Canvas, omega: &Vector3<f64>, momentum: &Vector3<f64>, gap: f64) {
    let centre = CENTRE;
    let (w_tip, l_tip) = (tip(omega.x, omega.y), tip(momentum.x, momentum.y));
    let [w_angle, l_angle] = [omega, momentum].map(|v| v.y.atan2(v.x));
    let arc = Pen::new(Ink::Text, 1.2);
    canvas.arc(centre, 60.0, 0.0, w_angle, arc);
    canvas.arc(centre, 100.0, 0.0, l_angle, arc);
    canvas.arc(centre, 226.0, w_angle, l_angle, Pen::new(Ink::Text, 2.4));
    canvas.arrow(centre, w_tip, Pen::new(Ink::Omega, 3.6));
    canvas.arrow(centre, l_tip, Pen::new(Ink::Momentum, 3.6));
    canvas.disc(centre, 4.0, Fill::new(Ink::Text), None);
    for (down, words) in [(56.0, "$!ω$ = (1, 1, 0)"), (80.0, "rad/s")] {
        canvas.label((w_tip.0 + 8.0, w_tip.1 + down), &Label::new(words).ink(Ink::Omega));
    }
    canvas.label(
        (496.0, l_tip.1 - 16.0),
        &Label::new(format!("$!L$ = ({:.3}, {:.3}, 0) kg m²/s", momentum.x, momentum.y))
            .ink(Ink::Momentum)
            .end(),
    );
    let small =
        |at: (f64, f64), text: String| canvas.label((at.0 + 5.0, at.1 + 4.0), &Label::new(text).size(15.5));
    small(polar(centre, 60.0, 0.35), format!("{:.0}°", w_angle.to_degrees()));
    small(polar(centre, 108.0, 0.64), format!("{:.1}°", l_angle.to_degrees()));
    let by_the_arc = polar(centre, 226.0, 0.5 * (w_angle + l_angle));
    canvas
        .label((by_the_arc.0 - 24.0, by_the_arc.1 - 4.0), &Label::new(format!("gap {gap:.1}°")).bold().end());
}
