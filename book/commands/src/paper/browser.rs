//! Printing by a browser that is installed: Chromium writes PDF with tags and an outline.

use std::env;
use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The names of the programs that can do it.
const NAMES: &str =
    "chromium chromium-browser google-chrome google-chrome-stable chrome microsoft-edge msedge";

/// Where they stand on systems that have no PATH for programs with windows.
const PLACES: [&str; 5] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
];

/// The browser that would print: the one that the variable `CHROMIUM` names, or the first that is found.
pub(crate) fn found() -> Option<PathBuf> {
    if let Some(named) = env::var_os("CHROMIUM") {
        return Some(named.into());
    }
    let folders: Vec<PathBuf> =
        env::var_os("PATH").map(|path| env::split_paths(&path).collect()).unwrap_or_default();
    let ending = env::consts::EXE_SUFFIX;
    let on_path = NAMES
        .split(' ')
        .flat_map(|name| folders.iter().map(move |folder| folder.join(format!("{name}{ending}"))));
    on_path.chain(PLACES.iter().map(PathBuf::from)).find(|file| file.is_file())
}

/// Prints an HTML file, and returns the PDF.
///
/// # Errors
/// The browser cannot be started, or prints nothing.
pub(crate) fn pdf(browser: &Path, html: &Path) -> Result<Vec<u8>, String> {
    let folder = tempfile::TempDir::new().map_err(|e| format!("no folder for the browser: {e}"))?;
    let file = folder.path().join("out.pdf");
    let option = |name: &str, path: &Path| OsString::from_iter([OsStr::new(name), path.as_os_str()]);
    let status = Command::new(browser)
        // The page is ours, runs no script and loads nothing. Without its sandbox the browser runs as any
        // user.
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-extensions", "--no-first-run"])
        .args(["--no-pdf-header-footer", "--export-tagged-pdf", "--generate-pdf-document-outline"])
        .arg(option("--user-data-dir=", &folder.path().join("profile")))
        .arg(option("--print-to-pdf=", &file))
        .arg(html)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .map_err(|e| format!("{} cannot be started: {e}", browser.display()))?;
    fs::read(&file).map_err(|_| format!("{} printed nothing ({status})", browser.display()))
}
