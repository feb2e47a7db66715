//! A plot: plotters' coordinates and lines, with a light grid and labels on the curves themselves.

use super::canvas::Canvas;
use super::pen::{FINENESS, Pen};
use super::point::P;
use super::text::Label;
use crate::ink::Ink;
use plotters::coord::Shift;
use plotters::coord::combinators::{IntoLogRange, LogCoord};
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged};
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingArea;
use plotters::element::{Circle, PathElement};
use plotters::prelude::{Cartesian2d, IntoDrawingArea};
use std::ops::Range;

/// How an axis spaces its values.
pub(crate) enum Scale {
    Linear(RangedCoordf64),
    Log(LogCoord<f64>),
}

impl From<Range<f64>> for Scale {
    fn from(range: Range<f64>) -> Self {
        Self::Linear(range.into())
    }
}

impl Scale {
    /// Logarithmic: each power of ten has the same length.
    pub(crate) fn log(range: Range<f64>) -> Self {
        Self::Log(range.log_scale().into())
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        match self {
            Self::Linear(axis) => axis.map(value, limit),
            Self::Log(axis) => axis.map(value, limit),
        }
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        match self {
            Self::Linear(axis) => axis.key_points(hint),
            Self::Log(axis) => axis.key_points(hint),
        }
    }

    fn range(&self) -> Range<f64> {
        match self {
            Self::Linear(axis) => axis.range(),
            Self::Log(axis) => axis.range(),
        }
    }
}

/// A plot in a rectangle of the canvas.
pub(crate) struct Plot {
    canvas: Canvas,
    area: DrawingArea<Canvas, Cartesian2d<Scale, Scale>>,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

/// The errors of plotters.
pub(crate) type Drawn = Result<(), Box<dyn std::error::Error>>;

fn fine(x: f64) -> i32 {
    (x * FINENESS).round() as i32
}

impl Plot {
    /// In the rectangle from left and top to right and bottom.
    pub(crate) fn new(
        canvas: &Canvas,
        [left, top, right, bottom]: [f64; 4],
        x: impl Into<Scale>,
        y: impl Into<Scale>,
    ) -> Self {
        let whole: DrawingArea<Canvas, Shift> = canvas.clone().into_drawing_area();
        let place = (fine(left)..fine(right), fine(bottom)..fine(top));
        let area = whole.apply_coord_spec(Cartesian2d::new(x.into(), y.into(), place));
        Self { canvas: canvas.clone(), area, left, right, top, bottom }
    }

    /// The position of a pair of values on the canvas.
    pub(crate) fn at(&self, x: f64, y: f64) -> P {
        let (px, py) = self.area.map_coordinate(&(x, y));
        (f64::from(px) / FINENESS, f64::from(py) / FINENESS)
    }

    pub(crate) fn curve(&self, points: impl IntoIterator<Item = (f64, f64)>, pen: Pen) -> Drawn {
        let points: Vec<_> = points.into_iter().filter(|p| p.0.is_finite() && p.1.is_finite()).collect();
        Ok(self.area.draw(&PathElement::new(points, pen))?)
    }

    /// Round marks.
    pub(crate) fn dots(&self, points: impl IntoIterator<Item = (f64, f64)>, r: f64, ink: Ink) -> Drawn {
        for point in points {
            let style = plotters::style::ShapeStyle::from(Pen::new(ink, 1.0)).filled();
            self.area.draw(&Circle::new(point, fine(r), style))?;
        }
        Ok(())
    }

    /// Grid lines and numbers along the lower edge, with the name of the axis.
    pub(crate) fn x_axis(&self, ticks: impl IntoIterator<Item = (f64, String)>, title: &str) {
        let (_, y0) = (0.0, self.bottom);
        for (x, text) in ticks {
            let px = self.x_at(x);
            self.canvas.line((px, self.top), (px, y0), Pen::new(Ink::Text, 0.8).opacity(0.13));
            self.canvas.line((px, y0), (px, y0 + 5.0), Pen::new(Ink::Text, 1.0));
            if !text.is_empty() {
                self.canvas.label((px, y0 + 22.0), &Label::new(text).size(TICKS).middle());
            }
        }
        self.canvas.line((self.left, y0), (self.right, y0), Pen::new(Ink::Text, 1.0));
        if !title.is_empty() {
            self.canvas.label((0.5 * (self.left + self.right), y0 + 46.0), &Label::new(title).middle());
        }
    }

    /// Grid lines and numbers along the left edge, with the name of the axis above it, horizontal.
    pub(crate) fn y_axis(&self, ticks: impl IntoIterator<Item = (f64, String)>, title: &str) {
        for (y, text) in ticks {
            let py = self.y_at(y);
            self.canvas.line((self.left, py), (self.right, py), Pen::new(Ink::Text, 0.8).opacity(0.13));
            self.canvas.label((self.left - 8.0, py + 5.5), &Label::new(text).size(TICKS).end());
        }
        if !title.is_empty() {
            self.canvas.label((self.left - 30.0, self.top - 14.0), &Label::new(title));
        }
    }

    fn x_at(&self, x: f64) -> f64 {
        self.at(x, self.area.get_y_range().start).0
    }

    fn y_at(&self, y: f64) -> f64 {
        self.at(self.area.get_x_range().start, y).1
    }
}

/// The size of numbers along an axis.
const TICKS: f64 = 15.5;
