//! `cargo run`: hands each command to the package that carries it out, so that only what it needs is
//! compiled. Options of cargo itself reach that build by its environment alone (`CARGO_NET_OFFLINE=true`).

use std::env;
use std::ffi::OsString;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, ExitCode};

const SITE: &str = "tumbling-site";
const EXERCISES: &str = "tumbling-exercises-command";
const COMMANDS: &str = "tumbling-commands";

fn main() -> ExitCode {
    let (package, words) = handed(env::args_os().skip(1).collect());
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["run", "--manifest-path", concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml")]);
    cargo.args(["--package", package]);
    // Built like this program, whose folder has the name of its profile; the first time cargo shows how far
    // it has come.
    if let Some(folder) = env::current_exe().ok().as_deref().and_then(Path::parent) {
        let program = if package == EXERCISES { "exercise" } else { package };
        if folder.join(program).with_extension(env::consts::EXE_EXTENSION).is_file() {
            cargo.arg("--quiet");
        }
        if folder.ends_with("release") {
            cargo.arg("--release");
        }
    }
    match cargo.arg("--").args(words).status() {
        Ok(status) => ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)),
        Err(reason) => {
            let _ = writeln!(std::io::stderr().lock(), "error: cannot run cargo: {reason}");
            ExitCode::FAILURE
        }
    }
}

/// The package that carries out this command, and its own arguments.
fn handed(mut words: Vec<OsString>) -> (&'static str, Vec<OsString>) {
    let known: Vec<&str> = words.iter().map(|word| word.to_str().unwrap_or_default()).collect();
    match known[..] {
        _ if known.contains(&"--help") || known.contains(&"-h") => (COMMANDS, words),
        [] | ["build"] | ["build", "--site", _] => (SITE, words),
        ["exercises"] => (EXERCISES, vec!["list".into()]),
        ["exercises", ..] => (EXERCISES, words.split_off(1)),
        _ => (COMMANDS, words),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_command_goes_to_the_smallest_package_that_knows_it() {
        for (words, package, own) in [
            ("", SITE, ""),
            ("build --site x.org", SITE, "build --site x.org"),
            ("exercises", EXERCISES, "list"),
            ("exercises reset two_arrows_1", EXERCISES, "reset two_arrows_1"),
            ("build --help", COMMANDS, "build --help"),
            ("film book", COMMANDS, "film book"),
        ] {
            let split = |words: &str| words.split_whitespace().map(OsString::from).collect();
            assert_eq!(handed(split(words)), (package, split(own)), "{words}");
        }
    }
}
