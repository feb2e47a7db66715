//! Every body's place among all bodies: its two smaller moments relative to its largest.

use crate::draw::{Canvas, Fill, Ink, Label, Pen, Plot};
use crate::picture::Drawing;
use tumbling::body::named::NamedBody;
use tumbling::dynamics::stability::rate_squared;

/// The triangle of possible bodies, as wide as its sheet allows.
pub(crate) fn map() -> Result<(Canvas, Plot), Box<dyn std::error::Error>> {
    let canvas = Canvas::sized(500, 570);
    let plot = Plot::new(&canvas, [46.0, 78.0, 474.0, 506.0], 0.0..1.0, 0.5..1.0);
    let tenths = |range: std::ops::RangeInclusive<i32>| {
        range.map(|i| (0.1 * f64::from(i), format!("{:.1}", 0.1 * f64::from(i))))
    };
    plot.x_axis(tenths(0..=10).step_by(2), "smallest moment over the largest, $I_1/I_3$");
    plot.y_axis(tenths(5..=10), "");
    canvas.label((14.0, 30.0), &Label::new("middle moment over the largest, $I_2/I_3$"));
    let corners = [(0.0, 1.0), (0.5, 0.5), (1.0, 1.0)].map(|(x, y)| plot.at(x, y));
    canvas.area(&corners, Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 2.2)));
    Ok((canvas, plot))
}

/// Two bounding lines on each side of the triangle, and the labels in its corners.
pub(crate) fn edges(canvas: &Canvas, plot: &Plot) {
    let outside = |x: f64, y: f64, lines: [&str; 2], end: bool| {
        let p = plot.at(x, y);
        for (down, line) in [0.0, 21.0].into_iter().zip(lines) {
            let label = Label::new(line).size(15.5);
            canvas.label((p.0, p.1 + down), &if end { label.end() } else { label });
        }
    };
    outside(0.335, 0.57, ["flat: plates", "$I_1 + I_2 = I_3$"], true);
    outside(0.645, 0.57, ["round: wheels, coins", "$I_1 = I_2$"], false);
    let corner = plot.at(0.5, 0.5);
    canvas.label((corner.0 + 22.0, corner.1 - 8.0), &Label::new("disk").size(15.5));
    let ball = plot.at(1.0, 1.0);
    canvas.label((ball.0, ball.1 - 12.0), &Label::new("ball").size(15.5).end());
    let needle = plot.at(0.0, 1.0);
    canvas.label((needle.0, needle.1 - 12.0), &Label::new("needle").size(15.5));
    let top = plot.at(0.5, 1.0);
    canvas.label((top.0, top.1 - 12.0), &Label::new("round: rods, $I_2 = I_3$").size(15.5).middle());
}

/// A named body, and the position of its name relative to its point.
const NAMES: [(&str, f64, f64, bool); 8] = [
    ("the box", 9.0, 5.0, false),
    ("the book", -9.0, 12.0, true),
    ("the phone", -9.0, 10.0, true),
    ("the remote control", 9.0, 2.0, false),
    ("the hammer", 9.0, 9.0, false),
    ("the tennis racket", 9.0, 8.0, false),
    ("the wing nut", 9.0, 5.0, false),
    ("the T-handle", -9.0, 12.0, true),
];

fn points(canvas: &Canvas, plot: &Plot) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let mut said = Vec::new();
    for body in NamedBody::ALL {
        let (m, full_name) = (body.properties()?.inertia().principal().moments(), body.to_string());
        let (x, y) = (m[0] / m[2], m[1] / m[2]);
        let (_, dx, dy, end) =
            *NAMES.iter().find(|name| name.0 == full_name).ok_or("a body without a place for its name")?;
        let p = plot.at(x, y);
        canvas.disc(p, 4.5, Fill::new(Ink::Text), None);
        let name = full_name.trim_start_matches("the ").trim_start_matches("tennis ");
        let label = Label::new(name).size(16.0);
        // Names to the right of their points are inside the triangle, the others outside.
        canvas.label((p.0 + dx, p.1 + dy), &if end { label.end() } else { label.halo(Ink::Surface) });
        said.push(format!("{name} ({x:.2}, {y:.2})"));
    }
    Ok(said)
}

pub(super) fn draw() -> Drawing {
    let (canvas, plot) = map()?;
    edges(&canvas, &plot);
    let said = points(&canvas, &plot)?;
    canvas.described(format!(
        "Every rigid body is a point in a triangle: across, its smallest moment over the largest; up, its middle moment \
         over the largest. The corners are the needle (0, 1), the thin disk (0.5, 0.5) and the ball (1, 1). No body \
         lies left of the edge I1 + I2 = I3, where flat plates are. The book's bodies: {}.",
        said.join(", ")
    ))
}

/// The growth of the angle during one radian of spin, for a body at this position of the map.
fn rate(x: f64, y: f64) -> f64 {
    rate_squared(&1.0, &y, &x, &1.0).max(0.0).sqrt()
}

/// Draws lines of equal growth with labels; returns the labels.
pub(crate) fn growth_lines(canvas: &Canvas, plot: &Plot) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let mut levels = Vec::new();
    for tenth in [2, 4, 6, 8, 9] {
        let level = 0.1 * f64::from(tenth);
        // On each height the rate falls from the left edge to the right one.
        let mut line = Vec::new();
        for i in 0..=400 {
            let y = 0.5 + 0.5 * f64::from(i) / 400.0;
            let (mut left, mut right) = ((1.0 - y).max(1e-9), y);
            if rate(left, y) < level {
                continue;
            }
            for _ in 0..50 {
                let middle = 0.5 * (left + right);
                if rate(middle, y) > level { left = middle } else { right = middle }
            }
            line.push((left, y));
        }
        // The label is on the line, or outside the edge where names of bodies leave no space.
        let outside = tenth == 9;
        let named = line.iter().copied().find(|p| p.1 >= 0.725).unwrap_or_default();
        plot.curve(line, Pen::new(Ink::AxisMid, 1.8).dashed())?;
        let p = plot.at(named.0, named.1);
        let label = Label::new(format!("{level:.1}")).ink(Ink::AxisMid).size(15.5);
        let across = if outside { -8.0 } else { 6.0 };
        canvas.label((p.0 + across, p.1 + 5.0), &if outside { label.end() } else { label });
        levels.push(format!("{level:.1}"));
    }
    Ok(levels)
}

/// A sentence that explains the lines of equal growth.
pub(crate) fn growth_key(canvas: &Canvas, plot: &Plot) {
    let words = plot.at(0.72, 0.70);
    for (down, line) in [(0.0, "dashed: $λ/ω$,"), (21.0, "a slip’s growth"), (42.0, "per radian of spin")]
    {
        canvas.label((words.0, words.1 + down), &Label::new(line).ink(Ink::AxisMid).size(15.5));
    }
}

/// The growth of the angle during one radian of spin, as contour lines over the map.
pub(super) fn draw_growth() -> Drawing {
    let (canvas, plot) = map()?;
    let levels = growth_lines(&canvas, &plot)?;
    edges(&canvas, &plot);
    points(&canvas, &plot)?;
    growth_key(&canvas, &plot);
    let mut said = Vec::new();
    for body in NamedBody::ALL {
        let m = body.properties()?.inertia().principal().moments();
        said.push(format!("{body} {:.2}", rate(m[0] / m[2], m[1] / m[2])));
    }
    canvas.described(format!(
        "The triangle of all rigid bodies with lines of equal growth rate of a slip off the middle axis, relative to the spin: \
         {}. It is zero along the two edges of round bodies and largest towards the needle along the edge of flat \
         plates. The book's bodies: {}.",
        levels.join(", "),
        said.join(", ")
    ))
}
