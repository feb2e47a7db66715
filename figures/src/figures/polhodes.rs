use super::polhode::Ellipsoid;
use super::{Drawing, ink_of};
use crate::draw::{Canvas, Fill, Ink, Label, Pen, View};
use nalgebra::Vector3;
use tumbling::Axis;

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];

pub(super) fn draw() -> Drawing {
    let ellipsoid = Ellipsoid::new(MOMENTS)?;
    let canvas = Canvas::sized(500, 470);
    let view = View::new((246.0, 240.0), 218.0, 58.0, 27.0);
    paths(&canvas, &ellipsoid, &view, &[0.22, 0.44, 0.66, 0.86])?;
    let [min, mid, max] = [Axis::Smallest, Axis::Middle, Axis::Largest].map(|axis| {
        let mut end = Vector3::zeros();
        end[axis as usize] = ellipsoid.reach[axis as usize];
        let tip = view.at(&(end * (1.0 + 0.3 / end.norm())));
        canvas.disc(view.at(&end), 4.0, Fill::new(ink_of(axis)), None);
        canvas.arrow(view.at(&end), tip, Pen::new(ink_of(axis), 2.6));
        tip
    });
    let name = |at: (f64, f64), axis: Axis, name: &str, fate: &str| {
        let moment = format!("{name} $I_{}$ = {}", axis as usize + 1, MOMENTS[axis as usize]);
        canvas.label(at, &Label::new(moment).ink(ink_of(axis)));
        canvas.label((at.0, at.1 + 22.0), &Label::new(fate).ink(ink_of(axis)));
    };
    name((max.0 + 16.0, max.1 + 8.0), Axis::Largest, "largest", "stable: loops");
    name((14.0, min.1 + 84.0), Axis::Smallest, "smallest", "stable: loops");
    name((330.0, mid.1 + 44.0), Axis::Middle, "middle", "unstable: a crossing");
    // The separatrix is named where it comes from behind the left edge.
    let ellipses = [ellipsoid.separatrix(1.0), ellipsoid.separatrix(-1.0)].concat();
    let left = ellipses.iter().map(|p| view.at(p)).min_by(|p, q| p.0.total_cmp(&q.0)).unwrap_or_default();
    canvas.label((4.0, left.1 - 22.0), &Label::new("separatrix").ink(Ink::Separatrix));
    let [a, b, c] = [0, 1, 2].map(|i| ellipsoid.reach[i]);
    canvas.described(format!(
        "The ellipsoid of all spins with the same energy, for moments 1, 2 and 3; its half axes are {a:.3}, {b:.3} and \
         {c:.3}. The paths of the spin on it, as a body turned by the library draws them, are closed loops round the \
         ends of the axes with the smallest and the largest moment. Two ellipses, the separatrix, part the loops and cross \
         at the ends of the middle axis: a spin that starts near a crossing runs away along them to the opposite one."
    ))
}

/// The surface and the paths on it.
pub(super) fn paths(
    canvas: &Canvas,
    ellipsoid: &Ellipsoid,
    view: &View,
    shares: &[f64],
) -> Result<(), Box<dyn std::error::Error>> {
    let back = |ink| Some(Pen::new(ink, 1.0).opacity(0.35));
    ellipsoid.surface(canvas, view, Pen::new(Ink::Faint, 1.2));
    for (axis, ink, head) in [(0, Ink::AxisMin, 40), (2, Ink::AxisMax, 130)] {
        for sign in [1.0, -1.0] {
            for &share in shares {
                let path = ellipsoid.polhode(axis, sign, share)?;
                ellipsoid.curve(canvas, view, &path, Pen::new(ink, 1.8), back(ink));
                if sign > 0.0 && share > 0.4 {
                    ellipsoid.head(canvas, view, &path, head, Pen::new(ink, 1.8));
                }
            }
        }
    }
    for sign in [1.0, -1.0] {
        let ellipse = ellipsoid.separatrix(sign);
        ellipsoid.curve(canvas, view, &ellipse, Pen::new(Ink::Separatrix, 3.2), back(Ink::Separatrix));
    }
    Ok(())
}
