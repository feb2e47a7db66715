//! The exercises are exercises: left open, each stops at its own `todo!`; solved, each passes; answered wrongly, each is
//! refused by an assertion, and told why. All blocks are compiled, so none fails for that.

use std::cell::RefCell;
use std::{panic, thread};
use tumbling_exercises as exercises;

/// A block of an exercise, to be run.
pub struct Run {
    name: &'static str,
    variant: &'static str,
    run: fn(),
}

#[allow(unused, unreachable_code, missing_docs, clippy::all, clippy::unwrap_used)]
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

/// Whom of these variants the test is told about, and what of each.
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
            (p.message.len() < 40).then(|| format!("{} is told too little: {}", run.label(), p.message))
        }
        Err(p) => Some(format!("{} ends by no assertion, but: {} at {}", run.label(), p.message, p.line)),
        Ok(()) => Some(format!("{} passes", run.label())),
    });
    let all: Vec<String> = [open, solved, wrong].concat();
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn every_chapter_has_three_to_five_exercises_and_every_exercise_a_file_to_edit() {
    let all = exercises::all().unwrap();
    for chapter in exercises::chapters() {
        let count = all.iter().filter(|e| e.place().0 == chapter).count();
        assert!((3..=5).contains(&count), "{chapter} has {count}");
    }
    let unmatched = exercises::unmatched(&all).unwrap();
    assert!(unmatched.is_empty(), "in stubs/ and not in whole/, or the other way round: {unmatched:?}");
}

#[test]
fn the_file_to_edit_differs_from_the_solution_in_the_marked_place_alone() {
    for exercise in exercises::all().unwrap() {
        let around = |text: &str| {
            let (before, rest) = text.split_once(exercises::BEGIN).unwrap();
            (before.to_owned(), rest.split_once(exercises::END).unwrap().1.to_owned())
        };
        assert_eq!(around(&exercise.open()), around(&exercise.solved()), "{}", exercise.name);
        assert!(exercise.stub().contains(&exercise.open()), "{}", exercise.name);
        assert!(!exercise.stub().contains(exercise.solution()), "{} tells its solution", exercise.name);
    }
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
