//! The contestants: the library's methods, the exact motion, and all else that implements [`Contestant`].

use crate::ended::{Ended, Failure};
use crate::errors::Watch;
use crate::operations;
use crate::story::Story;
use std::cell::RefCell;
use std::hint::black_box;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, MethodInfo, State, Stepper};

/// What a contestant keeps of a free motion: how the figures tell their curves apart.
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
    /// Another law than the body's: no step is short enough.
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

    fn of(info: MethodInfo) -> Self {
        match (info.order, info.conserved.energy, info.conserved.momentum) {
            (0, ..) => Self::Wrong,
            (_, true, true) => Self::Both,
            (_, _, true) => Self::Momentum,
            _ => Self::Neither,
        }
    }
}

/// What a contestant is set by.
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

/// What a contestant says of itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct About {
    /// What it is called; the key in the record.
    pub name: &'static str,
    /// What it keeps.
    pub group: Group,
    /// The order it claims, 0 for none.
    pub order: u32,
    /// What it is set by.
    pub knob: Knob,
    /// Whether it knows free bodies alone.
    pub free_only: bool,
}

/// A way to take a body from the start of a story to its end.
pub trait Contestant {
    /// What it says of itself.
    fn about(&self) -> About;

    /// Its name.
    fn name(&self) -> &'static str {
        self.about().name
    }

    /// Whether it can take this story on at all: the exact motion is of free bodies.
    fn takes(&self, story: &Story) -> bool {
        !self.about().free_only || story.is_free()
    }

    /// From start to end, showing the watch each step where there is one.
    ///
    /// # Errors
    /// Why it could not.
    fn run(&self, story: &Story, setting: Setting, watch: Option<&mut Watch<'_>>) -> Result<Ended, Failure>;

    /// How many evaluations of the law one step of this length is worth, where that is known beforehand.
    fn evaluations_of_step(&self, _story: &Story, _step: f64) -> Option<f64> {
        None
    }

    /// Claims that a run longer than a few turns can test.
    fn keeps_something(&self) -> bool {
        matches!(self.about().group, Group::Both | Group::Momentum)
    }

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
        About { name: info.name, group, order: info.order, knob: Knob::Steps, free_only: false }
    }

    fn run(
        &self,
        story: &Story,
        setting: Setting,
        mut watch: Option<&mut Watch<'_>>,
    ) -> Result<Ended, Failure> {
        let Setting::Steps(steps) = setting else {
            return Err(Failure::Refused("it is set by its steps".into()));
        };
        if story.drive.timed() {
            return counting_time(self.0, story, steps, watch);
        }
        let (mut motion, mut done, mut before) = (story.start, 0, 0.0);
        for phase in &story.phases {
            // Each phase has its share of the steps, and a step ends where the torques change.
            let count = (steps as f64 * phase.seconds / story.end).round().max(1.0) as u64;
            let h = black_box(phase.seconds / count as f64);
            for k in 1..=count {
                motion = self.0.step(&phase.system, &motion, h)?;
                if let Some(watch) = watch.as_deref_mut() {
                    watch.see(before + time_of(k, count, phase.seconds), &motion);
                }
            }
            done += count;
            before += phase.seconds;
        }
        Ok(Ended { motion, steps: done, evaluations: None, seconds: None })
    }

    fn evaluations_of_step(&self, story: &Story, step: f64) -> Option<f64> {
        operations::evaluations_of_step(self.0, &story.system, &story.start, step)
    }

    fn method(&self) -> Option<Method> {
        Some(self.0)
    }
}

/// By a stepper, which counts the time: for torques that depend on it.
fn counting_time(
    method: Method,
    story: &Story,
    steps: u64,
    mut watch: Option<&mut Watch<'_>>,
) -> Result<Ended, Failure> {
    let h = black_box(step_of(story, steps));
    let mut stepper = story.stepper(|body| Stepper::new(body, method))?;
    let mut motion = story.start;
    for k in 1..=steps {
        motion = stepper.step(h)?;
        if let Some(watch) = watch.as_deref_mut() {
            watch.see(time_of(k, steps, story.end), &motion);
        }
    }
    Ok(Ended { motion, steps, evaluations: None, seconds: None })
}

/// The library's run within a tolerance.
#[derive(Debug, Clone, Copy)]
pub struct Adaptive;

/// Steps that it may take.
const BUDGET: usize = 10_000_000;

impl Contestant for Adaptive {
    fn about(&self) -> About {
        About { name: "adaptive", group: Group::Neither, order: 0, knob: Knob::Tolerance, free_only: false }
    }

    // Its steps are not to be seen, and so neither are the flips of a free body.
    fn takes(&self, story: &Story) -> bool {
        !story.is_free()
    }

    fn run(
        &self,
        story: &Story,
        setting: Setting,
        mut watch: Option<&mut Watch<'_>>,
    ) -> Result<Ended, Failure> {
        let Setting::Tolerance(tolerance) = setting else {
            return Err(Failure::Refused("it is set by a tolerance".into()));
        };
        let (mut motion, mut budget, mut time) = (story.start, BUDGET, 0.0);
        for phase in &story.phases {
            let mut stepper = Stepper::of_system(phase.system.clone(), &motion, tolerance, budget)?;
            motion = stepper.step_to(black_box(phase.seconds))?;
            budget -= stepper.steps_of_run();
            time += phase.seconds;
            if let Some(watch) = watch.as_deref_mut() {
                watch.see(time, &motion);
            }
        }
        let steps = (BUDGET - budget) as u64;
        Ok(Ended { motion, steps, evaluations: None, seconds: None })
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
fn at_the_end(exact: &FreeMotion, story: &Story, watch: Option<&mut Watch<'_>>) -> Result<Ended, Failure> {
    let there = exact.at(black_box(story.end))?;
    if let Some(watch) = watch {
        watch.take_flips(exact.flips(0.0, story.end)?.count());
    }
    let vector = story.system.moments().component_mul(&there.omega);
    let motion = State { attitude: there.attitude.into_inner(), momentum: vector };
    Ok(Ended { motion, steps: 1, evaluations: None, seconds: None })
}

/// The exact motion: prepared from moments and spin, evaluated once.
#[derive(Debug, Clone, Copy)]
pub struct Exact;

impl Contestant for Exact {
    fn about(&self) -> About {
        About { name: "exact motion", group: Group::Exact, order: 0, knob: Knob::None, free_only: true }
    }

    fn run(&self, story: &Story, _: Setting, watch: Option<&mut Watch<'_>>) -> Result<Ended, Failure> {
        let moments = black_box(story.system.moments());
        let omega = story.system.omega(&story.start.momentum);
        let exact = FreeMotion::new((*moments).try_into()?, &omega)?;
        at_the_end(&exact, story, watch)
    }
}

/// The exact motion of a story, once prepared, at one instant: what each further instant costs.
#[derive(Debug, Default)]
pub struct Prepared(RefCell<Option<(&'static str, FreeMotion)>>);

impl Contestant for Prepared {
    fn about(&self) -> About {
        About {
            name: "exact motion, prepared",
            group: Group::Exact,
            order: 0,
            knob: Knob::None,
            free_only: true,
        }
    }

    fn run(&self, story: &Story, _: Setting, watch: Option<&mut Watch<'_>>) -> Result<Ended, Failure> {
        let mut kept = self.0.borrow_mut();
        if kept.as_ref().is_none_or(|(name, _)| *name != story.name) {
            let omega = story.system.omega(&story.start.momentum);
            *kept = Some((story.name, FreeMotion::new((*story.system.moments()).try_into()?, &omega)?));
        }
        let Some((_, exact)) = kept.as_ref() else { return Err(Failure::Refused("not prepared".into())) };
        at_the_end(exact, story, watch)
    }
}

/// The exact motion, the run within a tolerance, and all methods of the library.
#[must_use]
pub fn ours() -> Vec<Box<dyn Contestant>> {
    let exact: [Box<dyn Contestant>; 2] = [Box::new(Exact), Box::<Prepared>::default()];
    let methods = Method::ALL.iter().map(|&method| Box::new(Ours(method)) as Box<dyn Contestant>);
    let adaptive: Box<dyn Contestant> = Box::new(Adaptive);
    exact.into_iter().chain([adaptive]).chain(methods).collect()
}
