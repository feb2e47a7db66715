//! Draws figures into their committed files, or checks that the files are up to date.

use crate::files::write_changed;
use crate::say;
use std::any::Any;
use std::collections::VecDeque;
use std::fs;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};
use tumbling_figures::{Figure, registry};

/// Draws these figures into `folder`; only files whose bytes change are written.
///
/// # Errors
/// The names of the figures that could not be drawn or written; the others were drawn.
pub fn draw(figures: &[&Figure], folder: &Path) -> Result<(), String> {
    let start = Instant::now();
    let mut changed = 0;
    let mut failures = Vec::new();
    each_made(
        figures.len(),
        |at| figures[at].draw().map_err(|e| e.to_string()),
        |at, drawn, took| {
            let name = figures[at].name;
            match drawn.and_then(|svg| write_changed(&file_of(figures[at], folder), svg.as_bytes())) {
                Ok(new) => {
                    changed += usize::from(new);
                    let news = if new { "new" } else { "as it was" };
                    say!("  {name:24} {:6.2} s  {news}", took.as_secs_f64());
                }
                Err(reason) => failures.push(format!("figure `{name}`: {reason}")),
            }
            Ok::<(), String>(())
        },
    )?;
    none_or(&failures)?;
    say!("Drew {} figures ({changed} changed) in {:.1} s.", figures.len(), start.elapsed().as_secs_f64());
    Ok(())
}

/// All that went wrong, as an error.
pub fn none_or(failures: &[String]) -> Result<(), String> {
    if failures.is_empty() { Ok(()) } else { Err(failures.join("\n")) }
}

/// Compares these figures with their committed files.
///
/// # Errors
/// The names of figures whose files are missing or differ, of figures that could not be drawn, and, when all
/// figures were requested, of drawings in the folder that no figure draws.
pub fn check(figures: &[&Figure], folder: &Path) -> Result<(), String> {
    let mut wrong = Vec::new();
    each_made(
        figures.len(),
        |at| figures[at].draw().map_err(|e| e.to_string()),
        |at, drawn, _| {
            let reason = match (drawn, fs::read_to_string(file_of(figures[at], folder))) {
                (Err(reason), _) => reason,
                (_, Err(_)) => "the file is missing".into(),
                (Ok(svg), Ok(old)) if old != svg => "the file is not what would be drawn".into(),
                _ => return Ok::<(), String>(()),
            };
            wrong.push(format!("  {}: {reason}", figures[at].name));
            Ok(())
        },
    )?;
    if figures.len() == registry().len() {
        wrong.extend(strays(figures, folder));
    }
    if wrong.is_empty() {
        say!("All {} figures are as committed.", figures.len());
        return Ok(());
    }
    wrong.sort();
    Err(format!(
        "these figures are not up to date (`cargo run -- figures` draws them):\n{}",
        wrong.join("\n")
    ))
}

/// Drawings that belong to no figure.
fn strays(figures: &[&Figure], folder: &Path) -> Vec<String> {
    let Ok(entries) = fs::read_dir(folder) else {
        return vec![format!("  cannot read {}", folder.display())];
    };
    entries
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter_map(|file| file.strip_suffix(".svg").map(str::to_owned))
        .filter(|name| figures.iter().all(|figure| figure.name != name))
        .map(|name| format!("  {name}.svg: no figure draws it"))
        .collect()
}

fn file_of(figure: &Figure, folder: &Path) -> PathBuf {
    folder.join(format!("{}.svg", figure.name))
}

/// Makes `count` things on all cores, and passes each to `take`, in order, with the time that it took.
///
/// # Errors
/// The first error of `take`; nothing more is made after it.
pub fn each_made<T: Send, E>(
    count: usize,
    make: impl Fn(usize) -> Result<T, String> + Sync,
    mut take: impl FnMut(usize, Result<T, String>, Duration) -> Result<(), E>,
) -> Result<(), E> {
    let one = |at: usize| {
        let start = Instant::now();
        (make(at), start.elapsed())
    };
    // More than there are cores: while the first of them is waited for, the others are made.
    let most = 2 * thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        let mut running = VecDeque::new();
        for at in 0..count + most {
            if at < count {
                running.push_back((at, scope.spawn(move || one(at))));
            }
            if at + 1 >= most
                && let Some((due, thread)) = running.pop_front()
            {
                let (made, took) =
                    thread.join().unwrap_or_else(|panic| (Err(words_of(&*panic)), Duration::ZERO));
                take(due, made, took)?;
            }
        }
        Ok(())
    })
}

fn words_of(panic: &(dyn Any + Send)) -> String {
    let words =
        panic.downcast_ref::<String>().map(String::as_str).or_else(|| panic.downcast_ref::<&str>().copied());
    format!("its program panicked: {}", words.unwrap_or("without a word"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_that_no_figure_draws_is_named() {
        let folder = tempfile::TempDir::new().unwrap();
        fs::write(folder.path().join("left-over.svg"), "<svg></svg>").unwrap();
        fs::write(folder.path().join("lib.rs"), "").unwrap();
        assert_eq!(strays(&[], folder.path()), ["  left-over.svg: no figure draws it"]);
    }
}
