//! Published Python integrators, which run in a separate process and are called by lines of text.

use nalgebra::{Quaternion, Vector3};
use std::cell::RefCell;
use std::io::{BufRead as _, BufReader, Write as _};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::rc::Rc;
use tumbling::step::State;
use tumbling_measure::AnyError;
use tumbling_measure::contestant::{About, Contestant, Group, Knob, Setting};
use tumbling_measure::errors::{Ended, Observed, Outcome};
use tumbling_measure::story::Story;

/// What the program has, by its own name; the name in the record.
const SOLVERS: [(&str, &str); 2] = [("SciPy", "DOP853 (SciPy)"), ("heyoka", "Taylor series (heyoka)")];

/// A solver of `solvers.py`. It knows the stories with a torque alone.
pub struct Python {
    solver: &'static str,
    name: &'static str,
    process: Rc<RefCell<Process>>,
}

struct Process {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
}

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Process {
    fn ask(&mut self, question: &str) -> Result<String, AnyError> {
        writeln!(self.to, "{question}")?;
        self.answer()
    }

    fn answer(&mut self) -> Result<String, AnyError> {
        let mut line = String::new();
        self.from.read_line(&mut line)?;
        Ok(line.trim().to_owned())
    }
}

/// Those that the `python3` found first has, and their versions.
pub fn found() -> Result<(Vec<Box<dyn Contestant>>, Vec<String>), AnyError> {
    let mut child = Command::new("python3")
        .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/solvers.py"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()?;
    let (Some(to), Some(from)) = (child.stdin.take(), child.stdout.take()) else {
        return Err("no way to python3".into());
    };
    let mut process = Process { child, to, from: BufReader::new(from) };
    let versions: Vec<String> = process.answer()?.split_whitespace().map(|x| x.replace('=', " ")).collect();
    let process = Rc::new(RefCell::new(process));
    let here = |solver: &str| versions.iter().any(|version| version.split(' ').next() == Some(solver));
    let solvers = SOLVERS.into_iter().filter(|(solver, _)| here(solver));
    let contestants = solvers
        .map(|(solver, name)| {
            Box::new(Python { solver, name, process: Rc::clone(&process) }) as Box<dyn Contestant>
        })
        .collect();
    Ok((contestants, versions))
}

impl Contestant for Python {
    fn about(&self) -> About {
        About { name: self.name, group: Group::Peer, knob: Knob::Tolerance }
    }

    fn takes(&self, story: &Story) -> bool {
        !story.is_free()
    }

    fn run(&self, story: &Story, setting: Setting, _: Observed<'_, '_>) -> Result<Ended, Outcome> {
        let tolerance = setting.tolerance()?;
        let question = format!("{}\t{}\t{tolerance:e}", self.solver, story.name);
        let refused = |why: AnyError| Outcome::Refused(why.to_string());
        let answer = self.process.borrow_mut().ask(&question).map_err(refused)?;
        let numbers: Vec<f64> = answer.split(' ').map_while(|word| word.parse().ok()).collect();
        let [seconds, steps, w, x, y, z, l, m, n] = numbers[..] else {
            return Err(Outcome::Refused(answer));
        };
        let motion = State { attitude: Quaternion::new(w, x, y, z), momentum: Vector3::new(l, m, n) };
        Ok(Ended { motion, steps: steps as u64, seconds: Some(seconds) })
    }
}
