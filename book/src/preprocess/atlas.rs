//! The atlas: `{{#atlas}}`, alone in its line, becomes the committed record as tables, and a script that
//! searches them. Without the script the tables are simply shown.

use crate::site::places::escaped;
use tumbling_measure::atlas::{Fate, Precision, Row, recorded};

const DIRECTIVE: &str = "{{#atlas}}";

/// Each chart of the record, what it is called, and what its columns are.
const CHARTS: [(&str, &str, &str); 13] = [
    ("steady spin", "a stable spin", "turn in a step, rad"),
    ("flipping", "a body that flips", "turn in a step, rad"),
    ("needles", "needles", "largest over smallest moment"),
    ("pushes", "three flips after a push", "push, rad/s, on a spin of 10 rad/s"),
    ("damping", "damping", "damping times step over inertia"),
    ("named", "odd bodies and far scales", "case"),
    ("drag", "uneven drag", "loss a second, on the third axis half as much again"),
    ("one axis", "drag on one axis", "loss a second of the spin about it"),
    ("weight", "a weight", "its energy over the spin's"),
    ("shapes", "needles, strips and plates with a weight", "case"),
    ("stop", "brought to rest, and from rest", "case"),
    ("resonance", "a push to and fro", "frequency over that of the wobble"),
    ("blow", "a blow of the same impulse", "how long it lasts, s"),
];

/// What each fate means, in a sentence that follows a method's name.
const fn meaning(fate: Fate) -> &'static str {
    match fate {
        Fate::Right => {
            "is right: energy and momentum to a hundredth, and every flip, or the attitude at the end, to a tenth"
        }
        Fate::Late => {
            "runs early or late: the last flip by more than a tenth of the time between two, or the attitude at the end by more than a \
             tenth of a radian"
        }
        Fate::Worn => "gains or loses more than a hundredth of energy or momentum, and at most a tenth",
        Fate::WrongFlips => "miscounts the flips",
        Fate::Gained => "gains more than a tenth of energy or momentum",
        Fate::Lost => "loses more than a tenth of energy or momentum",
        Fate::Reversed => "lets damping turn the momentum round",
        Fate::Refused => "refuses the step, and says why",
        Fate::NotFinite => "ends in numbers that are infinite or none",
    }
}

/// The chapter's text with the atlas in it.
///
/// # Errors
/// A record that cannot be read.
pub(super) fn replace(text: &str) -> Result<String, String> {
    let Some(at) = text.find(DIRECTIVE) else { return Ok(text.to_owned()) };
    let (before, after) = (&text[..at], &text[at + DIRECTIVE.len()..]);
    Ok(format!("{before}{}{after}", page(&recorded()?)))
}

/// Different values in the order in which they first come.
fn distinct<'a>(values: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = Vec::new();
    for value in values {
        if !seen.contains(&value) {
            seen.push(value);
        }
    }
    seen
}

fn page(rows: &[Row]) -> String {
    let tables: Vec<String> = CHARTS.iter().map(|chart| table(rows, *chart)).collect();
    let keys = Fate::ALL
        .iter()
        .map(|fate| format!("<li><b>{}</b>: the method {}.</li>", fate.word(), meaning(*fate)));
    // A blank line would end the HTML.
    let script: Vec<&str> =
        include_str!("../../theme/atlas.js").lines().filter(|line| !line.trim().is_empty()).collect();
    format!(
        "<div class=\"atlas\">\n<p class=\"atlas-choice\" hidden></p>\n<p class=\"atlas-fate\" role=\"status\"></p>\n{}\n\
         <ul class=\"atlas-key\">\n{}\n</ul>\n</div>\n<script>\n{}\n</script>\n",
        tables.join("\n"),
        keys.collect::<Vec<_>>().join("\n"),
        script.join("\n")
    )
}

fn table(rows: &[Row], (name, title, columns): (&str, &str, &str)) -> String {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.chart == name).collect();
    let (cases, runners) =
        (distinct(rows.iter().map(|row| row.case)), distinct(rows.iter().map(|row| row.runner)));
    let fate = |case: &str, runner: &str, precision: Precision| {
        let of = |row: &&&Row| row.case == case && row.runner == runner && row.precision == precision;
        rows.iter().find(of).map(|row| row.fate)
    };
    let cell = |case: &str, runner: &str| {
        let [double, single] = [Precision::Double, Precision::Single].map(|p| fate(case, runner, p));
        let Some(double) = double else { return "<td></td>".to_owned() };
        let off = if matches!(double, Fate::Right | Fate::Refused) { "" } else { " class=\"off\"" };
        let other = single.filter(|single| *single != double);
        let small = other.map_or(String::new(), |other| format!("<small>single: {}</small>", other.word()));
        format!("<td{off}>{}{small}</td>", double.word())
    };
    let head: Vec<String> =
        cases.iter().map(|case| format!("<th>{}</th>", escaped(&readable(case)))).collect();
    let body = runners.iter().map(|runner| {
        let cells: String = cases.iter().map(|case| cell(case, runner)).collect();
        format!("<tr><th scope=\"row\">{}</th>{cells}</tr>", escaped(runner))
    });
    format!(
        "<div class=\"table-wrapper\" data-chart=\"{title}\" data-columns=\"{columns}\">\n<table>\n<caption>{title}: {columns}</caption>\n\
         <thead><tr><th>method</th>{}</tr></thead>\n<tbody>\n{}\n</tbody>\n</table>\n</div>",
        head.concat(),
        body.collect::<Vec<_>>().join("\n")
    )
}

/// `1e-20 kg m²` as `10⁻²⁰ kg m²`, for people.
fn readable(case: &str) -> String {
    let (number, unit) =
        case.split_once(' ').map_or((case, String::new()), |(n, unit)| (n, format!(" {unit}")));
    let power = |exponent: &str| {
        exponent.chars().filter_map(|c| if c == '-' { Some('⁻') } else { superscript(c) }).collect::<String>()
    };
    let large = || number.parse::<u64>().ok().filter(|n| *n >= 10_000).map(|n| n.ilog10().to_string());
    match number.strip_prefix("1e").map(str::to_owned).or_else(large).as_deref() {
        Some("0") => format!("1{unit}"),
        Some("1") => format!("10{unit}"),
        Some(exponent) if exponent.parse::<i32>().is_ok() => format!("10{}{unit}", power(exponent)),
        _ => case.to_owned(),
    }
}

fn superscript(digit: char) -> Option<char> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit.to_digit(10)? as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_of_the_record_stands_in_a_table() {
        let rows = recorded().unwrap();
        assert_eq!(distinct(rows.iter().map(|row| row.chart)), CHARTS.map(|chart| chart.0));
        let double: Vec<&Row> = rows.iter().filter(|row| row.precision == Precision::Double).collect();
        let html = page(&rows);
        assert_eq!(html.matches("<td").count(), double.len());
        for fate in Fate::ALL {
            // Once more in the key.
            let count = double.iter().filter(|row| row.fate == fate).count();
            assert_eq!(html.matches(&format!(">{}<", fate.word())).count(), count + 1, "{}", fate.word());
        }
        assert!(!html.contains("\n\n<t"), "a blank line would end the HTML");
    }

    #[test]
    fn powers_of_ten_are_written_for_people() {
        let pairs = [
            ("1e-20 kg m²", "10⁻²⁰ kg m²"),
            ("1e0", "1"),
            ("10000", "10⁴"),
            ("0.01", "0.01"),
            ("sphere", "sphere"),
        ];
        for (case, expected) in pairs {
            assert_eq!(readable(case), expected);
        }
    }
}
