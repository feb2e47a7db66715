//! A drawing in pixels.

use crate::drawing::{Drawing, plain};
use crate::error::Error;
use resvg::tiny_skia::{Color, Pixmap, Transform};

/// Red, green, blue.
pub type Rgb = [u8; 3];

/// Pixels without transparency, row by row from the upper left.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// One for each pixel.
    pub pixels: Vec<Rgb>,
}

impl Drawing {
    /// The drawing as a picture of this width in pixels; where nothing is drawn it is white.
    ///
    /// # Errors
    /// No pixels, or more than the memory limit allows.
    pub fn picture(&self, width: u32) -> Result<Picture, Error> {
        let [w, h] = self.size();
        let scale = (f64::from(width) / w) as f32;
        let height = (h * f64::from(width) / w).round() as u32;
        let too_many = || Error(format!("{width} × {height} pixels are no picture, or too large a one"));
        // A limit on memory: 700 megabytes for the pixmap and its copy.
        if u64::from(width) * u64::from(height) > 100_000_000 {
            return Err(too_many());
        }
        let mut pixmap = Pixmap::new(width, height).ok_or_else(too_many)?;
        pixmap.fill(Color::WHITE);
        resvg::render(&self.tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
        // On white everything is opaque, so nothing needs dividing by its opacity.
        let pixels = pixmap.data().chunks_exact(4).map(|p| [p[0], p[1], p[2]]).collect();
        Ok(Picture { width, height, pixels })
    }

    /// As a PNG file of this width in pixels, with its title and description.
    ///
    /// # Errors
    /// As [`picture`](Self::picture).
    pub fn png(&self, width: u32) -> Result<Vec<u8>, Error> {
        let words = [("Title", &self.title), ("Description", &self.description)];
        let words = words.into_iter().filter(|(_, said)| !said.is_empty());
        self.picture(width)?.png(&words.map(|(name, said)| (name, plain(said))).collect::<Vec<_>>())
    }
}

impl Picture {
    /// As a PNG file with these words.
    ///
    /// # Errors
    /// What the encoder reports.
    pub fn png(&self, words: &[(&str, String)]) -> Result<Vec<u8>, Error> {
        let failed = |e: png::EncodingError| Error::new("the PNG", e);
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_adaptive_filter(png::AdaptiveFilterType::Adaptive);
        for (keyword, text) in words {
            encoder.add_itxt_chunk((*keyword).to_owned(), text.clone()).map_err(failed)?;
        }
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(self.pixels.as_flattened()).map_err(failed)?;
        writer.finish().map_err(failed)?;
        Ok(file)
    }
}
