//! The book on paper: an EPUB, a PDF, handouts and sheets of problems.

pub(crate) mod browser;
mod ends;
mod epub;
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

use crate::say;
use crate::site::files::write_changed;
use crate::site::paths;
use pages::{About, Paper};
use sheet::Size;
use std::path::{Path, PathBuf};

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
    /// A chapter on one or two sheets, without programs: PDF, and HTML to print yourself
    Handout {
        /// The chapters, by the names of their pages, such as two-arrows; every chapter if not given
        #[arg(value_name = "CHAPTER")]
        chapters: Vec<String>,
    },
    /// Problems of a chapter for paper and pencil, answers on a sheet of their own: PDF, and HTML
    Problems {
        /// The chapters, by the names of their pages, such as two-arrows; every chapter if not given
        #[arg(value_name = "CHAPTER")]
        chapters: Vec<String>,
    },
}

/// What is said where no browser is found.
pub(crate) const NO_BROWSER: &str = "No Chromium, Chrome or Edge was found to print the PDF (the variable CHROMIUM can name one). \
                          Open the HTML in any browser, and print it from there.";

/// Writes what was asked for.
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
        What::Handout { chapters } => each(&paper, chapters, |name| {
            let stem = folder.join(format!("{name}-handout"));
            printed(&stem, &TRIES, &paper.about, |fit| handout::sheet(&paper, name, arguments.paper, fit))
        }),
        What::Problems { chapters } => each(&paper, chapters, |name| {
            let stem = folder.join(format!("{name}-problems"));
            printed(&stem, &[(0, usize::MAX)], &paper.about, |_| {
                problems::sheet(&paper, name, arguments.paper)
            })
        }),
    }
}

fn write(file: &Path, content: &[u8]) -> Result<(), String> {
    write_changed(file, content)?;
    say!("{}", file.display());
    Ok(())
}

/// Does it for these chapters, or for every one.
fn each(
    paper: &Paper,
    chapters: &[String],
    mut print: impl FnMut(&str) -> Result<(), String>,
) -> Result<(), String> {
    if chapters.is_empty() {
        let numbered = paper.pages.iter().filter(|page| page.number.is_some());
        return numbered.map(|page| page.name.as_str()).try_for_each(print);
    }
    // A name that is none is refused before anything is written.
    for name in chapters {
        sheet::chapter(paper, name)?;
    }
    chapters.iter().try_for_each(|name| print(name))
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

/// How closely a sheet may be set, from the widest on.
type Fit = usize;

/// How a sheet is tried, with the number of pages that will do: on one page, if it need not be too close.
const TRIES: [(Fit, usize); 7] = [(0, 1), (1, 1), (2, 1), (0, 2), (1, 2), (2, 2), (3, 2)];

/// How it is set where nothing counts the pages.
const UNCOUNTED: Fit = 1;

/// A sheet as HTML, and as PDF where a browser is found.
fn printed(
    stem: &Path,
    tries: &[(Fit, usize)],
    about: &About,
    make: impl Fn(Fit) -> Result<String, String>,
) -> Result<(), String> {
    let (html, pdf) = (stem.with_extension("html"), stem.with_extension("pdf"));
    let Some(browser) = browser::found() else {
        write(&html, make(UNCOUNTED)?.as_bytes())?;
        say!("{NO_BROWSER}");
        return Ok(());
    };
    let mut last = Vec::new();
    for &(fit, pages) in tries {
        write_changed(&html, make(fit)?.as_bytes())?;
        last = browser::pdf(&browser, &html)?;
        if browser::count(&last) <= pages {
            break;
        }
    }
    say!("{}", html.display());
    write(&pdf, &mended(last, about))
}

#[cfg(test)]
mod tests;
