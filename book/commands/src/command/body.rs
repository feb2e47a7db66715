//! The body that a command is given.

use tumbling_bodies::{BodyModel, Error};
use tumbling_site::complain;

/// The body for a name or a file; if its units look wrong, a question is printed at once.
///
/// # Errors
/// A body that cannot be read.
pub(crate) fn body(words: &str) -> Result<BodyModel, Error> {
    let body = BodyModel::load(words)?;
    body.question.iter().for_each(|question| complain!("{question}"));
    Ok(body)
}

/// A body's name as a folder has it.
pub(crate) fn folder_name(name: &str) -> String {
    let plain = name.trim_start_matches("the ").to_lowercase();
    let words = plain.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let words = words.collect::<Vec<_>>().join("-");
    if words.is_empty() { "body".into() } else { words }
}
