//! The errors of a run: each kind of error separately, because a small error of energy says nothing about the
//! phase.

use crate::story::{Story, in_world};
use nalgebra::{Quaternion, Vector3};
use std::fmt;
use tumbling::exact::FreeMotion;
use tumbling::step::State;
use tumbling::{Error, ErrorKind};

/// Where a run ended, and what it took.
#[derive(Debug, Clone, PartialEq)]
pub struct Ended {
    /// Attitude, and momentum in body axes.
    pub motion: State<f64>,
    /// Steps done.
    pub steps: u64,
    /// The time it took by its own clock, s, where it runs in another process.
    pub seconds: Option<f64>,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// At the end, with every flip.
    Right,
    /// At the end, after another number of flips than the body makes.
    Flips(u64),
    /// A number in it is not finite.
    NotFinite,
    /// It refused, in these words.
    Refused(String),
}

impl From<Error> for Outcome {
    fn from(error: Error) -> Self {
        match error.kind() {
            ErrorKind::Unrepresentable | ErrorKind::NotFinite => Self::NotFinite,
            _ => Self::Refused(error.to_string()),
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Right => f.write_str("right"),
            Self::Flips(count) => write!(f, "{count} flips"),
            Self::NotFinite => f.write_str("not finite"),
            Self::Refused(why) => write!(f, "refused: {why}"),
        }
    }
}

/// The errors of a run, each by itself. An error that does not exist (of flips under a torque) is `None`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Errors {
    /// How early or late the last flip came, as a share of the time between two.
    pub phase: Option<f64>,
    /// The angle between the body's attitude and the true one at the end, rad.
    pub attitude: Option<f64>,
    /// Relative error of the energy: where it is conserved, the largest at any step, else at the end.
    pub energy: Option<f64>,
    /// Relative error of the length of the angular momentum, at the same times.
    pub momentum: Option<f64>,
    /// Error of its direction in the world at the same times, rad.
    pub direction: Option<f64>,
}

/// The observer of a run, if there is one.
pub type Observed<'a, 'b> = Option<&'a mut Observer<'b>>;

/// A run as it is seen from outside, step by step.
#[derive(Debug)]
pub struct Observer<'a> {
    story: &'a Story,
    middle: usize,
    world: Vector3<f64>,
    before: Option<(f64, State<f64>)>,
    flips: u64,
    /// The last state before the last change of sign, and when.
    last: Option<(f64, State<f64>)>,
    worst: [f64; 3],
    finite: bool,
}

impl<'a> Observer<'a> {
    /// Ready to observe a run of this story.
    #[must_use]
    pub fn new(story: &'a Story) -> Self {
        let start = &story.start;
        Self {
            story,
            middle: story.middle(),
            world: in_world(&start.attitude, &start.momentum),
            before: Some((0.0, *start)),
            flips: 0,
            last: None,
            worst: [0.0; 3],
            finite: true,
        }
    }

    /// The motion after a step.
    pub fn observe(&mut self, time: f64, motion: &State<f64>) {
        if !motion.attitude.coords.iter().chain(&motion.momentum).all(|x| x.is_finite()) {
            self.finite = false;
            return;
        }
        if let Some((t, before)) = self.before.take() {
            // A component of exactly zero has the sign that it had before.
            if motion.momentum[self.middle] == 0.0 {
                self.before = Some((t, before));
                return;
            }
            if (before.momentum[self.middle] < 0.0) != (motion.momentum[self.middle] < 0.0) {
                self.flips += 1;
                self.last = Some((t, before));
            }
        }
        self.before = Some((time, *motion));
        if self.story.keeps_energy() {
            let off = relative(self.story.energy(motion), self.story.truth.energy);
            self.worst[0] = self.worst[0].max(off);
        }
        if self.story.is_free() {
            self.worst[1] = self.worst[1].max(relative(motion.momentum.norm(), self.world.norm()));
            let world = in_world(&motion.attitude, &motion.momentum);
            self.worst[2] = self.worst[2].max(angle(&world, &self.world));
        }
    }

    /// Sets the number of flips of a run that makes no steps. Their times are then not compared.
    pub fn set_flips(&mut self, flips: usize) {
        self.flips = flips as u64;
    }

    /// The result of the run when it is over.
    #[must_use]
    pub fn judge(self, ended: Result<&Ended, &Outcome>) -> (Outcome, Errors) {
        let end = match ended {
            Err(outcome) => return (outcome.clone(), Errors::default()),
            Ok(end) => &end.motion,
        };
        if !self.finite || !end.attitude.coords.iter().chain(&end.momentum).all(|x| x.is_finite()) {
            return (Outcome::NotFinite, Errors::default());
        }
        let truth = &self.story.truth;
        let true_world = in_world(&truth.motion.attitude, &truth.motion.momentum);
        let end_world = in_world(&end.attitude, &end.momentum);
        let at_end = [
            relative(self.story.energy(end), truth.energy),
            relative(end.momentum.norm(), true_world.norm()),
            angle(&end_world, &true_world),
        ];
        let largest = |i: usize| Some(self.worst[i].max(at_end[i]));
        let mut errors = Errors {
            phase: None,
            attitude: Some(turn(&end.attitude, &truth.motion.attitude)),
            energy: largest(0),
            momentum: largest(1),
            direction: largest(2),
        };
        let Some(flips) = truth.flips else { return (Outcome::Right, errors) };
        if self.flips != flips.count {
            return (Outcome::Flips(self.flips), errors);
        }
        errors.phase = self.last_flip().map(|t| (t - flips.last).abs() / flips.apart);
        (Outcome::Right, errors)
    }

    /// The time of the last flip. The exact motion from the last state before the flip gives its time to the
    /// last digit, so that no interpolation adds to the error of the method.
    fn last_flip(&self) -> Option<f64> {
        let (t, state) = self.last.as_ref()?;
        let omega = self.story.system.omega(&state.momentum);
        let on = FreeMotion::new((*self.story.system.moments()).try_into().ok()?, &omega)
            .ok()?
            .next_flip(0.0)
            .ok()??;
        Some(t + on)
    }
}

/// The difference of two numbers relative to the second.
fn relative(x: f64, truth: f64) -> f64 {
    ((x - truth) / truth).abs()
}

/// The angle between two vectors, right also when it is tiny.
fn angle(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

/// The angle of the turn from one attitude to another, of whatever lengths, rad.
#[must_use]
pub fn turn(a: &Quaternion<f64>, b: &Quaternion<f64>) -> f64 {
    let between = a.conjugate() * b;
    2.0 * between.imag().norm().atan2(between.w.abs())
}
