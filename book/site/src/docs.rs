//! The library's documentation, made by rustdoc and copied next to the pages, where the chapters link to it.

use crate::{files, paths};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder, next to the pages.
const FOLDER: &str = "api";

/// Runs rustdoc.
///
/// # Errors
/// Cargo could not be run or failed; its own message was printed.
pub fn make() -> Result<(), String> {
    cargo(&["doc", "--quiet", "--no-deps", "-p", "tumbling", "-p", "tumbling-scenes"])
}

/// Runs cargo in the repository.
///
/// # Errors
/// It could not be run, or did not get through; it has said why.
pub fn cargo(words: &[&str]) -> Result<(), String> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(paths::repository()).args(words);
    let status = cargo.status().map_err(|e| format!("cannot run cargo: {e}"))?;
    if status.success() { Ok(()) } else { Err(format!("{cargo:?} failed")) }
}

/// Copies the latest documentation next to the pages; returns whether there was any.
///
/// # Errors
/// A file that cannot be copied.
pub(crate) fn lay_beside(pages: &Path) -> Result<bool, String> {
    // Only the library's own pages, the files that they load, and their sources: the folder also contains
    // documentation of other crates.
    let Some(made) = made().filter(|made| made.join("tumbling/index.html").is_file()) else {
        return Ok(false);
    };
    let beside = pages.join(FOLDER);
    let ours = ["tumbling", "src/tumbling", "tumbling_scenes", "src/tumbling_scenes"];
    let loaded = ["static.files", "search.index", "trait.impl", "type.impl"];
    let parts = ours.into_iter().chain(loaded).map(|part| made.join(part)).filter(|part| part.exists());
    let beside_them = fs::read_dir(&made).into_iter().flatten().flatten().map(|entry| entry.path());
    for from in parts.chain(beside_them.filter(|path| path.is_file())) {
        copy(&from, &beside.join(from.strip_prefix(&made).unwrap_or(&from)))?;
    }
    Ok(true)
}

/// Cargo's folder for documentation, next to the folder of this program's profile.
fn made() -> Option<PathBuf> {
    let program = std::env::current_exe().ok()?;
    let target = program.ancestors().find(|folder| folder.join("doc").is_dir())?;
    Some(target.join("doc"))
}

pub(crate) fn copy(from: &Path, to: &Path) -> Result<(), String> {
    if !from.is_dir() {
        return files::write_changed(to, &files::bytes(from)?).map(|_| ());
    }
    let cannot = |e: std::io::Error| format!("cannot read {}: {e}", from.display());
    for entry in fs::read_dir(from).map_err(cannot)? {
        let entry = entry.map_err(cannot)?;
        copy(&entry.path(), &to.join(entry.file_name()))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_module_of_the_library_is_on_its_page() {
        let root = paths::repository();
        let library = fs::read_to_string(root.join("src/lib.rs")).unwrap();
        let page = fs::read_to_string(paths::chapters().join("library.md")).unwrap();
        let modules: Vec<&str> =
            library.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';')).collect();
        assert!(modules.len() >= 7);
        for module in modules {
            let link = format!("({FOLDER}/tumbling/{module}/index.html)");
            assert!(page.contains(&link), "the chapter library.md does not link to {link}");
        }
    }

    #[test]
    fn a_folder_is_copied_with_all_below_it() {
        let folder = tempfile::TempDir::new().unwrap();
        let [from, to] = ["from", "to"].map(|name| folder.path().join(name));
        fs::create_dir_all(from.join("a/b")).unwrap();
        fs::write(from.join("a/b/c"), "text").unwrap();
        copy(&from, &to).unwrap();
        assert_eq!(fs::read_to_string(to.join("a/b/c")).unwrap(), "text");
    }
}
