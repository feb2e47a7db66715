//! Prints, as lines of JSON, what the functions of the widgets answer natively, bit for bit. `grid.mjs` asks
//! the built modules the same.

mod maths;

use exchange::Numbers;
use serde_json::json;
use std::io::{self, Write as _};
use std::path::Path;

fn main() -> io::Result<()> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    let row = Numbers::empty();
    let mut ask = |module: &str,
                   answer: fn(u32, &Numbers) -> usize,
                   what: u32,
                   asked: &[f64],
                   text: Option<fn() -> String>| {
        row.fill(asked);
        let count = answer(what, &row);
        let found: Vec<f64> = (0..count).map(|i| row.get(i)).collect();
        let said = text.filter(|_| count == 0).map(|text| text());
        let (asked, found) = (bits(asked), bits(&found));
        let line = json!({"module": module, "what": what, "asked": asked, "found": found, "said": said});
        writeln!(out, "{line}")
    };

    two_arrows(&mut ask)?;
    your_box(&mut ask)?;
    your_body(&mut ask)?;
    exact(&mut ask)?;
    engines(&row, &mut ask)?;
    methods(&mut ask)?;
    tumble(&mut ask)?;
    top(&row, &mut ask)?;
    for argument in std::env::args_os().skip(1) {
        record(&mut out, Path::new(&argument))?;
    }
    out.flush()
}

/// Asks a module, by its name and function, a question, and has the answer printed.
type Ask<'a> =
    dyn FnMut(&str, fn(u32, &Numbers) -> usize, u32, &[f64], Option<fn() -> String>) -> io::Result<()> + 'a;

/// Starts that turn over, that tumble, that stand, and odd ones.
const SPINS: [[f64; 3]; 7] = [
    [10.0, 0.1, 0.1],
    [1.0, 1.0, 1.0],
    [1.0, 1.0, 0.0],
    [20.0, 0.0, 0.0],
    [-3.0, 1e-6, 2.0],
    [0.0; 3],
    [f64::NAN, 1e200, 1.0],
];

/// Moments of bodies flat, long, round and impossible, kg m².
const MOMENTS: [[f64; 3]; 5] =
    [[10.0, 13.0, 5.0], [1.0, 1.0, 1.0], [1e-6, 2.0, 2.0], [2.0, 1.0, 3.0], [1.0, 2.0, 4.0]];

fn two_arrows(ask: &mut Ask<'_>) -> io::Result<()> {
    for body in 0..6 {
        for between in 0..3 {
            for degrees in -4..=188 {
                let (up, along) = (0.5 * f64::from(degrees)).to_radians().sin_cos();
                let asked = [f64::from(body), f64::from(between), along, up];
                ask("two-arrows", widget_two_arrows::answer, 0, &asked, None)?;
            }
        }
    }
    for odd in [f64::NAN, f64::INFINITY, -1e300, 1e-300, 0.0] {
        ask("two-arrows", widget_two_arrows::answer, 0, &[0.0, 0.0, odd, 1.0], None)?;
        ask("two-arrows", widget_two_arrows::answer, 0, &[odd, odd, odd, odd], None)?;
        let pair = [1.0, 0.9, 0.4, 0.0, odd, -0.3, 0.7, 0.1];
        let asked = [&[1.0, 1.0, odd, 0.2, 2.0], &pair[..]].concat();
        ask("two-arrows", widget_two_arrows::answer, 1, &asked, None)?;
    }
    Ok(())
}

/// Boxes of sizes, masses and spins ordinary, extreme and impossible.
fn your_body(ask: &mut Ask<'_>) -> io::Result<()> {
    let mut ask = |what: u32, asked: &[f64]| {
        ask("your-body", widget_your_body::answer, what, asked, Some(|| widget_your_body::WHY.said()))
    };
    let sizes = [1e-160, 0.0078, 0.16, 1.0, 620.0, 0.0, -1.0, f64::NAN];
    for kind in 0..9_u32 {
        for (i, a) in sizes.into_iter().enumerate() {
            for (j, b) in sizes.into_iter().enumerate() {
                let c = sizes[(3 * i + 5 * j + 2) % sizes.len()];
                ask(0, &[f64::from(kind), [0.2, 1e12, 0.0][(i + j) % 3], a, b, c])?;
            }
        }
    }
    for [a, b, c] in MOMENTS {
        for products in [[0.0; 3], [0.1, -0.2, 0.3], [1e-9, 0.0, 2.0]] {
            let [xy, xz, yz] = products;
            ask(0, &[9.0, 4.0, a, b, c, xy, xz, yz])?;
            for at in [0.0, 0.3, 1e160, f64::NAN] {
                let cone = [5.0, 2.0, 0.1, a, 0.0, 0.0, 0.0, 0.0, at, 0.2, -0.7];
                ask(5, &[&[2.0, 9.0, 4.0, a, b, c, xy, xz, yz, 0.0, 0.0, 0.0][..], &cone].concat())?;
            }
            for angles in [[0.0; 3], [0.3, -1.2, 2.9], [f64::NAN, 0.0, 0.0]] {
                ask(3, &[a, b, c, xy, xz, yz, angles[0], angles[1], angles[2]])?;
            }
        }
        for (axis, share) in [(0.0, 0.3), (2.0, 0.9), (0.0, 1.0)] {
            ask(1, &[a.min(b).min(c), b, a.max(b).max(c), axis, -1.0, share])?;
        }
        ask(2, &[a, b, c, 0.0, 2.0, 4.0, 0.0, 0.2, 0.4, 1.0])?;
    }
    Ok(())
}

fn your_box(ask: &mut Ask<'_>) -> io::Result<()> {
    let mut ask = |asked: &[f64]| {
        ask("your-body", widget_your_body::answer, 4, asked, Some(|| widget_your_body::WHY.said()))
    };
    let edges = [1e-200, 0.02, 1.0, 2.0, 3.0, 17.3, 1e100, 0.0, -1.0, f64::NAN];
    for (i, a) in edges.into_iter().enumerate() {
        for (j, b) in edges.into_iter().enumerate() {
            let c = edges[(3 * i + 7 * j + 4) % edges.len()];
            for spin in [[1.0, 1.0, 0.0], [0.0, 0.0, -2.5], [1.0, 0.01, 0.01], [0.0; 3], [1e-160, 3e160, 0.1]]
            {
                let mass = if i + j == 9 { 0.0 } else { 0.1 + j as f64 };
                let asked = [a, b, c, mass, spin[0], spin[1], spin[2]];
                ask(&asked)?;
            }
        }
    }
    let sizes = [(2.0, 1.0, 3.0), (1.0, 1.0, 1.0), (2.0, 2.0, 1.0)];
    let spins = [[1.0, 1.0, 0.0], [3.0, 0.0, 0.0], [0.0, 0.0, 2.0], [1e300, 1.0, 1.0], [1e300, 0.0, 0.0]];
    for (a, b, c) in sizes {
        for mass in [1e-300, 1e-200, 1.0, 1e200, 1e300] {
            for [x, y, z] in spins {
                let asked = [a, b, c, mass, x, y, z];
                ask(&asked)?;
            }
        }
    }
    Ok(())
}

/// Each setting is prepared, then asked for instants near and far, a stretch of time, and polhodes.
fn tumble(ask: &mut Ask<'_>) -> io::Result<()> {
    let mut tumble = |what: u32, asked: &[f64]| {
        ask("tumble", widget_tumble::answer, what, asked, Some(|| widget_tumble::WHY.said()))
    };
    tumble(1, &[1.0])?;
    for body in 0..11 {
        for own in [[1.0, 2.0, 2.5], [3.0, 1.0, 1.0], [0.0, 1.0, 1.0], [1.0, f64::NAN, 1.0]] {
            for what in [6, 7, 12] {
                tumble(what, &[f64::from(body), own[0], own[1], own[2]])?;
            }
        }
    }
    let pushes = [0.1, 0.01, 1e-3, 1e-6, 1e-9, 5e-324, 0.0, 1.0, -0.3, 1e200, f64::NAN];
    let spins = [10.0, 0.1, -7.3, 1e-300, 1e300, 0.0, f64::INFINITY];
    let times = [0.0, 0.69, 1.38, -2.5, 17.3, 1e6, 1e6 + 0.1, 1e12, 1e16, 1e300, f64::NAN];
    for body in 0..8 {
        for push in pushes {
            for spin in spins {
                tumble(0, &[f64::from(body), spin, push, 0.0])?;
                for t in times {
                    tumble(1, &[t])?;
                }
                tumble(2, &[0.0, 8.0, 17.0])?;
                tumble(2, &[1e6, 1e6 + 20.0, 5.0])?;
                tumble(9, &[0.0, 8.0, 5.0])?;
                tumble(10, &[1.3])?;
            }
        }
        for about in [1.0, 2.0] {
            tumble(0, &[f64::from(body), 3.7, 0.3, about])?;
            tumble(1, &[12.3])?;
            tumble(2, &[-1.0, 8.0, 17.0])?;
        }
        for (axis, depth) in
            [(0.0, 1.0), (1.0, 1.05), (1.0, 0.0015), (2.0, 0.5), (2.0, 1e-6), (3.0, f64::NAN)]
        {
            tumble(3, &[axis, depth, 24.0])?;
        }
    }
    for own in [[1.0, 2.0, 2.5], [3.0, 1.0, 1.0], [1.0, 2.0, 3.5], [-1.0, 1.0, 1.0]] {
        for which in [8.0, 9.0] {
            for about in [0.0, 1.0, 3.0] {
                tumble(0, &[which, 5.0, 0.1, about, own[0], own[1], own[2], 1.0, -2.0, 0.3])?;
                tumble(1, &[2.5])?;
                tumble(9, &[-1.0, 3.0, 7.0])?;
                tumble(10, &[2.5])?;
                tumble(11, &[2.5, 1.7])?;
                tumble(3, &[1.0, 1.5, 24.0])?;
            }
        }
    }
    for odd in [f64::NAN, f64::INFINITY, -1e300, 1e-300, 0.0] {
        tumble(0, &[odd, odd, odd, odd])?;
        tumble(9, &[odd, 1.0, odd])?;
        tumble(10, &[odd])?;
        tumble(2, &[odd, 1.0, odd])?;
        tumble(3, &[odd, odd, odd])?;
    }
    Ok(())
}

/// The engines of the pitfalls, each from its start on in two pieces, as a page asks.
fn engines(row: &Numbers, ask: &mut Ask<'_>) -> io::Result<()> {
    let name = "pitfalls";
    let answer = widget_pitfalls::answer;
    for moments in MOMENTS {
        for spin in SPINS {
            let start = [moments, spin].concat();
            for engine in 0..4 {
                for step in [0.001, 0.01, 0.5, 1e9] {
                    let begun = [&start[..], &[f64::from(engine)]].concat();
                    ask(name, answer, 0, &begun, None)?;
                    for before in [0.0, 40.0] {
                        let state: [f64; 9] = row.take(1);
                        let asked = [&begun[..], &[step, before, 40.0], &state].concat();
                        ask(name, answer, 1, &asked, None)?;
                    }
                }
            }
        }
    }
    Ok(())
}

/// The exact motion, for the widgets that set something beside it.
fn exact(ask: &mut Ask<'_>) -> io::Result<()> {
    let (name, answer) = ("tumble", widget_tumble::answer);
    for moments in MOMENTS {
        for spin in SPINS {
            let start = [moments, spin].concat();
            for time in [0.0, 0.7, 20.0, -1e4, 1e12, f64::INFINITY] {
                ask(name, answer, 4, &[&start[..], &[time]].concat(), None)?;
                ask(name, answer, 5, &[&start[..], &[time, 20.0]].concat(), None)?;
            }
            ask(name, answer, 8, &start, None)?;
        }
    }
    Ok(())
}

/// What each method says of itself, and what it makes of some starts at steps short and long.
fn methods(ask: &mut Ask<'_>) -> io::Result<()> {
    let name = "steps";
    let answer = widget_steps::answer;
    for method in 0..27 {
        ask(name, answer, 0, &[f64::from(method)], None)?;
        for moments in MOMENTS {
            for spin in SPINS {
                for count in [1.0, 6.0, 25.0, 200.0] {
                    let run = [10.0, count, f64::from(method), 0.6, 0.0, -0.8, 0.0];
                    ask(name, answer, 1, &[&moments[..], &spin, &run].concat(), None)?;
                    let on = [0.6, 0.0, -0.8, 0.0, spin[0], spin[1], spin[2], f64::from(method), 0.01, count];
                    ask(name, answer, 2, &[&moments[..], &on].concat(), None)?;
                }
            }
        }
    }
    Ok(())
}

/// The top from starts of every kind, near and odd, by the closed form and by steps.
fn top(row: &Numbers, ask: &mut Ask<'_>) -> io::Result<()> {
    let (name, answer) = ("top", widget_top::answer as fn(u32, &Numbers) -> usize);
    let why = || Some((|| widget_top::WHY.said()) as fn() -> String);
    for spin in [0.0, 40.0, 113.2, 200.0, 400.0, -150.0, f64::NAN, 1e300] {
        for lean in [0.0, 1.0, 30.0, 90.0, 150.0, 1e-80] {
            for round in [0.0, 3.0, -12.5, f64::NAN, f64::INFINITY] {
                let start = [spin, lean, round];
                ask(name, answer, 0, &start, why())?;
                ask(name, answer, 1, &[&start[..], &[0.0, 3.0, 40.0]].concat(), why())?;
                ask(name, answer, 1, &[&start[..], &[1e6, 1e6, 1.0]].concat(), why())?;
                ask(name, answer, 2, &start, why())?;
                let state: [f64; 7] = row.take(0);
                for (drag, step) in [(0.0, 1e-3), (1.0, 1e-3), (0.0, 0.02), (1.0, 0.5)] {
                    ask(name, answer, 3, &[&[drag, step, 3.0, 40.0][..], &state].concat(), why())?;
                }
            }
        }
    }
    Ok(())
}

/// A record as a file, judged by what it says and by other moments.
fn record(out: &mut impl io::Write, file: &Path) -> io::Result<()> {
    let bytes = std::fs::read(file)?;
    let row = Numbers::empty();
    let questions: [&[f64]; 3] = [
        &[0.0, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        &[1.0, 1.0, 2.0, 2.5, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        &[1.0, 1.0, 2.0, 3.5, 1e-9, 1e-3, 0.0, f64::NAN, -1.0, 0.0, 2.0, 0.5],
    ];
    for asked in questions {
        row.fill(asked);
        let count = widget_judge::judged(bytes.as_slice(), &row);
        let (said, file) = (widget_judge::VERDICT.said(), file.display().to_string());
        let asked = bits(asked);
        let line =
            json!({"module": "judge", "what": 0, "file": file, "asked": asked, "count": count, "said": said});
        writeln!(out, "{line}")?;
    }
    Ok(())
}

/// Numbers by their bits; all NaN are one.
fn bits(numbers: &[f64]) -> Vec<String> {
    let word = |x: &f64| if x.is_nan() { "nan".into() } else { format!("{:016x}", x.to_bits()) };
    numbers.iter().map(word).collect()
}
