//! The figures, one file each.

use crate::picture::{Drawing, ink_of, power_of_ten, raised};
use crate::{Figure, Follows, of_body};
use tumbling::body::named;
use tumbling::{Error, Inertia};

mod a_top;
mod box_arrows;
mod box_moments;
mod closed_form;
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
mod scene_costs;
mod seen_from_body;
mod series_terms;
mod three_spins;
pub(crate) mod three_tosses;
mod torque;
mod turning_place;
mod turning_tensor;
mod two_arrows;
mod two_rods;
mod wobble_growth;
mod work;
mod work_torque;

/// The figures: for each its function, its name, its chapter and what it shows; after an arrow the function
/// that draws it for another body, and what it then shows.
macro_rules! figures {
    ($($draw:path, $name:literal, $chapter:literal, $shows:literal
       $(=> $of_body:path, $of_it:literal)?;)*) => {
        &[$(Figure {
            name: $name,
            shows: $shows,
            chapter: $chapter,
            draw: $draw,
            of_body: figures!(@ $($of_body, $of_it)?),
        }),*]
    };
    (@) => { None };
    (@ $of_body:path, $shows:literal) => {
        Some(Follows { shows: $shows, draw: $of_body })
    };
}

/// In the order of the book.
pub(crate) static ALL: &[Figure] = figures! {
    cover::draw, "cover", "about", "The paths that the spin of a tumbling body can take, on the ellipsoid of equal energy"
        => of_body::polhodes::cover, "The paths that its spin can take, on the ellipsoid of equal energy";
    three_tosses::draw, "three-tosses", "toss-a-book", "Three tosses of one book, drawn after each turn"
        => of_body::tosses::draw, "Three tosses, drawn after each turn";
    rod_two_ways::draw, "rod-two-ways", "matrix-mass", "One rod, two moments: about its length and end over end";
    turning_place::draw, "turning-place", "matrix-mass", "A point of a turning body, and its velocity";
    hammer::draw, "hammer", "principal-axes", "A hammer made of two solids, and its principal axes";
    moments_gallery::draw, "moments-gallery", "principal-axes", "The book's bodies and their three principal moments";
    moments_map::draw, "moments-map", "principal-axes", "Every rigid body is a point in one triangle"
        => of_body::moments::place::<false>, "Its place among all rigid bodies";
    two_arrows::draw, "two-arrows", "two-arrows", "A flat plate spun off its axes: the angular momentum leans to the hard axis"
        => of_body::arrows::turned, "Spun off its axes: the angular momentum leans to the hard axis";
    gap_curve::draw, "gap-curve", "two-arrows", "The angle between spin and momentum, for every direction of the spin and several bodies"
        => of_body::gaps::draw, "The angle between spin and momentum, for every direction of the spin";
    box_moments::draw, "box-moments", "worked-example", "The box of the worked example, its edges and its three moments"
        => of_body::moments::draw, "Its principal axes and its three moments";
    box_arrows::draw, "box-arrows", "worked-example", "The box seen along z, its spin, its momentum and the gap between them"
        => of_body::arrows::one, "Spin and momentum between two of its axes";
    turning_tensor::draw, "turning-tensor", "body-and-world", "The box turns, and its tensor in world axes turns with it";
    torque::draw, "torque", "eulers-equations", "A torque about one axis turns a box at rest about another";
    seen_from_body::draw, "seen-from-body", "eulers-equations", "An arrow fixed in the room, seen from a turning body";
    three_spins::draw, "three-spins", "eulers-equations", "The same small slip about each of the three axes: two wobble, one flips"
        => of_body::spins::three, "The spin in body axes, thrown about each axis in turn";
    two_rods::draw, "two-rods", "why-the-middle-one", "Two crossed rods, spun about each axis and tilted from it in two ways, and how their masses are pulled outward";
    engines_energy::draw, "engines-energy", "three-pitfalls", "Energy of a free box: the right engine, and the one with a frozen tensor";
    engines_paths::draw, "engines-paths", "three-pitfalls", "Spin about the middle axis: the right engine flips, two wrong ones refuse";
    polhodes::draw, "polhodes", "dzhanibekov", "Paths of the spin on the ellipsoid of equal energy, with the separatrix"
        => of_body::polhodes::draw, "The paths of its spin on the ellipsoid of equal energy";
    wobble_growth::draw, "wobble-growth", "dzhanibekov", "A small wobble about the middle axis grows as theory says, until it flips"
        => of_body::flips::growth, "How a small slip grows until it flips";
    flip_time::draw, "flip-time", "dzhanibekov", "Time between flips against the slip"
        => of_body::flips::time, "The time between flips against the slip";
    moments_map::draw_growth, "flip-map", "dzhanibekov", "How fast a slip off the middle axis grows, for every rigid body"
        => of_body::moments::place::<true>, "How fast a slip grows, among all rigid bodies";
    coin::draw, "coin", "coin", "A thrown plate: its axis and its spin circle its momentum";
    jacobi::draw, "jacobi", "exact-motion", "The components of the spin are Jacobi's three functions"
        => of_body::spins::jacobi, "Its spin in Jacobi’s elliptic functions";
    flip_time_deep::draw, "flip-time-deep", "exact-motion", "Time between flips down to the smallest slip that a computer knows";
    series_terms::draw, "series-terms", "closed-form", "Number of terms that the two series of the closed form need";
    closed_form::complements, "complements", "closed-form", "The complement of the modulus for starts next to the middle axis";
    closed_form::psi, "psi", "closed-form", "The angle about the momentum that the closed form adds up";
    closed_form::zeros, "theta-zeros", "closed-form", "Zeros and poles of the attitude's two numbers in the plane of the argument";
    closed_form::both_numbers, "pair", "closed-form", "The attitude's two complex numbers through two half periods";
    exact_errors::draw, "exact-errors", "exact-motion", "Errors of the exact motion over many bodies, relative to what a rounded input does";
    a_top::draw, "a-top", "a-top", "The axis of a top that was let go: it nods and goes round";
    four_steps::draw, "four-steps", "stepping-through-time", "What four methods make of the energy of a tumbling box";
    work::draw_box, "work-box", "error-against-run-time", "Error of the box's attitude against run time, for every method";
    work_torque::draw, "work-torque", "error-against-run-time", "Error of a heavy top's attitude against run time, for every method and published programs";
    work::draw_attitude, "work-attitude", "records", "Error of the attitude against run time, for twelve bodies";
    work::draw_drift, "drift", "records", "Error of the energy through a million turns";
    scene_costs::draw, "scene-costs", "only-what-you-need", "What a state costs by what is requested of it";
    engines_fate::draw, "engines-fate", "where-things-break", "What the rules of physics engines make of a stable spin";
    judged::grades, "judged-grades", "test-your-engine", "For how long recorded engines do what a free body does";
    frame::draw, "frame", "put-it-into-your-engine", "A frame of an engine: forces, solver, positions, and what each changes";
    judged::energies, "judged-energy", "records", "Energy of free bodies in recorded engines, beside the exact motion";
};

/// The width, in points, of a sheet whose letters are at least 11 px high on a phone.
const NARROW: u32 = 500;

/// Edges of the document's box, m.
const BOX_EDGES: [f64; 3] = named::THE_BOX.sizes;

/// Its tensor.
fn document_box() -> Result<Inertia, Error> {
    Ok(named::NamedBody::TheBox.properties()?.inertia())
}

/// A body with its frame turned along its principal axes, smallest moment first.
fn in_principal_axes(inertia: &Inertia) -> Result<Inertia, Error> {
    let m = inertia.principal().moments();
    Inertia::from_moments(m[0], m[1], m[2])
}

/// The next power of ten above a small error, as a statement that holds on every machine.
fn bound(error: f64) -> f64 {
    10_f64.powf(error.log10().ceil())
}
