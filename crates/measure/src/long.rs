//! Long runs: the energy of a free body after a million turns.

use crate::contestant::Contestant;
use crate::ended::Failure;
use crate::errors::Outcome;
use crate::measure::Effort;
use crate::operations::evaluations_of_step;
use crate::record::Long;
use nalgebra::{Quaternion, Vector3};
use std::f64::consts::TAU;
use tumbling::PrincipalMoments;
use tumbling::step::{Method, State, System};

/// Steps in a turn of the spin.
pub const STEPS: u32 = 20;

/// The document's box, and spins that differ a little from start to start.
fn start(k: u32) -> Option<(System<f64>, State<f64>, f64)> {
    let system = System::free(PrincipalMoments::new(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0).ok()?).ok()?;
    let omega = Vector3::new(0.6 + 0.07 * f64::from(k), 0.5, 0.7 - 0.05 * f64::from(k));
    let h = TAU / (f64::from(STEPS) * omega.norm());
    Some((system.clone(), State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) }, h))
}

/// Errors gathered over a window.
#[derive(Debug, Clone, Copy, Default)]
struct Window {
    sum: f64,
    count: f64,
    energy: f64,
    momentum: f64,
}

/// The ends of the windows, in turns: 1, 2, 4 and so on, and the last.
fn ends(turns: u64) -> Vec<u64> {
    let mut ends: Vec<u64> = (0..).map(|k| 1_u64 << k).take_while(|&n| n < turns).collect();
    ends.push(turns);
    ends
}

/// Those that keep something, and the classical Runge-Kutta method for comparison.
pub fn all(contestants: &[Box<dyn Contestant>], effort: Effort, tell: &mut dyn FnMut(&str)) -> Vec<Long> {
    let mut rows = Vec::new();
    for contestant in contestants {
        let Some(method) = contestant.method() else { continue };
        if !contestant.keeps_something() && method != Method::RungeKutta4 {
            continue;
        }
        tell(&format!("{} turns: {}", effort.turns, contestant.name()));
        let starts = starts(method, effort);
        rows.extend(run(method, contestant.about().group.word(), effort.turns, starts));
    }
    rows
}

/// From how many starts this method runs: from fewer where its steps are dear.
fn starts(method: Method, effort: Effort) -> u32 {
    let Some((system, motion, h)) = start(0) else { return effort.starts };
    let Some(each) = evaluations_of_step(method, &system, &motion, h) else { return effort.starts };
    let one = each * f64::from(STEPS) * effort.turns as f64;
    ((effort.long / one) as u32).clamp(1, effort.starts.max(1))
}

/// One method through this number of turns from each of these starts.
#[must_use]
pub fn run(method: Method, group: &str, turns: u64, starts: u32) -> Vec<Long> {
    let ends = ends(turns);
    let runs: Vec<(Vec<Window>, Outcome)> =
        (0..starts).filter_map(|k| start(k).map(|(s, m, h)| one(method, &s, m, h, &ends))).collect();
    let mut rows = Vec::new();
    for (at, &end) in ends.iter().enumerate() {
        let windows: Vec<Window> = runs.iter().filter_map(|(windows, _)| windows.get(at).copied()).collect();
        if windows.len() < runs.len() || runs.is_empty() {
            break;
        }
        let rms = |of: fn(&Window) -> f64| {
            let squares: Vec<f64> = windows.iter().map(|w| of(w).powi(2)).collect();
            (squares.iter().sum::<f64>() / f64::from(starts)).sqrt()
        };
        rows.push(Long {
            contestant: method.info().name.into(),
            group: group.into(),
            steps: STEPS,
            turns: end,
            mean: rms(|w| w.sum / w.count),
            largest: rms(|w| w.energy),
            momentum: rms(|w| w.momentum),
            outcome: Outcome::Right,
        });
    }
    // What went wrong, once, after the last window that all came through.
    if let Some((_, outcome)) = runs.iter().find(|(_, outcome)| *outcome != Outcome::Right) {
        rows.push(Long {
            contestant: method.info().name.into(),
            group: group.into(),
            steps: STEPS,
            turns: ends.get(rows.len()).copied().unwrap_or(turns),
            mean: f64::NAN,
            largest: f64::NAN,
            momentum: f64::NAN,
            outcome: outcome.clone(),
        });
    }
    rows
}

fn one(
    method: Method,
    system: &System<f64>,
    start: State<f64>,
    h: f64,
    ends: &[u64],
) -> (Vec<Window>, Outcome) {
    let energy =
        |m: &State<f64>| tumbling::dynamics::observe::energy(&system.omega(&m.momentum), &m.momentum);
    let (energy0, momentum0) = (energy(&start), start.momentum.norm());
    let mut windows = Vec::new();
    let mut motion = start;
    let mut done = 0;
    for &end in ends {
        let mut window = Window::default();
        for _ in done..end {
            for _ in 0..STEPS {
                motion = match method.step(system, &motion, h) {
                    Ok(motion) => motion,
                    Err(e) => return (windows, Failure::from(e).into()),
                };
                let off = energy(&motion) / energy0 - 1.0;
                window.sum += off;
                window.count += 1.0;
                window.energy = window.energy.max(off.abs());
                window.momentum = window.momentum.max((motion.momentum.norm() / momentum0 - 1.0).abs());
            }
        }
        done = end;
        if !(window.sum.is_finite() && window.energy.is_finite()) {
            return (windows, Outcome::NotFinite);
        }
        windows.push(window);
    }
    (windows, Outcome::Right)
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
