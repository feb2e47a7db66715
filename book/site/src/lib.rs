//! The site: the book's figures and pages, their addresses, where its files lie, and what it says of itself.

pub mod build;
pub mod digits;
pub mod docs;
pub mod draw;
pub mod files;
pub mod goals;
pub mod home;
pub mod language;
mod log;
pub mod paths;
pub mod places;
pub mod preprocess;
pub mod share;
pub mod spelled;

use std::time::Instant;

/// Writes a line to standard output. A reader that went away (`| head`) is no reason to stop, nor to
/// complain: the work goes on.
#[macro_export]
macro_rules! say {
    ($($arg:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stdout().lock(), $($arg)*);
    }};
}

/// Writes a line to standard error.
#[macro_export]
macro_rules! complain {
    ($($arg:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr().lock(), $($arg)*);
    }};
}

/// Draws all figures, and makes the documentation and the pages.
///
/// # Errors
/// What went wrong, in words for the user.
pub fn everything() -> Result<(), String> {
    let start = Instant::now();
    draw::draw(&tumbling_figures::registry().iter().collect::<Vec<_>>(), &paths::figures())?;
    docs::make()?;
    build::build(None)?;
    say!("All done in {:.1} s. Open", start.elapsed().as_secs_f64());
    say!("{}", paths::pages().join("index.html").display());
    Ok(())
}
