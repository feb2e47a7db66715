//! Films: pictures one after another, in few colours, each stored by what it changes.

mod apng;
mod changes;
mod gif;
mod palette;

pub use palette::Palette;

use crate::error::Error;
use crate::picture::Picture;
use changes::{Changes, Patch};

/// How a film is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// An animated PNG.
    Apng,
    /// A GIF.
    Gif,
}

/// A file of one format, as it grows.
trait Writer {
    fn add(&mut self, patch: &Patch) -> Result<(), Error>;

    fn finish(self: Box<Self>) -> Result<Vec<u8>, Error>;
}

/// A film that grows picture by picture, and starts again at its end.
pub struct Film {
    writer: Box<dyn Writer>,
    palette: Palette,
    changes: Changes,
}

impl Film {
    /// A film of `count` pictures of this size, each shown for `milliseconds`. A GIF counts in hundredths of
    /// a second, so that its pictures stay for ten milliseconds or a multiple.
    ///
    /// # Errors
    /// What the encoder reports, for instance of a size that the format does not have.
    pub fn new(
        format: Format,
        palette: Palette,
        size: [u32; 2],
        count: u32,
        milliseconds: u16,
    ) -> Result<Self, Error> {
        let writer: Box<dyn Writer> = match format {
            Format::Apng => Box::new(apng::Apng::new(&palette, size, count, milliseconds)?),
            Format::Gif => Box::new(gif::Gif::new(&palette, size, milliseconds)?),
        };
        Ok(Self { writer, palette, changes: Changes::new(size) })
    }

    /// Adds the next picture.
    ///
    /// # Errors
    /// A picture of another size, or what the encoder reports.
    pub fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        let patch = self.changes.patch(picture, &mut self.palette)?;
        self.writer.add(&patch)
    }

    /// The file.
    ///
    /// # Errors
    /// Fewer pictures than were announced, or what the encoder reports.
    pub fn finish(self) -> Result<Vec<u8>, Error> {
        self.writer.finish()
    }
}
