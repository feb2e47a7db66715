//! From a record to a verdict, one row in hand at a time.

use crate::clock::Clock;
use crate::columns::{Columns, Kind};
use crate::derived::{Derived, Deriver, Feed, too_far};
use crate::diagnosis::{Diagnosis, Sample};
use crate::error::Error;
use crate::fit::{self, Fit};
use crate::grid::Grid;
use crate::laws::{FlipCount, Law, LawName, Laws, angle_between, turned};
use crate::points::Point;
use crate::reading::{Misread, Reading};
use crate::rows::{Raw, Rows};
use crate::state::{Row, median};
use crate::suspects::Subject;
use crate::trial::Trial;
use nalgebra::Vector3;
use std::io::BufRead;
use tumbling::exact::FreeMotion;

/// How many rows are looked at before it is settled how they are meant.
const PROBE: usize = 2048;

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
    /// The record has nothing that could be told right or wrong.
    NothingToJudge,
    /// No law is broken, and too little is seen for that to say anything.
    TooShort,
}

impl Outcome {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Passed, Self::Failed, Self::NothingToJudge, Self::TooShort];

    /// What a program calls it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::NothingToJudge => "nothing to judge",
            Self::TooShort => "too short to judge",
        }
    }
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
    /// Whether the body turns so far that no `f64` tells where in its motion it should be.
    pub untraceable: bool,
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
    rows: &[Row],
    moments: &Vector3<f64>,
    omega: &Vector3<f64>,
) -> Result<Option<Vector3<f64>>, tumbling::Error> {
    let Some(first) = rows.first() else { return Ok(None) };
    let motion = FreeMotion::new((*moments).try_into()?, omega)?;
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
