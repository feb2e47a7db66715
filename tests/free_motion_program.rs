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
        (r#"{"name": "lost", "inertia": [1, 1, 1], "t": [1]}"#, "`w0` is missing"),
        (r#"{"name": "odd", "inertia": [1, 1, 1], "w0": [0, "NaN", 1], "t": [1]}"#, "not a finite number"),
        (r#"{"name": "word", "inertia": [1, 1, 1], "w0": [0, 0, 1], "t": ["soon"]}"#, "not a finite number"),
        (r#"{"name": "flat", "inertia": [1, 1], "w0": [0, 0, 1], "t": [1]}"#, "must have 3"),
        (r#"{"inertia": [1, 1, 1], "w0": [0, 0, 1], "t": [1]}"#, "`name` is missing"),
        (r#"17"#, "`name` is missing"),
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
    let good = r#"[{"name": "one", "inertia": [1, 2, 2.5], "w0": [0.1, 0.2, 0.3], "t": [1e9]}]"#;
    assert!(run("good", good).status.success());
}

/// Runs it on these cases and on a good one, which must be answered whatever the others are.
fn refused(name: &str, cases: &[&str]) -> Vec<String> {
    let good = r#"{"name": "good", "inertia": [1, 2, 2.5], "w0": [0, 1, 0], "t": [0]}"#;
    let output = run(name, &format!(r#"{{"cases": [{}, {good}]}}"#, cases.join(", ")));
    let complaints = String::from_utf8(output.stderr).unwrap();
    assert!(!output.status.success(), "{complaints}");
    let answers: Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{complaints}"));
    assert_eq!(answers["cases"][cases.len()]["w"], serde_json::json!([[0.0, 1.0, 0.0]]));
    let lines = complaints.lines().map(str::to_owned).collect();
    for (answer, line) in answers["cases"].as_array().unwrap().iter().zip::<&Vec<String>>(&lines) {
        assert_eq!(
            *line,
            format!("{}: {}", answer["name"].as_str().unwrap(), answer["error"].as_str().unwrap())
        );
    }
    lines
}

#[test]
fn a_number_that_no_computer_holds_spoils_its_own_case_alone() {
    for word in ["1e999", "-1e999", "NaN", "Infinity", "-Infinity", "1e-400", "0.001E-400"] {
        for (field, case) in [
            (
                "inertia",
                format!(r#"{{"name": "odd", "inertia": [1, {word}, 1], "w0": [0, 0, 1], "t": [1]}}"#),
            ),
            ("w0", format!(r#"{{"name": "odd", "inertia": [1, 1, 1], "w0": [0, 0, {word}], "t": [1]}}"#)),
            ("t", format!(r#"{{"name": "odd", "inertia": [1, 1, 1], "w0": [0, 0, 1], "t": [1, "{word}"]}}"#)),
        ] {
            let lines = refused("unheld", &[&case]);
            assert!(lines.len() == 1 && lines[0].starts_with("odd: "), "{lines:?}");
            assert!(lines[0].contains(&format!("`{field}` holds")) && lines[0].contains(word), "{lines:?}");
        }
    }
    // What is zero is zero however it is written, and words inside a string are letters.
    let good =
        r#"[{"name": "NaN \" Infinity", "inertia": [1, 2, 2.5], "w0": [0.0e-400, "-0e9", 1], "t": [0]}]"#;
    let output = run("zero", good);
    assert!(output.status.success());
    let answers: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(answers["cases"][0]["name"], "NaN \" Infinity");
}

#[test]
fn what_is_given_twice_is_named() {
    let case =
        |name: &str| format!(r#"{{"name": "{name}", "inertia": [1, 1, 1], "w0": [0, 0, 1], "t": [1]}}"#);
    let output = run("names", &format!("[{}, {}, {}]", case("one"), case("two"), case("one")));
    let complaints = String::from_utf8(output.stderr).unwrap();
    assert_eq!(complaints, "one: an earlier case has this name too\n");
    let answers: Value = serde_json::from_slice(&output.stdout).unwrap();
    let refused = [0, 1, 2].map(|k| answers["cases"][k]["error"].is_string());
    assert!(!output.status.success() && refused == [false, false, true]);
}

#[test]
fn a_field_given_twice_is_named_with_its_case() {
    for twice in ["name", "inertia", "w0", "t", "note"] {
        let fields = r#""name": "odd", "inertia": [1, 1, 1], "w0": [0, 0, 1], "t": [1], "note": [2]"#;
        let again = if twice == "name" { r#""again""# } else { "[1, 1, 1]" };
        let lines = refused("fields", &[&format!(r#"{{{fields}, "{twice}": {again}}}"#)]);
        assert_eq!(lines, [format!("odd: the field `{twice}` is there twice")]);
    }
    let output = run("cases", r#"{"cases": [], "cases": []}"#);
    assert!(String::from_utf8(output.stderr).unwrap().contains("`cases` is there twice"));
}

#[test]
fn a_byte_order_mark_is_no_matter() {
    let text = r#"[{"name": "one", "inertia": [1, 2, 2.5], "w0": [0, 1, 0], "t": [0]}]"#;
    assert_eq!(run("marked", &format!("\u{feff}{text}")), run("plain", text));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_and_a_closed_pipe_is_none() {
    use std::process::Stdio;
    let case = r#"[{"name": "one", "inertia": [1, 2, 2.5], "w0": [0, 1, 0], "t": [0]}]"#;
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
