//! What engines did, as recorded: the runs committed in `data`, and the table made of them.

use crate::Error;
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude;

/// A recorded run of an engine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Recorded {
    /// The engine, as [`PhysicsEngine::record`](crate::PhysicsEngine::record) names it.
    pub engine: &'static str,
    /// The story: which body, and how it was spun.
    pub story: &'static str,
    /// The record itself, as the judge takes it.
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
/// use tumbling_engines::RECORDED;
/// let run = RECORDED.iter().find(|run| (run.engine, run.story) == ("rapier3d-f64-0.36.1", "fast")).unwrap();
/// // 60 rad/s at the start, and a step later no more than an eighth of a turn a step.
/// let rows = run.read()?.rows;
/// assert_eq!((rows[0].omega.z, rows[1].step), (60.0, 1));
/// assert!(rows[1].omega.norm() < 47.2);
/// # Ok::<(), tumbling_engines::Error>(())
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
    /// A line that is not as those of the committed records.
    pub fn read(&self) -> Result<Trajectory, Error> {
        let mut lines = self.text.lines();
        let [about, names] = [lines.next(), lines.next()].map(Option::unwrap_or_default);
        let about = |what| about.split_once(what).and_then(|(_, numbers)| first(numbers.split_whitespace()));
        let ([a, b, c], [x, y, z]) = about("moments ").zip(about("torque ")).ok_or(Error::Line(1))?;
        let in_world = names.ends_with("wxw,wyw,wzw");
        let row = |(at, line): (usize, &str)| {
            let step = line.split(',').next().and_then(|step| step.parse().ok());
            let numbers = first(line.split(',').skip(1));
            let (step, [qw, qx, qy, qz, wx, wy, wz]) = step.zip(numbers).ok_or(Error::Line(at + 3))?;
            let (attitude, spin) = (Quaternion::new(qw, qx, qy, qz), Vector3::new(wx, wy, wz));
            let omega = if in_world { attitude::rotation_matrix(&attitude).tr_mul(&spin) } else { spin };
            Ok::<_, Error>(RecordedRow { step, attitude, omega })
        };
        let rows = lines.enumerate().map(row).collect::<Result<_, Error>>()?;
        Ok(Trajectory { moments: Vector3::new(a, b, c), torque: Vector3::new(x, y, z), rows })
    }
}

/// As many numbers as are wanted, from the first words.
fn first<'a, const N: usize>(words: impl Iterator<Item = &'a str>) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = words.take(N).map(|word| word.parse().ok()).collect();
    numbers?.try_into().ok()
}

/// The table of engines, by rule; a test holds it to the records.
///
/// ```
/// use tumbling_engines::table;
/// let whole: Vec<&str> = table().filter(|line| line.steps == [None; 2]).map(|line| line.name).collect();
/// assert_eq!(whole, ["MuJoCo 4, RK4", "MuJoCo 3, RK4", "MJX 3, RK4", "Drake, error-controlled"]);
/// ```
pub fn table() -> impl Iterator<Item = Kept> {
    include_str!("../data/table.tsv").lines().skip(1).filter_map(|line| {
        let [record, name, rule, of_box, largest] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
        Some(Kept { record, name, rule, steps: [of_box, largest].map(|step| step.parse().ok()) })
    })
}
