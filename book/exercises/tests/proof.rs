//! The exercises are exercises: left open, each stops at its own `todo!`; solved, each passes; answered
//! wrongly, each is refused by an assertion that says why. All blocks are compiled, so none fails for that.

use std::cell::RefCell;
use std::{panic, thread};
use tumbling_exercises as exercises;

/// A block of an exercise, to be run.
pub struct Run {
    name: &'static str,
    variant: &'static str,
    run: fn(),
}

#[allow(
    unused,
    unreachable_code,
    missing_docs,
    clippy::all,
    reason = "readers write these blocks, some of them wrong"
)]
mod runs {
    use super::Run;
    include!(concat!(env!("OUT_DIR"), "/runs.rs"));
}

const SOURCE: &str = include_str!(concat!(env!("OUT_DIR"), "/runs.rs"));

thread_local! {
    static PANICKED: RefCell<Option<Panicked>> = const { RefCell::new(None) };
}

/// How a block ended early.
#[derive(Debug, Clone)]
struct Panicked {
    message: String,
    /// The line of code that it ended at.
    line: String,
}

impl Run {
    /// Runs it to its end, or to where it panics.
    fn outcome(&self) -> Result<(), Panicked> {
        let run = self.run;
        panic::catch_unwind(run).map_err(|_| PANICKED.take().expect("the hook has heard of it"))
    }

    /// The variant and its name, as messages give them.
    fn label(&self) -> String {
        format!("{} ({})", self.name, self.variant)
    }
}

/// What `fault` says of the runs of these variants.
fn faults(of: &str, fault: impl Fn(&Run, Result<(), Panicked>) -> Option<String>) -> Vec<String> {
    let (before, here) = (panic::take_hook(), thread::current().id());
    panic::set_hook(Box::new(move |info| {
        if thread::current().id() != here {
            return before(info); // another test's affair
        }
        let message = info.payload_as_str().unwrap_or_default().to_owned();
        let line = info.location().filter(|at| at.file().ends_with("runs.rs"));
        let line = line.and_then(|at| SOURCE.lines().nth(at.line() as usize - 1));
        PANICKED.set(Some(Panicked { message, line: line.unwrap_or_default().trim().to_owned() }));
    }));
    let runs: Vec<&Run> = runs::ALL.iter().filter(|run| run.variant.starts_with(of)).collect();
    let faults = runs.iter().filter_map(|run| fault(run, run.outcome())).collect();
    let _ = panic::take_hook();
    assert!(runs.len() >= exercises::all().unwrap().len(), "each exercise has its block, {of}");
    faults
}

#[test]
fn exercises_left_open_stop_at_their_own_todo_solved_ones_pass_and_wrong_answers_are_refused_with_a_reason() {
    let open = faults("open", |run, ended| match ended {
        Err(p) if p.message.starts_with("not yet implemented: ") && p.line.contains("todo!(\"") => None,
        other => Some(format!("{} does not stop at its todo: {other:?}", run.label())),
    });
    let solved = faults("solved", |run, ended| {
        ended.err().map(|p| format!("{} is refused: {}\n    at {}", run.label(), p.message, p.line))
    });
    let wrong = faults("wrong: ", |run, ended| match ended {
        // An assertion with words of its own: they show the reader's value and say what to think of.
        Err(p) if p.line.starts_with("assert!(") && !p.message.starts_with("assertion failed") => {
            (p.message.len() < 40).then(|| format!("{} says too little: {}", run.label(), p.message))
        }
        Err(p) => Some(format!("{} ends by no assertion, but: {} at {}", run.label(), p.message, p.line)),
        Ok(()) => Some(format!("{} passes", run.label())),
    });
    let all: Vec<String> = [open, solved, wrong].concat();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn every_chapter_that_shows_exercises_has_three_to_five_and_no_other_has_any() {
    let all = exercises::all().unwrap();
    for chapter in exercises::chapters() {
        let count = all.iter().filter(|e| e.place().0 == chapter).count();
        let text =
            std::fs::read_to_string(exercises::whole().join(format!("../../chapters/{chapter}.md"))).unwrap();
        let expected = if text.contains("{{#exercises}}") { 3..=5 } else { 0..=0 };
        assert!(expected.contains(&count), "{chapter} has {count}");
    }
}

#[test]
fn the_file_to_edit_differs_from_the_solution_in_the_marked_place_alone() {
    for exercise in exercises::all().unwrap() {
        let text = exercise.stub();
        let around = |text: &str| {
            let (before, rest) = text.split_once(exercises::BEGIN)?;
            Some((before.to_owned(), rest.rsplit_once(exercises::END)?.1.to_owned()))
        };
        let (before, after) = around(&exercise.solved()).unwrap();
        let same = around(&text).is_some_and(|(above, below)| {
            above.ends_with(&format!("\n\n```rust,standalone_crate\n{before}"))
                && above.contains(&exercise.task)
                && below.starts_with(&format!("{after}```\n\n"))
        });
        let name = &exercise.name;
        assert!(same, "{name} is another outside of its marks");
        assert!(!exercise.stub().contains(exercise.solution()), "{name} tells its solution");
    }
}

/// The file with this in its place.
fn filled(exercise: &exercises::Exercise, answer: &str) -> String {
    let stub = exercise.stub();
    let (before, rest) = stub.split_once(exercises::BEGIN).unwrap();
    let (_, after) = rest.split_once(exercises::END).unwrap();
    format!("{before}{}\n{answer}\n{}{after}", exercises::BEGIN, exercises::END)
}

fn named(name: &str) -> exercises::Exercise {
    exercises::all().unwrap().into_iter().find(|exercise| exercise.name == name).unwrap()
}

#[test]
fn a_file_that_is_filled_between_its_marks_alone_may_count() {
    for exercise in exercises::all().unwrap() {
        let solved = filled(&exercise, exercise.solution());
        for text in [&exercise.stub(), &solved, &solved.replace('\n', " \r\n"), &format!("{solved}\n\n")] {
            assert_eq!(exercises::fault(&exercise, text), None, "{}", exercise.name);
        }
    }
    // Inside of a function a `return` is its own affair, and so are new names.
    let inside = filled(&named("toss_a_book_1"), "    let a = 1; // no return\n    return a;");
    assert_eq!(exercises::fault(&named("toss_a_book_1"), &inside), None);
    let words = filled(&named("worked_example_2"), "let tangent = 1.0; // return\nprintln!(\"return {{\");");
    assert_eq!(exercises::fault(&named("worked_example_2"), &words), None);
}

#[test]
fn a_file_that_was_changed_outside_of_its_marks_is_no_answer_and_says_which_line_brings_it_back() {
    let exercise = named("two_arrows_4");
    let solved = filled(&exercise, exercise.solution());
    let line = |of: &str| solved.lines().position(|line| line.contains(of)).unwrap() + 1;
    for (text, message) in [
        (String::new(), " has not both marks".to_owned()),
        (format!("{solved}\n{}\n", exercises::BEGIN), " has not both marks".to_owned()),
        (
            solved.replace("let degrees = 45.0_f64;", "let a = 1;"),
            format!(
                ":{}: `let a = 1; // 45°` stands where the exercise has `let degrees",
                line("let degrees")
            ),
        ),
        (
            solved.replace("    (yours - degrees).abs() < 1e-9,", "    true,"),
            format!(":{}: `true,` stands where the exercise has `(yours", line("(yours - degrees)")),
        ),
        (
            solved.replace("standalone_crate", "ignore"),
            format!(":{}: ```", line("standalone_crate")).replace("```", "````rust,ignore` stands"),
        ),
        (
            solved.split_once("assert!").unwrap().0.to_owned(),
            format!(":{}: nothing stands where the exercise has `assert!(`", line("assert!(")),
        ),
        (filled(&exercise, "let angle = 0.0;\n```\n```text"), ": ``` ends the block".to_owned()),
    ] {
        let fault = exercises::fault(&exercise, &text).expect(&message);
        assert!(
            fault.contains(&format!("stubs/two_arrows_4.md{message}")) || fault.contains(&message),
            "{fault}"
        );
        assert!(fault.contains("exercises reset two_arrows_4"), "{fault}");
    }
}

#[test]
fn an_answer_that_goes_round_the_check_is_none() {
    for (name, answer, message) in [
        ("two_arrows_4", "let angle = 0.0_f64;\nlet degrees = 0.0;", "`let degrees` hides the `degrees`"),
        ("two_arrows_4", "let (angle, plate) = (0.0_f64, 1);", "`let plate` hides"),
        ("worked_example_2", "let tangent = 0.0;\nreturn Ok(());", "`return` would end the program"),
        ("worked_example_2", "if true { return Ok(()); }", "`return` would end"),
        ("toss_a_book_1", "    std::process::exit(0)", "`process` would end"),
    ] {
        let fault = exercises::fault(&named(name), &filled(&named(name), answer)).expect(answer);
        assert!(fault.contains(message) && fault.contains(name), "{fault}");
    }
}

#[test]
fn files_to_edit_are_made_where_they_are_missing_and_what_a_reader_wrote_stays() {
    let kept = tempfile::TempDir::new().unwrap();
    let folder = kept.path().join("stubs");
    let all = exercises::all().unwrap();
    exercises::lay_out(&all, &folder).unwrap();
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), all.len());
    for exercise in &all {
        assert_eq!(exercises::file(exercise, &folder), Ok(exercise.stub()));
    }
    let [mine, gone] = ["proofs_3.md", "proofs_2.md"].map(|name| folder.join(name));
    std::fs::write(&mine, "mine").unwrap();
    std::fs::remove_file(&gone).unwrap();
    exercises::lay_out(&all, &folder).unwrap();
    assert_eq!(std::fs::read_to_string(&mine).unwrap(), "mine");
    assert_eq!(std::fs::read_to_string(&gone).unwrap(), named("proofs_2").stub());
    assert_eq!(exercises::readable(&all, &folder), Ok(()));
}

#[test]
fn a_file_that_is_no_text_is_named_with_what_brings_it_back() {
    let kept = tempfile::TempDir::new().unwrap();
    let all = exercises::all().unwrap();
    exercises::lay_out(&all, kept.path()).unwrap();
    std::fs::write(kept.path().join("proofs_3.md"), [0xff, 0xfe, 0x00]).unwrap();
    let no_text = exercises::readable(&all, kept.path()).unwrap_err();
    assert!(no_text.starts_with("book/exercises/stubs/proofs_3.md is no text in UTF-8"), "{no_text}");
    assert!(no_text.ends_with("cargo run -- exercises reset proofs_3"), "{no_text}");
}

#[test]
fn files_that_are_no_exercise_are_refused_with_their_line() {
    let whole = "# T\n\nDo.\n\n```rust\n// -- your turn --\nlet x = todo!(\"x\");\n// -- until here --\n\
                 assert!(x > 1, \"{x}\");\n```\n\n## Hint\n\nh\n\n## Solution\n\n```rust\nlet x = 2;\n```\n\n\
                 ## Wrong: too small\n\n```rust\nlet x = 1;\n```\n";
    let read = |text: &str| exercises::Exercise::read("x_1", text);
    let exercise = read(whole).unwrap();
    assert_eq!(exercise.solved(), exercise.open().replace("todo!(\"x\")", "2"));
    for (from, to, line, what) in [
        ("// -- until here --\n", "", 1, "the two lines"),
        ("todo!(\"x\")", "0", 1, "todo!"),
        ("## Hint\n\nh\n\n", "", 1, "`## Hint`"),
        ("## Solution", "## Answer", 16, "`## Solution`"),
        ("let x = 1;", "let x = todo!(\"x\");", 22, "between the two lines"),
        ("```rust\nlet x = 2;\n```", "", 16, "one block"),
        ("# T", "T", 1, "begin with"),
        ("Do.", "", 1, "what is asked"),
    ] {
        assert!(whole.contains(from), "{from}");
        let fault = read(&whole.replace(from, to)).unwrap_err();
        assert!(fault.contains(&format!("x_1.md:{line}: ")) && fault.contains(what), "{from}: {fault}");
    }
}
