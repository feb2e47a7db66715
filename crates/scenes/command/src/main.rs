//! Answers a scene from a file, in the cheapest way that is accurate enough.
//!
//! ```text
//! cargo scene FILE.toml             the states, as comma-separated values
//! cargo scene --summary FILE.toml   each body in a few lines
//! cargo scene --explain FILE.toml   what was chosen, what left out, what it costs
//! ```
//!
//! With `cargo run -p tumbling-scenes-command --features threads -- FILE.toml` a scene of many bodies is
//! distributed over the processor's cores.
//!
//! The columns are those requested: the spin in body axes, rad/s; the attitude, body to world, scalar part
//! first; the kinetic energy, J; the angle between spin and momentum, rad. Lines are in order of time, all
//! bodies at each; of more than 256 bodies, block by block. Numbers have 17 digits. Flips and the polhode do
//! not belong to a single time; they are in the summary, which is printed in any case if nothing else is
//! requested.
//!
//! A body that cannot be answered gets a line on standard error and the program ends with 1 after answering
//! the others. It ends with 2 for a file that is no scene, wrong arguments, or answers that cannot be
//! written.

mod file;

use clap::Parser as _;
use file::File;
use indicatif::{ProgressBar, ProgressStyle};
use std::fmt::Write as _;
use std::io::{self, BufWriter, ErrorKind, IsTerminal as _, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use tumbling_scenes::batch::{self, Block};
use tumbling_scenes::{Answer, Error, FlipTimes, Outputs, Plan};

const HELP: &str = "FILE.toml has the bodies, the torques and what is requested:

    accuracy = 1e-9              # of angles (rad), and of spin and energy relative to their largest
    span = 10.0                  # s
    every = 0.1                  # s; or instead of the two: times = [0.0, 0.5, 2.0]
    wants = [\"spin\", \"flips\"]  # of spin, attitude, energy, angle-to-momentum, flips, polhode

    [[body]]                     # as many as you like
    body = \"phone\"               # a body of the book, FILE.toml or FILE.urdf#LINK; or what such a file holds:
                                 #   moments = [xx, yy, zz], kg m^2, with products = [xy, xz, yz]; or a shape,
                                 #   parts, a mesh (`cargo doc -p tumbling-bodies` has all fields)
    spin = [0.01, 10.0, 0.0]     # rad/s, body axes; or momentum = [..], kg m^2/s, world axes
    attitude = [1, 0, 0, 0]      # body to world, scalar part first; this one if left out

    [[torque]]                   # none, or as many as you like, each on every body: one of
    damping = [0.1, 0.1, 0.1]    #   N m s, along the principal axes
                                 #   in-body = [..], in-world = [..]: N m
                                 #   arm = [..] (m, body axes) with field = [..] (N, world axes): a weight
                                 #   moment = [..] (A m^2, body axes) with field = [..] (T): a magnet
                                 #   arm = [..] with rest = [..] (world axes) and stiffness = 8.0 (N m): a spring
                                 #   toward = [..] (length 1) with orbit = [..] (rad/s), world axes: gravity gradient
                                 #   amplitude = [..] (N m, body axes) with rate = 3.0 (rad/s): a push to and fro
                                 #   dissipation = 0.1: turns spin into heat and keeps the momentum
    from = 2.0                   # s: when it begins; and to = 3.5, when it ends: either, both or none

Files to begin with are in crates/scenes/files.";

/// Answers a scene from a file, in the cheapest way that is accurate enough.
#[derive(clap::Parser)]
#[command(name = "scene", after_help = HELP)]
struct Arguments {
    /// Each body in a few lines: its last state, all flips, the polhode.
    #[arg(long, conflicts_with = "explain")]
    summary: bool,
    /// What was chosen for each body, what was left out and why, what it costs.
    #[arg(long)]
    explain: bool,
    /// The scene.
    #[arg(value_name = "FILE.toml")]
    file: PathBuf,
}

/// A line on standard error, if it takes one.
fn complain(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

fn main() -> ExitCode {
    let wanted = Arguments::parse();
    let path = &wanted.file;
    let name = path.to_string_lossy().into_owned();
    let read = |text| file::read(text, path.parent().unwrap_or(Path::new("")));
    let file = match tumbling_bodies::read_text(path).and_then(read) {
        Ok(file) => file,
        Err(error) => {
            complain(&error.in_file(path).to_string());
            return ExitCode::from(2);
        }
    };
    let mut out = BufWriter::new(io::stdout().lock());
    let answered = answer(&file, &wanted, &name, &mut out).and_then(|failed| out.flush().map(|()| failed));
    match answered {
        Ok(0) => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        // A reader that closes the pipe has read what it wanted.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            complain(&format!("the answers cannot be written: {error}"));
            ExitCode::from(2)
        }
    }
}

/// Writes the answers; returns the number of bodies that have none.
fn answer(file: &File, wanted: &Arguments, name: &str, out: &mut impl Write) -> io::Result<usize> {
    let scene = &file.scene;
    let outputs = scene.outputs();
    if outputs.states() && !wanted.summary && !wanted.explain {
        writeln!(out, "{}", columns(outputs).join(","))?;
        if outputs.flips || outputs.polhode {
            complain(&format!("{name}: flips and polhode do not belong to a single time: see --summary"));
        }
        return states(file, name, out);
    }
    let mut failed = 0;
    let mut alike: Vec<(String, Vec<usize>)> = Vec::new();
    for index in 0..scene.bodies().len() {
        let of_body = |source| Error::Body { index, source: Box::new(source) };
        let found = scene.plan(index).and_then(|plan| match wanted.explain {
            true => Ok((plan.explain(), None)),
            false => summary(&plan, index, outputs).map_err(of_body),
        });
        match found {
            Ok((text, _)) if wanted.explain => match alike.iter_mut().find(|(other, _)| *other == text) {
                Some((_, bodies)) => bodies.push(index),
                None => alike.push((text, vec![index])),
            },
            Ok((text, flips)) => {
                out.write_all(text.as_bytes())?;
                // One at a time: they may be more than memory holds.
                for flip in flips.into_iter().flatten() {
                    writeln!(out, "            at {flip:.16e} s")?;
                }
            }
            Err(error) => {
                failed += 1;
                complain(&file.error(index, &error).in_file(Path::new(name)).to_string());
            }
        }
    }
    for (text, bodies) in alike {
        writeln!(out, "{}\n{text}", names(&bodies))?;
    }
    Ok(failed)
}

/// The bodies that one plan is for.
fn names(bodies: &[usize]) -> String {
    const FEW: usize = 8;
    let words: Vec<String> = bodies.iter().take(FEW).map(ToString::to_string).collect();
    match (words.as_slice(), bodies.len()) {
        ([one], _) => format!("body {one}"),
        (_, count) if count > FEW => format!("bodies {}, ... ({count} of them)", words.join(", ")),
        _ => format!("bodies {}", words.join(", ")),
    }
}

/// Writes the states, block by block as they are answered.
fn states(file: &File, name: &str, out: &mut impl Write) -> io::Result<usize> {
    let bar = bar(file.scene.times().count().saturating_mul(file.scene.bodies().len() as u64));
    let (mut failed, mut written) = (0, Ok(()));
    batch::run(&file.scene, lines, |block| {
        let (lines, states, wrong) = block;
        for (index, error) in wrong {
            failed += 1;
            let error = file.error(index, &error).in_file(Path::new(name));
            bar.suspend(|| complain(&error.to_string()));
        }
        written = out.write_all(lines.as_bytes());
        bar.inc(states);
        if written.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    bar.finish_and_clear();
    written.map(|()| failed)
}

/// A block as it is printed, its number of states, and the bodies that have none.
fn lines(block: &Block<'_>) -> (String, u64, Vec<(usize, Error)>) {
    let (mut text, mut count) = (String::new(), 0);
    for (body, state) in block.states() {
        let Answer { time, spin, attitude, energy, angle_to_momentum } = state;
        count += 1;
        let quaternion = attitude.map(|q| [q.w, q.i, q.j, q.k]);
        let numbers =
            spin.iter().flatten().chain(quaternion.iter().flatten()).chain(energy).chain(angle_to_momentum);
        // Text takes all that is written to it.
        let _ = write!(text, "{body},{time:.16e}");
        for x in numbers {
            let _ = write!(text, ",{x:.16e}");
        }
        text.push('\n');
    }
    (text, count, block.wrong.to_vec())
}

/// A progress bar, if standard error is a terminal and the answers do not scroll it away.
fn bar(length: u64) -> ProgressBar {
    if !io::stderr().is_terminal() || io::stdout().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} states, {eta} left");
    ProgressBar::new(length).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

fn columns(outputs: Outputs) -> Vec<&'static str> {
    let names: [(bool, &[&str]); 5] = [
        (true, &["body", "t [s]"]),
        (outputs.spin, &["wx [rad/s]", "wy [rad/s]", "wz [rad/s]"]),
        (outputs.attitude, &["qw", "qx", "qy", "qz"]),
        (outputs.energy, &["kinetic energy [J]"]),
        (outputs.angle_to_momentum, &["angle to momentum [rad]"]),
    ];
    names.into_iter().filter(|(wanted, _)| *wanted).flat_map(|(_, names)| names).copied().collect()
}

/// A body in a few lines, and its flips.
fn summary(plan: &Plan<'_>, index: usize, outputs: Outputs) -> Result<(String, Option<FlipTimes>), Error> {
    let mut text = format!("body {index}\n");
    let Some(last) = plan.states().last().transpose()? else { return Ok((text, None)) };
    let mut line = |line: String| text.extend([&line, "\n"]);
    line(format!("at {} s", last.time));
    if let Some(w) = last.spin {
        line(format!("  spin      {:.16e} {:.16e} {:.16e} rad/s, body axes", w.x, w.y, w.z));
    }
    if let Some(q) = last.attitude {
        line(format!("  attitude  {:.16e} {:.16e} {:.16e} {:.16e}, body to world", q.w, q.i, q.j, q.k));
    }
    if let Some(energy) = last.energy {
        line(format!("  energy    {energy:.16e} J, kinetic"));
    }
    if let Some(angle) = last.angle_to_momentum {
        line(format!("  angle to momentum {angle:.16e} rad"));
    }
    if outputs.polhode {
        let polhode = plan.polhode()?;
        for (word, size) in [("least", polhode.least), ("greatest", polhode.greatest)] {
            let [x, y, z] = size.into();
            line(format!("  {word:9} {x:.16e} {y:.16e} {z:.16e} rad/s, along the principal axes"));
        }
        let period = polhode.period.map_or_else(|| "none".to_owned(), |period| format!("{period:.16e} s"));
        line(format!("  period    {period}"));
    }
    let flips = if outputs.flips { Some(plan.flips()?) } else { None };
    if let Some(flips) = &flips {
        line(format!("  flips     {}", flips.remaining()));
    }
    Ok((text, flips))
}
