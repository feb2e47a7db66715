//! Speaking with mdBook as a command: the book as JSON in, the changed book as JSON out.

use super::Preprocess;
use mdbook_preprocessor::errors::Result;
use mdbook_preprocessor::{Preprocessor, parse_input};
use std::io::{Read, Write};

/// Reads a book, changes it, and writes it.
///
/// # Errors
/// What the preprocessor found wrong, or that the input is not what mdBook sends.
pub fn answer(input: impl Read, mut output: impl Write) -> Result<()> {
    let (context, book) = parse_input(input)?;
    let book = Preprocess::Pages.run(&context, book)?;
    serde_json::to_writer(&mut output, &book)?;
    output.flush()?;
    Ok(())
}
