//! The fields of a body in a file, and which of them an error is about.

use serde::Deserialize;
use serde::de::{Deserializer, Error};
use std::ops::Range;
use toml::Spanned;
use tumbling::Subject;

/// A body or one of its parts, as a TOML file has it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    pub(crate) name: Option<Spanned<String>>,
    pub(crate) shape: Option<Spanned<String>>,
    pub(crate) sides: Option<Spanned<Vec<f64>>>,
    pub(crate) radius: Option<Spanned<f64>>,
    pub(crate) inner: Option<Spanned<f64>>,
    pub(crate) height: Option<Spanned<f64>>,
    pub(crate) length: Option<Spanned<f64>>,
    #[serde(default, deserialize_with = "list")]
    pub(crate) semiaxes: Option<Spanned<[f64; 3]>>,
    #[serde(default, deserialize_with = "lists")]
    pub(crate) vertices: Option<Spanned<[[f64; 3]; 4]>>,
    #[serde(default, deserialize_with = "lists")]
    pub(crate) points: Option<Spanned<Vec<[f64; 4]>>>,
    pub(crate) mesh: Option<Spanned<String>>,
    pub(crate) unit: Option<Spanned<f64>>,
    pub(crate) part: Option<Spanned<Vec<Spanned<Table>>>>,
    #[serde(default, deserialize_with = "list")]
    pub(crate) moments: Option<Spanned<[f64; 3]>>,
    #[serde(default, deserialize_with = "list")]
    pub(crate) products: Option<Spanned<[f64; 3]>>,
    pub(crate) tolerance: Option<Spanned<f64>>,
    pub(crate) urdf: Option<Spanned<String>>,
    pub(crate) link: Option<Spanned<String>>,
    pub(crate) body: Option<Spanned<String>>,
    /// How fast it spins.
    pub spin: Option<Spanned<Spin>>,
    /// Of a body in a scene: its angular momentum in world axes, kg m²/s.
    #[serde(default, deserialize_with = "list")]
    pub momentum: Option<Spanned<[f64; 3]>>,
    /// Of a body in a scene: body to world, a unit quaternion, scalar part first.
    #[serde(default, deserialize_with = "list")]
    pub attitude: Option<Spanned<[f64; 4]>>,
    pub(crate) mass: Option<Spanned<f64>>,
    pub(crate) density: Option<Spanned<f64>>,
    #[serde(default, deserialize_with = "list")]
    pub(crate) at: Option<Spanned<[f64; 3]>>,
    #[serde(default, deserialize_with = "list")]
    pub(crate) turn: Option<Spanned<[f64; 4]>>,
}

/// A list of just this number of numbers: an array by itself would leave the rest of a longer list unread.
///
/// # Errors
/// A list of more or fewer.
pub fn list<'de, D: Deserializer<'de>, const N: usize>(
    from: D,
) -> Result<Option<Spanned<[f64; N]>>, D::Error> {
    let found = Spanned::<Vec<f64>>::deserialize(from)?;
    Ok(Some(Spanned::new(found.span(), whole(found.into_inner()).map_err(D::Error::custom)?)))
}

/// Lists of just this number of numbers each: as many as `L` takes.
fn lists<'de, D, L, const N: usize>(from: D) -> Result<Option<Spanned<L>>, D::Error>
where
    D: Deserializer<'de>,
    L: TryFrom<Vec<[f64; N]>>,
{
    let found = Spanned::<Vec<Vec<f64>>>::deserialize(from)?;
    let (span, count) = (found.span(), found.get_ref().len());
    let all: Result<Vec<_>, _> = found.into_inner().into_iter().map(whole).collect();
    let all = L::try_from(all.map_err(D::Error::custom)?);
    let all = all.map_err(|_| D::Error::custom(format!("{count} lists are too many or too few here")))?;
    Ok(Some(Spanned::new(span, all)))
}

fn whole<const N: usize>(numbers: Vec<f64>) -> Result<[f64; N], String> {
    let found = numbers.len();
    numbers.try_into().map_err(|_| format!("{N} numbers are expected here, not {found}"))
}

/// How fast a body spins, rad/s.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(untagged, expecting = "a number (rad/s), or in a scene a list of three")]
pub enum Spin {
    /// As figures and films show it.
    Speed(f64),
    /// In a scene: in body axes.
    Vector([f64; 3]),
}

/// The fields that say what a body is, and those that may go with each.
pub(crate) const GIVEN_BY: [(&str, &[&str]); 8] = [
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
    pub(crate) fn parts(&self) -> (usize, usize) {
        let inner = self.part.iter().flat_map(Spanned::get_ref).map(|part| part.get_ref().parts());
        inner.fold((0, 1), |(count, depth), (inner, below)| (count + 1 + inner, depth.max(below + 1)))
    }

    /// The moments (xx, yy, zz) and the products (xy, xz, yz), if it is given by them.
    pub(crate) fn tensor(&self) -> Option<([f64; 3], [f64; 3])> {
        let products = self.products.as_ref().map(|products| *products.get_ref());
        self.moments.as_ref().map(|moments| (*moments.get_ref(), products.unwrap_or_default()))
    }

    /// The fields that there are, and where.
    #[must_use]
    pub fn present(&self) -> Vec<(&'static str, Range<usize>)> {
        macro_rules! spans {
            ($($name:ident)*) => { [$((stringify!($name), self.$name.as_ref().map(Spanned::span))),*] };
        }
        let all = spans!(shape sides radius inner height length semiaxes vertices points mesh unit part
            moments products tolerance urdf link body spin momentum attitude mass density at turn);
        all.into_iter().filter_map(|(name, span)| Some((name, span?))).collect()
    }
}

/// The field that one of the library's refusals may come from, the likeliest first.
pub(crate) fn fields_of(subject: Subject) -> &'static [&'static str] {
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
