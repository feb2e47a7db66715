//! The fields of a body in a file, and which of them an error is about.

use serde::Deserialize;
use std::ops::Range;
use toml::Spanned;
use tumbling::Subject;

/// The fields of a body or of one of its parts, by the names that a file has for them.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Table {
    pub(super) name: Option<Spanned<String>>,
    pub(super) shape: Option<Spanned<String>>,
    pub(super) sides: Option<Spanned<Vec<f64>>>,
    pub(super) radius: Option<Spanned<f64>>,
    pub(super) inner: Option<Spanned<f64>>,
    pub(super) height: Option<Spanned<f64>>,
    pub(super) length: Option<Spanned<f64>>,
    pub(super) semiaxes: Option<Spanned<[f64; 3]>>,
    pub(super) vertices: Option<Spanned<[[f64; 3]; 4]>>,
    pub(super) points: Option<Spanned<Vec<[f64; 4]>>>,
    pub(super) mesh: Option<Spanned<String>>,
    pub(super) unit: Option<Spanned<f64>>,
    pub(super) part: Option<Spanned<Vec<Spanned<Table>>>>,
    pub(super) moments: Option<Spanned<[f64; 3]>>,
    pub(super) products: Option<Spanned<[f64; 3]>>,
    pub(super) tolerance: Option<Spanned<f64>>,
    pub(super) urdf: Option<Spanned<String>>,
    pub(super) link: Option<Spanned<String>>,
    pub(super) body: Option<Spanned<String>>,
    pub(super) spin: Option<Spanned<f64>>,
    pub(super) mass: Option<Spanned<f64>>,
    pub(super) density: Option<Spanned<f64>>,
    pub(super) at: Option<Spanned<[f64; 3]>>,
    pub(super) turn: Option<Spanned<[f64; 4]>>,
}

/// The fields that say what a body is, and those that may go with each.
pub(super) const GIVEN_BY: [(&str, &[&str]); 8] = [
    ("moments", &["products", "tolerance", "mass", "sides"]),
    ("shape", &["mass", "density"]),
    ("sides", &["mass", "density"]),
    ("points", &[]),
    ("mesh", &["unit", "mass", "density"]),
    ("part", &[]),
    ("urdf", &["link", "tolerance"]),
    ("body", &[]),
];

impl Table {
    /// How many parts it has in all, and how deep they are nested.
    pub(super) fn parts(&self) -> (usize, usize) {
        let inner = self.part.iter().flat_map(Spanned::get_ref).map(|part| part.get_ref().parts());
        inner.fold((0, 1), |(count, depth), (inner, below)| (count + 1 + inner, depth.max(below + 1)))
    }

    /// The fields that there are, and where.
    pub(super) fn present(&self) -> Vec<(&'static str, Range<usize>)> {
        macro_rules! spans {
            ($($name:ident)*) => { [$((stringify!($name), self.$name.as_ref().map(Spanned::span))),*] };
        }
        let all = spans!(shape sides radius inner height length semiaxes vertices points mesh unit part
            moments products tolerance urdf link body spin mass density at turn);
        all.into_iter().filter_map(|(name, span)| Some((name, span?))).collect()
    }
}

/// The field that one of the library's refusals may come from, the likeliest first.
pub(super) fn fields_of(subject: Subject) -> &'static [&'static str] {
    match subject {
        Subject::Mass => &["mass", "density"],
        Subject::Density => &["density"],
        Subject::InnerRadius => &["inner"],
        Subject::Radius | Subject::OuterRadius => &["radius"],
        Subject::Height => &["height"],
        Subject::Length => &["length"],
        Subject::EdgeX | Subject::EdgeY | Subject::EdgeZ => &["sides"],
        Subject::SemiAxisX | Subject::SemiAxisY | Subject::SemiAxisZ => &["semiaxes"],
        // Of a mesh, a file's numbers are finite: their unit makes them too large or too small.
        Subject::Vertex => &["vertices", "unit"],
        Subject::Volume | Subject::Moment => &["unit"],
        Subject::RelativeTolerance => &["tolerance"],
        Subject::Ixy | Subject::Ixz | Subject::Iyz => &["products"],
        _ => &[],
    }
}
