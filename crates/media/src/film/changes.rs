//! What of a picture differs from the one before.

use super::palette::{AS_BEFORE, Palette};
use crate::error::Error;
use crate::picture::Picture;

/// A rectangle of a picture in numbers of colours; where nothing changed, [`AS_BEFORE`].
pub(super) struct Patch {
    pub(super) left: u32,
    pub(super) top: u32,
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) numbers: Vec<u8>,
}

/// The picture that is shown so far.
pub(super) struct Changes {
    size: [u32; 2],
    shown: Vec<u8>,
}

impl Changes {
    pub(super) fn new(size: [u32; 2]) -> Self {
        Self { size, shown: Vec::new() }
    }

    /// The smallest rectangle that holds all changes; the whole of the first picture.
    pub(super) fn patch(&mut self, picture: &Picture, palette: &mut Palette) -> Result<Patch, Error> {
        let [width, height] = self.size;
        if [picture.width, picture.height] != self.size {
            return Err(Error(format!(
                "a picture of {} × {} pixels in a film of {width} × {height}",
                picture.width, picture.height
            )));
        }
        let next: Vec<u8> = picture.pixels.iter().map(|&colour| palette.nearest(colour)).collect();
        let before = std::mem::replace(&mut self.shown, next);
        let Some([left, top, right, bottom]) = bounds(&before, &self.shown, width as usize) else {
            // A film has no picture without pixels: one that stays the same is one pixel.
            return Ok(Patch { left: 0, top: 0, width: 1, height: 1, numbers: vec![AS_BEFORE] });
        };
        let mut numbers = Vec::with_capacity((right - left) * (bottom - top));
        for row in top..bottom {
            let places = row * width as usize + left..row * width as usize + right;
            let as_before = |at: usize| before.get(at) == Some(&self.shown[at]);
            numbers.extend(places.map(|at| if as_before(at) { AS_BEFORE } else { self.shown[at] }));
        }
        let [width, height] = [right - left, bottom - top].map(|x| x as u32);
        Ok(Patch { left: left as u32, top: top as u32, width, height, numbers })
    }
}

/// Left, top, right and bottom of all that differs; `None` if nothing does.
fn bounds(before: &[u8], after: &[u8], width: usize) -> Option<[usize; 4]> {
    let mut found: Option<[usize; 4]> = None;
    for (at, number) in after.iter().enumerate() {
        if before.get(at) != Some(number) {
            let (x, y) = (at % width, at / width);
            let [left, top, right, bottom] = found.unwrap_or([x, y, x + 1, y + 1]);
            found = Some([left.min(x), top.min(y), right.max(x + 1), bottom.max(y + 1)]);
        }
    }
    found
}
