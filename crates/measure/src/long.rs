//! Long runs: the energy of a free body after a million turns.

use crate::contestant::{Contestant, Group};
use crate::errors::Outcome;
use crate::measure::Effort;
use crate::record::{Long, short};
use nalgebra::{Quaternion, Vector3};
use std::f64::consts::TAU;
use std::time::Instant;
use tumbling::dynamics::observe;
use tumbling::step::{Method, State, System};
use tumbling::{Error, PrincipalMoments};

/// Steps in a turn of the spin.
pub const STEPS: u32 = 20;

/// The document's box, and spins that differ a little from start to start.
fn start(k: u32) -> Result<(System<f64>, State<f64>, f64), Error> {
    let system = System::free(PrincipalMoments::new(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0)?)?;
    let omega = Vector3::new(0.6 + 0.07 * f64::from(k), 0.5, 0.7 - 0.05 * f64::from(k));
    let start = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    Ok((system, start, TAU / (f64::from(STEPS) * omega.norm())))
}

/// Errors gathered over a window.
#[derive(Debug, Clone, Copy, Default)]
struct Window {
    sum: f64,
    energy: f64,
    momentum: f64,
}

/// The ends of the windows, in turns: 1, 2, 4 and so on, and the last.
fn ends(turns: u64) -> Vec<u64> {
    (0..63).map(|k| 1_u64 << k).take_while(|&n| n < turns).chain([turns]).collect()
}

/// Those that keep something, and the classical Runge-Kutta method for comparison.
pub fn all(contestants: &[Box<dyn Contestant>], effort: Effort, progress: &mut dyn FnMut(&str)) -> Vec<Long> {
    let mut rows = Vec::new();
    for contestant in contestants {
        let (Some(method), about) = (contestant.method(), contestant.about()) else { continue };
        if matches!(about.group, Group::Both | Group::Momentum) || method == Method::RungeKutta4 {
            progress(&format!("{} turns: {}", effort.turns, about.name));
            rows.extend(run(method, effort));
        }
    }
    rows
}

/// One method from each of the starts that the effort has time for.
#[must_use]
pub fn run(method: Method, effort: Effort) -> Vec<Long> {
    let (ends, began) = (ends(effort.turns), Instant::now());
    let in_time = |k: &u32| *k == 0 || began.elapsed().as_secs_f64() < effort.long;
    let runs: Vec<_> = (0..effort.starts).take_while(in_time).map(|k| one(method, k, &ends)).collect();
    // The windows that all starts completed, and then one more row with the error.
    let through = runs.iter().map(|(windows, _)| windows.len()).min().unwrap_or(0);
    let failed = runs.iter().find_map(|(_, outcome)| outcome.as_ref().err());
    let row = |(at, &turns): (usize, &u64)| {
        let rms = |of: fn(&Window) -> f64| {
            let squares = runs.iter().map(|(windows, _)| windows.get(at).map_or(f64::NAN, of).powi(2));
            short((squares.sum::<f64>() / runs.len() as f64).sqrt())
        };
        Long {
            contestant: method.info().name.into(),
            group: Group::of(method.info()).word().into(),
            steps: STEPS,
            turns,
            mean: rms(|window| window.sum),
            largest: rms(|window| window.energy),
            momentum: rms(|window| window.momentum),
            outcome: failed.filter(|_| at == through).unwrap_or(&Outcome::Right).to_string(),
        }
    };
    ends.iter().enumerate().take(through + usize::from(failed.is_some())).map(row).collect()
}

/// The completed windows of one start, and the reason why it ended.
fn one(method: Method, k: u32, ends: &[u64]) -> (Vec<Window>, Result<(), Outcome>) {
    let mut windows = Vec::new();
    let outcome = start(k).map_err(Outcome::from).and_then(|(system, mut motion, h)| {
        let energy = |m: &State<f64>| observe::energy(&system.omega(&m.momentum), &m.momentum);
        let (energy0, momentum0, mut done) = (energy(&motion), motion.momentum.norm(), 0);
        for &end in ends {
            let mut window = Window::default();
            let steps = u64::from(STEPS) * (end - done);
            for _ in 0..steps {
                motion = method.step(&system, &motion, h)?;
                let off = energy(&motion) / energy0 - 1.0;
                window.sum += off / steps as f64;
                window.energy = window.energy.max(off.abs());
                window.momentum = window.momentum.max((motion.momentum.norm() / momentum0 - 1.0).abs());
            }
            done = end;
            if !(window.sum.is_finite() && window.energy.is_finite()) {
                return Err(Outcome::NotFinite);
            }
            windows.push(window);
        }
        Ok(())
    });
    (windows, outcome)
}

/// The slope of a line through logarithms of error against logarithms of turns, by least squares, over rows
/// of at least this number of turns; `None` from fewer than three, or where there is no error.
#[must_use]
pub fn slope<'a>(rows: impl IntoIterator<Item = &'a Long>, from: u64, of: fn(&Long) -> f64) -> Option<f64> {
    let points: Vec<(f64, f64)> = rows
        .into_iter()
        .filter(|row| row.turns >= from && of(row) > 0.0)
        .map(|row| ((row.turns as f64).ln(), of(row).ln()))
        .collect();
    if points.len() < 3 {
        return None;
    }
    let n = points.len() as f64;
    let (mx, my) = points.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
    let (xy, xx) =
        points.iter().fold((0.0, 0.0), |s, p| (s.0 + (p.0 - mx) * (p.1 - my), s.1 + (p.0 - mx).powi(2)));
    Some(xy / xx)
}
