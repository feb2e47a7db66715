//! The time between flips down to the smallest positive number, and the push at which a plain computation
//! fails.

use super::flip_time::{SPIN, exact, spin};
use super::{Drawing, document_box, in_principal_axes, power_of_ten};
use crate::draw::{Canvas, Fill, Ink, Label, Pen, Plot};
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::FRAC_PI_2;

/// The smallest positive `f64`.
const LEAST: f64 = f64::from_bits(1);

/// The same time by the formulas of a textbook, computed as they are printed: energy and momentum, then the
/// parameter `m`, then `1 - m` for the arithmetic-geometric mean.
fn plain(moments: &Vector3<f64>, push: f64) -> f64 {
    let (i, w) = (moments, spin(push));
    let twice_energy = i.x * w.x * w.x + i.y * w.y * w.y + i.z * w.z * w.z;
    let momentum_squared = i.x * i.x * w.x * w.x + i.y * i.y * w.y * w.y + i.z * i.z * w.z * w.z;
    let large = (i.z - i.y) * (momentum_squared - twice_energy * i.x);
    let small = (i.y - i.x) * (twice_energy * i.z - momentum_squared);
    let (above, below) = if momentum_squared >= twice_energy * i.y { (small, large) } else { (large, small) };
    let m = above / below;
    let rate = (below / (i.x * i.y * i.z)).sqrt();
    let (mut a, mut g) = (1.0, (1.0 - m).sqrt());
    for _ in 0..40 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    if m < 1.0 { 2.0 * FRAC_PI_2 / a / rate } else { f64::INFINITY }
}

pub(super) fn draw() -> Drawing {
    let m = in_principal_axes(&document_box()?)?.principal().moments();
    // From the largest push to the smallest for which the plain computation finds a time.
    let last = (100..=32_300)
        .map(|i| -0.01 * f64::from(i))
        .take_while(|&x| plain(&m, 10_f64.powf(x)).is_finite())
        .last()
        .ok_or("no plain time")?;
    let least = exact(&m, LEAST)?;
    let canvas = Canvas::sized(500, 400);
    let plot = Plot::new(&canvas, [50.0, 56.0, 486.0, 336.0], -324.0..0.0, 0.0..350.0);
    let ticks = (-3..=0).map(|n| (100.0 * f64::from(n), power_of_ten(100 * n)));
    plot.x_axis(ticks, "slip, as a fraction of the spin");
    plot.y_axis((0..=3).map(|n| (100.0 * f64::from(n), (100 * n).to_string())), "time between two flips (s)");
    let line: Result<Vec<_>, Box<dyn Error>> =
        (0..=322).map(|i| -f64::from(i) - 1.0).map(|x| Ok((x, exact(&m, 10_f64.powf(x))?))).collect();
    plot.curve(line?, Pen::new(Ink::Text, 3.0))?;
    let start = plot.at(-323.3, least);
    canvas.disc(start, 5.0, Fill::new(Ink::Text), None);
    let label = Label::new(format!("{least:.0} s: the smallest slip that"));
    canvas.label((start.0 + 40.0, start.1 - 18.0), &label);
    canvas.label((start.0 + 40.0, start.1 + 4.0), &Label::new("a computer’s number can be"));
    let end = plot.at(last, exact(&m, 10_f64.powf(last))?);
    let pen = Pen::new(Ink::Wrong, 3.0);
    for (dx, dy) in [(8.0, 8.0), (8.0, -8.0)] {
        canvas.line((end.0 - dx, end.1 - dy), (end.0 + dx, end.1 + dy), pen);
    }
    let word = |dy: f64, words: String| {
        canvas.label((end.0 - 95.0, end.1 + dy), &Label::new(words).ink(Ink::Wrong).end());
    };
    word(-24.0, "parameter rounded to one:".into());
    word(-2.0, format!("no flips below {}", power_of_ten(last.round() as i32)));
    canvas.described(format!(
        "Time between two flips of the box spun at {SPIN:.0} rad/s about its middle axis against a slip about its largest, as a \
         fraction of the spin. The exact time is a straight line over the powers of ten, from {:.2} s at 0.1 to {:.0} s at \
         1e-300 and {least:.0} s at 5e-324, the smallest number above zero. A computation that rounds the elliptic parameter \
         ends below {:.0e}, where the parameter rounds to 1: it says that the box never flips.",
        exact(&m, 0.1)?,
        exact(&m, 1e-300)?,
        10_f64.powf(last)
    ))
}
