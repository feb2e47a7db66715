//! Processor instructions, counted by valgrind where it is installed.
//!
//! The program that measures runs itself under `valgrind`, with few runs and with twice as many; the
//! difference is what the runs took, and the start of the program falls out.

use crate::contestant::{Contestant, Knob, Setting};
use crate::record::Work;
use crate::story::Story;
use std::ffi::OsString;
use std::hint::black_box;
use std::process::{Command, Stdio};

/// How to run the measuring program again so that it calls [`child`]: the program and its first words. The
/// name of the contestant and a count follow.
#[derive(Debug, Clone)]
pub struct Again {
    /// The program.
    pub program: OsString,
    /// Its first words.
    pub words: Vec<OsString>,
}

/// Steps of a short run.
const STEPS: u64 = 200;
/// The tolerance that stands for all.
const TOLERANCE: f64 = 1e-8;
/// The step of a short run, as radians of the spin.
const RADIANS: f64 = 0.1;

/// The start of a story, as many steps on.
fn short(story: &Story, contestant: &dyn Contestant) -> (Story, Setting) {
    let mut short = story.clone();
    let setting = match contestant.about().knob {
        Knob::None => return (short, Setting::None),
        Knob::Steps => Setting::Steps(STEPS),
        Knob::Tolerance => Setting::Tolerance(TOLERANCE),
    };
    short.end = STEPS as f64 * RADIANS / story.speed();
    (short, setting)
}

/// What the program does when it is run again: the short run, this number of times. Returns
/// the number of steps that they took together.
///
/// # Errors
/// A name that nobody has, or what the contestant says.
pub fn child(
    contestants: &[Box<dyn Contestant>],
    stories: &[Story],
    name: &str,
    count: u64,
) -> Result<u64, String> {
    let contestant = contestants.iter().find(|c| c.name() == name).ok_or("nobody has that name")?;
    let story = stories.iter().find(|story| contestant.takes(story)).ok_or("it takes no story")?;
    let (story, setting) = short(story, contestant.as_ref());
    let mut steps = 0;
    for _ in 0..count {
        let ended = black_box(contestant.run(black_box(&story), setting, None));
        steps += ended.map_err(|failure| format!("{failure:?}"))?.steps;
    }
    Ok(steps)
}

/// Instructions of a step of this contestant, on the first story that it takes, at a tenth of a radian a step
/// or a tolerance of 1e-8; of the exact motion all of it. `None` where valgrind is not installed, or does not
/// get through.
#[must_use]
pub fn of_step(again: &Again, contestant: &dyn Contestant, stories: &[Story]) -> Option<f64> {
    let story = stories.iter().find(|story| contestant.takes(story))?;
    let (story, setting) = short(story, contestant);
    let steps = contestant.run(&story, setting, None).ok()?.steps;
    let counted = |times: u64| counted(again, &[contestant.name().to_owned(), times.to_string()]);
    let (few, many) = (counted(1)?, counted(3)?);
    let each = many.checked_sub(few)? as f64 / (2 * steps) as f64;
    Some(each)
}

/// Instructions of the program run again with these words at the end. `None` where valgrind is not installed,
/// or does not get through.
#[must_use]
pub fn counted(again: &Again, words: &[String]) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"])
        .arg(&again.program)
        .args(&again.words)
        .args(words)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .output()
        .ok()?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return None;
    }
    // "==1234== I refs:        170,592"
    let line = said.lines().find(|line| line.contains("I refs") || line.contains("I   refs"))?;
    line.rsplit(':').next()?.trim().replace(',', "").parse().ok()
}

/// Fills the column of the rows of the story on which they were counted.
pub fn fill(rows: &mut [Work], contestant: &dyn Contestant, stories: &[Story], each: f64) {
    let Some(story) = stories.iter().find(|story| contestant.takes(story)) else { return };
    for row in rows.iter_mut().filter(|row| row.story == story.name && row.contestant == contestant.name()) {
        row.instructions = row.steps.map(|steps| each * steps as f64);
    }
}
