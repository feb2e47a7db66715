//! The command line: its grammar, and what each command does.

use crate::command::{body::body, export, film, measure, report};
use crate::{guard, paper};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Parser, Subcommand};
use std::error::Error;
use std::fmt::Write as _;
use std::process::ExitCode;
use tumbling_bodies::BodyModel;
use tumbling_figures::{Figure, registry};
use tumbling_site::share::Site;
use tumbling_site::{build, complain, docs, draw, paths, say};

/// Draws the figures of the book and builds its pages
///
/// Without a command: draws every figure, builds the book and the library's documentation with it.
#[derive(Debug, Parser)]
#[command(
    name = "tumbling-book",
    bin_name = "cargo run --",
    after_help = "The pages are written to book/html/; open book/html/index.html in any browser, no server needed.
With mdBook 0.5 installed, `mdbook serve book` shows the same pages and follows your edits.
`cargo test` tests the code of the chapters; `cargo exercise NAME` runs one exercise."
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Draw every figure, or those named
    #[command(
        after_help = "With one of --format, --theme, --width and --out it writes files for slides, papers and \
other programs, and leaves the pages' drawings as they are: `cargo run -- figures two-arrows --format pdf --theme print --out slides`."
    )]
    Figures {
        /// The figures, by the names that `list` shows
        #[arg(value_name = "NAME", value_parser = figure(), hide_possible_values = true)]
        names: Vec<&'static Figure>,
        /// Draw nothing; fail and name the committed figures that differ from what would be drawn
        #[arg(long, conflicts_with_all = ["format", "theme", "width", "out"])]
        check: bool,
        /// For this body instead of the book's: a name such as `phone` or `hammer`, a TOML file, or
        /// FILE.urdf#LINK; into figures/of-bodies/NAME/ where no --out is given
        #[arg(long, value_name = "BODY", value_parser = body, conflicts_with = "check")]
        body: Option<BodyModel>,
        #[command(flatten)]
        export: export::Arguments,
    },
    /// Film a body in free motion: the body, its two arrows, the path of its spin
    Film(film::Arguments),
    /// List the name, chapter and subject of each figure
    List,
    /// Build the book from the figures as they are
    Build {
        /// Where the pages will be published: adds full addresses and sitemap.xml
        #[arg(long, value_name = "URL", value_parser = Site::parse)]
        site: Option<Site>,
    },
    /// Make the book for paper and readers: EPUB, PDF, handouts, sheets of problems
    Print(paper::Arguments),
    /// Name the numbers and equations of the chapters that no code or proof supports
    #[command(
        after_help = "Exit code: 0 if there are none, 1 if there are some, 2 if something cannot be read."
    )]
    Check {
        /// Also list what supports each number and equation
        #[arg(long)]
        list: bool,
    },
    /// List which exercises are done, begun and open, by chapter; runs those that you have changed
    #[command(after_help = "`cargo exercise NAME` runs one exercise.")]
    Exercises {
        /// `next` names the next one that is not done, with its file and its command; `reset NAME ...` brings
        /// files back as they were; `untouched` fails and names the files that are not as the book has them
        #[arg(value_name = "next | reset NAME ... | untouched")]
        words: Vec<String>,
    },
    /// Write one page on a body, HTML and PDF: axes, moments, which spin flips, the step for an engine
    Report(report::Arguments),
    /// Run every method against the exact motion, some minutes; renews crates/measure/record/
    Measure(measure::Arguments),
    /// Run every method on every hard case under torques, and say how each ends
    Atlas,
}

/// A figure's name on the command line.
fn figure() -> impl TypedValueParser<Value = &'static Figure> {
    PossibleValuesParser::new(
        registry().iter().map(|figure| PossibleValue::new(figure.name).help(figure.shows)),
    )
    .try_map(|name| registry().iter().find(|figure| figure.name == name).ok_or("no such figure"))
}

/// Carries out what the command line asks for.
///
/// # Errors
/// What went wrong, in words for the user.
pub(crate) fn run(cli: Cli) -> Result<ExitCode, Box<dyn Error>> {
    let Some(command) = cli.command else {
        tumbling_site::everything()?;
        return Ok(ExitCode::SUCCESS);
    };
    match command {
        Command::List => say!("{}", listing(registry())),
        Command::Figures { names, check, body, export } => {
            let named = !names.is_empty();
            let figures = if named { names } else { registry().iter().collect() };
            if export.wanted() || body.is_some() {
                export::export(&figures, body.as_ref(), !named, &export)?;
            } else if check {
                draw::check(&figures, &paths::figures())?;
            } else {
                draw::draw(&figures, &paths::figures())?;
            }
        }
        Command::Film(arguments) => film::run(&arguments)?,
        Command::Build { site } => build::build(site.as_ref())?,
        Command::Print(arguments) => paper::run(&arguments)?,
        Command::Check { list } => return Ok(checked(list)),
        // The default program asks a small package instead, so that learners do not compile this one.
        Command::Exercises { words } => {
            let program = ["run", "--quiet", "--package", "tumbling-book", "--", "exercises"];
            docs::cargo(&program.into_iter().chain(words.iter().map(String::as_str)).collect::<Vec<_>>())?;
        }
        Command::Report(arguments) => report::run(&arguments)?,
        Command::Measure(arguments) => measure::run(&arguments)?,
        Command::Atlas => measure::atlas()?,
    }
    Ok(ExitCode::SUCCESS)
}

/// Runs the guard and prints its findings; 1 if a number or equation has no support, 2 if something cannot be
/// read.
fn checked(list: bool) -> ExitCode {
    let report = match guard::check() {
        Ok(report) => report,
        Err(wrong) => {
            complain!("error: {wrong}");
            return ExitCode::from(2);
        }
    };
    report.held.iter().filter(|_| list).for_each(|line| say!("{line}"));
    report.offences.iter().for_each(|offence| say!("{offence}"));
    say!("{report}");
    ExitCode::from(u8::from(!report.offences.is_empty()))
}

fn listing(all: &[Figure]) -> String {
    let width = |text: fn(&Figure) -> &str| all.iter().map(|f| text(f).len()).max().unwrap_or(0);
    let (name, chapter) = (width(|f| f.name), width(|f| f.chapter));
    let mut out = String::new();
    for f in all {
        let _ = writeln!(out, "{:name$}  {:chapter$}  {}", f.name, f.chapter, f.shows);
    }
    let following: Vec<&str> = all.iter().filter(|f| f.follows_a_body()).map(|f| f.name).collect();
    let _ = write!(out, "\nWith --body, for any body: {}", following.join(", "));
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory as _;

    fn parsed(words: &str) -> Result<Option<Command>, String> {
        let all = std::iter::once("tumbling-book").chain(words.split_whitespace());
        Cli::try_parse_from(all).map(|cli| cli.command).map_err(|e| e.to_string())
    }

    #[test]
    fn the_grammar_is_sound() {
        Cli::command().debug_assert();
    }

    #[test]
    fn commands_are_understood() {
        assert!(matches!(parsed(""), Ok(None)));
        assert!(matches!(
            parsed("build --site https://example.org/"),
            Ok(Some(Command::Build { site: Some(_) }))
        ));
        let name = registry()[0].name;
        let Ok(Some(Command::Figures { names, check: true, .. })) =
            parsed(&format!("figures {name} --check"))
        else {
            panic!("`figures {name} --check` is not understood");
        };
        assert_eq!(names.iter().map(|figure| figure.name).collect::<Vec<_>>(), [name]);
        for words in [
            "figures",
            "figures two-arrows --format pdf --theme print --width 800 --out x",
            "film phone.toml --axis largest --spin 2turns --push 0.1 --seconds 4",
            "film hammer --camera body --format frames --theme navy --width 800",
            "figures polhodes --body hammer",
            "print epub",
            "print pdf --paper letter --out folder",
            "print handout two-arrows coin",
            "print problems --out folder",
            "check --list",
            "report phone --out reports",
            "measure --quick --peers",
            "measure scenes --check",
        ] {
            assert!(matches!(parsed(words), Ok(Some(_))), "{words}: {:?}", parsed(words));
        }
    }

    #[test]
    fn what_is_not_understood_is_answered_with_what_is_near() {
        for (words, near) in [
            ("biuld", "'build'"),
            ("exercise", "'exercises'"),
            ("figures --chekc", "'--check'"),
            ("figures two-arows", "'two-arrows'"),
            ("figures --theme prnt", "'print'"),
        ] {
            let answer = parsed(words).unwrap_err();
            let (_, tip) = answer.split_once("tip: ").unwrap_or_else(|| panic!("{answer}"));
            assert!(tip.lines().next().is_some_and(|tip| tip.contains(near)), "{answer}");
        }
    }

    #[test]
    fn options_go_with_their_command_alone() {
        let all = "build --site example.org, figures --check --format svg, figures --width 0, figures --body hamer, \
                   figures --check --body hammer, report nothing, measure --check, measure scenes --check --builds";
        for words in all.split(", ") {
            assert!(parsed(words).is_err(), "{words}");
        }
    }

    #[test]
    fn each_command_has_a_help_of_its_own() {
        let commands = Cli::command();
        for command in commands.get_subcommands().filter(|command| !command.is_hide_set()) {
            let name = command.get_name();
            let help = parsed(&format!("{name} --help")).unwrap_err();
            assert!(help.contains(&format!("Usage: cargo run -- {name}")), "{help}");
        }
    }
}
