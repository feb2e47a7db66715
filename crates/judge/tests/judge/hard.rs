//! Input that is not what it should be.

use crate::common::{exact, judged, refused as error, spins};
use nalgebra::Vector3;
use tumbling_judge::{Options, Outcome, judge};

const HEAD: &str = "# inertia: 1 2 2.5\nt,wx,wy,wz\n0,1,2,3\n";

#[test]
fn what_spreadsheets_and_locales_make_of_a_record_is_named() {
    let with = |line: &str| error(format!("{HEAD}{line}\n"));
    assert_eq!(
        with("0.1,1,\u{2212}2,3"),
        "line 4, column 3 (`wy`): `\u{2212}2` is not a number: its minus sign is not the hyphen `-` that programs read"
    );
    let decimal = error("# inertia: 1 2 2.5\nt;wx;wy;wz\n0;1;2;3\n0,1;1;2;3\n");
    assert_eq!(decimal, "line 4, column 1 (`t`): `0,1` is not a number: write a decimal point, not a comma");
    let wide: Vec<u8> = [0xff, 0xfe].into_iter().chain(HEAD.bytes().flat_map(|byte| [byte, 0])).collect();
    assert_eq!(error(wide), "line 1: the file is in UTF-16: save it in UTF-8");
    let old = HEAD.replace('\n', "\r");
    assert!(error(old).starts_with("line 1: there are carriage returns within the line"));
    assert_eq!(error("t,wx\0,wy,wz\n"), "line 1: the line is not text in UTF-8: save the file in UTF-8");
    let huge = with(&format!("0.1,1,{},3", "x".repeat(5000)));
    assert!(huge.starts_with("line 4, column 3 (`wy`): `xxx") && huge.len() < 200, "{huge}");
    let digits = with(&format!("0.1,1,{},3", "9".repeat(5000)));
    assert!(digits.starts_with("line 4, column 3 (`wy`): the value is 9") && digits.len() < 200, "{digits}");
}

#[test]
fn columns_that_say_a_thing_twice_are_refused() {
    assert_eq!(error("t,time,wx,wy,wz\n"), "line 1: `t` and `time` both are the time");
    assert!(error("t,wx,wy,wz,omega_x,omega_y,omega_z\n").contains("two sets of columns for one vector"));
    let twice = error("t,qw,qx,qy,qz,quat_w,quat_x,quat_y,quat_z,wx,wy,wz\n");
    assert!(twice.contains("two sets of columns for the attitude"));
}

#[test]
fn separators_at_the_ends_of_lines_and_any_line_end_do_no_harm() {
    let rows = exact(Vector3::new(1.0, 2.0, 1.5), 0.01, 50);
    let plain = spins("# inertia: 1 2 2.5", rows.into_iter().map(|(t, _, w)| (t, w)));
    let (expected, quoted) = (judged(&plain), plain.replace('\n', "\"\n\"").replace(',', "\",\""));
    for text in [
        plain.replace('\n', ",\n").replacen(",\n", "\n", 1),
        plain.replace("wz\n", "wz,\n"),
        plain.replace('\n', "\r\n"),
        format!("\u{feff}{plain}"),
        plain.trim_end().to_string(),
        plain.replace(',', " ; "),
        plain.replace('\n', "\n\n"),
        quoted.replacen("\"\n\"", "\n\"", 1).trim_end_matches('"').into(),
    ] {
        assert_eq!(judged(&text).laws, expected.laws, "{}", &text[..60]);
    }
}

#[test]
fn one_attitude_is_an_error_and_two_are_no_motion() {
    let attitudes = "# inertia: 1 2 2.5\nt,qw,qx,qy,qz\n0,1,0,0,0\n";
    assert!(error(attitudes).contains("one row"));
    // Attitudes alone need a third row for anything to be held against.
    let verdict = judge(format!("{attitudes}0.1,0.99,0.1,0.05,0.02\n").as_bytes(), &Options::default());
    assert!(verdict.is_ok_and(|verdict| verdict.outcome != Outcome::Passed));
}
