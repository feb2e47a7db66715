use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, View};
use nalgebra::{UnitQuaternion, Vector3};

/// The tilt from each axis, rad: more than a little, so that it is seen.
const TILT: f64 = 0.5;

/// The rods of the chapter, tilted from each axis about which they spin, and how each mass is pulled outward:
/// as strongly as it is heavy and far from that axis.
pub(super) fn draw() -> Drawing {
    let canvas = Canvas::sized(500, 520);
    let tilt = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -TILT);
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    // Where the heavy and the light rod lie before the tilt, the axis upright.
    let spins = [
        (y, x, ["spun flat:", "drawn back"]),
        (z, x, ["about the heavy rod:", "flung out, turned aside"]),
        (x, z, ["about the light rod:", "flung over"]),
    ];
    for (row, (heavy, light, words)) in spins.into_iter().enumerate() {
        let centre: P = (152.0, 100.0 + 168.0 * row as f64);
        let view = View::new(centre, 62.0, 24.0, 16.0);
        canvas.arrow(centre, view.at(&(1.45 * z)), Pen::new(Ink::Momentum, 3.6));
        for (rod, mass) in [(light, 0.5), (heavy, 1.0)] {
            for place in [rod, -rod].map(|end| tilt * end) {
                let at = view.at(&place);
                let pulled = place + 1.8 * mass * Vector3::new(place.x, place.y, 0.0);
                canvas.line(centre, at, Pen::new(Ink::Faint, 2.0 + 4.0 * mass));
                canvas.arrow(at, view.at(&pulled), Pen::new(Ink::Text, 2.6));
                canvas.disc(at, 3.0 + 6.0 * mass, Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.6)));
            }
        }
        for (down, line) in [-8.0, 16.0].into_iter().zip(words) {
            canvas.label((304.0, centre.1 + down), &Label::new(line).size(15.5));
        }
    }
    canvas.described(
        "Two rods that cross in their middles, with a heavy pair of masses at the ends of one and a light pair at the ends of the \
         other, three times, each tilted from the axis about which it spins, an orange arrow upwards. An arrow at each mass is its \
         pull outward, at a right angle to that axis. Spun flat, the pulls draw the tilted pair back into its plane. About \
         the heavy rod they fling the heavy pair outward. About the light rod they fling the light pair over.",
    )
}
