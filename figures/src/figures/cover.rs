use super::polhode::Ellipsoid;
use super::{Drawing, polhodes};
use crate::draw::{Canvas, View};

pub(super) fn draw() -> Drawing {
    let canvas = Canvas::new(430);
    let view = View::new((340.0, 215.0), 320.0, 62.0, 24.0);
    polhodes::paths(
        &canvas,
        &Ellipsoid::new([1.0, 2.0, 3.0])?,
        &view,
        &[0.12, 0.26, 0.4, 0.54, 0.68, 0.82, 0.94],
    )?;
    canvas.described(
        "An ellipsoid covered with the paths that the spin of a tumbling body can take: loops round the ends of \
                      two axes, and between them, crossing at the ends of the third, the two curves that part them; near those a body flips."
    )
}
