//! Whether several records are one motion: one object, described to its engine in several ways.
//!
//! The turn since the start and the spin are compared in world axes, so that it does not matter how the axes
//! of a description lie in the body; of the positions, that they are of two points of one body.

use crate::error::Error;
use crate::gyroscope::{FittedInertia, fit_inertia};
use crate::options::Options;
use crate::read::{Kind, Reading, Rows, angle_between, in_world, rounding};
use crate::thresholds::PROBE_ROWS;
use crate::verdict::plain_number;
use nalgebra::{Matrix3x6, Matrix6, Quaternion, Vector3, Vector6};
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
        let kind = rows.columns.kind;
        let given = options.inertia.or_else(|| rows.header.moments(&mut Vec::new()));
        let moments =
            given.or((!kind.is_momentum()).then(|| Vector3::repeat(1.0))).ok_or(Error::NoMoments)?;
        let (reading, mut all, mut raws) = (Reading::plain(kind), Vec::new(), Vec::new());
        while let Some(raw) = rows.advance()? {
            let row = reading.state(&raw, &moments);
            let length = row.attitude.map_or(0.0, |q| q.norm());
            if length == 0.0 || !length.is_finite() {
                let problem = "records are compared by their attitudes: there is none here".into();
                return Err(Error::Line { line: raw.line, problem });
            }
            let attitude = row.start() / length;
            let spin = [row.omega, in_world(&attitude, &row.omega)];
            all.push(Instant { t: row.t, attitude, spin, position: raw.position });
            if raws.len() < PROBE_ROWS {
                raws.push(raw);
            }
        }
        if let Some(ended) = rows.ended.take() {
            return Err(ended);
        }
        if all.len() < 2 {
            return Err(if all.is_empty() { Error::NoRows } else { Error::OneRow });
        }
        let has = [kind != Kind::Attitude, rows.columns.position.is_some()];
        Ok(Self { rows: all, rounding: rounding(&raws), has })
    }

    /// How far `other` is from this motion.
    fn to(&self, other: &Self) -> Result<[Off; 3], Error> {
        let fastest = self.rows.iter().map(|row| row.spin[1].norm()).fold(f64::MIN_POSITIVE, f64::max);
        // Rounding adds up over many steps: a third of the digits of the record that has fewer of them.
        let limit = self.rounding.max(other.rounding).cbrt();
        let both = [0, 1].map(|i| self.has[i] && other.has[i]);
        let (a, b) = (&self.rows[0], &other.rows[0]);
        let mut off = [Off { limit, ..Off::default() }; 3];
        for (row, (here, there)) in self.rows.iter().zip(&other.rows).enumerate() {
            if (here.t - there.t).abs() > limit * (here.t - a.t).abs().max(self.rows[1].t - a.t) {
                let problem = format!("its time is {} s, and {} s in another record", there.t, here.t);
                return Err(Error::Row { row: row + 1, problem });
            }
            let [turn, turned] =
                [(here, a), (there, b)].map(|(q, start)| product(&q.attitude, &start.attitude.conjugate()));
            off[1].take(here.t, angle_between(&turn, &turned));
            if both[0] {
                off[0].take(here.t, (here.spin[1] - there.spin[1]).norm() / fastest);
            }
        }
        let [few, many] = [self.rows.len().min(other.rows.len()), self.rows.len().max(other.rows.len())];
        if few < many {
            let problem = format!("one record ends before it, and another has {many} rows");
            return Err(Error::Row { row: few + 1, problem });
        }
        if both[1] {
            let way = self
                .rows
                .iter()
                .map(|row| (row.position - a.position).norm())
                .fold(f64::MIN_POSITIVE, f64::max);
            let left = self.left_of_positions(other);
            self.rows.iter().zip(left).for_each(|(row, left)| off[2].take(row.t, left / way));
        }
        Ok(off)
    }

    /// What is left of the distance between the two positions, without that of two points of one body, and
    /// without that of two places where it stands: a vector fixed in the body, and one in the world.
    fn left_of_positions(&self, other: &Self) -> Vec<f64> {
        let apart = || {
            self.rows.iter().zip(&other.rows).map(|(a, b)| {
                let mut along = Matrix3x6::identity();
                along.fixed_columns_mut::<3>(3).copy_from(&rotation_matrix(&a.attitude));
                (along, a.position - b.position)
            })
        };
        let normal: Matrix6<f64> = apart().map(|(along, _)| along.tr_mul(&along)).sum();
        let sum: Vector6<f64> = apart().map(|(along, apart)| along.tr_mul(&apart)).sum();
        let best = normal
            .pseudo_inverse(1e-12 * normal.amax())
            .map_or_else(|_| Vector6::zeros(), |inverse| inverse * sum);
        apart().map(|(along, apart)| (apart - along * best).norm()).collect()
    }

    /// What its spins say of the moments, with the axes in the world at the start.
    fn inertia(&self) -> Option<FittedInertia> {
        let rows: Vec<_> = self.rows.iter().map(|row| (row.t, row.spin[0])).collect();
        let fitted = fit_inertia(&rows, None).ok().filter(|_| self.has[0])?;
        let start = rotation_matrix(&self.rows[0].attitude);
        Some(FittedInertia { axes: start * fitted.axes, ..fitted })
    }
}

/// How far two motions are apart: of the spin as a share of the fastest, of the attitude in rad, of the
/// position as a share of the way.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Off {
    /// At most.
    pub most: f64,
    /// Up to which they are alike.
    pub limit: f64,
    /// When it is first more than that, s.
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

/// What became of records that should be one motion.
#[derive(Debug, Clone)]
pub struct Comparison {
    names: Vec<String>,
    /// Those that are one motion, the most there are.
    pub alike: Vec<usize>,
    /// Each of the others, and how far spin, attitude and position are from that motion.
    pub others: Vec<(usize, [Off; 3])>,
    most: [Off; 3],
    inertia: Vec<Option<FittedInertia>>,
    start: f64,
}

/// Compares records of one object, each with its name.
///
/// # Errors
/// Fewer than two records, or records of other times.
pub fn compare(records: &[(String, Motion)]) -> Result<Comparison, Error> {
    let mut best: Option<Vec<[Off; 3]>> = None;
    let count = |all: &[[Off; 3]]| all.iter().filter(|off| is_alike(off)).count();
    for (_, one) in records {
        let all = records.iter().map(|(_, other)| one.to(other)).collect::<Result<Vec<_>, _>>()?;
        if best.as_ref().is_none_or(|best| count(&all) > count(best)) {
            best = Some(all);
        }
    }
    let (Some(all), Some((_, first))) = (best, records.first()) else { return Err(Error::Empty) };
    let (alike, others): (Vec<_>, Vec<_>) = all.into_iter().enumerate().partition(|(_, off)| is_alike(off));
    let most = alike.iter().fold([Off::default(); 3], |mut most, (_, off)| {
        most.iter_mut().zip(off).for_each(|(most, off)| most.most = most.most.max(off.most));
        most
    });
    let inertia =
        if others.is_empty() { Vec::new() } else { records.iter().map(|(_, one)| one.inertia()).collect() };
    let names = records.iter().map(|(name, _)| name.clone()).collect();
    let alike = alike.into_iter().map(|(k, _)| k).collect();
    Ok(Comparison { names, alike, others, most, inertia, start: first.rows[0].t })
}

fn is_alike(off: &[Off; 3]) -> bool {
    off.iter().all(|off| off.since.is_none())
}

impl Comparison {
    /// How the moments and axes that two records' spins fit differ.
    fn tensors(&self, one: usize, other: usize) -> Option<String> {
        let [a, b] = [one, other].map(|k| self.inertia.get(k).copied().flatten());
        let (a, b) = (a?, b?);
        let cosine = (0..3).map(|i| a.axes.column(i).dot(&b.axes.column(i)).abs()).fold(1.0, f64::min);
        let ratio =
            |x: &FittedInertia| (x.moments / x.moments.x).map(|x| format!("{x:.4}")).as_slice().join(" : ");
        let turned = match (a.alike, b.alike) {
            (None, None) => {
                format!(", about axes turned by up to {:.1}°", cosine.min(1.0).acos().to_degrees())
            }
            _ => String::new(),
        };
        Some(format!("Its spins are those of moments {}{turned}; the others' of {}.", ratio(&b), ratio(&a)))
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [spin, attitude, position] = self.most.map(|off| plain_number(off.most));
        match self.alike[..] {
            [one] => writeln!(f, "FAILED: no two of these are one motion. Against {}:", self.names[one])?,
            _ => {
                let grade = if self.others.is_empty() { "PASSED" } else { "FAILED" };
                let alike = self.alike.iter().map(|k| self.names[*k].as_str()).collect::<Vec<_>>().join(", ");
                writeln!(
                    f,
                    "{grade}: {alike} are one motion, to {spin} of the spin, {attitude} rad, and {position} of the way."
                )?;
            }
        }
        for (k, off) in &self.others {
            writeln!(f, "{} is another motion:", self.names[*k])?;
            let words =
                ["the spin is off by up to", "the attitude is off by up to", "the position is off by up to"];
            for ((off, words), unit) in off.iter().zip(words).zip(["of the fastest", "rad", "of the way"]) {
                if let Some(since) = off.since {
                    let [most, limit] = [off.most, off.limit].map(plain_number);
                    writeln!(f, "  {words} {most} {unit}, and by more than {limit} from {since:.4} s on.")?;
                }
            }
            let [spin, attitude, position] = off.map(|off| off.since);
            let why = match (spin.or(attitude), position) {
                (Some(t), _) if t == self.start => "It starts otherwise: compare the first rows.",
                (Some(_), _) => {
                    "It starts alike: look at the tensor, its axes, and the parts that make it up."
                }
                (None, Some(_)) => {
                    "It turns alike: look at the centre of mass and at the velocity at the start. A step of first order errs by itself where \
                     the origin is off the centre."
                }
                _ => "",
            };
            writeln!(f, "  {why}")?;
            if let Some(words) = self.tensors(self.alike[0], *k).filter(|_| spin.or(attitude).is_some()) {
                writeln!(f, "  {words}")?;
            }
        }
        Ok(())
    }
}
