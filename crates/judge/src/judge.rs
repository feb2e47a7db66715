//! From a record to a verdict, one row in hand at a time.

use crate::candidates::Subject;
use crate::clock::Clock;
use crate::columns::Kind;
use crate::derived::{Derived, Deriver, Feed};
use crate::error::Error;
use crate::findings::{Complaint, Note};
use crate::fit::{self, Fit};
use crate::grid::Grid;
use crate::reading::Reading;
use crate::rounding::rounding;
use crate::rows::Rows;
use crate::source::{Raw, Source};
use crate::state::{Row, angle_between, in_world, median};
use crate::thresholds::{FAR_FROM_ONE, FEW_DIGITS, PROBE_ROWS, SPIN_FROM_TURN, VECTORS_APART};
use crate::trial::{Conditions, Trial};
use crate::verdict::{Options, Verdict};
use nalgebra::Vector3;
use std::io::BufRead;
use tumbling::PrincipalMoments;
use tumbling::exact::FreeMotion;

/// Judges a record.
///
/// The first line that is neither empty nor a comment (`#`) names the columns: `t` (s) or `step`,
/// `qw,qx,qy,qz` (body to world), `wx,wy,wz` (spin in body axes, rad/s) or `wxw,wyw,wzw` (in world axes), or
/// momentum (`lx,ly,lz`, `lxw,lyw,lzw`, kg m²/s), or attitudes alone, from which the spin is then
/// computed; in any order, between commas, semicolons, tabs or blanks. Comments before it may give
/// `inertia: A B C`, `dt: 1/60` and `torque: X Y Z`.
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
    let mut notes = std::mem::take(&mut rows.header.notes);
    let moments = options.inertia.or_else(|| rows.header.moments(&mut notes));
    let second = rows.columns.second.map(|(kind, places)| (kind, rows.columns.names[places[0]].clone()));
    let torque = rows.header.torque.filter(|torque| *torque != Vector3::zeros());
    let about = About { kind: rows.columns.kind, second, step: rows.header.step, torque, moments, notes };
    let mut verdict = judge_rows(&mut rows, about, options)?;
    if let Some(diagnosis) = &mut verdict.diagnosis {
        diagnosis.name_engines(rows.header.engine.as_deref());
    }
    verdict.record.engine = rows.header.engine;
    verdict.record.ignored = rows.columns.ignored();
    Ok(verdict)
}

/// What is known of a record besides its rows.
pub(crate) struct About {
    pub kind: Kind,
    /// Another vector of the rows, and the name of its first column.
    pub second: Option<(Kind, String)>,
    /// The step that it names, s.
    pub step: Option<f64>,
    /// Constant in the world, N m.
    pub torque: Option<Vector3<f64>>,
    /// Principal moments, kg m².
    pub moments: Option<Vector3<f64>>,
    pub notes: Vec<Note>,
}

/// Judges rows from anywhere.
pub(crate) fn judge_rows(
    rows: &mut dyn Source,
    mut about: About,
    options: &Options,
) -> Result<Verdict, Error> {
    options.checked()?;
    let mut probe = probed(rows)?;
    let (moments, torque) = (about.moments.ok_or(Error::NoMoments)?, about.torque);
    PrincipalMoments::try_from(moments)?;
    let unit = unit_of(&moments);
    let subject = Subject::new(moments / unit, torque.map(|torque| torque / unit))?;
    let meaning = Meaning::of(&mut probe, &mut about, &moments);
    let has_spin = about.kind != Kind::Attitude;
    let mut feed = Feed { has_spin, moments, clock: meaning.clock, deriver: Deriver::default() };
    let (states, stopped) = understood(&probe, &meaning.reading, &mut feed)?;
    let start = Start::of(&states, stopped, &probe, &subject.moments, options)?;
    let floor = meaning.floor_of(&states, has_spin);
    let rounding = rounding(&probe);
    let conditions = Conditions {
        kind: about.kind,
        clock: meaning.clock,
        floor,
        few: rounding > FEW_DIGITS * f64::from(f32::EPSILON),
        single: rounding == f64::from(f32::EPSILON),
    };
    let mut trial = Trial::new(&subject, start.first, start.direction, conditions)?;
    trial.rows = probe.len() as u64;
    for state in &states {
        trial.row(state)?;
    }
    trial.stopped = stopped;
    follow(rows, &mut trial, &meaning, &mut feed)?;
    trial.second = disagreement(&about, &probe, &meaning.reading, &moments, floor);
    trial.ended = rows.ended().map(|error| error.to_string());
    let mut verdict = trial.end(&subject, &meaning.reading, options);
    verdict.fit = start.fit;
    (verdict.moments, verdict.torque) = (moments, torque);
    if let Some(diagnosis) = &mut verdict.diagnosis {
        diagnosis.in_units_of(unit);
    }
    verdict.record.notes = about.notes;
    Ok(verdict)
}

/// The rows after those that the reading was settled by.
fn follow(rows: &mut dyn Source, trial: &mut Trial, meaning: &Meaning, feed: &mut Feed) -> Result<(), Error> {
    while let Some(mut raw) = rows.next()? {
        if let Some(grid) = &meaning.grid {
            grid.put(&mut raw);
        }
        trial.rows += 1;
        if trial.stopped.is_some() {
            continue;
        }
        match feed.push(&meaning.reading.state(&raw, &feed.moments))? {
            Derived::Known(state) => trial.row(&state)?,
            Derived::Unknown => {}
            Derived::TooFar { line, turn } => trial.stopped = Some((line, turn)),
        }
    }
    Ok(())
}

/// What moments so large or small are divided by, so that products of momenta are numbers; a power of two.
fn unit_of(moments: &Vector3<f64>) -> f64 {
    let size = moments.amax().log2().floor();
    if size.abs() < FAR_FROM_ONE { 1.0 } else { size.exp2() }
}

/// The first rows, two at least.
fn probed(rows: &mut dyn Source) -> Result<Vec<Raw>, Error> {
    let mut probe = Vec::new();
    while probe.len() < PROBE_ROWS
        && let Some(raw) = rows.next()?
    {
        probe.push(raw);
    }
    match probe.len() {
        0 => Err(Error::NoRows),
        1 => Err(Error::OneRow),
        _ => Ok(probe),
    }
}

/// How the numbers of a record are meant.
struct Meaning {
    grid: Option<Grid>,
    reading: Reading,
    clock: Clock,
    /// The rounding of the numbers, relative to 1.
    floor: f64,
}

impl Meaning {
    /// From the first rows, whose times are put to the grid that they are rounded from.
    fn of(probe: &mut [Raw], about: &mut About, moments: &Vector3<f64>) -> Self {
        let notes = &mut about.notes;
        let grid = Grid::of(probe, about.step);
        if let Some(grid) = &grid {
            notes.push(grid.note());
            probe.iter_mut().for_each(|raw| grid.put(raw));
        }
        let clock = Clock::of(probe);
        let reading = match about.kind {
            Kind::Attitude => Reading::of_attitudes(&clock.triples(probe), moments),
            kind => Reading::of(kind, &clock.pairs(probe), moments),
        };
        let (clock, note) = clock.read(reading.time(), about.step);
        notes.extend(note);
        let mut floor = rounding(probe);
        if let Some(grid) = &grid {
            floor = floor.max(grid.floor(probe, &reading, moments));
        }
        Self { grid, reading, clock, floor }
    }

    /// The rounding of the spins. A rounding of attitudes alone is so much more relative to the turn that
    /// makes a spin.
    fn floor_of(&self, states: &[Row], has_spin: bool) -> f64 {
        if has_spin {
            return self.floor;
        }
        let turn = median(states.iter().filter_map(|state| {
            let (_, ahead) = state.ahead?;
            Some(angle_between(&state.attitude?, &ahead)).filter(|turn| *turn > 0.0)
        }));
        if turn.is_finite() && turn > 0.0 {
            self.floor * (SPIN_FROM_TURN / turn.min(1.0))
        } else {
            self.floor
        }
    }
}

/// At which line an attitude turns too far for its direction to be known, and by how much, rad.
type Stopped = Option<(usize, f64)>;

/// The first rows as motions, up to where one turns too far.
fn understood(probe: &[Raw], reading: &Reading, feed: &mut Feed) -> Result<(Vec<Row>, Stopped), Error> {
    let mut states = Vec::new();
    for raw in probe {
        match feed.push(&reading.state(raw, &feed.moments))? {
            Derived::Known(state) => states.push(state),
            Derived::Unknown => {}
            Derived::TooFar { line, turn } => return Ok((states, Some((line, turn)))),
        }
    }
    Ok((states, None))
}

/// What the record is held against.
struct Start {
    first: Row,
    /// The momentum in the world, where it is fitted.
    direction: Option<Vector3<f64>>,
    fit: Option<Fit>,
}

impl Start {
    /// The first row, or the start whose exact motion is nearest to that number of rows.
    fn of(
        states: &[Row],
        stopped: Stopped,
        probe: &[Raw],
        moments: &Vector3<f64>,
        options: &Options,
    ) -> Result<Self, Error> {
        let Some(mut first) = states.first().copied() else {
            return Err(match stopped {
                Some((line, turn)) => {
                    Error::Line { line, problem: Complaint::TooFar { line, turn }.problem() }
                }
                None => Error::OneRow,
            });
        };
        let Some(count) = options.fit else { return Ok(Self { first, direction: None, fit: None }) };
        if count > states.len() {
            let problem = match probe.len() {
                PROBE_ROWS => format!("more than {PROBE_ROWS} are not held in memory"),
                there => format!("the record has {there}. Give a smaller number"),
            };
            return Err(Error::Fit { rows: count, problem });
        }
        let rows = &states[..count];
        let (omega, how) = fit::start(moments, rows)?;
        first.omega = omega;
        Ok(Self { first, direction: momentum_of(rows, moments, &omega)?, fit: Some(how) })
    }
}

/// The mean of the momenta in the world that the rows' attitudes make of the exact motion's; `None` without
/// attitudes.
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
        sum += in_world(&q, &moments.component_mul(&motion.omega(row.t - first.t)?)) / q.norm_squared();
    }
    Ok(Some(sum))
}

/// Where a second vector of the record, as a spin, is not what the first one says: the first such row looked
/// at.
fn disagreement(
    about: &About,
    probe: &[Raw],
    reading: &Reading,
    moments: &Vector3<f64>,
    floor: f64,
) -> Option<Complaint> {
    let (kind, column) = about.second.as_ref().filter(|_| reading.mistakes().is_empty())?;
    let [roundings, share] = VECTORS_APART;
    probe.iter().find_map(|raw| {
        let first = reading.state(raw, moments).omega;
        let other = Raw { attitude: reading.state(raw, moments).attitude, vector: raw.second, ..*raw };
        let other = other.omega(*kind, moments);
        let off = (first - other).norm() / first.norm().max(other.norm());
        let apart = off > (roundings * floor).max(share);
        apart.then(|| Complaint::OtherSpin { column: column.clone(), off, line: raw.line })
    })
}
