//! Compares records of one object that was described to its engine in several ways.
//!
//! The turn since the start and the spin are compared in world axes, so that it does not matter how the axes
//! of a description lie in the body; of the positions, that they are of two points of one body.

use crate::error::Error;
use crate::gyroscope::{FittedInertia, fit_inertia};
use crate::memory::{Memory, Precision, Row};
use crate::options::Options;
use crate::read::{Kind, Reading, Rows, Source, angle_between, in_world, rounding};
use crate::thresholds::PROBE_ROWS;
use crate::verdict::{Outcome, VERSION, plain_number};
use nalgebra::{Matrix3, Matrix3x6, Matrix6, Quaternion, Vector3, Vector6};
use serde_json::{Value, json};
use std::fmt;
use std::io::BufRead;
use tumbling::attitude::{product, rotation_matrix};

/// A record, as it is compared with others.
#[derive(Debug, Clone)]
pub struct Motion {
    rows: Vec<Instant>,
    rounding: f64,
    /// Whether it has spins, and positions.
    has: [bool; 2],
}

#[derive(Debug, Clone, Copy)]
struct Instant {
    t: f64,
    attitude: Quaternion<f64>,
    /// In body axes and in the world's, rad/s.
    spin: [Vector3<f64>; 2],
    /// In the world, in the record's unit.
    position: Vector3<f64>,
}

impl Motion {
    /// Reads a record with attitudes; columns `x,y,z` (or `px,py,pz`) are the position of its origin in the
    /// world.
    ///
    /// # Errors
    /// A record that cannot be read, or has no attitudes; momentum in place of a spin without moments.
    pub fn read(source: impl BufRead, options: &Options) -> Result<Self, Error> {
        let mut rows = Rows::open(source)?;
        rows.columns.take_positions();
        let (kind, positions) = (rows.columns.kind, rows.columns.position.is_some());
        let given = options.inertia.map_or_else(|| rows.header.moments(&mut Vec::new()), |x| Ok(Some(x)))?;
        let moments =
            given.or((!kind.is_momentum()).then(|| Vector3::repeat(1.0))).ok_or(Error::NoMoments)?;
        Self::of(&mut rows, kind, &moments, positions)
    }

    /// From rows in memory, each with an attitude; `kind` says what their spins are.
    ///
    /// # Errors
    /// As of [`read`](Self::read).
    pub fn in_memory<T: Precision>(
        kind: Kind,
        rows: impl IntoIterator<Item = Row<T>>,
    ) -> Result<Self, Error> {
        if kind.is_momentum() {
            return Err(Error::NoMoments);
        }
        Self::of(&mut Memory::of(rows.into_iter(), true), kind, &Vector3::repeat(1.0), false)
    }

    fn of(rows: &mut dyn Source, kind: Kind, moments: &Vector3<f64>, positions: bool) -> Result<Self, Error> {
        let (reading, mut all, mut raws) = (Reading::plain(kind), Vec::new(), Vec::new());
        while let Some(raw) = rows.next()? {
            let row = reading.state(&raw, moments);
            let length = row.attitude.map_or(0.0, |q| q.norm());
            if length == 0.0 || !length.is_finite() {
                let problem = "records are compared by their attitudes, but there is none here".into();
                return Err(Error::Line { line: raw.line, problem });
            }
            let attitude = row.start() / length;
            let spin = [row.omega, in_world(&attitude, &row.omega)];
            all.push(Instant { t: row.t, attitude, spin, position: raw.position });
            if raws.len() < PROBE_ROWS {
                raws.push(raw);
            }
        }
        rows.ended().map_or(Ok(()), Err)?;
        if all.len() < 2 {
            return Err(if all.is_empty() { Error::NoRows } else { Error::OneRow });
        }
        Ok(Self {
            rows: all,
            rounding: rounding(&raws, kind.in_world()),
            has: [kind != Kind::Attitude, positions],
        })
    }

    /// How far `other` is from this motion.
    fn to(&self, other: &Self, threshold: Option<f64>) -> Option<Apart> {
        let fastest = self.rows.iter().map(|row| row.spin[1].norm()).fold(f64::MIN_POSITIVE, f64::max);
        // Rounding adds up over many steps: a third of the digits of the record that has fewer of them.
        let limit = threshold.unwrap_or_else(|| self.rounding.max(other.rounding).cbrt());
        let both = [0, 1].map(|i| self.has[i] && other.has[i]);
        let mut off = [Off { limit, ..Off::default() }; 3];
        let common = self.common(other);
        let ((a, b), _) = (*common.first()?, common.get(1)?);
        let turns = |here: &Instant, start: &Instant| product(&here.attitude, &start.attitude.conjugate());
        for (here, there) in &common {
            off[1].take(here.t, angle_between(&turns(here, a), &turns(there, b)));
            if both[0] {
                off[0].take(here.t, (here.spin[1] - there.spin[1]).norm() / fastest);
            }
        }
        let origin = both[1].then(|| {
            let way = |(here, _): &(&Instant, &Instant)| (here.position - a.position).norm();
            let way = common.iter().map(way).fold(f64::MIN_POSITIVE, f64::max);
            let (origin, left) = positions(&common);
            common.iter().zip(left).for_each(|((here, _), left)| off[2].take(here.t, left / way));
            origin
        });
        Some(Apart { off, rows: common.len(), origin })
    }

    /// The rows of both at the same times.
    fn common<'a>(&'a self, other: &'a Self) -> Vec<(&'a Instant, &'a Instant)> {
        let (mut there, mut all) = (other.rows.iter().peekable(), Vec::new());
        for here in &self.rows {
            let open = f64::from(f32::EPSILON) * (here.t.abs() + (self.rows[1].t - self.rows[0].t));
            while there.next_if(|row| row.t < here.t - open).is_some() {}
            all.extend(there.next_if(|row| row.t <= here.t + open).map(|row| (here, row)));
        }
        all
    }

    /// The moments that its spins fit, with the axes in the world at the start.
    fn inertia(&self) -> Option<FittedInertia> {
        let rows: Vec<_> = self.rows.iter().map(|row| (row.t, row.spin[0])).collect();
        let fitted = fit_inertia(&rows, None).ok().filter(|_| self.has[0])?;
        let start = rotation_matrix(&self.rows[0].attitude);
        Some(FittedInertia { axes: start * fitted.axes, ..fitted })
    }
}

/// The second origin in the axes of the first body, by the first rows, up to a turn of two radians; and how
/// far each position is from there. A body may stand somewhere else, which takes one more vector, in the
/// world.
fn positions(common: &[(&Instant, &Instant)]) -> (Vector3<f64>, Vec<f64>) {
    let apart = |(a, b): &(&Instant, &Instant)| {
        let mut along = Matrix3x6::identity();
        along.fixed_columns_mut::<3>(3).copy_from(&rotation_matrix(&a.attitude));
        (along, b.position - a.position)
    };
    let start = common[0].0.attitude;
    let far = common.iter().position(|(here, _)| angle_between(&start, &here.attitude) > 2.0);
    let first = &common[..far.map_or(common.len(), |far| (far + 1).max(3).min(common.len()))];
    let normal: Matrix6<f64> = first.iter().map(apart).map(|(along, _)| along.tr_mul(&along)).sum();
    let sum: Vector6<f64> = first.iter().map(apart).map(|(along, apart)| along.tr_mul(&apart)).sum();
    let inverse = normal.pseudo_inverse(1e-12 * normal.amax());
    let best = inverse.map_or_else(|_| Vector6::zeros(), |inverse| inverse * sum);
    let left = common.iter().map(apart).map(|(along, apart)| (apart - along * best).norm());
    (best.fixed_rows::<3>(3).into(), left.collect())
}

/// The difference of two motions: spin as a share of the fastest, attitude in rad, position as a share of the
/// greatest distance from the start.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Off {
    /// The largest.
    pub most: f64,
    /// The largest allowed.
    pub limit: f64,
    /// When it first exceeds that, s.
    pub since: Option<f64>,
}

impl Off {
    fn take(&mut self, t: f64, off: f64) {
        self.most = if off.is_nan() { f64::INFINITY } else { self.most.max(off) };
        if self.most > self.limit {
            self.since.get_or_insert(t);
        }
    }
}

/// The differences of two records.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apart {
    /// Spin, attitude and position.
    pub off: [Off; 3],
    /// The number of rows at the same times.
    pub rows: usize,
    /// Where the second origin is in the axes of the first body, in the records' unit; with positions only.
    pub origin: Option<Vector3<f64>>,
}

impl Apart {
    fn is_alike(&self) -> bool {
        self.off.iter().all(|off| off.since.is_none())
    }
}

/// The result of comparing records that should show one motion.
#[derive(Debug, Clone)]
pub struct Comparison {
    names: Vec<String>,
    /// The index of the record that the others are compared with: the first of those alike.
    pub reference: usize,
    /// The largest group that shows one motion, and each record's difference from the reference.
    pub alike: Vec<(usize, Apart)>,
    /// The other records, and their differences from that motion.
    pub others: Vec<(usize, Apart)>,
    inertia: Vec<Option<FittedInertia>>,
    start: f64,
}

/// Compares records of one object, each with its name, at the times that they have in common: they are alike
/// up to the threshold (of spins a share of the fastest, of attitudes rad, of positions a share of the
/// greatest distance from the start), without one up to a third of the digits of the record that has fewer.
///
/// ```
/// use tumbling_judge::{Motion, Options, compare};
/// // A body turns evenly about z; once its own x axis points along the room's x, once along its y.
/// let record = |start: f64| {
///     let mut text = String::from("t,qw,qx,qy,qz,wx,wy,wz\n");
///     for i in 0..100 {
///         let (t, half) = (0.1 * f64::from(i), 0.5 * (start + 0.3 * f64::from(i)));
///         text += &format!("{t},{},0,0,{},0,0,3\n", half.cos(), half.sin());
///     }
///     Motion::read(text.as_bytes(), &Options::default())
/// };
/// let records = [("one".into(), record(0.0)?), ("turned".into(), record(std::f64::consts::FRAC_PI_2)?)];
/// let found = compare(&records, None)?;
/// assert!(found.others.is_empty() && found.alike[1].1.rows == 100);
/// # Ok::<(), tumbling_judge::Error>(())
/// ```
///
/// # Errors
/// No record, two with fewer than two times in common, a threshold that is no number above zero.
pub fn compare(records: &[(String, Motion)], threshold: Option<f64>) -> Result<Comparison, Error> {
    if let Some(value) = threshold.filter(|most| most.is_nan() || *most <= 0.0) {
        return Err(Error::Threshold { law: None, value });
    }
    let wrong = |problem: String| Error::Compared { problem };
    let mut best: Option<(usize, Vec<Apart>)> = None;
    let count = |all: &[Apart]| all.iter().filter(|apart| apart.is_alike()).count();
    for (k, (name, one)) in records.iter().enumerate() {
        let apart = |(other, motion): &(String, Motion)| {
            one.to(motion, threshold)
                .ok_or_else(|| wrong(format!("{name} and {other} have fewer than two times in common")))
        };
        let all = records.iter().map(apart).collect::<Result<Vec<_>, _>>()?;
        if best.as_ref().is_none_or(|(_, best)| count(&all) > count(best)) {
            best = Some((k, all));
        }
    }
    let (reference, all) = best.ok_or_else(|| wrong("there is no record".into()))?;
    let (alike, others): (Vec<_>, Vec<_>) = all.into_iter().enumerate().partition(|x| x.1.is_alike());
    let inertia =
        if others.is_empty() { Vec::new() } else { records.iter().map(|(_, one)| one.inertia()).collect() };
    let names = records.iter().map(|(name, _)| name.clone()).collect();
    Ok(Comparison { names, reference, alike, others, inertia, start: records[reference].1.rows[0].t })
}

impl Comparison {
    /// All of it as one JSON object: `version` (of its keys), `outcome` (passed if all are one motion), the
    /// name of the `reference`, and of each of `alike` and `others` the `name`, the `rows` in common, and for
    /// `spin`, `attitude` and `position` the largest distance from the reference, its limit and the time
    /// since when it is more (s; null where it never is); the `origin` in the reference's axes where there
    /// are positions. `report` is all of it in words.
    #[must_use]
    pub fn json(&self) -> Value {
        let off = |off: &Off| json!({ "most": off.most, "limit": off.limit, "since": off.since });
        let each = |all: &[(usize, Apart)]| {
            let one = |(k, apart): &(usize, Apart)| {
                let [spin, attitude, position] = apart.off.each_ref().map(off);
                json!({
                    "name": self.names[*k], "rows": apart.rows, "spin": spin, "attitude": attitude,
                    "position": apart.origin.map(|_| position), "origin": apart.origin.map(<[f64; 3]>::from),
                })
            };
            all.iter().map(one).collect::<Vec<_>>()
        };
        let outcome = if self.others.is_empty() { Outcome::Passed } else { Outcome::Failed };
        json!({
            "version": VERSION, "outcome": outcome.key(), "reference": self.names[self.reference],
            "alike": each(&self.alike), "others": each(&self.others),
            "report": self.to_string().lines().collect::<Vec<_>>(),
        })
    }

    fn why(&self, f: &mut fmt::Formatter<'_>, k: usize, apart: &Apart) -> fmt::Result {
        let far = "of the greatest distance from the start";
        let parts = [["spin", "of the fastest"], ["attitude", "rad"], ["position", far]];
        for (off, [part, unit]) in apart.off.iter().zip(parts) {
            if let Some(since) = off.since {
                let [most, limit] = [off.most, off.limit].map(plain_number);
                writeln!(
                    f,
                    "  the {part} is off by up to {most} {unit}, and by more than {limit} from {since:.4} s on."
                )?;
            }
        }
        let [spin, attitude, position] = apart.off.map(|off| off.since);
        let turns = spin.or(attitude);
        let words = match (turns, position) {
            (Some(t), _) if t == self.start => {
                "It starts differently: compare the first rows, and judge the file alone to find a mistake in it."
            }
            (Some(_), _) => {
                "It starts the same: check the tensor, its axes, the parts that make it up, and the engine's settings."
            }
            (None, Some(_)) => {
                "It turns the same: check the centre of mass and the velocity at the start. A first-order step has an error \
                 of its own if the origin is off the centre."
            }
            _ => "",
        };
        writeln!(f, "  {words}")?;
        let tensors = self.tensors(self.reference, k).filter(|_| turns.is_some_and(|t| t > self.start));
        tensors.map_or(Ok(()), |words| writeln!(f, "  {words}"))
    }

    /// How the moments and axes that two records' spins fit differ.
    fn tensors(&self, one: usize, other: usize) -> Option<String> {
        let [a, b] = [one, other].map(|k| self.inertia.get(k).copied().flatten());
        let (a, b) = (a?, b?);
        let ratio =
            |x: &FittedInertia| (x.moments / x.moments.x).map(|x| format!("{x:.4}")).as_slice().join(" : ");
        let degrees = turn_of_axes(&a.axes, &b.axes).to_degrees();
        let turned =
            a.alike.or(b.alike).map_or(format!(", about axes turned by {degrees:.1}°"), |_| String::new());
        Some(format!("Its spins fit moments {}{turned}; those of the others fit {}.", ratio(&b), ratio(&a)))
    }
}

/// The smallest turn that takes one set of axes to another, rad: an axis has no sense, but both sets are
/// right-handed.
fn turn_of_axes(a: &Matrix3<f64>, b: &Matrix3<f64>) -> f64 {
    let cosines = (a.transpose() * b).diagonal();
    let mirrored = cosines.product() < 0.0;
    let trace = cosines.abs().sum() - if mirrored { 2.0 * cosines.abs().min() } else { 0.0 };
    ((trace - 1.0) / 2.0).clamp(-1.0, 1.0).acos()
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |k: usize| self.names[k].as_str();
        let most = |i: usize| self.alike.iter().map(|(_, apart)| apart.off[i].most).fold(0.0, f64::max);
        let rows = self.alike.iter().chain(&self.others).map(|(_, apart)| apart.rows).min().unwrap_or(0);
        match self.alike[..] {
            [_] => writeln!(f, "FAILED: no two of these are one motion. Against {}:", name(self.reference))?,
            _ => {
                let grade = if self.others.is_empty() { "PASSED" } else { "FAILED" };
                let alike = self.alike.iter().map(|(k, _)| name(*k)).collect::<Vec<_>>().join(", ");
                let [spin, attitude] = [most(0), most(1)].map(plain_number);
                writeln!(
                    f,
                    "{grade}: {alike} are one motion, within {spin} of the spin and {attitude} rad, at {rows} common times."
                )?;
                writeln!(f, "To see whether that motion is right, judge one of these files alone.")?;
            }
        }
        for (k, apart) in &self.alike {
            if let Some(origin) = apart.origin {
                // To eight places: less is rounding.
                let [x, y, z]: [f64; 3] = origin.map(|x| (x * 1e8).round() / 1e8 + 0.0).into();
                let left = plain_number(apart.off[2].most);
                writeln!(
                    f,
                    "{}: its origin is at {x}, {y}, {z} in the axes of {}, within {left} of the greatest distance from the start.",
                    name(*k),
                    name(self.reference)
                )?;
            }
        }
        for (k, apart) in &self.others {
            writeln!(f, "{} is another motion:", name(*k))?;
            self.why(f, *k, apart)?;
        }
        Ok(())
    }
}
