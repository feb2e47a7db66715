//! The canvas: the drawing surface for plotters, and a few marks that plotters lacks.
//!
//! It is a backend of its own for plotters, because the SVG backend of plotters writes fixed colours and
//! these figures use the colours of the page.

use super::pen::{DEFAULT_WIDTH, FINENESS, Fill, Pen};
use super::point::{P, polar};
use super::text::{Label, SIZE, escaped};
use crate::ink::{Ink, stand_alone_style};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, DrawingBackend, DrawingErrorKind};
use std::cell::{Cell, RefCell};
use std::convert::Infallible;
use std::fmt::Write as _;
use std::rc::Rc;

/// A sheet of the given size that collects marks. Clones share one sheet.
#[derive(Debug, Clone, Default)]
pub(crate) struct Canvas {
    size: (u32, u32),
    body: Rc<RefCell<String>>,
    /// Left, top, right and bottom of all lines and areas, in the sheet's fine units.
    seen: Rc<Cell<Option<[i32; 4]>>>,
    /// Left, top, right and bottom of each label.
    written: Rc<RefCell<Vec<[f64; 4]>>>,
    /// The area of labels that overlap other labels or leave the sheet.
    pub(crate) over: Rc<Cell<f64>>,
}

/// The width of every figure, in points.
pub(crate) const WIDTH: u32 = 680;

fn fine(p: P) -> BackendCoord {
    ((p.0 * FINENESS).round() as i32, (p.1 * FINENESS).round() as i32)
}

/// The style of an area, with an outline or without.
fn look(fill: Fill, outline: Option<Pen>) -> String {
    outline.map_or(fill.css(), |pen| format!("{};{}", fill.css(), pen.css()))
}

impl Canvas {
    /// A sheet of the common width.
    pub(crate) fn new(height: u32) -> Self {
        Self::sized(WIDTH, height)
    }

    /// A sheet of another width, at which letters have their nominal size.
    pub(crate) fn sized(width: u32, height: u32) -> Self {
        Self { size: (width, height), ..Self::default() }
    }

    fn push(&self, element: &str) {
        self.body.borrow_mut().push_str(element);
    }

    fn shape(&self, points: &[BackendCoord], close: bool, style: &str) {
        if points.len() < 2 {
            return;
        }
        let around =
            |[l, t, r, b]: [i32; 4], &(x, y): &BackendCoord| [l.min(x), t.min(y), r.max(x), b.max(y)];
        let (x, y) = points[0];
        self.seen.set(Some(points.iter().fold(self.seen.get().unwrap_or([x, y, x, y]), around)));
        let close = if close { "z" } else { "" };
        self.push(&format!("<path d=\"{}{close}\" style=\"{style}\"/>\n", path_data(points)));
    }

    /// An open line through the points.
    pub(crate) fn path(&self, points: &[P], pen: Pen) {
        let points: Vec<_> = points.iter().map(|&p| fine(p)).collect();
        self.shape(&simplified(&points), false, &pen.css());
    }

    /// A line between two points.
    pub(crate) fn line(&self, from: P, to: P, pen: Pen) {
        self.path(&[from, to], pen);
    }

    /// A closed area, with an outline or without.
    pub(crate) fn area(&self, points: &[P], fill: Fill, outline: Option<Pen>) {
        let points: Vec<_> = points.iter().map(|&p| fine(p)).collect();
        self.shape(&simplified(&points), true, &look(fill, outline));
    }

    /// A filled disc, with an outline or without.
    pub(crate) fn disc(&self, centre: P, r: f64, fill: Fill, outline: Option<Pen>) {
        let (x, y) = fine(centre);
        let (r, style) = (r * FINENESS, look(fill, outline));
        self.push(&format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r:.0}\" style=\"{style}\"/>\n"));
    }

    /// Many rectangles (left, top, right, bottom) of one look in one element.
    pub(crate) fn tiles(&self, tiles: &[[f64; 4]], fill: Fill, outline: Option<Pen>) {
        let mut data = String::new();
        for &[left, top, right, bottom] in tiles {
            let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
            data.push_str(&path_data(&corners.map(fine)));
            data.push('z');
        }
        if !data.is_empty() {
            self.push(&format!("<path d=\"{data}\" style=\"{}\"/>\n", look(fill, outline)));
        }
    }

    /// Many small crosses in one element.
    pub(crate) fn crosses(&self, centres: impl IntoIterator<Item = P>, r: f64, pen: Pen) {
        let (half, mut data) = ((r * FINENESS).round(), String::new());
        for (x, y) in centres.into_iter().map(fine) {
            let (left, top) = (f64::from(x) - half, f64::from(y) - half);
            let (whole, right) = (2.0 * half, left + 2.0 * half);
            let _ = write!(data, "M{left} {top}l{whole} {whole}M{right} {top}l-{whole} {whole}");
        }
        if !data.is_empty() {
            self.push(&format!("<path d=\"{data}\" style=\"{}\"/>\n", pen.css()));
        }
    }

    /// An arc from one angle to another (radians, from the right, upwards).
    pub(crate) fn arc(&self, centre: P, r: f64, from: f64, to: f64, pen: Pen) {
        let points: Vec<P> =
            (0..=48).map(|i| polar(centre, r, from + (to - from) * f64::from(i) / 48.0)).collect();
        self.path(&points, pen);
    }

    /// A line with a head at its end; the head's point is the end.
    pub(crate) fn arrow(&self, from: P, to: P, pen: Pen) {
        self.arrow_along(&[from, to], pen);
    }

    /// A bent line with a head at its end.
    pub(crate) fn arrow_along(&self, points: &[P], pen: Pen) {
        let Some(&tip) = points.last() else { return };
        let long = 6.0 + 2.6 * pen.width();
        // The head points from where the line enters its circle; the line itself ends inside the head.
        let distance = |p: P| (p.0 - tip.0).hypot(p.1 - tip.1);
        let Some(kept) = points.iter().rposition(|&p| distance(p) > 0.8 * long) else { return };
        let d = distance(points[kept]);
        let (ux, uy) = ((tip.0 - points[kept].0) / d, (tip.1 - points[kept].1) / d);
        let mut shaft = points[..=kept].to_vec();
        shaft.push((tip.0 - 0.7 * long * ux, tip.1 - 0.7 * long * uy));
        self.path(&shaft, pen);
        let side = |s: f64| (tip.0 - long * ux - s * long * uy, tip.1 - long * uy + s * long * ux);
        let notch = (tip.0 - 0.72 * long * ux, tip.1 - 0.72 * long * uy);
        self.area(&[tip, side(0.4), notch, side(-0.4)], Fill::new(pen.ink()), None);
    }

    /// Writing, with its baseline at the point.
    pub(crate) fn label(&self, at: P, label: &Label) {
        let bounds = label.bounds(at);
        self.over.set(self.over.get() + self.overlap(&bounds));
        self.written.borrow_mut().push(bounds);
        self.push(&label.svg(at, FINENESS));
    }

    /// A label at the first of these places where it overlaps no other label and stays on the sheet; if there
    /// is none, at the place with the least overlap.
    pub(crate) fn label_at_first(&self, places: &[P], label: &Label) {
        let cost = |&at: &P| self.overlap(&label.bounds(at));
        let best = places.iter().map(|at| (cost(at), at)).reduce(|a, b| if b.0 < a.0 { b } else { a });
        if let Some((_, &at)) = best {
            self.label(at, label);
        }
    }

    /// The area of this rectangle that overlaps labels or leaves the sheet.
    fn overlap(&self, bounds: &[f64; 4]) -> f64 {
        let common = |[l, t, r, b]: [f64; 4]| {
            let (wide, high) = (bounds[2].min(r) - bounds[0].max(l), bounds[3].min(b) - bounds[1].max(t));
            if wide > 0.0 && high > 0.0 { wide * high } else { 0.0 }
        };
        let whole = (bounds[2] - bounds[0]) * (bounds[3] - bounds[1]);
        let sheet = [0.0, 0.0, f64::from(self.size.0), f64::from(self.size.1)];
        let off = whole - common(sheet);
        off.max(0.0) + self.written.borrow().iter().map(|&other| common(other)).sum::<f64>()
    }

    /// Left, top, width and height of a view that has all lines and areas between these rows of a sheet, and
    /// a margin for a number at the tip of each arrow. It is wider than high, and wide enough that letters do
    /// not become large.
    pub(crate) fn view(&self, rows: [i32; 2]) -> [i32; 4] {
        let [left, top, right, bottom] = self.seen.get().unwrap_or_default();
        let (top, bottom) = (rows[0].max(top - 260), rows[1].min(bottom + 260));
        let high = bottom - top;
        let wide = (right - left + 520).max(high * 6 / 5).max(3000);
        [(left + right - wide) / 2, top, wide, high]
    }

    /// The whole document. `name` prefixes its ids.
    pub(crate) fn finish(self, name: &str, title: &str, description: &str) -> String {
        let (w, h) = (f64::from(self.size.0) * FINENESS, f64::from(self.size.1) * FINENESS);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" viewBox=\"0 0 {w} {h}\" role=\"img\" \
             aria-labelledby=\"{name}-title {name}-desc\" fill=\"currentColor\" font-size=\"{}\" \
             style=\"font-family:var(--fig-font,system-ui,sans-serif){}\">\n\
             <title id=\"{name}-title\">{}</title>\n<desc id=\"{name}-desc\">{}</desc>\n\
             <style>{}</style>\n\
             <g fill=\"none\" stroke-width=\"{DEFAULT_WIDTH}\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n{}</g>\n</svg>\n",
            self.size.0,
            SIZE * FINENESS,
            // A narrow sheet is not stretched to the width of the page, because its letters already have
            // their final size.
            if self.size.0 < WIDTH { ";min-width:0" } else { "" },
            escaped(title),
            escaped(description),
            stand_alone_style(),
            self.body.borrow().replace("<text ", "<text fill=\"currentColor\" "),
        )
    }
}

/// Absolute start, then steps: shorter than absolute points.
fn path_data(points: &[BackendCoord]) -> String {
    let Some(&(x, y)) = points.first() else { return String::new() };
    let mut data = format!("M{x} {y}");
    for (at, step) in points.windows(2).enumerate() {
        let (dx, dy) = (step[1].0 - step[0].0, step[1].1 - step[0].1);
        let gap = |d: i32| if d < 0 { "" } else { " " };
        let _ = write!(data, "{}{dx}{}{dy}", if at == 0 { "l" } else { gap(dx) }, gap(dy));
    }
    data
}

/// Simplifies a curve to fewer points; the error is at most a tenth of a point (Ramer, Douglas, Peucker).
fn simplified(points: &[BackendCoord]) -> Vec<BackendCoord> {
    const TOLERANCE: f64 = 1.0;
    let mut keep = vec![false; points.len()];
    let mut spans = vec![(0, points.len().saturating_sub(1))];
    while let Some((a, b)) = spans.pop() {
        for end in [a, b] {
            if let Some(kept) = keep.get_mut(end) {
                *kept = true;
            }
        }
        if b <= a + 1 {
            continue;
        }
        let ((ax, ay), (bx, by)) = (points[a], points[b]);
        let (dx, dy) = (f64::from(bx - ax), f64::from(by - ay));
        let length = dx.hypot(dy);
        let off = |(x, y): BackendCoord| {
            let (px, py) = (f64::from(x - ax), f64::from(y - ay));
            if length == 0.0 { px.hypot(py) } else { (px * dy - py * dx).abs() / length }
        };
        let far =
            (a + 1..b).map(|i| (i, off(points[i]))).fold((a, 0.0), |m, x| if x.1 > m.1 { x } else { m });
        if far.1 > TOLERANCE {
            spans.push((a, far.0));
            spans.push((far.0, b));
        }
    }
    points.iter().zip(&keep).filter(|&(_, &kept)| kept).map(|(&p, _)| p).collect()
}

type Written = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Canvas {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        let fine = FINENESS as u32;
        (self.size.0 * fine, self.size.1 * fine)
    }

    fn ensure_prepared(&mut self) -> Written {
        Ok(())
    }

    fn present(&mut self) -> Written {
        Ok(())
    }

    fn draw_pixel(&mut self, at: BackendCoord, color: BackendColor) -> Written {
        let ink = Ink::from_index(usize::from(color.rgb.0));
        self.push(&format!("<path d=\"M{} {}h1v1h-1z\" style=\"{}\"/>\n", at.0, at.1, Fill::new(ink).css()));
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Written {
        let points: Vec<_> = path.into_iter().collect();
        self.shape(&simplified(&points), false, &Pen::of_backend(style).css());
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, (x, y): BackendCoord, r: u32, style: &S, _: bool) -> Written {
        let css = Fill::new(Pen::of_backend(style).ink()).css();
        self.push(&format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" style=\"{css}\"/>\n"));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_run_of_points_becomes_its_two_ends_and_a_corner_stays() {
        let straight: Vec<_> = (0..100).map(|i| (i, 2 * i)).collect();
        assert_eq!(simplified(&straight), [(0, 0), (99, 198)]);
        assert_eq!(simplified(&[(0, 0), (50, 0), (50, 50)]).len(), 3);
        assert!(simplified(&[]).is_empty());
    }
}
