use super::{Drawing, document_box, in_principal_axes, power_of_ten};
use crate::draw::{Canvas, Ink, Label, Pen, Plot, Scale};
use crate::motion;
use nalgebra::Vector3;
use tumbling::exact::time_between_flips;

const SPIN: f64 = 10.0;
const STEP: f64 = 0.0002;

pub(super) fn draw() -> Drawing {
    let inertia = in_principal_axes(&document_box()?)?;
    let m = inertia.principal().moments();
    let rate = motion::growth(&m, SPIN)?;
    let canvas = Canvas::sized(500, 450);
    let plot = Plot::new(&canvas, [66.0, 56.0, 484.0, 376.0], 0.0..7.0, Scale::log(1e-7..30.0));
    plot.x_axis((0..=7).map(|s| (f64::from(s), s.to_string())), "time $t$ (s)");
    let ticks = (-3..=0).map(|n| (10_f64.powi(2 * n), power_of_ten(2 * n)));
    plot.y_axis(ticks, "angle between the spin and the middle axis (rad)");
    // A slip about the largest axis, half growing, half fading: `cosh`, with `sinh` about the smallest.
    let other = ((m[2] - m[1]) * m[2] / ((m[1] - m[0]) * m[0])).sqrt();
    let mut said = Vec::new();
    for exponent in [-2, -4, -6] {
        let push = 10_f64.powi(exponent);
        let omega = Vector3::new(0.0, push.cos(), push.sin()) * SPIN;
        let whole = time_between_flips(m.try_into()?, &omega)?.ok_or("never flips")?;
        let run = motion::free(&motion::spun(inertia, omega)?, STEP, (whole / STEP) as usize)?;
        let angle = |w: Vector3<f64>| w.x.hypot(w.z).atan2(w.y.abs());
        let share = 0.5 * other.hypot(1.0) * push;
        let full = (3.0 / share).ln() / rate;
        let line = [(0.0, share), (full, share * (rate * full).exp())];
        plot.curve(line, Pen::new(Ink::Text, 7.0).opacity(0.22))?;
        let line = run.iter().step_by(10).map(|(t, body)| (*t, angle(body.omega_body())));
        plot.curve(line, Pen::new(Ink::Text, 2.2))?;
        let tail = plot.at(whole, push);
        let power = power_of_ten(exponent);
        if exponent == -2 {
            canvas.label((tail.0 + 10.0, tail.1 + 6.0), &Label::new(power));
        } else {
            canvas.label((tail.0 - 4.0, tail.1 + 22.0), &Label::new(format!("a slip of {power} rad")).end());
        }
        canvas.label(plot.at(0.5 * whole, 4.5), &Label::new(format!("{:.1} s", 0.5 * whole)).middle());
        said.push(format!("After a slip of {push:.0e} rad it flips after {:.2} s", 0.5 * whole));
    }
    canvas.label(plot.at(0.05, 4.5), &Label::new("flip:"));
    let words = ["wide: the theory,".into(), "growth as $e^{λt}$,".into(), format!("$λ$ = {rate:.2} /s")];
    for (down, line) in [0.0, 24.0, 48.0].into_iter().zip(words) {
        let at = plot.at(4.35, 1.6);
        canvas.label((at.0, at.1 + down), &Label::new(line));
    }
    canvas.described(format!(
        "The box spun at {SPIN:.0} rad/s about its middle axis, with a small slip about the largest. On a logarithmic scale \
         the angle between spin and middle axis grows along a straight line, the theory's exp({rate:.2} t), until the \
         spin is far from the axis; there it flips, and the angle falls back to what it was. {}. Each slip a hundred \
         times smaller only delays the flip by the same {:.2} s.",
        said.join(". "),
        100_f64.ln() / rate
    ))
}
