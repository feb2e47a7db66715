use super::{Drawing, bound, document_box};
use crate::draw::{Canvas, Ink, Label, Pen, Plot};
use crate::motion;
use nalgebra::Vector3;
use tumbling::step::Engine;

const END: f64 = 40.0;
const STEP: f64 = 0.01;

pub(super) fn draw() -> Drawing {
    let body = motion::spun(document_box()?, Vector3::new(1.0, 1.0, 1.0))?;
    let canvas = Canvas::sized(500, 430);
    let plot = Plot::new(&canvas, [66.0, 56.0, 484.0, 356.0], 0.0..END, 0.5..1.3);
    plot.x_axis((0..=4).map(|s| (10.0 * f64::from(s), (10 * s).to_string())), "time $t$ (s)");
    let ticks = [60, 80, 100, 120].map(|y| (0.01 * f64::from(y), format!("{y} %")));
    plot.y_axis(ticks, "kinetic energy, relative to the start");
    let energies = |engine| -> Result<Vec<(f64, f64)>, tumbling::Error> {
        let run = motion::timed(engine, &body, STEP, (END / STEP).round() as usize)?;
        Ok(run.iter().map(|(t, b)| (*t, b.energy() / body.energy())).collect())
    };
    let (wrong, right) = (energies(Engine::Frozen)?, energies(Engine::Turned)?);
    let extreme = |run: &[(f64, f64)], sign: f64| {
        run.iter().copied().fold((0.0, 1.0), |m, p| if sign * p.1 > sign * m.1 { p } else { m })
    };
    let (most, least) = (extreme(&wrong, 1.0), extreme(&wrong, -1.0));
    let drift = right.iter().map(|p| (p.1 - 1.0).abs()).fold(0.0, f64::max);
    plot.curve(wrong, Pen::new(Ink::Wrong, 2.4).dashed())?;
    plot.curve(right, Pen::new(Ink::Text, 3.0))?;
    plot.dots([most, least], 4.5, Ink::Wrong)?;
    let mark = |p: (f64, f64), down: f64, text: String| {
        let at = plot.at(p.0, p.1);
        canvas.label((at.0, at.1 + down), &Label::new(text).ink(Ink::Wrong).middle());
    };
    mark(most, -12.0, format!("gains {:.0} %", 100.0 * (most.1 - 1.0)));
    mark(least, 24.0, format!("loses {:.0} %", 100.0 * (1.0 - least.1)));
    let at = plot.at(0.6, 1.225);
    canvas.label(at, &Label::new("frozen tensor (dashed)").ink(Ink::Wrong));
    let at = plot.at(20.2, 1.0);
    canvas.label((at.0, at.1 - 12.0), &Label::new("tensor turned").middle());
    canvas.described(format!(
        "Kinetic energy of the free box, spun at (1, 1, 1) rad/s, over {END:.0} s. The right engine, which turns the tensor \
         at each step, keeps it to better than {:.0e}. The one that leaves the body's tensor frozen in the world gains up to \
         {:.0} % and loses up to {:.0} %, though no torque acts.",
        bound(drift),
        100.0 * (most.1 - 1.0),
        100.0 * (1.0 - least.1)
    ))
}
