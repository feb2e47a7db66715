//! The command `report`: one page on a body, as HTML and as PDF.

use crate::command::draw::folder_name;
use crate::say;
use crate::site::files::write_changed;
use clap::Args;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use tumbling_bodies::BodyModel;

/// Which body, and where its page goes.
#[derive(Debug, Args)]
pub(crate) struct Arguments {
    /// A name such as `phone` or `hammer`, a TOML file, or FILE.urdf#LINK
    #[arg(value_parser = BodyModel::load)]
    body: BodyModel,
    /// The folder; the present one if not given
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
}

/// Browsers that print a page to a file, by the names of their programs.
const BROWSERS: [&str; 5] =
    ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];

/// Writes the page, and its print where a browser is installed: the same text and drawings, tagged, on one
/// sheet.
///
/// # Errors
/// A body that cannot be computed with, or a file that cannot be written.
pub(crate) fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let html = arguments.out.join(format!("{}.html", folder_name(&arguments.body.name)));
    write_changed(&html, tumbling_figures::report(&arguments.body)?.as_bytes())?;
    say!("{}", html.display());
    let pdf = html.with_extension("pdf");
    if BROWSERS.iter().any(|browser| printed(browser, &html, &pdf)) {
        say!("{}", pdf.display());
    } else {
        say!(
            "No PDF: none of {} is installed. Printed from any browser, the page fits one sheet.",
            BROWSERS.join(", ")
        );
    }
    Ok(())
}

/// Whether this browser printed the page.
fn printed(browser: &str, html: &Path, pdf: &Path) -> bool {
    let Ok(page) = html.canonicalize() else { return false };
    let print = |more: &[&str]| {
        let _ = std::fs::remove_file(pdf);
        let mut command = Command::new(browser);
        command.args(["--headless", "--disable-gpu", "--no-pdf-header-footer"]).args(more);
        command.arg(format!("--print-to-pdf={}", pdf.display())).arg(format!("file://{}", page.display()));
        command.output().is_ok() && pdf.is_file()
    };
    // As root, in a container, a browser starts only without its sandbox; the page is our own and has no
    // scripts.
    print(&[]) || print(&["--no-sandbox"])
}
