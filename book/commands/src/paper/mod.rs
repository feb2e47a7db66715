//! The book on paper: an EPUB, a PDF, handouts and sheets of problems.

pub(crate) mod browser;
mod ends;
mod epub;
mod fitted;
mod handout;
mod ink;
mod mend;
mod numbers;
mod page;
mod pages;
mod problems;
pub(crate) mod sheet;
mod still;
mod title;
mod tree;

use pages::{About, Paper};
use sheet::Size;
use std::path::{Path, PathBuf};
use tumbling_site::files::write_changed;
use tumbling_site::paths;
use tumbling_site::say;

#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    what: What,
    /// The folder to write to; book/print if not given
    #[arg(long, value_name = "DIR", global = true)]
    out: Option<PathBuf>,
    /// The size of the paper
    #[arg(long, value_enum, default_value_t, global = true)]
    paper: Size,
}

#[derive(Debug, clap::Subcommand)]
enum What {
    /// The whole book as an EPUB, for readers and tablets
    Epub,
    /// The whole book as a PDF, printed by an installed Chromium, Chrome or Edge
    Pdf,
    /// A chapter as a handout, without programs, with its sources: PDF, and HTML to print yourself
    Handout {
        /// The chapters, by the names of their pages, such as two-arrows; every chapter if not given
        #[arg(value_name = "CHAPTER")]
        chapters: Vec<String>,
    },
    /// Problems of a chapter for paper and pencil, and a second sheet with their answers: PDF, and HTML
    Problems {
        /// The chapters, by the names of their pages, such as two-arrows; every chapter if not given
        #[arg(value_name = "CHAPTER")]
        chapters: Vec<String>,
    },
}

/// The message if no browser is found.
pub(crate) const NO_BROWSER: &str = "No Chromium, Chrome or Edge was found to print the PDF (the variable CHROMIUM can name one). \
                          Open the HTML in any browser, and print it from there.";

/// Writes the requested files.
///
/// # Errors
/// What is wrong with the book, or a file that cannot be written.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let folder = arguments.out.clone().unwrap_or_else(|| paths::book().join("print"));
    let paper = Paper::read()?;
    match &arguments.what {
        What::Epub => {
            let file = folder.join("tumbling.epub");
            write(&file, &epub::file(&paper)?)
        }
        What::Pdf => book(&paper, arguments.paper, &folder),
        What::Handout { chapters } => fitted::print(&paper, chapters, &["handout"], arguments.paper, &folder),
        What::Problems { chapters } => {
            fitted::print(&paper, chapters, &["problems", "answers"], arguments.paper, &folder)
        }
    }
}

fn write(file: &Path, content: &[u8]) -> Result<(), String> {
    write_changed(file, content)?;
    say!("{}", file.display());
    Ok(())
}

/// The whole book. It is printed twice: the second time, the contents have the numbers of the pages.
fn book(paper: &Paper, size: Size, folder: &Path) -> Result<(), String> {
    let html = folder.join("tumbling.html");
    write(&html, sheet::book(paper, size, &|_| None)?.as_bytes())?;
    let Some(browser) = browser::found() else {
        say!("{NO_BROWSER}");
        return Ok(());
    };
    let first = browser::pdf(&browser, &html)?;
    let places = numbers::of(&first);
    write_changed(&html, sheet::book(paper, size, &|place| places.get(place).copied())?.as_bytes())?;
    write(&folder.join("tumbling.pdf"), &mended(browser::pdf(&browser, &html)?, &paper.about))
}

/// A printed file with what the browser leaves out, or as it is.
fn mended(printed: Vec<u8>, about: &About) -> Vec<u8> {
    mend::mended(&printed, about).unwrap_or_else(|what| {
        say!("The PDF is as the browser printed it, without the metadata of PDF/UA: {what}.");
        printed
    })
}

#[cfg(test)]
mod tests;
