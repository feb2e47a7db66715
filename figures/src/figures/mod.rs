//! The figures, one file each.

use crate::Figure;
use crate::draw::Canvas;
use crate::ink::Ink;
use tumbling::{Axis, Error, Inertia};

mod box_arrows;
mod box_moments;
mod cover;
mod gap_curve;
mod engines_energy;
mod engines_paths;
mod flip_strip;
mod flip_time;
mod polhode;
mod polhodes;
mod three_spins;
mod turning_tensor;
mod wobble_growth;
mod two_arrows;

/// A finished drawing, and what it shows in words, for those who do not see it.
pub(crate) struct Picture {
    pub(crate) canvas: Canvas,
    pub(crate) description: String,
}

type Drawing = Result<Picture, Box<dyn std::error::Error>>;

/// In the order of the book.
pub(crate) static ALL: [Figure; 13] = [
    Figure {
        name: "cover",
        shows: "The paths of the spin of a tumbling body, on the ellipsoid of equal energy",
        chapter: "introduction",
        draw: cover::draw,
    },
    Figure {
        name: "two-arrows",
        shows: "A flat plate spun off its axes: the angular momentum leans to the heavier axis",
        chapter: "two-arrows",
        draw: two_arrows::draw,
    },
    Figure {
        name: "gap-curve",
        shows: "The angle between spin and momentum, for every direction of the spin and several bodies",
        chapter: "two-arrows",
        draw: gap_curve::draw,
    },
    Figure {
        name: "box-moments",
        shows: "The box of the worked example, its edges and its three moments",
        chapter: "worked-example",
        draw: box_moments::draw,
    },
    Figure {
        name: "box-arrows",
        shows: "The box seen along z: spin at 45 degrees, momentum at 52.4",
        chapter: "worked-example",
        draw: box_arrows::draw,
    },
    Figure {
        name: "flip-strip",
        shows: "todo",
        chapter: "toss-a-book",
        draw: flip_strip::draw,
    },
    Figure {
        name: "turning-tensor",
        shows: "todo",
        chapter: "body-and-world",
        draw: turning_tensor::draw,
    },
    Figure {
        name: "three-spins",
        shows: "todo",
        chapter: "eulers-equations",
        draw: three_spins::draw,
    },
    Figure {
        name: "engines-energy",
        shows: "todo",
        chapter: "three-pitfalls",
        draw: engines_energy::draw,
    },
    Figure {
        name: "engines-paths",
        shows: "todo",
        chapter: "three-pitfalls",
        draw: engines_paths::draw,
    },
    Figure {
        name: "polhodes",
        shows: "todo",
        chapter: "dzhanibekov",
        draw: polhodes::draw,
    },
    Figure {
        name: "wobble-growth",
        shows: "todo",
        chapter: "dzhanibekov",
        draw: wobble_growth::draw,
    },
    Figure {
        name: "flip-time",
        shows: "todo",
        chapter: "dzhanibekov",
        draw: flip_time::draw,
    },
];

/// The document's box: edges 2, 1 and 3 m, mass 1 kg.
const BOX_EDGES: [f64; 3] = [2.0, 1.0, 3.0];

/// Its tensor.
fn document_box() -> Result<Inertia, Error> {
    let [a, b, c] = BOX_EDGES.map(|x| x * x);
    Inertia::from_moments((b + c) / 12.0, (a + c) / 12.0, (a + b) / 12.0)
}

/// The same body, its frame turned along its principal axes, smallest moment first.
fn in_principal_axes(inertia: &Inertia) -> Result<Inertia, Error> {
    let m = inertia.principal().moments();
    Inertia::from_moments(m[0], m[1], m[2])
}

/// The ink of a principal axis.
fn ink_of(axis: Axis) -> Ink {
    match axis {
        Axis::Smallest => Ink::AxisMin,
        Axis::Middle => Ink::AxisMid,
        Axis::Largest => Ink::AxisMax,
    }
}

/// A power of ten as an axis shows it.
fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0 => "1".into(),
        1 => "10".into(),
        n => format!("$10^{{{}}}$", n.to_string().replace('-', "−")),
    }
}
