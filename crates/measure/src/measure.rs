//! The measuring: every contestant on every story down a ladder of settings, times taken in turns.

use crate::contestant::{Contestant, Knob, Setting};
use crate::ended::Ended;
use crate::errors::Watch;
use crate::record::Work;
use crate::story::{Story, Wrong};
use std::hint::black_box;
use std::time::Instant;

/// How much to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// No run is worth more evaluations of the law than this.
    pub evaluations: f64,
    /// How often each time is taken.
    pub repeats: u32,
    /// The longest that a run may take once it is to be repeated, s: a ladder ends below a rung that took
    /// longer.
    pub seconds: f64,
    /// How many turns a long run has.
    pub turns: u64,
    /// From how many starts.
    pub starts: u32,
    /// From fewer, down to one, where all would be worth more evaluations of the law than this.
    pub long: f64,
}

impl Effort {
    /// For the record: some minutes.
    pub const FULL: Self =
        Self { evaluations: 1.5e6, repeats: 5, seconds: 0.2, turns: 1_000_000, starts: 3, long: 5e8 };
    /// For a look: below a minute.
    pub const QUICK: Self =
        Self { evaluations: 1e5, repeats: 3, seconds: 0.02, turns: 3_000, starts: 2, long: 1e7 };
}

/// What a step is taken to be worth where that is not known.
const UNKNOWN: f64 = 40.0;
/// The longest step, in radians of the spin.
const COARSEST: f64 = 2.0;
/// Loosest and tightest tolerance, powers of ten.
const TOLERANCES: std::ops::RangeInclusive<i32> = 3..=15;
/// A ladder ends when this many rungs in a row have not brought the attitude nearer.
const NO_BETTER: u32 = 3;
/// The least time to take, s: what is shorter is run several times over.
const LEAST: f64 = 2e-4;

/// One rung: who, on what, set to what, and what came of it.
struct Rung<'a> {
    contestant: &'a dyn Contestant,
    story: &'a Story,
    setting: Setting,
    /// How many runs make one time.
    inner: u32,
    times: Vec<f64>,
    row: Work,
}

/// Every contestant on every story. `tell` hears how far it is.
///
/// # Errors
/// Nothing but a story that cannot be prepared; what contestants do wrong stands in their rows.
pub fn measure(
    contestants: &[Box<dyn Contestant>],
    stories: &[Story],
    effort: Effort,
    tell: &mut dyn FnMut(&str),
) -> Result<Vec<Work>, Wrong> {
    let mut rows = Vec::new();
    for (at, story) in stories.iter().enumerate() {
        let mut rungs = Vec::new();
        for contestant in contestants.iter().filter(|c| c.takes(story)) {
            tell(&format!(
                "story {} of {}, {}: errors of {}",
                at + 1,
                stories.len(),
                story.name,
                contestant.name()
            ));
            rungs.extend(ladder(contestant.as_ref(), story, effort));
        }
        for round in 0..effort.repeats {
            tell(&format!(
                "story {} of {}, {}: times, round {} of {}",
                at + 1,
                stories.len(),
                story.name,
                round + 1,
                effort.repeats
            ));
            // In turns: whatever slows the machine down for a while meets all alike.
            for rung in &mut rungs {
                if rung.row.seconds.is_some() {
                    rung.times.push(rung.time());
                }
            }
        }
        rows.extend(rungs.into_iter().map(Rung::done));
    }
    Ok(rows)
}

impl Rung<'_> {
    /// Of one run, s: the mean over some where they are short.
    fn time(&self) -> f64 {
        let start = Instant::now();
        let mut own = None;
        for _ in 0..self.inner {
            let ended = black_box(self.contestant.run(black_box(self.story), self.setting, None));
            if let Ok(Ended { seconds: Some(seconds), .. }) = ended {
                own = Some(own.unwrap_or(0.0) + seconds);
            }
        }
        own.unwrap_or_else(|| start.elapsed().as_secs_f64()) / f64::from(self.inner)
    }

    fn done(mut self) -> Work {
        self.times.sort_by(f64::total_cmp);
        if let [shortest, .., longest] = self.times.as_slice() {
            self.row.seconds = self.times.get(self.times.len() / 2).copied();
            self.row.spread = Some(longest / shortest);
        }
        self.row
    }
}

/// Settings from coarse to fine, each run once for its errors.
fn ladder<'a>(contestant: &'a dyn Contestant, story: &'a Story, effort: Effort) -> Vec<Rung<'a>> {
    let mut rungs = Vec::new();
    let (mut best, mut no_better) = (f64::INFINITY, 0);
    for setting in settings(contestant.about().knob, story) {
        let worth = worth(contestant, story, setting);
        if worth.unwrap_or_else(|| guess(setting)) > effort.evaluations {
            break;
        }
        let (rung, seconds) = rung(contestant, story, setting, worth);
        let attitude = rung.row.errors.attitude.unwrap_or(f64::INFINITY);
        rungs.push(rung);
        no_better = if attitude < best { 0 } else { no_better + 1 };
        best = best.min(attitude);
        if seconds > effort.seconds || (best < 1e-8 && no_better >= NO_BETTER) {
            break;
        }
    }
    rungs
}

/// From coarse to fine.
fn settings(knob: Knob, story: &Story) -> Vec<Setting> {
    match knob {
        Knob::None => vec![Setting::None],
        Knob::Tolerance => TOLERANCES.map(|n| Setting::Tolerance(10_f64.powi(-n))).collect(),
        Knob::Steps => (0..32).map(|k| Setting::Steps(coarsest(story) << k)).collect(),
    }
}

/// The fewest steps on the ladder.
fn coarsest(story: &Story) -> u64 {
    (story.speed() * story.end / COARSEST).ceil() as u64
}

/// What a run is worth in evaluations, as far as that is known before.
fn worth(contestant: &dyn Contestant, story: &Story, setting: Setting) -> Option<f64> {
    let Setting::Steps(steps) = setting else { return None };
    Some(contestant.evaluations_of_step(story, story.end / steps as f64)? * steps as f64)
}

/// The same where it is not known: a guess that only ends a ladder.
fn guess(setting: Setting) -> f64 {
    match setting {
        Setting::Steps(steps) => UNKNOWN * steps as f64,
        Setting::Tolerance(_) | Setting::None => 0.0,
    }
}

/// One run for its errors, and how long it took under the watch.
fn rung<'a>(
    contestant: &'a dyn Contestant,
    story: &'a Story,
    setting: Setting,
    worth: Option<f64>,
) -> (Rung<'a>, f64) {
    let mut watch = Watch::new(story);
    let start = Instant::now();
    let ended = contestant.run(story, setting, Some(&mut watch));
    let own = ended.as_ref().ok().and_then(|ended| ended.seconds);
    let seconds = own.unwrap_or_else(|| start.elapsed().as_secs_f64());
    let (outcome, errors) = watch.judge(ended.as_ref());
    let evaluations = match &ended {
        Ok(Ended { evaluations: Some(counted), .. }) => Some(*counted as f64),
        Ok(_) => worth,
        Err(_) => None,
    };
    let finite = ended.is_ok() && errors.attitude.is_some();
    let inner = (LEAST / seconds).clamp(1.0, 1e4) as u32;
    let row = Work {
        story: story.name.into(),
        contestant: contestant.name().into(),
        group: contestant.about().group.word().into(),
        order: contestant.about().order,
        setting,
        steps: ended.as_ref().ok().map(|ended| ended.steps),
        evaluations,
        instructions: None,
        seconds: finite.then_some(seconds),
        spread: None,
        errors,
        outcome,
    };
    (Rung { contestant, story, setting, inner, times: Vec::new(), row }, seconds)
}
