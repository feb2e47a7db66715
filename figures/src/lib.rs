//! Every figure of the book, drawn by plotters from what the library computes.
//!
//! [`registry`] lists them; asking one to [`draw`](Figure::draw) computes and draws only that one.
//! A drawing is a complete SVG document, the same bytes on every run, with a title and a
//! description inside that say what it shows.

/// One figure of the book.
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Short name, also the name of its file: `figures/NAME.svg`.
    pub name: &'static str,
    /// What it shows, in one line.
    pub shows: &'static str,
    /// The chapter's file name without its ending, for instance `two-arrows`.
    pub chapter: &'static str,
    draw: fn() -> Result<String, Box<dyn std::error::Error>>,
}

impl Figure {
    /// Computes and draws this figure: a complete SVG document, without an XML header.
    ///
    /// # Errors
    /// What the library or the drawing backend reported.
    pub fn draw(&self) -> Result<String, Box<dyn std::error::Error>> {
        (self.draw)()
    }
}

/// Every figure, in the order of the book.
#[must_use]
pub fn registry() -> &'static [Figure] {
    &[]
}
