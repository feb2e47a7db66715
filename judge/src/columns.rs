//! Which column is what, from their names.

use crate::error::Error;

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
    /// The header says that the spin is in degrees a second.
    pub degrees: bool,
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

const TIME: [&str; 3] = ["t", "time", "seconds"];
const STEPS: [&str; 2] = ["step", "frame"];
/// Before and after the letter of the axis.
const ATTITUDE: [(&str, &str); 3] = [("q", ""), ("quat", ""), ("quaternion", "")];
const VECTORS: [(Kind, &[(&str, &str)]); 4] = [
    (Kind::SpinBody, &[("w", ""), ("w", "b"), ("w", "body"), ("omega", ""), ("omega", "body")]),
    (Kind::SpinWorld, &[("w", "w"), ("w", "world"), ("omega", "world"), ("omega", "w")]),
    (Kind::MomentumBody, &[("l", ""), ("l", "b"), ("l", "body")]),
    (Kind::MomentumWorld, &[("l", "w"), ("l", "world")]),
];

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
        let clock = match (any(&TIME)?, any(&STEPS)?) {
            (Some(i), _) => Clock::Time(i),
            (None, Some(i)) => Clock::Steps(i),
            (None, None) => return Err(wrong(format!("the column `t` is missing; {known}"))),
        };
        let mut attitude = None;
        for (prefix, suffix) in ATTITUDE {
            if let Some(places) = whole(prefix, &["w", "x", "y", "z"], suffix)? {
                if attitude.is_some() {
                    return Err(wrong("there are two sets of columns for the attitude".into()));
                }
                attitude = <[usize; 4]>::try_from(places).ok();
            }
        }
        let mut vector = None;
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
                    Some(_) => {}
                    None => vector = <[usize; 3]>::try_from(places).ok().map(|places| (kind, places)),
                }
            }
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
        let degrees =
            !kind.is_momentum() && vector.is_some_and(|places| plain[places[0]].1.starts_with("deg"));
        Ok(Self { names, separator, clock, attitude, vector, kind, degrees })
    }
}
