//! The measuring: every contestant on every story down a ladder of settings, times taken in turns.

use crate::contestant::{Contestant, Knob, Setting};
use crate::errors::{Ended, Observer};
use crate::record::{Work, short};
use crate::story::Story;
use std::hint::black_box;
use std::time::Instant;

/// How much to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// How often each time is taken.
    pub repeats: u32,
    /// The longest that a run may take, s: a ladder ends below a rung that took longer.
    pub seconds: f64,
    /// How many turns a long run has.
    pub turns: u64,
    /// From how many starts, at most.
    pub starts: u32,
    /// No further start once a method has run for this long, s.
    pub long: f64,
}

impl Effort {
    /// For the record: some minutes.
    pub const FULL: Self = Self { repeats: 5, seconds: 0.2, turns: 1_000_000, starts: 3, long: 20.0 };
    /// For a look: below a minute.
    pub const QUICK: Self = Self { repeats: 3, seconds: 0.01, turns: 3_000, starts: 2, long: 0.1 };
}

/// The longest step, in radians of the spin.
const COARSEST: f64 = 2.0;
/// Loosest and tightest tolerance, powers of ten.
const TOLERANCES: std::ops::RangeInclusive<i32> = 3..=15;
/// A ladder ends when this many rungs in a row have not brought the attitude nearer.
const NO_BETTER: u32 = 3;
/// The least time to take, s: what is shorter is run several times over.
const LEAST: f64 = 2e-4;

/// One rung: who, on what, set to what, and the row of the record.
struct Rung<'a> {
    contestant: &'a dyn Contestant,
    story: &'a Story,
    setting: Setting,
    /// How many runs make one time.
    inner: u32,
    times: Vec<f64>,
    row: Work,
}

/// Every contestant on every story. `progress` hears how far it is. What contestants do wrong stands in their
/// rows.
pub fn measure(
    contestants: &[Box<dyn Contestant>],
    stories: &[Story],
    effort: Effort,
    progress: &mut dyn FnMut(&str),
) -> Vec<Work> {
    let mut rows = Vec::new();
    for (at, story) in stories.iter().enumerate() {
        let heading = format!("story {} of {}, {}", at + 1, stories.len(), story.name);
        let mut rungs = Vec::new();
        for contestant in contestants.iter().filter(|c| c.takes(story)) {
            progress(&format!("{heading}: errors of {}", contestant.about().name));
            rungs.extend(ladder(contestant.as_ref(), story, effort));
        }
        for round in 1..=effort.repeats {
            progress(&format!("{heading}: times, round {round} of {}", effort.repeats));
            // Interleaved, so that a temporary slowdown of the machine affects all equally.
            for rung in rungs.iter_mut().filter(|rung| rung.row.seconds.is_some()) {
                rung.times.push(rung.time());
            }
        }
        rows.extend(rungs.into_iter().map(Rung::done));
    }
    rows
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
            self.row.seconds = self.times.get(self.times.len() / 2).copied().map(short);
            self.row.spread = Some(short(longest / shortest));
        }
        self.row
    }
}

/// Settings from coarse to fine, each run once for its errors.
fn ladder<'a>(contestant: &'a dyn Contestant, story: &'a Story, effort: Effort) -> Vec<Rung<'a>> {
    let mut rungs = Vec::new();
    let (mut best, mut no_better) = (f64::INFINITY, 0);
    for setting in settings(contestant.about().knob, story) {
        let (rung, seconds) = rung(contestant, story, setting);
        let attitude = rung.row.attitude.unwrap_or(f64::INFINITY);
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
    let coarsest = (story.speed() * story.end / COARSEST).ceil() as u64;
    match knob {
        Knob::None => vec![Setting::None],
        Knob::Tolerance => TOLERANCES.map(|n| Setting::Tolerance(10_f64.powi(-n))).collect(),
        Knob::Steps => (0..32).map(|k| Setting::Steps(coarsest << k)).collect(),
    }
}

/// One run for its errors, and how long it took under observation.
fn rung<'a>(contestant: &'a dyn Contestant, story: &'a Story, setting: Setting) -> (Rung<'a>, f64) {
    let mut observer = Observer::new(story);
    let start = Instant::now();
    let ended = contestant.run(story, setting, Some(&mut observer));
    let own = ended.as_ref().ok().and_then(|ended| ended.seconds);
    let seconds = own.unwrap_or_else(|| start.elapsed().as_secs_f64());
    let (outcome, errors) = observer.judge(ended.as_ref());
    let about = contestant.about();
    let row = Work {
        story: story.name.into(),
        contestant: about.name.into(),
        group: about.group.word().into(),
        setting: setting.to_string(),
        steps: ended.as_ref().ok().map(|ended| ended.steps),
        seconds: errors.attitude.is_some().then_some(seconds),
        spread: None,
        phase: errors.phase.map(short),
        attitude: errors.attitude.map(short),
        energy: errors.energy.map(short),
        momentum: errors.momentum.map(short),
        direction: errors.direction.map(short),
        outcome: outcome.to_string(),
    };
    let inner = (LEAST / seconds).clamp(1.0, 1e4) as u32;
    (Rung { contestant, story, setting, inner, times: Vec::new(), row }, seconds)
}
