//! From a record to a verdict, one row in hand at a time.

use crate::error::Error;
use crate::laws::Trial;
use crate::options::Options;
use crate::read::{Known, Note, Raw, Rows, Said, Source};
use crate::rule::Subject;
use crate::thresholds::PROBE_ROWS;
use crate::verdict::{Verdict, too_far, verdict};
use nalgebra::Vector3;
use std::io::BufRead;
use tumbling::PrincipalMoments;
use tumbling_engines::PHYSICS_ENGINES;

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
    let said = Said {
        engine: rows.header.engine(|word| PHYSICS_ENGINES.iter().any(|engine| engine.is_called(word))),
        kind: rows.columns.kind,
        step: rows.header.step,
        torque: rows.header.torque.filter(|torque| *torque != Vector3::zeros()),
        moments: options.inertia.map_or_else(|| rows.header.moments(&mut notes), |given| Ok(Some(given)))?,
        notes,
        ignored: rows.columns.ignored(),
    };
    judge_rows(&mut rows, said, options)
}

/// Judges rows from anywhere.
pub(crate) fn judge_rows(rows: &mut dyn Source, said: Said, options: &Options) -> Result<Verdict, Error> {
    options.checked()?;
    let mut probe = probed(rows)?;
    let moments = said.moments.ok_or(Error::NoMoments)?;
    PrincipalMoments::try_from(moments)?;
    let subject = Subject::new(moments, said.torque)?;
    let known = Known::of(&mut probe, said, moments);
    // Attitudes that are not read as named may be right, and the step wrong.
    let plain = known.plainly();
    let mut grid = known.grid;
    let mut first = begun(known, &probe, &subject)?;
    let mut plain = plain.and_then(|plain| begun(plain, &probe, &subject).ok());
    while let Some(mut raw) = rows.next()? {
        grid.iter_mut().for_each(|grid| grid.put(&mut raw));
        follow(&raw, &mut first)?;
        plain.take_if(|plain| follow(&raw, plain).is_err());
    }
    let ended = rows.ended().map(|error| error.to_string());
    let judged = |mut trial: Trial| {
        trial.ended.clone_from(&ended);
        verdict(trial, &subject, options)
    };
    let is_named = |x: &Verdict| x.diagnosis.as_ref().is_some_and(|x| x.confidence.names_a_rule());
    let first = judged(first);
    Ok(plain.filter(|_| !is_named(&first)).map(judged).filter(is_named).unwrap_or(first))
}

/// The trial of the rows that the reading was settled by.
fn begun(mut known: Known, probe: &[Raw], subject: &Subject) -> Result<Trial, Error> {
    let mut waiting = None;
    let (mut states, stopped) = known.understood(probe, &mut waiting);
    let rest = states.iter().position(|row| row.omega != Vector3::zeros()).unwrap_or(0);
    states.drain(..rest);
    known.said.notes.extend(states.first().filter(|_| rest > 0).map(|first| Note::Rest(first.line)));
    let wrong = |(line, turn)| Error::Line { line, problem: too_far(turn) };
    let first = *states.first().ok_or_else(|| stopped.map_or(Error::OneRow, wrong))?;
    let mut trial = Trial::new(&subject.moments, first, known)?;
    trial.rows = probe.len() as u64;
    states.iter().try_for_each(|state| trial.row(state))?;
    (trial.stopped, trial.waiting) = (stopped, waiting);
    Ok(trial)
}

/// One of the rows after those.
fn follow(raw: &Raw, trial: &mut Trial) -> Result<(), Error> {
    trial.rows += 1;
    if trial.stopped.is_some() {
        return Ok(());
    }
    match trial.known.row(raw, &mut trial.waiting) {
        Ok(state) => state.iter().try_for_each(|state| trial.row(state))?,
        Err(stopped) => trial.stopped = Some(stopped),
    }
    Ok(())
}

/// The first rows, two at least.
fn probed(rows: &mut dyn Source) -> Result<Vec<Raw>, Error> {
    let mut probe = Vec::new();
    while probe.len() < PROBE_ROWS
        && let Some(raw) = rows.next()?
    {
        probe.push(raw);
    }
    let few = [Error::NoRows, Error::OneRow].into_iter().nth(probe.len());
    few.map_or(Ok(probe), Err)
}
