//! Reading and writing files.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The bytes of a file.
///
/// # Errors
/// That it cannot be read, in a sentence with its name.
pub fn bytes(file: &Path) -> Result<Vec<u8>, String> {
    fs::read(file).map_err(|e| format!("cannot read {}: {e}", file.display()))
}

/// The text of a file.
///
/// # Errors
/// That it cannot be read, in a sentence with its name.
pub fn text(file: &Path) -> Result<String, String> {
    fs::read_to_string(file).map_err(|e| format!("cannot read {}: {e}", file.display()))
}

/// A table of texts by the names of pages; empty where there is no such file.
///
/// # Errors
/// The fault in the file.
pub fn table(file: &Path) -> Result<BTreeMap<String, String>, String> {
    if !file.is_file() {
        return Ok(BTreeMap::new());
    }
    toml::from_str(&text(file)?).map_err(|e| format!("{}: {e}", file.display()))
}

/// The pages that `SUMMARY.md` in this folder lists, in order: the name of each file without its ending, and
/// its title.
///
/// # Errors
/// That it cannot be read.
pub fn listed(folder: &Path) -> Result<Vec<(String, String)>, String> {
    let line = |line: &str| {
        let item = line.trim().trim_start_matches(|c: char| c.is_ascii_digit() || " \t-*+.".contains(c));
        let (title, file) = item.strip_prefix('[')?.split_once("](")?;
        Some((file.strip_suffix(".md)")?.to_owned(), title.to_owned()))
    };
    Ok(text(&folder.join("SUMMARY.md"))?.lines().filter_map(line).collect())
}

/// Writes the file where its content differs, with the folders above it; returns whether it did. A file that
/// stays as it is wakes neither cargo nor a watching `mdbook serve`.
///
/// # Errors
/// A file or folder that cannot be written.
pub fn write_changed(file: &Path, content: &[u8]) -> Result<bool, String> {
    if fs::read(file).is_ok_and(|old| old == content) {
        return Ok(false);
    }
    file.parent()
        .map_or(Ok(()), fs::create_dir_all)
        .and_then(|()| fs::write(file, content))
        .map_err(|e| format!("cannot write {}: {e}", file.display()))?;
    Ok(true)
}

/// Writes these files into a folder, and removes all others from it.
///
/// # Errors
/// A file that cannot be written.
pub fn lay_out(folder: &Path, files: &BTreeMap<String, Vec<u8>>) -> Result<(), String> {
    for (name, bytes) in files {
        write_changed(&folder.join(name), bytes)?;
    }
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.file_name().to_str().is_none_or(|name| !files.contains_key(name)) {
            let _ = fs::remove_file(entry.path()); // of an earlier edition
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_written_only_where_it_changes() {
        let folder = tempfile::TempDir::new().unwrap();
        let file = folder.path().join("a/b.txt");
        assert_eq!(write_changed(&file, b"one"), Ok(true));
        assert_eq!(write_changed(&file, b"one"), Ok(false));
        assert_eq!(write_changed(&file, b"two"), Ok(true));
        assert_eq!(fs::read(&file).unwrap(), b"two");
        assert!(write_changed(&file.join("c"), b"one").unwrap_err().contains("cannot write"));
    }
}
