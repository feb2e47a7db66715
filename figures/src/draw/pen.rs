//! How a line or an area looks.

use crate::ink::Ink;
use plotters::style::{RGBAColor, ShapeStyle};
use plotters_backend::{BackendColor, BackendStyle};
use std::fmt::Write as _;

/// The resolution of a figure: plotters has only whole pixels, so each point is ten pixels.
pub(crate) const FINENESS: f64 = 10.0;

/// A line: colour, width in points, dashes, opacity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pen {
    ink: Ink,
    width: f64,
    dash: u8,
    opacity: f64,
}

/// Dashes and gaps in tenths of a point, by number.
const DASHES: [&str; 4] = ["", "60 40", "15 35", "110 40 20 40"];

impl Pen {
    pub(crate) fn new(ink: Ink, width: f64) -> Self {
        Self { ink, width, dash: 0, opacity: 1.0 }
    }

    pub(crate) fn dashed(self) -> Self {
        Self { dash: 1, ..self }
    }

    pub(crate) fn dotted(self) -> Self {
        Self { dash: 2, ..self }
    }

    pub(crate) fn dash_dotted(self) -> Self {
        Self { dash: 3, ..self }
    }

    pub(crate) fn opacity(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    pub(crate) fn ink(self) -> Ink {
        self.ink
    }

    pub(crate) fn width(self) -> f64 {
        self.width
    }

    /// As a style attribute for a stroke.
    pub(super) fn css(self) -> String {
        let mut css = format!("stroke:{}", self.ink.css());
        let width = (self.width * FINENESS).round();
        if width != DEFAULT_WIDTH {
            let _ = write!(css, ";stroke-width:{width}");
        }
        if self.dash > 0 {
            let _ = write!(css, ";stroke-dasharray:{}", DASHES[usize::from(self.dash) % DASHES.len()]);
        }
        if self.opacity < 1.0 {
            let _ = write!(css, ";stroke-opacity:{:.2}", self.opacity);
        }
        css
    }

    /// The pen that was passed to plotters, as plotters passes it on.
    pub(super) fn of_backend<S: BackendStyle>(style: &S) -> Self {
        let BackendColor { alpha, rgb: (ink, dash, _) } = style.color();
        Self {
            ink: Ink::from_index(usize::from(ink)),
            width: f64::from(style.stroke_width()) / FINENESS,
            dash,
            opacity: alpha,
        }
    }
}

/// The width, in tenths of a point, of a stroke without a stated width.
pub(super) const DEFAULT_WIDTH: f64 = 10.0;

impl From<Pen> for ShapeStyle {
    fn from(pen: Pen) -> Self {
        // Plotters passes colours through untouched: red carries the ink, green the dashes.
        let (ink, width) = (pen.ink.index() as u8, (pen.width * FINENESS).round() as u32);
        Self { color: RGBAColor(ink, pen.dash, 0, pen.opacity), filled: false, stroke_width: width }
    }
}

/// An area: colour and opacity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fill {
    pub(crate) ink: Ink,
    pub(crate) opacity: f64,
}

impl Fill {
    pub(crate) fn new(ink: Ink) -> Self {
        Self { ink, opacity: 1.0 }
    }

    pub(crate) fn opacity(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    pub(super) fn css(self) -> String {
        let mut css = format!("fill:{}", self.ink.css());
        if self.opacity < 1.0 {
            let _ = write!(css, ";fill-opacity:{:.2}", self.opacity);
        }
        css
    }
}
