//! Films of a body in free motion.

use crate::command::body::{body, folder_name};
use crate::command::export::{own_folder_refused, theme};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::error::Error;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use std::process::Command;
use tumbling::Axis;
use tumbling_bodies::BodyModel;
use tumbling_figures::Theme;
use tumbling_figures::film::{Camera, Film, Request};
use tumbling_media::film::{Film as Writer, Palette};
use tumbling_media::{Drawing, Picture};
use tumbling_site::draw::each_made;
use tumbling_site::files::write_changed;
use tumbling_site::language::Language;
use tumbling_site::paths;
use tumbling_site::say;

/// What a film shows, and how it is written.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// A body of the book (book, phone, hammer, ...), or a file: FILE.toml, FILE.urdf#LINK
    #[arg(value_name = "BODY")]
    body: String,
    /// The principal axis that it spins about
    #[arg(long, value_parser = one_of(AXES), default_value = "middle")]
    axis: Axis,
    /// The spin: 6 or 6rad/s, 1turn or 2turns (a second) [default: what the body's file says, or 1turn]
    #[arg(long, value_name = "SPIN", value_parser = spin, allow_negative_numbers = true)]
    spin: Option<f64>,
    /// The spin across that axis, as a share of it [default: near 0.02, such that the film closes]
    #[arg(long, value_name = "SHARE", allow_negative_numbers = true)]
    push: Option<f64>,
    /// How long the film takes; a turn of the spin takes a second [default: until the motion starts again]
    #[arg(long, value_name = "S")]
    seconds: Option<f64>,
    /// At rest in the room, riding on the body, or turning about the momentum so that the film closes
    /// [default: room, or momentum where only that closes]
    #[arg(long, value_parser = one_of(CAMERAS))]
    camera: Option<Camera>,
    /// gif plays in slides, messengers and pages; mp4 needs an installed ffmpeg; frames are pictures alone
    #[arg(long, value_enum, default_value_t = Format::Gif)]
    format: Format,
    /// As wide as high, for messengers: the body alone; 16 to 9, as a slide, if not given
    #[arg(long)]
    square: bool,
    /// In pixels [default: 1280, or 720 of a square]
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u32).range(64..=4096))]
    width: Option<u32>,
    /// The colours
    #[arg(long, value_parser = theme(), default_value = Theme::Light.name())]
    theme: Theme,
    /// The language of its words: de
    #[arg(long, value_name = "CODE", value_parser = Language::read)]
    language: Option<Language>,
    /// The folder for the film; book/print if not given
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

const AXES: &[(&str, Axis)] =
    &[("smallest", Axis::Smallest), ("middle", Axis::Middle), ("largest", Axis::Largest)];
const CAMERAS: &[(&str, Camera)] =
    &[("room", Camera::Room), ("body", Camera::Body), ("momentum", Camera::Momentum)];

/// One of these by its name.
fn one_of<T: Copy + Send + Sync>(all: &'static [(&str, T)]) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.iter().map(|(name, _)| *name)).try_map(|name| {
        all.iter().find(|(known, _)| *known == name).map(|(_, one)| *one).ok_or("no such name")
    })
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    Gif,
    Mp4,
    Frames,
}

/// Pictures per second. GIF counts in hundredths of a second, and the time of a picture is a whole number of
/// these.
const RATE: f64 = 20.0;

/// The number of colours of a film of a few hundred kilobytes.
const COLOURS: usize = 64;

/// The units of a spin, and their values in rad/s.
const UNITS: [(&str, f64); 6] =
    [("rad/s", 1.0), ("turns/s", TAU), ("turn/s", TAU), ("turns", TAU), ("turn", TAU), ("rad", 1.0)];

/// A spin in rad/s or in turns a second.
fn spin(text: &str) -> Result<f64, String> {
    let of = |(name, unit): &(&'static str, f64)| Some((text.trim().strip_suffix(name)?, *unit));
    let (number, unit) = UNITS.iter().find_map(of).unwrap_or((text, 1.0));
    let value = number.trim().parse().ok().filter(|x: &f64| x.is_finite());
    value.map(|x| x * unit).ok_or_else(|| {
        "a spin is a number of rad/s or of turns a second, such as 6, 6rad/s, 1turn or 2.5turns".into()
    })
}

impl Arguments {
    fn request(&self, model: &BodyModel) -> Request {
        Request {
            axis: self.axis,
            spin: self.spin.or(model.spin).unwrap_or(TAU),
            push: self.push,
            seconds: self.seconds,
            camera: self.camera,
            square: self.square,
        }
    }

    /// The film's file, without its ending.
    fn file(&self, model: &BodyModel) -> PathBuf {
        let mut name = folder_name(&model.name);
        let axis = AXES.iter().find(|(_, axis)| *axis == self.axis && *axis != Axis::Middle);
        axis.iter().for_each(|(axis, _)| name.push_str(&format!("-{axis}")));
        name.push_str(if self.square { "-square" } else { "" });
        self.language.iter().for_each(|own| name.push_str(&format!("-{}", own.code)));
        self.out.clone().unwrap_or_else(|| paths::book().join("print")).join(name)
    }
}

/// Draws the film and writes it.
///
/// # Errors
/// A body that cannot be read, a spin that it cannot have, a folder that cannot be written.
pub(crate) fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let model = body(&arguments.body)?;
    let file = arguments.file(&model);
    own_folder_refused(file.parent().unwrap_or(&file))?;
    let none = "no ffmpeg was found, which writes an MP4: install it, or leave `--format mp4` out for a GIF";
    let can = arguments.format != Format::Mp4 || Command::new("ffmpeg").arg("-version").output().is_ok();
    can.then_some(()).ok_or(none)?;
    let film = Film::new(&model, &arguments.request(&model))?;
    let count = (film.seconds() * RATE).round().clamp(2.0, 12_000.0) as u32;
    say!("{}\nDrawing {count} pictures ...", film.explained()?);
    let shown = |i: u32| picture(&film, f64::from(i) / f64::from(count), arguments);
    let written = match arguments.format {
        Format::Gif => whole(&file.with_extension("gif"), arguments, &film, count, &shown)?,
        Format::Mp4 => video(&file.with_extension("mp4"), count, &shown)?,
        Format::Frames => frames(&file, count, &shown)?,
    };
    say!("{written}");
    Ok(())
}

/// One picture.
fn picture(film: &Film, share: f64, arguments: &Arguments) -> Result<Picture, String> {
    let svg = film.frame(share).map_err(|e| e.to_string())?;
    let svg = arguments.language.as_ref().map_or(svg.clone(), |own| own.markup(&svg).0);
    let drawing = Drawing::read(&arguments.theme.dressed(&svg)).map_err(|e| e.to_string())?;
    let width = arguments.width.unwrap_or(if arguments.square { 720 } else { 1280 });
    drawing.picture(width).map_err(|e| e.to_string())
}

type Written = Result<String, Box<dyn Error>>;
type Shown<'a> = &'a (dyn Fn(u32) -> Result<Picture, String> + Sync);

/// A GIF; returns what was written.
fn whole(file: &Path, arguments: &Arguments, film: &Film, count: u32, shown: Shown<'_>) -> Written {
    let samples: Vec<Picture> = (0..5).map(|i| shown(i * count / 5)).collect::<Result<_, _>>()?;
    let size = [samples[0].width, samples[0].height];
    let palette = Palette::new(&arguments.theme.inks(), &samples, COLOURS);
    let milliseconds = (1000.0 * film.seconds() / f64::from(count)).round() as u16;
    let mut writer = Writer::new(palette, size, milliseconds)?;
    let add = |_, picture: Result<Picture, String>, _| Ok::<_, Box<dyn Error>>(writer.add(&picture?)?);
    each_made(count as usize, |i| shown(i as u32), add)?;
    let bytes = writer.finish()?;
    write_changed(file, &bytes)?;
    let (at, size, [wide, high]) = (file.display(), bytes.len().div_ceil(1000), size);
    Ok(format!("  {at}  {size} kB, {count} pictures of {wide} × {high}"))
}

/// Writes a video of three repetitions by ffmpeg; returns a line on it.
fn video(file: &Path, count: u32, shown: Shown<'_>) -> Written {
    let folder = tempfile::TempDir::new()?;
    frames(folder.path(), count, shown)?;
    let even = "pad=ceil(iw/2)*2:ceil(ih/2)*2";
    let once = format!("-framerate {RATE} -i %04d.png -vf {even} -pix_fmt yuv420p once.mp4");
    // The encoded video is repeated without encoding it again.
    for how in [&once, "-stream_loop 2 -i once.mp4 -c copy -movflags +faststart film.mp4"] {
        let how = ["-loglevel", "error"].into_iter().chain(how.split(' '));
        let made = Command::new("ffmpeg").current_dir(&folder).args(how).output()?;
        if !made.status.success() {
            return Err(format!("ffmpeg: {}", String::from_utf8_lossy(&made.stderr).trim()).into());
        }
    }
    let film = std::fs::read(folder.path().join("film.mp4"))?;
    write_changed(file, &film)?;
    Ok(format!("  {}  {} kB", file.display(), film.len().div_ceil(1000)))
}

/// A folder of pictures; returns what was written.
fn frames(folder: &Path, count: u32, shown: Shown<'_>) -> Written {
    let made = |i| shown(i as u32)?.png(&[]).map_err(|e| e.to_string());
    each_made(count as usize, made, |i, png, _| {
        write_changed(&folder.join(format!("{:04}.png", i + 1)), &png?)?;
        Ok::<_, Box<dyn Error>>(())
    })?;
    Ok(format!("  {}  {count} pictures, {RATE} a second", folder.display()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Cli;
    use clap::Parser as _;
    use std::fs;
    use tumbling::body::named::NamedBody;

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
        filmed(&[&["book", "--square"], &short[..]].concat(), folder.path()).unwrap();
        filmed(&[&[&*phone, "--axis", "largest"], &short[..]].concat(), folder.path()).unwrap();
        filmed(&[&[&*phone, "--format", "frames", "--theme", "navy"], &short[..]].concat(), folder.path())
            .unwrap();
        let start = |name: &str| fs::read(folder.path().join(name)).unwrap()[..4].to_vec();
        assert_eq!(start("book.gif"), b"GIF8");
        assert_eq!(start("phone-largest.gif"), b"GIF8");
        let square = fs::read(folder.path().join("book-square.gif")).unwrap();
        assert_eq!(square[6..10], [160, 0, 160, 0], "width and height");
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
            let file = fs::read(paths::chapters().join(format!("films/{name}.gif"))).unwrap();
            // The block of each picture with its duration: five hundredths of a second.
            let stays = file.windows(6).filter(|bytes| bytes[..3] == [0x21, 0xf9, 4] && bytes[4..] == [5, 0]);
            assert_eq!(stays.count() as u32, pictures, "{name}");
            assert!(fs::exists(paths::chapters().join(format!("films/{name}-still.png"))).unwrap());
        }
    }

    #[test]
    fn each_word_of_a_film_of_a_named_body_has_its_german() {
        let german = Language::read("de").unwrap();
        let cameras = [Camera::Room, Camera::Body, Camera::Momentum];
        for (at, body) in NamedBody::ALL.into_iter().enumerate() {
            let (axis, camera) = (Axis::ALL[at % 3], Some(cameras[at / 3]));
            let film =
                Film::new(&BodyModel::named(body).unwrap(), &Request { axis, camera, ..Request::default() });
            let frame = film.unwrap().frame(0.0).unwrap();
            assert_eq!(german.markup(frame.split("</desc>").nth(1).unwrap()).1, [""; 0]);
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
