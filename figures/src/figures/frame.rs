use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, Pen};

/// A stage: its name, what acts in it, and what it changes.
const STAGES: [[&str; 3]; 3] = [
    ["forces", "gravity, thrusters, damping", "spin"],
    ["solver", "contacts, joints, motors", "spin"],
    ["positions", "the position stage: nothing acts", "attitude and spin"],
];

pub(super) fn draw() -> Drawing {
    let canvas = Canvas::sized(500, 420);
    let (left, right, height, gap) = (20.0, 400.0, 92.0, 40.0);
    for (i, [name, acts, changes]) in STAGES.into_iter().enumerate() {
        let top = 20.0 + i as f64 * (height + gap);
        let corners = [(left, top), (right, top), (right, top + height), (left, top + height), (left, top)];
        let (fill, pen) = if i == 2 { (Ink::Surface, 3.6) } else { (Ink::Paper, 1.2) };
        canvas.area(&corners, Fill::new(fill), Some(Pen::new(Ink::Text, pen)));
        canvas.label((left + 14.0, top + 28.0), &Label::new(name).bold());
        canvas.label((left + 14.0, top + 53.0), &Label::new(acts));
        canvas.label((left + 14.0, top + 78.0), &Label::new(format!("changes {changes}")).ink(Ink::Omega));
        if i < 2 {
            let middle = (left + right) / 2.0;
            canvas.arrow(
                (middle, top + height),
                (middle, top + height + gap - 2.0),
                Pen::new(Ink::Text, 2.2),
            );
        }
    }
    // The next frame, or the next sub-step.
    let (first, last) = (20.0 + height / 2.0, 20.0 + 2.0 * (height + gap) + height / 2.0);
    let back = [(right, last), (440.0, last), (440.0, first), (right + 4.0, first)];
    canvas.arrow_along(&back, Pen::new(Ink::Text, 2.2));
    canvas.described(
        "A frame of an engine as three boxes, one below the other, joined by arrows, with an arrow from the last back to \
                      the first. Forces: gravity, thrusters and damping change the spin. Solver: contacts, joints and motors change \
                      the spin. Positions, drawn bold: in the position stage nothing acts; it changes attitude and spin."
    )
}
