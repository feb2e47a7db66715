//! Figures as files for other programs: slides, papers, printers.

use crate::command::body::folder_name;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::{Path, PathBuf};
use tumbling_bodies::BodyModel;
use tumbling_figures::{Figure, Theme};
use tumbling_media::Drawing;
use tumbling_site::draw::{each_made, none_or};
use tumbling_site::files::write_changed;
use tumbling_site::paths;
use tumbling_site::say;

/// Options for files of figures outside the book.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// Write files for other programs, in this format [default: svg]
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// The colours of those files [default: light]
    #[arg(long, value_parser = theme())]
    theme: Option<Theme>,
    /// Their width in pixels, 96 to the inch [default: 1600 of a png, otherwise as drawn]
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u32).range(16..=20_000))]
    width: Option<u32>,
    /// Each in the middle of a slide, 16 to 9
    #[arg(long)]
    slide: bool,
    /// Each in the middle of a square, for messengers
    #[arg(long, conflicts_with = "slide")]
    square: bool,
    /// The folder for those files [default: the one you are in, or of a body its own]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// Outlines and plain colours, for any program
    Svg,
    /// Pixels
    Png,
    /// One page, with text that can be copied
    Pdf,
}

/// The width of a PNG: a slide's, nearly.
const PNG_WIDTH: u32 = 1600;

/// A theme's name on the command line.
pub(crate) fn theme() -> impl TypedValueParser<Value = Theme> {
    PossibleValuesParser::new(Theme::ALL.map(Theme::name))
        .try_map(|name| Theme::ALL.into_iter().find(|theme| theme.name() == name).ok_or("no such theme"))
}

impl Arguments {
    /// Whether any of them was given.
    pub(crate) fn wanted(&self) -> bool {
        let given = [self.format.is_some(), self.theme.is_some(), self.width.is_some(), self.out.is_some()];
        self.slide || self.square || given.contains(&true)
    }
}

/// Writes these figures into the given folder: the book's own, or those of a body. With `all`, only figures
/// that follow a body and that this body has.
///
/// # Errors
/// If the folder is the one of the pages' own drawings; also the figures that could not be drawn or written,
/// after all others.
pub(crate) fn export(
    figures: &[&Figure],
    body: Option<&BodyModel>,
    all: bool,
    wanted: &Arguments,
) -> Result<(), String> {
    let of_body = |body: &BodyModel| paths::figures().join("of-bodies").join(folder_name(&body.name));
    let folder = wanted.out.clone().unwrap_or_else(|| body.map_or_else(|| ".".into(), of_body));
    own_folder_refused(&folder)?;
    let (format, theme) = (wanted.format.unwrap_or(Format::Svg), wanted.theme.unwrap_or(Theme::Light));
    let mut failures = Vec::new();
    let make = |figure: &Figure| {
        let svg = body.map_or_else(|| figure.draw(), |body| figure.draw_for(body));
        let svg = svg.map_err(|e| e.to_string())?;
        let svg = theme.dressed(&svg);
        let ground = wanted.slide || wanted.square;
        exported(&if ground { on_slide(&svg, theme, wanted.square)? } else { svg }, format, wanted.width)
    };
    let follows = |figure: &&Figure| body.is_none() || !all || figure.follows_a_body();
    let figures: Vec<&Figure> = figures.iter().copied().filter(follows).collect();
    each_made(
        figures.len(),
        |at| make(figures[at]),
        |at, made, _| {
            let figure = figures[at];
            let file = folder.join(format!("{}.{}", figure.name, format!("{format:?}").to_lowercase()));
            match made.and_then(|bytes| Ok((write_changed(&file, &bytes)?, bytes.len()))) {
                Ok((_, size)) => say!("  {}  {} kB", file.display(), size.div_ceil(1000)),
                Err(reason) if body.is_some() && all => say!("  {}: not drawn: {reason}", figure.name),
                Err(reason) => failures.push(format!("figure `{}`: {reason}", figure.name)),
            }
            Ok::<(), String>(())
        },
    )?;
    none_or(&failures)
}

/// The drawing in the middle of a slide of its theme's ground, 16 to 9 or square.
fn on_slide(svg: &str, theme: Theme, square: bool) -> Result<String, String> {
    let [w, h] = Drawing::read(svg).map_err(|e| e.to_string())?.size();
    let shape = if square { 1.0 } else { 16.0 / 9.0 };
    let (wide, high) = (w.max(h * shape), h.max(w / shape));
    let [r, g, b] = theme.inks()[0];
    let placed = format!("<svg x=\"{}\" y=\"{}\" ", (wide - w) / 2.0, (high - h) / 2.0);
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{wide}\" height=\"{high}\" viewBox=\"0 0 {wide} {high}\">\n\
         <path d=\"M0 0h{wide}v{high}h-{wide}z\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>\n{}</svg>\n",
        svg.replacen("<svg ", &placed, 1)
    ))
}

/// The bytes of one file.
fn exported(svg: &str, format: Format, width: Option<u32>) -> Result<Vec<u8>, String> {
    let drawing = Drawing::read(svg).map_err(|e| e.to_string())?;
    match format {
        Format::Svg => Ok(drawing.svg(width).into_bytes()),
        Format::Png => drawing.png(width.unwrap_or(PNG_WIDTH)).map_err(|e| e.to_string()),
        Format::Pdf => drawing.pdf(width).map_err(|e| e.to_string()),
    }
}

/// Exported drawings must not be among those of the pages.
pub(crate) fn own_folder_refused(folder: &Path) -> Result<(), String> {
    let [given, own] = [folder, &paths::figures()].map(|folder| folder.canonicalize().ok());
    if given.is_some() && given == own {
        let why = "holds the drawings that the pages take; choose another folder with --out";
        return Err(format!("{} {why}", folder.display()));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use tumbling_site::files;

    #[test]
    fn by_day_and_by_night_the_colours_are_those_of_the_pages() {
        let sheet = fs::read_to_string(paths::book().join("theme/palette.css")).unwrap();
        for (theme, selector) in
            [(Theme::Light, ".light, html:not(.js) {"), (Theme::Navy, ".coal, .navy, .ayu {")]
        {
            let rules = sheet.split(selector).nth(1).unwrap().split('}').next().unwrap();
            let colours: Vec<_> = rules.lines().filter_map(|line| line.trim().split_once(": ")).collect();
            let inks: Vec<_> = colours.iter().filter(|(name, _)| name.starts_with("--fig-")).collect();
            assert_eq!(inks.len(), 7, "{theme:?}");
            for (property, colour) in inks {
                let dressed = theme.dressed(&format!("var({property},none)"));
                assert_eq!(dressed, colour.trim_end_matches(';'), "{theme:?} {property}");
            }
        }
    }

    #[test]
    fn a_slide_is_sixteen_to_nine_or_square_whatever_the_figure_is() {
        for (name, high) in [("three-tosses", 180), ("two-arrows", 180), ("three-tosses", 320)] {
            let svg = files::text(&paths::figures().join(format!("{name}.svg"))).unwrap();
            let slide = on_slide(&Theme::Navy.dressed(&svg), Theme::Navy, high == 320).unwrap();
            let picture = Drawing::read(&slide).unwrap().picture(320).unwrap();
            assert_eq!((picture.height, picture.pixels[0]), (high, Theme::Navy.inks()[0]), "{name}");
        }
    }
}
