//! Films of a body in free motion.

use crate::command::draw::each_made;
use crate::command::export::{own_folder_refused, theme};
use crate::say;
use crate::site::files::write_changed;
use std::error::Error;
use std::f64::consts::TAU;
use std::io::{IsTerminal as _, Write as _, stderr};
use std::path::{Path, PathBuf};
use tumbling::Axis;
use tumbling_bodies::BodyModel;
use tumbling_figures::Theme;
use tumbling_figures::film::{Camera, Film, Request, SHEET};
use tumbling_media::film::{Film as Writer, Format as Kind, Palette};
use tumbling_media::{Drawing, Picture};

/// What a film shows, and how it is written.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// A body of the book (book, phone, hammer, ...), or a file: FILE.toml, FILE.urdf#LINK
    #[arg(value_name = "BODY")]
    body: String,
    /// The principal axis that it spins about
    #[arg(long, value_enum, default_value_t = About::Middle)]
    axis: About,
    /// The spin: 6 or 6rad/s, 1turn or 2turns (a second) [default: what the body's file says, or 1turn]
    #[arg(long, value_name = "SPIN", value_parser = spin, allow_negative_numbers = true)]
    spin: Option<f64>,
    /// The spin across that axis, as a share of it [default: near 0.02, such that the film closes]
    #[arg(long, value_name = "SHARE", allow_negative_numbers = true)]
    push: Option<f64>,
    /// How long the film takes; a turn of the spin takes a second [default: until the motion starts again]
    #[arg(long, value_name = "S")]
    seconds: Option<f64>,
    /// From where it is seen [default: from the room, or turning with the momentum where only that closes]
    #[arg(long, value_enum)]
    camera: Option<Seen>,
    /// apng for slides and pages, gif for old programs, frames for a video
    #[arg(long, value_enum, default_value_t = Format::Apng)]
    format: Format,
    /// In pixels
    #[arg(long, value_name = "PX", default_value_t = SHEET[0], value_parser = clap::value_parser!(u32).range(64..=4096))]
    width: u32,
    /// The colours
    #[arg(long, value_parser = theme(), default_value = Theme::Light.name())]
    theme: Theme,
    /// The folder for the film
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum About {
    Smallest,
    Middle,
    Largest,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Seen {
    /// At rest
    Room,
    /// Riding along
    Body,
    /// Turning about the momentum so that the film closes
    Momentum,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    Apng,
    Gif,
    Frames,
}

/// Pictures a second; in hundredths of a second, as GIF counts, a whole number.
const RATE: f64 = 20.0;

/// As many colours as a film of a few hundred kilobytes has.
const COLOURS: usize = 64;

/// A spin in rad/s or in turns a second.
fn spin(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let at = text.find(|c: char| c.is_ascii_alphabetic() && c != 'e' && c != 'E').unwrap_or(text.len());
    let (number, unit) = text.split_at(at);
    let value: Option<f64> = number.trim().parse().ok().filter(|x: &f64| x.is_finite());
    let per_second = match unit {
        "" | "rad" | "rad/s" => Some(1.0),
        "turn" | "turns" | "turn/s" | "turns/s" => Some(TAU),
        _ => None,
    };
    value.zip(per_second).map(|(x, unit)| x * unit).ok_or_else(|| {
        "a spin is a number of rad/s or of turns a second, such as 6, 6rad/s, 1turn or 2.5turns".into()
    })
}

impl Arguments {
    fn request(&self, model: &BodyModel) -> Request {
        Request {
            axis: match self.axis {
                About::Smallest => Axis::Smallest,
                About::Middle => Axis::Middle,
                About::Largest => Axis::Largest,
            },
            spin: self.spin.or(model.spin).unwrap_or(TAU),
            push: self.push,
            seconds: self.seconds,
            camera: self.camera.map(|seen| match seen {
                Seen::Room => Camera::Room,
                Seen::Body => Camera::Body,
                Seen::Momentum => Camera::Momentum,
            }),
        }
    }

    /// The name of the film's file, without its ending.
    fn name(&self) -> String {
        let file =
            Path::new(&self.body).file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned());
        let mut name: String = file.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
        if self.axis != About::Middle {
            name.push_str(if self.axis == About::Smallest { "-smallest" } else { "-largest" });
        }
        name
    }
}

/// Draws the film and writes it.
///
/// # Errors
/// A body that cannot be read, a spin that it cannot have, a folder that cannot be written.
pub(crate) fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    own_folder_refused(&arguments.out)?;
    let model = BodyModel::load(&arguments.body)?;
    let film = Film::new(&model, &arguments.request(&model))?;
    say!("{}", film.explained()?);
    let count = (film.seconds() * RATE).round().clamp(2.0, 12_000.0) as u32;
    let shown = |i: u32| picture(&film, f64::from(i) / f64::from(count), arguments);
    let written = match arguments.format {
        Format::Frames => frames(arguments, count, &shown)?,
        Format::Apng => whole(arguments, Kind::Apng, "png", &film, count, &shown)?,
        Format::Gif => whole(arguments, Kind::Gif, "gif", &film, count, &shown)?,
    };
    say!("{written}");
    Ok(())
}

/// One picture.
fn picture(film: &Film, share: f64, arguments: &Arguments) -> Result<Picture, String> {
    let svg = film.frame(share).map_err(|e| e.to_string())?;
    let drawing = Drawing::read(&arguments.theme.dressed(&svg)).map_err(|e| e.to_string())?;
    drawing.picture(arguments.width).map_err(|e| e.to_string())
}

type Shown<'a> = &'a (dyn Fn(u32) -> Result<Picture, String> + Sync);

/// Draws the pictures on every core and takes them in order; a terminal shows how many are done.
fn each(
    count: u32,
    shown: Shown<'_>,
    mut take: impl FnMut(usize, &Picture) -> Result<(), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let show = |words: &str| {
        if stderr().is_terminal() {
            let _ = write!(stderr(), "\r\x1b[K{words}");
        }
    };
    each_made(
        count as usize,
        |i| shown(i as u32),
        |i, picture, _| {
            show(&format!("{} of {count} pictures", i + 1));
            take(i, &picture?)
        },
    )?;
    show("");
    Ok(())
}

/// One file; returns what was written.
fn whole(
    arguments: &Arguments,
    kind: Kind,
    ending: &str,
    film: &Film,
    count: u32,
    shown: Shown<'_>,
) -> Result<String, Box<dyn Error>> {
    let samples: Vec<Picture> = (0..5).map(|i| shown(i * count / 5)).collect::<Result<_, _>>()?;
    let size = [samples[0].width, samples[0].height];
    let palette = Palette::new(&arguments.theme.inks(), &samples, COLOURS);
    let milliseconds = (1000.0 * film.seconds() / f64::from(count)).round() as u16;
    let mut writer = Writer::new(kind, palette, size, count, milliseconds)?;
    each(count, shown, |_, picture| Ok(writer.add(picture)?))?;
    let bytes = writer.finish()?;
    let file = arguments.out.join(format!("{}.{ending}", arguments.name()));
    write_changed(&file, &bytes)?;
    Ok(format!(
        "  {}  {} kB, {count} pictures of {} × {}",
        file.display(),
        bytes.len().div_ceil(1000),
        size[0],
        size[1]
    ))
}

/// A folder of pictures; returns the line that makes a video of them.
fn frames(arguments: &Arguments, count: u32, shown: Shown<'_>) -> Result<String, Box<dyn Error>> {
    let folder = arguments.out.join(arguments.name());
    each(count, shown, |i, picture| {
        write_changed(&folder.join(format!("{:04}.png", i + 1)), &picture.png(&[])?)?;
        Ok(())
    })?;
    let (at, to) = (folder.display(), folder.with_extension("mp4"));
    Ok(format!(
        "  {at}  {count} pictures; a video of them, three times over:\n  ffmpeg -stream_loop 2 -framerate {RATE} -i '{at}/%04d.png' \
         -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt yuv420p '{}'",
        to.display()
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Cli;
    use crate::site::paths;
    use clap::Parser as _;
    use std::fs;

    /// A film of the given words, into this folder.
    fn filmed(words: &[&str], folder: &Path) -> Result<(), String> {
        let out = folder.to_string_lossy().into_owned();
        let all = ["tumbling-book", "film"].iter().chain(words).copied();
        let cli = Cli::try_parse_from(all.chain(["--out", &out])).map_err(|e| e.to_string())?;
        crate::cli::run(cli).map(|_| ()).map_err(|e| e.to_string())
    }

    #[test]
    fn a_named_body_and_one_from_a_file_become_films_and_frames() {
        let folder = tempfile::TempDir::new().unwrap();
        let phone = paths::repository().join("examples/bodies/phone.toml").to_string_lossy().into_owned();
        let short = ["--seconds", "0.2", "--width", "160"];
        filmed(&[&["book"], &short[..]].concat(), folder.path()).unwrap();
        filmed(&[&[&*phone, "--format", "gif", "--axis", "largest"], &short[..]].concat(), folder.path())
            .unwrap();
        filmed(&[&[&*phone, "--format", "frames", "--theme", "navy"], &short[..]].concat(), folder.path())
            .unwrap();
        let start = |name: &str| fs::read(folder.path().join(name)).unwrap()[..4].to_vec();
        assert_eq!(start("book.png"), b"\x89PNG");
        assert_eq!(start("phone-largest.gif"), b"GIF8");
        assert_eq!(start("phone/0004.png"), b"\x89PNG");
        assert!(!folder.path().join("phone/0005.png").exists(), "0.2 s at 20 pictures a second are four");
    }

    #[test]
    fn what_cannot_be_filmed_is_refused_in_a_sentence() {
        let folder = tempfile::TempDir::new().unwrap();
        let refused = |words: &[&str]| filmed(words, folder.path()).unwrap_err();
        assert_eq!(refused(&["book", "--spin", "0"]), "a spin of 0 rad/s: nothing would move");
        assert!(refused(&["bok"]).contains("bok"), "{}", refused(&["bok"]));
        assert!(refused(&["no-such-file.toml"]).contains("no-such-file.toml"));
        assert!(filmed(&["book"], &paths::figures()).unwrap_err().contains("choose another folder"));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0, "something was written");
    }

    #[test]
    fn the_first_page_s_films_are_as_long_as_the_motion() {
        let film = Film::new(&BodyModel::load("book").unwrap(), &Request::default()).unwrap();
        let pictures = (film.seconds() * RATE).round() as u32;
        for name in ["book", "book-navy"] {
            let file = fs::read(paths::chapters().join(format!("films/{name}.png"))).unwrap();
            let at = file.windows(4).position(|bytes| bytes == b"acTL").unwrap() + 4;
            assert_eq!(u32::from_be_bytes(file[at..at + 4].try_into().unwrap()), pictures, "{name}");
            assert!(fs::exists(paths::chapters().join(format!("films/{name}-still.png"))).unwrap());
        }
    }

    #[test]
    fn a_spin_is_in_radians_or_turns() {
        assert_eq!(spin("6"), Ok(6.0));
        assert_eq!(spin("-1.5e-3 rad/s"), Ok(-1.5e-3));
        assert_eq!(spin("2.5turns"), Ok(2.5 * TAU));
        for wrong in ["fast", "", "6 rpm", "inf", "NaN"] {
            assert!(spin(wrong).unwrap_err().starts_with("a spin is a number of rad/s"), "{wrong}");
        }
    }
}
