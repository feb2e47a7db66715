//! The number of terms after which each of the two theta series has reached rounding.

use super::Drawing;
use crate::draw::{Canvas, Ink, Label, Pen, Plot, Scale};
use std::f64::consts::PI;

/// From which number on a term is below the rounding of one: the nome to the square of its number.
fn terms(log_nome: f64) -> f64 {
    (f64::EPSILON.ln() / log_nome).sqrt()
}

pub(super) fn draw() -> Drawing {
    let canvas = Canvas::sized(500, 340);
    let (x, y) = (Scale::log(0.05..20.0), 0.0..16.0);
    let plot = Plot::new(&canvas, [50.0, 40.0, 486.0, 276.0], x, y);
    plot.x_axis([0.1, 1.0, 10.0].map(|x| (x, x.to_string())), "K′/K");
    plot.y_axis([0, 5, 10, 15].map(|n| (f64::from(n), n.to_string())), "terms");
    let ratios = || (0..=120).map(|k| 0.05 * 400_f64.powf(f64::from(k) / 120.0));
    plot.curve(ratios().map(|x| (x, terms(-PI * x))), Pen::new(Ink::Text, 3.0))?;
    plot.curve(ratios().map(|x| (x, terms(-PI / x))), Pen::new(Ink::Separatrix, 3.0).dashed())?;
    canvas.label(plot.at(0.095, 12.5), &Label::new("direct series"));
    canvas.label(plot.at(0.9, 12.5), &Label::new("complementary series").ink(Ink::Separatrix));
    canvas.label(plot.at(0.054, 3.2), &Label::new("← separatrix"));
    canvas.label(plot.at(3.3, 3.6), &Label::new("small wobble →"));
    canvas.described(
        "Number of terms that reach rounding against the ratio of the quarter periods. Towards the separatrix, on the left, \
                      the direct series needs more and more terms and the complementary one few; for small wobbles, on the right, it is \
                      the other way round. They need equally many where the two quarter periods are equal."
    )
}
