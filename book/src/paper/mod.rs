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
            printed(&folder.join(format!("{name}-handout")), &paper.about, LINES, &|fit| {
                handout::sheet(&paper, name, arguments.paper, fit)
            })
        }),
        What::Problems { chapters } => each(&paper, chapters, |name| {
            ["problems", "answers"].iter().try_for_each(|sheet| {
                printed(&folder.join(format!("{name}-{sheet}")), &paper.about, 0, &|[fit, _]| {
                    problems::sheet(&paper, name, arguments.paper, fit, *sheet == "answers")
                })
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
        return paper.chapters().map(|page| page.name.as_str()).try_for_each(print);
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

/// How widely a sheet may be set, from the widest on: `fit-N` in `print.css`.
const FITS: usize = 8;

/// How many times three lines to write on are tried: as many as a page has.
const LINES: usize = 20;

/// Makes a sheet, set this closely, with three times this many lines to write on.
type Make<'a> = &'a dyn Fn([usize; 2]) -> Result<String, String>;

/// A sheet as HTML, and as PDF where a browser is found: on as few pages as the closest fit needs, as wide
/// as these pages allow, with as many lines of these to write on as they have room for.
fn printed(to: &Path, about: &About, lines: usize, make: Make<'_>) -> Result<(), String> {
    let (html, pdf) = (to.with_extension("html"), to.with_extension("pdf"));
    let Some(browser) = browser::found() else {
        write(&html, make([FITS / 2, 0])?.as_bytes())?;
        say!("{NO_BROWSER}");
        return Ok(());
    };
    let set = |fit: [usize; 2]| -> Result<Vec<u8>, String> {
        write_changed(&html, make(fit)?.as_bytes())?;
        browser::pdf(&browser, &html)
    };
    let fewest = browser::count(&set([FITS - 1, 0])?);
    let fits = |fit| Ok(browser::count(&set(fit)?) <= fewest);
    let fit = if fits([0, 0])? { 0 } else { 1 + first(FITS - 2, |fit| fits([fit + 1, 0]))? };
    let fewer = first(lines, |fewer| fits([fit, lines - fewer]))?;
    let printed = set([fit, lines - fewer])?;
    say!("{}", html.display());
    write(&pdf, &mended(printed, about))
}

/// The first number for which it holds, where it holds for all from there on and for `high`.
fn first(mut high: usize, holds: impl Fn(usize) -> Result<bool, String>) -> Result<usize, String> {
    let mut low = 0;
    while low < high {
        let middle = low.midpoint(high);
        (low, high) = if holds(middle)? { (low, middle) } else { (middle + 1, high) };
    }
    Ok(low)
}

#[cfg(test)]
mod tests;
