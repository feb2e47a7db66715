//! Writing files.

use std::fs;
use std::path::Path;

/// Writes the file where its content differs, with the folders above it; returns whether it did. A file that
/// stays as it is wakes neither cargo nor a watching `mdbook serve`.
///
/// # Errors
/// A file or folder that cannot be written.
pub(crate) fn write_changed(file: &Path, content: &[u8]) -> Result<bool, String> {
    if fs::read(file).is_ok_and(|old| old == content) {
        return Ok(false);
    }
    file.parent()
        .map_or(Ok(()), fs::create_dir_all)
        .and_then(|()| fs::write(file, content))
        .map_err(|e| format!("cannot write {}: {e}", file.display()))?;
    Ok(true)
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
