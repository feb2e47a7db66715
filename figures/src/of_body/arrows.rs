//! Spin and momentum in the plane of two principal axes.

use super::{NAMES, Subject};
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, hull, polar};
use crate::picture::{Drawing, ink_of};
use crate::units;
use nalgebra::Vector3;
use tumbling::Axis;

/// Angles of spin and momentum from the easier axis, rad.
struct Pair {
    omega: f64,
    momentum: f64,
}

impl Pair {
    fn new(subject: &Subject<'_>, plane: [Axis; 2], degrees: f64) -> Self {
        let m = subject.moments.vector();
        let (s, c) = degrees.to_radians().sin_cos();
        Self { omega: s.atan2(c), momentum: (m[plane[1] as usize] * s).atan2(m[plane[0] as usize] * c) }
    }

    /// The angle between the two, rad; never −0.
    fn width(&self) -> f64 {
        (self.momentum - self.omega).abs()
    }

    fn gap(&self) -> String {
        format!("{:.1}°", self.width().to_degrees())
    }
}

/// The outline of the body, seen across the plane.
fn outline(canvas: &Canvas, subject: &Subject<'_>, plane: [Axis; 2], centre: P, radius: f64) {
    let [right, up]: [Vector3<f64>; 2] = plane.map(|axis| subject.frame.column(axis as usize).into_owned());
    let scale = radius / subject.model.reach();
    for surface in subject.model.drawn() {
        let at = |p: &Vector3<f64>| (centre.0 + scale * right.dot(p), centre.1 - scale * up.dot(p));
        let places: Vec<P> = surface.vertices.iter().map(at).collect();
        canvas.area(&hull(&places), Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.2)));
    }
}

fn pair(canvas: &Canvas, centre: P, long: f64, pair: &Pair, wide: [f64; 2]) -> [P; 2] {
    let tips = [polar(centre, long, pair.omega), polar(centre, 0.86 * long, pair.momentum)];
    canvas.arrow(centre, tips[1], Pen::new(Ink::Momentum, wide[1]));
    canvas.arrow(centre, tips[0], Pen::new(Ink::Omega, wide[0]));
    canvas.disc(centre, wide[0].min(4.0), Fill::new(Ink::Text), None);
    tips
}

/// One spin, large, with its momentum.
fn large(canvas: &Canvas, subject: &Subject<'_>, plane: [Axis; 2], degrees: f64) -> Pair {
    let centre = (215.0, 290.0);
    outline(canvas, subject, plane, centre, 100.0);
    let axis = Pen::new(Ink::Faint, 1.2).dash_dotted();
    canvas.line((centre.0 - 150.0, centre.1), (490.0, centre.1), axis);
    canvas.line((centre.0, centre.1 + 70.0), (centre.0, 70.0), axis);
    let (written, unit) = units::moments(subject.moments.vector().as_slice());
    canvas.label((14.0, 24.0), &Label::new(subject.name()).bold());
    for (which, at) in plane.into_iter().zip([(490.0, centre.1 + 44.0), (centre.0 - 10.0, 66.0)]) {
        let k = which as usize;
        canvas.label(at, &Label::new(format!("{} axis", NAMES[k])).ink(ink_of(which)).end());
        let value =
            Label::new(format!("$I_{}$ = {} {unit}", k + 1, written[k])).ink(ink_of(which)).end().size(15.5);
        canvas.label((at.0, at.1 + 22.0), &value);
    }
    let arrows = Pair::new(subject, plane, degrees);
    let tips = pair(canvas, centre, 215.0, &arrows, [3.6, 3.6]);
    canvas.arc(centre, 112.0, arrows.omega, arrows.momentum, Pen::new(Ink::Text, 2.2));
    let near = |tip: P| -> [P; 8] {
        let right = [10.0, 10.0, 10.0, 10.0, 10.0, -40.0, -70.0, -90.0];
        let down = [6.0, 26.0, -14.0, 46.0, -34.0, -14.0, -26.0, 40.0];
        std::array::from_fn(|k| (tip.0 + right[k], tip.1 + down[k]))
    };
    canvas.label_at_first(&near(tips[0]), &Label::new("spin $!ω$").ink(Ink::Omega));
    let momentum = Label::new("momentum $!L$").ink(Ink::Momentum).halo(Ink::Paper);
    // Where the arrows are close, on the side of the momentum that the spin is not on.
    let aside = (tips[1].0 - momentum.width() - 10.0, tips[1].1 + 6.0);
    let places = near(tips[1]);
    let close = arrows.width() < 0.3;
    if close {
        canvas.label_at_first(&[&[aside], &places[..]].concat(), &momentum);
    } else {
        canvas.label_at_first(&places, &momentum);
    }
    let by_the_arc = polar(centre, 140.0, 0.5 * (arrows.omega + arrows.momentum));
    let gap = Label::new(format!("gap {}", arrows.gap())).bold().halo(Ink::Paper);
    let first = if close { (14.0, 24.0) } else { (-6.0, 6.0) };
    let places = [first, (-100.0, -8.0), (10.0, 30.0), (-120.0, 30.0), (20.0, 60.0)];
    canvas.label_at_first(&places.map(|(right, down)| (by_the_arc.0 + right, by_the_arc.1 + down)), &gap);
    arrows
}

/// Half-way between the middle axis and the largest.
pub(crate) fn one(subject: &Subject<'_>) -> Drawing {
    let canvas = Canvas::sized(500, 400);
    let arrows = large(&canvas, subject, [Axis::Middle, Axis::Largest], 45.0);
    canvas.described(format!(
        "The outline of {} in the plane of its middle and its largest axis. The spin, a blue arrow, lies half-way between them; the \
         momentum, an orange arrow from the same point, leans to the largest axis. The gap between them is {}.",
        subject.name(),
        arrows.gap()
    ))
}

/// From the smallest axis to the largest.
pub(crate) fn turned(subject: &Subject<'_>) -> Drawing {
    let plane = [Axis::Smallest, Axis::Largest];
    let canvas = Canvas::sized(500, 540);
    large(&canvas, subject, plane, 30.0);
    let words = "the spin turned from one axis to the other, and the gap:";
    canvas.label((14.0, 402.0), &Label::new(words).size(15.5));
    let mut gaps = Vec::new();
    for i in 0..7_u32 {
        let degrees = f64::from(15 * i);
        let centre = (36.0 + 70.0 * f64::from(i), 466.0);
        outline(&canvas, subject, plane, centre, 24.0);
        let arrows = Pair::new(subject, plane, degrees);
        pair(&canvas, centre, 40.0, &arrows, [1.6, 3.6]);
        let at = |down: f64| (centre.0, centre.1 + down);
        canvas.label(at(44.0), &Label::new(format!("{degrees:.0}°")).ink(Ink::Omega).middle());
        canvas.label(at(66.0), &Label::new(arrows.gap()).bold().middle().size(15.5));
        gaps.push(format!("{} at {degrees:.0}°", arrows.gap()));
    }
    canvas.described(format!(
        "The outline of {} in the plane of its smallest and its largest axis, with a spin 30° from the smallest and its momentum, \
         which leans to the largest. Below, the spin turned from one axis to the other; the gap is {}.",
        subject.name(),
        gaps.join(", ")
    ))
}
