use super::polhode::Ellipsoid;
use super::{Drawing, Picture, ink_of};
use crate::draw::{Canvas, Fill, Label, Pen, View};
use crate::ink::Ink;
use nalgebra::Vector3;
use tumbling::Axis;

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];

pub(super) fn draw() -> Drawing {
    let ellipsoid = Ellipsoid::new(MOMENTS)?;
    let canvas = Canvas::new(520);
    let view = View::new((352.0, 262.0), 262.0, 58.0, 27.0);
    paths(&canvas, &ellipsoid, &view, &[0.22, 0.44, 0.66, 0.86])?;
    let [min, mid, max] = [Axis::Smallest, Axis::Middle, Axis::Largest].map(|axis| {
        let mut end = Vector3::zeros();
        end[axis.index()] = ellipsoid.reach[axis.index()];
        let tip = view.at(&(end * (1.0 + 0.3 / end.norm())));
        canvas.disc(view.at(&end), 4.0, Fill::new(ink_of(axis)), None);
        canvas.arrow(view.at(&end), tip, Pen::new(ink_of(axis), 2.6));
        tip
    });
    let two = |at: (f64, f64), axis: Axis, name: &str, fate: &str, end: bool| {
        let ink = ink_of(axis);
        for (line, text) in [(0.0, name), (22.0, fate)] {
            let label = Label::new(text).ink(ink);
            canvas.label((at.0, at.1 + line), &if end { label.end() } else { label });
        }
    };
    let k = |i: usize| format!("{}", MOMENTS[i]);
    two((max.0 + 16.0, max.1 + 6.0), Axis::Largest, &format!("largest moment, $I_3$ = {}", k(2)), "stable: small loops", false);
    two((20.0, min.1 + 46.0), Axis::Smallest, "smallest", &format!("moment, $I_1$ = {}", k(0)), false);
    canvas.label((20.0, min.1 + 90.0), &Label::new("stable:").ink(ink_of(Axis::Smallest)));
    canvas.label((20.0, min.1 + 112.0), &Label::new("small loops").ink(ink_of(Axis::Smallest)));
    two((mid.0 + 8.0, mid.1 + 34.0), Axis::Middle, &format!("middle moment, $I_2$ = {}", k(1)), "unstable: a crossing", false);
    let ellipse = ellipsoid.separatrix(-1.0);
    let point = view.at(&ellipse[300]);
    let words = (20.0, 100.0);
    canvas.line((words.0 + 60.0, words.1 + 10.0), (point.0 - 4.0, point.1 - 4.0), Pen::new(Ink::Separatrix, 1.0));
    canvas.label(words, &Label::new("separatrix").ink(Ink::Separatrix));
    let [a, b, c] = [0, 1, 2].map(|i| ellipsoid.reach[i]);
    Ok(Picture {
        canvas,
        description: format!(
            "The ellipsoid of all spins with the same energy, for moments 1, 2 and 3; its half axes are {a:.3}, {b:.3} and \
             {c:.3}. The paths of the spin on it, as a body turned by the library draws them, are closed loops round the \
             ends of the axes with the smallest and the largest moment. Two ellipses, the separatrix, part the loops and cross \
             at the ends of the middle axis: a spin that starts near a crossing runs away along them to the opposite one."
        ),
    })
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
