//! GIF.

use super::Patch;
use super::palette::{AS_BEFORE, Palette};
use crate::error::Error;
use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

pub(super) struct Gif {
    encoder: Encoder<Vec<u8>>,
    hundredths: u16,
}

fn failed(e: EncodingError) -> Error {
    Error::new("the GIF", e)
}

fn short(x: u32) -> Result<u16, Error> {
    u16::try_from(x).map_err(|_| Error(format!("a GIF has at most 65535 pixels from side to side, not {x}")))
}

impl Gif {
    pub(super) fn new(palette: &Palette, size: [u32; 2], milliseconds: u16) -> Result<Self, Error> {
        let (width, height) = (short(size[0])?, short(size[1])?);
        let mut encoder = Encoder::new(Vec::new(), width, height, &palette.bytes()).map_err(failed)?;
        encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
        Ok(Self { encoder, hundredths: (milliseconds + 5) / 10 })
    }

    pub(super) fn add(&mut self, patch: &Patch) -> Result<(), Error> {
        let frame = Frame {
            delay: self.hundredths,
            dispose: DisposalMethod::Keep,
            transparent: Some(AS_BEFORE),
            left: short(patch.left)?,
            top: short(patch.top)?,
            width: short(patch.width)?,
            height: short(patch.height)?,
            buffer: patch.numbers.as_slice().into(),
            ..Frame::default()
        };
        self.encoder.write_frame(&frame).map_err(failed)
    }

    pub(super) fn finish(self) -> Result<Vec<u8>, Error> {
        self.encoder.into_inner().map_err(|e| Error::new("the GIF", e))
    }
}
