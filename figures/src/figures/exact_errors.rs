//! Errors of the exact motion against tables of more digits than an `f64` has.

use super::{Drawing, Picture, bound, power_of_ten};
use crate::draw::{Canvas, Label, P, Pen, Plot, Scale};
use crate::ink::Ink;
use nalgebra::Vector3;
use serde_json::Value;
use std::error::Error;
use std::f64::consts::TAU;
use tumbling::exact::FreeMotion;

const TABLES: [&str; 2] =
    [include_str!("../../../tests/data/free-motion.json"), include_str!("../../../tests/data/sweep.json")];

/// The rounding of one input, relative.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// A decimal number as 36 digits and the power of ten of the last one.
struct Decimal {
    digits: i128,
    exponent: i32,
}

const DIGITS: usize = 36;

impl Decimal {
    /// From a numeral with or without a point and a power of ten; digits after the 36th are cut.
    fn parse(text: &str) -> Option<Self> {
        let (mantissa, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let negative = mantissa.starts_with('-');
        let (whole, part) = mantissa
            .trim_start_matches(['-', '+'])
            .split_once('.')
            .unwrap_or((mantissa.trim_start_matches(['-', '+']), ""));
        let all: String = [whole, part].concat();
        let leading = all.len() - all.trim_start_matches('0').len();
        let kept: String = all[leading..].chars().chain(std::iter::repeat('0')).take(DIGITS).collect();
        let first = i32::try_from(whole.len()).ok()? - i32::try_from(leading).ok()?;
        let digits: i128 = kept.parse().ok()?;
        Some(Self {
            digits: if negative { -digits } else { digits },
            exponent: power.parse::<i32>().ok()? + first - i32::try_from(DIGITS).ok()?,
        })
    }

    /// All that matters of an `f64`.
    fn of(x: f64) -> Option<Self> {
        Self::parse(&format!("{x:.*e}", DIGITS - 1))
    }

    /// The difference, from which nothing is lost but what lies below the 36th digit of the larger number.
    fn minus(&self, other: &Self) -> Option<f64> {
        let top = match (self.digits, other.digits) {
            (0, _) => other.exponent,
            (_, 0) => self.exponent,
            _ => self.exponent.max(other.exponent),
        };
        let lined_up = |x: &Self| {
            10_i128
                .checked_pow(u32::try_from(top - x.exponent).unwrap_or(0))
                .map_or(0, |power| x.digits / power)
        };
        format!("{}e{top}", lined_up(self) - lined_up(other)).parse().ok()
    }
}

fn length(v: &[f64]) -> f64 {
    let scale = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if scale == 0.0 { 0.0 } else { scale * v.iter().map(|x| (x / scale).powi(2)).sum::<f64>().sqrt() }
}

/// One instant of one motion: how far off, and how far the rounding of the inputs may take it.
struct Seen {
    name: String,
    /// How far it is from the start, at the speed of that instant.
    turns: f64,
    condition: f64,
    error: f64,
}

fn texts(value: &Value) -> Option<Vec<&str>> {
    value.as_array()?.iter().map(Value::as_str).collect()
}

fn numbers(value: &Value) -> Option<Vec<f64>> {
    texts(value)?.into_iter().map(|text| text.parse().ok()).collect()
}

fn off(ours: &[f64], table: &[&str]) -> Option<f64> {
    let differences: Option<Vec<f64>> =
        ours.iter().zip(table).map(|(x, text)| Decimal::of(*x)?.minus(&Decimal::parse(text)?)).collect();
    Some(length(&differences?))
}

/// Spin and attitude at each instant of a case.
fn case(case: &Value) -> Option<[Vec<Seen>; 2]> {
    let vector = |field: &str| numbers(&case[field]).map(Vector3::from_vec);
    let motion = FreeMotion::new(&vector("inertia")?, &vector("w0")?).ok()?;
    let mut seen = [Vec::new(), Vec::new()];
    for (k, t) in numbers(&case["t"])?.into_iter().enumerate() {
        let at = motion.at(t).ok()?;
        let q = at.attitude.quaternion();
        let q = [q.w, q.i, q.j, q.k];
        let (w_table, q_table) = (texts(&case["w"][k])?, texts(&case["q"][k])?);
        let size = length(&numbers(&case["w"][k])?);
        let spin = off(at.omega.as_slice(), &w_table)? / if size > 0.0 { size } else { 1.0 };
        let attitude = off(&q, &q_table)?.min(off(&q.map(|x| -x), &q_table)?);
        for (i, (error, column)) in [(spin, "kappas_w"), (attitude, "kappas_q")].into_iter().enumerate() {
            let condition = numbers(&case[column])?[k].max(1.0);
            let name = case["name"].as_str()?.to_owned();
            seen[i].push(Seen { name, turns: size * t.abs() / TAU, condition, error });
        }
    }
    Some(seen)
}

/// Both tables: how many motions, and each instant's spin, then attitude.
struct Measured {
    motions: usize,
    seen: [Vec<Seen>; 2],
}

fn measured() -> Result<Measured, Box<dyn Error>> {
    let mut motions = 0;
    let mut seen = [Vec::new(), Vec::new()];
    for table in TABLES {
        let file: Value = serde_json::from_str(table)?;
        for entry in file["cases"].as_array().ok_or("a table without cases")? {
            let [spin, attitude] =
                case(entry).ok_or_else(|| format!("case {} cannot be read", entry["name"]))?;
            seen[0].extend(spin);
            seen[1].extend(attitude);
            motions += 1;
        }
    }
    Ok(Measured { motions, seen })
}

/// As many units as no error may have.
const LIMIT: f64 = 8.0;
/// Where smaller errors are drawn too, and where none at all is.
const SMALL: f64 = 3e-18;
const NONE: f64 = 1e-19;

pub(super) fn draw() -> Drawing {
    let Measured { motions, seen: [spin, attitude] } = measured()?;
    let units = |s: &Seen| s.error / (s.condition * ROUNDING);
    if let Some(bad) = spin.iter().chain(&attitude).find(|s| units(s) > LIMIT) {
        return Err(format!("{} has an error of {:.1} units", bad.name, units(bad)).into());
    }
    let canvas = Canvas::new(490);
    let plot = panel(&canvas, 62.0, &spin, Ink::Omega, "spin: relative error")?;
    let p = plot.at(2e11, 1e-3);
    canvas.label((p.0 - 14.0, p.1), &Label::new(format!("{LIMIT:.0} units")).size(15.5).end());
    let p = plot.at(1e13, 1e-3);
    for (down, line) in [(4.0, "1 unit:"), (26.0, "$κ$·$2^{−53}$")] {
        canvas.label((p.0 + 12.0, p.1 + down), &Label::new(line).size(15.5));
    }
    let near_sphere = worst(&spin, "sphere-near-separatrix-96")?;
    pointed(&canvas, &plot, near_sphere, (58.0, 44.0), &["a near sphere near", "the separatrix,"]);
    let plot = panel(&canvas, 384.0, &attitude, Ink::Text, "attitude: error of $q$")?;
    pointed(&canvas, &plot, worst(&attitude, "needle-flip-100")?, (42.0, 20.0), &["a needle,"]);
    pointed(&canvas, &plot, worst(&attitude, "sphere-tiny-80")?, (8.0, 60.0), &["a near sphere,"]);
    let greatest = |seen: &[Seen]| bound(seen.iter().map(|s| s.error).fold(0.0, f64::max));
    Ok(Picture {
        canvas,
        description: format!(
            "Errors of the exact motion against tables of 20 and 40 digits: {} instants of {motions} motions, among them \
             needles, near spheres, pushes down to 5e-324, neighbours of the separatrix. Across, the condition number κ, 1 \
             to 1e26: by how much the motion magnifies a relative change of its inputs. Up, the error of the spin, left, and \
             of the attitude, right. No dot lies above the line of {LIMIT:.0} units; a unit, κ 2^-53, is what the rounding of one \
             input may do by itself. Where κ is large most lie far below: every error of the spin is below {:.0e}, every error of the \
             attitude below {:.0e}.",
            spin.len(),
            greatest(&spin),
            greatest(&attitude)
        ),
    })
}

/// The instant of this motion with the greatest error.
fn worst<'a>(seen: &'a [Seen], name: &str) -> Result<&'a Seen, Box<dyn Error>> {
    let of_it = seen.iter().filter(|s| s.name == name);
    Ok(of_it.max_by(|a, b| a.error.total_cmp(&b.error)).ok_or("a motion that is in no table")?)
}

/// Says what a dot is and how many turns after the start, its words' end so far right of the
/// dot and above it. The line ends above the next power
/// of ten: within it the error is the machine's own.
fn pointed(canvas: &Canvas, plot: &Plot, seen: &Seen, (right, above): P, words: &[&str]) {
    let tip = plot.at(seen.condition, bound(seen.error));
    #[allow(clippy::cast_possible_truncation)]
    let turns = format!("{} turns", power_of_ten(seen.turns.log10().round() as i32));
    canvas.line((tip.0, tip.1 - above), (tip.0, tip.1 - 3.0), Pen::new(Ink::Text, 1.0).opacity(0.6));
    let mut baseline = tip.1 - above - 5.0;
    for line in words.iter().copied().chain([turns.as_str()]).rev() {
        canvas.label((tip.0 + right, baseline), &Label::new(line).size(15.5).end());
        baseline -= 20.0;
    }
}

fn panel(canvas: &Canvas, left: f64, seen: &[Seen], ink: Ink, title: &str) -> Result<Plot, Box<dyn Error>> {
    let plot =
        Plot::new(canvas, left, 56.0, left + 274.0, 416.0, Scale::log(1.0..1e26), Scale::log(NONE..10.0));
    plot.x_axis((0..=3).map(|n| (10_f64.powi(8 * n), power_of_ten(8 * n))), "condition number $κ$");
    let powers = (-4..=0).map(|n| (10_f64.powi(4 * n), power_of_ten(4 * n)));
    plot.y_axis([(NONE, "0".into())].into_iter().chain(powers), "");
    canvas.label((left - 30.0, 34.0), &Label::new(title).ink(ink).bold());
    let place = |s: &Seen| plot.at(s.condition, if s.error > 0.0 { s.error.max(SMALL) } else { NONE });
    canvas.specks(seen.iter().map(place), Pen::new(ink, 4.4).opacity(0.65));
    for (units, pen) in [(1.0, Pen::new(Ink::Text, 1.6)), (LIMIT, Pen::new(Ink::Text, 1.4).dashed())] {
        // An error of 1 is as wrong as can be.
        plot.curve([(1.0, units * ROUNDING), (1.0 / (units * ROUNDING), 1.0)], pen)?;
    }
    Ok(plot)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference(x: f64, table: &str) -> f64 {
        Decimal::of(x).unwrap().minus(&Decimal::parse(table).unwrap()).unwrap()
    }

    /// An `f64` has 3602879701896397 / 2^55 for 0.1, which is more by a fifth of 2^-55.
    #[test]
    fn a_difference_far_below_the_last_digit_of_a_number_is_seen() {
        assert_eq!(difference(0.1, "0.1"), 2_f64.powi(-55) / 5.0);
        assert_eq!(difference(-0.1, "-1.00E-1"), -2_f64.powi(-55) / 5.0);
        assert_eq!(difference(1.0, "0.99999999999999999999"), 1e-20);
        assert_eq!(difference(0.0, "2.5e-300"), -2.5e-300);
        assert_eq!(difference(3e-310, "0"), 3e-310);
        assert_eq!(difference(100.0, "1e2"), 0.0);
    }
}
