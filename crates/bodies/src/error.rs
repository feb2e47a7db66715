//! Why a body could not be read.

use std::fmt;
use std::ops::Range;
use std::path::Path;

/// Why a body could not be read: in which file, at which line, which field, and the rule that it breaks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    /// The file, where the body came from one.
    pub file: Option<String>,
    /// From 1.
    pub line: Option<usize>,
    /// The field.
    pub field: Option<String>,
    /// The rest of the sentence.
    pub why: String,
}

impl Error {
    /// What is wrong, without a place.
    #[must_use]
    pub fn new(why: impl fmt::Display) -> Self {
        // A file has fields where a program calls functions.
        let why = why.to_string().replace(
            "`within` takes a tolerance and gives the nearest possible body",
            "`tolerance` says by how much, and the nearest possible body is taken",
        );
        Self { file: None, line: None, field: None, why }
    }

    /// What is wrong at a place in a text.
    #[must_use]
    pub fn at(text: &str, span: &Range<usize>, why: impl fmt::Display) -> Self {
        let before = text.bytes().take(span.start).filter(|&byte| byte == b'\n').count();
        Self { line: Some(before + 1), ..Self::new(why) }
    }

    /// With the field.
    #[must_use]
    pub fn of_field(self, field: &str) -> Self {
        Self { field: Some(field.to_owned()), ..self }
    }

    /// With the file, if it is not in another.
    #[must_use]
    pub fn in_file(self, file: &Path) -> Self {
        Self { file: self.file.or_else(|| Some(file.display().to_string())), ..self }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = [
            self.file.clone(),
            self.line.map(|line| format!("line {line}")),
            self.field.as_ref().map(|field| format!("`{field}`")),
        ];
        let place: Vec<String> = place.into_iter().flatten().collect();
        if !place.is_empty() {
            write!(f, "{}: ", place.join(", "))?;
        }
        f.write_str(&self.why)
    }
}

impl std::error::Error for Error {}

impl From<tumbling::Error> for Error {
    fn from(error: tumbling::Error) -> Self {
        Self::new(error)
    }
}
