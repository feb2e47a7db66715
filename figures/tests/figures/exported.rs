//! What an exported figure owes the programs that show it.

use crate::DRAWN;
use std::collections::BTreeSet;
use std::sync::LazyLock;
use tumbling_figures::{Figure, Theme, registry};
use tumbling_media::Drawing;

/// A figure in one of the themes, with all three in turn: as a plain document, and as read.
struct Exported {
    figure: &'static Figure,
    theme: Theme,
    plain: String,
    drawing: Drawing,
}

static ALL: LazyLock<Vec<Exported>> = LazyLock::new(|| {
    let export = |(figure, theme): (&'static Figure, Theme)| {
        let plain = theme.dressed(&DRAWN[figure.name]);
        let drawing = Drawing::read(&plain).unwrap_or_else(|e| panic!("{}: {e}", figure.name));
        Exported { figure, theme, plain, drawing }
    };
    registry().iter().zip(Theme::ALL.into_iter().cycle()).map(export).collect()
});

/// The colours that are said in full: `#rrggbb`.
fn colours(svg: &str) -> BTreeSet<[u8; 3]> {
    let hex = |at: usize| -> Option<[u8; 3]> {
        let channel = |i| u8::from_str_radix(svg.get(at + i..at + i + 2)?, 16).ok();
        Some([channel(1)?, channel(3)?, channel(5)?])
    };
    svg.match_indices('#').filter_map(|(at, _)| hex(at)).collect()
}

/// What is drawn, a line each: the sheet and the marks on it. A text says the colour of all text first, and
/// then its own.
fn marks(plain: &str) -> impl Iterator<Item = &str> {
    let drawn = |line: &&str| ["<path ", "<circle ", "<text "].iter().any(|tag| line.starts_with(tag));
    plain.lines().filter(drawn).map(|line| {
        let own = line.split('>').next().is_some_and(|tag| tag.contains("style=\"fill:"));
        if own { line.trim_start_matches("<text fill=\"#") } else { line }
    })
}

#[test]
fn an_exported_drawing_has_outlines_and_plain_colours_alone() {
    for Exported { figure, theme, plain, drawing } in ALL.iter() {
        let (name, svg) = (figure.name, drawing.svg(None));
        for foreign in ["var(", "currentColor", "<style", "style=", "<text", "font", "class=", "url("] {
            assert!(!svg.contains(foreign), "{name} has {foreign}");
        }
        let described = plain.split("</desc>").next().and_then(|head| head.rsplit('>').next()).unwrap();
        assert!(svg.contains(&format!("<title>{}</title>", figure.shows)), "{name}");
        assert!(svg.contains(&format!("<desc>{described}</desc>")), "{name}");
        // Every colour is an ink of the theme, and all that the drawing has are still there.
        let inks: BTreeSet<_> = theme.inks().into_iter().collect();
        assert!(colours(&svg).is_subset(&inks), "{name}: {:?}", colours(&svg));
        assert_eq!(colours(&svg), marks(plain).flat_map(colours).collect(), "{name}");
        // The letters are there: each text became outlines in the fonts that are carried.
        let texts = plain.matches("<text").count();
        assert!(texts == 0 || svg.matches("<path").count() > plain.matches("<path").count(), "{name}");
    }
}

#[test]
fn a_picture_has_the_width_that_was_requested_and_ink_of_every_colour() {
    for Exported { figure, plain, drawing, .. } in ALL.iter() {
        let [w, h] = drawing.size();
        let picture = drawing.picture(600).unwrap();
        let size = (600, (h * 600.0 / w).round() as u32);
        assert_eq!((picture.width, picture.height), size, "{}", figure.name);
        for ink in opaque(plain) {
            let near = |pixel: &[u8; 3]| pixel.iter().zip(ink).all(|(a, b)| a.abs_diff(b) <= 2);
            // A line thinner than two pixels has none in full, so it must have one where it is wider.
            let wider = || drawing.picture(1300).unwrap().pixels.iter().any(near);
            assert!(picture.pixels.iter().any(near) || wider(), "{}: no {ink:?}", figure.name);
        }
    }
}

/// The colours of marks that hide what is below them.
fn opaque(plain: &str) -> BTreeSet<[u8; 3]> {
    marks(plain).filter(|line| !line.contains("opacity")).flat_map(colours).collect()
}

#[test]
fn a_pdf_carries_its_fonts_and_says_what_it_shows() {
    for Exported { figure, plain, drawing, .. } in ALL.iter() {
        let pdf = drawing.pdf(Some(1000)).unwrap();
        let has = |what: &str| pdf.windows(what.len()).filter(|bytes| *bytes == what.as_bytes()).count();
        assert!(pdf.starts_with(b"%PDF-1."), "{}", figure.name);
        assert_eq!(has("/Title"), 1, "{}", figure.name);
        assert!(has("/MediaBox [0 0 750 ") == 1, "{}: 1000 pixels are 750 points", figure.name);
        let (fonts, files) = (has("/FontDescriptor /") + has("/Type /FontDescriptor"), has("/FontFile"));
        assert!(fonts > 0 || !plain.contains("<text"), "{}", figure.name);
        assert_eq!(has("/Type /FontDescriptor"), files, "{}: a font that is not embedded", figure.name);
        assert_eq!(has("/ToUnicode"), has("/Subtype /Type0"), "{}: text that cannot be copied", figure.name);
    }
}

#[test]
fn what_only_a_browser_understands_is_refused() {
    let svg = registry()[0].draw().unwrap();
    let refused = Drawing::read(&svg).unwrap_err().to_string();
    assert_eq!(refused, "the drawing has `var(`, which only a browser understands");
}
