//! The closed form of the worked body: its complement, its angle, its zeros, its two numbers.

use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, Plot, View};
use crate::picture::power_of_ten;
use nalgebra::{Complex, UnitQuaternion, Vector3};
use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use tumbling::exact::{FreeMotion, Polhode};

/// The worked body's moments, kg m²: along the middle, the circled and the across axis.
const MOMENTS: Vector3<f64> = Vector3::new(10.0, 13.0, 5.0);

/// The complement of the modulus. Of the two other axes, only the circled one always has some spin.
fn complement(spin: &Vector3<f64>) -> Result<f64, tumbling::Error> {
    let turning = Polhode::new(MOMENTS.try_into()?, spin)?;
    Ok(turning.least.component_div(&turning.greatest).max())
}

/// The position of the theta zero of a spin, relative to `K'`: (C19), and (C8) by the integral for both.
fn depth(spin: &Vector3<f64>) -> Result<f64, tumbling::Error> {
    let duplicated = |of: [f64; 3], _| {
        let [x, y, z] = of.map(f64::sqrt);
        of.map(|a| 0.25 * (a + x * y + y * z + z * x))
    };
    let rf = |of: [f64; 3]| (0..30).fold(of, duplicated)[0].sqrt().recip();
    let ([m, c, x], modulus) = (MOMENTS.into(), 1.0 - complement(spin)?.powi(2));
    let [beta, gamma] = [x * (c - m), c * (m - x)].map(|part: f64| part / (m * (c - x)));
    Ok(beta.sqrt() * rf([gamma, gamma + modulus * beta, 1.0]) / rf([0.0, modulus, 1.0]))
}

/// Its motion, and the rotation of its momentum to a direction.
fn worked(to: &Vector3<f64>) -> Result<(FreeMotion, UnitQuaternion<f64>), Box<dyn Error>> {
    let upright = UnitQuaternion::rotation_between(&MOMENTS, to).ok_or("a momentum turned round")?;
    Ok((FreeMotion::new(MOMENTS.try_into()?, &Vector3::repeat(1.0))?, upright))
}

pub(super) fn complements() -> Drawing {
    let canvas = Canvas::sized(500, 500);
    let plot = Plot::new(&canvas, [62.0, 62.0, 486.0, 436.0], -16.0..0.0, -16.0..0.0);
    // The slips with a complement of this power of ten: it is proportional to both, where they are small.
    let slips = |level: f64, ratio: f64| {
        let spin = Vector3::new(1.0, 1e-30 * 10_f64.powf(ratio), 1e-30);
        let slip = level - 30.0 - complement(&spin).unwrap_or(f64::NAN).log10();
        (slip + ratio, slip)
    };
    let rounded = 0.5 * (0.5 * f64::EPSILON).log10();
    let ((left, bottom), (x, y)) = (plot.at(-16.0, -16.0), (slips(rounded, 20.0).0, slips(rounded, -20.0).1));
    let (right, top) = plot.at(x, y);
    canvas.tiles(&[[left, top, right, bottom]], Fill::new(Ink::Surface), Some(Pen::new(Ink::Wrong, 2.6)));
    let ticks = || (-4..=0).map(|n| (4.0 * f64::from(n), power_of_ten(4 * n)));
    plot.x_axis(ticks(), "slip toward the axis of the largest moment");
    plot.y_axis(ticks().skip(1), "slip toward the axis of the smallest moment");
    for (level, x, y) in [(-3, -15.7, -2.7), (-7, -15.7, -6.7), (-11, -15.7, -10.7), (-15, -14.9, -15.6)] {
        let line = (-320..=320).map(|i| slips(level.into(), 0.05 * f64::from(i)));
        let line = line.filter(|p| p.0.min(p.1) >= -16.0);
        plot.curve(line, Pen::new(Ink::Text, 1.8))?;
        let label = Label::new(format!("$k$′ = {}", power_of_ten(level))).size(15.5).halo(Ink::Paper);
        canvas.label(plot.at(x, y), &label);
    }
    // (C2): there I (I - I_M) w² is equal for both.
    let [m, c, x] = MOMENTS.into();
    let apart = 0.5 * f64::log10(x * (m - x) / (c * (c - m)));
    canvas.line(plot.at(-16.0 + apart, -16.0), plot.at(apart, 0.0), Pen::new(Ink::Separatrix, 3.4));
    canvas.label(plot.at(-4.8, -4.3), &Label::new("separatrix: $k$′ = 0").ink(Ink::Separatrix).end());
    canvas.label(plot.at(-15.5, -9.2), &Label::new("$k$ rounds to 1").ink(Ink::Wrong));
    canvas.described(
        "Starts of the worked body next to its middle axis, by the spin's slips toward the two other axes, from 1e-16 to 1. Lines of equal \
         complement k′, 1e-3 to 1e-15, turn along the separatrix, evenly apart. Below about 1e-8 the modulus k rounds to 1.",
    )
}

pub(super) fn psi() -> Drawing {
    let ((motion, room), up) = (worked(&Vector3::z())?, Vector3::z());
    let (canvas, view) = (Canvas::sized(500, 400), View::new((220.0, 268.0), 165.0, 20.0, 24.0));
    // The middle and the circled axis in the world; the first also after the rotation that makes the other
    // upright.
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
    canvas.label(plot.at(1.06, 0.1), &Label::new("the motion"));
    let deep = depth(&Vector3::repeat(1.0))?;
    let zeros = [(deep - 2.0, "$a$ is zero"), (deep, "$b$ is zero")];
    let mirrored = [(2.0 - deep, "mirror of $a$"), (-deep, "mirror of $b$")];
    for (y, name) in zeros.into_iter().chain(mirrored).chain([(1.0, "pole of dn"), (-1.0, "pole of dn")]) {
        let fill = Fill::new(if name.ends_with("zero") { Ink::Text } else { Ink::Paper });
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
         lower edge, b one {deep:.3} K′ above the axis; their mirror images are on the other side. Two poles of dn are K′ off."
    ))
}

pub(super) fn both_numbers() -> Drawing {
    let (motion, righting) = worked(&Vector3::y())?;
    let half = 0.5 * motion.period()?.ok_or("no period")?;
    let canvas = Canvas::sized(500, 580);
    let plot = Plot::new(&canvas, [44.0, 40.0, 466.0, 150.0], 0.0..2.0 * half, 0.0..1.0);
    plot.x_axis([0.0, half, 2.0 * half].map(|t| (t, format!("{t:.2} s"))), "");
    plot.y_axis([(0.0, "0".into()), (0.5, "½".into()), (1.0, "1".into())], "squares of the lengths");
    let place = |z: &Complex<f64>| (250.0 + 165.0 * z.re, 362.0 - 165.0 * z.im);
    canvas.disc((250.0, 362.0), 165.0, Fill::new(Ink::Surface), None);
    let mut turned = [0.0; 2];
    let [solid, dashed] = [Pen::new(Ink::Text, 3.0), Pen::new(Ink::Text, 2.2).dashed()];
    for (k, pen, name, below) in [(0, solid, "$a$", 22.0), (1, dashed, "$b$", -8.0)] {
        let number = |i: i32| -> Result<Complex<f64>, tumbling::Error> {
            let q = righting * motion.attitude(half * f64::from(i) / 240.0)?;
            Ok(if k == 0 { Complex::new(q.w, q.j) } else { Complex::new(q.k, q.i) })
        };
        let values = (0..=480).map(number).collect::<Result<Vec<_>, _>>()?;
        let square = |i: usize| (half * i as f64 / 240.0, values[i].norm_sqr());
        plot.curve((0..=480).map(square), pen)?;
        let places: Vec<P> = values.iter().map(place).collect();
        canvas.path(&places[240..], pen.opacity(0.3));
        canvas.arrow_along(&places[..=240], pen);
        canvas.disc(places[0], 5.5, Fill::new(Ink::Text), None);
        for ((x, y), dy) in [(plot.at(square(86).0, square(86).1), below), (places[120], 24.0)] {
            canvas.label((x, y + dy), &Label::new(name));
        }
        turned[k] = (values[240] / values[0]).arg().to_degrees().rem_euclid(360.0);
    }
    let [a, b] = turned;
    canvas.label((380.0, 238.0), &Label::new("unit circle"));
    let words = format!("after a half period: $a$ turned by {a:.0}°, $b$ by {b:.0}°");
    canvas.label((250.0, 562.0), &Label::new(words).middle());
    canvas.described(format!(
        "The worked body's complex numbers a and b, of length one together. Above, the squares of their lengths repeat after {half:.2} s. \
         Below, a runs near the unit circle, b, dashed, inside; after a half period a has turned by {a:.1}°, b by {b:.1}°, half a turn less."
    ))
}
