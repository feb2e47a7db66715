//! The stories: bodies with a start, and their true states at the end.

use crate::AnyError;
use crate::drive::{Components, Drive, digits};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde::Deserialize;
use tumbling::exact::FreeMotion;
use tumbling::step::{State, Stepper, System, Torque};
use tumbling::{Body, Error, Inertia};

/// A body with a start, and its true state at the end.
#[derive(Debug, Clone)]
pub struct Story {
    /// One word or two: the key in the record.
    pub name: &'static str,
    /// What it is, for the head of a figure.
    pub title: &'static str,
    /// The body and all its torques, each pulse for its time alone.
    pub system: System<f64>,
    /// One after another, in which the same torques act: one, but for thrusters that switch.
    pub phases: Vec<Phase>,
    /// The torques in numbers.
    pub drive: Drive,
    /// Attitude, and momentum in body axes, at time 0.
    pub start: State<f64>,
    /// When it ends, s.
    pub end: f64,
    /// Its true state then.
    pub truth: Truth,
}

/// A time in which the same torques act.
#[derive(Debug, Clone)]
pub struct Phase {
    /// s.
    pub seconds: f64,
    /// The body and its torques.
    pub system: System<f64>,
}

/// The true state of a body at the end of its story.
#[derive(Debug, Clone)]
pub struct Truth {
    /// Attitude, and momentum in body axes.
    pub motion: State<f64>,
    /// Kinetic and potential energy, J.
    pub energy: f64,
    /// The changes of sign of the spin along the middle axis; of a free body alone.
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

/// A story as the table has it.
#[derive(Deserialize)]
struct Entry {
    name: String,
    moments: Components,
    omega: Components,
    t: f64,
    attitude: [String; 4],
    momentum: [String; 3],
    energy: String,
    #[serde(flatten)]
    drive: Drive,
}

#[derive(Deserialize)]
struct Table {
    stories: Vec<Entry>,
}

impl Story {
    /// The spin at the start, rad/s, to which the length of a step is compared.
    #[must_use]
    pub fn speed(&self) -> f64 {
        self.system.omega(&self.start.momentum).norm()
    }

    /// Which component belongs to the middle moment.
    #[must_use]
    pub fn middle(&self) -> usize {
        let moments = self.system.moments();
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
        order[1]
    }

    /// Kinetic and potential energy, J. The attitude may have any length.
    #[must_use]
    pub fn energy(&self, motion: &State<f64>) -> f64 {
        let kinetic =
            tumbling::dynamics::observe::energy(&self.system.omega(&motion.momentum), &motion.momentum);
        let potential = |torque: &Torque<f64>| match torque {
            Torque::Aligning { arm, field } => -in_world(&motion.attitude, arm).dot(field),
            _ => 0.0,
        };
        kinetic + self.system.torques().iter().map(potential).sum::<f64>()
    }

    /// Whether its energy stays what it was.
    #[must_use]
    pub fn keeps_energy(&self) -> bool {
        self.system.torques().iter().all(|torque| matches!(torque, Torque::Aligning { .. }))
    }

    /// Whether no torque ever acts.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.system.torques().is_empty()
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

    fn read(entry: Entry, name: &'static str, title: &'static str) -> Result<Self, AnyError> {
        let drive = entry.drive.until(entry.t);
        let phase = |&(seconds, pulse): &(f64, Components)| {
            Ok::<_, Error>(Phase {
                seconds,
                system: System::with(entry.moments.try_into()?, drive.torques(pulse))?,
            })
        };
        let phases = drive.phases.iter().map(phase).collect::<Result<Vec<_>, _>>()?;
        let system = System::with(entry.moments.try_into()?, drive.throughout())?;
        let momentum = system.momentum(&entry.omega.into());
        let start = State { attitude: Quaternion::identity(), momentum };
        let [w, x, y, z] = digits(&entry.attitude)?;
        let motion =
            State { attitude: Quaternion::new(w, x, y, z), momentum: digits(&entry.momentum)?.into() };
        let truth = Truth { motion, energy: entry.energy.parse()?, flips: None };
        let mut story = Self { name, title, system, phases, drive, start, end: entry.t, truth };
        if story.is_free() {
            story.truth.flips = Some(flips(&story)?);
        }
        Ok(story)
    }
}

/// Those of a free body, by the exact motion.
fn flips(Story { system, start, end, .. }: &Story) -> Result<Flips, AnyError> {
    let exact = FreeMotion::new((*system.moments()).try_into()?, &system.omega(&start.momentum))?;
    let times: Vec<f64> = exact.flips(0.0, *end)?.collect();
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
pub fn all() -> Result<Vec<Story>, AnyError> {
    let Table { stories } = serde_json::from_str(include_str!("../data/truth.json"))?;
    let known = |entry: &Entry| STORIES.into_iter().find(|(name, _)| *name == entry.name);
    let read = |entry: Entry| {
        let (name, title) = known(&entry).ok_or_else(|| format!("{} is no story", entry.name))?;
        Story::read(entry, name, title)
    };
    stories.into_iter().map(read).collect()
}

/// A body vector in the axes of the world, by an attitude of any length.
#[must_use]
pub fn in_world(attitude: &Quaternion<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    tumbling::attitude::rotation_matrix(attitude) * v / attitude.norm_squared()
}
