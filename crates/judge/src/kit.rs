//! The kit's stories as values: starts of a free body, what becomes of each exactly, and how far off an
//! engine may be.

use crate::error::Error;
use crate::law::LawName;
use crate::memory::{Description, Precision, Row, judge_described};
use crate::options::Options;
use crate::read::{Kind, Note, in_world};
use crate::verdict::Verdict;
use nalgebra::{Quaternion, convert};
use serde::Deserialize;

/// The kit's file.
#[derive(Default, Deserialize)]
struct Kit {
    stories: Vec<Story>,
}

/// A start of a free body, and what becomes of it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Story {
    /// Its name, such as `box-5`.
    pub name: String,
    /// What it tests.
    pub tests: String,
    /// Principal moments about the body's axes, kg m².
    pub moments: [f64; 3],
    /// The spin at the start, in body axes, rad/s.
    pub spin: [f64; 3],
    /// The attitude at the start: a quaternion w, x, y, z, body to world.
    pub attitude: [f64; 4],
    /// How long it goes on, s.
    pub duration: f64,
    /// The largest spin that is ever reached, rounded up to two digits, rad/s.
    pub fastest: f64,
    /// The times at which the spin along the middle moment's axis changes its sign, s; `None` where two
    /// moments are equal.
    pub flips: Option<Vec<f64>>,
    /// What the body does at some times.
    pub answers: Vec<Answer>,
}

/// The exact motion at one time.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Answer {
    /// The time, s.
    #[serde(rename = "t")]
    pub time: f64,
    /// The spin in body axes, rad/s.
    pub spin: [f64; 3],
    /// The attitude: a quaternion w, x, y, z, body to world.
    pub attitude: [f64; 4],
}

impl Story {
    /// All of them, in the order of the file.
    #[must_use]
    pub fn all() -> Vec<Self> {
        serde_json::from_str::<Kit>(include_str!("../kit/stories.json")).unwrap_or_default().stories
    }

    /// The one of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::all().into_iter().find(|story| story.name == name)
    }

    /// The rows that an engine makes of it, in steps of `h` seconds: `step` takes an attitude (w, x, y, z;
    /// body to world) and a spin (body axes, rad/s) one step further.
    ///
    /// ```
    /// let story = tumbling_judge::Story::named("box-5").unwrap();
    /// let mut rows = story.rows(story.duration / 3.0, |q: [f64; 4], spin| (q, spin));
    /// assert_eq!(rows.next().unwrap().spin, story.spin);
    /// assert_eq!(rows.count(), 3);
    /// ```
    pub fn rows<T: Precision>(
        &self,
        h: f64,
        step: impl FnMut([T; 4], [T; 3]) -> ([T; 4], [T; 3]),
    ) -> impl Iterator<Item = Row<T>> {
        self.rows_from(self.spin, h, step)
    }

    fn rows_from<T: Precision>(
        &self,
        spin: [f64; 3],
        h: f64,
        mut step: impl FnMut([T; 4], [T; 3]) -> ([T; 4], [T; 3]),
    ) -> impl Iterator<Item = Row<T>> {
        // A step that is not a number, or zero, has no rows.
        let steps = Some((self.duration / h).round()).filter(|steps| steps.is_finite() && *steps >= 0.0);
        let mut now = (self.attitude.map(convert), spin.map(convert));
        (0..steps.map_or(0, |steps| steps as u64 + 1)).map(move |i| {
            now = if i > 0 { step(now.0, now.1) } else { now };
            Row { time: i as f64 * h, attitude: Some(now.0), spin: now.1 }
        })
    }

    /// The verdict on an engine's run of it, in steps of `h` seconds: `step` takes an attitude (w, x, y, z;
    /// body to world) and a spin (body axes, rad/s) one step further.
    ///
    /// An engine that keeps its spin in world axes is judged by [`run_in_world`](Self::run_in_world): to turn
    /// the spin there and back in each step adds roundings as large as the engine's own.
    ///
    /// # Errors
    /// Those of [`judge_in_memory`](crate::judge_in_memory): a step that gives no number, above all.
    pub fn run<T: Precision>(
        &self,
        h: f64,
        step: impl FnMut([T; 4], [T; 3]) -> ([T; 4], [T; 3]),
    ) -> Result<Verdict, Error> {
        self.judged(Kind::SpinBody, h, self.rows(h, step))
    }

    /// As [`run`](Self::run), with the spin in world axes: what engines store.
    ///
    /// ```
    /// use tumbling::step::PositionStage;
    /// use tumbling_judge::{Story, assert_passes};
    /// let story = Story::named("box-5").unwrap();
    /// let stage = PositionStage::new(&nalgebra::Vector3::from(story.moments).cast::<f32>()).unwrap();
    /// let h = 1.0 / 60.0;
    /// assert_passes!(story.run_in_world(h, |[w, x, y, z]: [f32; 4], spin| {
    ///     let end = stage.step(&nalgebra::Quaternion::new(w, x, y, z), &spin.into(), h as f32);
    ///     let q = end.attitude;
    ///     ([q.w, q.i, q.j, q.k], end.omega.into())
    /// }));
    /// ```
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_in_world<T: Precision>(
        &self,
        h: f64,
        step: impl FnMut([T; 4], [T; 3]) -> ([T; 4], [T; 3]),
    ) -> Result<Verdict, Error> {
        let [w, x, y, z] = self.attitude;
        let spin = in_world(&Quaternion::new(w, x, y, z), &self.spin.into()).into();
        self.judged(Kind::SpinWorld, h, self.rows_from(spin, h, step))
    }

    fn judged<T: Precision>(
        &self,
        kind: Kind,
        h: f64,
        rows: impl Iterator<Item = Row<T>>,
    ) -> Result<Verdict, Error> {
        let description = Description { kind, ..Description::default() };
        let mut verdict = judge_described(self.moments, description, rows, &self.options(h))?;
        verdict.record.notes.push(Note::Story(self.name.clone()));
        Ok(verdict)
    }

    /// What the judge allows of a run of it in steps of `h` seconds: as always, and for the turn against the
    /// spin what the best rules of second order make of so long a step, (w h)²/12 with the largest spin w.
    #[must_use]
    pub fn options(&self, h: f64) -> Options {
        let options = Options::default();
        options.with(LawName::Consistency, ((self.fastest * h).powi(2) / 12.0).max(options.threshold))
    }
}

/// Fails the test where a verdict is not that the record passes, and prints it.
///
/// ```
/// use tumbling_judge::{Story, assert_passes};
/// # fn my_engine(q: [f32; 4], w: [f32; 3], moments: [f64; 3], h: f64) -> ([f32; 4], [f32; 3]) {
/// #     use tumbling::{PrincipalMoments, step::{Method, State, System}};
/// #     let [a, b, c] = moments;
/// #     let system = System::free(PrincipalMoments::new(a, b, c).unwrap()).unwrap();
/// #     let q = nalgebra::Quaternion::new(q[0], q[1], q[2], q[3]).cast::<f64>();
/// #     let start = State { attitude: q, momentum: system.momentum(&nalgebra::Vector3::from(w).cast()) };
/// #     let end = Method::RotationSplitting2.step(&system, &start, h).unwrap();
/// #     let q = end.attitude.cast::<f32>();
/// #     ([q.w, q.i, q.j, q.k], system.omega(&end.momentum).cast::<f32>().into())
/// # }
/// let story = Story::named("box-5").unwrap();
/// let h = 1.0 / 60.0;
/// assert_passes!(story.run(h, |q, w| my_engine(q, w, story.moments, h)));
/// ```
#[macro_export]
macro_rules! assert_passes {
    ($verdict:expr) => {
        match $verdict {
            Ok(verdict) => assert!(verdict.outcome == $crate::Outcome::Passed, "\n{verdict}"),
            Err(why) => panic!("{why}"),
        }
    };
}
