//! The picture of a verdict: how a record of an engine runs beside the exact motion, and how the laws are
//! kept.

use crate::draw::{Canvas, Fill, Label, P, Pen, Plot, Scale};
use crate::ink::Ink;
use crate::picture::power_of_ten;
use std::fmt::Write as _;
use tumbling_judge::{Law, LawName, Outcome, Point, Verdict, plain_number};

const LEFT: f64 = 74.0;
const RIGHT: f64 = 500.0;
/// Narrower than the book's drawings: a picture that a small screen shrinks keeps larger letters.
const WIDTH: u32 = 520;
/// The upper plot's edges, and how high the lower one is.
const SPIN: [f64; 2] = [150.0, 352.0];
const HIGH: f64 = 202.0;
/// From a line of letters to the next.
const LINE: f64 = 21.0;
/// What is smaller lies on the lower edge.
const FLOOR: f64 = 1e-16;
/// Spins are drawn up to so many times the exact motion's greatest.
const ROOM: f64 = 2.5;

type Drawn = Result<(), Box<dyn std::error::Error>>;

/// A picture of a verdict: a complete SVG document without an XML header, as the book's figures are.
///
/// Above is the spin about the axis that the body is spun about, as recorded and as the exact motion has it,
/// with its flips; below are the errors of energy, `|L|` and direction, where a free body is judged.
///
/// # Errors
/// What the drawing backend reported.
pub fn verdict(verdict: &Verdict) -> Result<String, Box<dyn std::error::Error>> {
    let said = growths(verdict);
    let lines = said.iter().map(|(.., lines)| lines.len()).sum::<usize>();
    let upper = SPIN[1] + LINE * (2 + lines) as f64 + 24.0;
    let height = upper + HIGH + 64.0;
    let canvas = Canvas::sized(WIDTH, height.ceil() as u32);
    // A ground of its own: a viewer's may be white where the letters are those for the night.
    let (w, h) = (f64::from(WIDTH), height.ceil());
    canvas.area(&[(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)], Fill::new(Ink::Paper), None);
    let title = title(verdict);
    heading(&canvas, verdict);
    let end = verdict.curve.last().map_or(0.0, |point| point.time);
    // A record of one stretch has some width all the same.
    let end = if end > 0.0 && end.is_finite() { end } else { 1.0 };
    spins(&canvas, verdict, end)?;
    errors(&canvas, verdict, end, upper, &said)?;
    Ok(canvas.finish("verdict", &title, &description(verdict)))
}

/// What made the record, in a line.
fn diagnosis(verdict: &Verdict) -> String {
    let Some(diagnosis) = &verdict.diagnosis else { return "no rule is named".into() };
    format!("{}: {}", diagnosis.words(), diagnosis.best.rule.name())
}

fn grade(verdict: &Verdict) -> String {
    let words = verdict.outcome.key();
    let reason = match (verdict.file_mistakes.first(), verdict.resets.first(), verdict.complaints.last()) {
        (Some(_), ..) => Some("the file is not what its names say".to_owned()),
        (_, Some(reset), _) => Some(format!("the motion starts anew at {:.3} s", reset.time)),
        (.., Some(complaint)) => Some(complaint.to_string()),
        _ => verdict
            .broken()
            .max_by(|a, b| a.growth.rank().cmp(&b.growth.rank()).then(a.most.total_cmp(&b.most)))
            .map(|law| format!("{} is off by up to {}", law.name.words(), plain_number(law.most)))
            .or_else(|| {
                let worst = verdict.worst()?;
                Some(format!("kept worst is {}, {}", worst.name.words(), worst.growth.name()))
            }),
    };
    reason.map_or_else(|| words.to_owned(), |reason| format!("{words}: {reason}"))
}

fn title(verdict: &Verdict) -> String {
    format!("{}; {}", grade(verdict), diagnosis(verdict))
}

/// The text in lines of so many letters at most, broken between words.
fn broken(text: &str, most: usize, lines: usize) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match all.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => all.push(word.chars().take(most).collect()),
        }
    }
    if all.len() > lines {
        all.truncate(lines);
        if let Some(last) = all.last_mut() {
            last.push('…');
        }
    }
    all
}

/// A dollar sign would start a symbol.
fn plain(text: &str) -> String {
    text.replace('$', "").chars().filter(|c| !c.is_control()).collect()
}

fn heading(canvas: &Canvas, verdict: &Verdict) {
    let mut first = grade(verdict);
    if let Some(letter) = first.get(..1) {
        first = letter.to_uppercase() + &first[1..];
    }
    let ink = if verdict.outcome == Outcome::Failed { Ink::Wrong } else { Ink::Text };
    let lines = broken(&plain(&first), 50, 2);
    let under = 20.0 * if lines.len() > 1 { 1.0 } else { 0.0 };
    for (line, y) in lines.into_iter().zip([26.0, 46.0]) {
        canvas.label((LEFT - 30.0, y), &Label::new(line).bold().ink(ink));
    }
    for (line, y) in broken(&plain(&diagnosis(verdict)), 60, 2).into_iter().zip([48.0 + under, 67.0 + under])
    {
        canvas.label((LEFT - 30.0, y), &Label::new(line).size(15.5));
    }
    if let Some(engine) = &verdict.record.engine {
        let engine: String = broken(&plain(engine), 64, 1).concat();
        canvas.label((LEFT - 30.0, 106.0), &Label::new(engine).size(14.5).ink(Ink::Faint));
    }
}

/// Steps of 1, 2 or 5 times a power of ten, some five of them, over a range.
fn ticks(from: f64, to: f64) -> Vec<(f64, String)> {
    let rough = (to - from) / 5.0;
    let power = 10_f64.powf(rough.log10().floor());
    let step = power * [1.0, 2.0, 5.0, 10.0].into_iter().find(|x| x * power >= rough).unwrap_or(10.0);
    let digits = (-step.log10().floor()).clamp(0.0, 12.0) as usize;
    let mut all = Vec::new();
    let mut number = (from / step).ceil();
    while number * step <= to + 1e-9 * step && all.len() < 12 {
        let value = number * step;
        let small = !(1e-4..1e5).contains(&step);
        let text = if value == 0.0 {
            "0".into()
        } else if small {
            format!("{value:.0e}")
        } else {
            format!("{value:.digits$}")
        };
        all.push((value, text.replace('-', "−")));
        number += 1.0;
    }
    all
}

fn spins(canvas: &Canvas, verdict: &Verdict, end: f64) -> Drawn {
    let axis = verdict.curve.first().map_or(0, |point| point.exact.iamax());
    let size = |range: fn(&Point) -> &[nalgebra::Vector3<f64>; 2]| {
        let sizes = verdict.curve.iter().flat_map(|point| range(point).iter().map(|x| x[axis].abs()));
        sizes.filter(|x| x.is_finite()).fold(0.0, f64::max)
    };
    let (exact, found) = (size(|point| &point.exact_range), size(|point| &point.spin_range));
    let most = 1.12 * exact.max(found.min(ROOM * exact));
    let most = if most > 0.0 && most.is_finite() { most } else { 1.0 };
    let plot = Plot::new(canvas, [LEFT, SPIN[0], RIGHT, SPIN[1]], 0.0..end, -most..most);
    let name = ["$ω_1$", "$ω_2$", "$ω_3$"][axis.min(2)];
    let middle = verdict.flips.is_some() && middle(verdict) == axis;
    let about = if middle { ", middle axis" } else { "" };
    plot.x_axis(ticks(0.0, end).into_iter().map(|(t, _)| (t, String::new())), "");
    plot.y_axis(ticks(-most, most), &format!("spin {name}{about} (rad/s)"));
    let within = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(-most, most) };
    let band = |range: fn(&Point) -> &[nalgebra::Vector3<f64>; 2], fill: Fill| {
        let ends = |side: usize| verdict.curve.iter().map(move |p| (p.time, within(range(p)[side][axis])));
        let points: Vec<P> = ends(1)
            .chain(ends(0).collect::<Vec<_>>().into_iter().rev())
            .map(|(t, x)| plot.at(t, x))
            .collect();
        canvas.area(&points, fill, None);
    };
    // Where a point stands for many rows, what they reach shows as a band.
    let many = verdict.record.rows as f64 > 1.5 * verdict.curve.len() as f64;
    if many {
        band(|p| &p.exact_range, Fill::new(Ink::Text).opacity(0.16));
        band(|p| &p.spin_range, Fill::new(Ink::Omega).opacity(0.22));
    }
    plot.curve(
        verdict.curve.iter().map(|p| (p.time, within(p.exact[axis]))),
        Pen::new(Ink::Text, 3.2).opacity(0.45),
    )?;
    plot.curve(verdict.curve.iter().map(|p| (p.time, within(p.spin[axis]))), Pen::new(Ink::Omega, 1.8))?;
    flip_marks(canvas, verdict, &plot, end, middle);
    key(canvas);
    if let Some(flips) = verdict.flips.as_ref().filter(|_| middle) {
        let text = format!("flips ○: {} (exact: {})", flips.found, flips.exact);
        canvas.label((RIGHT, SPIN[1] + 22.0), &Label::new(text).size(15.5).end().ink(Ink::AxisMid));
    }
    if found > ROOM * exact && exact > 0.0 {
        let text = format!("leaves the picture: up to {} rad/s", plain_number(found));
        canvas.label((RIGHT, SPIN[1] + 22.0 + LINE), &Label::new(text).size(15.5).end().ink(Ink::Wrong));
    }
    Ok(())
}

/// The flips, and where the body turns over for good.
fn flip_marks(canvas: &Canvas, verdict: &Verdict, plot: &Plot, end: f64, middle: bool) {
    let Some(flips) = &verdict.flips else { return };
    if middle {
        let places: Vec<P> = flips.times.iter().filter(|t| **t <= end).map(|t| plot.at(*t, 0.0)).collect();
        if places.len() <= 80 {
            for place in places {
                canvas.disc(place, 3.6, Fill::new(Ink::Paper), Some(Pen::new(Ink::AxisMid, 1.8)));
            }
        }
    }
    if let Some(t) = flips.turned_over {
        let at = plot.at(t, 0.0);
        canvas.crosses([at], 5.0, Pen::new(Ink::Wrong, 2.4));
        let label = Label::new("turns over").ink(Ink::Wrong).halo(Ink::Paper);
        let (x, label) =
            if at.0 > 0.5 * (LEFT + RIGHT) { (at.0 - 10.0, label.end()) } else { (at.0 + 10.0, label) };
        canvas.label((x, at.1 - 10.0), &label);
    }
}

/// The key stands above the plot, where no curve can run through it.
fn key(canvas: &Canvas) {
    let y = SPIN[0] - 14.0;
    let mut x = RIGHT;
    let mut key = |text: String, ink: Ink, width: f64| {
        let wide = 8.6 * text.chars().filter(|c| !"$_".contains(*c)).count() as f64;
        canvas.label((x, y), &Label::new(text).size(15.5).end().ink(ink));
        x -= wide + 8.0;
        let pen = Pen::new(ink, width);
        let pen = if ink == Ink::Text { pen.opacity(0.45) } else { pen };
        canvas.line((x - 20.0, y - 5.0), (x, y - 5.0), pen);
        x -= 36.0;
    };
    key("exact".into(), Ink::Text, 3.2);
    key("recorded".into(), Ink::Omega, 1.8);
}

/// The index of the middle moment.
fn middle(verdict: &Verdict) -> usize {
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| verdict.moments[i].total_cmp(&verdict.moments[j]));
    order[1]
}

type Of = fn(&Point) -> Option<f64>;
/// A law that is drawn, with its pen, where its errors are, and what is said of it in lines.
type Said<'a> = (&'a Law, Pen, Of, Vec<String>);

/// What is said of each law that is drawn: its name, and how its error grows.
fn growths(verdict: &Verdict) -> Vec<Said<'_>> {
    let laws: [(LawName, &str, Pen, Of); 3] = [
        (LawName::Energy, "energy", Pen::new(Ink::Text, 2.4), |p| Some(p.energy)),
        (LawName::Momentum, "|$!L$|", Pen::new(Ink::Momentum, 2.4), |p| Some(p.momentum)),
        (LawName::Direction, "direction of $!L$", Pen::new(Ink::Momentum, 2.0).dashed(), |p| p.direction),
    ];
    let drawn = laws.into_iter().filter_map(|(name, words, pen, of)| {
        let law = verdict.laws.iter().find(|law| law.name == name)?;
        Some((law, pen, of, broken(&format!("{words}: {}", law.plain()), 52, 3)))
    });
    drawn.collect()
}

fn errors(canvas: &Canvas, verdict: &Verdict, end: f64, upper: f64, drawn: &[Said<'_>]) -> Drawn {
    let largest = drawn.iter().map(|(law, ..)| law.most).filter(|x| x.is_finite()).fold(1e-14, f64::max);
    let top = (largest.log10().ceil() as i32).clamp(-12, 300);
    let ceiling = 10_f64.powi(top);
    let lower = upper + HIGH;
    let plot = Plot::new(canvas, [LEFT, upper, RIGHT, lower], 0.0..end, Scale::log(FLOOR..ceiling));
    let every = ((top + 21) / 6).max(1);
    plot.x_axis(ticks(0.0, end), "time $t$ (s)");
    plot.y_axis((-16..=top).filter(|n| (n + 16) % every == 0).map(|n| (10_f64.powi(n), power_of_ten(n))), "");
    if drawn.is_empty() {
        let at = (0.5 * (LEFT + RIGHT), 0.5 * (upper + lower));
        canvas.label(at, &Label::new("no law of a free body is judged here").middle().ink(Ink::Faint));
        return Ok(());
    }
    let allowed = verdict.options.allowed(LawName::Energy).filter(|x| (FLOOR..ceiling).contains(x));
    if let Some(allowed) = allowed {
        plot.curve([(0.0, allowed), (end, allowed)], Pen::new(Ink::Wrong, 1.4).dotted())?;
    }
    for (_, pen, of, _) in drawn {
        let sizes = verdict.curve.iter().filter_map(|p| Some((p.time, of(p)?.abs().clamp(FLOOR, ceiling))));
        plot.curve(sizes, *pen)?;
    }
    // After the curves, so that its halo keeps it clear of them.
    if let Some(allowed) = allowed {
        let at = plot.at(end, allowed);
        canvas.label(
            (at.0 - 6.0, at.1 - 6.0),
            &Label::new("allowed").end().size(14.5).ink(Ink::Wrong).halo(Ink::Paper),
        );
    }
    // What a curve is and how it grows stands above the plot, a line each: curves may lie upon each other.
    let mut y = upper - 14.0;
    for (_, pen, _, lines) in drawn.iter().rev() {
        for line in lines.iter().rev() {
            canvas.label((LEFT + 4.0, y), &Label::new(line.clone()).size(15.5).ink(pen.ink()));
            y -= LINE;
        }
        canvas.line((LEFT - 30.0, y + LINE - 5.0), (LEFT - 4.0, y + LINE - 5.0), *pen);
    }
    Ok(())
}

fn description(verdict: &Verdict) -> String {
    let mut text = format!(
        "A record of {} rows over {:.3} s: {}.",
        verdict.record.rows,
        verdict.record.duration,
        title(verdict)
    );
    let axis = verdict.curve.first().map_or(0, |point| point.exact.iamax());
    let last = verdict.curve.last().map(|point| (point.spin[axis], point.exact[axis]));
    if let Some((found, exact)) = last {
        let _ = write!(
            text,
            " Above, the spin about axis {} as recorded and as the exact motion has it; near the end it is {found:.3} rad/s, and should be {exact:.3}.",
            axis + 1
        );
    }
    if let Some(flips) = &verdict.flips {
        let _ = write!(
            text,
            " The spin along the middle axis changes sign {} times (exact: {}).",
            flips.found, flips.exact
        );
        if let Some(t) = flips.turned_over {
            let _ = write!(text, " The spin that should never turn over does so at {t:.3} s.");
        }
    }
    let laws = [LawName::Energy, LawName::Momentum, LawName::Direction];
    for law in verdict.laws.iter().filter(|law| laws.contains(&law.name)) {
        let _ = write!(
            text,
            " Below, the error of {}: up to {:.1e}, {}.",
            law.name.words(),
            law.most,
            law.plain()
        );
    }
    for misread in &verdict.file_mistakes {
        let _ = write!(text, " The file: {}.", misread.words());
    }
    text
}
