use super::{Drawing, ink_of};
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen};
use nalgebra::Vector3;
use tumbling::Axis;
use tumbling::solid::{Compound, Cuboid, Cylinder, Solid};

/// The hammer of the chapter's code, m: an ash handle along z, a steel head across its end, off its middle.
const HANDLE: [f64; 2] = [0.0145, 0.29];
const HEAD: [f64; 3] = [0.1, 0.032, 0.032];
const OFF: f64 = 0.03;

/// Where a point of the xz plane falls: the handle lies from left to right.
fn at(x: f64, z: f64) -> P {
    const METRE: f64 = 1150.0;
    (44.0 + METRE * z, 190.0 - METRE * x)
}

fn rectangle(x: [f64; 2], z: [f64; 2]) -> [P; 4] {
    [(x[0], z[0]), (x[1], z[0]), (x[1], z[1]), (x[0], z[1])].map(|(x, z)| at(x, z))
}

pub(super) fn draw() -> Drawing {
    let [radius, long] = HANDLE;
    let [across, _, side] = HEAD;
    let handle = Cylinder::new(radius, long)?.with_density(680.0)?;
    let head = Cuboid::new(across, side, side)?.with_density(7850.0)?;
    let hammer = Compound::new()
        .at(handle, &Vector3::new(0.0, 0.0, 0.5 * long))
        .at(head, &Vector3::new(OFF, 0.0, long + 0.5 * side))
        .properties()?;
    let (centre, axes) = (hammer.centre(), hammer.inertia().principal());

    let canvas = Canvas::sized(500, 300);
    let edge = Some(Pen::new(Ink::Text, 1.3));
    canvas.area(&rectangle([-radius, radius], [0.0, long]), Fill::new(Ink::Surface), edge);
    let (low, high) = (OFF - 0.5 * across, OFF + 0.5 * across);
    let block = rectangle([low, high], [long, long + side]);
    canvas.area(&block, Fill::new(Ink::Surface), None);
    canvas.area(&block, Fill::new(Ink::Text).opacity(0.3), edge);
    let end = |axis: Axis, reach: f64| {
        let p = centre + axes.axis(axis) * reach;
        at(p.x, p.z)
    };
    // Along the handle downwards, and across it upwards, whichever way the axes were found.
    let down = -axes.axis(Axis::Smallest).z.signum();
    let up = axes.axis(Axis::Middle).x.signum();
    let lean = (axes.axis(Axis::Smallest).x / axes.axis(Axis::Smallest).z).atan().abs().to_degrees();
    for (axis, from, to) in [(Axis::Smallest, -0.08, 0.31), (Axis::Middle, -0.075, 0.125)] {
        let sign = if axis == Axis::Smallest { down } else { up };
        canvas.line(end(axis, sign * from), end(axis, sign * to), Pen::new(ink_of(axis), 3.0).dash_dotted());
    }
    let middle = at(centre.x, centre.z);
    canvas.disc(middle, 9.0, Fill::new(Ink::Paper), Some(Pen::new(ink_of(Axis::Largest), 3.0)));
    canvas.disc(middle, 3.5, Fill::new(ink_of(Axis::Largest)), None);
    let name = |at: P, words: &str, axis: Axis| canvas.label(at, &Label::new(words).ink(ink_of(axis)));
    name((20.0, 262.0), "easiest", Axis::Smallest);
    name((end(Axis::Middle, up * 0.125).0 - 118.0, 52.0), "middle", Axis::Middle);
    name((middle.0 - 172.0, middle.1 - 26.0), "hardest:", Axis::Largest);
    name((middle.0 - 172.0, middle.1 - 4.0), "through the page", Axis::Largest);
    canvas.label((130.0, 282.0), &Label::new(format!("{lean:.1}° from the handle")).bold());
    canvas.described(format!(
        "A hammer from its side: a wooden handle {long} m long, a steel head {across} m wide across its end and {OFF} m off its \
         middle. Its centre of mass lies {:.4} m to the side of the handle's axis, outside the wood, and {:.3} m from the head. The easiest of its principal axes leans by {lean:.1}° from the \
         handle, the middle one stands across it, and the hardest goes through the page.",
        centre.x,
        long - centre.z
    ))
}
