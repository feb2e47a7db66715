//! What the manifests say of versions.

use tumbling_site::{files, paths};

/// The versions that the pages name, each with its name: `Rust 1.95`.
///
/// # Errors
/// A manifest that cannot be read, or that lacks one of them.
pub(crate) fn versions() -> Result<Vec<String>, String> {
    let manifest = |folder: &std::path::Path| -> Result<toml::Table, String> {
        let file = folder.join("Cargo.toml");
        files::text(&file)?.parse().map_err(|e| format!("{}: {e}", file.display()))
    };
    let (whole, site) = (manifest(paths::repository())?, manifest(&paths::book().join("site"))?);
    let package = |key: &str| whole.get("workspace")?.get("package")?.get(key)?.as_str();
    let mdbook = || site.get("dependencies")?.get("mdbook-preprocessor")?.as_str()?.rsplit_once('.');
    let versions = [
        ("Rust", package("rust-version")),
        ("Apache", package("license").and_then(|license| license.rsplit_once("Apache-")).map(|(_, v)| v)),
        ("mdBook", mdbook().map(|(major_minor, _)| major_minor)),
    ];
    let named = |(name, version): (&str, Option<&str>)| {
        version
            .map(|v| format!("{name} {v}"))
            .ok_or_else(|| format!("the manifests have no version of {name}"))
    };
    versions.into_iter().map(named).collect()
}
