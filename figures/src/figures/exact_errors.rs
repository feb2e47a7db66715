//! Errors of the exact motion over many bodies, against a table of more digits than an `f64` has.

use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, Pen};
use nalgebra::Vector3;
use serde_json::Value;
use tumbling::exact::FreeMotion;
use tumbling_measure::record::FREE_MOTIONS;

/// The rounding of one input, relative.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Decimals of the numbers whose differences are taken.
const DECIMALS: i32 = 30;

/// A number with a few digits before its point, in units of the last decimal; further decimals are cut off.
fn fixed(text: &str) -> Option<i128> {
    let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: i128 = format!("{whole}{part}").parse().ok()?;
    let shift = DECIMALS + power.parse::<i32>().ok()? - i32::try_from(part.len()).ok()?;
    let Some(factor) = 10_i128.checked_pow(shift.unsigned_abs()) else { return Some(0) };
    if shift < 0 { Some(digits / factor) } else { digits.checked_mul(factor) }
}

/// The difference of a number from one of a table, which has more digits than an `f64`.
fn difference(x: f64, table: &str) -> Option<f64> {
    Some((fixed(&format!("{x:.30e}"))? - fixed(table)?) as f64 * 10_f64.powi(-DECIMALS))
}

fn length(v: &[f64]) -> f64 {
    let scale = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if scale == 0.0 { 0.0 } else { scale * v.iter().map(|x| (x / scale).powi(2)).sum::<f64>().sqrt() }
}

fn texts(value: &Value) -> Option<Vec<&str>> {
    value.as_array()?.iter().map(Value::as_str).collect()
}

fn numbers(value: &Value) -> Option<Vec<f64>> {
    texts(value)?.into_iter().map(|text| text.parse().ok()).collect()
}

fn off(ours: &[f64], table: &[&str]) -> Option<f64> {
    let differences: Option<Vec<f64>> =
        ours.iter().zip(table).map(|(x, text)| difference(*x, text)).collect();
    Some(length(&differences?))
}

/// The worst error of spin and of attitude of one body spun one way, in units.
fn case(case: &Value) -> Option<[f64; 2]> {
    let vector = |field: &str| numbers(&case[field]).map(Vector3::from_vec);
    let motion = FreeMotion::new(vector("inertia")?.try_into().ok()?, &vector("w0")?).ok()?;
    let mut units = [0.0_f64; 2];
    for (k, t) in numbers(&case["t"])?.into_iter().enumerate() {
        let at = motion.at(t).ok()?;
        let q = at.attitude.quaternion();
        let q = [q.w, q.i, q.j, q.k];
        let (w_table, q_table) = (texts(&case["w"][k])?, texts(&case["q"][k])?);
        let spin = off(at.omega.as_slice(), &w_table)? / length(&numbers(&case["w"][k])?);
        let attitude = off(&q, &q_table)?.min(off(&q.map(|x| -x), &q_table)?);
        for (i, (error, column)) in [(spin, "kappa_w"), (attitude, "kappa_q")].into_iter().enumerate() {
            let condition = numbers(&case[column])?[k].max(1.0);
            units[i] = units[i].max(error / (condition * ROUNDING));
        }
    }
    Some(units)
}

/// An error above this number of units is not acceptable.
const LIMIT: f64 = 8.0;

/// Where each bar ends, in units, and how that is written.
const BARS: [(f64, &str); 5] = [(0.25, "¼"), (0.5, "½"), (1.0, "1"), (2.0, "2"), (LIMIT, "8")];

pub(super) fn draw() -> Drawing {
    let file: Value = serde_json::from_str(FREE_MOTIONS)?;
    let mut units = Vec::new();
    for entry in file["cases"].as_array().ok_or("a table without cases")? {
        let both = case(entry).ok_or_else(|| format!("case {} cannot be read", entry["inertia"]))?;
        if let Some(bad) = both.iter().find(|&&units| units.is_nan() || units > LIMIT) {
            return Err(format!("{} has an error of {bad:.1} units", entry["inertia"]).into());
        }
        units.extend(both);
    }
    let share = |from: f64, to: f64| {
        let inside = units.iter().filter(|&&x| x <= to && (x > from || from == 0.0)).count();
        100.0 * inside as f64 / units.len() as f64
    };
    let canvas = Canvas::sized(500, 370);
    let foot = 290.0;
    let mut from = 0.0;
    let mut said = Vec::new();
    for (i, (to, words)) in BARS.into_iter().enumerate() {
        let (left, right) = (24.0 + 90.0 * i as f64, 114.0 + 90.0 * i as f64);
        let per_cent = share(from, to);
        let top = foot - 3.1 * per_cent;
        canvas.tiles(&[[left + 6.0, top, right - 6.0, foot]], Fill::new(Ink::Text).opacity(0.7), None);
        let written = Label::new(format!("{per_cent:.0} %")).bold().middle();
        canvas.label((0.5 * (left + right), top - 9.0), &written);
        canvas.label((right, foot + 24.0), &Label::new(words).middle());
        said.push(format!("{per_cent:.0} % up to {words}"));
        from = to;
    }
    canvas.label((24.0, foot + 24.0), &Label::new("0").middle());
    canvas.line((24.0, foot), (474.0, foot), Pen::new(Ink::Text, 1.2));
    canvas.line((294.0, 96.0), (294.0, foot), Pen::new(Ink::Text, 1.6).dashed());
    canvas.label((304.0, 112.0), &Label::new("what rounding"));
    canvas.label((304.0, 134.0), &Label::new("one input causes"));
    let title = Label::new("error, in units of what rounding one input causes").middle();
    canvas.label((249.0, foot + 54.0), &title);
    canvas.label((24.0, 28.0), &Label::new("share of the answers").bold());
    canvas.described(format!(
        "A bar for each size of the error of the exact motion, over {} bodies and ways of spinning, for spin and attitude, in \
         units of what the rounding of one input does by itself: {}; none is beyond {LIMIT:.0}.",
        units.len() / 2,
        said.join(", ")
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An `f64` has 3602879701896397 / 2^55 for 0.1, which is more by a fifth of 2^-55.
    #[test]
    fn a_difference_far_below_the_last_digit_of_a_number_is_seen() {
        let near = |x: f64, table: &str, expected: f64| {
            let found = difference(x, table).unwrap();
            assert!((found - expected).abs() < 1e-29, "{x} - {table}: {found:e}, not {expected:e}");
        };
        near(0.1, "0.1", 2_f64.powi(-55) / 5.0);
        near(-0.1, "-1.00e-1", -2_f64.powi(-55) / 5.0);
        near(1.0, "0.99999999999999999999", 1e-20);
        near(0.0, "2.5e-20", -2.5e-20);
        near(0.0, "2.5e-300", 0.0);
        near(100.0, "1e2", 0.0);
    }
}
