//! The body with its principal axes and moments, and its place among all bodies.

use super::{NAMES, Subject, beyond};
use crate::draw::{Canvas, Fill, Ink, Label, Pen, View, solid};
use crate::figures::moments_map::{edges, growth_key, growth_lines, map};
use crate::picture::{Drawing, ink_of};
use crate::units;
use nalgebra::{Matrix3, Vector3};
use tumbling::Axis;

/// From where the body is seen.
const SEEN: (f64, f64) = (42.0, 24.0);

pub(crate) fn draw(subject: &Subject<'_>) -> Drawing {
    let canvas = Canvas::sized(500, 540);
    canvas.label((14.0, 24.0), &Label::new(subject.name()).bold());
    canvas.label((14.0, 46.0), &Label::new(subject.sizes()).size(15.5));
    let (surfaces, reach) = (subject.model.drawn(), subject.model.reach());
    let view = View::new((250.0, 258.0), 140.0 / reach, SEEN.0, SEEN.1);
    solid(&canvas, &view, &surfaces, &Matrix3::identity(), None);
    let centre = view.at(&Vector3::zeros());
    for axis in Axis::ALL {
        let along = subject.frame.column(axis as usize).into_owned();
        // Toward the viewer, or upwards.
        let along = if along.dot(&view.toward()) + 0.2 * along.z < 0.0 { -along } else { along };
        let inside = surfaces.iter().flat_map(|s| &s.vertices).map(|p| p.dot(&along)).fold(0.0, f64::max);
        let [from, tip] = [inside, inside.max(0.35 * reach) + 0.5 * reach].map(|far| view.at(&(along * far)));
        canvas.line(centre, from, Pen::new(ink_of(axis), 1.4).dashed());
        canvas.arrow(from, tip, Pen::new(ink_of(axis), 2.8));
        let number = Label::new((axis as usize + 1).to_string()).ink(ink_of(axis)).bold().middle();
        canvas.label_at_first(&beyond(centre, tip), &number);
    }
    let (written, unit) = units::moments(subject.moments.vector().as_slice());
    for axis in Axis::ALL {
        let k = axis as usize;
        let words = format!("$I_{}$ = {} {unit}, the {}", k + 1, written[k], NAMES[k]);
        canvas.label((14.0, 486.0 + 22.0 * k as f64), &Label::new(words).ink(ink_of(axis)));
    }
    let about = NAMES.iter().zip(&written).map(|(name, value)| format!("{name} {value} {unit}"));
    canvas.described(format!(
        "{}, {}, with an arrow along each of its principal axes. Its moments of inertia about them: {}.",
        subject.name(),
        subject.sizes(),
        about.collect::<Vec<_>>().join(", ")
    ))
}

/// Its place in the triangle of all bodies, with lines of equal growth or without.
pub(crate) fn place<const GROWTH: bool>(subject: &Subject<'_>) -> Drawing {
    let (canvas, plot) = map()?;
    edges(&canvas, &plot);
    if GROWTH {
        growth_lines(&canvas, &plot)?;
        growth_key(&canvas, &plot);
    }
    let m = subject.moments.vector();
    let (x, y) = (m.x / m.z, m.y / m.z);
    let p = plot.at(x, y);
    canvas.disc(p, 5.5, Fill::new(Ink::Text), None);
    let words = Label::new(subject.name()).size(16.0).bold().halo(Ink::Surface);
    let wide = words.width();
    let places = [(10.0, 5.0), (10.0, 24.0), (10.0, -12.0), (-wide - 10.0, 5.0), (-wide - 10.0, 24.0)];
    let places = places.into_iter().chain((1..9).map(|k| (10.0 - 0.5 * wide, 24.0 * f64::from(k))));
    let places: Vec<_> = places.map(|(right, down)| (p.0 + right, p.1 + down)).collect();
    let all: Vec<_> =
        [0.0, -60.0, -120.0].iter().flat_map(|left| places.iter().map(move |p| (p.0 + left, p.1))).collect();
    canvas.label_at_first(&all, &words);
    canvas.described(format!(
        "Every rigid body is a point in a triangle: across, its smallest moment over the largest; up, its middle moment over the \
         largest. The corners are the needle (0, 1), the thin disk (0.5, 0.5) and the ball (1, 1). {} is at ({x:.3}, {y:.3}); \
         a slip off its middle axis grows by {:.2} per radian of spin.",
        subject.name(),
        subject.growth()
    ))
}
