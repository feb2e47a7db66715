//! From a record to a verdict, one row in hand at a time.

use crate::columns::{Columns, Kind};
use crate::derived::{Derived, Deriver};
use crate::diagnosis::{Diagnosis, Floor, Run, Sample, Sure, diagnose, should_change};
use crate::error::Error;
use crate::faults::{wrong_pace, wrong_rule};
use crate::fit::{self, Fit};
use crate::grid::Grid;
use crate::laws::{FlipCount, Law, LawName, Laws, angle_between, turned};
use crate::points::Point;
use crate::reading::{Misread, Reading};
use crate::rows::{Raw, Rows};
use crate::state::{Pair, State, median};
use crate::suspects::Subject;
use nalgebra::Vector3;
use std::f64::consts::TAU;
use std::io::BufRead;
use tumbling::euler;
use tumbling::exact::FreeMotion;

/// How many rows are looked at before it is settled how they are meant.
const PROBE: usize = 2048;
/// Of those, how many pairs.
const PROBED: usize = 256;

/// Fewer rows than this pass nothing, nor does a record in which the body neither turns once round nor should change its spin by a tenth.
const ENOUGH: u64 = 8;

/// What the judge is to go by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Principal moments, kg m²; they take precedence over what the record says.
    pub inertia: Option<Vector3<f64>>,
    /// The most that a law may be broken by: of energy and momentum as a share, of a direction in rad.
    pub threshold: f64,
    /// Other limits for some laws, the last of a law's own taken; one of phase (ways round) or of consistency is held too then.
    /// Without one a phase fails that is off by more than a quarter of a way round and a quarter of the ways that the exact motion makes.
    pub thresholds: [Option<f64>; 7],
    /// To start from the exact motion that comes nearest to so many rows, and not from the first alone.
    pub fit: Option<usize>,
}

impl Options {
    /// What is allowed of a law; nothing where it is not held to anything.
    #[must_use]
    pub fn allowed(&self, law: LawName) -> Option<f64> {
        let own = LawName::ALL.iter().position(|name| *name == law).and_then(|i| self.thresholds[i]);
        own.or_else(|| law.is_conserved().then_some(self.threshold))
    }

    /// With a limit of its own for a law.
    #[must_use]
    pub fn with(mut self, law: LawName, threshold: f64) -> Self {
        if let Some(i) = LawName::ALL.iter().position(|name| *name == law) {
            self.thresholds[i] = Some(threshold);
        }
        self
    }
}

impl Default for Options {
    fn default() -> Self {
        Self { inertia: None, threshold: 0.01, thresholds: [None; 7], fit: None }
    }
}

/// The end of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Outcome {
    /// The file is sound, and every law is kept within the threshold.
    Passed,
    /// The file is not sound, or a law is broken.
    Failed,
    /// The record has nothing that could be right or wrong.
    NothingToJudge,
    /// No law is broken, and too little is seen for that to say anything.
    TooShort,
}

/// A row at which the motion starts anew.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reset {
    /// Its line in the file.
    pub line: usize,
    /// Its time, s.
    pub time: f64,
    /// Whether the body was put to rest.
    pub to_rest: bool,
    /// Whether it was put back to its start.
    pub to_start: bool,
}

/// Steps that have no row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaps {
    /// How often rows are missing.
    pub count: u64,
    /// The first line after such a place.
    pub line: usize,
    /// How many steps the longest is.
    pub longest: f64,
}

/// A verdict.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Who made the record, if it says so.
    pub engine: Option<String>,
    /// Principal moments, kg m².
    pub moments: Vector3<f64>,
    /// A torque constant in the world, N m, that the record tells of.
    pub torque: Option<Vector3<f64>>,
    /// Rows.
    pub rows: u64,
    /// From the first row to the last that was judged, s.
    pub duration: f64,
    /// The step, s; none where it varies.
    pub step: Option<f64>,
    /// The rounding of the file's numbers, beside 1.
    pub rounding: f64,
    /// Whether it has attitudes.
    pub has_attitude: bool,
    /// Mistakes of the file. What follows is of the file with these put right.
    pub misread: Vec<Misread>,
    /// Columns that were not read.
    pub ignored: Vec<String>,
    /// What was made of the file beside its rows, in words.
    pub notes: Vec<String>,
    /// Laws of which the file does not tell: no attitude, or no spin.
    pub untold: Vec<LawName>,
    /// Where the motion starts anew; the laws are followed up to the first.
    pub resets: Vec<Reset>,
    /// Missing rows.
    pub gaps: Option<Gaps>,
    /// Times at which the quaternion changes its sign and not its attitude.
    pub sign_changes: u64,
    /// The laws.
    pub laws: Vec<Law>,
    /// Flips, for a body that can.
    pub flips: Option<FlipCount>,
    /// `2 E I2 / L²` in the first row and in the last, for a body with three different moments.
    pub separatrix: Option<[f64; 2]>,
    /// Which rule explains it.
    pub diagnosis: Option<Diagnosis>,
    /// What failed and is no law, in words.
    pub complaints: Vec<String>,
    /// What was allowed.
    pub options: Options,
    /// How the start was fitted, if it was.
    pub fit: Option<Fit>,
    /// The run in at most 256 points, to draw it by.
    pub curve: Vec<Point>,
    /// The end of it.
    pub outcome: Outcome,
}

impl Verdict {
    /// The conserved law that is kept worst.
    #[must_use]
    pub fn worst(&self) -> Option<&Law> {
        self.laws
            .iter()
            .filter(|law| law.name.is_conserved())
            .max_by(|a, b| a.growth.rank().cmp(&b.growth.rank()).then(a.most.total_cmp(&b.most)))
    }

    /// The laws that are broken by more than is allowed.
    pub fn broken(&self) -> impl Iterator<Item = &Law> {
        self.laws
            .iter()
            .filter(|law| self.options.allowed(law.name).is_some_and(|most| law.most.abs() > most))
    }
}

/// Judges a record.
///
/// The first line that is neither empty nor a comment (`#`) names the columns: `t` (s) or `step`, `qw,qx,qy,qz` (body to world),
/// `wx,wy,wz` (spin in body axes, rad/s) or `wxw,wyw,wzw` (in world axes), or momentum (`lx,ly,lz`, `lxw,lyw,lzw`, kg m²/s), in
/// or attitudes alone, from whose turns the spin is told then; in
/// any order, between commas, semicolons, tabs or blanks. Comments before it may tell `inertia: A B C`, `dt: 1/60` and
/// `torque: X Y Z`.
///
/// ```
/// use tumbling_judge::{Options, Outcome, judge};
/// // A body without a gyroscopic term: its spin does not move.
/// let mut record = String::from("# inertia: 1 2 3\nt,wx,wy,wz\n");
/// for i in 0..100 {
///     record += &format!("{},0.1,2,0.1\n", 0.1 * f64::from(i));
/// }
/// let verdict = judge(record.as_bytes(), &Options::default())?;
/// assert_eq!(verdict.outcome, Outcome::Failed);
/// let diagnosis = verdict.diagnosis.unwrap();
/// assert_eq!(diagnosis.best.rule.name(), "no gyroscopic term");
/// # Ok::<(), tumbling_judge::Error>(())
/// ```
///
/// # Errors
/// A record that cannot be read, with line and column; moments that are not known or that no body has.
pub fn judge(source: impl BufRead, options: &Options) -> Result<Verdict, Error> {
    let mut rows = Rows::open(source)?;
    let mut probe = Vec::new();
    while probe.len() < PROBE
        && let Some(raw) = rows.next()?
    {
        probe.push(raw);
    }
    if probe.is_empty() {
        return Err(Error::NoRows);
    }
    if probe.len() == 1 {
        return Err(Error::OneRow);
    }
    let mut notes = std::mem::take(&mut rows.told.notes);
    let moments = match options.inertia {
        Some(moments) => moments,
        None => rows.told.moments(&mut notes).ok_or(Error::NoMoments)?,
    };
    let torque = rows.told.torque.filter(|torque| *torque != Vector3::zeros());
    let subject = Subject::new(moments, torque)?;
    let kind = rows.columns.kind;
    let grid = Grid::of(&probe, rows.told.step);
    if let Some(grid) = &grid {
        notes.push(grid.words());
        probe.iter_mut().for_each(|raw| grid.put(raw));
    }
    let clock = Clock::of(&probe);
    let reading = match kind {
        Kind::Attitude => Reading::of_attitudes(&clock.triples(&probe), &moments),
        _ => Reading::of(kind, &clock.pairs(&probe), &moments),
    };
    let clock = clock.read(reading.time(), rows.told.step);
    let mut floor = rounding(&probe);
    if let Some(grid) = &grid {
        floor = floor.max(grid.floor(&probe, &reading, &moments));
    }
    let mut feed = Feed { told: kind != Kind::Attitude, moments, clock, deriver: Deriver::default() };
    let mut states = Vec::new();
    let mut stopped = None;
    for raw in &probe {
        match feed.push(&reading.state(raw, &moments))? {
            Derived::Known(state) => states.push(state),
            Derived::Unknown => {}
            Derived::TooFar { line, turn } => {
                stopped = Some((line, turn));
                break;
            }
        }
    }
    let Some(mut first) = states.first().copied() else {
        return Err(match stopped {
            Some((line, turn)) => Error::Line { line, problem: too_far(turn) },
            None => Error::OneRow,
        });
    };
    if kind == Kind::Attitude {
        // A rounding of the attitudes is so much more beside the turn that makes a spin.
        let turn = median(states.iter().filter_map(|state| {
            let (_, ahead) = state.ahead?;
            Some(angle_between(&state.attitude?, &ahead)).filter(|turn| *turn > 0.0)
        }));
        if turn.is_finite() && turn > 0.0 {
            floor *= 4.0 / turn.min(1.0);
        }
    }
    let (mut direction, mut fitted) = (None, None);
    if let Some(count) = options.fit {
        if count > states.len() {
            let problem = match probe.len() {
                PROBE => format!("more than {PROBE} are not held in memory"),
                there => format!("the record has {there}. Give a smaller number, `--fit N`"),
            };
            return Err(Error::Fit { rows: count, problem });
        }
        let rows = &states[..count];
        let (omega, how) = fit::start(&moments, rows)?;
        first.omega = omega;
        direction = momentum_of(rows, &moments, &omega)?;
        fitted = Some(how);
    }
    let mut trial = Trial {
        laws: Laws::new(&moments, &first, direction, floor)?,
        first,
        sample: Sample::new(),
        clock,
        rows: 0,
        resets: Vec::new(),
        gaps: None,
        last: None,
        moments,
        torque,
        off: 0.0,
        steps: 0,
        told: kind != Kind::Attitude,
        stopped: None,
        second: None,
        most: 0.0,
        now: 0.0,
        turn_off: 0.0,
        floor,
        ended: None,
        few: rounding(&probe) > 2.0 * f64::from(f32::EPSILON),
    };
    trial.rows = probe.len() as u64;
    for state in &states {
        trial.row(state)?;
    }
    trial.stopped = stopped;
    while let Some(mut raw) = rows.next()? {
        if let Some(grid) = &grid {
            grid.put(&mut raw);
        }
        trial.rows += 1;
        if trial.stopped.is_some() {
            continue;
        }
        match feed.push(&reading.state(&raw, &moments))? {
            Derived::Known(state) => trial.row(&state)?,
            Derived::Unknown => {}
            Derived::TooFar { line, turn } => trial.stopped = Some((line, turn)),
        }
    }
    trial.second = disagreement(&rows.columns, &probe, &reading, &moments, floor);
    trial.ended = rows.ended.take().map(|error| error.to_string());
    let mut verdict = trial.end(&subject, &reading, kind, floor, rows.told.engine, options);
    verdict.fit = fitted;
    verdict.ignored = rows.columns.ignored();
    verdict.notes = notes;
    Ok(verdict)
}

/// The mean of the momenta in the world that the rows' attitudes make of the exact motion's; `None` without attitudes.
fn momentum_of(
    rows: &[State],
    moments: &Vector3<f64>,
    omega: &Vector3<f64>,
) -> Result<Option<Vector3<f64>>, tumbling::Error> {
    let Some(first) = rows.first() else { return Ok(None) };
    let motion = FreeMotion::new(moments, omega)?;
    let mut sum = Vector3::zeros();
    for row in rows {
        let Some(q) = row.attitude else { return Ok(None) };
        sum += turned(&q, &moments.component_mul(&motion.omega(row.t - first.t)?)) / q.norm_squared();
    }
    Ok(Some(sum))
}

/// The rounding of numbers that have so many digits, or that single precision holds.
fn rounding(probe: &[Raw]) -> f64 {
    let digits = probe.iter().map(|raw| raw.digits).max().unwrap_or(17).min(17);
    let single = probe.iter().all(|raw| raw.single) && digits > 6;
    let of_digits = if digits >= 16 { 0.0 } else { 10.0_f64.powi(1 - i32::try_from(digits).unwrap_or(17)) };
    // Few digits may be all there are: 0.5 has one. A record of such numbers alone does not move.
    let of_digits = if digits < 4 { 0.0 } else { of_digits };
    let of_single = if single { f64::from(f32::EPSILON) } else { 0.0 };
    // Numbers of so many places after the point have fewer digits where they are small.
    let place = probe.iter().map(|raw| raw.place).fold(f64::INFINITY, f64::min);
    let size = median(probe.iter().map(|raw| raw.vector.norm()).filter(|size| *size > 0.0));
    let of_place =
        if digits < 4 || place.partial_cmp(&size) != Some(std::cmp::Ordering::Less) || size.is_infinite() {
            0.0
        } else {
            place / size
        };
    f64::EPSILON.max(of_digits).max(of_single).max(of_place)
}

/// Where a second vector of the record, as a spin, is not what the first one tells: the first such row looked at, in words.
fn disagreement(
    columns: &Columns,
    probe: &[Raw],
    reading: &Reading,
    moments: &Vector3<f64>,
    floor: f64,
) -> Option<String> {
    let (kind, places) = columns.second.filter(|_| reading.mistakes().is_empty())?;
    probe.iter().find_map(|raw| {
        let first = reading.state(raw, moments).omega;
        let other = Raw { attitude: reading.state(raw, moments).attitude, vector: raw.second, ..*raw };
        let other = other.omega(kind, moments);
        let off = (first - other).norm() / first.norm().max(other.norm());
        (off > (1e3 * floor).max(1e-6)).then(|| {
            format!(
                "the columns of `{}` tell another spin than those judged, by {:.3} % in line {}",
                columns.names[places[0]],
                100.0 * off,
                raw.line
            )
        })
    })
}

/// What a record without attitudes, or of attitudes alone, does not tell.
fn untold(attitude: bool, kind: Kind) -> Vec<LawName> {
    match (attitude, kind) {
        (false, _) => vec![LawName::Direction, LawName::Unit, LawName::Consistency],
        (true, Kind::Attitude) => vec![LawName::Consistency],
        _ => Vec::new(),
    }
}

fn times(count: u64) -> String {
    if count == 1 { "once".into() } else { format!("{count} times") }
}

/// How time goes from row to row.
#[derive(Debug, Clone, Copy)]
struct Clock {
    /// The step; none where it varies.
    step: Option<f64>,
    /// By how much of itself a step may seem another for the rounding of the times.
    slack: f64,
}

impl Clock {
    /// From the times as the file has them.
    fn of(probe: &[Raw]) -> Self {
        if let Some(clock) = Self::of_rounded(probe) {
            return clock;
        }
        let steps = probe.windows(2).map(|rows| rows[1].t - rows[0].t);
        let least = steps.clone().fold(f64::INFINITY, f64::min);
        let mut count = 0.0;
        for step in steps {
            let times = (step / least).round();
            if (step / least - times).abs() > 0.02 {
                return Self { step: None, slack: 0.05 };
            }
            count += times;
        }
        let whole = probe.last().map_or(0.0, |row| row.t) - probe[0].t;
        Self { step: Some(whole / count), slack: 0.05 }
    }

    /// Of even steps without gaps, at times of a few digits: none is farther from its place than its rounding.
    fn of_rounded(probe: &[Raw]) -> Option<Self> {
        let (first, last) = (probe.first()?, probe.last()?);
        #[expect(clippy::cast_precision_loss, reason = "a count of rows")]
        let step = (last.t - first.t) / (probe.len() - 1) as f64;
        let digits = probe.iter().map(|raw| raw.time.0).max().filter(|digits| *digits <= 9)?;
        let place = probe.iter().map(|raw| raw.time.1).fold(f64::INFINITY, f64::min);
        let rounding = |t: f64| {
            let of_digits = t.abs().log10().floor() + 1.0 - f64::from(digits);
            if t == 0.0 { place } else { place.max(10.0_f64.powf(of_digits)) }
        };
        let mut slack = 0.05_f64;
        let mut due = first.t;
        for rows in probe.windows(2) {
            due += step;
            if (rows[1].t - due).abs() > 1.5 * rounding(rows[1].t) {
                return None;
            }
            slack = slack.max(1.01 * ((rows[1].t - rows[0].t) / step - 1.0).abs());
        }
        (slack < 0.45).then_some(Self { step: Some(step), slack })
    }

    /// In seconds, and to the digit where the step is told.
    fn read(self, time: f64, told: Option<f64>) -> Self {
        let step = self.step.map(|step| step * time);
        let step = step.map(|step| told.filter(|told| (told / step - 1.0).abs() < 0.02).unwrap_or(step));
        Self { step, ..self }
    }

    /// The step between two times, and how many steps long it is.
    fn between(&self, from: f64, to: f64) -> (f64, f64) {
        let Some(step) = self.step else { return (to - from, 1.0) };
        let times = (to - from) / step;
        if (times - 1.0).abs() < self.slack { (step, 1.0) } else { (to - from, times) }
    }

    /// Three rows, each one step after the other, with the step as the file has it.
    fn triples(&self, probe: &[Raw]) -> Vec<[(Raw, f64); 3]> {
        let every = probe.len().div_ceil(PROBED).max(1);
        let three = probe.windows(3).step_by(every).filter_map(|rows| {
            let (h, times) = self.between(rows[0].t, rows[1].t);
            let (next, more) = self.between(rows[1].t, rows[2].t);
            (times == 1.0 && more == 1.0).then_some([(rows[0], 0.0), (rows[1], h), (rows[2], next)])
        });
        three.collect()
    }

    /// Rows one step apart, with the step as the file has it.
    fn pairs(&self, probe: &[Raw]) -> Vec<(Raw, Raw, f64)> {
        let mut pairs: Vec<_> = probe
            .windows(2)
            .filter_map(|rows| {
                let (h, times) = self.between(rows[0].t, rows[1].t);
                (times == 1.0).then_some((rows[0], rows[1], h))
            })
            .collect();
        let every = pairs.len().div_ceil(PROBED).max(1);
        let mut place = 0;
        pairs.retain(|_| {
            place += 1;
            (place - 1) % every == 0
        });
        pairs
    }
}

/// Rows, with spins where the record tells none.
struct Feed {
    told: bool,
    moments: Vector3<f64>,
    clock: Clock,
    deriver: Deriver,
}

impl Feed {
    fn push(&mut self, state: &State) -> Result<Derived, Error> {
        if state.attitude.is_some_and(|q| q.norm() == 0.0) {
            let problem = "the quaternion has no length: it is no attitude".into();
            return Err(Error::Line { line: state.line, problem });
        }
        if self.told {
            return Ok(Derived::Known(*state));
        }
        let (h, times) = self.deriver.last().map_or((0.0, 1.0), |last| self.clock.between(last, state.t));
        Ok(self.deriver.push(&self.moments, state, h, times))
    }
}

fn too_far(turn: f64) -> String {
    format!(
        "the attitude turns by {turn:.2} rad or more in one step, and attitudes alone do not tell a turn from one that goes the other \
         way round. Record the spin, or shorter steps"
    )
}

/// A trial as far as it has come.
struct Trial {
    laws: Laws,
    first: State,
    sample: Sample,
    clock: Clock,
    rows: u64,
    resets: Vec<Reset>,
    gaps: Option<Gaps>,
    last: Option<State>,
    moments: Vector3<f64>,
    torque: Option<Vector3<f64>>,
    /// The most that a step was off the law, and how many steps there were.
    off: f64,
    steps: u64,
    /// Whether the record tells spins.
    told: bool,
    /// At which line the attitude turns too far to tell which way, and by how much, rad.
    stopped: Option<(usize, f64)>,
    /// How a second vector of the record is at odds with the first, in words.
    second: Option<String>,
    /// The most that a step before the last was off the law in spin, and the last; the most in turn, rad; and the rounding of the numbers.
    most: f64,
    now: f64,
    turn_off: f64,
    floor: f64,
    /// Where the numbers end, and with what.
    ended: Option<String>,
    /// Whether the record has fewer digits than single precision.
    few: bool,
}

/// No more resets than this are told one by one.
const RESETS: usize = 16;

impl Trial {
    fn row(&mut self, state: &State) -> Result<(), Error> {
        let mut steps = 0.0;
        if let Some(last) = self.last.replace(*state) {
            let (h, times) = self.clock.between(last.t, state.t);
            steps = times;
            if times != 1.0 {
                let gaps = self.gaps.get_or_insert(Gaps { count: 0, line: state.line, longest: 0.0 });
                gaps.count += 1;
                gaps.longest = gaps.longest.max(times);
            }
            let to_start = self.starts_anew(&last, state) || self.comes_back(&last, state, times);
            let jumps = times == 1.0 && self.jumps(&Pair { from: last, to: *state, h });
            if (to_start || jumps) && self.resets.len() < RESETS {
                let to_rest = state.omega == Vector3::zeros();
                let to_start = to_start && !to_rest;
                let line = state.ahead.map_or(state.line, |(line, _)| line);
                self.resets.push(Reset { line, time: state.t, to_rest, to_start });
            }
            if self.resets.is_empty() && times == 1.0 {
                let pair = Pair { from: last, to: *state, h };
                if self.told {
                    self.laws.pair(&pair);
                }
                if self.told || state.ahead.is_some() {
                    self.sample.push(&pair);
                }
            }
        }
        if self.resets.is_empty() {
            self.laws.push(state, steps)?;
        }
        Ok(())
    }

    /// A step that is a hundred times as far from the law as the steps before it were, and farther than a rule's error in one step can
    /// be: the law itself changes the spin by no more than the angle turned.
    fn jumps(&mut self, pair: &Pair) -> bool {
        let (from, to) = (pair.from.omega, pair.to.omega);
        // Of attitudes alone a spin that is out of all proportion is what is to be found.
        let speed = if self.told { from.norm().max(to.norm()) } else { from.norm() };
        let mean = (from + to) / 2.0;
        let rate = euler::angular_acceleration(&self.moments, &mean, &self.torque(pair));
        let spin = (to - from - rate * pair.h).norm() / speed;
        let turn = match (pair.turn(), speed * pair.h < 1.0) {
            (Some(turn), true) => (turn - mean * pair.h).norm(),
            _ => 0.0,
        };
        let off = spin.max(turn);
        if !off.is_finite() {
            return false;
        }
        self.most = self.most.max(self.now);
        self.now = spin;
        // A slow body turns little in a step: what is no jump for a fast one is many steps for it.
        let thrown = self.steps > 8
            && turn > 20.0 * speed * pair.h
            && turn > 100.0 * self.turn_off
            && turn > 1e3 * self.floor;
        self.turn_off = self.turn_off.max(turn);
        if thrown {
            return true;
        }
        let jumps = self.steps > 8 && off > 0.2 && off > 3.0 * speed * pair.h && off > 100.0 * self.off;
        if !jumps {
            // Forgotten slowly, so that a rule that goes astray now and then is known to.
            self.off = off.max(0.98 * self.off);
            self.steps += 1;
        }
        jumps
    }

    /// Back at the spin of the start, to its last digit, by a step that is farther from the law than any before: a record without attitudes
    /// that starts anew where the spin is near its first value anyway.
    fn comes_back(&self, last: &State, state: &State, times: f64) -> bool {
        let (first, now, was) = (&self.first.omega, &state.omega, &last.omega);
        let h = state.t - last.t;
        if self.steps < 8
            || times != 1.0
            || state.attitude.is_some()
            || (now - first).norm() > 1e-12 * first.norm()
        {
            return false;
        }
        let rate = euler::angular_acceleration(&self.moments, &((was + now) / 2.0), &Vector3::zeros());
        let off = (now - was - rate * h).norm() / now.norm().max(was.norm());
        off > 4.0 * self.most.max(self.now) && off > 64.0 * self.floor
    }

    /// The torque in body axes, for a mean over the step.
    fn torque(&self, pair: &Pair) -> Vector3<f64> {
        match (self.torque, pair.from.attitude) {
            (Some(torque), Some(q)) => {
                tumbling::attitude::rotation_matrix(&q).tr_mul(&torque) / q.norm_squared()
            }
            _ => Vector3::zeros(),
        }
    }

    /// A body that moves is at rest all of a sudden, or back at the start without a way there.
    fn starts_anew(&self, last: &State, state: &State) -> bool {
        let (before, now) = (last.omega.norm(), state.omega.norm());
        if before > 0.0 && now == 0.0 {
            return before > 1e-3 * self.first.omega.norm();
        }
        let back = (state.omega - self.first.omega).norm() <= 1e-12 * self.first.omega.norm();
        let Some(((first, q), was)) = self.first.attitude.zip(state.attitude).zip(last.attitude) else {
            return back && (last.omega - state.omega).norm() > 0.2 * now;
        };
        let turned = angle_between(&was, &q);
        back && angle_between(&first, &q) < 1e-12
            && turned > 0.2
            && turned > 1.5 * before.max(now) * (state.t - last.t)
    }

    fn end(
        self,
        subject: &Subject,
        reading: &Reading,
        kind: Kind,
        floor: f64,
        engine: Option<String>,
        options: &Options,
    ) -> Verdict {
        let Self { laws, first, sample, clock, rows, resets, gaps, stopped, second, ended, few, .. } = self;
        let free = subject.torque.is_none();
        let still = free
            && laws.constant
            && !should_change(subject, sample.pairs(), floor)
            && (laws.moved <= 100.0 * floor || laws.on_axis());
        let few = Floor { size: floor, few };
        let mut diagnosis = if still { None } else { diagnose(subject, &sample, few, kind.is_momentum()) };
        let mut kept = laws.kept(|law| options.allowed(law));
        if !free {
            kept.retain(|law| matches!(law.name, LawName::Unit | LawName::Consistency));
        }
        let mut complaints = Vec::new();
        complaints.extend(ended.map(|at| format!("the numbers end at {at}. Judged up to there")));
        let ended = !complaints.is_empty();
        let flips = laws.flips().filter(|_| free);
        if let Some(t) = flips.as_ref().and_then(|flips| flips.turned_over) {
            complaints.push(format!(
                "the spin turns over at {t:.4} s about the axis that it should circle for ever"
            ));
        }
        match flips.as_ref().map(|flips| (flips.found, flips.exact)) {
            Some((0, wanted)) if wanted > 0 => {
                complaints.push(format!(
                    "the spin along the middle axis never changes sign, and should do so {}",
                    times(wanted)
                ));
            }
            Some((found, 0)) if found > 0 => {
                complaints.push(format!(
                    "the spin along the middle axis changes sign {}, and should never do so",
                    times(found)
                ));
            }
            _ => {}
        }
        complaints.extend(second);
        if free && !still && laws.constant && laws.moved > f64::max(0.1, 100.0 * floor) {
            let moved = 100.0 * laws.moved;
            complaints.push(format!(
                "the spin stays as it is at the start, and should change by {moved:.0} % of it"
            ));
        }
        if let Some((line, turn)) = stopped {
            complaints.push(format!("line {line}: {}. Judged up to there", too_far(turn)));
        }
        if sample.seen() == 0 {
            complaints.push("no two rows are one step apart: no rule can be tried".into());
        }
        let consistent = options.allowed(LawName::Consistency).unwrap_or(options.threshold);
        let otherwise = kept.iter().find(|law| law.name == LawName::Consistency && law.most > consistent);
        let turns_otherwise = otherwise.is_some();
        if let Some(law) = otherwise {
            let off = 100.0 * law.most;
            complaints
                .push(format!("the attitude does not turn as the spin says, by up to {off:.1} % of it"));
        }
        // Of a few rows any rule may be had.
        if free && rows >= ENOUGH {
            complaints.extend(diagnosis.as_ref().and_then(wrong_rule));
            complaints.extend(wrong_pace(&kept, laws.ways_round(), options));
        }
        let misread = reading.mistakes();
        let broken =
            kept.iter().any(|law| options.allowed(law.name).is_some_and(|most| law.most.abs() > most));
        // Of few digits a wrong rule may fit each step: what the whole record does is held against it too.
        let astray =
            free && (broken || flips.as_ref().is_some_and(|flips| flips.found.abs_diff(flips.exact) > 1));
        if let (Some(found), Some(h)) = (&mut diagnosis, clock.step)
            && few.few
            && astray
            && found.sure == Sure::ToRounding
        {
            let flips = flips.as_ref().map(|flips| flips.found);
            found.by_drift(subject, &sample, &Run { first, last: laws.last, h, flips, floor });
        }
        let outcome = if !misread.is_empty() || !resets.is_empty() || ended {
            Outcome::Failed
        } else if !free || still && !broken && !turns_otherwise {
            Outcome::NothingToJudge
        } else if broken || !complaints.is_empty() {
            Outcome::Failed
        } else if rows < ENOUGH || laws.turned < TAU && laws.moved < 0.1 {
            Outcome::TooShort
        } else {
            Outcome::Passed
        };
        Verdict {
            engine,
            moments: subject.moments,
            torque: subject.torque,
            rows,
            duration: laws.last.t - first.t,
            step: clock.step,
            rounding: floor,
            has_attitude: first.attitude.is_some(),
            misread,
            untold: untold(first.attitude.is_some(), kind),
            resets,
            gaps,
            sign_changes: laws.sign_changes,
            laws: kept,
            flips,
            separatrix: laws.separatrix().filter(|ends| free && ends.iter().all(|x| x.is_finite())),
            diagnosis,
            complaints,
            options: *options,
            fit: None,
            ignored: Vec::new(),
            notes: Vec::new(),
            curve: laws.points.into_all(),
            outcome,
        }
    }
}
