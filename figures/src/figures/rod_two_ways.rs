use super::{Drawing, ink_of};
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, polar};
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};
use tumbling::{Axis, solid::Cylinder, solid::Solid};

/// A wooden rod: 1 m long, 2 cm thick, 0.2 kg.
const LENGTH: f64 = 1.0;
const RADIUS: f64 = 0.01;
const MASS: f64 = 0.2;

pub(super) fn draw() -> Drawing {
    let inertia = Cylinder::new(RADIUS, LENGTH)?.with_mass(MASS)?.inertia();
    let [along, across] = [inertia.about_axis(&Vector3::z())?, inertia.about_axis(&Vector3::x())?];
    let canvas = Canvas::sized(500, 330);
    let easy = (124.0, 114.0);
    let hard = (376.0, 114.0);
    // Thicker than to scale, so that it is seen to turn.
    let rod = |centre: P, angle: f64, opacity: f64| {
        let [a, b] = [0.0, PI].map(|turn| polar(centre, 84.0, angle + turn));
        let side = |p: P, s: f64| (p.0 + s * 6.0 * angle.sin(), p.1 + s * 6.0 * angle.cos());
        let outline = [side(a, 1.0), side(a, -1.0), side(b, -1.0), side(b, 1.0)];
        canvas.area(&outline, Fill::new(Ink::Paper), None);
        canvas.area(
            &outline,
            Fill::new(Ink::Surface).opacity(opacity),
            Some(Pen::new(Ink::Text, 1.3).opacity(opacity)),
        );
    };
    let axis_pen = |axis| Pen::new(ink_of(axis), 1.6).dash_dotted();
    // About its length.
    canvas.line((easy.0 - 112.0, easy.1), (easy.0 + 114.0, easy.1), axis_pen(Axis::Smallest));
    rod(easy, 0.0, 1.0);
    let ring: Vec<P> = (0..=60)
        .map(|i| {
            let (s, c) = (-0.9 + 0.80 * TAU * f64::from(i) / 60.0).sin_cos();
            (easy.0 + 98.0 + 9.0 * c, easy.1 - 24.0 * s)
        })
        .collect();
    canvas.arrow_along(&ring, Pen::new(Ink::Omega, 2.2));
    // End over end.
    for (angle, opacity) in [(1.05, 0.35), (0.7, 0.45), (0.35, 0.6)] {
        rod(hard, angle, opacity);
    }
    rod(hard, 0.0, 1.0);
    canvas.disc(hard, 4.5, Fill::new(ink_of(Axis::Largest)), None);
    for turn in [0.0, PI] {
        let sweep: Vec<P> =
            (0..=40).map(|i| polar(hard, 96.0, turn + 0.05 + 1.1 * f64::from(i) / 40.0)).collect();
        canvas.arrow_along(&sweep, Pen::new(Ink::Omega, 2.2));
    }
    let under = |x: f64, axis: Axis, lines: [String; 2]| {
        for (i, line) in [248.0, 273.0].into_iter().zip(lines) {
            canvas.label((x, i), &Label::new(line).ink(ink_of(axis)).middle());
        }
    };
    let [easy_words, hard_words] = [scientific(along), scientific(across)];
    under(easy.0, Axis::Smallest, ["about its length".into(), format!("$I$ = {easy_words} kg m²")]);
    under(hard.0, Axis::Largest, ["end over end".into(), format!("$I$ = {hard_words} kg m²")]);
    let ratio = across / along;
    canvas.label((250.0, 312.0), &Label::new(format!("{ratio:.0} times as hard")).bold().middle());
    canvas.described(format!(
        "The same rod, {LENGTH:.0} m long, {:.0} cm thick, {MASS} kg, turned in two ways. About its length its moment is {:.1e} \
         kg m², end over end {across:.4} kg m²: {ratio:.0} times as much. (Drawn thicker than it is.)",
        200.0 * RADIUS,
        along
    ))
}

/// As `1.00 × 10⁻⁵`.
fn scientific(x: f64) -> String {
    let exponent = x.log10().floor() as i32;
    format!("{:.2} × {}", x / 10_f64.powi(exponent), super::power_of_ten(exponent))
}
