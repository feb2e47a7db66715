//! Every figure of the book, drawn by plotters from what the library computes.
//!
//! [`registry`] lists them; asking one to [`draw`](Figure::draw) computes and draws only that one.
//! A drawing is a complete SVG document, the same bytes on every run, with a title and a
//! description inside that say what it shows. Its colours are custom properties (`--fig-omega` for the spin,
//! `--fig-momentum`, `--fig-axis-min`, `--fig-axis-mid`, `--fig-axis-max`, `--fig-separatrix`, `--fig-wrong`,
//! `--fig-surface`, `--fig-paper`, `--fig-faint`; everything else is `currentColor`), so that a page
//! which holds it sets them; opened by itself it has its own, for a light and for a dark ground.

mod draw;
mod figures;
mod ink;
mod motion;
mod verdict;

pub use verdict::verdict;

/// One figure of the book.
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Short name, also the name of its file: `figures/NAME.svg`.
    pub name: &'static str,
    /// What it shows, in one line.
    pub shows: &'static str,
    /// The chapter's file name without its ending, for instance `two-arrows`.
    pub chapter: &'static str,
    draw: fn() -> Result<figures::Picture, Box<dyn std::error::Error>>,
}

impl Figure {
    /// Computes and draws this figure: a complete SVG document, without an XML header.
    ///
    /// # Errors
    /// What the library or the drawing backend reported.
    pub fn draw(&self) -> Result<String, Box<dyn std::error::Error>> {
        let figures::Picture { canvas, description } = (self.draw)()?;
        Ok(canvas.finish(self.name, self.shows, &figures::with_powers(&description)))
    }
}

/// Every figure, in the order of the book.
#[must_use]
pub fn registry() -> &'static [Figure] {
    &figures::ALL
}
