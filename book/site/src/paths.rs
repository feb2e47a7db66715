//! Where things are, from wherever the command was given.

use std::path::{Path, PathBuf};

/// The folder of the book, with `book.toml`.
pub fn book() -> &'static Path {
    parent(Path::new(env!("CARGO_MANIFEST_DIR")))
}

/// The folder of the chapters.
pub fn chapters() -> PathBuf {
    book().join("chapters")
}

/// The folder of the repository.
pub fn repository() -> &'static Path {
    parent(book())
}

/// `CARGO_MANIFEST_DIR` is absolute and never near the root of the file system.
fn parent(folder: &Path) -> &Path {
    folder.parent().unwrap_or(folder)
}

/// The folder of the drawn figures.
pub fn figures() -> PathBuf {
    repository().join("figures")
}

/// The folder the pages are built into.
pub fn pages() -> PathBuf {
    book().join("html")
}
