use super::Drawing;
use crate::draw::{Canvas, Ink, Label, Pen, Plot};
use nalgebra::Vector3;
use tumbling::solid::{Ball, Cylinder, Solid, ThinPlate};
use tumbling::{Axis, Error, Inertia, body::named::NamedBody};

struct Curve {
    name: &'static str,
    inertia: Inertia,
    /// From the easy axis to the hard one.
    plane: [Vector3<f64>; 2],
}

impl Curve {
    /// From the axis with the smallest moment to that with the largest.
    fn across(name: &'static str, inertia: Inertia) -> Self {
        let axes = inertia.principal();
        Self { name, inertia, plane: [axes.axis(Axis::Smallest), axes.axis(Axis::Largest)] }
    }

    fn gap(&self, degrees: f64) -> Result<f64, Error> {
        let (s, c) = degrees.to_radians().sin_cos();
        Ok(self.inertia.angle_to_momentum(&(self.plane[0] * c + self.plane[1] * s))?.to_degrees())
    }

    /// The heavier moment in parts of the lighter one.
    fn ratio(&self) -> Result<f64, Error> {
        Ok(self.inertia.about_axis(&self.plane[1])? / self.inertia.about_axis(&self.plane[0])?)
    }

    /// The direction of the widest gap and the gap, degrees: there the diagonal halves it.
    fn widest(&self) -> Result<(f64, f64), Error> {
        let at = self.ratio()?.sqrt().recip().atan().to_degrees();
        Ok((at, self.gap(at)?))
    }
}

pub(super) fn draw() -> Drawing {
    let in_plane = [Vector3::x(), Vector3::y()];
    let curves = [
        Curve::across("pencil", Cylinder::new(0.0035, 0.18)?.with_mass(0.005)?.inertia()),
        Curve::across("racket", NamedBody::TennisRacket.properties()?.inertia()),
        Curve {
            name: "plate, 2 × 1",
            inertia: ThinPlate::new(2.0, 1.0)?.with_mass(1.0)?.inertia(),
            plane: in_plane,
        },
        Curve { name: "box, x to y", inertia: NamedBody::TheBox.properties()?.inertia(), plane: in_plane },
        Curve::across("ball", Ball::new(1.0)?.with_mass(1.0)?.inertia()),
    ];
    let canvas = Canvas::sized(500, 440);
    let plot = Plot::new(&canvas, [50.0, 56.0, 484.0, 366.0], 0.0..90.0, 0.0..90.0);
    let ticks = || (0..=6).map(|i| (f64::from(15 * i), format!("{}°", 15 * i)));
    plot.x_axis(ticks(), "spin, from the easy axis (0°) to the hard one (90°)");
    plot.y_axis(ticks(), "gap between $!ω$ and $!L$");
    let mut said = Vec::new();
    for curve in &curves {
        // Finer where a slender body's curve is steep.
        let directions = (0..=300).map(|i| 90.0 * (f64::from(i) / 300.0).powi(2));
        let points: Result<Vec<_>, Error> = directions.map(|d| Ok((d, curve.gap(d)?))).collect();
        let ball = curve.ratio()? == 1.0;
        plot.curve(points?, if ball { Pen::new(Ink::Text, 3.4) } else { Pen::new(Ink::Text, 2.2) })?;
        if ball {
            let p = plot.at(45.0, 0.0);
            canvas.label((p.0, p.1 - 9.0), &Label::new("ball: 0°").middle());
            said.push(format!("{}: none in any direction", curve.name));
            continue;
        }
        let (at, gap) = curve.widest()?;
        plot.dots([(at, gap)], 4.5, Ink::Text)?;
        let p = plot.at(at, gap);
        if (20.0..80.0).contains(&gap) {
            // Under the peak, in the space between the curves.
            canvas.label((p.0 + 6.0, p.1 + 25.0), &Label::new(curve.name).middle());
            canvas.label((p.0 + 6.0, p.1 + 47.0), &Label::new(format!("{gap:.1}°")).middle());
        } else if gap > 80.0 {
            // Off the grid's line above it.
            canvas.label((p.0 + 26.0, p.1 + 10.0), &Label::new(format!("{}: {gap:.1}°", curve.name)));
        } else {
            canvas.label((p.0 + 6.0, p.1 - 12.0), &Label::new(format!("{}: {gap:.1}°", curve.name)));
        }
        said.push(format!("{} (moments 1 : {:.2}): {gap:.1}° at {at:.1}°", curve.name, curve.ratio()?));
    }
    canvas.described(format!(
        "The gap between spin and momentum against the direction of the spin, from the easy to the hard one of two \
         principal axes. It is zero at both ends and widest between them. The widest gaps: {}. The more unequal the \
         moments, the wider the gap, and the nearer to the easy axis.",
        said.join("; ")
    ))
}
