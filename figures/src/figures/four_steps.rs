//! The energy of a box with four methods.

use super::{Drawing, NARROW};
use crate::draw::{Canvas, Ink, Label, Pen, Plot};
use nalgebra::{Quaternion, Vector3};
use tumbling::body::named::NamedBody;
use tumbling::step::{Method, State, System};

/// Length of a step, s.
const STEP: f64 = 0.7;
const STEPS: u32 = 143;
/// The sheet's least and greatest energy, as a share of the first.
const SHOWN: [f64; 2] = [0.94, 1.06];

/// The energy after each step as a share of the first, as long as the sheet shows it.
fn energies(method: Method) -> Result<Vec<(f64, f64)>, tumbling::Error> {
    let system = System::free(NamedBody::TheBox.properties()?.inertia().matrix().diagonal().try_into()?)?;
    let omega = Vector3::repeat(1.0);
    let mut state = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    let first = system.energy(&state);
    let mut seen = vec![(0.0, 1.0)];
    for step in 1..=STEPS {
        state = method.step(&system, &state, STEP)?;
        let energy = system.energy(&state) / first;
        if !(SHOWN[0]..=SHOWN[1]).contains(&energy) {
            break;
        }
        seen.push((STEP * f64::from(step), energy));
    }
    Ok(seen)
}

pub(super) fn draw() -> Drawing {
    let end = STEP * f64::from(STEPS);
    let canvas = Canvas::sized(NARROW, 360);
    let plot = Plot::new(&canvas, [72.0, 46.0, 474.0, 300.0], 0.0..end, SHOWN[0]..SHOWN[1]);
    plot.x_axis((0..=4).map(|k| (25.0 * f64::from(k), (25 * k).to_string())), "time $t$ (s)");
    let ticks = [0.94, 0.96, 0.98, 1.0, 1.02, 1.04, 1.06];
    plot.y_axis(ticks.map(|y| (y, format!("{:.0} %", 100.0 * y))), "energy, as a share of the first");
    let euler = energies(Method::ExplicitEuler)?;
    let classical = energies(Method::RungeKutta4)?;
    let turns = energies(Method::RotationSplitting2)?;
    let whole = energies(Method::MoserVeselov8)?;
    plot.curve(turns.iter().copied(), Pen::new(Ink::Faint, 1.6))?;
    plot.curve(whole.iter().copied(), Pen::new(Ink::Text, 3.0))?;
    plot.curve(classical.iter().copied(), Pen::new(Ink::Wrong, 2.6))?;
    plot.curve(euler.iter().copied(), Pen::new(Ink::Wrong, 2.6))?;
    // Out of the top, as it leaves.
    let last = euler.last().copied().unwrap_or((0.0, 1.0));
    canvas.line(plot.at(last.0, last.1), plot.at(last.0 + 0.5 * STEP, SHOWN[1]), Pen::new(Ink::Wrong, 2.6));
    for (t, y, text, ink) in [
        (3.0, 1.043, "Euler: straight ahead", Ink::Wrong),
        (24.0, 1.026, "three rotations: sways", Ink::Text),
        (3.0, 0.949, "bold: Moser-Veselov keeps it", Ink::Text),
        (38.0, 0.968, "Runge-Kutta 4: sinks", Ink::Wrong),
    ] {
        canvas.label(plot.at(t, y), &Label::new(text).ink(ink).halo(Ink::Paper));
    }
    let spread = |seen: &[(f64, f64)]| seen.iter().map(|p| (p.1 - 1.0).abs()).fold(0.0_f64, f64::max);
    canvas.described(format!(
        "Energy of the box with a spin of (1, 1, 1) rad/s, as a share of the first, over {end:.0} s in steps of {STEP} s. Euler's method \
         leaves the sheet upward at the first step. The Runge-Kutta method sinks to {:.0} % after {:.0} s. The \
         splitting into three rotations sways by up to {:.1} %. Moser and Veselov's method stays level.",
        100.0 * classical.last().map_or(1.0, |p| p.1),
        classical.last().map_or(0.0, |p| p.0),
        100.0 * spread(&turns),
    ))
}
