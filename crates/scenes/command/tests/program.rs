//! The program that answers scenes: what it prints, what it refuses, how it ends.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tumbling::exact::FreeMotion;

fn answered(words: &[&str], file: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_scene")).args(words).arg(file).output().unwrap()
}

fn story(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../files").join(name)
}

fn of_text(name: &str, text: &str) -> Output {
    let (_folder, file) = written(name, text);
    answered(&[], &file)
}

/// A file of this name, and the folder that holds it.
fn written(name: &str, text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::TempDir::new().unwrap();
    let file = folder.path().join(format!("{name}.toml"));
    std::fs::write(&file, text).unwrap();
    (folder, file)
}

fn said(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn the_states_are_printed_with_all_their_digits_under_names_and_units() {
    let output = answered(&[], &story("box.toml"));
    assert_eq!(output.status.code(), Some(0));
    let text = said(&output.stdout);
    let mut lines = text.lines();
    assert_eq!(
        lines.next().unwrap(),
        "body,t [s],wx [rad/s],wy [rad/s],wz [rad/s],qw,qx,qy,qz,kinetic energy [J],angle to momentum [rad]"
    );
    let moments = Vector3::new(0.833_333_333_333_333_4, 1.083_333_333_333_333_3, 0.416_666_666_666_666_7);
    let exact = FreeMotion::new(moments.try_into().unwrap(), &Vector3::new(1.0, 0.01, 0.01)).unwrap();
    let mut count = 0;
    for line in lines {
        let x: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
        let at = exact.at(x[1]).unwrap();
        assert_eq!(Vector3::new(x[2], x[3], x[4]), at.omega);
        let q = UnitQuaternion::new_unchecked(Quaternion::new(x[5], x[6], x[7], x[8]));
        assert!(q.angle_to(&at.attitude) < 1e-14);
        count += 1;
    }
    assert_eq!(count, 601);
}

#[test]
fn every_story_is_answered_in_numbers_in_short_and_in_words() {
    for entry in std::fs::read_dir(story("")).unwrap() {
        let path = entry.unwrap().path();
        for (words, begins) in
            [(&[][..], "body,t [s]"), (&["--summary"], "body 0\nat "), (&["--explain"], "bod")]
        {
            let output = answered(words, &path);
            assert_eq!(output.status.code(), Some(0), "{path:?}");
            assert!(said(&output.stdout).starts_with(begins), "{path:?}");
            // Flips are requested: a line says where they are.
            let elsewhere =
                words.is_empty() && (path.ends_with("racket.toml") || path.ends_with("phone.toml"));
            assert_eq!(said(&output.stderr).contains("see --summary"), elsewhere, "{path:?}");
            assert_eq!(output.stderr.is_empty(), !elsewhere, "{path:?}");
        }
    }
}

#[test]
fn the_summary_counts_the_flips() {
    let text = said(&answered(&["--summary"], &story("racket.toml")).stdout);
    // One each 1.63 s, half of the period in the table of truth, 3.263 s.
    assert!(text.contains("  flips     6\n"), "{text}");
    assert_eq!(text.matches("            at ").count(), 6, "{text}");
}

#[test]
fn a_body_that_is_none_is_named_with_its_line_and_the_others_are_answered() {
    let text = "accuracy = 1e-9\ntimes = [1.0]\nwants = [\"spin\"]\n\n[[body]]\nmoments = [1.0, 1.0, 3.0]\nspin = [0.0, 0.0, 1.0]\n\n\
                [[body]]\nmoments = [1.0, 1.0, 2.0]\nspin = [0.0, 0.0, 1.0]\n";
    let output = of_text("invalid", text);
    assert_eq!(output.status.code(), Some(1));
    let message = said(&output.stderr);
    assert!(message.contains("line 6, `moments`: body 0: no body has principal moments"), "{message}");
    assert!(said(&output.stdout).contains("\n1,1.0000000000000000e0,0.0000000000000000e0"));
}

#[test]
fn a_file_that_cannot_be_read_ends_with_two() {
    let output = of_text("unknown", "acuracy = 1\n");
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output.stderr).contains("line 1, `acuracy`: no such field. Did you mean `accuracy`?"));
    let output = answered(&[], Path::new("there/is/none.toml"));
    assert_eq!(output.status.code(), Some(2));
    for words in [&[][..], &["--sumary", "x"], &["a", "b"], &["--summary", "--explain", "x"]] {
        let output = Command::new(env!("CARGO_BIN_EXE_scene")).args(words).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{words:?}");
        assert!(said(&output.stderr).contains("Usage: scene"), "{words:?}");
    }
    assert_eq!(
        Command::new(env!("CARGO_BIN_EXE_scene")).arg("--help").output().unwrap().status.code(),
        Some(0)
    );
}

/// Bodies that are answered alike are explained once.
#[test]
fn many_bodies_are_explained_kind_by_kind() {
    let ball = "[[body]]\nmoments = [1.0, 1.0, 1.0]\nspin = [0.0, 0.0, 1.0]\n";
    let odd = "[[body]]\nmoments = [1.0, 2.0, 2.5]\nspin = [1.0, 2.0, 1.0]\n";
    let head = "accuracy = 1e-9\ntimes = [1.0]\nwants = [\"spin\"]\n";
    let (_folder, path) = written("kinds", &[head, &ball.repeat(20), odd, ball].concat());
    let text = said(&answered(&["--explain"], &path).stdout);
    assert!(
        text.starts_with("bodies 0, 1, 2, 3, 4, 5, 6, 7, ... (21 of them)\nchosen: the spin as it is"),
        "{text}"
    );
    assert_eq!(text.matches("chosen: ").count(), 2, "{text}");
    assert!(text.contains("\nbody 20\nchosen: the spin by Jacobi"), "{text}");
}

/// What is printed here the judge of engines reads, and finds in order.
#[test]
fn what_is_printed_has_the_names_that_the_judge_knows() {
    let text = said(&answered(&[], &story("box.toml")).stdout);
    let inertia = Vector3::new(0.833_333_333_333_333_4, 1.083_333_333_333_333_3, 0.416_666_666_666_666_7);
    let options = tumbling_judge::Options { inertia: Some(inertia), ..Default::default() };
    let verdict = tumbling_judge::judge(text.as_bytes(), &options).unwrap();
    assert_eq!(verdict.outcome, tumbling_judge::Outcome::Passed, "{verdict}");
    assert_eq!(verdict.record.ignored, ["body", "kinetic energy [J]", "angle to momentum [rad]"]);
}

#[test]
fn flips_alone_are_given_in_the_summary() {
    let text = "accuracy = 1e-9\nspan = 10.0\nevery = 1.0\nwants = [\"flips\"]\n[[body]]\nmoments = [1.0, 2.0, 2.5]\nspin = [0.1, 5.0, 0.1]\n";
    let output = of_text("flips", text);
    assert!(said(&output.stdout).starts_with("body 0\n"), "{}", said(&output.stdout));
    assert!(said(&output.stdout).contains("  flips     "));
}

/// A reader who has had enough ends the program quietly; a disk that is full does not.
#[cfg(target_os = "linux")]
#[test]
fn a_closed_pipe_ends_well_and_a_full_disk_does_not() {
    use std::io::Read as _;
    use std::process::Stdio;
    let text = "accuracy = 1e-6\nspan = 1e4\nevery = 0.01\nwants = [\"spin\"]\n[[body]]\nmoments = [1.0, 2.0, 2.5]\nspin = [0.1, 5.0, 0.1]\n";
    let (_folder, path) = written("long", text);
    let mut child =
        Command::new(env!("CARGO_BIN_EXE_scene")).arg(&path).stdout(Stdio::piped()).spawn().unwrap();
    let mut pipe = child.stdout.take().unwrap();
    pipe.read_exact(&mut [0; 100]).unwrap();
    drop(pipe);
    assert_eq!(child.wait().unwrap().code(), Some(0));
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let ended = Command::new(env!("CARGO_BIN_EXE_scene")).arg(&path).stdout(full).output().unwrap();
    assert_eq!(ended.status.code(), Some(2));
    assert!(said(&ended.stderr).contains("the answers cannot be written"), "{}", said(&ended.stderr));
}
