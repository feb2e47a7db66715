//! Which column is what, from their names.

use crate::error::Error;
use crate::units;

/// What the numbers of a row stand for: at which place each stands among the fields.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Columns {
    pub names: Vec<String>,
    pub separator: Separator,
    pub clock: Clock,
    /// w, x, y, z.
    pub attitude: Option<[usize; 4]>,
    /// None where attitudes are all there is.
    pub vector: Option<[usize; 3]>,
    pub kind: Kind,
    /// Another vector, beside the one that is judged.
    pub second: Option<(Kind, [usize; 3])>,
    /// What a spin is to be multiplied by for rad/s, by the unit in its names; and the second vector's.
    pub units: [f64; 2],
    /// How many of the unit of the time column are a second.
    pub per_second: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Separator {
    One(char),
    Blanks,
}

/// What tells the time of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Clock {
    /// Seconds.
    Time(usize),
    /// A count of steps.
    Steps(usize),
}

/// What the three numbers are that move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    SpinBody,
    SpinWorld,
    MomentumBody,
    MomentumWorld,
    /// None: attitudes alone.
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

    pub(crate) fn split(self, line: &str) -> Fields<'_> {
        Fields { rest: Some(line), separator: self }
    }
}

/// The fields of a line, without the blanks around them.
pub(crate) struct Fields<'a> {
    rest: Option<&'a str>,
    separator: Separator,
}

impl<'a> Iterator for Fields<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let rest = self.rest?;
        let (field, left) = match self.separator {
            Separator::One(c) => match rest.split_once(c) {
                Some((field, left)) => (field, Some(left)),
                None => (rest, None),
            },
            Separator::Blanks => {
                let rest = rest.trim_start();
                match rest.split_once(char::is_whitespace) {
                    Some((field, left)) => (field, Some(left.trim_start()).filter(|left| !left.is_empty())),
                    None => (rest, None),
                }
            }
        };
        self.rest = left;
        Some(field.trim())
    }
}

/// A name without quotes, unit, underscores and capitals; and its unit.
fn plain(name: &str) -> (String, String) {
    let name = name.trim_matches(|c: char| c == '"' || c == '\'' || c.is_whitespace()).to_lowercase();
    let (name, unit) = match name.find(['[', '(']) {
        Some(at) => name.split_at(at),
        None => (name.as_str(), ""),
    };
    let letters = name.chars().filter(|c| c.is_alphanumeric()).collect();
    (letters, unit.trim_matches(|c: char| "[]() ".contains(c)).to_string())
}

const TIME: [&str; 10] =
    ["t", "time", "seconds", "timestamp", "ts", "tsec", "times", "timesec", "timeseconds", "simtime"];
/// Names of the time that tell its unit.
const TIME_IN: [(&str, &str); 6] = [
    ("tms", "ms"),
    ("timems", "ms"),
    ("timestampms", "ms"),
    ("timeus", "us"),
    ("timens", "ns"),
    ("timestampns", "ns"),
];
const STEPS: [&str; 2] = ["step", "frame"];
/// Before and after the letter of the axis.
const ATTITUDE: [(&str, &str); 3] = [("q", ""), ("quat", ""), ("quaternion", "")];
/// The same, where a part of the names alone means nothing (three of `rot` may be angles).
const ATTITUDE_WHOLE: [(&str, &str); 6] =
    [("orientation", ""), ("rot", ""), ("rotation", ""), ("attitude", ""), ("att", ""), ("ori", "")];
/// Four names that are no letters of axes: the scalar first.
const ATTITUDE_NAMES: [[&str; 4]; 4] = [
    ["q0", "q1", "q2", "q3"],
    ["qw", "qi", "qj", "qk"],
    ["qr", "qi", "qj", "qk"],
    ["quat0", "quat1", "quat2", "quat3"],
];
const VECTORS: [(Kind, &[(&str, &str)]); 4] = [
    (
        Kind::SpinBody,
        &[
            ("w", ""),
            ("w", "b"),
            ("w", "body"),
            ("wbody", ""),
            ("omega", ""),
            ("omega", "body"),
            ("omegabody", ""),
            ("angvel", ""),
            ("angvel", "body"),
            ("angvelbody", ""),
            ("angularvelocity", ""),
            ("angularvelocity", "body"),
            ("angularvelocitybody", ""),
        ],
    ),
    (
        Kind::SpinWorld,
        &[
            ("w", "w"),
            ("w", "world"),
            ("wworld", ""),
            ("omega", "world"),
            ("omega", "w"),
            ("omegaworld", ""),
            ("angvel", "world"),
            ("angvelworld", ""),
            ("angularvelocity", "world"),
            ("angularvelocityworld", ""),
        ],
    ),
    (Kind::MomentumBody, &[("l", ""), ("l", "b"), ("l", "body")]),
    (Kind::MomentumWorld, &[("l", "w"), ("l", "world")]),
];
/// Three names of a spin that have no axes' letters.
const SPIN_NAMES: [&str; 3] = ["p", "q", "r"];

impl Columns {
    /// From the line of names.
    pub(crate) fn of(line: &str, number: usize) -> Result<Self, Error> {
        let wrong = |problem: String| Error::Columns { line: number, problem };
        let separator = Separator::of(line);
        let mut names: Vec<String> = separator.split(line).map(str::to_string).collect();
        // A separator at the end of the line.
        if names.len() > 1 && names.last().is_some_and(String::is_empty) {
            names.pop();
        }
        let plain: Vec<(String, String)> = names.iter().map(|name| plain(name)).collect();
        let known = "known are t or step; qw,qx,qy,qz; wx,wy,wz (spin in body axes) or wxw,wyw,wzw (in world axes); \
                     lx,ly,lz (momentum in body axes) or lxw,lyw,lzw (in world axes)";
        if plain.iter().any(|(name, _)| name.parse::<f64>().is_ok()) {
            return Err(wrong(format!("column names are wanted here, and there is a number; {known}")));
        }
        let at = |wanted: &str| -> Result<Option<usize>, Error> {
            let mut found = plain.iter().enumerate().filter(|(_, (name, _))| name == wanted);
            let first = found.next().map(|(i, _)| i);
            match found.next() {
                Some(_) => Err(wrong(format!("there are two columns `{wanted}`"))),
                None => Ok(first),
            }
        };
        let any = |wanted: &[&str]| -> Result<Option<usize>, Error> {
            let mut found = None;
            for name in wanted {
                if let Some(i) = at(name)? {
                    if let Some(before) = found {
                        let before: &String = &names[before];
                        return Err(wrong(format!("`{before}` and `{}` both tell the time", names[i])));
                    }
                    found = Some(i);
                }
            }
            Ok(found)
        };
        // All, none, or an error that names what is missing.
        let whole = |prefix: &str, axes: &[&str], suffix: &str| -> Result<Option<Vec<usize>>, Error> {
            let wanted: Vec<String> = axes.iter().map(|axis| format!("{prefix}{axis}{suffix}")).collect();
            let places = wanted.iter().map(|name| at(name)).collect::<Result<Vec<_>, _>>()?;
            if places.iter().all(Option::is_none) {
                return Ok(None);
            }
            if let Some(missing) = places.iter().position(Option::is_none) {
                return Err(wrong(format!("the column `{}` is missing", wanted[missing])));
            }
            Ok(Some(places.into_iter().flatten().collect()))
        };
        let all = |wanted: &[&str]| -> Result<Option<Vec<usize>>, Error> {
            let places = wanted.iter().map(|name| at(name)).collect::<Result<Vec<_>, _>>()?;
            Ok(places.into_iter().collect())
        };
        let times: Vec<&str> = TIME.into_iter().chain(TIME_IN.map(|name| name.0)).collect();
        let clock = match (any(&times)?, any(&STEPS)?) {
            (Some(i), _) => Clock::Time(i),
            (None, Some(i)) => Clock::Steps(i),
            (None, None) => return Err(wrong(format!("the column `t` is missing; {known}"))),
        };
        let mut attitude = None;
        let mut sets = Vec::new();
        let other = |names: &[&str; 4]| -> Result<bool, Error> { Ok(all(names)?.is_some()) };
        for (prefix, suffix) in ATTITUDE {
            let replaced = prefix == "q" && at("qx")?.is_none() && other(&ATTITUDE_NAMES[1])?;
            if !replaced {
                sets.extend(whole(prefix, &["w", "x", "y", "z"], suffix)?);
            }
        }
        for (prefix, suffix) in ATTITUDE_WHOLE {
            if at(&format!("{prefix}w{suffix}"))?.is_some() {
                sets.extend(whole(prefix, &["w", "x", "y", "z"], suffix)?);
            }
        }
        for names in ATTITUDE_NAMES {
            sets.extend(all(&names)?);
        }
        for places in sets {
            if attitude.is_some() {
                return Err(wrong("there are two sets of columns for the attitude".into()));
            }
            attitude = <[usize; 4]>::try_from(places).ok();
        }
        let mut vector = None;
        let mut second = None;
        for (kind, ways) in VECTORS {
            for (prefix, suffix) in ways {
                let Some(places) = whole(prefix, &["x", "y", "z"], suffix)? else { continue };
                match vector {
                    Some((before, _)) if before == kind => {
                        let name = &names[places[0]];
                        return Err(wrong(format!(
                            "there are two sets of columns for one vector, `{name}` among them"
                        )));
                    }
                    Some(_) => {
                        second = second.or(<[usize; 3]>::try_from(places).ok().map(|places| (kind, places)));
                    }
                    None => vector = <[usize; 3]>::try_from(places).ok().map(|places| (kind, places)),
                }
            }
        }
        if let Some(places) = all(&SPIN_NAMES)? {
            let spin = <[usize; 3]>::try_from(places).ok().map(|places| (Kind::SpinBody, places));
            (vector, second) = (vector.or(spin), second.or(spin.filter(|_| vector.is_some())));
        }
        let (kind, vector) = match vector {
            Some((kind, places)) => (kind, Some(places)),
            None if attitude.is_some() => (Kind::Attitude, None),
            None => {
                return Err(wrong(format!(
                    "neither spin nor momentum nor attitude is there to be judged; {known}"
                )));
            }
        };
        if kind.in_world() && attitude.is_none() {
            return Err(wrong(
                "a vector in world axes tells nothing of the body without its attitude: qw,qx,qy,qz are missing"
                    .into(),
            ));
        }
        if attitude.is_none() {
            second = second.filter(|(kind, _)| !kind.in_world());
        }
        // One unit for the three of them, and one that is known.
        let unit_of = |kind: Kind, places: &[usize; 3]| -> Result<f64, Error> {
            let [first, others @ ..] = places.map(|i| plain[i].1.as_str());
            if let Some(k) = others.iter().position(|unit| *unit != first) {
                return Err(wrong(format!(
                    "`{}` is not in the unit of `{}`: one unit is wanted for the three",
                    names[places[k + 1]],
                    names[places[0]]
                )));
            }
            if kind.is_momentum() {
                return Ok(1.0);
            }
            units::spin(first).ok_or_else(|| {
                wrong(format!(
                    "the unit of `{}` is not known here: known are rad/s, deg/s, dps, rpm and rev/s",
                    names[places[0]]
                ))
            })
        };
        let first = vector.map_or(Ok(1.0), |places| unit_of(kind, &places))?;
        let other = second.as_ref().map_or(Ok(1.0), |(kind, places)| unit_of(*kind, places))?;
        let per_second = match clock {
            Clock::Steps(_) => 1.0,
            Clock::Time(i) => {
                let (name, unit) = &plain[i];
                let by_name =
                    TIME_IN.iter().find(|known| known.0 == name.as_str()).map_or("", |known| known.1);
                units::per_second(if unit.is_empty() { by_name } else { unit }).ok_or_else(|| {
                    wrong(format!(
                        "the unit of `{}` is not known here: known are s, ms, us, ns and min",
                        names[i]
                    ))
                })?
            }
        };
        Ok(Self {
            names,
            separator,
            clock,
            attitude,
            vector,
            kind,
            second,
            units: [first, other],
            per_second,
        })
    }

    /// The names of the columns that are not read.
    pub(crate) fn ignored(&self) -> Vec<String> {
        let (Clock::Time(clock) | Clock::Steps(clock)) = self.clock;
        let read = |i: usize| {
            i == clock || self.attitude.is_some_and(|places| places.contains(&i)) || self.vectors(i)
        };
        self.names.iter().enumerate().filter(|(i, _)| !read(*i)).map(|(_, name)| name.clone()).collect()
    }

    /// Whether a column is a component of a vector.
    pub(crate) fn vectors(&self, i: usize) -> bool {
        let both = [self.vector, self.second.map(|second| second.1)];
        both.iter().flatten().any(|places| places.contains(&i))
    }
}
