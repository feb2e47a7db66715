//! What engines did, as recorded: the runs committed in `data`, and the table made of them.

use crate::error::Error;
use crate::read::{Raw, Rows, Source};
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude;

/// A recorded run of an engine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Recorded {
    /// The engine, as [`PhysicsEngine::record`](crate::PhysicsEngine::record) names it.
    pub engine: &'static str,
    /// The story: which body, and how it was spun.
    pub story: &'static str,
    /// The record itself, as [`judge`](crate::judge) takes it.
    pub text: &'static str,
}

/// A recorded run, read.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    /// Principal moments, kg m².
    pub moments: Vector3<f64>,
    /// A torque constant in the world, N m; zero for a free body.
    pub torque: Vector3<f64>,
    /// The rows, in the order of time.
    pub rows: Vec<RecordedRow>,
}

/// A row of a recorded run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecordedRow {
    /// How many steps after the start.
    pub step: usize,
    /// Body to world.
    pub attitude: Quaternion<f64>,
    /// In body axes, rad/s.
    pub omega: Vector3<f64>,
}

/// How long an engine, recorded in one setting, does what a free body does: a line of the table of engines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Kept {
    /// The engine's record, as [`PhysicsEngine::record`](crate::PhysicsEngine::record) names it.
    pub record: &'static str,
    /// The engine and its setting.
    pub name: &'static str,
    /// The rule, as the judge names it; `none known` of a rule that it does not know.
    pub rule: &'static str,
    /// The step at which energy or momentum is first off by more than 1 in 100, or the first flip is missed:
    /// of the box, which flips, and of a stable spin about the largest moment's axis. `None` where no such
    /// step is among the 1200 recorded, of a sixtieth of a second each.
    pub steps: [Option<usize>; 2],
}

macro_rules! recorded {
    ($($engine:literal: $($story:literal)+;)+) => {
        &[$($(Recorded {
            engine: $engine,
            story: $story,
            text: include_str!(concat!("../data/", $engine, "--", $story, ".csv")),
        }),+),+]
    };
}

/// Every recorded run.
///
/// ```
/// use tumbling_judge::records::RECORDED;
/// let run = RECORDED.iter().find(|run| (run.engine, run.story) == ("rapier3d-f64-0.36.1", "fast")).unwrap();
/// // 60 rad/s at the start, and a step later no more than an eighth of a turn a step.
/// let rows = run.read()?.rows;
/// assert_eq!((rows[0].omega.z, rows[1].step), (60.0, 1));
/// assert!(rows[1].omega.norm() < 47.2);
/// # Ok::<(), tumbling_judge::Error>(())
/// ```
pub const RECORDED: &[Recorded] = recorded! {
    "bullet-3.2.7-multibody": "box-middle" "fast" "major" "middle" "minor" "pushed" "wound";
    "bullet-3.2.7-multibody-1e9": "major" "minor";
    "bullet-3.2.7-rigid": "box-middle" "fast" "major" "middle" "minor" "pushed" "wound";
    "mujoco-3.17.0-rk4": "box-middle" "major" "middle" "minor";
    "mujoco-4.0.0-euler": "box-middle" "fast" "major" "middle" "minor" "pushed" "wound";
    "mujoco-4.0.0-implicitfast": "box-middle" "fast" "major" "middle" "minor" "pushed" "wound";
    "mujoco-4.0.0-rk4": "box-middle" "fast" "major" "middle" "minor" "pushed" "wound";
    "rapier3d-f64-0.36.1": "box-middle" "fast" "major" "middle" "minor" "pushed" "wound";
};

impl Recorded {
    /// Its numbers.
    ///
    /// # Errors
    /// A record that does not do, or has no moments or attitudes.
    pub fn read(&self) -> Result<Trajectory, Error> {
        let mut rows = Rows::open(self.text.as_bytes())?;
        let moments = rows.header.moments(&mut Vec::new())?.ok_or(Error::NoMoments)?;
        let torque = rows.header.torque.unwrap_or_default();
        let step = rows.header.step.unwrap_or(1.0);
        let mut read = Vec::new();
        while let Some(Raw { line, t, attitude, vector, .. }) = rows.next()? {
            let none = || Error::Line { line, problem: "the row has no attitude".into() };
            let attitude = attitude.ok_or_else(none)?;
            let step = (t / step).round() as usize;
            let world = rows.columns.kind.in_world();
            let omega = if world { attitude::rotation_matrix(&attitude).tr_mul(&vector) } else { vector };
            read.push(RecordedRow { step, attitude, omega });
        }
        Ok(Trajectory { moments, torque, rows: read })
    }
}

/// The table of engines, by rule; a test holds it to the records.
///
/// ```
/// use tumbling_judge::records::table;
/// let whole: Vec<&str> = table().filter(|line| line.steps == [None; 2]).map(|line| line.name).collect();
/// assert_eq!(whole, ["MuJoCo 4, RK4", "MuJoCo 3, RK4", "MJX 3, RK4", "Drake, error-controlled"]);
/// ```
pub fn table() -> impl Iterator<Item = Kept> {
    include_str!("../data/table.tsv").lines().skip(1).filter_map(|line| {
        let [record, name, rule, of_box, largest] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
        Some(Kept { record, name, rule, steps: [of_box, largest].map(|step| step.parse().ok()) })
    })
}
