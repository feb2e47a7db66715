use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, View};
use nalgebra::{UnitQuaternion, Vector3};

/// The tilt from each axis, rad: more than a little, so that it is seen.
const TILT: f64 = 0.5;

/// The rods of the chapter, tilted in two ways from each axis about which they spin, and how each mass is
/// pulled outward: as strongly as it is heavy and far from that axis.
pub(super) fn draw() -> Drawing {
    let canvas = Canvas::sized(500, 596);
    let tilt = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -TILT);
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let rows = ["Spun flat: both held", "About the light rod: one flung", "About the heavy rod: both flung"];
    for (row, words) in rows.into_iter().enumerate() {
        canvas.label((14.0, 24.0 + 198.0 * row as f64), &Label::new(words).bold());
    }
    // Where the heavy and the light rod lie before the tilt, the axis upright.
    #[rustfmt::skip]
    let tilts = [
        (y, x, "toward the heavy pair"), (x, y, "toward the light pair"),
        (y, z, "toward the heavy pair: held"), (x, z, "across: flung over"),
        (z, y, "toward the light pair"), (z, x, "across"),
    ];
    for (k, (heavy, light, toward)) in tilts.into_iter().enumerate() {
        let centre: P = (125.0 + 250.0 * (k % 2) as f64, 106.0 + 198.0 * (k / 2) as f64);
        let view = View::new(centre, 46.0, 24.0, 16.0);
        canvas.line(view.at(&(-1.5 * z)), view.at(&(1.5 * z)), Pen::new(Ink::Omega, 2.2).dash_dotted());
        for (rod, mass) in [(light, 0.5), (heavy, 1.0)] {
            for place in [rod, -rod].map(|end| tilt * end) {
                let at = view.at(&place);
                let pulled = place + 1.5 * mass * Vector3::new(place.x, place.y, 0.0);
                canvas.line(centre, at, Pen::new(Ink::Faint, 2.0 + 4.0 * mass));
                canvas.arrow(at, view.at(&pulled), Pen::new(Ink::Text, 2.6));
                canvas.disc(at, 3.0 + 5.0 * mass, Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.6)));
            }
        }
        canvas.label((centre.0, centre.1 + 83.0), &Label::new(toward).size(15.5).middle());
    }
    canvas.described(
        "Two rods that cross in their middles, with a heavy pair of masses at the ends of one and a light pair at the ends of the \
         other, spun about each of three axes and tilted from it in two ways. An arrow at each mass is its pull outward, at a right \
         angle to the axis, which is a dash-dotted line. Spun flat, the pulls draw the tilted pair back, the heavy as the light. About \
         the light rod they draw the rods back from a tilt toward the heavy pair, and fling the light pair over in a tilt across. About \
         the heavy rod they fling the heavy pair out, whichever way it tilts.",
    )
}
