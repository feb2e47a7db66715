//! A body from the text of a TOML file.

mod table;

use crate::error::Error;
use crate::files::read_text;
use crate::model::BodyModel;
use crate::shape::{KINDS, Sizes, Weight, shaped, sides};
use crate::surface::{FARTHEST, Surface};
use crate::{mesh, urdf};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use std::ops::Range;
use std::path::Path;
use table::{GIVEN_BY, Table, fields_of};
use toml::Spanned;
use tumbling::body::named::NamedBody;
use tumbling::solid::{Compound, Mesh};
use tumbling::{Inertia, MassProperties};

/// How many parts a body may have, and how deep they may be nested.
const MOST_PARTS: usize = 10_000;
const DEEPEST: usize = 30;

/// Where a table stands, and what it names.
struct Reader<'a> {
    text: &'a str,
    folder: &'a Path,
}

pub(crate) fn read(text: &str, folder: &Path) -> Result<BodyModel, Error> {
    let table: Table = toml::from_str(text).map_err(|error| match error.span() {
        Some(span) => Error::at(text, &span, error.message()),
        None => Error::new(error.message()),
    })?;
    let (count, depth) = table.parts();
    let first = table.part.as_ref().map_or(0..0, Spanned::span);
    for (found, of, most) in
        [(count, "parts", MOST_PARTS), (depth, "bodies, one the part of the other", DEEPEST)]
    {
        if found > most {
            let why = format!("{found} {of}: at most {most} are read");
            return Err(Error::at(text, &first, why).of_field("part"));
        }
    }
    Reader { text, folder }.body(&table, &(0..0))
}

impl Reader<'_> {
    fn wrong(&self, span: &Range<usize>, field: &str, why: impl std::fmt::Display) -> Error {
        Error::at(self.text, span, why).of_field(field)
    }

    /// A refusal of the library, at the field that it speaks of or at the one that says what the body is.
    fn refused(&self, table: &Table, by: &(&'static str, Range<usize>), error: &tumbling::Error) -> Error {
        let (meant, present) = (fields_of(error.subject()), table.present());
        let found = meant.iter().find_map(|meant| present.iter().find(|(field, _)| field == meant));
        let (field, span) = found.unwrap_or(by);
        self.wrong(span, field, error)
    }

    /// The one field that says what the body is; all others must go with it.
    fn given_by(&self, table: &Table, span: &Range<usize>) -> Result<(&'static str, Range<usize>), Error> {
        let present = table.present();
        let by = GIVEN_BY.iter().find_map(|(name, with)| {
            let (name, span) = present.iter().find(|(field, _)| field == name)?;
            Some((*name, span.clone(), *with))
        });
        let Some((name, span, with)) = by else {
            let all: Vec<String> = GIVEN_BY.iter().map(|(name, _)| format!("`{name}`")).collect();
            let why = format!("what the body is is missing: one of {}", all.join(", "));
            return Err(Error::at(self.text, span, why));
        };
        let sizes = match (&table.shape, name) {
            (Some(shape), _) => self.sizes_of(shape.get_ref(), &shape.span())?,
            (None, "sides") => &["sides"],
            _ => &[][..],
        };
        for (field, span) in &present {
            let goes = *field == name
                || with.contains(field)
                || sizes.contains(field)
                || ["at", "turn", "spin"].contains(field);
            if !goes {
                return Err(self.wrong(span, field, format!("it does not go with `{name}`")));
            }
        }
        Ok((name, span))
    }

    fn sizes_of(&self, shape: &str, span: &Range<usize>) -> Result<&'static [&'static str], Error> {
        let Some(kind) = KINDS.iter().find(|kind| kind.name == shape) else {
            let names: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
            return Err(self.wrong(
                span,
                "shape",
                format!("no shape is called `{shape}`; there are {}", names.join(", ")),
            ));
        };
        Ok(kind.all)
    }

    /// A body as its table says, placed and turned.
    fn body(&self, table: &Table, span: &Range<usize>) -> Result<BodyModel, Error> {
        let by = self.given_by(table, span)?;
        let found = match by.0 {
            "points" => self.points(table, &by),
            "mesh" => self.mesh(table, &by),
            "part" => self.parts(table, &by),
            "moments" => self.moments(table, &by),
            "urdf" => self.urdf(table, &by),
            "body" => self.named(table, &by),
            _ => self.shape(table, &by),
        }?;
        self.drawable(table, &by, &found)?;
        let name = table.name.as_ref().map(|name| self.name(name)).transpose()?;
        let name = name.unwrap_or_else(|| found.name.clone());
        let spin = table.spin.as_ref().map(|spin| self.spin(spin)).transpose()?;
        self.placed(table, BodyModel { name, spin, ..found })
    }

    /// That what is drawn has a size that can be computed with, or else which field is to blame.
    fn drawable(
        &self,
        table: &Table,
        by: &(&'static str, Range<usize>),
        found: &BodyModel,
    ) -> Result<(), Error> {
        let Err(why) = found.drawable() else { return Ok(()) };
        let size = |field: &Option<Spanned<f64>>| field.as_ref().map_or(1.0, |x| x.get_ref().abs());
        let sizes = [
            ("radius", size(&table.radius)),
            ("height", size(&table.height)),
            ("length", size(&table.length)),
        ];
        let largest = sizes.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).map_or("", |size| size.0);
        // Too large a box is that of too large moments or of too small a mass.
        let moment = found.inertia.matrix().amax();
        let off = |x: f64| x.log10().abs();
        let weight = if off(size(&table.mass)) > off(moment) { "mass" } else { "moments" };
        let meant: &[&str] = match by.0 {
            "moments" if table.sides.is_none() => &[weight],
            _ => &["unit", "sides", "semiaxes", "vertices", largest],
        };
        let present = table.present();
        let blamed = meant.iter().find_map(|meant| present.iter().find(|(field, _)| field == meant));
        let (field, span) = blamed.unwrap_or(by);
        Err(self.wrong(span, field, why))
    }

    fn weight(&self, table: &Table, by: &(&'static str, Range<usize>)) -> Result<Weight, Error> {
        match (&table.mass, &table.density) {
            (Some(mass), None) => Ok(Weight::Mass(*mass.get_ref())),
            (None, Some(density)) => Ok(Weight::Density(*density.get_ref())),
            (None, None) => Err(self.wrong(
                &by.1,
                by.0,
                "`mass` (kg) or `density` (kg/m³) is missing, which goes with it",
            )),
            (Some(_), Some(density)) => Err(self.wrong(
                &density.span(),
                "density",
                "either `mass` or `density` is expected, not both",
            )),
        }
    }

    fn shape(&self, table: &Table, by: &(&'static str, Range<usize>)) -> Result<BodyModel, Error> {
        let name = table.shape.as_ref().map_or("box", |shape| shape.get_ref());
        let present = table.present();
        let needed = KINDS.iter().find(|kind| kind.name == name).map_or(&[][..], |kind| kind.all);
        let absent = |field: &&&str| **field != "inner" && present.iter().all(|p| p.0 != **field);
        if let Some(missing) = needed.iter().find(absent) {
            return Err(self.wrong(&by.1, by.0, format!("`{missing}` is missing, which a {name} has")));
        }
        let count = sides(name);
        if let Some(given) = table.sides.as_ref().filter(|given| given.get_ref().len() != count) {
            let why = format!("{count} numbers are expected here, not {}", given.get_ref().len());
            return Err(self.wrong(&given.span(), "sides", why));
        }
        let number = |field: &Option<Spanned<f64>>| field.as_ref().map_or(0.0, |x| *x.get_ref());
        let sizes = Sizes {
            sides: table.sides.as_ref().map(|s| s.get_ref().clone()).unwrap_or_default(),
            radius: number(&table.radius),
            inner: number(&table.inner),
            height: number(&table.height),
            length: number(&table.length),
            semiaxes: table.semiaxes.as_ref().map(|s| *s.get_ref()).unwrap_or_default(),
            vertices: table.vertices.as_ref().map(|s| *s.get_ref()).unwrap_or_default(),
        };
        let (properties, surface) =
            shaped(name, &sizes, self.weight(table, by)?).map_err(|error| self.refused(table, by, &error))?;
        let sides = (name == "box").then(|| <[f64; 3]>::try_from(sizes.sides).ok()).flatten();
        Ok(BodyModel { sides, ..model(properties, vec![surface]) })
    }

    /// What it is called: one line, as drawings and pages can write it.
    fn name(&self, given: &Spanned<String>) -> Result<String, Error> {
        let name = given.get_ref();
        match name.chars().find(|c| c.is_control()) {
            Some(c) => Err(self.wrong(&given.span(), "name", format!("{c:?} is not a character to write"))),
            None => Ok(name.clone()),
        }
    }

    /// How fast it spins, rad/s.
    fn spin(&self, given: &Spanned<f64>) -> Result<f64, Error> {
        let spin = *given.get_ref();
        let why = || self.wrong(&given.span(), "spin", format!("{spin} rad/s is not above zero and finite"));
        if spin > 0.0 && spin.is_finite() { Ok(spin) } else { Err(why()) }
    }

    /// The three edges of a box.
    fn edges(&self, given: &Spanned<Vec<f64>>) -> Result<[f64; 3], Error> {
        let wrong = |why: String| self.wrong(&given.span(), "sides", why);
        let count = given.get_ref().len();
        let edges = <[f64; 3]>::try_from(given.get_ref().as_slice())
            .map_err(|_| wrong(format!("3 numbers are expected here, not {count}")))?;
        let [a, b, c] = edges;
        tumbling::solid::Cuboid::new(a, b, c).map_err(|error| wrong(error.to_string()))?;
        Ok(edges)
    }

    fn points(&self, table: &Table, by: &(&'static str, Range<usize>)) -> Result<BodyModel, Error> {
        let rows = table.points.as_ref().map(|points| points.get_ref().as_slice()).unwrap_or_default();
        let points: Vec<_> = rows.iter().map(|&[mass, x, y, z]| (mass, Vector3::new(x, y, z))).collect();
        let properties =
            MassProperties::of_points(&points).map_err(|error| self.wrong(&by.1, by.0, error))?;
        Ok(model(properties, vec![Surface::points(points.into_iter().map(|point| point.1).collect())]))
    }

    fn mesh(&self, table: &Table, by: &(&'static str, Range<usize>)) -> Result<BodyModel, Error> {
        let file = table.mesh.as_ref().map_or("", |file| file.get_ref());
        let unit = table.unit.as_ref().map_or(1.0, |unit| *unit.get_ref());
        if let Some(given) = table.unit.as_ref().filter(|_| !(unit > 0.0 && unit.is_finite())) {
            return Err(self.wrong(&given.span(), "unit", format!("{unit} is not above 0 and finite")));
        }
        let (mut vertices, faces) =
            mesh::read(&self.folder.join(file)).map_err(|error| self.wrong(&by.1, by.0, error))?;
        for vertex in &mut vertices {
            *vertex *= unit;
        }
        let weight = self.weight(table, by)?;
        let properties = Mesh::new(&vertices, &faces)
            .and_then(|mesh| weight.of(&mesh))
            .map_err(|error| self.refused(table, by, &error))?;
        let faces = faces.into_iter().map(|face| face.to_vec()).collect();
        Ok(model(properties, vec![Surface { vertices, faces, convex: false }]))
    }

    fn parts(&self, table: &Table, by: &(&'static str, Range<usize>)) -> Result<BodyModel, Error> {
        let (mut whole, mut surfaces) = (Compound::new(), Vec::new());
        for part in table.part.iter().flat_map(Spanned::get_ref) {
            let found = self.body(part.get_ref(), &part.span())?;
            if let Some(spin) = &part.get_ref().spin {
                return Err(self.wrong(&spin.span(), "spin", "it is the whole body's, not a part's"));
            }
            let Some(mass) = found.mass else {
                return Err(Error::at(
                    self.text,
                    &part.span(),
                    "`mass` (kg) is missing: a part without is no part",
                ));
            };
            let of_part = MassProperties::new(mass, &found.centre, found.inertia);
            whole = whole.at(of_part.map_err(|error| self.wrong(&by.1, by.0, error))?, &Vector3::zeros());
            surfaces.extend(found.surfaces);
        }
        let properties = whole.properties().map_err(|error| self.wrong(&by.1, by.0, error))?;
        Ok(model(properties, surfaces))
    }

    fn moments(&self, table: &Table, by: &(&'static str, Range<usize>)) -> Result<BodyModel, Error> {
        let [xx, yy, zz] = table.moments.as_ref().map(|m| *m.get_ref()).unwrap_or_default();
        let [xy, xz, yz] = table.products.as_ref().map(|p| *p.get_ref()).unwrap_or_default();
        let matrix = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let found = match &table.tolerance {
            Some(tolerance) => Inertia::within(&matrix, *tolerance.get_ref()),
            None => Inertia::try_from(matrix).map(|inertia| (inertia, 0.0)),
        };
        let (inertia, moved) = found.map_err(|error| self.refused(table, by, &error))?;
        let mass = table.mass.as_ref().map(|mass| *mass.get_ref());
        if let Some(mass) = mass {
            MassProperties::new(mass, &Vector3::zeros(), inertia)
                .map_err(|error| self.refused(table, by, &error))?;
        }
        // Sides say what is drawn.
        let sides = table.sides.as_ref().map(|given| self.edges(given)).transpose()?;
        let surfaces = sides.iter().map(|sides| Surface::cuboid(&(*sides).into())).collect();
        Ok(BodyModel {
            name: String::new(),
            mass,
            centre: Vector3::zeros(),
            inertia,
            moved,
            surfaces,
            spin: None,
            sides,
        })
    }

    fn urdf(&self, table: &Table, by: &(&'static str, Range<usize>)) -> Result<BodyModel, Error> {
        let path = self.folder.join(table.urdf.as_ref().map_or("", |file| file.get_ref()));
        let text = read_text(&path).map_err(|error| self.wrong(&by.1, by.0, error))?;
        let link = table.link.as_ref().map(|link| link.get_ref().as_str());
        let tolerance = table.tolerance.as_ref().map_or(0.0, |tolerance| *tolerance.get_ref());
        if let Some(given) = table.tolerance.as_ref().filter(|_| !(tolerance >= 0.0 && tolerance.is_finite()))
        {
            let why = format!("{tolerance} is not a finite number, zero or above");
            return Err(self.wrong(&given.span(), "tolerance", why));
        }
        urdf::read(&text, link, tolerance).map_err(|error| match &table.link {
            // Without a line: not an element of the file, but the name that is not in it.
            Some(link) if error.line.is_none() && error.field.as_deref() == Some("link") => {
                self.wrong(&link.span(), "link", error.why)
            }
            _ => self.wrong(&by.1, by.0, error.in_file(&path)),
        })
    }

    fn named(&self, table: &Table, by: &(&'static str, Range<usize>)) -> Result<BodyModel, Error> {
        let name = table.body.as_ref().map_or("", |name| name.get_ref());
        let body = NamedBody::ALL.into_iter().find(|&body| crate::model::word(body) == name);
        let body =
            body.ok_or_else(|| self.wrong(&by.1, by.0, format!("no body of the book is called `{name}`")))?;
        BodyModel::named(body)
    }

    /// The body turned about the origin of its axes, then moved.
    fn placed(&self, table: &Table, found: BodyModel) -> Result<BodyModel, Error> {
        let mut found = found;
        if let Some(turn) = &table.turn {
            let [x, y, z, degrees] = *turn.get_ref();
            let axis = Vector3::new(x, y, z);
            let wrong = |why: &dyn std::fmt::Display| self.wrong(&turn.span(), "turn", why);
            let Some(axis) =
                nalgebra::Unit::try_new(axis, 0.0).filter(|axis| axis.iter().all(|x| x.is_finite()))
            else {
                return Err(wrong(
                    &"x, y and z must be a direction, of finite numbers that are not all zero",
                ));
            };
            let attitude = UnitQuaternion::from_axis_angle(&axis, degrees.to_radians());
            found.inertia = found.inertia.turned(attitude).map_err(|error| wrong(&error))?;
            found.centre = attitude * found.centre;
            for surface in &mut found.surfaces {
                *surface = surface.mapped(|p| attitude * p);
            }
            found.sides = None;
        }
        if let Some(at) = &table.at {
            let place = Vector3::from(*at.get_ref());
            found.centre += place;
            if !found.centre.iter().all(|x| x.is_finite()) {
                return Err(self.wrong(&at.span(), "at", "the place must be finite"));
            }
            let reach = found.surfaces.iter().flat_map(|s| &s.vertices).map(|p| p.amax()).fold(0.0, f64::max);
            if place.amax() > FARTHEST * reach && !found.surfaces.is_empty() {
                return Err(self.wrong(&at.span(), "at", "so far away that rounding would change its shape"));
            }
            for surface in &mut found.surfaces {
                *surface = surface.mapped(|p| p + place);
            }
        }
        Ok(found)
    }
}

fn model(properties: MassProperties, surfaces: Vec<Surface>) -> BodyModel {
    BodyModel {
        name: String::new(),
        mass: Some(properties.mass()),
        centre: properties.centre(),
        inertia: properties.inertia(),
        moved: 0.0,
        surfaces,
        spin: None,
        sides: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body(text: &str) -> Result<BodyModel, Error> {
        BodyModel::from_toml(text, Path::new(""))
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line_and_its_field() {
        for (text, words) in [
            ("sides = [1, 2, 3]", "line 1, `sides`: `mass` (kg) or `density` (kg/m³) is missing"),
            ("mass = 1", "line 1: what the body is is missing"),
            (
                "sides = [1, -2, 3]\nmass = 1",
                "line 1, `sides`: the edge along y is -2.0: it must be above zero",
            ),
            ("sides = [1, 2]\nmass = 1", "line 1, `sides`: 3 numbers are expected here, not 2"),
            (
                "mass = 1\nshape = 'bal'\nradius = 1",
                "line 2, `shape`: no shape is called `bal`; there are box, ball",
            ),
            ("mass = 1\nshape = 'ball'\nheight = 1", "line 3, `height`: it does not go with `shape`"),
            ("mass = 1\nshape = 'cone'\nheight = 1", "line 2, `shape`: `radius` is missing"),
            ("mass = 1\nshape = 'ball'\nradius = 1\ninner = 2", "line 4, `inner`: the inner radius"),
            ("moments = [1, 2, 3.1]", "line 1, `moments`: no body has principal moments"),
            ("moments = [1, 2, 2]\nmass = 0", "line 2, `mass`: the mass is 0.0: it must be above zero"),
            ("moments = [1, 2, nan]", "line 1, `moments`"),
            ("mass = 'a'", "line 1: invalid type"),
            (
                "[[part]]\nsides = [1, 2, 3]\nmass = 1\n[[part]]\nmomets = [1]",
                "line 5: unknown field `momets`",
            ),
            ("[[part]]\nmoments = [1, 2, 3]", "line 1: `mass` (kg) is missing"),
            ("[[part]]\nsides = [1, 2, 3]\nmass = 1\nturn = [0, 0, 0, 1]", "line 4, `turn`: x, y and z"),
            ("mesh = 'none.stl'\nmass = 1", "line 1, `mesh`: none.stl: it cannot be read"),
            ("shape = 'rod'\nlength = 1\nmass = 1", "moment"),
            ("spin = 0\nmoments = [1, 2, 2]", "line 1, `spin`: 0 rad/s is not above zero"),
            ("[[part]]\nsides = [1, 2, 3]\nmass = 1\nspin = 1", "line 4, `spin`: it is the whole body's"),
            ("points = [[1, 0, 0, 0]]", "line 1, `points`"),
            ("mass = 1\nname = \"a\\u0000b\"\nsides = [1, 2, 3]", "line 2, `name`: '\\0' is not a character"),
            ("sides = [1, 2, 3]\nmass = 1\nat = [1e300, 0, 0]", "line 3, `at`: so far away that rounding"),
        ] {
            let error = body(text).unwrap_err().to_string();
            assert!(error.contains(words), "{text}\n{error}");
        }
    }

    /// Each field of each kind of body, made bad in turn.
    #[test]
    fn the_field_that_is_made_bad_is_the_field_that_is_named() {
        for (good, bad) in [
            ("sides = [1, 2, 3]\nmass = 1", &[("sides", "[1, 2, -3]"), ("mass", "-1"), ("mass", "inf")][..]),
            ("sides = [1, 2, 3]\ndensity = 1", &[("density", "-1"), ("density", "1e308")]),
            ("shape = 'ball'\nradius = 2\ninner = 1\nmass = 1", &[("radius", "-1"), ("inner", "3")]),
            ("shape = 'ball'\nradius = 2\nmass = 1", &[("radius", "-1"), ("mass", "0")]),
            ("shape = 'capsule'\nradius = 2\nlength = 1\nmass = 1", &[("radius", "0"), ("length", "-1")]),
            ("shape = 'cone'\nradius = 2\nheight = 1\nmass = 1", &[("radius", "0"), ("height", "nan")]),
            (
                "shape = 'cylinder'\nradius = 2\nheight = 1\ninner = 1\nmass = 1",
                &[("radius", "inf"), ("height", "-1"), ("inner", "-1")],
            ),
            ("shape = 'disk'\nradius = 2\ndensity = 1", &[("radius", "-2"), ("density", "inf")]),
            ("shape = 'ellipsoid'\nsemiaxes = [1, 2, 3]\nmass = 1", &[("semiaxes", "[1, 0, 3]")]),
            ("shape = 'plate'\nsides = [1, 2]\nmass = 1", &[("sides", "[0, 1]"), ("mass", "nan")]),
            (
                "shape = 'tetrahedron'\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\nmass = 1",
                &[("vertices", "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, inf]]"), ("mass", "-1")],
            ),
            ("points = [[1, 0, 0, 0], [1, 1, 0, 0], [1, 0, 1, 0]]", &[("points", "[[0, 1, 2, 3]]")]),
            (
                "moments = [2, 3, 4]\nproducts = [0, 0.1, 0]\ntolerance = 0.1\nmass = 1\nsides = [1, 1, 1]",
                &[
                    ("moments", "[2, -3, 4]"),
                    ("moments", "[2, nan, 4]"),
                    ("products", "[0, inf, 0]"),
                    ("tolerance", "-1"),
                    ("mass", "0"),
                    ("sides", "[1, 1, 0]"),
                ],
            ),
            ("mass = 1\nmesh = 'corner.obj'\nunit = 1", &[("mass", "-1"), ("unit", "0"), ("unit", "1e308")]),
            ("mesh = 'corner.obj'\nunit = 1\ndensity = 1", &[("density", "-1"), ("unit", "1e200")]),
            (
                "urdf = 'arm.urdf'\nlink = 'arm'\ntolerance = 0.1",
                &[("urdf", "'none'"), ("link", "'leg'"), ("tolerance", "-1"), ("tolerance", "nan")],
            ),
            (
                "sides = [1, 2, 3]\ndensity = 1",
                &[("sides", "[1e101, 1, 1]"), ("sides", "[1e-105, 1e-105, 1e-105]")],
            ),
            (
                "shape = 'cylinder'\nradius = 2\nheight = 1\nmass = 1",
                &[("radius", "1e120"), ("height", "1e120")],
            ),
            ("moments = [2, 3, 4]\nmass = 1", &[("moments", "[1e308, 1e308, 1e308]"), ("mass", "1e-250")]),
            ("moments = [2, 3, 4]", &[("moments", "[1e308, 1e308, 1e308]")]),
            (
                "body = 'book'\nspin = 1\nat = [1, 0, 0]\nturn = [1, 0, 0, 30]",
                &[("body", "'page'"), ("spin", "-1"), ("at", "[inf, 0, 0]"), ("turn", "[0, 0, 0, 1]")],
            ),
        ] {
            let body = |text: &str| BodyModel::from_toml(text, Path::new("tests/files"));
            body(good).unwrap_or_else(|error| panic!("{good}: {error}"));
            for (field, value) in bad {
                let mut lines = good.lines().enumerate();
                let (line, given) =
                    lines.find(|(_, given)| given.split_once(" = ").unwrap().0 == *field).unwrap();
                let text = good.replacen(given, &format!("{field} = {value}"), 1);
                let error = body(&text).unwrap_err();
                assert_eq!(
                    (error.line, error.field.as_deref()),
                    (Some(line + 1), Some(*field)),
                    "{text}: {error}"
                );
            }
        }
    }

    #[test]
    fn what_would_take_minutes_or_the_stack_is_refused_with_its_count() {
        let part = "[[part]]\nsides = [1, 2, 3]\nmass = 1\n";
        let error = body(&part.repeat(100_000)).unwrap_err();
        assert!(error.why.starts_with("100000 parts: at most 10000"), "{error}");
        let nested = |depth: usize| {
            let heads =
                (1..depth).map(|k| format!("[[{}]]\n", vec!["part"; k].join("."))).collect::<String>();
            body(&format!("{heads}sides = [1, 2, 3]\nmass = 1\n"))
        };
        assert!(nested(30).is_ok());
        assert!(nested(31).unwrap_err().why.starts_with("31 bodies, one the part of the other: at most 30"));
        for depth in [100, 1000] {
            assert!(nested(depth).is_err());
        }
        for depth in [1000, 100_000] {
            assert!(body(&format!("part = {}{}", "[".repeat(depth), "]".repeat(depth))).is_err());
            assert!(body(&format!("[{}]", vec!["part"; depth].join("."))).is_err());
            assert!(body(&format!("{}x = 1{}", "part = [{ ".repeat(depth), " }]".repeat(depth))).is_err());
        }
    }

    #[test]
    fn parts_add_up_as_a_compound_does_wherever_they_are_written() {
        let one = "[[part]]\nsides = [1, 2, 3]\ndensity = 2\nat = [0.5, 0, 0]\n";
        let pair = format!(
            "{one}[[part]]\nsides = [2, 1, 3]\ndensity = 2\nturn = [0, 0, 1, 90]\nat = [-0.5, 0, 0]\n"
        );
        let whole = body("sides = [2, 2, 3]\ndensity = 2").unwrap();
        let found = body(&pair).unwrap();
        assert!((found.inertia.matrix() - whole.inertia.matrix()).amax() < 1e-13);
        assert_eq!(found.mass, whole.mass);
        let nested = pair.replace("[[part]]", "[[part.part]]");
        assert_eq!(body(&format!("[[part]]\nat = [0, 7, 0]\n{nested}")).unwrap().centre.y, 7.0);
    }

    #[test]
    fn printed_moments_are_taken_within_the_tolerance_that_the_file_has() {
        let panel = "moments = [0.003333, 0.01333, 0.01667]";
        assert!(body(panel).is_err());
        let moved = body(&format!("{panel}\ntolerance = 1e-3")).unwrap().moved;
        assert!(moved > 1e-4 && moved < 1e-3);
    }
}
