//! The atlas: the result of each method on each hard case under torques.
//!
//! A chart sweeps one difficulty: a damping, a weight, a needle's thinness, the frequency of a push.
//! `data/atlas.py` computed the true final state of the body of each case to 20 digits, by Taylor series that
//! share no code with the library. No time is measured, so every machine draws the same atlas.

use crate::AnyError;
use crate::drive::{Components, Drive, digits};
use crate::errors::turn;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde::Deserialize;
use tumbling::step::{Method, State, Stepper};
use tumbling::{Body, Error, Inertia};

/// How a run on a hard case ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    /// The momentum is right to a hundredth, the attitude to a tenth of a radian.
    Right,
    /// The attitude is off by more than a tenth of a radian, or the momentum's direction by as much.
    Late,
    /// The momentum is off by more than a hundredth, and no more than a tenth.
    Inaccurate,
    /// The momentum is more than a tenth too long.
    Gained,
    /// The momentum is more than a tenth too short.
    Lost,
    /// An error that says why.
    Refused,
    /// Infinite or not a number, without an error.
    NotFinite,
}

impl Fate {
    /// One word or two.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Late => "late",
            Self::Inaccurate => "inaccurate",
            Self::Gained => "gained",
            Self::Lost => "lost",
            Self::Refused => "refused",
            Self::NotFinite => "not finite",
        }
    }
}

/// The relative error that the adaptive run is allowed.
pub const TOLERANCE: f64 = 1e-10;

/// The charts, in their order.
pub const CHARTS: [&str; 7] = ["drag", "one axis", "weight", "shapes", "stop", "resonance", "blow"];

/// A hard case.
#[derive(Debug, Clone, Deserialize)]
pub struct Case {
    /// The chart that it belongs to.
    pub chart: String,
    /// What it is called, or the value that is swept.
    pub name: String,
    /// Principal moments, kg m².
    pub moments: Components,
    /// The spin at the start, rad/s.
    pub omega: Components,
    /// The step of the methods with a fixed one, s.
    pub step: f64,
    /// When it ends, s.
    pub t: f64,
    /// What acts.
    #[serde(flatten)]
    pub drive: Drive,
    /// The true attitude at the end, scalar first.
    pub attitude: [String; 4],
    /// The true momentum at the end, body axes, kg m²/s.
    pub momentum: [String; 3],
}

/// All cases, a chart after another, the mildest first.
///
/// # Errors
/// A table that cannot be read.
pub fn cases() -> Result<Vec<Case>, AnyError> {
    #[derive(Deserialize)]
    struct Table {
        cases: Vec<Case>,
    }
    let Table { cases } = serde_json::from_str(include_str!("../data/atlas.json"))?;
    Ok(cases.into_iter().map(|case| Case { drive: case.drive.until(case.t), ..case }).collect())
}

impl Case {
    /// The true state at the end.
    ///
    /// # Errors
    /// A number of the table that cannot be read.
    pub fn truth(&self) -> Result<State<f64>, AnyError> {
        let [w, x, y, z] = digits(&self.attitude)?;
        Ok(State { attitude: Quaternion::new(w, x, y, z), momentum: digits(&self.momentum)?.into() })
    }

    /// The final state by a method at its fixed step, or by the adaptive run within a tolerance.
    ///
    /// # Errors
    /// An error of the library.
    pub fn run(&self, runner: Option<Method>, tolerance: f64) -> Result<State<f64>, Error> {
        let [a, b, c] = self.moments;
        let inertia = Inertia::from_moments(a, b, c)?;
        let mut body = Body::spinning(inertia, UnitQuaternion::identity(), &self.omega.into())?;
        for &(seconds, pulse) in &self.drive.phases {
            let (stepper, steps) = match runner {
                Some(method) => (Stepper::new(&body, method)?, (seconds / self.step).ceil().clamp(1.0, 1e5)),
                None => (Stepper::adaptive(&body, tolerance, 100_000)?, 1.0),
            };
            let mut stepper = stepper.with_torques(self.drive.torques(pulse))?;
            stepper.run(seconds / steps, steps as usize).try_for_each(|state| state.map(drop))?;
            body = stepper.body()?;
        }
        Ok(body.state())
    }

    /// How far one end is from another: the momentum as a share of the larger of those at start and end, and
    /// the angle, rad.
    #[must_use]
    pub fn off(&self, end: &State<f64>, truth: &State<f64>) -> [f64; 2] {
        let angle = turn(&end.attitude, &truth.attitude);
        [(end.momentum - truth.momentum).norm() / self.scale(truth), angle]
    }

    fn scale(&self, truth: &State<f64>) -> f64 {
        let [moments, omega] = [self.moments, self.omega].map(Vector3::from);
        moments.component_mul(&omega).norm().max(truth.momentum.norm())
    }

    /// The result in `f64`; the adaptive run has the tolerance [`TOLERANCE`].
    ///
    /// # Errors
    /// A number of the table that cannot be read.
    pub fn fate(&self, runner: Option<Method>) -> Result<Fate, AnyError> {
        let truth = self.truth()?;
        let Ok(end) = self.run(runner, TOLERANCE) else { return Ok(Fate::Refused) };
        let [momentum, angle] = self.off(&end, &truth);
        Ok(match (end.momentum.norm() - truth.momentum.norm()) / self.scale(&truth) {
            longer if !(longer + momentum + angle).is_finite() => Fate::NotFinite,
            longer if longer > 0.1 => Fate::Gained,
            longer if longer < -0.1 => Fate::Lost,
            _ if momentum > 0.1 || angle > 0.1 => Fate::Late,
            _ if momentum > 0.01 => Fate::Inaccurate,
            _ => Fate::Right,
        })
    }
}

/// The results of the adaptive run and of every method on each of these cases, in their order.
///
/// # Errors
/// A number of the table that cannot be read.
pub fn fates(cases: &[Case]) -> Result<Vec<(&'static str, Vec<Fate>)>, AnyError> {
    let methods = Method::ALL.iter().copied().map(Some);
    let ends = |runner: Option<Method>| {
        let name = runner.map_or("adaptive", |method| method.info().name);
        Ok((name, cases.iter().map(|case| case.fate(runner)).collect::<Result<_, _>>()?))
    };
    [None].into_iter().chain(methods).map(ends).collect()
}

/// The lines of a table: for each of [`fates`] and each of the [`CHARTS`], in how many cases it is right, and
/// how many it refuses.
#[must_use]
pub fn table(cases: &[Case], fates: &[(&str, Vec<Fate>)]) -> Vec<String> {
    let line = |(name, fates): &(&str, Vec<Fate>)| {
        let cell = |chart: &str| {
            let here = cases.iter().zip(fates).filter(|(case, _)| case.chart == chart);
            let count = |fate| here.clone().filter(|(_, found)| **found == fate).count();
            match count(Fate::Refused) {
                0 => count(Fate::Right).to_string(),
                refused => format!("{}, {refused} refused", count(Fate::Right)),
            }
        };
        format!("| {name} | {} |", CHARTS.map(cell).join(" | "))
    };
    fates.iter().map(line).collect()
}

/// For a terminal: the result of each of [`fates`] on each case, chart by chart.
#[must_use]
pub fn text(cases: &[Case], fates: &[(&str, Vec<Fate>)]) -> String {
    let mut text = String::new();
    for chart in CHARTS {
        let of_chart = |case: &Case| case.chart == chart;
        let names: Vec<&str> = cases.iter().filter(|case| of_chart(case)).map(|case| &*case.name).collect();
        text += &format!("\n{chart}: {}\n", names.join(" | "));
        for (name, fates) in fates {
            let here = cases.iter().zip(fates).filter(|(case, _)| of_chart(case));
            let words: String = here.map(|(_, fate)| format!(" {:10}", fate.word())).collect();
            text += &format!("{name:28}{words}\n");
        }
    }
    text
}
