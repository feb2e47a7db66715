//! The time between flips down to the smallest number above zero, and where a plain computation gives up.

use super::{Drawing, Picture, document_box, in_principal_axes, power_of_ten};
use crate::draw::{Canvas, Fill, Label, Pen, Plot, Scale};
use crate::ink::Ink;
use nalgebra::Vector3;
use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use tumbling::exact::FreeMotion;

/// About the middle axis, rad/s.
const SPIN: f64 = 10.0;
/// The smallest number above zero that an `f64` holds.
const LEAST: f64 = f64::from_bits(1);

fn spin(push: f64) -> Vector3<f64> {
    Vector3::new(0.0, SPIN, push)
}

fn exact(moments: &Vector3<f64>, push: f64) -> Result<f64, Box<dyn Error>> {
    Ok(0.5 * FreeMotion::new((*moments).try_into()?, &spin(push))?.period()?.ok_or("never flips")?)
}

/// The same as a textbook's formulas give it, typed in as they stand: energy and momentum, then the parameter
/// `m`, then `1 - m` for the arithmetic-geometric mean.
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

/// The powers of ten from one exponent to another, and the time at each.
fn line(moments: &Vector3<f64>, from: f64, to: f64) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let at = |i: i32| from + (to - from) * f64::from(i) / 200.0;
    (0..=200).map(|i| Ok((at(i), exact(moments, 10_f64.powf(at(i)))?))).collect()
}

pub(super) fn draw() -> Drawing {
    let m = in_principal_axes(&document_box()?)?.principal().moments();
    // From the largest push to the smallest; the last time that the plain computation finds, and where.
    let pushes = (100..=32_300).map(|i| -0.01 * f64::from(i));
    let plainly: Vec<_> = pushes.map(|x| (x, plain(&m, 10_f64.powf(x)))).collect();
    let last = plainly.iter().rposition(|p| p.1.is_finite()).ok_or("no plain time")?;
    let least = exact(&m, LEAST)?;
    let canvas = Canvas::new(606);
    near(&canvas, &m, &plainly[..=last])?;
    all(&canvas, &m, plainly[last], least)?;
    let decade = exact(&m, 1e-101)? - exact(&m, 1e-100)?;
    Ok(Picture {
        canvas,
        description: format!(
            "Time between two flips of the box spun at {SPIN:.0} rad/s about its middle axis against a push about its largest, \
             for pushes down to 1e-12 rad/s above and down to 5e-324, the smallest number above zero, below. The exact \
             time is a straight line over the powers of ten, {decade:.2} s for each: {:.2} s at 0.1, {:.1} s at 1e-12, {:.1} s \
             at 1e-300 and {least:.1} s at 5e-324. A plain computation that subtracts the elliptic parameter m from 1 strays \
             from it below 1e-6; below {:.0e} rad/s m rounds to 1, and it says that the box never flips.",
            exact(&m, 0.1)?,
            exact(&m, 1e-12)?,
            exact(&m, 1e-300)?,
            10_f64.powf(plainly[last].0)
        ),
    })
}

/// The pushes at which the plain computation still says something.
fn near(canvas: &Canvas, m: &Vector3<f64>, plainly: &[(f64, f64)]) -> Result<(), Box<dyn Error>> {
    let plot =
        Plot::new(canvas, 62.0, 50.0, 655.0, 250.0, Scale::linear(-12.0..-1.0), Scale::linear(0.0..14.0));
    let tick = |n: i32| (f64::from(n), if n % 2 == 0 { power_of_ten(n) } else { String::new() });
    plot.x_axis((-12..=-1).map(tick), "");
    plot.y_axis([0, 4, 8, 12].map(|s| (f64::from(s), s.to_string())), "time between two flips (s)");
    plot.curve(line(m, -12.0, -1.0)?, Pen::new(Ink::Text, 3.0))?;
    plot.curve(plainly.iter().copied(), Pen::new(Ink::Wrong, 1.8).dashed())?;
    let &(x, time) = plainly.last().ok_or("no plain time")?;
    let from = plot.at(x, time);
    canvas.arrow(from, (from.0, 52.0), Pen::new(Ink::Wrong, 2.2).dashed());
    let words = [
        "plain computing of $1 − m$:".to_owned(),
        format!("coarse, then 0 below {:.0}·{} rad/s,", 10_f64.powf(x - x.floor()), power_of_ten(floor(x))),
        "so “it never flips”".to_owned(),
    ];
    for (text, down) in words.into_iter().zip([0.0, 22.0, 44.0]) {
        canvas.label((from.0 + 14.0, 70.0 + down), &Label::new(text).ink(Ink::Wrong));
    }
    canvas.label(plot.at(-11.7, 9.4), &Label::new("exact"));
    Ok(())
}

/// All pushes that an `f64` holds.
fn all(canvas: &Canvas, m: &Vector3<f64>, plain: (f64, f64), least: f64) -> Result<(), Box<dyn Error>> {
    let plot =
        Plot::new(canvas, 62.0, 310.0, 655.0, 536.0, Scale::linear(-330.0..0.0), Scale::linear(0.0..350.0));
    // What the picture above shows of this one.
    let shown = [(-12.0, 0.0), (-1.0, 0.0), (-1.0, 350.0), (-12.0, 350.0)].map(|(x, y)| plot.at(x, y));
    canvas.area(&shown, Fill::new(Ink::Text).opacity(0.08), None);
    plot.x_axis(
        (-6..=0).map(|n| (f64::from(50 * n), power_of_ten(50 * n))),
        "push: spin about the largest axis (rad/s)",
    );
    plot.y_axis([0, 100, 200, 300].map(|s| (f64::from(s), s.to_string())), "");
    let smallest = plot.at(LEAST.log10(), least);
    let points = line(m, -307.0, -1.0)?;
    plot.curve([(LEAST.log10(), least)].into_iter().chain(points), Pen::new(Ink::Text, 2.6))?;
    canvas.disc(smallest, 5.0, Fill::new(Ink::Paper), Some(Pen::new(Ink::Text, 2.0)));
    canvas.label(
        (smallest.0 + 14.0, smallest.1 + 1.0),
        &Label::new(format!("{least:.0} s at 5·{}, the smallest f64 above 0", power_of_ten(-324))),
    );
    let [from, to] = [plain.1, 343.0].map(|y| plot.at(plain.0, y));
    canvas.arrow(from, to, Pen::new(Ink::Wrong, 2.2).dashed());
    let middle = plot.at(-17.0, 215.0);
    canvas.label(middle, &Label::new("plain: never").ink(Ink::Wrong).end());
    let decade = exact(m, 1e-101)? - exact(m, 1e-100)?;
    let words = plot.at(-255.0, 70.0);
    canvas.label(words, &Label::new(format!("exact: {decade:.2} s more")));
    canvas.label((words.0, words.1 + 22.0), &Label::new("for each power of ten"));
    Ok(())
}

fn floor(x: f64) -> i32 {
    x.floor() as i32
}
