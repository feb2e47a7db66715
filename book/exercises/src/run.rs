//! Runs the reader's files, and tells what came of it in few words.

use std::collections::BTreeMap;
use std::io::{BufRead as _, BufReader, Read as _};
use std::process::{Command, Stdio};
use std::thread;

/// Runs the blocks of these exercises, and gives what `cargo test` prints of them. Each line of what cargo
/// says meanwhile goes to `heard`.
///
/// # Errors
/// All that cargo said, if it came to no test.
pub fn run(names: &[impl AsRef<str>], mut heard: impl FnMut(&str)) -> Result<String, String> {
    let cannot = |e: std::io::Error| format!("cannot run cargo: {e}");
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["test", "--package", "tumbling-exercises", "--doc", "--features", "mine", "--"])
        .args(names.iter().map(AsRef::as_ref))
        .env("CARGO_TERM_COLOR", "never")
        // What is read is the assertion's message, not the way there.
        .env("RUST_BACKTRACE", "0")
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(cannot)?;
    let out = cargo.stdout.take();
    let out = thread::spawn(move || {
        let mut output = Vec::new();
        let read = out.map_or(Ok(0), |mut out| out.read_to_end(&mut output));
        read.map(|_| String::from_utf8_lossy(&output).into_owned())
    });
    let mut said = String::new();
    for line in cargo.stderr.take().map(BufReader::new).into_iter().flat_map(|err| err.split(b'\n')) {
        let line = line.map_err(cannot)?;
        let line = String::from_utf8_lossy(&line);
        heard(&line);
        said.push_str(&line);
        said.push('\n');
    }
    cargo.wait().map_err(cannot)?;
    let output = out.join().map_err(|_| "what cargo prints could not be read".to_owned())?.map_err(cannot)?;
    if output.contains("test result: ") {
        Ok(output)
    } else {
        Err(format!("The exercises could not be run:\n{output}{said}"))
    }
}

/// Which exercises ran, by what `cargo test` prints, and whether all of each passed.
#[must_use]
pub fn passed(output: &str) -> BTreeMap<String, bool> {
    let mut passed = BTreeMap::new();
    for line in output.lines() {
        if let Some((_, rest)) = line.strip_prefix("test ").and_then(|line| line.rsplit_once(" - mine::"))
            && let Some((name, rest)) = rest.split_once(" (line ")
        {
            *passed.entry(name.to_owned()).or_insert(true) &= rest.ends_with("... ok");
        }
    }
    passed
}

/// Whether these exercises are solved, by what `cargo test` prints: each ran, and passed.
///
/// # Errors
/// For each that failed what it said, with the line it failed at; or which did not run.
pub fn verdict(names: &[impl AsRef<str>], output: &str) -> Result<(), String> {
    let passed = passed(output);
    for name in names {
        let name = name.as_ref();
        if !passed.contains_key(name) {
            return Err(format!(
                "Nothing ran for `{name}`, so nothing is solved. This brings its file back:\n    \
                 cargo run -- exercises reset {name}"
            ));
        }
    }
    if names.iter().all(|name| passed[name.as_ref()]) {
        return Ok(());
    }
    let said: Vec<String> = failures(output).map(|(name, body)| sentence(name, body)).collect();
    Err(if said.is_empty() { output.to_owned() } else { said.join("\n\n") })
}

/// The failures' names, and what is printed of each.
fn failures(output: &str) -> impl Iterator<Item = (&str, &str)> {
    let output = output.rsplit_once("\nfailures:\n").map_or(output, |(details, _)| details);
    output.split("\n---- ").skip(1).filter_map(|section| {
        let (title, body) = section.split_once(" stdout ----\n")?;
        Some((title.rsplit_once("mine::")?.1.split_once(" (line ")?.0, body))
    })
}

/// What a block said itself, and where; of one that does not compile, all.
fn sentence(name: &str, body: &str) -> String {
    let mut place = String::new();
    let mut kept = Vec::new();
    for line in body.lines() {
        if let Some((_, at)) = line.strip_prefix("thread ").and_then(|line| line.split_once(" panicked at "))
        {
            if let Some(number) = at.rsplit_once(".md:").and_then(|(_, at)| at.split(':').next()) {
                place = format!("\n    at book/exercises/stubs/{name}.md:{number}");
            }
        } else if !matches!(line, "stdout:" | "stderr:")
            && !line.starts_with("Test executable failed (")
            && !line.starts_with("note: run with `RUST_BACKTRACE=")
        {
            kept.push(line);
        }
    }
    let said = kept.join("\n");
    if body.starts_with("error") || body.contains("Couldn't compile the test") || said.trim().is_empty() {
        return format!("{name}:\n{}", body.trim());
    }
    format!("{name}: {}{place}", said.trim())
}

#[cfg(test)]
mod tests {
    use super::{passed, verdict};

    #[test]
    fn a_run_tells_which_pass_and_an_exercise_passes_if_all_of_its_blocks_do() {
        let output = "running 4 tests\n\
            test /a b/book/exercises/stubs/two_arrows_1.md - mine::two_arrows_1 (line 7) ... ok\n\
            test /a b/book/exercises/stubs/proofs_2.md - mine::proofs_2 (line 9) ... FAILED\n\
            test /a b/book/exercises/stubs/proofs_1.md - mine::proofs_1 (line 9) ... ok\n\
            test /a b/book/exercises/stubs/proofs_1.md - mine::proofs_1 (line 30) ... FAILED\n\
            test result: FAILED. 2 passed\n";
        let passed = passed(output);
        assert_eq!(passed.len(), 3);
        assert!(passed["two_arrows_1"] && !passed["proofs_1"] && !passed["proofs_2"]);
        assert_eq!(verdict(&["two_arrows_1"], output), Ok(()));
        assert!(verdict(&["two_arrows_1", "proofs_1"], output).is_err());
    }

    #[test]
    fn an_exercise_of_which_nothing_ran_is_not_solved() {
        let output = "running 0 tests\n\ntest result: ok. 0 passed; 0 failed\n";
        let why = verdict(&["two_arrows_1"], output).unwrap_err();
        assert!(
            why.starts_with("Nothing ran for `two_arrows_1`") && why.contains("reset two_arrows_1"),
            "{why}"
        );
    }

    const FAILED: &str = "\nrunning 1 test\n\
        test /r/book/exercises/stubs/two_arrows_1.md - mine::two_arrows_1 (line 7) ... FAILED\n\nfailures:\n\n\
        ---- /r/book/exercises/stubs/two_arrows_1.md - mine::two_arrows_1 (line 7) stdout ----\n";
    const ENDS: &str = "\n\nfailures:\n    /r/book/exercises/stubs/two_arrows_1.md - mine::two_arrows_1 (line 7)\n\n\
        test result: FAILED. 0 passed; 1 failed; 0 ignored\n";

    #[test]
    fn of_a_panic_its_own_words_and_its_line_are_told_and_no_more() {
        let output = format!(
            "{FAILED}Test executable failed (exit status: 101).\n\nstderr:\n\n\
             thread 'main' (6613) panicked at /r/book/exercises/stubs/two_arrows_1.md:12:30:\n\
             you have 3 kg m²/s, it is 4: part by part\n\
             note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace\n{ENDS}"
        );
        assert_eq!(
            verdict(&["two_arrows_1"], &output).unwrap_err(),
            "two_arrows_1: you have 3 kg m²/s, it is 4: part by part\n    \
             at book/exercises/stubs/two_arrows_1.md:12"
        );
        let printed = output.replace("exit status: 101).\n", "exit status: 101).\n\nstdout:\nx is 3\n");
        let why = verdict(&["two_arrows_1"], &printed).unwrap_err();
        assert!(
            why.contains("x is 3") && why.contains("you have 3"),
            "what the reader prints is kept: {why}"
        );
    }

    #[test]
    fn of_a_block_that_does_not_compile_all_is_told() {
        let errors = "error[E0425]: cannot find value `y`\n --> stubs/two_arrows_1.md:12:9\n\nerror: aborting\n\n\
                      Couldn't compile the test.";
        let why = verdict(&["two_arrows_1"], &format!("{FAILED}{errors}{ENDS}")).unwrap_err();
        assert!(why.ends_with(errors), "{why}");
    }
}
