//! Every figure of the book, drawn by plotters from what the library computes.
//!
//! [`registry`] lists them; [`draw`](Figure::draw) computes and draws one of them. A drawing is a complete
//! SVG document, the same bytes on every run, with a title and a description of what it shows. Its colours
//! are custom properties (`--fig-omega` for the spin, `--fig-momentum`, `--fig-axis-min`, `--fig-axis-mid`,
//! `--fig-axis-max`, `--fig-separatrix`, `--fig-wrong`, `--fig-surface`, `--fig-paper`, `--fig-faint`;
//! everything else is `currentColor`), so that the page that contains it sets them. A drawing opened on its
//! own has default colours for a light and for a dark background.

mod draw;
mod figures;
pub mod film;
mod ink;
mod motion;
mod of_body;
mod picture;
mod report;
mod stills;
mod theme;
mod units;

pub use report::report;
pub use stills::still;
pub use theme::Theme;
use tumbling_bodies::BodyModel;

/// One figure of the book.
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Short name, also the name of its file: `figures/NAME.svg`.
    pub name: &'static str,
    /// What it shows, in one line.
    pub shows: &'static str,
    /// The chapter's file name without its ending, for instance `two-arrows`.
    pub chapter: &'static str,
    draw: fn() -> Result<picture::Picture, Box<dyn std::error::Error>>,
    /// How it is drawn for another body, if it shows a body and not a record, a rule or an example of the
    /// book.
    of_body: Option<Follows>,
}

/// A figure that follows a body.
#[derive(Debug, Clone, Copy)]
struct Follows {
    /// What it shows of the body, in one line.
    shows: &'static str,
    draw: fn(&of_body::Subject<'_>) -> picture::Drawing,
}

impl Figure {
    /// Computes and draws this figure: a complete SVG document, without an XML header.
    ///
    /// # Errors
    /// What the library or the drawing backend reported.
    pub fn draw(&self) -> Result<String, Box<dyn std::error::Error>> {
        let picture::Picture { canvas, description } = (self.draw)()?;
        Ok(canvas.finish(self.name, self.shows, &picture::with_powers(&description)))
    }

    /// Draws the figure for another body, with that body's numbers and shape and with suitable units and
    /// ticks.
    ///
    /// # Errors
    /// That the figure does not show a body, or that the body lacks what it shows; or the error of the
    /// library.
    pub fn draw_for(&self, body: &BodyModel) -> Result<String, Box<dyn std::error::Error>> {
        let picture::Picture { canvas, description } = self.picture_of(body)??;
        let shows = self.of_body.map_or(self.shows, |follows| follows.shows);
        let title = format!("{}: {shows}", body.name);
        Ok(canvas.finish(self.name, &title, &picture::with_powers(&description)))
    }

    /// The area of labels that overlap other labels or leave the sheet, if the figure can be drawn for this
    /// body.
    #[must_use]
    pub fn overlap_for(&self, body: &BodyModel) -> Option<f64> {
        Some(self.picture_of(body).ok()?.ok()?.canvas.over.get())
    }

    fn picture_of(&self, body: &BodyModel) -> Result<picture::Drawing, String> {
        let follows =
            self.of_body.ok_or("it shows a record, a rule or the book's own example, not one body")?;
        let subject = of_body::Subject::new(body).map_err(|error| error.to_string())?;
        Ok((follows.draw)(&subject))
    }

    /// Whether the figure can be drawn for another body.
    #[must_use]
    pub fn follows_a_body(&self) -> bool {
        self.of_body.is_some()
    }
}

/// Every figure, in the order of the book.
#[must_use]
pub fn registry() -> &'static [Figure] {
    figures::ALL
}
