//! The machine and the date, for the heads of the record.

use std::process::Command;
use std::thread::available_parallelism;

/// Whether this build is for measurement: builds for tests are optimised less.
pub const IS_RELEASE: bool = matches!(env!("BUILT_FOR").as_bytes(), b"release");

/// The head of a record: what its columns are, then when it was measured, on which machine, built by what.
#[must_use]
pub fn head(what: &[(&str, &str)]) -> Vec<(String, String)> {
    let cores = available_parallelism().map_or(0, usize::from);
    let profile = if IS_RELEASE { "release" } else { "built for tests: not for the record" };
    let circumstances = [
        ("when", today().unwrap_or_else(|| "unknown".to_owned())),
        ("machine", format!("{}, {cores} cores, {}", processor(), std::env::consts::OS)),
        ("compiler", format!("{}, {profile}", env!("MEASURED_WITH"))),
        ("tumbling", env!("CARGO_PKG_VERSION").to_owned()),
    ];
    let what = what.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned()));
    what.chain(circumstances.map(|(key, value)| (key.to_owned(), value))).collect()
}

/// What the processor calls itself.
fn processor() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned())
}

/// The date (UTC) as 2026-11-21, by the system's own program.
fn today() -> Option<String> {
    let output = Command::new("date").args(["-u", "+%F"]).output().ok()?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned()).filter(|date| !date.is_empty())
}
