use super::{Drawing, document_box, in_principal_axes};
use crate::draw::{Canvas, Label, Plot};
use crate::motion;
use crate::of_body::spins;
use nalgebra::Vector3;
use tumbling::Axis;
use tumbling::dynamics::observe::sign_changes;

/// The spin, the slip about each other axis (rad/s), and the time watched (s).
const SPIN: f64 = 10.0;
const PUSH: f64 = 0.3;
const END: f64 = 5.0;
const STEP: f64 = 0.002;

pub(super) fn draw() -> Drawing {
    let inertia = in_principal_axes(&document_box()?)?;
    let canvas = Canvas::sized(500, 626);
    let pens = spins::pens();
    let mut said = Vec::new();
    for (k, axis) in Axis::ALL.into_iter().enumerate() {
        let name = ["axis of the smallest moment", "middle axis", "axis of the largest moment"][k];
        let top = 58.0 + 190.0 * k as f64;
        let plot = axes(&canvas, top, k == 2);
        let mut omega = Vector3::repeat(PUSH);
        omega[k] = SPIN;
        let run = motion::free(&motion::spun(inertia, omega)?, STEP, (END / STEP).round() as usize)?;
        // The spin that was meant is drawn last, over the others.
        for i in [(k + 1) % 3, (k + 2) % 3, k] {
            plot.curve(run.iter().map(|(t, body)| (*t, body.omega_body()[i])), pens[i])?;
        }
        let moment = inertia.principal().moment(axis);
        let title = format!("about the {name}, $I_{}$ = {moment:.3} kg m²", k + 1);
        canvas.label((14.0, top - 12.0), &Label::new(title).ink(pens[k].ink()));
        let beside = |i: usize, y: f64, nudge: f64| {
            let p = plot.at(END, y);
            let name = Label::new(format!("$ω_{}$", i + 1)).ink(pens[i].ink());
            canvas.label((p.0 + 10.0 + nudge, p.1 + 5.0), &name);
        };
        let w_end = run[run.len() - 1].1.omega_body();
        if k == 1 {
            let flips = sign_changes(run.iter().map(|(t, b)| (*t, b.omega_body()[1])));
            let flips: Vec<_> = flips.iter().map(|t| format!("{t:.2} s")).collect();
            said.push(format!("About the middle axis the spin reverses, at {}", flips.join(", ")));
            for i in 0..3 {
                beside(i, w_end[i], 0.0);
            }
        } else {
            let others = [0, 1, 2].into_iter().filter(|&i| i != k);
            let most = |i: usize| run.iter().map(|(_, b)| b.omega_body()[i].abs()).fold(0.0, f64::max);
            said.push(format!(
                "About the {name} the other components never exceed {:.2} rad/s",
                others.clone().map(most).fold(0.0, f64::max)
            ));
            beside(k, w_end[k], 0.0);
            for (n, i) in others.enumerate() {
                beside(i, 0.0, if n == 0 { 0.0 } else { 32.0 });
            }
        }
    }
    canvas.label((14.0, 22.0), &Label::new("spin in body axes, $ω$ (rad/s)"));
    canvas.described(format!(
        "The box spun at {SPIN:.0} rad/s about each principal axis in turn, with the same slip of {PUSH} rad/s about both \
         others. {}.",
        said.join(". ")
    ))
}

/// Axes for one spin; the last one's carry the times.
fn axes(canvas: &Canvas, top: f64, last: bool) -> Plot {
    let (times, spins) = (0.0..END, -11.5..11.5);
    let plot = Plot::new(canvas, [44.0, top, 418.0, top + 130.0], times, spins);
    let number = |s: i32| if last { s.to_string() } else { String::new() };
    plot.x_axis((0..=5).map(|s| (f64::from(s), number(s))), if last { "time $t$ (s)" } else { "" });
    plot.y_axis([-10, 0, 10].map(|w| (f64::from(w), w.to_string().replace('-', "−"))), "");
    plot
}
