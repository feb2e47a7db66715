//! The paths of the spin on the ellipsoid of equal energy, from the two conservation laws alone.

use super::{Kind, NAMES, Subject, beyond};
use crate::draw::{Canvas, Fill, Ink, Label, Pen, View};
use crate::figures::polhode::Ellipsoid;
use crate::picture::{Drawing, ink_of};
use crate::units;
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};
use tumbling::Axis;

/// The directions of the spin on a drawable ellipsoid: a needle's own would be too thin.
fn drawn(moments: &Vector3<f64>) -> Result<Ellipsoid, Box<dyn Error>> {
    let stout = [1.0, 0.85, 0.8].map(|reach: f64| reach.powi(-2));
    Ellipsoid::new(if to_scale(moments) { (moments / moments.x).into() } else { stout })
}

fn to_scale(moments: &Vector3<f64>) -> bool {
    (moments.x / moments.z).sqrt() > 0.3
}

/// A closed path round the end of an axis (0 or 2), `share` of the way to the separatrix; at 1 it is half the
/// separatrix. In parts of the half axes.
///
/// With `u` the spin over the half axes, `|u| = 1` and `I1 u1² + I2 u2² + I3 u3² = c`: across the axis an
/// ellipse.
fn path(i: &Vector3<f64>, axis: usize, sign: f64, share: f64) -> Vec<Vector3<f64>> {
    let other = 2 - axis;
    let across = |k: usize| (i[k] - i[axis]).abs();
    // The angle along the great circle to the other end, at most that of the separatrix.
    let full = if across(1) == 0.0 { 1.0 } else { (across(1) / across(other)).sqrt().asin() };
    let angle = share * if across(1) == across(other) { FRAC_PI_2 } else { full };
    let size = angle.sin() * across(other).sqrt();
    let point = |k: u32| {
        let (s, c) = (TAU * f64::from(k) / 240.0).sin_cos();
        let mut u = Vector3::zeros();
        u[other] = size / across(other).sqrt() * c;
        u[1] = size / across(1).sqrt() * s;
        u[axis] = sign * (1.0 - u.norm_squared()).max(0.0).sqrt();
        u
    };
    (0..=240).map(point).collect()
}

/// The ellipsoid and the paths on it; the ellipsoid.
fn paths(
    canvas: &Canvas,
    view: &View,
    subject: &Subject<'_>,
    shares: &[f64],
) -> Result<Ellipsoid, Box<dyn Error>> {
    let moments = subject.moments.vector();
    let ellipsoid = drawn(&moments)?;
    ellipsoid.surface(canvas, view, Pen::new(Ink::Faint, 1.2));
    let curve = |end: usize, sign: f64, share: f64, ink: Ink, width: f64| {
        let points: Vec<_> =
            path(&moments, end, sign, share).iter().map(|u| u.component_mul(&ellipsoid.reach)).collect();
        let behind = Some(Pen::new(ink, 1.0).opacity(0.35));
        ellipsoid.curve(canvas, view, &points, Pen::new(ink, width), behind);
    };
    let ends: &[(usize, Axis)] = match subject.kind {
        Kind::Ball => &[],
        Kind::Round(Axis::Smallest) => &[(0, Axis::Smallest)],
        Kind::Round(_) => &[(2, Axis::Largest)],
        Kind::Three => &[(0, Axis::Smallest), (2, Axis::Largest)],
    };
    for sign in [1.0, -1.0] {
        for &(end, axis) in ends {
            shares.iter().for_each(|&share| curve(end, sign, share, ink_of(axis), 1.8));
        }
        if subject.kind == Kind::Three {
            curve(0, sign, 1.0, Ink::Separatrix, 3.0);
        }
    }
    Ok(ellipsoid)
}

pub(crate) fn draw(subject: &Subject<'_>) -> Drawing {
    let canvas = Canvas::sized(500, 540);
    let view = View::new((250.0, 246.0), 190.0, 58.0, 27.0);
    let ellipsoid = paths(&canvas, &view, subject, &[0.22, 0.44, 0.66, 0.86])?;
    canvas.label((14.0, 24.0), &Label::new(subject.name()).bold());
    for axis in Axis::ALL {
        let k = axis as usize;
        let end = Vector3::ith(k, ellipsoid.reach[k]);
        let tip = view.at(&(end * (1.0 + 0.25 / end.norm())));
        canvas.disc(view.at(&end), 4.0, Fill::new(ink_of(axis)), None);
        canvas.arrow(view.at(&end), tip, Pen::new(ink_of(axis), 2.6));
        let places = beyond(view.at(&Vector3::zeros()), tip);
        canvas.label_at_first(&places, &Label::new((k + 1).to_string()).ink(ink_of(axis)).bold().middle());
    }
    let (written, unit) = units::moments(subject.moments.vector().as_slice());
    for axis in Axis::ALL {
        let k = axis as usize;
        let fate = match (subject.kind, axis) {
            (Kind::Three, Axis::Middle) => "unstable: it flips",
            (Kind::Three, _) => "stable: loops",
            (Kind::Round(lone), _) if lone == axis => "stable: circles",
            (Kind::Round(_), _) => "one of two equal",
            (Kind::Ball, _) => "any spin stays",
        };
        let words = format!("{} {}: {} {unit}, {fate}", k + 1, NAMES[k], written[k]);
        canvas.label((14.0, 462.0 + 22.0 * k as f64), &Label::new(words).ink(ink_of(axis)).size(15.5));
    }
    let scale =
        if to_scale(&subject.moments.vector()) { "" } else { "not to scale: the true ellipsoid is a needle" };
    canvas.label((14.0, 530.0), &Label::new(scale).size(15.5));
    canvas.described(words(subject))
}

/// The paths without words.
pub(crate) fn cover(subject: &Subject<'_>) -> Drawing {
    let canvas = Canvas::new(430);
    let view = View::new((340.0, 215.0), 208.0, 62.0, 24.0);
    paths(&canvas, &view, subject, &[0.12, 0.26, 0.4, 0.54, 0.68, 0.82, 0.94])?;
    canvas.described(words(subject))
}

fn words(subject: &Subject<'_>) -> String {
    let name = subject.name();
    match subject.kind {
        Kind::Three => format!(
            "The ellipsoid of all spins of {name} with the same energy. The paths of the spin on it are closed loops round the ends of \
             the axes with the smallest and the largest moment. Two ellipses, the separatrix, part them and cross at the ends of \
             the middle axis."
        ),
        Kind::Round(_) => format!(
            "The ellipsoid of all spins of {name} with the same energy. Two of its moments are equal: the paths of the spin are \
             circles round the third axis, and no spin flips."
        ),
        Kind::Ball => format!(
            "The sphere of all spins of {name} with the same energy. Its three moments are equal: every spin stays where it is, and \
             there is no path to draw."
        ),
    }
}
