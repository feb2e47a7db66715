//! The example program that answers cases from a file: right ones in full, wrong ones by name.

use serde_json::Value;
use std::path::PathBuf;
use std::process::{Command, Output};

/// Built beside this test by the same command.
fn program() -> PathBuf {
    let mut path = std::env::current_exe().unwrap();
    path.pop();
    path.pop();
    path.join("examples").join(format!("free_motion{}", std::env::consts::EXE_SUFFIX))
}

fn run(name: &str, text: &str) -> Output {
    let path = std::env::temp_dir().join(format!("tumbling-{}-{name}.json", std::process::id()));
    std::fs::write(&path, text).unwrap();
    let output = Command::new(program()).arg(&path).output().unwrap();
    std::fs::remove_file(path).unwrap();
    output
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
