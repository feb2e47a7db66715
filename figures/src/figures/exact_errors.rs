//! Errors of the exact motion over all bodies, against a table of more digits than an `f64` has.

use super::{Drawing, Picture};
use crate::draw::{Canvas, Fill, Label, P, Pen, Plot, Scale};
use crate::ink::Ink;
use nalgebra::Vector3;
use serde_json::Value;
use tumbling::exact::FreeMotion;

/// Made by the program beside it.
const TABLE: &str = include_str!("../../data/errors.json");

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

/// One body spun one way: where it stands on the map, and the worst error of spin and attitude, in units.
struct Seen {
    spun: String,
    cell: [u32; 3],
    place: (f64, f64),
    units: [f64; 2],
    /// A hair inside the triangle's edge, not at the middle of its cell.
    on_edge: bool,
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

fn case(case: &Value) -> Option<Seen> {
    let vector = |field: &str| numbers(&case[field]).map(Vector3::from_vec);
    let moments = vector("inertia")?;
    let motion = FreeMotion::new(moments.try_into().ok()?, &vector("w0")?).ok()?;
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
    let cell: Vec<u32> =
        case["cell"].as_array()?.iter().filter_map(|x| x.as_u64()?.try_into().ok()).collect();
    let (x, y) = (moments.x / moments.z, moments.y / moments.z);
    // From the edges of flat plates, of rods and of wheels; a body in the middle of a cell is 1/60 or more
    // off.
    let on_edge = (x + y - 1.0).min(1.0 - y).min(y - x) < 0.01;
    let spun = case["spin"].as_str()?.to_owned();
    Some(Seen { spun, cell: cell.try_into().ok()?, place: (x, y), units, on_edge })
}

/// As many units as no error may have.
const LIMIT: f64 = 8.0;

/// Up to how many units each shade goes, and the shades.
const STEPS: [(f64, &str, f64); 5] =
    [(0.25, "¼", 0.08), (0.5, "½", 0.24), (1.0, "1", 0.45), (2.0, "2", 0.72), (LIMIT, "8", 1.0)];

fn shade(units: f64) -> f64 {
    STEPS.iter().find(|step| units <= step.0).map_or(1.0, |step| step.2)
}

/// The ways of spinning, as the table and the figure name them.
const WAYS: [(&str, &str); 3] =
    [("generic", "any spin"), ("flip", "near the middle axis"), ("near-separatrix", "near the separatrix")];

pub(super) fn draw() -> Drawing {
    let file: Value = serde_json::from_str(TABLE)?;
    let side = u32::try_from(file["side"].as_u64().ok_or("a table without a side")?)?;
    let mut seen = Vec::new();
    for entry in file["cases"].as_array().ok_or("a table without cases")? {
        let one = case(entry).ok_or_else(|| format!("case {} cannot be read", entry["inertia"]))?;
        if let Some(bad) = one.units.iter().find(|&&units| units.is_nan() || units > LIMIT) {
            return Err(format!("{} {:?} has an error of {bad:.1} units", one.spun, one.cell).into());
        }
        seen.push(one);
    }
    let canvas = Canvas::new(568);
    for (row, (ink, title)) in
        [(Ink::Omega, "the spin’s error"), (Ink::Text, "the attitude’s error")].into_iter().enumerate()
    {
        for (column, (spun, words)) in WAYS.into_iter().enumerate() {
            let (left, top) = (16.0 + 222.0 * column as f64, 104.0 + 242.0 * row as f64);
            let here: Vec<&Seen> = seen.iter().filter(|one| one.spun == spun).collect();
            panel(&canvas, (left, top), side, &here, ink, &|one| one.units[row]);
            let name = |x: f64, y: f64, words: &str| ((left + x, top + y), Label::new(words).size(15.5));
            let (at, label) = name(102.0, -38.0, words);
            canvas.label(at, &label.middle());
            let (at, label) = name(-6.0, -13.0, "needle");
            canvas.label(at, &label);
            let (at, label) = name(203.0, -13.0, "ball");
            canvas.label(at, &label.end());
            let (at, label) = name(118.0, 155.0, "disk");
            canvas.label(at, &label);
        }
        canvas.label((10.0, 38.0 + 242.0 * row as f64), &Label::new(title).ink(ink).bold());
    }
    key(&canvas);
    let small = |row: usize| {
        let count = seen.iter().filter(|one| one.units[row] <= 1.0).count();
        if 2 * count > seen.len() { Ok("most") } else { Err("most errors are beyond one unit") }
    };
    Ok(Picture {
        canvas,
        description: format!(
            "Six triangles of all rigid bodies, with the needle, the ball and the disk in their corners: {} bodies, of which {} are a \
             hair from an edge or a corner, drawn as discs there. Above the error of the spin, below that of the attitude; each for any \
             spin, one near the middle axis and one near the separatrix; the worse of two instants within thirty periods. The stronger \
             the colour, the larger, in units of what the rounding of one input may do by itself. Of the spin, {} errors are within one unit, of the \
             attitude, {} too; none is beyond {LIMIT:.0}, at no edge and in no corner. Near the separatrix, where the motion magnifies rounding \
             most, hardly any is beyond a quarter.",
            seen.len() / WAYS.len(),
            seen.iter().filter(|one| one.on_edge).count() / WAYS.len(),
            small(0)?,
            small(1)?,
        ),
    })
}

/// The triangle of all bodies: needle upper left, ball upper right, disk below.
fn panel(canvas: &Canvas, (left, top): P, side: u32, seen: &[&Seen], ink: Ink, shown: &dyn Fn(&Seen) -> f64) {
    let plot = Plot::new(
        canvas,
        left,
        top,
        left + 204.0,
        top + 150.0,
        Scale::linear(0.0..1.0),
        Scale::linear(0.5..1.0),
    );
    let corner = |shares: [u32; 3]| {
        let [needle, disk, ball] = shares.map(|share| f64::from(share) / f64::from(side));
        plot.at(0.5 * disk + ball, needle + 0.5 * disk + ball)
    };
    let corners = |one: &Seen| {
        let [a, b, down] = one.cell;
        let c = side - a - b;
        let corners = if down == 0 {
            [[a + 1, b, c - 1], [a, b + 1, c - 1], [a, b, c]]
        } else {
            [[a + 1, b + 1, c - 2], [a + 1, b, c - 1], [a, b + 1, c - 1]]
        };
        corners.map(corner)
    };
    let of_shade = |opacity: f64, on_edge: bool| {
        seen.iter().filter(move |one| one.on_edge == on_edge && shade(shown(one)) == opacity)
    };
    for (_, _, opacity) in STEPS {
        canvas.triangles(of_shade(opacity, false).map(|one| corners(one)), Fill::new(ink).opacity(opacity));
    }
    let outline = [[side, 0, 0], [0, side, 0], [0, 0, side]].map(corner);
    canvas.path(&[outline[0], outline[1], outline[2], outline[0]], Pen::new(Ink::Text, 1.0));
    // A disc is a rim, the paper on it, the shade on that.
    let centre = |one: &&Seen| plot.at(one.place.0, one.place.1);
    let on_edge = || seen.iter().filter(|one| one.on_edge);
    canvas.specks(on_edge().map(centre), Pen::new(Ink::Text, 11.0));
    canvas.specks(on_edge().map(centre), Pen::new(Ink::Paper, 9.0));
    for (_, _, opacity) in STEPS {
        canvas.specks(of_shade(opacity, true).map(centre), Pen::new(ink, 9.0).opacity(opacity));
    }
}

/// What the shades mean.
fn key(canvas: &Canvas) {
    let (left, top) = (126.0, 532.0);
    canvas.label((left - 12.0, top + 15.0), &Label::new("units, up to").size(15.5).end());
    for (i, (_, words, opacity)) in STEPS.into_iter().enumerate() {
        let x = left + 62.0 * i as f64;
        let corners = [(x, top), (x + 26.0, top), (x + 26.0, top + 20.0), (x, top + 20.0)];
        canvas.area(&corners, Fill::new(Ink::Text).opacity(opacity), Some(Pen::new(Ink::Text, 1.0)));
        canvas.label((x + 32.0, top + 15.0), &Label::new(words).size(15.5));
    }
    canvas.label((left + 340.0, top + 15.0), &Label::new("1 unit = $κ$·$2^{−53}$").size(15.5));
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
