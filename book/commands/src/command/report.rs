//! The command `report`: one page on a body, as HTML and as PDF.

use crate::command::body::{body, folder_name};
use crate::paper::sheet::fonts;
use crate::paper::{NO_BROWSER, browser};
use clap::Args;
use std::error::Error;
use std::path::PathBuf;
use tumbling_bodies::BodyModel;
use tumbling_site::files::write_changed;
use tumbling_site::say;

/// Which body, and where its page goes.
#[derive(Debug, Args)]
pub(crate) struct Arguments {
    /// A name such as `phone` or `hammer`, a TOML file, or FILE.urdf#LINK
    #[arg(value_parser = body)]
    body: BodyModel,
    /// With the step that an engine needs for it
    #[arg(long)]
    engine: bool,
    /// The folder; the present one if not given
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
}

/// Writes the page, and its print where a browser is installed: the same text and drawings, tagged, on one
/// sheet.
///
/// # Errors
/// A body that cannot be computed with, or a file that cannot be written.
pub(crate) fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let html = arguments.out.join(format!("{}.html", folder_name(&arguments.body.name)));
    let page = tumbling_figures::report(&arguments.body, arguments.engine)?;
    // The book's letters travel with the page.
    write_changed(&html, page.replacen("<style>", &format!("<style>{}", fonts()?), 1).as_bytes())?;
    say!("{}", html.display());
    let Some(browser) = browser::found() else {
        say!("{NO_BROWSER} It fits one sheet.");
        return Ok(());
    };
    let pdf = html.with_extension("pdf");
    write_changed(&pdf, &browser::pdf(&browser, &html)?)?;
    say!("{}", pdf.display());
    Ok(())
}
