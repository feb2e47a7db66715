use super::{Drawing, bound, document_box, in_principal_axes, power_of_ten};
use crate::draw::{Canvas, Fill, Ink, Label, Pen, Plot, Scale};
use crate::motion;
use nalgebra::Vector3;
use tumbling::dynamics::observe::sign_changes;
use tumbling::exact::time_between_flips;

pub(super) const SPIN: f64 = 10.0;
const STEP: f64 = 0.0005;

pub(super) fn draw() -> Drawing {
    let inertia = in_principal_axes(&document_box()?)?;
    let m = inertia.principal().moments();
    let rate = motion::growth(&m, SPIN)?;
    let canvas = Canvas::sized(500, 450);
    let plot = Plot::new(&canvas, [50.0, 56.0, 484.0, 376.0], Scale::log(1e-12..1.0), 0.0..14.0);
    let ticks = (-6..=0).map(|n| (10_f64.powi(2 * n), power_of_ten(2 * n)));
    plot.x_axis(ticks, "slip, as a fraction of the spin");
    plot.y_axis((0..=7).map(|n| (2.0 * f64::from(n), (2 * n).to_string())), "time between two flips (s)");
    let time = |push| exact(&m, push);
    let curve: Result<Vec<_>, _> = (0..=240)
        .map(|i| 10_f64.powf(-12.0 + 0.05 * f64::from(i)))
        .map(|push| time(push).map(|t| (push, t)))
        .collect();
    plot.curve(curve?, Pen::new(Ink::Text, 2.4))?;
    let mut dots = Vec::new();
    let mut worst = 0.0_f64;
    for n in 1..=12 {
        let push = 10_f64.powi(-n);
        let exact = time(push)?;
        let run = motion::free(&motion::spun(inertia, spin(push))?, STEP, (0.6 * exact / STEP) as usize)?;
        let flips = sign_changes(run.iter().map(|(t, b)| (*t, b.omega_body().y)));
        // The start is half-way between two flips.
        let seen = 2.0 * flips.first().ok_or("no flip")?;
        worst = worst.max((seen / exact - 1.0).abs());
        dots.push((push, seen));
    }
    for (push, seen) in dots {
        canvas.disc(plot.at(push, seen), 5.0, Fill::new(Ink::Paper), Some(Pen::new(Ink::Text, 2.0)));
    }
    let decade = 2.0 * 10_f64.ln() / rate;
    // A step of one decade, drawn as a stair under the line.
    let (near, far) = ((1e-5, time(1e-5)?), (1e-6, time(1e-6)?));
    let stair = [plot.at(near.0, near.1), plot.at(far.0, near.1), plot.at(far.0, far.1)];
    canvas.path(&stair, Pen::new(Ink::Text, 1.2).dashed());
    canvas.label((stair[1].0 - 6.0, stair[1].1 + 24.0), &Label::new("ten times smaller:").end());
    let longer = Label::new(format!("{decade:.2} s longer")).end().bold();
    canvas.label((stair[1].0 - 6.0, stair[1].1 + 46.0), &longer);
    canvas.label(plot.at(3e-9, 10.6), &Label::new("line: the formula; rings: simulated"));
    canvas.described(format!(
        "Time between two flips of the box spun at {SPIN:.0} rad/s about its middle axis, against the slip, from {:.2} s at a \
         push of 0.1 to {:.2} s at 1e-12: nearly a straight line over a logarithmic axis, {decade:.2} s for each factor of \
         ten. Twelve simulated motions lie on the formula, all to better than {:.0e}.",
        time(0.1)?,
        time(1e-12)?,
        bound(worst)
    ))
}

/// About the middle axis, with a slip about the hardest, rad/s.
pub(super) fn spin(push: f64) -> Vector3<f64> {
    Vector3::new(0.0, SPIN, SPIN * push)
}

/// The time between flips for a body of these moments, s.
pub(super) fn exact(moments: &Vector3<f64>, push: f64) -> Result<f64, Box<dyn std::error::Error>> {
    Ok(time_between_flips((*moments).try_into()?, &spin(push))?.ok_or("never flips")?)
}
