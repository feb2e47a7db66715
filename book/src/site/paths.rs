//! Where things are, from wherever the command was given.

use std::path::{Path, PathBuf};

/// The folder of the book, with `book.toml`.
pub(crate) fn book() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The folder of the chapters.
pub(crate) fn chapters() -> PathBuf {
    book().join("chapters")
}

/// The folder of the repository.
pub(crate) fn repository() -> &'static Path {
    // `CARGO_MANIFEST_DIR` is absolute and never the root of the file system.
    book().parent().unwrap_or(book())
}

/// The folder of the drawn figures.
pub(crate) fn figures() -> PathBuf {
    repository().join("figures")
}

/// The folder the pages are built into.
pub(crate) fn pages() -> PathBuf {
    book().join("html")
}
