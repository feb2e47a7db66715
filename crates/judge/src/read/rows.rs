//! A row as it is written, and where rows come from: memory, or a record, one line in memory at a time.

use crate::error::{Error, not_later};
use crate::read::{Columns, Header, Separator, TimeColumn, last_place, significant, significant_bits};
use crate::thresholds::*;
use nalgebra::{Quaternion, Vector3};
use std::io::BufRead;

/// Where rows come from.
pub(crate) trait Source {
    /// The next row; `None` after the last, or where the numbers end.
    fn next(&mut self) -> Result<Option<Raw>, Error>;

    /// Where the numbers end before the rows do.
    fn ended(&mut self) -> Option<Error>;
}

/// How a time is printed. Nothing of it is known of a count of steps.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Printed {
    /// Half a unit of its last digit, s.
    pub half: f64,
    /// Its significant digits.
    pub digits: u32,
    /// The power of ten next above it, s.
    pub above: f64,
}

/// A row as it stands in the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Raw {
    pub line: usize,
    /// Seconds, or a count of steps times the step.
    pub t: f64,
    pub attitude: Option<Quaternion<f64>>,
    /// As [`Kind`] says; in radians.
    pub vector: Vector3<f64>,
    /// In the world; zero where it is not read.
    pub position: Vector3<f64>,
    /// How its time is printed.
    pub printed: Printed,
    /// How exact the numbers of the attitude are, and those of the vector.
    pub exact: [Exact; 2],
}

/// The precision of numbers, as they are written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Exact {
    /// The largest number of significant digits.
    pub digits: u32,
    /// The largest number of significant bits; 24 fit single precision, 11 half precision.
    pub bits: u32,
    /// The smallest unit in the last place of any.
    pub place: f64,
}

impl Raw {
    /// The spin in body axes, from a spin or a momentum in either frame.
    pub(crate) fn omega(&self, in_world: bool, momentum: bool, moments: &Vector3<f64>) -> Vector3<f64> {
        let turned = |attitude: Quaternion<f64>| {
            let rotation = tumbling::attitude::rotation_matrix(&attitude);
            rotation.tr_mul(&self.vector) / attitude.coords.norm_squared()
        };
        let there = self.attitude.filter(|q| in_world && q.coords.norm_squared() > 0.0);
        let vector = there.map_or(self.vector, turned);
        if momentum { vector.component_div(moments) } else { vector }
    }
}

/// Reads a record.
pub(crate) struct Rows<R> {
    lines: Lines<R>,
    pub columns: Columns,
    pub header: Header,
    last: Option<f64>,
    fields: Vec<f64>,
    rows: u64,
    /// The first value that is not a number, after sound rows; nothing is read from there on.
    pub ended: Option<Error>,
}

impl<R: BufRead> Rows<R> {
    /// Reads up to the line of names.
    pub(crate) fn open(source: R) -> Result<Self, Error> {
        let mut lines = Lines { source, line: 0, text: Vec::new() };
        let mut header = Header::default();
        while lines.advance()? {
            let line = lines.line;
            let text = text_of(&lines.text, line)?.trim_start_matches('\u{feff}').trim();
            if let Some(comment) = comment(text) {
                header.read(comment, line)?;
            } else if !text.is_empty() {
                let columns = Columns::of(text, line, header.step.is_some())?;
                if matches!(columns.clock, TimeColumn::Steps(_)) && header.step.is_none() {
                    let problem = "steps are counted, but their length is not given: a comment line `# dt: 0.01`, or a \
                         column `t`, is missing";
                    return Err(Error::Line { line, problem: problem.into() });
                }
                let (last, fields, ended) = (None, Vec::new(), None);
                return Ok(Self { lines, columns, header, last, fields, rows: 0, ended });
            }
        }
        Err(Error::Empty)
    }
}

impl<R: BufRead> Source for Rows<R> {
    fn next(&mut self) -> Result<Option<Raw>, Error> {
        while self.ended.is_none() && self.lines.advance()? {
            let line = self.lines.line;
            let text = text_of(&self.lines.text, line)?.trim();
            if text.is_empty() || comment(text).is_some() {
                continue;
            }
            let header = (&self.header, self.rows);
            let raw = read(&self.columns, text, line, header, (&mut self.fields, &mut self.ended))?;
            if self.ended.is_some() {
                let is_early = self.rows < ROWS_BEFORE_THE_END;
                return self.ended.take_if(|_| is_early).map_or(Ok(None), Err);
            }
            if let Some(last) = self.last.replace(raw.t)
                && raw.t <= last
            {
                let i = self.columns.clock.place().unwrap_or(0);
                let (column, name) = (i + 1, self.columns.names[i].clone());
                return Err(Error::Field { line, column, name, problem: not_later(raw.t, last) });
            }
            self.rows += 1;
            return Ok(Some(raw));
        }
        Ok(None)
    }

    fn ended(&mut self) -> Option<Error> {
        self.ended.take()
    }
}

impl Exact {
    /// Of no number yet.
    const NONE: Self = Self { digits: 0, bits: 0, place: f64::INFINITY };

    fn take(&mut self, field: &str, value: f64) {
        self.digits = self.digits.max(significant(field));
        let place = last_place(field);
        self.place = self.place.min(place);
        // Single precision, either exactly or as decimals that round back to it.
        let off = (f64::from(value as f32) - value).abs();
        let decimals = significant(field) <= MOST_DIGITS_OF_SINGLE;
        let is_single = decimals && off <= 0.5000001 * place;
        let bits = significant_bits(value);
        self.bits = self.bits.max(if is_single { bits.min(BITS_OF_SINGLE) } else { bits });
    }
}

impl Printed {
    fn of(field: &str, value: f64, per_second: f64) -> Self {
        let above = if value == 0.0 { 0.0 } else { 10.0_f64.powf(value.abs().log10().floor() + 1.0) };
        let (half, digits) = (0.5 * last_place(field) / per_second, significant(field));
        Self { half, digits, above: above / per_second }
    }
}

/// What programs in C print for values that are not numbers.
const C_HAS_NONE: [&str; 5] = ["nan(", "#ind", "#qnan", "#snan", "#inf"];

/// The numbers of a row, one for each column; zero where none is read. Where one is not finite the numbers
/// end.
fn numbers(
    columns: &Columns,
    text: &str,
    line: usize,
    (fields, ended): (&mut Vec<f64>, &mut Option<Error>),
) -> Result<(Printed, [Exact; 2]), Error> {
    let (mut printed, mut exact) = (Printed::default(), [Exact::NONE; 2]);
    let there = columns.names.len();
    fields.clear();
    for (i, field) in columns.separator.split(text).enumerate() {
        let wrong = |problem: String| Error::Field {
            line,
            column: i + 1,
            name: columns.names.get(i).cloned().unwrap_or_default(),
            problem,
        };
        if i >= there {
            if field.is_empty() && i == there {
                continue; // a separator at the end of the line
            }
            let shown = shown(field);
            let comma =
                if columns.separator == Separator::One(',') { ": a decimal comma? Write points" } else { "" };
            let problem = format!("`{shown}` is one more field than there are columns ({there}){comma}");
            return Err(wrong(problem));
        }
        if !columns.reads(i) {
            fields.push(0.0);
            continue;
        }
        if field.is_empty() {
            return Err(wrong("the field is empty".into()));
        }
        let lower = || field.to_ascii_lowercase();
        let none = || C_HAS_NONE.iter().any(|none| lower().contains(none)).then_some(f64::NAN);
        let value: f64 = field.parse().ok().or_else(none).ok_or_else(|| wrong(no_number(field)))?;
        if !value.is_finite() {
            let problem = format!("the value is {}: from here on there is no motion", shown(field));
            ended.get_or_insert(wrong(problem));
        }
        if columns.clock == TimeColumn::Time(i) {
            printed = Printed::of(field, value, columns.per_second);
        } else if columns.clock.place() != Some(i) && columns.position.is_none_or(|at| !at.contains(&i)) {
            let of_attitude = columns.attitude.is_some_and(|places| places.contains(&i));
            exact[usize::from(!of_attitude)].take(field, value);
        }
        fields.push(value);
    }
    if let Some(missing) = columns.names.get(fields.len()) {
        let found = fields.len();
        let problem = format!("there are {found} fields for {there} columns: `{missing}` is missing");
        return Err(Error::Line { line, problem });
    }
    Ok((printed, exact))
}

fn read(
    columns: &Columns,
    text: &str,
    line: usize,
    (header, rows): (&Header, u64),
    (fields, ended): (&mut Vec<f64>, &mut Option<Error>),
) -> Result<Raw, Error> {
    let (printed, exact) = numbers(columns, text, line, (fields, ended))?;
    let t = match columns.clock {
        TimeColumn::Time(i) => fields[i] / columns.per_second,
        TimeColumn::Steps(i) => fields[i] * header.step.unwrap_or(1.0),
        TimeColumn::Rows => rows as f64 * header.step.unwrap_or(1.0),
    };
    let three = |at: Option<[usize; 3]>| Vector3::from(at.map_or([0.0; 3], |at| at.map(|i| fields[i])));
    let (vector, position) = (three(columns.vector) * columns.unit, three(columns.position));
    let attitude = columns.attitude.map(|places| {
        let [w, x, y, z] = places.map(|i| fields[i]);
        Quaternion::new(w, x, y, z)
    });
    if attitude.is_some_and(|q: Quaternion<f64>| q.coords.amax() == 0.0) {
        let problem = "the quaternion has no length: from here on there is no motion".into();
        ended.get_or_insert(Error::Line { line, problem });
    }
    Ok(Raw { line, t, attitude, vector, position, printed, exact })
}

/// A field as an error shows it: not all of a long one.
fn shown(field: &str) -> String {
    let shown = field.chars().take(FIELD_SHOWN).map(|c| if c.is_control() { '\u{fffd}' } else { c });
    shown.chain(field.chars().nth(FIELD_SHOWN).map(|_| '…')).collect()
}

/// What is wrong with a field that is no number.
fn no_number(field: &str) -> String {
    let shown = shown(field);
    let why = if field.contains('\u{2212}') {
        ": its minus sign is not the hyphen `-` that programs read"
    } else if field.contains(',') && field.replacen(',', ".", 1).parse::<f64>().is_ok() {
        ": write a decimal point, not a comma"
    } else {
        ""
    };
    format!("`{shown}` is not a number{why}")
}

/// Lines with their numbers.
struct Lines<R> {
    source: R,
    line: usize,
    text: Vec<u8>,
}

impl<R: BufRead> Lines<R> {
    fn advance(&mut self) -> Result<bool, Error> {
        self.text.clear();
        self.line += 1;
        let mut limited = std::io::Read::take(&mut self.source, LINE_BYTES);
        let read = limited.read_until(b'\n', &mut self.text);
        let read = read.map_err(|source| Error::Read { line: self.line, source })?;
        if read as u64 == LINE_BYTES && self.text.last() != Some(&b'\n') {
            let problem = format!("the line is longer than {LINE_BYTES} bytes");
            return Err(Error::Line { line: self.line, problem });
        }
        Ok(read > 0)
    }
}

/// The text of a comment, without what spreadsheets put around it.
fn comment(line: &str) -> Option<&str> {
    line.trim_start_matches('"').strip_prefix('#').map(|text| text.trim_end_matches(['"', ',', ';', '\t']))
}

fn text_of(bytes: &[u8], line: usize) -> Result<&str, Error> {
    let wrong = |problem: &str| Error::Line { line, problem: problem.into() };
    let text = match std::str::from_utf8(bytes) {
        Ok(text) if !text.contains('\0') => text,
        _ if line == 1 && (bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff])) => {
            return Err(wrong("the file is in UTF-16: save it in UTF-8"));
        }
        _ => return Err(wrong("the line is not text in UTF-8: save the file in UTF-8")),
    };
    if text.trim_end().contains('\r') {
        return Err(wrong("there are carriage returns within the line: end lines by a line feed"));
    }
    Ok(text)
}
