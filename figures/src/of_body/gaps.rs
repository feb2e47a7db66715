//! The gap between spin and momentum against the direction of the spin.

use super::{Kind, NAMES, Subject};
use crate::draw::{Canvas, Ink, Label, Pen, Plot};
use crate::picture::Drawing;
use crate::units;

/// The gap, degrees, for moments of this ratio: `tan(angle of momentum) = ratio tan(angle of spin)`.
fn gap(ratio: f64, degrees: f64) -> f64 {
    let angle = degrees.to_radians();
    let (s, c) = angle.sin_cos();
    ((ratio - 1.0) * s * c).atan2(c * c + ratio * s * s).to_degrees()
}

pub(crate) fn draw(subject: &Subject<'_>) -> Drawing {
    let m = subject.moments.vector();
    // Where moments are equal, one plane is enough: each other one has the same curve, or no gap.
    let planes: Vec<(usize, usize)> = match subject.kind {
        Kind::Three => vec![(0, 2), (0, 1), (1, 2)],
        _ => vec![(0, 2)],
    };
    let widest = |(easy, hard): (usize, usize)| {
        let ratio: f64 = m[hard] / m[easy];
        let at = (1.0 / ratio.sqrt()).atan().to_degrees();
        (at, gap(ratio, at))
    };
    let most = widest(planes[0]).1;
    let canvas = Canvas::sized(500, 450);
    canvas.label((14.0, 24.0), &Label::new(subject.name()).bold());
    let top = if most > 60.0 { 90.0 } else { (1.35 * most).max(1.0) };
    let plot = Plot::new(&canvas, [60.0, 78.0, 484.0, 376.0], 0.0..90.0, 0.0..top);
    let ticks = (0..=6).map(|i| (f64::from(15 * i), format!("{}°", 15 * i)));
    plot.x_axis(ticks, "spin, from the easier axis to the harder");
    let degrees = units::ticks(top).into_iter().map(|(y, text)| (y, format!("{text}°")));
    plot.y_axis(degrees, "gap between $!ω$ and $!L$");
    let pens =
        [Pen::new(Ink::Text, 2.6), Pen::new(Ink::Text, 2.2).dashed(), Pen::new(Ink::Text, 2.2).dotted()];
    let mut said = Vec::new();
    for (row, (&plane, pen)) in planes.iter().zip(pens).enumerate() {
        let ratio = m[plane.1] / m[plane.0];
        let (at, widest) = widest(plane);
        let between = format!("{} to {}", NAMES[plane.0], NAMES[plane.1]);
        said.push(format!("{between}: {widest:.2}° at {at:.1}°"));
        if subject.kind == Kind::Ball {
            continue;
        }
        let directions = (0..=300).map(|i| 90.0 * (f64::from(i) / 300.0).powi(2));
        plot.curve(directions.map(|d| (d, gap(ratio, d))), pen)?;
        plot.dots([(at, widest)], 4.0, Ink::Text)?;
        // Above the curves, or to the right of curves that leave no space above.
        let y = 96.0 + 22.0 * row as f64;
        canvas.line((206.0, y - 5.0), (240.0, y - 5.0), pen);
        let words = Label::new(format!("{between}: {}°", units::significant(widest, 3))).size(15.5);
        canvas.label((248.0, y), &words.halo(Ink::Paper));
    }
    if subject.kind == Kind::Ball {
        let at = plot.at(45.0, 0.0);
        canvas.label((at.0, at.1 - 10.0), &Label::new("no gap in any direction").middle());
    }
    canvas.described(format!(
        "The gap between spin and momentum of {} against the direction of the spin, from the easier to the harder of two \
         principal axes: zero at both ends, widest between them. The widest gaps: {}.",
        subject.name(),
        said.join("; ")
    ))
}
