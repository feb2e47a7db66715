//! Which column is what, from their names.

use crate::error::Error;
use crate::read::comment::{per_second, spin_unit};

/// The meaning of a row's numbers: the index of each among the fields.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Columns {
    pub names: Vec<String>,
    pub separator: Separator,
    pub clock: TimeColumn,
    /// w, x, y, z.
    pub attitude: Option<[usize; 4]>,
    /// None where attitudes are all there is.
    pub vector: Option<[usize; 3]>,
    /// Of the body's origin in the world, where positions are asked for.
    pub position: Option<[usize; 3]>,
    pub kind: Kind,
    /// The factor from the unit in the spin's names to rad/s.
    pub unit: f64,
    /// The number of the time column's units in a second.
    pub per_second: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Separator {
    One(char),
    Blanks,
}

/// The source of a row's time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TimeColumn {
    /// Seconds.
    Time(usize),
    /// A count of steps.
    Steps(usize),
    /// Nothing: each row is one step.
    Rows,
}

impl TimeColumn {
    /// Its place among the fields, if it has one.
    pub(crate) const fn place(self) -> Option<usize> {
        match self {
            Self::Time(i) | Self::Steps(i) => Some(i),
            Self::Rows => None,
        }
    }
}

/// The meaning of a row's three numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Kind {
    /// The spin in body axes, rad/s.
    #[default]
    SpinBody,
    /// The spin in world axes, rad/s.
    SpinWorld,
    /// The momentum in body axes, kg m²/s.
    MomentumBody,
    /// The momentum in world axes, kg m²/s.
    MomentumWorld,
    /// Nothing: the record has attitudes alone.
    Attitude,
}

impl Kind {
    pub(crate) const fn in_world(self) -> bool {
        matches!(self, Self::SpinWorld | Self::MomentumWorld)
    }

    pub(crate) const fn is_momentum(self) -> bool {
        matches!(self, Self::MomentumBody | Self::MomentumWorld)
    }
}

impl Separator {
    fn of(line: &str) -> Self {
        [';', '\t', ','].into_iter().find(|&c| line.contains(c)).map_or(Self::Blanks, Self::One)
    }

    /// The fields of a line, without the blanks and quotes around them.
    pub(crate) fn split(self, line: &str) -> impl Iterator<Item = &str> {
        let (is_one, blanks) = (move |c: char| Self::One(c) == self, self == Self::Blanks);
        let fields = line.split(move |c: char| if blanks { c.is_whitespace() } else { is_one(c) });
        let surrounds = |c: char| c.is_whitespace() || c == '"';
        let trimmed = fields.map(move |field| field.trim_matches(surrounds));
        trimmed.filter(move |field| !blanks || !field.is_empty())
    }
}

/// A name without quotes, unit, underscores and capitals; and its unit.
fn plain(name: &str) -> (String, String) {
    let name = name.trim_matches(|c: char| c == '\'' || c.is_whitespace()).to_ascii_lowercase();
    let (name, unit) = match name.find(['[', '(']) {
        Some(at) => name.split_at(at),
        None => (name.as_str(), ""),
    };
    let letters = name.chars().filter(|c| c.is_alphanumeric()).collect();
    (letters, unit.trim_matches(|c: char| "[]() ".contains(c)).to_string())
}

/// The time, with its unit behind it or without.
const TIME: [&str; 5] = ["timestamp", "simtime", "time", "t", "seconds"];
const UNITS: [&str; 7] = ["", "s", "sec", "seconds", "ms", "us", "ns"];
const STEPS: [&str; 2] = ["step", "frame"];
/// Before the letter of the axis.
const ATTITUDE: [&str; 3] = ["q", "quat", "quaternion"];
/// Before it, where a part of the names alone means nothing (three of `rot` may be angles).
const ATTITUDE_WHOLE: [&str; 6] = ["orientation", "rot", "rotation", "attitude", "att", "ori"];
/// Four names that are no letters of axes: the scalar first.
const ATTITUDE_NAMES: [[&str; 4]; 4] = [
    ["q0", "q1", "q2", "q3"],
    ["qw", "qi", "qj", "qk"],
    ["qr", "qi", "qj", "qk"],
    ["quat0", "quat1", "quat2", "quat3"],
];
/// Before and after the letter of the axis.
const VECTORS: [(Kind, &str); 4] = [
    (
        Kind::SpinBody,
        "w* w*b w*body wbody* omega* omega*body omegabody* angvel* angvel*body angvelbody* angularvelocity* \
         angularvelocity*body angularvelocitybody*",
    ),
    (
        Kind::SpinWorld,
        "w*w w*world wworld* omega*world omega*w omegaworld* angvel*world angvelworld* angularvelocity*world \
         angularvelocityworld*",
    ),
    (Kind::MomentumBody, "l* l*b l*body"),
    (Kind::MomentumWorld, "l*w l*world"),
];
/// Before the letter of the axis.
const POSITIONS: [&str; 4] = ["", "p", "pos", "position"];
/// Three names of a spin that have no axes' letters.
const SPIN_NAMES: [&str; 3] = ["p", "q", "r"];

/// The unit behind the name of a time.
fn unit_of_time(name: &str) -> Option<&str> {
    TIME.iter().find_map(|time| name.strip_prefix(time)).filter(|unit| UNITS.contains(unit))
}

/// The line of names, and what is found in it.
struct Names {
    line: usize,
    /// As they stand.
    raw: Vec<String>,
    /// Without quotes and capitals, each with its unit.
    plain: Vec<(String, String)>,
}

const KNOWN: &str = "known are t or step; qw,qx,qy,qz; wx,wy,wz (spin in body axes) or wxw,wyw,wzw (in world axes); \
     lx,ly,lz (momentum in body axes) or lxw,lyw,lzw (in world axes)";

impl Names {
    fn of(separator: Separator, text: &str, line: usize) -> Result<Self, Error> {
        let mut raw: Vec<String> = separator.split(text).map(str::to_string).collect();
        // A separator at the end of the line.
        if raw.len() > 1 && raw.last().is_some_and(String::is_empty) {
            raw.pop();
        }
        let plain = raw.iter().map(|name| plain(name)).collect();
        let names = Self { line, raw, plain };
        if names.plain.iter().any(|(name, _)| name.parse::<f64>().is_ok()) {
            let problem = format!("this must be the line of column names, and it has a number; {KNOWN}");
            return Err(names.wrong(problem));
        }
        Ok(names)
    }

    fn wrong(&self, problem: String) -> Error {
        Error::Line { line: self.line, problem }
    }

    fn at(&self, wanted: &str) -> Result<Option<usize>, Error> {
        let mut found = self.plain.iter().enumerate().filter(|(_, (name, _))| name == wanted);
        let first = found.next().map(|(i, _)| i);
        match found.next() {
            Some(_) => Err(self.wrong(format!("there are two columns `{wanted}`"))),
            None => Ok(first),
        }
    }

    /// The one there is of these.
    fn any(&self, is_one: impl Fn(&str) -> bool) -> Result<Option<usize>, Error> {
        let found: Vec<usize> = (0..self.raw.len()).filter(|i| is_one(&self.plain[*i].0)).collect();
        match found[..] {
            [a, b, ..] => {
                Err(self.wrong(format!("`{}` and `{}` both are the time", self.raw[a], self.raw[b])))
            }
            _ => Ok(found.first().copied()),
        }
    }

    /// All of these, or nothing.
    fn all(&self, wanted: &[&str]) -> Result<Option<Vec<usize>>, Error> {
        let places = wanted.iter().map(|name| self.at(name)).collect::<Result<Vec<_>, _>>()?;
        Ok(places.into_iter().collect())
    }

    /// All, none, or an error that names what is missing.
    fn whole(&self, prefix: &str, axes: &[&str], suffix: &str) -> Result<Option<Vec<usize>>, Error> {
        let wanted: Vec<String> = axes.iter().map(|axis| format!("{prefix}{axis}{suffix}")).collect();
        let places = wanted.iter().map(|name| self.at(name)).collect::<Result<Vec<_>, _>>()?;
        match places.iter().position(Option::is_none) {
            Some(missing) if places.iter().any(Option::is_some) => {
                Err(self.wrong(format!("the column `{}` is missing", wanted[missing])))
            }
            _ => Ok(places.into_iter().collect()),
        }
    }

    /// The time; `step` says whether the header has the length of a step.
    fn clock(&self, step: bool) -> Result<TimeColumn, Error> {
        match (self.any(|name| unit_of_time(name).is_some())?, self.any(|name| STEPS.contains(&name))?) {
            (Some(i), _) => Ok(TimeColumn::Time(i)),
            (None, Some(i)) => Ok(TimeColumn::Steps(i)),
            (None, None) if step => Ok(TimeColumn::Rows),
            (None, None) => Err(self.wrong(format!(
                "the column `t` is missing: add it, or a comment line `# dt: 1/60` with the time from row to row; {KNOWN}"
            ))),
        }
    }

    fn attitude(&self) -> Result<Option<[usize; 4]>, Error> {
        let mut sets = Vec::new();
        for prefix in ATTITUDE.into_iter().chain(ATTITUDE_WHOLE) {
            let other = prefix == "q" && self.at("qx")?.is_none() && self.all(&ATTITUDE_NAMES[1])?.is_some();
            let is_none = ATTITUDE_WHOLE.contains(&prefix) && self.at(&format!("{prefix}w"))?.is_none();
            if !other && !is_none {
                sets.extend(self.whole(prefix, &["w", "x", "y", "z"], "")?);
            }
        }
        for names in ATTITUDE_NAMES {
            sets.extend(self.all(&names)?);
        }
        match &sets[..] {
            [_, _, ..] => Err(self.wrong("there are two sets of columns for the attitude".into())),
            sets => Ok(sets.first().and_then(|places| places.as_slice().try_into().ok())),
        }
    }

    /// The vector that is judged: the first kind there is.
    fn vector(&self) -> Result<Option<(Kind, [usize; 3])>, Error> {
        for (kind, ways) in VECTORS {
            let mut sets = Vec::new();
            for (prefix, suffix) in ways.split(' ').filter_map(|way| way.split_once('*')) {
                sets.extend(self.whole(prefix, &["x", "y", "z"], suffix)?);
            }
            if let [_, other, ..] = &sets[..] {
                let name = &self.raw[other[0]];
                let problem = format!("there are two sets of columns for one vector, `{name}` among them");
                return Err(self.wrong(problem));
            }
            if let Some(places) = sets.first() {
                return Ok(places.as_slice().try_into().ok().map(|places| (kind, places)));
            }
        }
        let places = self.all(&SPIN_NAMES)?.and_then(|places| <[usize; 3]>::try_from(places).ok());
        Ok(places.map(|places| (Kind::SpinBody, places)))
    }

    /// One unit for the three of them, and one that is known.
    fn unit_of(&self, kind: Kind, places: &[usize; 3]) -> Result<f64, Error> {
        let [first, others @ ..] = places.map(|i| self.plain[i].1.as_str());
        let name = &self.raw[places[0]];
        if let Some(k) = others.iter().position(|unit| *unit != first) {
            let other = &self.raw[places[k + 1]];
            let problem = format!("`{other}` is not in the unit of `{name}`: the three must have one unit");
            return Err(self.wrong(problem));
        }
        if kind.is_momentum() {
            return Ok(1.0);
        }
        spin_unit(first).ok_or_else(|| self.unknown(places[0], "rad/s, deg/s, dps, rpm and rev/s"))
    }

    fn unknown(&self, i: usize, known: &str) -> Error {
        self.wrong(format!("the unit of `{}` is not known here: known are {known}", self.raw[i]))
    }

    fn per_second(&self, clock: TimeColumn) -> Result<f64, Error> {
        let TimeColumn::Time(i) = clock else { return Ok(1.0) };
        let (name, unit) = &self.plain[i];
        let by_name = unit_of_time(name).unwrap_or_default();
        let unit = if unit.is_empty() { by_name } else { unit };
        per_second(unit).ok_or_else(|| self.unknown(i, "s, ms, us, ns and min"))
    }
}

impl Columns {
    /// From the line of names; `step` says whether the header has the length of a step.
    pub(crate) fn of(line: &str, number: usize, step: bool) -> Result<Self, Error> {
        let separator = Separator::of(line);
        let names = Names::of(separator, line, number)?;
        let clock = names.clock(step)?;
        let attitude = names.attitude()?;
        let (kind, vector) = match names.vector()? {
            Some((kind, places)) => (kind, Some(places)),
            None if attitude.is_some() => (Kind::Attitude, None),
            None => {
                let why = format!("there is neither spin nor momentum nor attitude to judge; {KNOWN}");
                return Err(names.wrong(why));
            }
        };
        if kind.in_world() && attitude.is_none() {
            return Err(names.wrong(
                "a vector in world axes cannot be used without its attitude: qw,qx,qy,qz are missing".into(),
            ));
        }
        let unit = vector.map_or(Ok(1.0), |places| names.unit_of(kind, &places))?;
        let per_second = names.per_second(clock)?;
        let position = None;
        Ok(Self { names: names.raw, separator, clock, attitude, vector, position, kind, unit, per_second })
    }

    /// Reads positions too, where there are any.
    pub(crate) fn take_positions(&mut self) {
        let plain: Vec<String> = self.names.iter().map(|name| plain(name).0).collect();
        let at = |prefix: &str| {
            let at = |axis: &str| plain.iter().position(|name| *name == format!("{prefix}{axis}"));
            Some([at("x")?, at("y")?, at("z")?])
        };
        self.position = POSITIONS.iter().find_map(|prefix| at(prefix));
    }

    /// The names of the columns that are not read.
    pub(crate) fn ignored(&self) -> Vec<String> {
        let names = self.names.iter().enumerate();
        names.filter(|(i, _)| !self.reads(*i)).map(|(_, name)| name.clone()).collect()
    }

    /// Whether a column is read.
    pub(crate) fn reads(&self, i: usize) -> bool {
        self.clock.place() == Some(i)
            || self.attitude.is_some_and(|places| places.contains(&i))
            || self.vector.is_some_and(|places| places.contains(&i))
            || self.position.is_some_and(|places| places.contains(&i))
    }
}
