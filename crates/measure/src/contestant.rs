//! The contestants: the library's methods, the exact motion, and all else that implements [`Contestant`].

use crate::errors::{Ended, Observed, Outcome};
use crate::story::Story;
use std::cell::RefCell;
use std::fmt;
use std::hint::black_box;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, MethodInfo, State, Stepper, System, fixed_rate};

/// The quantities of a free motion that a contestant conserves; the figures group their curves by it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Group {
    /// The closed form.
    Exact,
    /// Energy and the length of the momentum.
    Both,
    /// The length of the momentum at least, and not the energy.
    Momentum,
    /// Neither.
    Neither,
    /// A published program of others.
    Peer,
    /// A law different from the body's: no step is short enough.
    Wrong,
}

impl Group {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Exact, Self::Both, Self::Momentum, Self::Neither, Self::Peer, Self::Wrong];

    /// The word in the record.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Both => "energy and momentum",
            Self::Momentum => "momentum",
            Self::Neither => "neither",
            Self::Peer => "peer",
            Self::Wrong => "wrong law",
        }
    }

    pub(crate) fn of(info: MethodInfo) -> Self {
        match (info.order, info.energy, info.momentum) {
            (0, ..) => Self::Wrong,
            (_, true, true) => Self::Both,
            (_, _, true) => Self::Momentum,
            _ => Self::Neither,
        }
    }
}

/// The parameter of a contestant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Knob {
    /// A fixed number of equal steps.
    Steps,
    /// A relative tolerance: it chooses its own steps.
    Tolerance,
    /// Nothing.
    None,
}

/// A setting of the knob.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Setting {
    /// This number of equal steps.
    Steps(u64),
    /// This relative tolerance.
    Tolerance(f64),
    /// There is nothing to set.
    None,
}

impl Setting {
    /// The number of steps.
    ///
    /// # Errors
    /// Another setting.
    pub fn steps(self) -> Result<u64, Outcome> {
        if let Self::Steps(steps) = self { Ok(steps) } else { Err(Self::unknown()) }
    }

    /// The relative tolerance.
    ///
    /// # Errors
    /// Another setting.
    pub fn tolerance(self) -> Result<f64, Outcome> {
        if let Self::Tolerance(tolerance) = self { Ok(tolerance) } else { Err(Self::unknown()) }
    }

    /// The error of a contestant for a setting that it does not have.
    fn unknown() -> Outcome {
        Outcome::Refused("it has no such setting".into())
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Steps(steps) => write!(f, "{steps} steps"),
            Self::Tolerance(tolerance) => write!(f, "tolerance {tolerance:e}"),
            Self::None => Ok(()),
        }
    }
}

/// The description of a contestant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct About {
    /// What it is called; the key in the record.
    pub name: &'static str,
    /// What it keeps.
    pub group: Group,
    /// What it is set by.
    pub knob: Knob,
}

/// A way to take a body from the start of a story to its end.
pub trait Contestant {
    /// What it says of itself.
    fn about(&self) -> About;

    /// Whether it can run this story: the exact motion is only for free bodies.
    fn takes(&self, _story: &Story) -> bool {
        true
    }

    /// Runs from start to end, and shows each step to the observer if there is one.
    ///
    /// # Errors
    /// Why it could not.
    fn run(&self, story: &Story, setting: Setting, observer: Observed<'_, '_>) -> Result<Ended, Outcome>;

    /// The method behind it, for runs of a million turns.
    fn method(&self) -> Option<Method> {
        None
    }
}

/// A method of the library, at equal steps.
#[derive(Debug, Clone, Copy)]
pub struct Ours(pub Method);

impl Contestant for Ours {
    fn about(&self) -> About {
        let info = self.0.info();
        let group = Group::of(info);
        About { name: info.name, group, knob: Knob::Steps }
    }

    fn run(&self, story: &Story, setting: Setting, observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
        let steps = setting.steps()?;
        if story.drive.timed() {
            return counting_time(self.0, story, steps, observer);
        }
        at_equal_steps(story, steps, observer, |system, motion, h| self.0.step(system, motion, h))
    }

    fn method(&self) -> Option<Method> {
        Some(self.0)
    }
}

/// In each phase its share of the steps, so that a step ends where the torques change.
fn at_equal_steps(
    story: &Story,
    steps: u64,
    mut observer: Observed<'_, '_>,
    step: impl Fn(&System<f64>, &State<f64>, f64) -> Result<State<f64>, tumbling::Error>,
) -> Result<Ended, Outcome> {
    let (mut motion, mut done, mut before) = (story.start, 0, 0.0);
    for phase in &story.phases {
        let count = (steps as f64 * phase.seconds / story.end).round().max(1.0) as u64;
        let h = black_box(phase.seconds / count as f64);
        for k in 1..=count {
            motion = step(&phase.system, &motion, h)?;
            if let Some(observer) = observer.as_deref_mut() {
                observer.observe(before + time_of(k, count, phase.seconds), &motion);
            }
        }
        done += count;
        before += phase.seconds;
    }
    Ok(Ended { motion, steps: done, seconds: None })
}

/// The library's step for free bodies at a fixed rate: Moser and Veselov's in closed form.
#[derive(Debug, Clone, Copy)]
pub struct FixedRate;

impl Contestant for FixedRate {
    fn about(&self) -> About {
        About { name: "fixed rate", group: Group::Both, knob: Knob::Steps }
    }

    fn takes(&self, story: &Story) -> bool {
        story.is_free()
    }

    fn run(&self, story: &Story, setting: Setting, observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
        at_equal_steps(story, setting.steps()?, observer, fixed_rate)
    }
}

/// By a stepper, which counts the time: for torques that depend on it.
fn counting_time(
    method: Method,
    story: &Story,
    steps: u64,
    mut observer: Observed<'_, '_>,
) -> Result<Ended, Outcome> {
    let h = black_box(step_of(story, steps));
    let mut stepper = story.stepper(|body| Stepper::new(body, method))?;
    let mut motion = story.start;
    for k in 1..=steps {
        motion = stepper.step(h)?;
        if let Some(observer) = observer.as_deref_mut() {
            observer.observe(time_of(k, steps, story.end), &motion);
        }
    }
    Ok(Ended { motion, steps, seconds: None })
}

/// The library's run within a tolerance.
#[derive(Debug, Clone, Copy)]
pub struct Adaptive;

/// Steps that it may take.
const BUDGET: usize = 10_000_000;

impl Contestant for Adaptive {
    fn about(&self) -> About {
        About { name: "adaptive", group: Group::Neither, knob: Knob::Tolerance }
    }

    // Its steps cannot be observed, and so the flips of a free body cannot either.
    fn takes(&self, story: &Story) -> bool {
        !story.is_free()
    }

    fn run(&self, story: &Story, setting: Setting, mut observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
        let tolerance = setting.tolerance()?;
        let mut stepper = Stepper::of_system(story.system.clone(), &story.start, tolerance, BUDGET)?;
        let (mut motion, mut time) = (story.start, 0.0);
        for phase in &story.phases {
            time += phase.seconds;
            motion = stepper.step_to(black_box(time))?;
            if let Some(observer) = observer.as_deref_mut() {
                observer.observe(time, &motion);
            }
        }
        Ok(Ended { motion, steps: stepper.steps_of_run() as u64, seconds: None })
    }
}

/// The length of each of this number of steps.
#[must_use]
pub fn step_of(story: &Story, steps: u64) -> f64 {
    story.end / steps as f64
}

fn time_of(k: u64, steps: u64, end: f64) -> f64 {
    end * (k as f64 / steps as f64)
}

/// The closed form at the story's end.
fn at_the_end(exact: &FreeMotion, story: &Story, observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
    let there = exact.at(black_box(story.end))?;
    if let Some(observer) = observer {
        observer.set_flips(exact.flips(0.0, story.end)?.count());
    }
    let vector = story.system.moments().component_mul(&there.omega);
    let motion = State { attitude: there.attitude.into_inner(), momentum: vector };
    Ok(Ended { motion, steps: 1, seconds: None })
}

/// The exact motion: prepared from moments and spin, evaluated once.
#[derive(Debug, Clone, Copy)]
pub struct Exact;

impl Contestant for Exact {
    fn about(&self) -> About {
        About { name: "exact motion", group: Group::Exact, knob: Knob::None }
    }

    fn takes(&self, story: &Story) -> bool {
        story.is_free()
    }

    fn run(&self, story: &Story, _: Setting, observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
        let moments = black_box(story.system.moments());
        let omega = story.system.omega(&story.start.momentum);
        let exact = FreeMotion::new((*moments).try_into()?, &omega)?;
        at_the_end(&exact, story, observer)
    }
}

/// The exact motion of a story, once prepared, at one instant: what each further instant costs.
#[derive(Debug, Default)]
pub struct Prepared(RefCell<Option<(&'static str, FreeMotion)>>);

impl Contestant for Prepared {
    fn about(&self) -> About {
        About { name: "exact motion, prepared", group: Group::Exact, knob: Knob::None }
    }

    fn takes(&self, story: &Story) -> bool {
        story.is_free()
    }

    fn run(&self, story: &Story, _: Setting, observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
        let mut kept = self.0.borrow_mut();
        if kept.as_ref().is_none_or(|(name, _)| *name != story.name) {
            let omega = story.system.omega(&story.start.momentum);
            *kept = Some((story.name, FreeMotion::new((*story.system.moments()).try_into()?, &omega)?));
        }
        let Some((_, exact)) = kept.as_ref() else { return Err(Setting::unknown()) };
        at_the_end(exact, story, observer)
    }
}

/// The exact motion, the run within a tolerance, the step at a fixed rate, and all methods of the library.
#[must_use]
pub fn ours() -> Vec<Box<dyn Contestant>> {
    let exact: [Box<dyn Contestant>; 2] = [Box::new(Exact), Box::<Prepared>::default()];
    let methods = Method::ALL.iter().map(|&method| Box::new(Ours(method)) as Box<dyn Contestant>);
    let chosen: [Box<dyn Contestant>; 2] = [Box::new(Adaptive), Box::new(FixedRate)];
    exact.into_iter().chain(chosen).chain(methods).collect()
}
