//! What the comment lines of a record say.

use crate::error::Error;
use crate::read::units;
use crate::read::{Note, last_place};
use crate::thresholds::MOMENTS_MISS;
use nalgebra::Vector3;
use tumbling::PrincipalMoments;

/// What the comments before the first row say.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Header {
    /// Who made the record.
    pub engine: Option<String>,
    /// The first comment, up to a semicolon.
    pub first: Option<String>,
    /// Principal moments, kg m².
    pub inertia: Option<Vector3<f64>>,
    /// By how much their printed digits leave them open.
    pub open: Vector3<f64>,
    /// The line that names them.
    line: usize,
    /// Each of them where it has a line of its own, and by how much its digits leave it open.
    each: [Option<(f64, f64)>; 3],
    /// The step, s.
    pub step: Option<f64>,
    /// A torque constant in the world, N m.
    pub torque: Option<Vector3<f64>>,
    /// What was not understood, and what was made of what was.
    pub notes: Vec<Note>,
}

/// Words that may stand between a name and its numbers.
const BETWEEN: [&str; 6] = ["size", "length", "is", "of", "tensor", "principal"];

const OFF_DIAGONAL: [&str; 6] = ["ixy", "iyx", "ixz", "izx", "iyz", "izy"];

/// Words before a name that say that there is none of it.
const NONE: [&str; 3] = ["no", "without", "zero"];

/// Whatever comes after the whole word `word` and a colon, an equals sign or blanks; not where the word
/// before it says that there is none.
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

/// The first word or fraction there is a number, with its unit of time if there is one.
fn seconds(text: &str) -> Option<f64> {
    let mut words = text.split([' ', ',', ';', '\t', ')', ']', '[', '(']).filter(|word| !word.is_empty());
    let word = words.next()?;
    let number = match word.split_once('/') {
        Some((over, under)) => over.parse::<f64>().ok()? / under.parse::<f64>().ok()?,
        None => word.parse().ok()?,
    };
    match words.next() {
        Some(unit) if unit.eq_ignore_ascii_case("hz") => Some(1.0 / number),
        unit => Some(number / unit.and_then(units::per_second).unwrap_or(1.0)),
    }
}

/// The numbers up to the first word that is none, and by how much their printed digits leave them open.
fn numbers(text: &str) -> Vec<(f64, f64)> {
    let words = text.split([' ', ',', '\t', ';', '(', ')', '[', ']']).filter(|x| !x.is_empty());
    words.map_while(|word| Some((word.parse().ok()?, 0.5 * last_place(word)))).collect()
}

/// Whether one of the first words is a number with a comma for a point.
fn has_decimal_comma(text: &str, count: usize) -> bool {
    let mut words = text.split([' ', ';', '\t']).filter(|word| !word.is_empty()).take(count);
    let numbers: Vec<&str> = words.by_ref().map(|word| word.trim_end_matches(',')).collect();
    numbers.iter().any(|word| word.contains(','))
        && numbers.iter().all(|word| word.replacen(',', ".", 1).parse::<f64>().is_ok())
}

const DECIMAL_COMMA: &str = "a number has a decimal comma: write a point";

/// How many kg m² the unit behind the numbers of a tensor is; 1 for prose.
fn unit(text: &str) -> Result<f64, String> {
    let number = |c: char| c.is_ascii_digit() || " ,\t;()[].+-eE".contains(c);
    let words: Vec<&str> = text.trim_start_matches(number).split([' ', ',', ';', ')']).take(3).collect();
    let known = (1..=words.len()).find_map(|n| units::inertia(&words[..n].concat()));
    let is_mass = |word: &str| ["g", "kg", "mg", "t", "lb", "oz", "slug"].contains(&word);
    let mass = words.first().and_then(|word| word.split(|c: char| !c.is_alphabetic()).next());
    if known.is_none() && mass.is_some_and(is_mass) && words.iter().any(|word| word.contains(['2', '²'])) {
        let unit = words.join(" ");
        return Err(format!("the unit `{unit}` is not known here: write the moments in kg m2"));
    }
    Ok(known.unwrap_or(1.0))
}

const PRINCIPAL: &str =
    "give the three principal moments, and write spin and attitude about the principal axes";

/// Three moments; of nine numbers, or of six, the tensor's, those of its diagonal if the rest are zero. One
/// or two may be prose where no colon stands before them.
fn moments(text: &str, named: bool) -> Result<Option<[Vector3<f64>; 2]>, String> {
    if has_decimal_comma(text, 3) {
        return Err(DECIMAL_COMMA.into());
    }
    let all = numbers(text);
    let count = all.len();
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
    if (0..count).any(|i| !places.contains(&i) && all[i].0 != 0.0) {
        return Err(format!(
            "{count} numbers are given for the inertia, with products that are not zero: {PRINCIPAL}"
        ));
    }
    let unit = unit(text)?;
    let part = |of: fn(&(f64, f64)) -> f64| Vector3::from(places.map(|i| of(&all[i]))) * unit;
    Ok(Some([part(|x| x.0), part(|x| x.1)]))
}

/// What comes before a semicolon.
fn head(text: &str) -> String {
    text.split(';').next().unwrap_or(text).trim().to_string()
}

impl Header {
    /// Reads one more comment line. What it does not understand it takes for prose, and says so where it
    /// seems to say something.
    pub(crate) fn read(&mut self, comment: &str, line: usize) -> Result<(), Error> {
        if self.engine.is_none() && comment.to_ascii_lowercase().contains("engine:") {
            self.engine = after(comment, "engine").map(head);
        }
        self.first.get_or_insert_with(|| head(comment));
        let mut unread = None;
        let wrong = |problem: String| Error::Line { line, problem };
        for word in ["inertia", "moments"] {
            let Some(text) = after(comment, word) else { continue };
            let named = comment[..comment.len() - text.len()].trim_end().ends_with([':', '=']);
            match moments(text, named).map_err(wrong)? {
                Some([moments, open]) => self.take(moments, open, line)?,
                None if self.inertia.is_none() && after(comment, "ixx").is_none() => unread = Some(word),
                None => {}
            }
        }
        let one = |word: &str| after(comment, word).and_then(|text| numbers(text).first().copied());
        for (i, word) in ["ixx", "iyy", "izz"].into_iter().enumerate() {
            self.each[i] = self.each[i].or_else(|| one(word));
        }
        if let Some(word) = OFF_DIAGONAL.into_iter().find(|word| one(word).is_some_and(|x| x.0 != 0.0)) {
            return Err(wrong(format!("the product `{word}` is not zero: {PRINCIPAL}")));
        }
        if let (None, [Some(x), Some(y), Some(z)]) = (self.inertia, self.each) {
            self.take(Vector3::new(x.0, y.0, z.0), Vector3::new(x.1, y.1, z.1), line)?;
        }
        if self.torque.is_none()
            && let Some(text) = after(comment, "torque")
        {
            self.torque = numbers(text).get(..3).map(|three| Vector3::from_fn(|i, _| three[i].0));
            unread = unread.or(self.torque.is_none().then_some("torque"));
        }
        for word in ["dt", "timestep", "step"] {
            if self.step.is_none()
                && let Some(text) = after(comment, word)
            {
                if has_decimal_comma(text, 1) {
                    return Err(wrong(DECIMAL_COMMA.into()));
                }
                let Some(step) = seconds(text) else {
                    unread = unread.or(Some(word));
                    continue;
                };
                if !(step.is_finite() && step > 0.0) {
                    return Err(wrong(format!("the step is given as {step}: it must be above zero")));
                }
                self.step = Some(step);
            }
        }
        if let Some(word) = unread {
            self.notes.push(Note::Unread { line, word });
        }
        Ok(())
    }

    /// Moments that a line names: those that another line has named, if it has.
    fn take(&mut self, moments: Vector3<f64>, open: Vector3<f64>, line: usize) -> Result<(), Error> {
        if self.inertia.replace(moments).is_some_and(|before| before != moments) {
            let problem = format!("the moments differ from those in line {}: name them once", self.line);
            return Err(Error::Line { line, problem });
        }
        (self.open, self.line) = (open, line);
        Ok(())
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
        let Some(named) = self.inertia else { return Ok(None) };
        let largest = named.imax();
        let rest = named[(largest + 1) % 3] + named[(largest + 2) % 3];
        let missing = named[largest] - rest;
        // One or two digits are no rounding, but a mistake.
        let rounded = missing <= self.open.sum() && missing <= MOMENTS_MISS * named[largest];
        if !(missing > 0.0 && rounded && named.min() > 0.0) {
            let line = self.line;
            let wrong =
                |wrong| Error::Line { line, problem: format!("{wrong}. Look at the numbers and their unit") };
            return PrincipalMoments::try_from(named).map(|_| Some(named)).map_err(wrong);
        }
        let mut moments = named;
        moments[largest] = rest;
        notes.push(Note::Flat { printed: named[largest], missing, moments });
        Ok(Some(moments))
    }
}
