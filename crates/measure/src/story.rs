//! The stories: bodies let go in some way, and where they truly are at the end.

use crate::drive::{Drive, Phase};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde_json::Value;
use tumbling::exact::FreeMotion;
use tumbling::step::{State, Stepper, System, Torque};
use tumbling::{Body, Error, Inertia};

/// What went wrong with a story, in words.
pub type Wrong = Box<dyn std::error::Error>;

/// A body let go in some way, and where it truly is at the end.
#[derive(Debug, Clone)]
pub struct Story {
    /// One word or two: the key in the record.
    pub name: &'static str,
    /// What it is, for the head of a figure.
    pub title: &'static str,
    /// The body and the torques at the start.
    pub system: System<f64>,
    /// One after another, in which the same torques act: one, but for thrusters that switch.
    pub phases: Vec<Phase>,
    /// The torques in numbers.
    pub drive: Drive,
    /// Attitude, and momentum in body axes, at time 0.
    pub start: State<f64>,
    /// When it ends, s.
    pub end: f64,
    /// Where it truly is then.
    pub truth: Truth,
}

/// Where a body truly is at the end of its story.
#[derive(Debug, Clone)]
pub struct Truth {
    /// Attitude, and momentum in body axes.
    pub motion: State<f64>,
    /// Kinetic energy and that of its place, J.
    pub energy: f64,
    /// The changes of sign of the spin along the middle axis, counted, and the instant of the last, s; of a
    /// free body alone.
    pub flips: Option<Flips>,
}

/// Changes of sign of the spin along the middle axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flips {
    /// How many.
    pub count: u64,
    /// When the last was, s.
    pub last: f64,
    /// From one to the next, s.
    pub apart: f64,
}

/// Where the bodies truly are, by the program that stands with the table.
const TABLE: &str = include_str!("../data/truth.json");

impl Story {
    /// The spin at the start, rad/s: what a step is judged by.
    #[must_use]
    pub fn speed(&self) -> f64 {
        self.system.omega(&self.start.momentum).norm()
    }

    /// How many times a body turning at that speed turns from start to end.
    #[must_use]
    pub fn turns(&self) -> f64 {
        self.speed() * self.end / std::f64::consts::TAU
    }

    /// Which component belongs to the middle moment.
    #[must_use]
    pub fn middle(&self) -> usize {
        let moments = self.system.moments();
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
        order[1]
    }

    /// Kinetic energy and that of its place, J. The attitude may have any length.
    #[must_use]
    pub fn energy(&self, motion: &State<f64>) -> f64 {
        let kinetic =
            tumbling::dynamics::observe::energy(&self.system.omega(&motion.momentum), &motion.momentum);
        let place = |torque: &Torque<f64>| match torque {
            Torque::Aligning { arm, field } => -arm.dot(&in_body(&motion.attitude, field)),
            _ => 0.0,
        };
        kinetic + self.system.torques().iter().map(place).sum::<f64>()
    }

    /// Whether its energy stays what it was.
    #[must_use]
    pub fn keeps_energy(&self) -> bool {
        let stays =
            |phase: &Phase| phase.system.torques().iter().all(|t| matches!(t, Torque::Aligning { .. }));
        self.phases.iter().all(stays)
    }

    /// Whether no torque ever acts.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.phases.iter().all(|phase| phase.system.torques().is_empty())
    }

    /// The body at the start, for a stepper that counts the time.
    ///
    /// # Errors
    /// A tensor or state that the library refuses.
    pub fn stepper(&self, made: impl Fn(&Body) -> Result<Stepper, Error>) -> Result<Stepper, Error> {
        let [a, b, c] = (*self.system.moments()).into();
        let omega = self.system.omega(&self.start.momentum);
        let body = Body::spinning(Inertia::from_moments(a, b, c)?, UnitQuaternion::identity(), &omega)?;
        made(&body)?.with_torques(self.system.torques().iter().cloned())
    }

    /// From its entry in the table.
    fn read(entry: &Value, name: &'static str, title: &'static str) -> Result<Self, Wrong> {
        let moments = vector(&entry["moments"])?;
        let drive = Drive::read(entry)?;
        let phases = drive.systems(&moments)?;
        let system = phases.first().ok_or("a story without a phase")?.system.clone();
        let start =
            State { attitude: Quaternion::identity(), momentum: system.momentum(&vector(&entry["omega"])?) };
        let [w, x, y, z] = numbers(&entry["attitude"])?;
        let motion = State { attitude: Quaternion::new(w, x, y, z), momentum: vector(&entry["momentum"])? };
        let end = number(&entry["t"])?;
        let truth = Truth { motion, energy: number(&entry["energy"])?, flips: None };
        let mut story = Self { name, title, system, phases, drive, start, end, truth };
        if story.is_free() {
            story.truth.flips = Some(flips(&story.system, &start, end)?);
        }
        Ok(story)
    }
}

/// Those of a free body, by the exact motion.
fn flips(system: &System<f64>, start: &State<f64>, end: f64) -> Result<Flips, Wrong> {
    let exact = FreeMotion::new((*system.moments()).try_into()?, &system.omega(&start.momentum))?;
    let times: Vec<f64> = exact.flips(0.0, end)?.collect();
    let [.., before, last] = times.as_slice() else { return Err("fewer than two flips".into()) };
    Ok(Flips { count: u64::try_from(times.len())?, last: *last, apart: last - before })
}

/// Names of the stories, as in the table, and what they are.
const STORIES: [(&str, &str); 12] = [
    ("box", "the box, 100 flips"),
    ("wobble", "a stable wobble"),
    ("racket", "a tennis racket"),
    ("needle", "a needle, 1000 to 1"),
    ("near sphere", "nearly a sphere"),
    ("heavy top", "a heavy top"),
    ("sleeping top", "a sleeping top"),
    ("damped spin", "a damped spin"),
    ("gravity gradient", "a satellite in orbit"),
    ("thruster pulses", "thruster pulses"),
    ("resonant push", "a push in resonance"),
    ("stiff damping", "stiff, uneven damping"),
];

/// All stories.
///
/// # Errors
/// A table that cannot be read, or a body that the library refuses.
pub fn all() -> Result<Vec<Story>, Wrong> {
    let table: Value = serde_json::from_str(TABLE)?;
    let entries = table["stories"].as_array().ok_or("a table without stories")?;
    STORIES
        .iter()
        .map(|&(name, title)| {
            let entry = entries.iter().find(|entry| entry["name"] == name);
            Story::read(entry.ok_or_else(|| format!("{name} is not in the table"))?, name, title)
        })
        .collect()
}

/// A world vector in the axes of a body with this attitude, of whatever length.
fn in_body(attitude: &Quaternion<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    tumbling::attitude::rotation_matrix(attitude).tr_mul(v) / attitude.norm_squared()
}

/// A body vector in the axes of the world.
#[must_use]
pub fn in_world(attitude: &Quaternion<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    tumbling::attitude::rotation_matrix(attitude) * v / attitude.norm_squared()
}

pub(crate) fn number(value: &Value) -> Result<f64, Wrong> {
    match value {
        Value::String(digits) => Ok(digits.parse()?),
        other => other.as_f64().ok_or_else(|| format!("{other} is no number").into()),
    }
}

pub(crate) fn numbers<const N: usize>(value: &Value) -> Result<[f64; N], Wrong> {
    let list = value.as_array().ok_or("not a list")?.iter().map(number).collect::<Result<Vec<_>, _>>()?;
    <[f64; N]>::try_from(list).map_err(|list| format!("{} numbers instead of {N}", list.len()).into())
}

pub(crate) fn vector(value: &Value) -> Result<Vector3<f64>, Wrong> {
    Ok(Vector3::from(numbers(value)?))
}
