//! Animated PNG.

use super::palette::Palette;
use super::{Patch, Writer};
use crate::error::Error;
use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

/// The file as it grows: the encoder owns one end of it, and keeps it.
#[derive(Clone, Default)]
struct Shared(Arc<Mutex<Vec<u8>>>);

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

pub(super) struct Apng {
    file: Shared,
    encoder: png::Writer<Shared>,
}

fn failed(e: png::EncodingError) -> Error {
    Error::new("the APNG", e)
}

impl Apng {
    pub(super) fn new(
        palette: &Palette,
        size: [u32; 2],
        count: u32,
        milliseconds: u16,
    ) -> Result<Self, Error> {
        let file = Shared::default();
        let mut encoder = png::Encoder::new(file.clone(), size[0], size[1]);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette.bytes());
        encoder.set_trns(vec![0]);
        encoder.set_compression(png::Compression::Best);
        encoder.set_filter(png::FilterType::NoFilter);
        encoder.set_animated(count, 0).map_err(failed)?;
        encoder.set_frame_delay(milliseconds, 1000).map_err(failed)?;
        encoder.set_blend_op(png::BlendOp::Over).map_err(failed)?;
        encoder.set_dispose_op(png::DisposeOp::None).map_err(failed)?;
        encoder.validate_sequence(true);
        Ok(Self { encoder: encoder.write_header().map_err(failed)?, file })
    }
}

impl Writer for Apng {
    fn add(&mut self, patch: &Patch) -> Result<(), Error> {
        let mut add = || {
            self.encoder.reset_frame_position()?;
            self.encoder.set_frame_dimension(patch.width, patch.height)?;
            self.encoder.set_frame_position(patch.left, patch.top)?;
            self.encoder.write_image_data(&patch.numbers)
        };
        add().map_err(failed)
    }

    fn finish(self: Box<Self>) -> Result<Vec<u8>, Error> {
        self.encoder.finish().map_err(failed)?;
        Ok(std::mem::take(&mut *self.file.0.lock().unwrap_or_else(PoisonError::into_inner)))
    }
}
