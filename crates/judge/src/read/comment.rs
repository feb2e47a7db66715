//! Reads the comment lines of a record, and units.

use crate::error::Error;
use crate::read::{Note, last_place};
use crate::thresholds::{MOMENTS_MISS, PRODUCTS};
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};
use tumbling::PrincipalMoments;

/// The information in the comments before the first row.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Header {
    /// Who made the record.
    pub engine: Option<String>,
    /// The first comment, up to a semicolon.
    pub first: Option<String>,
    /// Principal moments, kg m²; how far their printed digits leave them open, and the lines that name them.
    named: [Option<(f64, f64, usize)>; 3],
    /// Products of inertia, kg m², and their lines.
    products: Vec<(f64, usize)>,
    /// The first line that is wrong about the moments, and why.
    wrong: Option<(usize, String)>,
    /// The step, s.
    pub step: Option<f64>,
    /// A torque constant in the world, N m.
    pub torque: Option<Vector3<f64>>,
    /// Notes on comments: not understood, or interpreted.
    pub notes: Vec<Note>,
}

/// Words that may stand between a name and its numbers.
const BETWEEN: [&str; 6] = ["size", "length", "is", "of", "tensor", "principal"];

const DIAGONAL: [&str; 3] = ["ixx", "iyy", "izz"];
const OFF_DIAGONAL: [&str; 6] = ["ixy", "iyx", "ixz", "izx", "iyz", "izy"];

/// Words before a name that deny it.
const NONE: [&str; 3] = ["no", "without", "zero"];

/// The text after the whole word `word` and a colon, an equals sign or blanks; none if the word before it
/// denies it ("no torque").
fn after<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    let lower = text.to_ascii_lowercase();
    let (at, _) = lower.match_indices(word).find(|(at, _)| {
        let (before, behind) = (&lower[..*at], &lower[at + word.len()..]);
        let none = before.split_whitespace().last().is_some_and(|last| NONE.contains(&last));
        let whole = |c: Option<char>| !c.is_some_and(char::is_alphanumeric);
        !none && whole(before.chars().last()) && whole(behind.chars().next())
    })?;
    let mut rest = text[at + word.len()..].trim_start_matches([':', '=', ' ', '\t']);
    while let Some(word) = BETWEEN.iter().find(|word| {
        rest.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word))
            && !rest[word.len()..].starts_with(char::is_alphanumeric)
    }) {
        rest = rest[word.len()..].trim_start_matches([':', '=', ' ', '\t']);
    }
    Some(rest)
}

/// The first word or fraction behind a name is a number, with its unit of time or of frequency if there is
/// one. Words behind it that are no unit are a remark, or make it prose where no colon stands before it.
fn seconds(text: &str, name: &str, named: bool) -> Result<Option<f64>, String> {
    let whole = text.split([',', ';']).next().unwrap_or_default();
    let is_digit = |c: char| c.is_ascii_digit();
    // A fraction may stand with blanks about its stroke.
    let parts = whole.split_once('/').map(|(over, under)| (over.trim_end(), under.trim_start()));
    let is_one = |(over, under): &(&str, &str)| over.ends_with(is_digit) && under.starts_with(is_digit);
    let said = parts.filter(is_one).map_or_else(|| whole.into(), |(over, under)| format!("{over}/{under}"));
    let mut words = said.split([' ', '\t', '(', ')', '[', ']']).filter(|word| !word.is_empty());
    let word = words.next().unwrap_or_default();
    let end = word.rfind(|c| is_digit(c) || c == '.').map_or(word.len(), |at| at + 1);
    let (number, unit) = word.split_at(end);
    let (over, under) = number.split_once('/').unwrap_or((number, "1"));
    let (Ok(over), Ok(under)) = (over.parse::<f64>(), under.parse::<f64>()) else { return Ok(None) };
    let next = words.next().unwrap_or_default().trim_end_matches(['.', ':']);
    let known = !unit.is_empty() || period(1.0, next).is_some();
    let frequency = !known && next.to_ascii_lowercase().ends_with("hz");
    let unit = if unit.is_empty() && (known || frequency) { next } else { unit };
    // `step: 3 / 10` is the third of ten, but a time step is no count.
    let counts = said != whole && name == "step" && unit.is_empty();
    match period(over / under, unit) {
        Some(_) if number.contains('/') && period(2.0, unit) < period(1.0, unit) => {
            Err(format!("the step is given as {}, a fraction of a frequency: write it in s", said.trim()))
        }
        Some(_) if counts || !known && (!named || ["of", "/"].contains(&next)) => Ok(None),
        Some(step) if step.is_finite() && step > 0.0 => Ok(Some(step)),
        Some(_) => Err(format!("the step is given as {}: it must be above zero", said.trim())),
        None if named && unit.starts_with(char::is_alphabetic) => {
            Err(format!("the unit `{unit}` is not known: s, ms, us, ns, min, h, Hz, kHz and fps are"))
        }
        None => Ok(None),
    }
}

/// The numbers up to the first word that is none, and by how much their printed digits leave them open.
fn numbers(text: &str) -> Vec<(f64, f64)> {
    let words = text.split([' ', ',', '\t', ';', '(', ')', '[', ']']).filter(|x| !x.is_empty());
    words.map_while(|word| Some((word.parse().ok()?, 0.5 * last_place(word)))).collect()
}

/// None of the first words is a number with a comma for a point.
fn no_decimal_comma(text: &str, count: usize) -> Result<(), String> {
    let words = text.split([' ', ';', '\t', '(', ')', '[', ']']).map(|word| word.trim_end_matches(','));
    let numbers: Vec<&str> = words.filter(|word| !word.is_empty()).take(count).collect();
    let is_number = |word: &&str| word.replacen(',', ".", 1).parse::<f64>().is_ok();
    let has = numbers.iter().any(|word| word.contains(',')) && numbers.iter().all(is_number);
    if has { Err("a number has a decimal comma: write a point".into()) } else { Ok(()) }
}

/// How many kg m² the unit behind the numbers of a tensor is; 1 for prose.
fn unit(text: &str) -> Result<f64, String> {
    let number = |c: char| c.is_ascii_digit() || " ,\t;()[].+-eE".contains(c);
    let words: Vec<&str> = text.trim_start_matches(number).split([' ', ',', ';', ')']).take(3).collect();
    let known = (1..=words.len()).find_map(|n| inertia_unit(&words[..n].concat()));
    let is_mass = |word: &str| ["g", "kg", "mg", "t", "lb", "oz", "slug"].contains(&word);
    let mass = words.first().and_then(|word| word.split(|c: char| !c.is_alphabetic()).next());
    if known.is_none() && mass.is_some_and(is_mass) && words.iter().any(|word| word.contains(['2', '²'])) {
        let unit = words.join(" ");
        return Err(format!("the unit `{unit}` is not known here: write the moments in kg m2"));
    }
    Ok(known.unwrap_or(1.0))
}

const PRINCIPAL: &str = "give the three principal moments, before other words, and write spin and attitude about the principal axes";

/// Moments and products of inertia, each with how far its printed digits leave it open.
type Parts = [Vec<(f64, f64)>; 2];

/// Three moments, and what products there are: of nine numbers, or of six, the tensor's. One or two may be
/// prose where no colon stands before them; so is all but a tensor behind a colon, once moments are known.
fn tensor(text: &str, named: bool, known: bool) -> Result<Option<Parts>, String> {
    let all = numbers(text);
    let count = all.len();
    if known && !(named && [3, 6, 9].contains(&count)) {
        return Ok(None);
    }
    no_decimal_comma(text, 3)?;
    let places = match count {
        3 | 6 => [0, 1, 2],
        9 => [0, 4, 8],
        0 => return Ok(None),
        1 | 2 if !named => return Ok(None),
        _ => {
            let numbers = if count == 1 { "number is" } else { "numbers are" };
            return Err(format!("{count} {numbers} given for the inertia: {PRINCIPAL}"));
        }
    };
    let unit = unit(text)?;
    let scaled = all.into_iter().map(|(x, open)| (x * unit, open * unit)).enumerate();
    let (moments, products): (Vec<_>, Vec<_>) = scaled.partition(|(i, _)| places.contains(i));
    Ok(Some([moments, products].map(|part| part.into_iter().map(|x| x.1).collect())))
}

/// Words before the numbers of a torque that is one in the world.
const OF_TORQUE: &str =
    "on the body in world space inertial axes frame constant external applied vector N m Nm";

/// Words that speak of the body as that which a torque acts on.
const OF_BODY: &str =
    "on the body|applied to the body|centre of the body|center of the body|the body is|rigid body";

/// Three numbers, constant in the world, behind a remark in brackets, or words that say as much, if there are
/// any. Behind a colon numbers that are not three are a mistake, and before one they may be prose.
fn torque(before: &str, text: &str) -> Result<Option<Vector3<f64>>, String> {
    let text = text.trim_start_matches([',', ' ']);
    let is_digit = |c: char| c.is_ascii_digit();
    let is_usual = |word: &str| word.is_empty() || OF_TORQUE.split(' ').any(|usual| usual == word);
    let is_remark = |words: &str| {
        words.starts_with(['(', '[']) && words.ends_with([')', ']'])
            || words.split(|c: char| !c.is_alphanumeric()).all(is_usual)
    };
    let is_other = |words: &str| [",", ";", "free", "inertia", "moments"].iter().any(|x| words.contains(x));
    let behind = text.split_once(':').filter(|(words, _)| is_remark(words) || !is_other(words));
    let numbers_in = behind.filter(|x| is_remark(x.0) && x.1.contains(is_digit)).map_or(text, |x| x.1);
    no_decimal_comma(numbers_in, 3)?;
    let all: Vec<f64> = numbers(numbers_in).into_iter().map(|x| x.0).collect();
    let clause = behind.map_or(text, |x| x.1).split(';').next().unwrap_or_default();
    let (words, rest) = clause.split_at(clause.find(is_digit).unwrap_or(clause.len()));
    // At most the name of an axis stands before the first digit; or three numbers or a unit tell a torque.
    let is_given = words.chars().filter(|c| c.is_alphabetic()).count() < 2
        || words.trim_end().ends_with('=')
        || ["N m", "Nm", "N*m", "N·m"].iter().any(|unit| rest.contains(unit))
        || numbers(rest).len() > 2;
    let of_time = words.ends_with("t=") || words.contains(',') && words.contains([':', '=']);
    let named = behind.is_some() || before.trim_end().ends_with([':', '=']);
    let is_said = named && is_given && !of_time && !rest.is_empty();
    match all[..] {
        [_, ..] if all.iter().all(|x| *x == 0.0) => Ok(Some(Vector3::zeros())),
        _ if (is_said || !all.is_empty()) && is_in_body(before, text) => {
            Err("the torque seems to be in axes that turn with the body: only a torque constant in the world is supported, as in `torque: 0 0 0.1`".into())
        }
        [x, y, z] => Ok(Some(Vector3::new(x, y, z))),
        _ if all.len() > 3 || is_said => {
            Err(format!("a torque has three numbers after its name, as in `torque: 0 0 0.1`, but {} can be read here", all.len()))
        }
        _ => Ok(None),
    }
}

/// Whether what is said of a torque, up to the next field, speaks of the body otherwise than as that which it
/// acts on, or of axes that turn with it.
fn is_in_body(before: &str, text: &str) -> bool {
    let is_own = |part: &&str| !part.contains([':', '=']);
    let has = |text: &str, word: &str| after(text, word).is_some();
    let of_torque = |part: &&str| !["spin", "inertia", "moments"].iter().any(|word| has(part, word));
    let later = text.split(';').skip(1).take_while(is_own);
    let own = text.split(';').next().unwrap_or_default();
    let others = before.rsplit(';').take(1).chain(later).filter(of_torque);
    let said = others.chain([own]).collect::<Vec<_>>().join(" ").to_ascii_lowercase();
    let plain = OF_BODY.split('|').fold(said.clone(), |said, words| said.replace(words, ""));
    let has_axes = ["axes", "frame", "fixed", "body's"].into_iter().any(|word| said.contains(word));
    let turns = "body local principal own rotating moving".split(' ').any(|word| has(&said, word));
    let denied = ["not inertial", "non-inertial"].iter().any(|words| said.contains(words));
    let in_world = has(&said, "world") || (has(&said, "inertial") || has(&said, "space")) && !denied;
    !in_world && (has(&plain, "body") || has(own, "local") || turns && has_axes)
}

/// What comes before a semicolon.
fn head(text: &str) -> String {
    text.split(';').next().unwrap_or(text).trim().to_string()
}

impl Header {
    /// Reads one more comment line. A line that it does not understand is taken for prose, with a note if it
    /// seems to give a number.
    pub(crate) fn read(&mut self, comment: &str, line: usize) -> Result<(), Error> {
        if self.engine.is_none() && comment.to_ascii_lowercase().contains("engine:") {
            self.engine = after(comment, "engine").map(head);
        }
        self.first.get_or_insert_with(|| head(comment));
        let mut unread = None;
        let wrong = |problem: String| Error::Line { line, problem };
        let named = |text: &str| comment[..comment.len() - text.len()].trim_end().ends_with([':', '=']);
        for word in ["inertia", "moments"] {
            let Some(text) = after(comment, word) else { continue };
            let known = self.named.iter().all(Option::is_some);
            match tensor(text, named(text), known) {
                Ok(Some([moments, products])) => {
                    moments.into_iter().enumerate().for_each(|(i, moment)| self.take(i, moment, line));
                    self.products.extend(products.into_iter().map(|product| (product.0, line)));
                }
                Ok(None) if !known && after(comment, "ixx").is_none() => unread = Some(word),
                Ok(None) => {}
                Err(problem) => self.wrong = self.wrong.take().or(Some((line, problem))),
            }
        }
        let texts = DIAGONAL.into_iter().chain(OFF_DIAGONAL).filter_map(|word| after(comment, word));
        if let Some(problem) = texts.into_iter().find_map(|text| no_decimal_comma(text, 1).err()) {
            self.wrong.get_or_insert((line, problem));
        }
        let one = |word: &str| after(comment, word).and_then(|text| numbers(text).first().copied());
        for (i, word) in DIAGONAL.into_iter().enumerate() {
            one(word).into_iter().for_each(|moment| self.take(i, moment, line));
        }
        self.products.extend(OFF_DIAGONAL.into_iter().filter_map(one).map(|product| (product.0, line)));
        let tau = after(comment, "tau").filter(|text| named(text) && numbers(text).len() == 3);
        let said = ["torque", "torques"].into_iter().find_map(|word| after(comment, word)).or(tau);
        if let Some(text) = said.filter(|_| self.torque.is_none()) {
            self.torque = torque(&comment[..comment.len() - text.len()], text).map_err(wrong)?;
            unread = unread.or(self.torque.is_none().then_some("torque"));
        }
        for word in ["dt", "timestep", "time step", "time_step", "time-step", "step size", "step"] {
            if let Some(text) = after(comment, word).filter(|_| self.step.is_none()) {
                no_decimal_comma(text, 1).map_err(wrong)?;
                self.step = seconds(text, word, named(text)).map_err(wrong)?;
                unread = unread.or(self.step.is_none().then_some(word));
            }
        }
        if let Some(word) = unread {
            self.notes.push(Note::Unread(line, word));
        }
        Ok(())
    }

    /// Stores a moment from a line; it must equal the one that an earlier line gave.
    fn take(&mut self, i: usize, (moment, open): (f64, f64), line: usize) {
        let (before, _, first) = *self.named[i].get_or_insert((moment, open, line));
        if (before - moment).abs() > PRODUCTS * before.abs() {
            let problem = format!("the moments differ from those in line {first}: give them once");
            self.wrong.get_or_insert((line, problem));
        }
    }

    /// The engine named; or the first comment, where that begins with the name of one.
    pub(crate) fn engine(&self, is_known: impl Fn(&str) -> bool) -> Option<String> {
        let named = |comment: &&String| {
            comment.split(|c: char| !c.is_alphanumeric()).find(|word| !word.is_empty()).is_some_and(&is_known)
        };
        self.engine.clone().or_else(|| self.first.as_ref().filter(named).cloned())
    }

    /// The moments given. Of a flat body, whose rounded moments miss the triangle rule by no more
    /// than their printed digits leave open, the largest is taken as the sum of the others, and a note says
    /// so.
    pub(crate) fn moments(&self, notes: &mut Vec<Note>) -> Result<Option<Vector3<f64>>, Error> {
        if let Some((line, problem)) = self.wrong.clone() {
            return Err(Error::Line { line, problem });
        }
        let [Some(x), Some(y), Some(z)] = self.named else { return Ok(None) };
        let (named, open) = (Vector3::new(x.0, y.0, z.0), x.1 + y.1 + z.1);
        let trace = named.sum().abs();
        let large = |product: f64| product.is_nan() || product.abs() > PRODUCTS * trace;
        if let Some(&(product, line)) = self.products.iter().find(|(product, _)| large(*product)) {
            let rule = format!("more than {PRODUCTS:e} of the sum of the moments, {trace}");
            let problem = format!("a product of inertia is {product}, {rule}: {PRINCIPAL}");
            return Err(Error::Line { line, problem });
        }
        let largest = named.imax();
        let rest = named[(largest + 1) % 3] + named[(largest + 2) % 3];
        let missing = named[largest] - rest;
        // One or two digits are no rounding, but a mistake.
        let rounded = missing <= open && missing <= MOMENTS_MISS * named[largest];
        if !(missing > 0.0 && rounded && named.min() > 0.0) {
            let line = x.2.max(y.2).max(z.2);
            let wrong =
                |wrong| Error::Line { line, problem: format!("{wrong}. Check the numbers and their unit") };
            return PrincipalMoments::try_from(named).map(|_| Some(named)).map_err(wrong);
        }
        let mut moments = named;
        moments[largest] = rest;
        notes.push(Note::Flat { printed: named[largest], missing, moments });
        Ok(Some(moments))
    }
}

/// How many of a unit of time are a second; `None` for no unit of time.
pub(super) fn per_second(unit: &str) -> Option<f64> {
    Some(match unit {
        "" | "s" | "sec" | "secs" | "second" | "seconds" => 1.0,
        "ms" | "msec" | "millisecond" | "milliseconds" => 1e3,
        "us" | "\u{b5}s" | "\u{3bc}s" | "usec" | "microsecond" | "microseconds" => 1e6,
        "ns" | "nsec" | "nanosecond" | "nanoseconds" => 1e9,
        "min" | "minute" | "minutes" => 1.0 / 60.0,
        "h" | "hour" | "hours" => 1.0 / 3600.0,
        _ => return None,
    })
}

/// A number of a unit of time, or a frequency in its unit, in s; `None` for a unit that is not known.
fn period(number: f64, unit: &str) -> Option<f64> {
    match unit.to_ascii_lowercase().as_str() {
        "hz" | "hertz" | "fps" => Some(1.0 / number),
        "khz" => Some(1e-3 / number),
        unit => Some(number / per_second(unit)?),
    }
}

/// A unit of moments of inertia in kg m²; `None` for a unit that is not known.
fn inertia_unit(unit: &str) -> Option<f64> {
    let unit: String = unit.chars().filter(|c| c.is_alphanumeric()).collect();
    Some(match unit.replace('²', "2").as_str() {
        "" | "kgm2" => 1.0,
        "kgcm2" => 1e-4,
        "gm2" => 1e-3,
        "kgmm2" => 1e-6,
        "gcm2" => 1e-7,
        "gmm2" => 1e-9,
        _ => return None,
    })
}

/// A unit of spin in rad/s; `None` for no unit of spin. Of lower case, and without blanks.
pub(super) fn spin_unit(unit: &str) -> Option<f64> {
    let unit: String = unit.chars().filter(|c| !c.is_whitespace()).collect();
    Some(match unit.as_str() {
        "" | "rad/s" | "rads" | "radps" | "rad/sec" | "radians" | "radians/s" | "rads^-1" | "rads-1"
        | "rad*s^-1" | "rad\u{b7}s^-1" | "1/s" | "s^-1" | "s-1" | "body" => 1.0,
        "mrad/s" => 1e-3,
        "deg/s" | "deg" | "degrees/s" | "degrees" | "deg/sec" | "\u{b0}/s" | "\u{b0}/sec" | "\u{b0}"
        | "dps" | "degs^-1" => PI / 180.0,
        "rpm" | "rev/min" | "r/min" | "1/min" => PI / 30.0,
        "rps" | "rev/s" | "r/s" | "hz" | "turns/s" | "turn/s" => TAU,
        _ => return None,
    })
}
