//! The facts file: numbers that no computation can produce, each with the words around it.

use serde::Deserialize;

/// The whole file.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    fact: Vec<Fact>,
}

/// One number and its source.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Fact {
    /// The chapter, by its file's name without ending.
    pub(crate) chapter: String,
    /// The words in the chapter that say it.
    pub(crate) text: String,
    pub(crate) source: String,
    pub(crate) certainty: String,
}

/// Reads the facts.
///
/// # Errors
/// A fault in the file, or in one of its facts.
pub(crate) fn read(text: &str) -> Result<Vec<Fact>, String> {
    let facts = toml::from_str::<File>(text).map_err(|e| e.to_string())?.fact;
    for fact in &facts {
        let says = fact.text.as_str();
        if !["certain", "attested", "legend"].contains(&fact.certainty.as_str()) {
            return Err(format!(
                "the fact `{says}` is `{}`, not certain, attested or legend",
                fact.certainty
            ));
        }
        if fact.source.trim().is_empty() || says.trim().is_empty() {
            return Err(format!("the fact `{says}` has no source or no text"));
        }
    }
    Ok(facts)
}
