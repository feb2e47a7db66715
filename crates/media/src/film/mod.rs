//! Films: pictures one after another, in few colours, each stored by what it changes. They are GIFs, which
//! slide programs, messengers and pages all play.

mod changes;
mod gif;
mod palette;

pub use palette::Palette;

use crate::error::Error;
use crate::picture::Picture;
use changes::{Changes, Patch};
use gif::Gif;

/// A film that grows picture by picture, and starts again at its end.
pub struct Film {
    writer: Gif,
    palette: Palette,
    changes: Changes,
}

impl Film {
    /// A film of pictures of this size, each shown for `milliseconds`, which count in tens.
    ///
    /// # Errors
    /// What the encoder reports, for instance of a size that the format does not have.
    pub fn new(palette: Palette, size: [u32; 2], milliseconds: u16) -> Result<Self, Error> {
        let writer = Gif::new(&palette, size, milliseconds)?;
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
    /// What the encoder reports.
    pub fn finish(self) -> Result<Vec<u8>, Error> {
        self.writer.finish()
    }
}
