//! A verdict for a notebook: its words, its table of laws, and the spin next to the exact one.

use tumbling_judge::{Point, Verdict};

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 160.0;
const COLOURS: [&str; 3] = ["#d55e00", "#009e73", "#0072b2"];

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// All of it as HTML.
pub fn page(verdict: &Verdict) -> String {
    let json = verdict.json();
    let heads = json["columns"].as_array().into_iter().flatten().filter_map(|name| name.as_str());
    let heads: String = heads.map(|name| format!("<th>{name}</th>")).collect();
    let mut html = String::from("<div>");
    for (i, section) in verdict.report().iter().enumerate() {
        html += &format!("<p><strong>{}</strong></p>", escaped(&section.title));
        if !section.table.is_empty() {
            let rows = section.table.iter().map(|row| {
                let cells: String = row.iter().map(|cell| format!("<td>{}</td>", escaped(cell))).collect();
                format!("<tr>{cells}</tr>")
            });
            html += &format!("<table><tr>{heads}</tr>{}</table>", rows.collect::<String>());
        }
        html.extend(section.lines.iter().map(|line| format!("<p>{}</p>", escaped(line))));
        if i == 0 {
            html += &picture(&verdict.curve);
        }
    }
    html + "</div>"
}

/// The spin along the body's axes, and dashed the exact one.
fn picture(curve: &[Point]) -> String {
    let (Some(first), Some(last)) = (curve.first(), curve.last()) else { return String::new() };
    let sizes = curve.iter().flat_map(|point| [point.spin.amax(), point.exact.amax()]);
    let most = sizes.filter(|size| size.is_finite()).fold(f64::MIN_POSITIVE, f64::max);
    let length = (last.time - first.time).max(f64::MIN_POSITIVE);
    let line = |axis: usize, exact: bool| {
        let places = curve.iter().filter_map(|point| {
            let y = if exact { point.exact[axis] } else { point.spin[axis] } / most;
            let x = (point.time - first.time) / length;
            y.is_finite().then(|| format!("{:.1},{:.1}", WIDTH * x, 0.5 * HEIGHT * (1.0 - y)))
        });
        let dashes = if exact { " stroke-dasharray=\"3 3\"" } else { "" };
        let places = places.collect::<Vec<_>>().join(" ");
        format!("<polyline fill=\"none\" stroke=\"{}\"{dashes} points=\"{places}\"/>", COLOURS[axis])
    };
    let lines: String = (0..3).flat_map(|axis| [line(axis, false), line(axis, true)]).collect();
    format!(
        "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" role=\"img\"><title>Spin about x (red), y (green) and z (blue), \
         dashed the exact one, over {length:.3} s, up to {most:.3} rad/s</title>{lines}</svg>"
    )
}
