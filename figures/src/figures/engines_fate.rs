//! A stable spin in several engines, each with its default rule and step.

use super::{Drawing, NARROW};
use crate::draw::{Canvas, Ink, Label, Pen, Plot};
use nalgebra::{Quaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::{State, System};
use tumbling_engines::{PHYSICS_ENGINES, PhysicsEngine};

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];
const SPIN: [f64; 3] = [0.5, 0.5, 10.0];
/// Seconds.
const END: u32 = 60;
/// Lean beyond which a body is lost, degrees: its curve ends there.
const LOST: f64 = 80.0;

/// An engine by name and setting, its default steps per second, its label, and the place of the label.
type Engine = (&'static str, &'static str, u32, &'static str, (f64, f64));

const ENGINES: [Engine; 3] = [
    ("Bullet", "multibody", 240, "pybullet, 240/s", (0.8, 86.0)),
    ("Rapier", "", 60, "Rapier, 60/s", (25.5, 86.0)),
    ("MuJoCo", "Euler", 500, "MuJoCo, 500/s", (38.0, 70.0)),
];

/// The angle between a spin and the axis of the largest moment, degrees.
fn lean(omega: &Vector3<f64>) -> f64 {
    (omega.z.abs() / omega.norm()).min(1.0).acos().to_degrees()
}

/// The greatest lean within each half second of angles seen at a rate, up to where the body is lost.
fn greatest(seen: &[f64], rate: u32) -> Vec<(f64, f64)> {
    let half = rate as usize / 2;
    let all = seen.chunks(half).enumerate().map(|(k, part)| {
        (0.5 * f64::from(u32::try_from(k).unwrap_or(0)), part.iter().copied().fold(0.0, f64::max))
    });
    let mut points: Vec<(f64, f64)> = all.collect();
    if let Some(lost) = points.iter().position(|point| point.1 > LOST) {
        points.truncate(lost + 1);
        points[lost].1 = LOST;
    }
    points
}

fn run(engine: &PhysicsEngine, rate: u32) -> Result<Vec<(f64, f64)>, Box<dyn std::error::Error>> {
    let system = System::free(MOMENTS.try_into()?)?;
    let omega = Vector3::from(SPIN);
    let mut motion = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    let mut seen = vec![lean(&omega)];
    for _ in 0..END * rate {
        let Ok(next) = engine.step(&system, &motion, 1.0 / f64::from(rate)) else { break };
        motion = next;
        seen.push(lean(&system.omega(&motion.momentum)));
    }
    Ok(greatest(&seen, rate))
}

fn exactly() -> Result<Vec<(f64, f64)>, Box<dyn std::error::Error>> {
    let motion = FreeMotion::new(MOMENTS.try_into()?, &SPIN.into())?;
    let at = |k: u32| Ok(lean(&motion.omega(f64::from(k) / 60.0)?));
    let seen: Result<Vec<f64>, tumbling::Error> = (0..END * 60).map(at).collect();
    Ok(greatest(&seen?, 60))
}

pub(super) fn draw() -> Drawing {
    let canvas = Canvas::sized(NARROW, 380);
    let plot = Plot::new(&canvas, [62.0, 50.0, 484.0, 316.0], 0.0..f64::from(END), 0.0..94.0);
    plot.x_axis((0..=4).map(|k| (15.0 * f64::from(k), (15 * k).to_string())), "time $t$ (s)");
    plot.y_axis([0, 30, 60, 90].map(|y| (f64::from(y), format!("{y}°"))), "lean of the spin from its axis");
    let mut sentences = Vec::new();
    for (name, setting, rate, words, at) in ENGINES {
        let of = |e: &&PhysicsEngine| e.name == name && e.setting.starts_with(setting);
        let engine = PHYSICS_ENGINES.iter().find(of).ok_or("no such engine")?;
        let points = run(engine, rate)?;
        let passes = points.iter().find(|point| point.1 > 60.0).map_or(f64::INFINITY, |point| point.0);
        plot.curve(points, Pen::new(Ink::Wrong, 2.8))?;
        let label = Label::new(words).ink(Ink::Wrong).halo(Ink::Paper);
        canvas.label(plot.at(at.0, at.1), &label);
        sentences.push(format!("{words}, in steps: passes 60° at about {passes:.0} s"));
    }
    let exact = exactly()?;
    let most = exact.iter().map(|point| point.1).fold(0.0, f64::max);
    plot.curve(exact, Pen::new(Ink::Text, 3.4))?;
    canvas.label(plot.at(34.0, 8.5), &Label::new("exact, fixed_rate").halo(Ink::Paper));
    canvas.described(format!(
        "A free body with moments 1, 2 and 3 kg m², spun at (0.5, 0.5, 10) rad/s for {END} s: the angle between the spin and the axis of \
         the largest moment, the greatest in each half second. Exactly it stays within {most:.1}°. By the engines' own defaults: {}.",
        sentences.join("; ")
    ))
}
