//! The figures, one file each.

use crate::Figure;
use crate::draw::Canvas;
use std::error::Error;

mod box_arrows;
mod box_moments;
mod gap_curve;
mod two_arrows;

/// A finished drawing, and what it shows in words, for those who do not see it.
pub(crate) struct Picture {
    pub(crate) canvas: Canvas,
    pub(crate) description: String,
}

type Drawing = Result<Picture, Box<dyn Error>>;

/// In the order of the book.
pub(crate) static ALL: [Figure; 4] = [
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
];

/// The document's box: edges 2, 1 and 3 m, mass 1 kg.
const BOX_EDGES: [f64; 3] = [2.0, 1.0, 3.0];

/// Its tensor.
fn document_box() -> Result<tumbling::Inertia, tumbling::Error> {
    let [a, b, c] = BOX_EDGES.map(|x| x * x);
    tumbling::Inertia::from_moments((b + c) / 12.0, (a + c) / 12.0, (a + b) / 12.0)
}
