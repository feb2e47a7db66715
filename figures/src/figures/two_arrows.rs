use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, polar};
use nalgebra::Vector3;
use tumbling::Inertia;
use tumbling::solid::{Solid, ThinPlate};

/// The plate: 2 m wide, 1 m high, 1 kg, of no thickness.
const WIDE: f64 = 2.0;
const HIGH: f64 = 1.0;

/// The spin of the large picture, from the horizontal axis.
const SHOWN: f64 = 30.0;

struct Arrows {
    omega: f64,
    momentum: f64,
    /// Length of the momentum over its greatest.
    relative: f64,
    gap: f64,
}

fn arrows(plate: &Inertia, degrees: f64) -> Result<Arrows, tumbling::Error> {
    // Exactly along the axes at the ends: the cosine of a right angle is not quite zero.
    let w = match degrees {
        90.0 => Vector3::y(),
        d => Vector3::new(d.to_radians().cos(), d.to_radians().sin(), 0.0),
    };
    let l = plate.momentum(&w);
    let most = plate.momentum(&Vector3::y()).norm();
    Ok(Arrows {
        omega: w.y.atan2(w.x),
        momentum: l.y.atan2(l.x),
        relative: l.norm() / most,
        gap: plate.angle_to_momentum(&w)?,
    })
}

fn plate_at(canvas: &Canvas, centre: P, scale: f64) {
    let (w, h) = (0.5 * WIDE * scale, 0.5 * HIGH * scale);
    let corners = [(-w, -h), (w, -h), (w, h), (-w, h)].map(|(x, y)| (centre.0 + x, centre.1 + y));
    canvas.area(&corners, Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.2)));
}

pub(super) fn draw() -> Drawing {
    let plate = ThinPlate::new(WIDE, HIGH)?.with_mass(1.0)?.inertia();
    let [light, heavy] = [Vector3::x(), Vector3::y()].map(|axis| plate.about_axis(&axis));
    let (light, heavy) = (light?, heavy?);
    let canvas = Canvas::sized(500, 500);
    let shown = arrows(&plate, SHOWN)?;
    let gap = format!("{:.1}°", shown.gap.to_degrees());
    large(&canvas, light, heavy, &shown, &gap);
    let gaps = small(&canvas, &plate)?;
    canvas.described(format!(
        "A flat plate, {WIDE:.0} m wide and {HIGH:.0} m high, 1 kg. Its moment about the horizontal axis is \
         {light:.3}, about the vertical axis {heavy:.3} kg m². The spin, a blue arrow, points {SHOWN:.0}° above the \
         horizontal axis; the momentum, an orange arrow from the same point, points {:.1}° above it: it leans to the \
         hard, vertical axis, and the gap between the arrows is {gap}. Below, seven small pictures turn the spin \
         from one axis to the other; the gap is {}. The arrows coincide only at the two ends.",
        shown.momentum.to_degrees(),
        gaps.join(", ")
    ))
}

/// The plate with one spin and its momentum.
fn large(canvas: &Canvas, light: f64, heavy: f64, shown: &Arrows, gap: &str) {
    let centre = (166.0, 214.0);
    plate_at(canvas, centre, 122.0);
    let axis = Pen::new(Ink::Faint, 1.2).dash_dotted();
    canvas.line((centre.0 - 156.0, centre.1), (centre.0 + 180.0, centre.1), axis);
    canvas.line((centre.0, centre.1 + 96.0), (centre.0, centre.1 - 196.0), axis);
    canvas.label((centre.0 + 186.0, centre.1 - 4.0), &Label::new("the easy axis"));
    canvas.label((centre.0 + 186.0, centre.1 + 18.0), &Label::new(format!("$I_1$ = {light:.3} kg m²")));
    canvas.label((centre.0 - 14.0, centre.1 - 188.0), &Label::new("the hard axis").end());
    canvas.label((centre.0 - 14.0, centre.1 - 166.0), &Label::new(format!("$I_2$ = {heavy:.3} kg m²")).end());

    let w_tip = polar(centre, 190.0, shown.omega);
    let l_tip = polar(centre, 300.0 * shown.relative, shown.momentum);
    let arc = Pen::new(Ink::Text, 1.2);
    canvas.arc(centre, 100.0, shown.omega, shown.momentum, arc);
    canvas.arc(centre, 62.0, 0.0, shown.omega, arc);
    canvas.arrow(centre, w_tip, Pen::new(Ink::Omega, 3.6));
    canvas.arrow(centre, l_tip, Pen::new(Ink::Momentum, 3.6));
    canvas.disc(centre, 4.0, Fill::new(Ink::Text), None);
    canvas.label((w_tip.0 + 8.0, w_tip.1 + 2.0), &Label::new("spin $!ω$").ink(Ink::Omega));
    canvas.label((l_tip.0 + 12.0, l_tip.1 + 8.0), &Label::new("momentum $!L$ = $I!ω$").ink(Ink::Momentum));
    let by_the_arc = polar(centre, 132.0, 0.5 * (shown.omega + shown.momentum));
    canvas.label((by_the_arc.0, by_the_arc.1 + 6.0), &Label::new(gap).bold().middle());
    let half = polar(centre, 70.0, 0.5 * shown.omega);
    canvas.label((half.0, half.1 + 6.0), &Label::new(format!("{SHOWN:.0}°")).size(15.5));
}

/// Small plates, with the spin turned from one axis to the other; returns the gap of each.
fn small(canvas: &Canvas, plate: &Inertia) -> Result<Vec<String>, tumbling::Error> {
    let directions = [0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0];
    let mut gaps = Vec::new();
    canvas.label((14.0, 350.0), &Label::new("the spin turned from one axis to the other, and the gap:"));
    for (i, &degrees) in directions.iter().enumerate() {
        let centre = (38.0 + 70.0 * i as f64, 422.0);
        plate_at(canvas, centre, 22.0);
        let a = arrows(plate, degrees)?;
        let dot_at = polar(centre, 42.0, a.omega);
        // Where they coincide both must be seen: the momentum wider and below.
        canvas.arrow(
            centre,
            polar(centre, 42.0 * a.relative.max(0.35), a.momentum),
            Pen::new(Ink::Momentum, 3.6),
        );
        canvas.arrow(centre, dot_at, Pen::new(Ink::Omega, 1.6));
        canvas.disc(centre, 2.4, Fill::new(Ink::Text), None);
        let label = Label::new(format!("{degrees:.0}°")).ink(Ink::Omega).middle();
        canvas.label((centre.0, centre.1 + 40.0), &label);
        let gap = format!("{:.1}°", a.gap.to_degrees());
        canvas.label((centre.0, centre.1 + 64.0), &Label::new(gap.clone()).middle().bold());
        gaps.push(format!("{gap} at {degrees:.0}°"));
    }
    Ok(gaps)
}
