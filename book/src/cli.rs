//! What was asked for on the command line, and carrying it out.

use crate::share::Site;
use crate::{build, complain, docs, draw, exercises, guard, judge, measure, nearest, paths, preprocess, say};
use std::error::Error;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;
use tumbling_figures::{Figure, registry};

const HELP: &str = "\
Draws the figures of the book and builds its pages.

    cargo run --release                        draw every figure, build the book and the
                                               library's documentation beside it
    cargo run --release -- figures [NAME...]   draw every figure, or those named
    cargo run --release -- figures --check     draw nothing; fail and name the committed
                                               figures that are not what would be drawn
    cargo run --release -- list                name, chapter and subject of each figure
    cargo run --release -- build               build the book from the figures as they are
         --site URL                            for pages that will stand there: full addresses, sitemap.xml
    cargo run --release -- check [DIR]         say what number or equation of the chapters (in DIR, else
                                               the book's own) nothing holds: exit 1; 2 where something
                                               cannot be read
    cargo run --release -- check --list        the same, and for each number and equation what holds it
    cargo run --release -- check --mutants     alter the book's numbers and equations, one change at a
                                               time, and tell which alterations go unnoticed
    cargo run --release -- exercises           say which exercises are done, begun and open, by chapter;
                                               runs those that you have changed
    cargo run --release -- exercises next      name the next one, with its file and its command
    cargo run --release -- exercises reset NAME...
                                               bring its file back as it was
    cargo run --release -- exercises untouched fail and name the files that are not as the book has them
    cargo run --release -- judge FILE          hold an engine's record of a free body (columns t, qw..qz,
                                               wx..wz) against the exact motion, and say which rule made it:
                                               exit 0 where it passes, 1 where not, 2 where it cannot be read;
                                               FILE may be - for the standard input
         --inertia A,B,C                       principal moments, where no comment `# inertia: A B C` tells
         --threshold X                         the most error allowed of a law (0.01 if not given)
         --threshold LAW=X,LAW=X               of energy, momentum, direction, unit, separatrix; and of phase and
                                               consistency, which are held to nothing otherwise
         --fit [N]                             take as the start the spin whose exact motion comes nearest to the first N
                                               rows (64 if not given), and not the first row's alone: where it has few digits
         --svg OUT                             draw the verdict into the file OUT
         --json                                the verdict as JSON
         --help                                more about this command
    cargo run --release -- measure             run every method against the exact motion, some minutes;
                                               renews measure/record/, from which figures are drawn
    cargo run --release -- measure --peers     the same, with published solvers and an engine in the same
                                               run; compiles some two hundred crates first
    cargo run --release -- measure --quick     the same in less than a minute, coarser, into measure/quick/;
                                               also with --peers
    cargo run --release -- measure scenes      count what scenes cost by what is asked of them, and what crates each part
                                               brings; renews measure/record/scenes.csv; needs valgrind
    cargo run --release -- measure scenes --builds
                                               the same, and time the build of each part from nothing, some minutes
    cargo run --release -- measure scenes --check
                                               count again what scenes cost; fail where the record says otherwise
    cargo run --release -- atlas               run every method on every hard case, some seconds; prints what
                                               became of each and renews measure/record/atlas.tsv
    cargo run --release -- measure scale       a hundred to ten million bodies, beside an engine, some minutes;
                                               renews measure/record/scale.csv
    cargo run --release -- measure --long NAME a billion turns by one method, a quarter of an hour or more
    cargo run --release -- --help              this text

The pages land in book/html/; open book/html/index.html in any browser, no server needed.
With mdBook installed, `mdbook serve book` shows the same pages and follows your edits
(it calls `preprocess`, a command meant for mdBook alone).

The code of the chapters is tested by `cargo test`; one exercise is run by `cargo exercise NAME`.";

/// What `check` is to tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Checking {
    /// What nothing holds.
    Offences,
    /// That, and for all else what holds it.
    Listing,
    /// What alterations go unnoticed.
    Mutants,
}

/// A command, understood.
#[derive(Debug)]
pub(crate) enum Asked {
    Everything,
    Help,
    JudgeHelp,
    List,
    Build { site: Option<Site> },
    Figures { names: Vec<&'static Figure>, check: bool },
    Check { folder: Option<PathBuf>, how: Checking },
    Exercises(exercises::Asked),
    Judge { file: PathBuf, json: bool, svg: Option<PathBuf>, options: Box<tumbling_judge::Options> },
    Measure { quick: bool, peers: bool },
    Scale { quick: bool },
    Atlas,
    Longest { method: String },
    Count { contestant: String, times: u64 },
    Scenes { check: bool, builds: bool },
    CountScene { name: String, plans: u64, rounds: u64 },
    Preprocess,
    Supports { renderer: String },
}

const COMMANDS: [&str; 10] =
    ["figures", "check", "list", "build", "exercises", "judge", "measure", "atlas", "help", "preprocess"];
const OPTIONS: [&str; 14] = [
    "--help",
    "--check",
    "--list",
    "--mutants",
    "--quick",
    "--peers",
    "--long",
    "--builds",
    "--inertia",
    "--threshold",
    "--json",
    "--site",
    "--svg",
    "--fit",
];

/// Reads the arguments that follow the program's name.
///
/// # Errors
/// A sentence that says what was not understood, and what was perhaps meant.
pub(crate) fn parse(args: impl IntoIterator<Item = OsString>) -> Result<Asked, String> {
    use lexopt::prelude::*;
    let mut parser = lexopt::Parser::from_args(args);
    let mut words = Vec::new();
    let mut check = false;
    let mut how = Checking::Offences;
    let (mut quick, mut peers, mut long, mut builds) = (false, false, None, false);
    let (mut options, mut json, mut svg) = (tumbling_judge::Options::default(), false, None);
    let mut site = None;
    while let Some(arg) = parser.next().map_err(|e| e.to_string())? {
        match arg {
            Short('h') | Long("help") => {
                return Ok(if words.first().is_some_and(|word| word == "judge") {
                    Asked::JudgeHelp
                } else {
                    Asked::Help
                });
            }
            Long("check") => check = true,
            Long("mutants") => how = Checking::Mutants,
            Long("list") => how = Checking::Listing,
            Long("quick") => quick = true,
            Long("peers") => peers = true,
            Long("builds") => builds = true,
            Long("long") => {
                long = Some(parser.value().map_err(|e| e.to_string())?.to_string_lossy().into_owned());
            }
            Long("json") => json = true,
            Long("inertia") => {
                let value = parser.value().map_err(|e| e.to_string())?;
                options.inertia = Some(judge::moments(&value.to_string_lossy())?);
            }
            Long("threshold") => {
                let value = parser.value().map_err(|e| e.to_string())?;
                judge::threshold(&value.to_string_lossy(), &mut options)?;
            }
            Long("svg") => {
                let out = PathBuf::from(parser.value().map_err(|e| e.to_string())?);
                if out.to_string_lossy().starts_with('-') {
                    return Err(format!("`--svg` takes a file to draw into, but got `{}`.", out.display()));
                }
                svg = Some(out);
            }
            // Its number may be left out: a word that is no number is the file.
            Long("fit") => {
                options.fit = Some(match parser.optional_value() {
                    Some(rows) => judge::fit(&rows.to_string_lossy())?,
                    None => {
                        let mut rest = parser.raw_args().map_err(|e| e.to_string())?;
                        let number = |word: &std::ffi::OsStr| {
                            word.to_str().is_some_and(|x| x.bytes().all(|c| c.is_ascii_digit()))
                        };
                        match rest.next_if(number) {
                            Some(rows) => judge::fit(&rows.to_string_lossy())?,
                            None => judge::FITTED,
                        }
                    }
                });
            }
            Long("site") => {
                let value = parser.value().map_err(|e| e.to_string())?;
                site = Some(Site::parse(&value.to_string_lossy())?);
            }
            Value(word) => words.push(word.to_string_lossy().into_owned()),
            Long(unknown) => {
                let unknown = format!("--{unknown}");
                let judging = words.first().is_some_and(|word| word == "judge");
                let known = if judging { &judge::OPTIONS[..] } else { &OPTIONS[..] };
                let near = nearest::perhaps(&unknown, known.iter().copied());
                return Err(format!("There is no option `{unknown}`.{near}"));
            }
            other => return Err(other.unexpected().to_string()),
        }
    }
    let mut words = words.into_iter();
    let command = words.next();
    let rest: Vec<String> = words.collect();
    let of_scenes = command.as_deref() == Some("measure") && rest == ["scenes"];
    if check && command.as_deref() != Some("figures") && !of_scenes {
        return Err("`--check` goes with `figures` and `measure scenes`.".into());
    }
    if builds && (check || !of_scenes) {
        return Err("`--builds` goes with `measure scenes`, without `--check`.".into());
    }
    if how != Checking::Offences && command.as_deref() != Some("check") {
        return Err("`--list` and `--mutants` go with `check`.".into());
    }
    if (quick || peers || long.is_some()) && command.as_deref() != Some("measure") {
        return Err("`--quick`, `--peers` and `--long` go with `measure`.".into());
    }
    let judging = json || svg.is_some() || options != tumbling_judge::Options::default();
    if judging && command.as_deref() != Some("judge") {
        return Err("`--inertia`, `--threshold`, `--fit`, `--svg` and `--json` go with `judge`.".into());
    }
    if site.is_some() && command.as_deref() != Some("build") {
        return Err("`--site` goes with `build`.".into());
    }
    match command.as_deref() {
        None => Ok(Asked::Everything),
        Some("judge") => match rest.as_slice() {
            [] => Err("`judge` takes a file of comma-separated values, or - for the standard input.".into()),
            [file] => Ok(Asked::Judge { file: file.into(), json, svg, options: Box::new(options) }),
            [_, extra, ..] => Err(format!("`judge` takes one file, but got `{extra}` besides.")),
        },
        Some("exercises") => Ok(Asked::Exercises(exercises::parse(&rest)?)),
        Some("figures") => Ok(Asked::Figures { names: named(&rest, registry())?, check }),
        Some("check") => match rest.as_slice() {
            [] => Ok(Asked::Check { folder: None, how }),
            [folder] => Ok(Asked::Check { folder: Some(folder.into()), how }),
            [_, extra, ..] => Err(format!("`check` takes one folder, but got `{extra}` besides.")),
        },
        Some("measure") => match (rest.as_slice(), long) {
            ([], None) => Ok(Asked::Measure { quick, peers }),
            ([], Some(method)) if !quick && !peers => Ok(Asked::Longest { method }),
            ([], Some(_)) => Err("`--long` goes alone.".into()),
            ([word], None) if word == "scenes" && !quick && !peers => Ok(Asked::Scenes { check, builds }),
            ([word], None) if word == "scale" && !peers => Ok(Asked::Scale { quick }),
            // How it runs itself again under valgrind.
            ([word, name, plans, rounds], None) if word == "scene" => {
                let number = |text: &String| text.parse().map_err(|_| format!("`{text}` is no number."));
                Ok(Asked::CountScene { name: name.clone(), plans: number(plans)?, rounds: number(rounds)? })
            }
            ([word, contestant, times], None) if word == "count" => {
                let times = times.parse().map_err(|_| format!("`{times}` is no number."))?;
                Ok(Asked::Count { contestant: contestant.clone(), times })
            }
            ([extra, ..], _) => {
                Err(format!("`measure` takes options, `scenes` or `scale`, but got `{extra}`."))
            }
        },
        Some("preprocess") => match rest.as_slice() {
            [] => Ok(Asked::Preprocess),
            [word, renderer] if word == "supports" => Ok(Asked::Supports { renderer: renderer.clone() }),
            _ => Err("`preprocess` takes nothing, or `supports RENDERER`.".into()),
        },
        Some(word @ ("list" | "build" | "atlas" | "help")) => match rest.first() {
            Some(extra) => Err(format!("`{word}` takes no further word, but got `{extra}`.")),
            None => Ok(match word {
                "list" => Asked::List,
                "build" => Asked::Build { site },
                "atlas" => Asked::Atlas,
                _ => Asked::Help,
            }),
        },
        Some(unknown) => {
            Err(format!("There is no command `{unknown}`.{}", nearest::perhaps(unknown, COMMANDS)))
        }
    }
}

/// The figures of these names; all of them when none is named.
fn named(names: &[String], all: &'static [Figure]) -> Result<Vec<&'static Figure>, String> {
    if names.is_empty() {
        return Ok(all.iter().collect());
    }
    names
        .iter()
        .map(|name| {
            all.iter().find(|figure| figure.name == name).ok_or_else(|| {
                format!(
                    "There is no figure `{name}`.{} `-- list` lists them all.",
                    nearest::perhaps(name, all.iter().map(|figure| figure.name))
                )
            })
        })
        .collect()
}

/// Carries it out.
///
/// # Errors
/// What went wrong, in words for whoever typed the command.
pub(crate) fn run(asked: Asked) -> Result<ExitCode, Box<dyn Error>> {
    match asked {
        Asked::Help => say!("{HELP}"),
        Asked::JudgeHelp => say!("{}", judge::HELP),
        Asked::List => say!("{}", listing(registry())),
        Asked::Figures { names, check: true } => draw::check(&names, &paths::figures())?,
        Asked::Figures { names, check: false } => draw::draw(&names, &paths::figures())?,
        Asked::Check { folder, how } => {
            let folder = folder.unwrap_or_else(paths::chapters);
            let told = match how {
                Checking::Mutants => alterations(&folder),
                Checking::Offences | Checking::Listing => checked(&folder, how == Checking::Listing),
            };
            return Ok(match told {
                Ok(true) => ExitCode::SUCCESS,
                Ok(false) => ExitCode::FAILURE,
                Err(wrong) => {
                    complain!("error: {wrong}");
                    ExitCode::from(2)
                }
            });
        }
        Asked::Exercises(asked) => return Ok(exercises::run(&asked)?),
        Asked::Judge { file, json, svg, options } => {
            return Ok(judge::judge(&file, &options, json, svg.as_deref()));
        }
        Asked::Measure { quick, peers } => measure::measure(quick, peers)?,
        Asked::Scale { quick } => measure::scale(quick)?,
        Asked::Atlas => measure::atlas()?,
        Asked::Longest { method } => measure::longest(&method)?,
        Asked::Count { contestant, times } => measure::count(&contestant, times)?,
        Asked::Scenes { check, builds } => measure::scenes(check, builds)?,
        Asked::CountScene { name, plans, rounds } => measure::count_scene(&name, plans, rounds)?,
        Asked::Build { site } => build::build(site.as_ref())?,
        Asked::Preprocess => preprocess::protocol::answer(std::io::stdin(), std::io::stdout())?,
        // mdBook asks by the exit code alone, and a no is no error.
        Asked::Supports { renderer } => {
            return Ok(if preprocess::supports(&renderer) { ExitCode::SUCCESS } else { ExitCode::FAILURE });
        }
        Asked::Everything => {
            let start = Instant::now();
            draw::draw(&registry().iter().collect::<Vec<_>>(), &paths::figures())?;
            docs::make()?;
            build::build(None)?;
            say!("All done in {:.1} s. Open", start.elapsed().as_secs_f64());
            say!("{}", paths::pages().join("index.html").display());
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Tells what the guard found; whether that was nothing.
fn checked(folder: &Path, list: bool) -> Result<bool, String> {
    let report = guard::check(folder)?;
    if list {
        for held in &report.held {
            say!("{held}");
        }
    }
    for offence in &report.offences {
        say!("{offence}");
    }
    say!("{report}");
    Ok(report.offences.is_empty())
}

/// Tells what became of each alteration; whether those of numbers were all noticed. Of equations, those that were not
/// are proven true.
fn alterations(folder: &Path) -> Result<bool, String> {
    let tallies = guard::alterations(folder)?;
    say!(
        "{:18} {:>12} {:>10} {:>22} {:>11} {:>12}",
        "altered, noticed",
        "numbers",
        "words",
        "assertions",
        "tolerances",
        "equations"
    );
    let mut all = guard::Tally { name: "the book".into(), ..guard::Tally::default() };
    for tally in &tallies {
        all.add(tally);
        say!("{tally}");
    }
    say!("{all}");
    say!(
        "(assertions: noticed by the guard + only by the assertion itself; a tolerance altered may leave it true)"
    );
    for survivor in &all.survivors {
        say!("unnoticed: {survivor}");
    }
    for still in &all.still_true {
        say!("altered, and proven true as well: {still}");
    }
    Ok(all.text.killed == all.text.made)
}

fn listing(all: &[Figure]) -> String {
    if all.is_empty() {
        return "There are no figures yet.".into();
    }
    let width = |text: fn(&Figure) -> &str| all.iter().map(|f| text(f).len()).max().unwrap_or(0);
    let (name, chapter) = (width(|f| f.name), width(|f| f.chapter));
    let mut out = String::new();
    for f in all {
        let _ = writeln!(out, "{:name$}  {:chapter$}  {}", f.name, f.chapter, f.shows);
    }
    out.truncate(out.trim_end().len());
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use tumbling_judge::LawName;

    fn parsed(words: &[&str]) -> Result<Asked, String> {
        parse(words.iter().map(OsString::from))
    }

    #[test]
    fn commands_are_understood() {
        assert!(matches!(parsed(&[]), Ok(Asked::Everything)));
        assert!(matches!(parsed(&["build"]), Ok(Asked::Build { site: None })));
        assert!(matches!(
            parsed(&["build", "--site", "https://example.org/"]),
            Ok(Asked::Build { site: Some(_) })
        ));
        assert!(
            parsed(&["build", "--site", "example.org"]).is_err()
                && parsed(&["--site", "https://a/", "list"]).is_err()
        );
        assert!(matches!(parsed(&["list"]), Ok(Asked::List)));
        for help in [&["--help"][..], &["-h"], &["help"], &["figures", "--help"]] {
            assert!(matches!(parsed(help), Ok(Asked::Help)), "{help:?}");
        }
        assert!(matches!(parsed(&["judge", "--help"]), Ok(Asked::JudgeHelp)));
        assert!(judge::OPTIONS.iter().all(|option| judge::HELP.contains(option)));
        assert!(matches!(parsed(&["exercises", "next"]), Ok(Asked::Exercises(exercises::Asked::Next))));
        assert!(matches!(parsed(&["atlas"]), Ok(Asked::Atlas)));
        assert!(matches!(parsed(&["measure", "scenes"]), Ok(Asked::Scenes { check: false, builds: false })));
        assert!(matches!(
            parsed(&["measure", "scenes", "--check"]),
            Ok(Asked::Scenes { check: true, builds: false })
        ));
        assert!(matches!(
            parsed(&["measure", "scenes", "--builds"]),
            Ok(Asked::Scenes { check: false, builds: true })
        ));
        assert!(parsed(&["measure", "--builds"]).unwrap_err().contains("`measure scenes`"));
        assert!(parsed(&["measure", "--check"]).unwrap_err().contains("`measure scenes`"));
        assert!(matches!(parsed(&["measure"]), Ok(Asked::Measure { quick: false, peers: false })));
        assert!(matches!(
            parsed(&["measure", "--quick", "--peers"]),
            Ok(Asked::Measure { quick: true, peers: true })
        ));
        assert!(
            matches!(parsed(&["measure", "--long", "Buss"]), Ok(Asked::Longest { method }) if method == "Buss")
        );
        assert!(matches!(
            parsed(&["judge", "run.csv"]),
            Ok(Asked::Judge { json: false, options, .. }) if *options == tumbling_judge::Options::default()
        ));
        assert!(matches!(
            parsed(&["judge", "-", "--inertia", "1,2,2.5", "--threshold=1e-6", "--json"]),
            Ok(Asked::Judge { json: true, options, .. })
                if options.threshold == 1e-6 && options.inertia.is_some_and(|moments| moments.z == 2.5)
        ));
        for (words, rows) in [
            (&["judge", "run.csv", "--fit"][..], 64),
            (&["judge", "--fit", "run.csv"], 64),
            (&["judge", "--fit", "9", "run.csv"], 9),
            (&["judge", "--fit=9", "run.csv"], 9),
        ] {
            let Ok(Asked::Judge { file, options, .. }) = parsed(words) else { panic!("{words:?}") };
            assert_eq!((file, options.fit), (PathBuf::from("run.csv"), Some(rows)), "{words:?}");
        }
        let words = ["judge", "x", "--threshold", "0.5,energy=1e-6, phase = 2", "--svg", "out.svg"];
        let Ok(Asked::Judge { options, svg, .. }) = parsed(&words) else { panic!() };
        assert_eq!(svg, Some(PathBuf::from("out.svg")));
        let allowed = [LawName::Energy, LawName::Momentum, LawName::Phase].map(|law| options.allowed(law));
        assert_eq!(allowed, [Some(1e-6), Some(0.5), Some(2.0)]);
        assert!(matches!(parsed(&["figures", "--check"]), Ok(Asked::Figures { check: true, .. })));
        assert!(matches!(parsed(&["check"]), Ok(Asked::Check { folder: None, how: Checking::Offences })));
        assert!(matches!(
            parsed(&["check", "x"]),
            Ok(Asked::Check { folder: Some(_), how: Checking::Offences })
        ));
        assert!(matches!(
            parsed(&["check", "--mutants"]),
            Ok(Asked::Check { folder: None, how: Checking::Mutants })
        ));
        assert!(matches!(parsed(&["preprocess"]), Ok(Asked::Preprocess)));
        assert!(
            matches!(parsed(&["preprocess", "supports", "html"]), Ok(Asked::Supports { renderer }) if renderer == "html")
        );
    }

    #[test]
    fn what_is_not_understood_is_answered_with_what_is_near() {
        let answer = parsed(&["biuld"]).unwrap_err();
        assert_eq!(answer, "There is no command `biuld`. Did you mean `build`?");
        let answer = parsed(&["figures", "no-such-figure-at-all"]).unwrap_err();
        assert!(answer.starts_with("There is no figure `no-such-figure-at-all`."), "{answer}");
        let answer = parsed(&["exercise"]).unwrap_err();
        assert_eq!(answer, "There is no command `exercise`. Did you mean `exercises`?");
        let answer = parsed(&["figures", "--chekc"]).unwrap_err();
        assert!(answer.starts_with("There is no option `--chekc`. Did you mean `--check`"), "{answer}");
        let answer = parsed(&["judge", "x", "--inertai", "1,2,3"]).unwrap_err();
        assert_eq!(answer, "There is no option `--inertai`. Did you mean `--inertia`?");
        let answer = parsed(&["judge", "x", "--tresholds"]).unwrap_err();
        assert_eq!(answer, "There is no option `--tresholds`. Did you mean `--threshold`?");
        assert!(parsed(&["build", "all"]).unwrap_err().contains("`all`"));
        assert!(parsed(&["list", "--check"]).unwrap_err().contains("`figures`"));
        assert!(parsed(&["preprocess", "html"]).is_err());
        assert!(parsed(&["build", "--quick"]).unwrap_err().contains("`measure`"));
        assert!(matches!(parsed(&["measure", "scale"]), Ok(Asked::Scale { quick: false })));
        assert!(matches!(parsed(&["measure", "scale", "--quick"]), Ok(Asked::Scale { quick: true })));
        assert!(parsed(&["measure", "all"]).unwrap_err().contains("`all`"));
        assert!(parsed(&["measure", "--quick", "--long", "x"]).unwrap_err().contains("alone"));
        assert!(parsed(&["check", "a", "b"]).unwrap_err().contains("`b`"));
        assert!(matches!(parsed(&["check", "--list"]), Ok(Asked::Check { how: Checking::Listing, .. })));
        assert!(parsed(&["judge"]).unwrap_err().contains("takes a file"));
        assert!(parsed(&["judge", "a", "b"]).unwrap_err().contains("`b`"));
        assert!(parsed(&["build", "--json"]).unwrap_err().contains("`judge`"));
        assert!(parsed(&["judge", "a", "--inertia", "1,2"]).unwrap_err().contains("three numbers"));
        assert!(parsed(&["judge", "a", "--inertia", "1,x,2"]).unwrap_err().contains("three numbers"));
        assert!(parsed(&["judge", "a", "--threshold", "-1"]).unwrap_err().contains("above zero"));
        let answer = parsed(&["judge", "a", "--threshold", "enrgy=1"]).unwrap_err();
        assert!(answer.starts_with("`--threshold` knows no law `enrgy`. Did you mean `energy`?"), "{answer}");
        assert!(parsed(&["judge", "a", "--threshold", "energy="]).unwrap_err().contains("above zero"));
        assert!(parsed(&["judge", "a", "--fit", "1"]).unwrap_err().contains("two at least"));
        assert!(parsed(&["judge", "a", "--fit=x"]).unwrap_err().contains("two at least"));
        assert!(parsed(&["build", "--svg", "x"]).unwrap_err().contains("`judge`"));
        assert!(parsed(&["figures", "--mutants"]).unwrap_err().contains("`check`"));
    }
}
