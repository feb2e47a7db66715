use super::{Drawing, document_box};
use crate::draw::{Canvas, Ink, Label, Pen, Plot};
use crate::motion;
use nalgebra::Vector3;
use tumbling::dynamics::observe::sign_changes;
use tumbling::step::Engine;

const SPIN: f64 = 10.0;
const PUSH: f64 = 0.1;
const END: f64 = 6.0;
const STEP: f64 = 0.001;

pub(super) fn draw() -> Drawing {
    // x is the box's middle axis.
    let body = motion::spun(document_box()?, Vector3::new(SPIN, PUSH, PUSH))?;
    let canvas = Canvas::sized(500, 450);
    let plot = Plot::new(&canvas, [50.0, 56.0, 484.0, 376.0], 0.0..END, -12.0..14.0);
    plot.x_axis((0..=6).map(|s| (f64::from(s), s.to_string())), "time $t$ (s)");
    let ticks = [-10, -5, 0, 5, 10].map(|w| (f64::from(w), w.to_string().replace('-', "−")));
    plot.y_axis(ticks, "spin about the middle axis, $ω_2$ (rad/s)");
    let spins = |engine| -> Result<Vec<(f64, f64)>, tumbling::Error> {
        let run = motion::timed(engine, &body, STEP, (END / STEP).round() as usize)?;
        Ok(run.iter().map(|(t, b)| (*t, b.omega_body().x)).collect())
    };
    let right = spins(Engine::Turned)?;
    let taken = spins(Engine::MomentumForSpin)?;
    let without = spins(Engine::NoGyroscopicTerm)?;
    if [&taken, &without].iter().any(|run| !sign_changes(run.iter().copied()).is_empty()) {
        return Err("a wrong engine flipped".into());
    }
    let flips = sign_changes(right.iter().copied());
    let (taken_at, without_at) = (taken[0].1, without[0].1);
    plot.curve(right, Pen::new(Ink::Text, 3.0))?;
    plot.curve(taken, Pen::new(Ink::Wrong, 2.4).dashed())?;
    plot.curve(without, Pen::new(Ink::Wrong, 2.6).dotted())?;
    let word = |t: f64, w: f64, down: f64, text: String, ink: Ink| {
        let at = plot.at(t, w);
        canvas.label((at.0, at.1 + down), &Label::new(text).ink(ink).middle());
    };
    word(3.0, taken_at, -12.0, "$!L$ taken for $!ω$ (dashed): never flips".into(), Ink::Wrong);
    word(2.85, without_at, 28.0, "no gyroscopic term".into(), Ink::Wrong);
    word(2.85, without_at, 50.0, "(dotted): never flips".into(), Ink::Wrong);
    word(2.8, -10.0, -12.0, "right: it flips".into(), Ink::Text);
    for &t in &flips {
        plot.dots([(t, 0.0)], 4.5, Ink::Text)?;
        let at = plot.at(t, 0.0);
        let label = Label::new(format!("{t:.2} s"));
        canvas.label((at.0 + 12.0, at.1 + 20.0), &label);
    }
    let when: Vec<_> = flips.iter().map(|t| format!("{t:.2} s")).collect();
    canvas.described(format!(
        "Spin of the box about its middle axis, {SPIN:.0} rad/s at the start, with {PUSH} rad/s about both others. In the right \
         engine it reverses, at {}. Two wrong engines never flip: the one that takes the momentum for the spin stays at \
         {taken_at:.1} rad/s, the one without the gyroscopic term at {without_at:.1} rad/s.",
        when.join(" and ")
    ))
}
