//! A film, decoded again, shows the pictures that went in.

use tumbling_media::film::{Film, Palette};
use tumbling_media::{Picture, Rgb};

const INKS: [Rgb; 3] = [[255, 255, 255], [0, 104, 168], [168, 90, 0]];

/// A sheet of 12 × 7 with a block at `x`; none beyond the edge.
fn picture(x: u32) -> Picture {
    let inside = |i: u32| (x..x + 3).contains(&(i % 12)) && (2..5).contains(&(i / 12));
    let pixels = (0..12 * 7).map(|i| INKS[if inside(i) { 1 + (i % 2) as usize } else { 0 }]).collect();
    Picture { width: 12, height: 7, pixels }
}

/// It moves, stays, leaves, and comes back.
fn pictures() -> Vec<Picture> {
    [0, 1, 1, 40, 5].map(picture).into()
}

fn film() -> Vec<u8> {
    let palette = Palette::new(&INKS, &[], 8);
    let mut film = Film::new(palette, [12, 7], 50).unwrap();
    for picture in pictures() {
        film.add(&picture).unwrap();
    }
    film.finish().unwrap()
}

/// Puts a patch of numbers on the picture so far; number 0 leaves a pixel as it was.
fn put(shown: &mut [Rgb], place: [usize; 3], numbers: &[u8], colours: &[u8]) {
    let [left, top, width] = place;
    for (i, &number) in numbers.iter().enumerate().filter(|(_, number)| **number > 0) {
        let colour = &colours[3 * usize::from(number)..];
        shown[(top + i / width) * 12 + left + i % width] = [colour[0], colour[1], colour[2]];
    }
}

#[test]
fn a_gif_shows_its_pictures() {
    let file = film();
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::Indexed);
    let mut reader = options.read_info(file.as_slice()).unwrap();
    let colours = reader.global_palette().unwrap().to_vec();
    let mut shown = vec![[1; 3]; 12 * 7];
    for picture in pictures() {
        let frame = reader.read_next_frame().unwrap().unwrap();
        assert_eq!((frame.delay, frame.transparent), (5, Some(0)));
        let place = [frame.left, frame.top, frame.width].map(usize::from);
        put(&mut shown, place, &frame.buffer, &colours);
        assert_eq!(shown, picture.pixels);
    }
    assert!(reader.read_next_frame().unwrap().is_none());
}

#[test]
fn a_colour_that_is_not_in_the_palette_becomes_the_nearest() {
    let palette = Palette::new(&INKS, &[], 8);
    let mut film = Film::new(palette, [1, 1], 50).unwrap();
    film.add(&Picture { width: 1, height: 1, pixels: vec![[20, 90, 150]] }).unwrap();
    let file = film.finish().unwrap();
    let mut reader = gif::DecodeOptions::new().read_info(file.as_slice()).unwrap();
    // The first number is the transparent colour, the third the blue ink.
    assert_eq!(*reader.read_next_frame().unwrap().unwrap().buffer, [2]);
}

#[test]
fn a_picture_of_another_size_is_refused_in_a_sentence() {
    let mut film = Film::new(Palette::new(&INKS, &[], 8), [10, 7], 50).unwrap();
    let refused = film.add(&picture(0)).unwrap_err().to_string();
    assert_eq!(refused, "a picture of 12 × 7 pixels in a film of 10 × 7");
}
