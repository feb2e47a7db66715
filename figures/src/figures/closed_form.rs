//! The closed form of the worked body: what its complement says, its angle, its zeros, its two numbers.

use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, Plot, View};
use crate::picture::power_of_ten;
use nalgebra::{Complex, UnitQuaternion, Vector3};
use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use tumbling::exact::{FreeMotion, Polhode};

/// The worked body's moments, kg m²: along the middle, the circled and the across axis.
const MOMENTS: Vector3<f64> = Vector3::new(10.0, 13.0, 5.0);

/// Where its theta zero lies, in parts of `K'`: (C8) and (C19), as the chapter computes both.
const DEPTH: f64 = 0.4514 / 1.6817;

/// Its motion, and the turn that takes its momentum to a direction.
fn worked(to: &Vector3<f64>) -> Result<(FreeMotion, UnitQuaternion<f64>), Box<dyn Error>> {
    let upright = UnitQuaternion::rotation_between(&MOMENTS, to).ok_or("a momentum turned round")?;
    Ok((FreeMotion::new(MOMENTS.try_into()?, &Vector3::repeat(1.0))?, upright))
}

pub(super) fn complements() -> Drawing {
    let (body, canvas) = (MOMENTS.try_into()?, Canvas::sized(500, 500));
    let plot = Plot::new(&canvas, [62.0, 62.0, 486.0, 436.0], -16.0..0.0, -16.0..0.0);
    // The slips with a complement of this power of ten: it is proportional to both, where they are small.
    let slips = |level: f64, ratio: f64| {
        let spin = Vector3::new(1.0, 1e-30 * 10_f64.powf(ratio), 1e-30);
        // Of the two only the circled axis always has some spin.
        let complement =
            Polhode::new(body, &spin).map_or(f64::NAN, |it| it.least.component_div(&it.greatest).max());
        (level - 30.0 - complement.log10() + ratio, level - 30.0 - complement.log10())
    };
    let rounded = 0.5 * (0.5 * f64::EPSILON).log10();
    let ((left, bottom), (x, y)) = (plot.at(-16.0, -16.0), (slips(rounded, 20.0).0, slips(rounded, -20.0).1));
    let (right, top) = plot.at(x, y);
    canvas.tiles(&[[left, top, right, bottom]], Fill::new(Ink::Surface), Some(Pen::new(Ink::Wrong, 2.6)));
    let ticks = || (-4..=0).map(|n| (4.0 * f64::from(n), power_of_ten(4 * n)));
    plot.x_axis(ticks(), "slip toward the axis of the largest moment");
    plot.y_axis(ticks().skip(1), "slip toward that of the smallest");
    for level in [-3, -7, -11, -15] {
        let line = (-320..=320).map(|i| slips(level.into(), 0.05 * f64::from(i)));
        let line = line.filter(|p| p.0.min(p.1) >= -16.0);
        plot.curve(line, Pen::new(Ink::Text, 1.8))?;
        let label = Label::new(format!("$k$′ = {}", power_of_ten(level))).size(15.5).halo(Ink::Paper);
        canvas.label(plot.at(f64::from(level) + 0.1, -15.6), &label);
    }
    // (C2): there I (I - I_M) w² is equal for both.
    let apart = 0.5 * (25.0_f64 / 39.0).log10();
    canvas.line(plot.at(-16.0 + apart, -16.0), plot.at(apart, 0.0), Pen::new(Ink::Separatrix, 3.4));
    canvas.label(plot.at(-4.8, -4.3), &Label::new("separatrix: $k$′ = 0").ink(Ink::Separatrix).end());
    canvas.label(plot.at(-15.5, -9.2), &Label::new("$k$ rounds to 1").ink(Ink::Wrong));
    canvas.described(
        "Starts of the worked body next to its middle axis, by the spin's slips toward the two other axes, from 1e-16 to 1. Lines of equal \
         complement k′, 1e-3 to 1e-15, have corners at the separatrix, evenly apart. Below about 1e-8 the modulus k rounds to 1.",
    )
}

pub(super) fn psi() -> Drawing {
    let ((motion, room), up) = (worked(&Vector3::z())?, Vector3::z());
    let (canvas, view) = (Canvas::sized(500, 400), View::new((220.0, 268.0), 165.0, 20.0, 24.0));
    // The middle and the circled axis in the room; the first also after the turn that rights the other.
    let stands = |t: f64| -> Result<[Vector3<f64>; 3], Box<dyn Error>> {
        let turn = room * motion.attitude(t)?;
        let (middle, circled) = (turn * Vector3::x(), turn * Vector3::y());
        let righting = UnitQuaternion::rotation_between(&circled, &up).ok_or("a body upside down")?;
        Ok([middle, circled, righting * middle])
    };
    let ([.., from], [middle, circled, to]) = (stands(0.0)?, stands(1.0)?);
    let (psi, lean, spin) = (from.angle(&to), circled.angle(&up), motion.omega(1.0)?.y);
    // (C20)
    let rate = (2.0 * motion.energy() + MOMENTS.norm() * spin) / (MOMENTS.norm() + MOMENTS.y * spin);
    canvas.area(&view.ring(FRAC_PI_2, 1.0), Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.2)));
    let arrow = |by: Vector3<f64>, from: Vector3<f64>, to: Vector3<f64>, pen: Pen| {
        let turn = |i: i32| UnitQuaternion::from_scaled_axis(by * (0.025 * f64::from(i)));
        let along = |i: i32| view.at(&(turn(i) * (from + (to - from) * (0.025 * f64::from(i)))));
        canvas.arrow_along(&(0..=40).map(along).collect::<Vec<P>>(), pen);
    };
    let (hinge, none) = (circled.cross(&up).normalize() * lean, Vector3::zeros());
    arrow(up * psi, from * 0.6, from * 0.6, Pen::new(Ink::Text, 2.8));
    arrow(none, none, from, Pen::new(Ink::AxisMid, 1.6).dash_dotted());
    arrow(none, none, to, Pen::new(Ink::AxisMid, 2.2).dashed());
    arrow(none, none, up * 1.45, Pen::new(Ink::Momentum, 3.3));
    for (axis, ink) in [(middle, Ink::AxisMid), (circled, Ink::AxisMax)] {
        arrow(none, none, axis, Pen::new(ink, 3.3));
        arrow(hinge, axis, axis, Pen::new(ink, 1.8).dotted());
    }
    let [psi, lean] = [psi, lean].map(f64::to_degrees);
    let words = format!("$ψ$ = {psi:.0}°, and grows by {rate:.2} rad/s");
    for (v, dx, dy, text, ink) in [
        (up * 1.45, 12.0, 12.0, "momentum $!L$", Ink::Momentum),
        (up * 1.45, 12.0, 36.0, "dotted: the righting turn", Ink::Text),
        (circled, -20.0, 0.0, "$C$", Ink::AxisMax),
        (middle, 9.0, 2.0, "$M$", Ink::AxisMid),
        (to, 8.0, 14.0, "$M$, righted", Ink::AxisMid),
        (from, -76.0, 46.0, "$M$, righted, at the start", Ink::AxisMid),
        ((from + to) * 0.3, -6.0, 4.0, "$ψ$", Ink::Text),
        (none, -110.0, 118.0, words.as_str(), Ink::Text),
    ] {
        let (x, y) = view.at(&v);
        canvas.label((x + dx, y + dy), &Label::new(text).ink(ink));
    }
    canvas.described(format!(
        "The worked body 1 s after the start; its momentum, an orange arrow, is upright, its circled axis C leans by {lean:.0}°. The turn that \
         rights this axis, dotted, takes the middle axis M into the level disk. There it has turned by ψ, {psi:.0}°, since the start."
    ))
}

pub(super) fn zeros() -> Drawing {
    let canvas = Canvas::sized(500, 560);
    let plot = Plot::new(&canvas, [52.0, 40.0, 486.0, 500.0], -1.2..3.0, -2.4..2.4);
    let ((left, top), (right, bottom)) = (plot.at(-1.0, 2.0), plot.at(1.0, -2.0));
    canvas.tiles(&[[left, top, right, bottom]], Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.2)));
    let tick = |(x, name): (f64, &str)| (x, name.to_owned());
    plot.x_axis([(-1.0, "−$K$"), (0.0, "0"), (1.0, "$K$"), (2.0, "2$K$")].map(tick), "real part of $u$");
    plot.y_axis([(-2.0, "−2$K$′"), (0.0, "0"), (2.0, "2$K$′")].map(tick), "imaginary part of $u$");
    canvas.arrow(plot.at(-1.2, 0.0), plot.at(3.0, 0.0), Pen::new(Ink::Text, 3.4));
    canvas.label(plot.at(2.06, 0.1), &Label::new("the motion"));
    let marks = [(DEPTH - 2.0, "$a$ is zero"), (DEPTH, "$b$ is zero"), (1.0, "pole of dn")];
    let mirrored = marks.map(|(y, name)| (-y, if y < 1.0 { "mirror image" } else { name }));
    for (y, name) in marks.into_iter().chain(mirrored) {
        let fill = Fill::new(if name.contains('$') { Ink::Text } else { Ink::Paper });
        for at in [0.0, 2.0].map(|x| plot.at(x, y)) {
            if y.abs() == 1.0 {
                canvas.crosses([at], 6.0, Pen::new(Ink::Text, 2.4))
            } else {
                canvas.disc(at, 6.0, fill, Some(Pen::new(Ink::Text, 2.0)))
            }
        }
        let (x, y) = plot.at(0.0, y);
        canvas.label((x + 11.0, y + 6.0), &Label::new(name).size(15.5).halo(Ink::Surface));
    }
    canvas.described(format!(
        "The plane of the complex argument; the motion runs along the real axis. In each cell, 2 K wide, 4 K′ high, a has one zero near the \
         lower edge, b one {DEPTH:.3} K′ above the axis; their mirror images are on the other side. Two poles of dn are K′ off."
    ))
}

pub(super) fn both_numbers() -> Drawing {
    let (motion, righting) = worked(&Vector3::y())?;
    let period = 0.5 * motion.period()?.ok_or("no period")?;
    let canvas = Canvas::sized(500, 580);
    let plot = Plot::new(&canvas, [44.0, 40.0, 466.0, 150.0], 0.0..2.0 * period, 0.0..1.0);
    plot.x_axis([0.0, period, 2.0 * period].map(|t| (t, format!("{t:.2} s"))), "");
    plot.y_axis([(0.0, "0".into()), (0.5, "½".into()), (1.0, "1".into())], "squares of the lengths");
    let place = |z: &Complex<f64>| (250.0 + 165.0 * z.re, 362.0 - 165.0 * z.im);
    canvas.disc((250.0, 362.0), 165.0, Fill::new(Ink::Surface), None);
    let mut turned = [0.0; 2];
    let [solid, dashed] = [Pen::new(Ink::Text, 3.0), Pen::new(Ink::Text, 2.2).dashed()];
    for (k, pen, name, below) in [(0, solid, "$a$", 22.0), (1, dashed, "$b$", -8.0)] {
        let number = |i: i32| -> Result<Complex<f64>, tumbling::Error> {
            let q = righting * motion.attitude(period * f64::from(i) / 240.0)?;
            Ok(if k == 0 { Complex::new(q.w, q.j) } else { Complex::new(q.k, q.i) })
        };
        let values = (0..=480).map(number).collect::<Result<Vec<_>, _>>()?;
        let square = |i: usize| (period * i as f64 / 240.0, values[i].norm_sqr());
        plot.curve((0..=480).map(square), pen)?;
        let places: Vec<P> = values.iter().map(place).collect();
        canvas.path(&places[240..], pen.opacity(0.3));
        canvas.arrow_along(&places[..=240], pen);
        canvas.disc(places[0], 5.5, Fill::new(Ink::Text), None);
        let (x, y) = plot.at(square(86).0, square(86).1);
        canvas.label((x, y + below), &Label::new(name));
        turned[k] = (values[240] / values[0]).arg().to_degrees().rem_euclid(360.0);
    }
    let [a, b] = turned;
    let words = format!("after a period: $a$ turned by {a:.0}°, $b$ by {b:.0}°");
    canvas.label((250.0, 562.0), &Label::new(words).middle());
    canvas.described(format!(
        "The worked body's complex numbers a and b, of length one together. Above, the squares of their lengths repeat after {period:.2} s. \
         Below, a runs near the unit circle, b, dashed, inside; after a period a has turned by {a:.1}°, b by {b:.1}°, half a turn less."
    ))
}
