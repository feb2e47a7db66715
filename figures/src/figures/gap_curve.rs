use super::{Drawing, Picture, document_box};
use crate::draw::{Canvas, Label, Pen, Plot, Scale};
use crate::ink::Ink;
use nalgebra::Vector3;
use tumbling::{Axis, Error, Inertia};

struct Curve {
    name: &'static str,
    inertia: Inertia,
    /// From the lighter axis to the heavier one.
    plane: [Vector3<f64>; 2],
    pen: Pen,
}

impl Curve {
    fn gap(&self, degrees: f64) -> Result<f64, Error> {
        let (s, c) = degrees.to_radians().sin_cos();
        Ok(self.inertia.gap(&(self.plane[0] * c + self.plane[1] * s))?.to_degrees())
    }

    fn moments(&self) -> Result<[f64; 2], Error> {
        Ok([self.inertia.about_axis(&self.plane[0])?, self.inertia.about_axis(&self.plane[1])?])
    }

    /// The direction of the widest gap and the gap, degrees, by golden sections.
    fn widest(&self) -> Result<(f64, f64), Error> {
        let (mut a, mut b) = (0.0, 90.0);
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        for _ in 0..50 {
            let (p, q) = (b - golden * (b - a), a + golden * (b - a));
            if self.gap(p)? < self.gap(q)? { a = p } else { b = q }
        }
        let at = 0.5 * (a + b);
        Ok((at, self.gap(at)?))
    }
}

/// From the axis with the smallest moment to that with the largest.
fn across(name: &'static str, inertia: Inertia, pen: Pen) -> Curve {
    let axes = inertia.principal();
    Curve { name, inertia, plane: [axes.axis(Axis::Smallest), axes.axis(Axis::Largest)], pen }
}

pub(super) fn draw() -> Drawing {
    let pen = Pen::new(Ink::Text, 2.0);
    let plate = Inertia::from_moments(1.0 / 12.0, 4.0 / 12.0, 5.0 / 12.0)?;
    let curves = [
        across("sphere", Inertia::from_moments(0.4, 0.4, 0.4)?, pen),
        Curve { name: "box, x to y", inertia: document_box()?, plane: [Vector3::x(), Vector3::y()], pen },
        Curve { name: "plate 2 × 1", inertia: plate, plane: [Vector3::x(), Vector3::y()], pen },
    ];
    let canvas = Canvas::new(450);
    let plot = Plot::new(&canvas, 62.0, 50.0, 655.0, 385.0, Scale::linear(0.0..90.0), Scale::linear(0.0..90.0));
    let ticks = |step: i32| (0..=90 / step).map(move |i| (f64::from(step * i), format!("{}°", step * i)));
    plot.x_axis(ticks(15), "spin direction, from the lighter axis (0°) to the heavier one (90°)");
    plot.y_axis(ticks(15), "gap between $!ω$ and $!L$");
    let mut said = Vec::new();
    for curve in &curves {
        let points: Result<Vec<_>, Error> =
            (0..=360).map(|i| f64::from(i) / 4.0).map(|d| Ok((d, curve.gap(d)?))).collect();
        plot.curve(points?, curve.pen)?;
        let [light, heavy] = curve.moments()?;
        if light == heavy {
            said.push(format!("{}: zero everywhere", curve.name));
            let at = plot.at(60.0, 0.0);
            canvas.label((at.0, at.1 - 8.0), &Label::new(format!("{}: 0° everywhere", curve.name)));
            continue;
        }
        let (at, gap) = curve.widest()?;
        plot.dots([(at, gap)], 4.0, Ink::Text)?;
        let p = plot.at(at, gap);
        canvas.label((p.0 + 8.0, p.1 - 10.0), &Label::new(format!("{} {gap:.1}°", curve.name)));
        said.push(format!("{} (moments 1 : {:.2}): at most {gap:.1}°, at {at:.1}°", curve.name, heavy / light));
    }
    Ok(Picture { canvas, description: format!("The gap between spin and momentum, against the direction of the spin. {}.", said.join("; ")) })
}
