//! What engines' rules make of a stable spin.

use super::{Drawing, Picture, power_of_ten};
use crate::draw::{Canvas, Label, Pen, Plot, Scale};
use crate::ink::Ink;
use nalgebra::{Quaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::{State, System};
use tumbling_judge::{PHYSICS_ENGINES, PhysicsEngine};

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];
const SPIN: [f64; 3] = [0.5, 0.5, 10.0];
const RATE: u32 = 60;
const STEPS: u32 = 1200;
/// Seconds.
const END: f64 = STEPS as f64 / RATE as f64;
/// The steps of half a second, more than one wobble: the tilt shown is the greatest within them.
const WINDOW: usize = 30;

/// One run: time, the spin's angle from the axis of the largest moment (degrees), the energy in parts of the
/// first.
struct Run {
    seen: Vec<[f64; 3]>,
    /// Where the engine starts anew.
    ends: bool,
}

impl Run {
    /// The greatest tilt within the last half second.
    fn tilts(&self) -> Vec<(f64, f64)> {
        (0..self.seen.len())
            .map(|k| {
                let last = &self.seen[k.saturating_sub(WINDOW)..=k];
                (self.seen[k][0], last.iter().map(|x| x[1]).fold(0.0, f64::max))
            })
            .collect()
    }

    fn energies(&self) -> Vec<(f64, f64)> {
        self.seen.iter().map(|x| (x[0], x[2])).collect()
    }

    fn last(&self) -> [f64; 3] {
        self.seen[self.seen.len() - 1]
    }
}

fn seen(system: &System<f64>, step: u32, omega: &Vector3<f64>) -> [f64; 3] {
    let energy = |omega: &Vector3<f64>| omega.dot(&system.momentum(omega));
    let tilt = (omega.z.abs() / omega.norm()).min(1.0).acos().to_degrees();
    [f64::from(step) / f64::from(RATE), tilt, energy(omega) / energy(&SPIN.into())]
}

fn run(engine: &PhysicsEngine) -> Result<Run, Box<dyn std::error::Error>> {
    let system = System::free(MOMENTS.try_into()?)?;
    let omega = Vector3::from(SPIN);
    let mut motion = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    let mut run = Run { seen: vec![seen(&system, 0, &omega)], ends: false };
    for step in 1..=STEPS {
        let Ok(next) = engine.step(&system, &motion, 1.0 / f64::from(RATE)) else {
            run.ends = true;
            break;
        };
        motion = next;
        run.seen.push(seen(&system, step, &system.omega(&motion.momentum)));
    }
    Ok(run)
}

fn exactly() -> Result<Run, Box<dyn std::error::Error>> {
    let system = System::free(MOMENTS.try_into()?)?;
    let motion = FreeMotion::new(MOMENTS.try_into()?, &SPIN.into())?;
    let at = |step: u32| Ok(seen(&system, step, &motion.omega(f64::from(step) / f64::from(RATE))?));
    let seen: Result<Vec<_>, tumbling::Error> = (0..=STEPS).map(at).collect();
    Ok(Run { seen: seen?, ends: false })
}

fn engine(name: &str, setting: &str) -> Result<&'static PhysicsEngine, String> {
    let found = PHYSICS_ENGINES.iter().find(|e| {
        e.name == name && e.setting.starts_with(setting) && e.version.is_none_or(|v| v != "3.17.0")
    });
    found.ok_or_else(|| format!("no {name}, {setting}"))
}

struct Runs {
    exact: Run,
    mujoco: Run,
    fourth: Run,
    bullet: Run,
    newton: Run,
    rapier: Run,
    rescaled: Run,
    without: Run,
}

pub(super) fn draw() -> Drawing {
    let runs = Runs {
        exact: exactly()?,
        mujoco: run(engine("MuJoCo", "Euler")?)?,
        fourth: run(engine("MuJoCo", "RK4")?)?,
        bullet: run(engine("Bullet", "multibody")?)?,
        newton: run(engine("Bullet", "rigid")?)?,
        rapier: run(engine("Rapier", "")?)?,
        rescaled: run(engine("Jolt", "")?)?,
        without: run(engine("PhysX, Unity", "")?)?,
    };
    let canvas = Canvas::new(780);
    tilts(&canvas, &runs)?;
    energies(&canvas, &runs)?;
    let Runs { exact, mujoco, fourth, bullet, newton, rapier, rescaled, without } = &runs;
    let greatest = |run: &Run| run.seen.iter().map(|x| x[1]).fold(0.0, f64::max);
    let heat = bullet.seen.iter().map(|x| x[2]).fold(0.0, f64::max);
    Ok(Picture {
        canvas,
        description: format!(
            "A free body with moments 1, 2 and 3 kg m², spun at (0.5, 0.5, 10) rad/s, {RATE} steps a second for {END:.0} s. Above, the \
             spin's angle from its stable axis, the greatest within half a second. Exactly it stays within {:.1}°, by MuJoCo's RK4 within \
             {:.1}°, without gyroscopic term within {:.1}°. It passes 60° by the explicit rule after {:.1} s, by the rescaled one \
             after {:.1} s, by Rapier after {:.1} s. By one Newton step it sinks to {:.1}°. Below, the energy: by MuJoCo's Euler {:.0e} \
             times the first after {:.1} s{}; by Bullet's multibody, which cuts off spin beyond 100 rad/s, up to {:.0} times; at the \
             end by the rescaled rule {:.2} times, by Rapier {:.2} times, by one Newton step {:.3} times.",
            greatest(exact),
            greatest(fourth),
            greatest(without),
            passes(mujoco),
            passes(rescaled),
            passes(rapier),
            newton.last()[1],
            mujoco.last()[2],
            mujoco.last()[0],
            if mujoco.ends { ", where the engine puts the body back to rest" } else { "" },
            heat,
            rescaled.last()[2],
            rapier.last()[2],
            newton.last()[2],
        ),
    })
}

fn times() -> impl Iterator<Item = (f64, String)> {
    (0..=4).map(|k| (5.0 * f64::from(k), (5 * k).to_string()))
}

fn wrong(width: f64) -> Pen {
    Pen::new(Ink::Wrong, width)
}

fn write(canvas: &Canvas, plot: &Plot, at: (f64, f64), text: &str, ink: Ink) {
    canvas.label(plot.at(at.0, at.1), &Label::new(text).ink(ink).halo(Ink::Paper));
}

fn tilts(canvas: &Canvas, runs: &Runs) -> Result<(), Box<dyn std::error::Error>> {
    let upper =
        Plot::new(canvas, 62.0, 48.0, 650.0, 408.0, Scale::linear(0.0..END), Scale::linear(-13.0..96.0));
    upper.x_axis(times(), "");
    upper.y_axis(
        [0, 30, 60, 90].map(|y| (f64::from(y), format!("{y}°"))),
        "angle between the spin and its stable axis",
    );
    upper.curve(runs.bullet.tilts().into_iter().filter(|p| p.0 <= runs.mujoco.last()[0]), wrong(3.0))?;
    upper.curve(runs.rescaled.tilts(), wrong(2.2).dashed())?;
    upper.curve(runs.rapier.tilts(), wrong(2.2).dash_dotted())?;
    upper.curve(runs.newton.tilts(), wrong(2.2).dotted())?;
    upper.curve(runs.exact.tilts(), Pen::new(Ink::Text, 3.2))?;
    let lines = [(86.0, "explicit:"), (79.0, "MuJoCo,"), (72.0, "Bullet's"), (65.0, "multibody")];
    for (y, text) in lines {
        write(canvas, &upper, (0.2, y), text, Ink::Wrong);
    }
    write(canvas, &upper, (6.6, 64.0), "rescaled: Jolt, flag on", Ink::Wrong);
    write(canvas, &upper, (12.4, 36.0), "rescaled, in four parts:", Ink::Wrong);
    write(canvas, &upper, (12.4, 29.0), "Rapier", Ink::Wrong);
    write(canvas, &upper, (8.2, 8.5), "exact; RK4; no gyroscopic term", Ink::Text);
    write(
        canvas,
        &upper,
        (1.2, -9.0),
        "one Newton step: Bullet's rigid body, MuJoCo's implicitfast",
        Ink::Wrong,
    );
    Ok(())
}

fn energies(canvas: &Canvas, runs: &Runs) -> Result<(), Box<dyn std::error::Error>> {
    let lower = Plot::new(canvas, 62.0, 490.0, 650.0, 700.0, Scale::linear(0.0..END), Scale::log(0.1..1e13));
    lower.x_axis(times(), "time $t$ (s)");
    lower.y_axis(
        (0..=3).map(|n| (10_f64.powi(4 * n), power_of_ten(4 * n))),
        "energy, in parts of what it was",
    );
    lower.curve(runs.bullet.energies(), wrong(2.2))?;
    lower.curve(runs.mujoco.energies(), wrong(3.0))?;
    for run in [&runs.rescaled, &runs.rapier] {
        lower.curve(run.energies(), wrong(2.0).dashed())?;
    }
    lower.curve(runs.exact.energies(), Pen::new(Ink::Text, 3.2))?;
    let most = runs.mujoco.last();
    lower.dots([(most[0], most[2])], 5.0, Ink::Wrong)?;
    write(canvas, &lower, (most[0] + 0.4, most[2] * 0.2), "MuJoCo's Euler: put back to rest", Ink::Wrong);
    write(canvas, &lower, (8.0, 5e3), "Bullet's multibody: cut at 100 rad/s", Ink::Wrong);
    write(canvas, &lower, (8.0, 2.6), "the others", Ink::Text);
    Ok(())
}

/// When the tilt first exceeds 60 degrees, s.
fn passes(run: &Run) -> f64 {
    run.seen.iter().find(|x| x[1] > 60.0).map_or(f64::INFINITY, |x| x[0])
}
