//! The atlas: what becomes of each method on each hard case, read from the record.

use super::{Drawing, Picture};
use crate::draw::{Canvas, Fill, Label, Pen};
use crate::ink::Ink;
use tumbling_measure::atlas::{Fate, Precision, Row, recorded};

/// How each fate is drawn: a sign that says it without colour, and how dark.
const fn drawn(fate: Fate) -> (&'static str, f64) {
    match fate {
        Fate::Right => ("", 0.0),
        Fate::Late => ("l", 0.13),
        Fate::Worn => ("w", 0.22),
        Fate::WrongFlips => ("m", 0.38),
        Fate::Gained => ("+", 0.62),
        Fate::Lost => ("−", 0.62),
        Fate::Reversed => ("r", 0.85),
        Fate::Refused => ("e", 0.0),
        Fate::NotFinite => ("×", 1.0),
    }
}

/// The sizes of the sheet, in points.
const LEFT: f64 = 178.0;
const RIGHT: f64 = 672.0;
const ROW: f64 = 17.0;
const GAP: f64 = 14.0;

struct Chart {
    name: &'static str,
    title: &'static str,
    swept: &'static str,
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

/// A sheet while it is drawn.
struct Sheet {
    all: Vec<Row>,
    runners: Vec<&'static str>,
    canvas: Canvas,
    tiles: Tiles,
    /// How wide a column is.
    wide: f64,
    /// Where the rows end.
    bottom: f64,
    /// Whether columns have numbers, and a key below names them.
    keyed: bool,
}

const TOP: f64 = 62.0;

/// One sheet: charts side by side, a row for each method.
fn sheet(charts: &[Chart], keyed: bool) -> Drawing {
    let all: Vec<Row> = recorded()?;
    let runners = distinct(all.iter().map(|row| row.runner));
    let columns: Vec<Vec<&str>> = charts
        .iter()
        .map(|chart| distinct(all.iter().filter(|p| p.chart == chart.name).map(|p| p.case)))
        .collect();
    let count: usize = columns.iter().map(Vec::len).sum();
    let wide = (RIGHT - LEFT - GAP * (charts.len() - 1) as f64) / count as f64;
    let bottom = TOP + ROW * runners.len() as f64;
    let keys = if keyed { columns[0].len().div_ceil(2) } else { 0 };
    let canvas = Canvas::new((bottom + 118.0 + 19.0 * keys as f64) as u32);
    for (row, runner) in runners.iter().enumerate() {
        let y = TOP + ROW * row as f64;
        canvas.label((LEFT - 8.0, y + 0.76 * ROW), &Label::new(*runner).size(13.0).end());
    }
    let mut sheet = Sheet { all, runners, canvas, tiles: Tiles::default(), wide, bottom, keyed };
    let mut said = Vec::new();
    let mut x = LEFT;
    for (chart, cases) in charts.iter().zip(&columns) {
        said.push(sheet.chart(chart, cases, x));
        x += wide * cases.len() as f64 + GAP;
    }
    sheet.tiles.draw(&sheet.canvas);
    let mut y = bottom + 50.0;
    if keyed {
        for (index, case) in columns[0].iter().enumerate() {
            let (column, row) = (index / keys, index % keys);
            let at = (24.0 + 340.0 * column as f64, y + 19.0 * row as f64);
            sheet.canvas.label(at, &Label::new(format!("{}  {case}", index + 1)).size(14.0));
        }
        y += 19.0 * keys as f64 + 6.0;
    }
    let here = |fate| sheet.all.iter().any(|p| p.fate == fate && charts.iter().any(|c| c.name == p.chart));
    let used: Vec<Fate> = Fate::ALL.into_iter().filter(|&fate| here(fate)).collect();
    legend(&sheet.canvas, y, &used);
    Ok(Picture {
        canvas: sheet.canvas,
        description: format!(
            "A table of squares, a row for each method, a column for each case. An empty square is right; marks and darkness say what \
             went wrong, a small square at the corner what single precision does if that differs. {}",
            said.join(" ")
        ),
    })
}

impl Sheet {
    /// One chart, from `x` on; says in words what it shows.
    fn chart(&mut self, chart: &Chart, cases: &[&str], x: f64) -> String {
        let middle = x + 0.5 * self.wide * cases.len() as f64;
        self.canvas.label((middle, 22.0), &Label::new(chart.title).size(15.5).bold().middle());
        for (column, case) in cases.iter().enumerate() {
            let left = x + self.wide * column as f64;
            let title = if self.keyed { (column + 1).to_string() } else { short(case) };
            let at = (left + 0.5 * self.wide, TOP - 7.0);
            self.canvas.label(at, &Label::new(title).size(11.0).middle());
            for row in 0..self.runners.len() {
                let fate = |precision| self.fate(chart, case, self.runners[row], precision);
                let fates = [fate(Precision::Double), fate(Precision::Single)];
                self.tile(fates, left, TOP + ROW * row as f64);
            }
        }
        let right = |case: &&&str, runner: &str| {
            self.fate(chart, case, runner, Precision::Double) == Some(Fate::Right)
        };
        let counts: Vec<_> = self
            .runners
            .iter()
            .map(|&runner| (cases.iter().filter(|case| right(case, runner)).count(), runner))
            .collect();
        let below = (middle, self.bottom + 20.0);
        self.canvas.label(below, &Label::new(chart.swept).size(14.0).middle());
        format!(
            "{}: {}, {} cases from {} to {}. {}.",
            capital(chart.title),
            chart.swept,
            cases.len(),
            cases.first().copied().unwrap_or_default(),
            cases.last().copied().unwrap_or_default(),
            best_and_worst(&counts)
        )
    }

    fn fate(&self, chart: &Chart, case: &str, runner: &str, precision: Precision) -> Option<Fate> {
        let place = self.all.iter().find(|p| {
            p.chart == chart.name && p.case == case && p.runner == runner && p.precision == precision
        });
        place.map(|place| place.fate)
    }

    /// A square with its corner here, for double precision, and a small one for single where that differs.
    fn tile(&mut self, fates: [Option<Fate>; 2], left: f64, y: f64) {
        let [double, single] = fates;
        if let Some(fate) = double {
            self.tiles.large[fate as usize].push([left, y, left + self.wide, y + ROW]);
        }
        if let (Some(double), Some(single)) = (double, single)
            && double != single
        {
            let side = 0.42 * ROW;
            let (ex, ey) = (left + self.wide - 0.8, y + ROW - 0.8);
            self.tiles.small[single as usize].push([ex - side, ey - side, ex, ey]);
        }
    }
}

/// As a power of ten where that is shorter.
fn short(case: &str) -> String {
    match case.parse::<f64>() {
        Ok(value) if !(0.01..100.0).contains(&value) || case.contains('e') => {
            let power = value.log10().round();
            if power == 0.0 { "1".to_owned() } else { format!("$10^{{{power}}}$") }
        }
        _ => case.to_owned(),
    }
}

/// With a capital first letter.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| format!("{}{}", first.to_uppercase(), letters.as_str()))
}

/// Who is right most often and who never, in double precision.
fn best_and_worst(counts: &[(usize, &str)]) -> String {
    let with = |count: usize| {
        let names: Vec<&str> = counts.iter().filter(|c| c.0 == count).map(|c| c.1).collect();
        names.join("; ")
    };
    let mut ranks: Vec<usize> = counts.iter().map(|c| c.0).collect();
    ranks.sort_unstable();
    ranks.dedup();
    let best: Vec<_> = ranks
        .iter()
        .rev()
        .take(2)
        .filter(|&&count| count > 0)
        .map(|&count| format!("Right in {count}: {}", with(count)))
        .collect();
    let never = with(0);
    if never.is_empty() { best.join(". ") } else { format!("{}. Right in none: {never}", best.join(". ")) }
}

/// Squares by their fate: those of double precision, and the small ones of single precision at their corners.
#[derive(Default)]
struct Tiles {
    large: [Vec<[f64; 4]>; Fate::ALL.len()],
    small: [Vec<[f64; 4]>; Fate::ALL.len()],
}

impl Tiles {
    fn draw(&self, canvas: &Canvas) {
        for (tiles, fate) in self.large.iter().zip(Fate::ALL) {
            let (sign, dark) = drawn(fate);
            canvas.tiles(tiles, fill(fate), Some(Pen::new(Ink::Faint, 0.6)));
            let ink = if dark > 0.5 { Ink::Paper } else { Ink::Text };
            let mut rows = tiles.clone();
            rows.sort_by(|a, b| a[1].total_cmp(&b[1]));
            // The signs of one row in one element.
            for row in rows.chunk_by(|a, b| a[1].total_cmp(&b[1]).is_eq()).filter(|_| !sign.is_empty()) {
                let x: Vec<f64> = row.iter().map(|tile| 0.5 * (tile[0] + tile[2])).collect();
                let label = Label::new(sign.repeat(x.len())).size(13.0).ink(ink).middle();
                canvas.letters(&x, row[0][3] - 0.26 * ROW, &label);
            }
        }
        for (tiles, fate) in self.small.iter().zip(Fate::ALL) {
            canvas.tiles(tiles, Fill::new(Ink::Paper), None);
            canvas.tiles(tiles, fill(fate), Some(Pen::new(Ink::Faint, 0.8)));
        }
    }
}

fn fill(fate: Fate) -> Fill {
    let (_, dark) = drawn(fate);
    let (ink, dark) = if fate == Fate::Refused { (Ink::Faint, 0.35) } else { (Ink::Wrong, dark) };
    Fill::new(ink).opacity(dark)
}

/// The fates that the sheet shows.
fn legend(canvas: &Canvas, y: f64, used: &[Fate]) {
    let mut x = 24.0;
    let mut y = y;
    let mut tiles = Tiles::default();
    for &fate in used {
        let word = fate.word();
        if x > 560.0 {
            (x, y) = (24.0, y + 24.0);
        }
        tiles.large[fate as usize].push([x, y - 13.0, x + 22.0, y + 4.0]);
        canvas.label((x + 28.0, y), &Label::new(word).size(14.0));
        x += 44.0 + 8.2 * word.len() as f64;
    }
    tiles.draw(canvas);
    if x > 480.0 {
        (x, y) = (18.0, y + 24.0);
    }
    canvas.label((x + 6.0, y), &Label::new("corner: single precision").size(14.0));
}

pub(super) fn steps() -> Drawing {
    sheet(
        &[
            Chart { name: "steady spin", title: "a stable spin", swept: "turn in a step, rad" },
            Chart { name: "flipping", title: "a body that flips", swept: "turn in a step, rad" },
        ],
        false,
    )
}

pub(super) fn stiff() -> Drawing {
    sheet(
        &[
            Chart { name: "needles", title: "needles", swept: "largest over smallest moment" },
            Chart { name: "damping", title: "damping", swept: "damping times step over inertia" },
        ],
        false,
    )
}

pub(super) fn pushes() -> Drawing {
    sheet(&[Chart { name: "pushes", title: "three flips after a push", swept: "push, rad/s" }], false)
}

pub(super) fn named() -> Drawing {
    sheet(
        &[Chart { name: "named", title: "odd bodies, far scales", swept: "number in the list below" }],
        true,
    )
}
