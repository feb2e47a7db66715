//! The example program that answers cases from a file: right ones in full, wrong ones by name.

use serde_json::Value;
use std::path::PathBuf;
use std::process::{Command, Output};

/// Built next to this test by the same command.
fn program() -> PathBuf {
    let mut path = std::env::current_exe().unwrap();
    path.pop();
    path.pop();
    path.join("examples").join(format!("free_motion{}", std::env::consts::EXE_SUFFIX))
}

/// A file of this name, and the folder that holds it.
fn written(name: &str, text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::TempDir::new().unwrap();
    let file = folder.path().join(format!("{name}.json"));
    std::fs::write(&file, text).unwrap();
    (folder, file)
}

fn run(name: &str, text: &str) -> Output {
    let (_folder, file) = written(name, text);
    Command::new(program()).arg(&file).output().unwrap()
}

#[test]
fn a_case_that_cannot_be_answered_is_named_and_the_others_are_answered() {
    let good = r#"{"name": "good", "inertia": ["1.0", 2, 2.5], "w0": [0, "-1", 0], "t": ["0.0", 3]}"#;
    let wrong = [
        (r#"{"name": "rod", "inertia": [1, 1, 5], "w0": [0, 0, 1], "t": [1]}"#, "triangle inequality"),
        (r#"{"name": "lost", "inertia": [1, 1, 1], "t": [1]}"#, "missing field `w0`"),
        (r#"{"name": "odd", "inertia": [1, 1, 1], "w0": [0, "NaN", 1], "t": [1]}"#, "not a finite number"),
        (r#"{"name": "word", "inertia": [1, 1, 1], "w0": [0, 0, 1], "t": ["soon"]}"#, "not a finite number"),
        (r#"{"name": "flat", "inertia": [1, 1], "w0": [0, 0, 1], "t": [1]}"#, "invalid length 2"),
        (r#"{"inertia": [1, 1, 1], "w0": [0, 0, 1], "t": [1]}"#, "missing field `name`"),
        (r#"17"#, "expected struct Named"),
    ];
    let cases: Vec<&str> = wrong.iter().map(|(case, _)| *case).chain([good]).collect();
    let output = run("mixed", &format!(r#"{{"cases": [{}]}}"#, cases.join(",")));
    assert!(!output.status.success());
    let (answers, complaints): (Value, _) =
        (serde_json::from_slice(&output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    for ((_, rule), (answer, complaint)) in
        wrong.iter().zip(answers["cases"].as_array().unwrap().iter().zip(complaints.lines()))
    {
        assert!(answer["error"].as_str().unwrap().contains(rule), "{answer}");
        assert!(
            complaint.contains(answer["name"].as_str().unwrap()) && complaint.contains(rule),
            "{complaint}"
        );
    }
    let last = &answers["cases"][wrong.len()];
    assert_eq!(last["name"], "good");
    assert_eq!(last["w"], serde_json::json!([[0.0, -1.0, 0.0], [0.0, -1.0, 0.0]]));
    assert!((last["q"][1][0].as_f64().unwrap() - 1.5_f64.cos()).abs() < 1e-15);
}

#[test]
fn a_bad_file_is_an_error_and_a_good_one_is_not() {
    for (name, text) in [("cut", r#"{"cases": ["#), ("none", r#"{"case": []}"#), ("number", "3")] {
        let output = run(name, text);
        assert!(!output.status.success() && output.stdout.is_empty());
        assert!(String::from_utf8(output.stderr).unwrap().contains(".json: "));
    }
    assert!(!Command::new(program()).arg("nowhere.json").output().unwrap().status.success());
    assert!(!Command::new(program()).output().unwrap().status.success());
    let good = r#"{"cases": [{"name": "one", "inertia": [1, 2, 2.5], "w0": [0.1, 0.2, 0.3], "t": [1e9]}]}"#;
    assert!(run("good", good).status.success());
}

/// Runs it on this case and on a good one, which must be answered whatever the other is.
fn refused(case: &str) -> String {
    let good = r#"{"name": "good", "inertia": [1, 2, 2.5], "w0": [0, 1, 0], "t": [0]}"#;
    let output = run("refused", &format!(r#"{{"cases": [{case}, {good}]}}"#));
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{complaint}");
    let answers: Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{complaint}"));
    assert_eq!(answers["cases"][1]["w"], serde_json::json!([[0.0, 1.0, 0.0]]));
    assert_eq!(complaint, format!("odd: {}\n", answers["cases"][0]["error"].as_str().unwrap()));
    complaint
}

#[test]
fn a_number_that_no_computer_holds_spoils_its_own_case_alone() {
    for word in ["1e999", "-1e999", "1e-400", "0.001E-400"] {
        for (field, case) in [
            (
                "inertia",
                format!(r#"{{"name": "odd", "inertia": [1, {word}, 1], "w0": [0, 0, 1], "t": [1]}}"#),
            ),
            ("w0", format!(r#"{{"name": "odd", "inertia": [1, 1, 1], "w0": [0, 0, {word}], "t": [1]}}"#)),
            ("t", format!(r#"{{"name": "odd", "inertia": [1, 1, 1], "w0": [0, 0, 1], "t": [1, "{word}"]}}"#)),
        ] {
            let line = refused(&case);
            assert!(line.contains(&format!("`{field}` holds")) && line.contains(word), "{line}");
        }
    }
    // What is zero is zero however it is written.
    let good =
        r#"{"cases": [{"name": "zero", "inertia": [1, 2, 2.5], "w0": [0.0e-400, "-0e9", 1], "t": [0]}]}"#;
    assert!(run("zero", good).status.success());
    // JSON has no such words.
    let bare = r#"{"cases": [{"name": "odd", "inertia": [1, 1, NaN], "w0": [0, 0, 1], "t": [1]}]}"#;
    assert_eq!(run("bare", bare).status.code(), Some(2));
}

#[test]
fn a_field_given_twice_is_named_with_its_case() {
    for twice in ["inertia", "w0", "t"] {
        let fields = r#""name": "odd", "inertia": [1, 1, 1], "w0": [0, 0, 1], "t": [1]"#;
        let line = refused(&format!(r#"{{{fields}, "{twice}": [1, 1, 1]}}"#));
        assert!(line.starts_with(&format!("odd: duplicate field `{twice}`")), "{line}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_and_a_closed_pipe_is_none() {
    use std::process::Stdio;
    let case = r#"{"cases": [{"name": "one", "inertia": [1, 2, 2.5], "w0": [0, 1, 0], "t": [0]}]}"#;
    let (_folder, path) = written("written", case);
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = Command::new(program()).arg(&path).stdout(full).output().unwrap();
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{complaint}");
    assert!(complaint.starts_with("the answers cannot be written: "), "{complaint}");
    // A pipe whose other end is gone: that of a program which has ended.
    let mut reader = Command::new("true").stdin(Stdio::piped()).spawn().unwrap();
    let pipe = reader.stdin.take().unwrap();
    reader.wait().unwrap();
    let output = Command::new(program()).arg(&path).stdout(pipe).output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty());
    // And where even the complaint cannot be written, a code is left.
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let status = Command::new(program()).arg("nowhere.json").stderr(full).status().unwrap();
    assert_eq!(status.code(), Some(2));
}
