//! The program from outside: exit codes, what it prints, what it takes.

use nalgebra::Vector3;
use std::io::Write as _;
use std::process::{Command, Output, Stdio};

fn judge(arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_tumbling-judge"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // It may stop reading at the first mistake.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    child.wait_with_output().unwrap()
}

/// The spin of a symmetric top, which circles its axis evenly; times `growth` to the power of the row.
fn top(growth: f64) -> String {
    let (transverse, along, h) = (1.0_f64, 2.0_f64, 0.01_f64);
    let rate = (along - transverse) / transverse * 3.0;
    let row = |i: i32| {
        let t = h * f64::from(i);
        let w = Vector3::new(0.5 * (rate * t).cos(), 0.5 * (rate * t).sin(), 3.0) * growth.powi(i);
        format!("{t:e},{:e},{:e},{:e}\n", w.x, w.y, w.z)
    };
    format!("# inertia: 1 1 2\nt,wx,wy,wz\n{}", (0..400).map(row).collect::<String>())
}

fn words(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap() + &String::from_utf8(output.stderr.clone()).unwrap()
}

#[test]
fn a_right_record_exits_with_0_a_wrong_one_with_1_and_no_record_with_2() {
    let right = judge(&["-"], &top(1.0));
    assert_eq!(right.status.code(), Some(0), "{}", words(&right));
    assert!(words(&right).contains("PASSED"));
    let wrong = judge(&["-"], &top(0.9999));
    assert_eq!(wrong.status.code(), Some(1), "{}", words(&wrong));
    assert!(words(&wrong).contains("FAILED") && words(&wrong).contains("damping"));
    for (arguments, input, problem) in [
        (&["-"][..], "", "the file is empty"),
        (&["-"], "t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n", "--inertia"),
        (&["no-such-file.csv"], "", "no-such-file.csv"),
        (&["-", "--inertia", "1,1,9"], "t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n", "9"),
        (&["-", "--jsno"], "", "similar argument exists: '--json'"),
        (&["-", "--inertai", "1,2,3"], "", "'--inertia'"),
        (&[], "", "<FILE>"),
    ] {
        let output = judge(arguments, input);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", words(&output));
        assert_eq!(output.stdout, b"", "{arguments:?}: half a verdict");
        assert!(words(&output).contains(problem), "{arguments:?}: {}", words(&output));
    }
    // A torque, or a spin that is constant as it should be, is no pass.
    let still = "# inertia: 1 2 3\nt,wx,wy,wz\n0,0,0,3\n0.1,0,0,3\n0.2,0,0,3\n";
    let output = judge(&["-"], still);
    assert_eq!(output.status.code(), Some(1));
    assert!(words(&output).contains("NOTHING TO JUDGE"));
}

#[test]
fn the_limits_decide_each_its_own_law() {
    let record = top(0.999_999); // the energy falls by 8e-4, the momentum by half of that
    for (limits, code) in [
        ("0.01", 0),
        ("1e-4", 1),
        ("energy=1e-4", 1),
        ("momentum=1e-4", 1),
        ("energy=1e-3,momentum=5e-4", 0),
        ("1e-9,energy=1e-3,momentum=5e-4,separatrix=1", 0),
        ("energy=1e-3,momentum=3e-4", 1),
    ] {
        let output = judge(&["-", "--threshold", limits], &record);
        assert_eq!(output.status.code(), Some(code), "{limits}: {}", words(&output));
    }
}

#[test]
fn the_json_has_its_shape_whatever_the_outcome() {
    for (record, outcome, options) in
        [(top(1.0), "passed", &["-", "--json"][..]), (top(0.999), "failed", &["--json", "-"])]
    {
        let output = judge(options, &record);
        let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(value["outcome"], outcome);
        assert_eq!(value["rows"], 400);
        for key in ["moments", "file_mistakes", "resets", "laws", "complaints"] {
            assert!(value[key].is_array(), "{key}");
        }
        for law in value["laws"].as_array().unwrap() {
            assert!(law["law"].is_string() && law["grade"].is_string() && law["most"].is_number());
        }
        assert!(value["diagnosis"]["best"]["rule"].is_string());
        assert_eq!(value["curve"]["time"].as_array().unwrap().len(), 200);
    }
}
