//! Films: sequences of pictures with few colours, in which each picture stores only its changes. They are
//! GIFs, which presentation programs, messengers and web pages all play.

mod palette;

pub use palette::Palette;

use crate::error::Error;
use crate::picture::Picture;
use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};
use palette::AS_BEFORE;

/// A film that grows picture by picture, and starts again at its end.
pub struct Film {
    encoder: Encoder<Vec<u8>>,
    hundredths: u16,
    palette: Palette,
    size: [u16; 2],
    /// The numbers of the colours that are shown so far.
    shown: Vec<u8>,
}

fn failed(e: EncodingError) -> Error {
    Error::new("the GIF", e)
}

impl Film {
    /// A film of pictures of this size, each shown for `milliseconds`, which count in tens.
    ///
    /// # Errors
    /// An error of the encoder, or a size that the format does not support.
    pub fn new(palette: Palette, size: [u32; 2], milliseconds: u16) -> Result<Self, Error> {
        let [Ok(width), Ok(height)] = size.map(u16::try_from) else {
            return Err(Error(format!("a GIF has at most 65535 pixels from side to side, not {size:?}")));
        };
        let mut encoder = Encoder::new(Vec::new(), width, height, &palette.bytes()).map_err(failed)?;
        encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
        let hundredths = milliseconds.saturating_add(5) / 10;
        Ok(Self { encoder, hundredths, palette, size: [width, height], shown: Vec::new() })
    }

    /// Adds the next picture: the smallest rectangle that contains all changes, or the whole picture if it is
    /// the first.
    ///
    /// # Errors
    /// A picture of another size, or what the encoder reports.
    pub fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        let ([own, tall], [width, height]) = ([picture.width, picture.height], self.size.map(u32::from));
        if [own, tall] != [width, height] {
            return Err(Error(format!("a picture of {own} × {tall} pixels in a film of {width} × {height}")));
        }
        // Most neighbours have one colour, which is then looked up once.
        let runs = picture.pixels.chunk_by(PartialEq::eq);
        let next: Vec<u8> = runs.flat_map(|run| vec![self.palette.nearest(run[0]); run.len()]).collect();
        let before = std::mem::replace(&mut self.shown, next);
        let wide = usize::from(self.size[0]);
        // A film has no picture without pixels: one that stays the same is one pixel.
        let [left, top, right, bottom] = bounds(&before, &self.shown, wide).unwrap_or([0, 0, 1, 1]);
        let places = (top..bottom).flat_map(|row| row * wide + left..row * wide + right);
        let number = |at| if before.get(at) == self.shown.get(at) { AS_BEFORE } else { self.shown[at] };
        let frame = Frame {
            delay: self.hundredths,
            dispose: DisposalMethod::Keep,
            transparent: Some(AS_BEFORE),
            left: left as u16,
            top: top as u16,
            width: (right - left) as u16,
            height: (bottom - top) as u16,
            buffer: places.map(number).collect(),
            ..Frame::default()
        };
        self.encoder.write_frame(&frame).map_err(failed)
    }

    /// The file.
    ///
    /// # Errors
    /// What the encoder reports.
    pub fn finish(self) -> Result<Vec<u8>, Error> {
        self.encoder.into_inner().map_err(|e| Error::new("the GIF", e))
    }
}

/// Left, top, right and bottom of all that differs; `None` if nothing does.
fn bounds(before: &[u8], after: &[u8], width: usize) -> Option<[usize; 4]> {
    let mut found: Option<[usize; 4]> = None;
    for at in (0..after.len()).filter(|&at| before.get(at) != after.get(at)) {
        let (x, y) = (at % width, at / width);
        let [left, top, right, bottom] = found.unwrap_or([x, y, x + 1, y + 1]);
        found = Some([left.min(x), top.min(y), right.max(x + 1), bottom.max(y + 1)]);
    }
    found
}
