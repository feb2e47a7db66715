//! The fields of a body in a file, and which of them an error is about.

use serde::Deserialize;
use serde::de::{Deserializer, Error};
use toml::Spanned;
use tumbling::Subject;

/// Defines a table of a file with optional fields, and a function that lists the fields present.
#[macro_export]
macro_rules! table {
    (
        $(#[$about:meta])*
        $see:vis struct $Name:ident { $($(#[$of:meta])* $sees:vis $field:ident $(as $name:literal)?: $type:ty,)* }
    ) => {
        $(#[$about])*
        $see struct $Name { $($(#[$of])* $sees $field: Option<toml::Spanned<$type>>,)* }

        impl $Name {
            /// The fields that there are, and where.
            #[must_use]
            pub fn present(&self) -> Vec<(&'static str, std::ops::Range<usize>)> {
                let all = [$(([$($name,)? stringify!($field)][0], self.$field.as_ref().map(toml::Spanned::span))),*];
                all.into_iter().filter_map(|(name, span)| Some((name, span?))).collect()
            }
        }
    };
}

table! {
    /// A body or one of its parts, as a TOML file has it.
    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct Table {
        pub(crate) name: String,
        pub(crate) shape: String,
        #[serde(default, deserialize_with = "sizes")] pub(crate) sides: Vec<f64>,
        #[serde(default, deserialize_with = "size::<_, LENGTH>")] pub(crate) radius: f64,
        #[serde(default, deserialize_with = "size::<_, LENGTH>")] pub(crate) inner: f64,
        #[serde(default, deserialize_with = "size::<_, LENGTH>")] pub(crate) height: f64,
        #[serde(default, deserialize_with = "size::<_, LENGTH>")] pub(crate) length: f64,
        #[serde(default, deserialize_with = "three_sizes")] pub(crate) semiaxes: [f64; 3],
        #[serde(default, deserialize_with = "vertices")] pub(crate) vertices: [[f64; 3]; 4],
        #[serde(default, deserialize_with = "lists")] pub(crate) points: Vec<[f64; 4]>,
        pub(crate) mesh: String,
        #[serde(default, deserialize_with = "size::<_, LENGTH>")] pub(crate) unit: f64,
        pub(crate) part: Vec<Spanned<Table>>,
        #[serde(default, deserialize_with = "list")] pub(crate) moments: [f64; 3],
        #[serde(default, deserialize_with = "list")] pub(crate) products: [f64; 3],
        pub(crate) tolerance: f64,
        pub(crate) urdf: String,
        pub(crate) link: String,
        pub(crate) body: String,
        /// How fast it spins.
        pub spin: Spin,
        /// Of a body in a scene: its angular momentum in world axes, kg m²/s.
        #[serde(default, deserialize_with = "list")]
        pub momentum: [f64; 3],
        /// Of a body in a scene: body to world, a unit quaternion, scalar part first.
        #[serde(default, deserialize_with = "list")]
        pub attitude: [f64; 4],
        #[serde(default, deserialize_with = "size::<_, MASS>")] pub(crate) mass: f64,
        #[serde(default, deserialize_with = "size::<_, DENSITY>")] pub(crate) density: f64,
        #[serde(default, deserialize_with = "three_sizes")] pub(crate) at: [f64; 3],
        #[serde(default, deserialize_with = "list")] pub(crate) turn: [f64; 4],
    }
}

/// A list of exactly this many numbers: an array alone would ignore the rest of a longer list.
///
/// # Errors
/// A list with more or fewer numbers.
pub fn list<'de, D: Deserializer<'de>, const N: usize>(from: D) -> Field<[f64; N], D::Error> {
    read(from, |all: Vec<f64>| whole(all, "numbers"))
}

type Field<T, E> = Result<Option<Spanned<T>>, E>;

/// What is made of a value, in its place.
fn read<'de, D: Deserializer<'de>, X: Deserialize<'de>, Y>(
    from: D,
    make: impl FnOnce(X) -> Result<Y, String>,
) -> Field<Y, D::Error> {
    let found = Spanned::<X>::deserialize(from)?;
    let span = found.span();
    Ok(Some(Spanned::new(span, make(found.into_inner()).map_err(D::Error::custom)?)))
}

fn rows<const N: usize>(rows: Vec<Vec<f64>>) -> Result<Vec<[f64; N]>, String> {
    rows.into_iter().map(|row| whole(row, "numbers")).collect()
}

/// Lists of exactly this many numbers each.
fn lists<'de, D: Deserializer<'de>, const N: usize>(from: D) -> Field<Vec<[f64; N]>, D::Error> {
    read(from, rows)
}

fn vertices<'de, D: Deserializer<'de>>(from: D) -> Field<[[f64; 3]; 4], D::Error> {
    read(from, |all| whole(rows(all)?, "lists of 3 numbers each"))
}

// What a size is of.
const LENGTH: usize = 0;
const MASS: usize = 1;
const DENSITY: usize = 2;

/// A length, a mass or a density: a number of m, kg or kg/m³, or a text with its unit.
struct Size<const OF: usize>(f64);

/// A size as written.
#[derive(Deserialize)]
#[serde(untagged, expecting = "a number is expected here, or a text with its unit such as \"77 mm\"")]
pub(crate) enum Given {
    Number(f64),
    Text(String),
}

/// The number of each unit in a metre, a kilogram or a kilogram per cubic metre.
const UNITS: [&[(&str, f64)]; 3] = [
    &[("mm", 1e3), ("cm", 1e2), ("m", 1.0)],
    &[("kg", 1.0), ("g", 1e3)],
    &[("kg/m3", 1.0), ("kg/m³", 1.0), ("g/cm3", 1e-3), ("g/cm³", 1e-3)],
];

impl<'de, const OF: usize> Deserialize<'de> for Size<OF> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let text = match Given::deserialize(from)? {
            Given::Number(number) => return Ok(Self(number)),
            Given::Text(text) => text,
        };
        let read = |(unit, per): &(&str, f64)| {
            let number: f64 = text.trim().strip_suffix(unit)?.trim().parse().ok()?;
            Some(number / per).filter(|x| x.is_finite())
        };
        UNITS[OF].iter().find_map(read).map(Self).ok_or_else(|| {
            let such = ["\"77 mm\" (mm, cm, m)", "\"200 g\" (g, kg)", "\"0.7 g/cm3\" (g/cm3, kg/m3)"][OF];
            let lacks = if text.trim().parse::<f64>().is_ok() { ": the unit is missing" } else { "" };
            D::Error::custom(format!(
                "a number is expected here, or one with its unit such as {such}, not `{text}`{lacks}"
            ))
        })
    }
}

fn size<'de, D: Deserializer<'de>, const OF: usize>(from: D) -> Field<f64, D::Error> {
    read(from, |size: Size<OF>| Ok(size.0))
}

fn sizes<'de, D: Deserializer<'de>>(from: D) -> Field<Vec<f64>, D::Error> {
    read(from, |all: Vec<Size<LENGTH>>| Ok(all.into_iter().map(|size| size.0).collect()))
}

fn three_sizes<'de, D: Deserializer<'de>>(from: D) -> Field<[f64; 3], D::Error> {
    read(from, |all: Vec<Size<LENGTH>>| whole(all.into_iter().map(|size| size.0).collect(), "numbers"))
}

fn whole<T, const N: usize>(items: Vec<T>, of: &str) -> Result<[T; N], String> {
    items.try_into().map_err(|items: Vec<T>| format!("{N} {of} are expected here, not {}", items.len()))
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

/// The fields that say what a body is, and the fields allowed with each.
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
        // The numbers in a mesh file are finite; only their unit can make them too large or too small.
        Subject::Vertex => &["vertices", "unit"],
        Subject::Volume | Subject::Moment => &["unit"],
        Subject::RelativeTolerance => &["tolerance"],
        Subject::Ixy | Subject::Ixz | Subject::Iyz => &["products"],
        _ => &[],
    }
}
