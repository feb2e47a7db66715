//! The figures, one file each.

use crate::picture::{Drawing, Picture, ink_of, power_of_ten, raised};
use crate::{Figure, Follows, of_body};
use tumbling::body::named;
use tumbling::{Error, Inertia};

mod a_top;
mod box_arrows;
mod box_moments;
mod coin;
mod cover;
mod engines_energy;
mod engines_fate;
mod engines_paths;
mod exact_errors;
mod flip_time;
mod flip_time_deep;
mod four_steps;
mod frame;
mod gap_curve;
mod hammer;
mod jacobi;
mod judged;
mod moments_gallery;
pub(crate) mod moments_map;
pub(crate) mod polhode;
mod polhodes;
mod rod_two_ways;
mod scale;
mod scene_costs;
mod seen_from_body;
mod series_terms;
mod three_spins;
mod three_tosses;
mod torque;
mod turning_place;
mod turning_tensor;
mod two_arrows;
mod wobble_growth;
mod work;
mod work_torque;

/// In the order of the book.
pub(crate) static ALL: [Figure; 42] = [
    Figure {
        name: "cover",
        shows: "The paths that the spin of a tumbling body can take, on the ellipsoid of equal energy",
        chapter: "about",
        draw: cover::draw,
        of_body: Ok(Follows {
            shows: "The paths that its spin can take, on the ellipsoid of equal energy",
            draw: of_body::polhodes::cover,
        }),
    },
    Figure {
        name: "three-tosses",
        shows: "Three tosses of one book, drawn after each turn",
        chapter: "toss-a-book",
        draw: three_tosses::draw,
        of_body: Ok(Follows { shows: "Three tosses, drawn after each turn", draw: of_body::tosses::draw }),
    },
    Figure {
        name: "rod-two-ways",
        shows: "One rod, two moments: about its length and end over end",
        chapter: "matrix-mass",
        draw: rod_two_ways::draw,
        of_body: Err("it is about a rod"),
    },
    Figure {
        name: "turning-place",
        shows: "A point of a turning body, and its velocity",
        chapter: "matrix-mass",
        draw: turning_place::draw,
        of_body: Err("it is about one point of a turning body, whatever the body"),
    },
    Figure {
        name: "hammer",
        shows: "A hammer made of two solids, and its principal axes",
        chapter: "principal-axes",
        draw: hammer::draw,
        of_body: Err("it is about the hammer; `box-moments` shows the principal axes of any body"),
    },
    Figure {
        name: "moments-gallery",
        shows: "The book's bodies and their three principal moments",
        chapter: "principal-axes",
        draw: moments_gallery::draw,
        of_body: Err("it compares the book’s bodies; `moments-map` shows where another stands"),
    },
    Figure {
        name: "moments-map",
        shows: "Every rigid body is a point in one triangle",
        chapter: "principal-axes",
        draw: moments_map::draw,
        of_body: Ok(Follows { shows: "Its place among all rigid bodies", draw: of_body::moments::on_map }),
    },
    Figure {
        name: "two-arrows",
        shows: "A flat plate spun off its axes: the angular momentum leans to the hard axis",
        chapter: "two-arrows",
        draw: two_arrows::draw,
        of_body: Ok(Follows {
            shows: "Spun off its axes: the angular momentum leans to the hard axis",
            draw: of_body::arrows::turned,
        }),
    },
    Figure {
        name: "gap-curve",
        shows: "The angle between spin and momentum, for every direction of the spin and several bodies",
        chapter: "two-arrows",
        draw: gap_curve::draw,
        of_body: Ok(Follows {
            shows: "The angle between spin and momentum, for every direction of the spin",
            draw: of_body::gaps::draw,
        }),
    },
    Figure {
        name: "box-moments",
        shows: "The box of the worked example, its edges and its three moments",
        chapter: "worked-example",
        draw: box_moments::draw,
        of_body: Ok(Follows {
            shows: "Its principal axes and its three moments",
            draw: of_body::moments::draw,
        }),
    },
    Figure {
        name: "box-arrows",
        shows: "The box seen along z, its spin, its momentum and the gap between them",
        chapter: "worked-example",
        draw: box_arrows::draw,
        of_body: Ok(Follows {
            shows: "Spin and momentum between two of its axes",
            draw: of_body::arrows::one,
        }),
    },
    Figure {
        name: "turning-tensor",
        shows: "The box turns, and its tensor in world axes turns with it",
        chapter: "body-and-world",
        draw: turning_tensor::draw,
        of_body: Err("it follows the numbers of the worked example"),
    },
    Figure {
        name: "torque",
        shows: "A torque about one axis turns a box at rest about another",
        chapter: "eulers-equations",
        draw: torque::draw,
        of_body: Err("it follows the numbers of the worked example"),
    },
    Figure {
        name: "seen-from-body",
        shows: "An arrow fixed in the room, seen from a turning body",
        chapter: "eulers-equations",
        draw: seen_from_body::draw,
        of_body: Err("it is about a vector that stands still, whatever the body"),
    },
    Figure {
        name: "three-spins",
        shows: "The same small push about each of the three axes: two wobble, one flips",
        chapter: "eulers-equations",
        draw: three_spins::draw,
        of_body: Ok(Follows {
            shows: "The spin in body axes, thrown about each axis in turn",
            draw: of_body::spins::three,
        }),
    },
    Figure {
        name: "engines-energy",
        shows: "Energy of a free box: the right engine, and the one with a frozen tensor",
        chapter: "three-pitfalls",
        draw: engines_energy::draw,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "engines-paths",
        shows: "Spin about the middle axis: the right engine flips, two wrong ones refuse",
        chapter: "three-pitfalls",
        draw: engines_paths::draw,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "polhodes",
        shows: "Paths of the spin on the ellipsoid of equal energy, with the separatrix",
        chapter: "dzhanibekov",
        draw: polhodes::draw,
        of_body: Ok(Follows {
            shows: "The paths of its spin on the ellipsoid of equal energy",
            draw: of_body::polhodes::draw,
        }),
    },
    Figure {
        name: "wobble-growth",
        shows: "A small wobble about the middle axis grows as theory says, until it flips",
        chapter: "dzhanibekov",
        draw: wobble_growth::draw,
        of_body: Ok(Follows { shows: "How a small push grows until it flips", draw: of_body::flips::growth }),
    },
    Figure {
        name: "flip-time",
        shows: "Time between flips against the push",
        chapter: "dzhanibekov",
        draw: flip_time::draw,
        of_body: Ok(Follows { shows: "The time between flips against the push", draw: of_body::flips::time }),
    },
    Figure {
        name: "flip-map",
        shows: "How fast a push off the middle axis grows, for every rigid body",
        chapter: "dzhanibekov",
        draw: moments_map::draw_growth,
        of_body: Ok(Follows {
            shows: "How fast a push grows, among all rigid bodies",
            draw: of_body::moments::on_growth_map,
        }),
    },
    Figure {
        name: "coin",
        shows: "A thrown plate: its axis and its spin circle its momentum",
        chapter: "coin",
        draw: coin::draw,
        of_body: Err("it is about a flat round plate"),
    },
    Figure {
        name: "jacobi",
        shows: "The components of the spin are Jacobi's three functions",
        chapter: "exact-motion",
        draw: jacobi::draw,
        of_body: Ok(Follows {
            shows: "Its spin in Jacobi’s elliptic functions",
            draw: of_body::spins::jacobi,
        }),
    },
    Figure {
        name: "flip-time-deep",
        shows: "Time between flips down to the smallest push that a computer knows",
        chapter: "exact-motion",
        draw: flip_time_deep::draw,
        of_body: Err("it is about where numbers end; `flip-time` shows any body"),
    },
    Figure {
        name: "series-terms",
        shows: "Number of terms that the two series of the closed form need",
        chapter: "closed-form",
        draw: series_terms::draw,
        of_body: Err("it is about the series, not about one body"),
    },
    Figure {
        name: "exact-errors",
        shows: "Errors of the exact motion over all bodies, relative to what a rounded input does",
        chapter: "exact-motion",
        draw: exact_errors::draw,
        of_body: Err("it is about the errors of a function, not of one body"),
    },
    Figure {
        name: "a-top",
        shows: "The axis of a top that was let go: it nods and goes round",
        chapter: "a-top",
        draw: a_top::draw,
        of_body: Err("it is about a top on its point"),
    },
    Figure {
        name: "four-steps",
        shows: "What four methods make of the energy of a tumbling box",
        chapter: "stepping-through-time",
        draw: four_steps::draw,
        of_body: Err("it compares methods on the box; `report` shows the errors for any body"),
    },
    Figure {
        name: "work-box",
        shows: "Error of the box's attitude against run time, for every method",
        chapter: "error-against-run-time",
        draw: work::draw_box,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "work-torque",
        shows: "Error of a heavy top's attitude against run time, for every method and published programs",
        chapter: "error-against-run-time",
        draw: work_torque::draw,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "work-attitude",
        shows: "Error of the attitude against run time, for twelve bodies",
        chapter: "records",
        draw: work::draw_attitude,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "work-phase",
        shows: "Error of the flips' phase against run time, for the free bodies",
        chapter: "records",
        draw: work::draw_phase,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "work-energy",
        shows: "Error of the energy against run time, for twelve bodies",
        chapter: "records",
        draw: work::draw_energy,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "work-momentum",
        shows: "Error of the momentum's length against run time, for twelve bodies",
        chapter: "records",
        draw: work::draw_momentum,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "work-direction",
        shows: "Error of the momentum's direction against run time, for twelve bodies",
        chapter: "records",
        draw: work::draw_direction,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "drift",
        shows: "Error of the energy through a million turns",
        chapter: "records",
        draw: work::draw_drift,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "scene-costs",
        shows: "What a state costs by what is asked of it",
        chapter: "only-what-you-need",
        draw: scene_costs::draw,
        of_body: Err("it shows a record of measured costs"),
    },
    Figure {
        name: "scale",
        shows: "Answers a second for a hundred to ten million bodies",
        chapter: "records",
        draw: scale::draw,
        of_body: Err("it shows a record of measured costs"),
    },
    Figure {
        name: "engines-fate",
        shows: "What the rules of physics engines make of a stable spin",
        chapter: "where-things-break",
        draw: engines_fate::draw,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "judged-grades",
        shows: "How recorded engines keep each law, story by story",
        chapter: "test-your-engine",
        draw: judged::grades,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
    Figure {
        name: "frame",
        shows: "A frame of an engine: forces, solver, positions, and what each changes",
        chapter: "put-it-into-your-engine",
        draw: frame::draw,
        of_body: Err("it shows the stages of an engine's step, for any body"),
    },
    Figure {
        name: "judged-energy",
        shows: "Energy of free bodies in recorded engines, beside the exact motion",
        chapter: "records",
        draw: judged::energies,
        of_body: Err("it shows a record of runs that were made of other bodies"),
    },
];

/// The width of a sheet whose letters are 11 px high or more on a phone, in points.
const NARROW: u32 = 500;

/// Edges of the document's box, m.
const BOX_EDGES: [f64; 3] = named::THE_BOX.sizes;

/// Its tensor.
fn document_box() -> Result<Inertia, Error> {
    Ok(named::NamedBody::TheBox.properties()?.inertia())
}

/// The same body, its frame turned along its principal axes, smallest moment first.
fn in_principal_axes(inertia: &Inertia) -> Result<Inertia, Error> {
    let m = inertia.principal().moments();
    Inertia::from_moments(m[0], m[1], m[2])
}

/// The next power of ten above a small error: what may be said of it on every machine.
fn bound(error: f64) -> f64 {
    10_f64.powf(error.log10().ceil())
}
