//! `cargo exercise NAME`, the program behind it: a name that no exercise has is no success.

use std::process::{Command, Output};

fn exercise(names: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_exercise")).args(names).output().unwrap()
}

#[test]
fn a_misspelt_name_is_refused_with_the_nearest() {
    let output = exercise(&["two_arows_1"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(
        message.starts_with("There is no exercise `two_arows_1`. Did you mean `two_arrows_1`? "),
        "{message}"
    );
    assert!(output.stdout.is_empty());
    for (words, near) in [("nxt", "next"), ("reset two_arrow_1", "two_arrows_1")] {
        let output = exercise(&words.split(' ').collect::<Vec<_>>());
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(!output.status.success() && message.contains(&format!("mean `{near}`?")), "{message}");
    }
}

#[test]
fn without_a_name_it_says_how_it_is_called() {
    for names in [&[][..], &["--help"], &["reset"]] {
        let output = exercise(names);
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8(output.stderr).unwrap().starts_with("usage: cargo exercise NAME"));
    }
}
