//! A body from its table in a TOML file.

use crate::document::{decimal_comma, from_toml};
use crate::error::Error;
use crate::files::{DEEPEST, Files};
use crate::model::{BodyModel, nameable};
use crate::shape::{KINDS, Weight, shaped};
use crate::surface::{FARTHEST, Surface};
use crate::table::{GIVEN_BY, Spin, Table, fields_of};
use crate::{mesh, question, urdf};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use std::fmt::Display;
use std::ops::Range;
use toml::Spanned;
use tumbling::solid::{Compound, Cuboid, Mesh};
use tumbling::{Inertia, MassProperties};

/// How many parts a body may have, and how many solids with those of the files that its parts name.
const MOST_PARTS: usize = 10_000;

pub(crate) fn read(text: &str, files: &Files<'_>) -> Result<BodyModel, Error> {
    let table: Table = from_toml(text)?;
    for (field, span) in table.present() {
        let in_scene = matches!(&table.spin, Some(spin) if matches!(spin.get_ref(), Spin::Vector(_)));
        if ["momentum", "attitude"].contains(&field) || (field == "spin" && in_scene) {
            let why = "it is of a body in a scene: here, `spin` is one number";
            return Err(Error::at(text, &span, why).of_field(field));
        }
    }
    model(text, &table, &(0..0), files)?.ready().map_err(|error| {
        let present = table.present();
        let by = GIVEN_BY.iter().find_map(|(by, _)| present.iter().find(|(field, _)| field == by));
        by.map_or(error.clone(), |(field, span)| Error::at(text, span, error.why).of_field(field))
    })
}

/// The body of a table of a text; the table begins at a place in it.
pub(crate) fn model(
    text: &str,
    table: &Table,
    span: &Range<usize>,
    files: &Files<'_>,
) -> Result<BodyModel, Error> {
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
    Reader::new(text, table, span, files)?.body()
}

/// What a table says, and where.
struct Reader<'a> {
    text: &'a str,
    files: &'a Files<'a>,
    table: &'a Table,
    span: &'a Range<usize>,
    present: Vec<(&'static str, Range<usize>)>,
    /// The one field that says what the body is.
    by: &'static str,
}

pub(crate) fn number(field: &Option<Spanned<f64>>) -> f64 {
    field.as_ref().map_or(0.0, |x| *x.get_ref())
}

impl<'a> Reader<'a> {
    fn new(
        text: &'a str,
        table: &'a Table,
        span: &'a Range<usize>,
        files: &'a Files<'a>,
    ) -> Result<Self, Error> {
        let present = table.present();
        let has = |name: &str| present.iter().any(|(field, _)| *field == name);
        let Some((by, with)) = GIVEN_BY.into_iter().find(|(name, _)| has(name)) else {
            let all = GIVEN_BY.map(|(name, _)| format!("`{name}`")).join(", ");
            let why = format!("what the body is is missing: one of {all}");
            return Err(Error::at(text, span, why));
        };
        let reader = Self { text, files, table, span, present, by };
        let sizes = match &table.shape {
            Some(shape) => reader.sizes_of(shape.get_ref())?,
            None => &["sides"][..usize::from(by == "sides")],
        };
        let always = ["name", "at", "turn", "spin", "momentum", "attitude"];
        let goes = |field: &str| field == by || [with, sizes, &always].iter().any(|all| all.contains(&field));
        match reader.present.iter().find(|(field, _)| !goes(field)) {
            Some((field, _)) => {
                let own = [sizes, with].concat().join("`, `");
                let of = table.shape.as_ref().map_or(by, |shape| shape.get_ref());
                let takes = if own.is_empty() { own } else { format!(", which takes `{own}`") };
                Err(reader.wrong(field, format!("it does not go with `{of}`{takes}")))
            }
            None => Ok(reader),
        }
    }

    /// An error at a field, or at the table's head where it has none of this name.
    fn wrong(&self, field: &str, why: impl Display) -> Error {
        let span = self.present.iter().find(|(name, _)| *name == field).map_or(self.span, |(_, span)| span);
        Error::at(self.text, span, why).of_field(field)
    }

    /// That a field is right, or what is wrong with it.
    fn unless(&self, right: bool, field: &str, why: impl Display) -> Result<(), Error> {
        if right { Ok(()) } else { Err(self.wrong(field, why)) }
    }

    /// The first of these fields that there is, or the one that says what the body is.
    fn blamed(&self, fields: &[&'static str]) -> &'static str {
        let has = |field: &&&str| self.present.iter().any(|(name, _)| name == *field);
        fields.iter().find(has).copied().unwrap_or(self.by)
    }

    /// A refusal of the library, at the field that it speaks of or at the one that says what the body is.
    fn refused(&self, error: &tumbling::Error) -> Error {
        self.wrong(self.blamed(fields_of(error.subject())), error)
    }

    fn sizes_of(&self, shape: &str) -> Result<&'static [&'static str], Error> {
        let kind = KINDS.iter().find(|(name, _)| *name == shape);
        kind.map(|(_, sizes)| *sizes).ok_or_else(|| {
            let names = KINDS.map(|(name, _)| name).join(", ");
            let why =
                format!("no shape is called `{shape}`; there are {names}; a tube is a cylinder with `inner`");
            self.wrong("shape", why)
        })
    }

    /// The body, placed and turned.
    fn body(&self) -> Result<BodyModel, Error> {
        let mut found = match self.by {
            "points" => self.points(),
            "mesh" => self.mesh(),
            "part" => self.parts(),
            "moments" => self.moments(),
            "urdf" => self.urdf(),
            "body" => self.named(),
            _ => self.shape(),
        }?;
        found.drawable().map_err(|why| self.wrong(self.extreme(), why))?;
        if let Some(name) = &self.table.name {
            let wrong = |why| Error::at(self.text, &name.span(), why).of_field("name");
            found.name = nameable(name.get_ref()).map_err(wrong)?.to_owned();
        }
        if let Some(Spin::Speed(spin)) = self.table.spin.as_ref().map(Spanned::get_ref) {
            let why = format!("{spin} rad/s is not above zero and finite");
            self.unless(*spin > 0.0 && spin.is_finite(), "spin", why)?;
            found.spin = Some(*spin);
        }
        self.placed(found)
    }

    /// Of the fields that make a body large or small, that whose number is the farthest from 1.
    fn extreme(&self) -> &'static str {
        let t = self.table;
        let one = |field: &Option<Spanned<f64>>| vec![number(field)];
        let list = |field: &Option<Spanned<[f64; 3]>>| field.iter().flat_map(|x| *x.get_ref()).collect();
        let sizes = [
            ("unit", one(&t.unit)),
            ("sides", t.sides.as_ref().map(|sides| sides.get_ref().clone()).unwrap_or_default()),
            ("semiaxes", list(&t.semiaxes)),
            ("vertices", t.vertices.iter().flat_map(|x| x.get_ref().as_flattened().to_vec()).collect()),
            ("radius", one(&t.radius)),
            ("height", one(&t.height)),
            ("length", one(&t.length)),
            ("moments", list(&t.moments)),
            ("mass", if self.by == "moments" { one(&t.mass) } else { Vec::new() }),
        ];
        let off = |sizes: &[f64]| {
            sizes.iter().filter(|x| **x != 0.0).map(|x| x.abs().log10().abs()).fold(0.0, f64::max)
        };
        let most = sizes.iter().max_by(|a, b| off(&a.1).total_cmp(&off(&b.1)));
        most.filter(|(_, sizes)| off(sizes) > 0.0).map_or(self.by, |(name, _)| name)
    }

    fn weight(&self) -> Result<Weight, Error> {
        match (&self.table.mass, &self.table.density) {
            (Some(mass), None) => Ok(Weight::Mass(*mass.get_ref())),
            (None, Some(density)) => Ok(Weight::Density(*density.get_ref())),
            (None, None) => {
                Err(self.wrong(self.by, "`mass` (kg) or `density` (kg/m³) is missing, which goes with it"))
            }
            (Some(_), Some(_)) => {
                Err(self.wrong("density", "either `mass` or `density` is expected, not both"))
            }
        }
    }

    fn shape(&self) -> Result<BodyModel, Error> {
        let name = self.table.shape.as_ref().map_or("box", |shape| shape.get_ref());
        let needed = self.sizes_of(name)?;
        let absent = |field: &&&str| **field != "inner" && self.present.iter().all(|p| p.0 != **field);
        if let Some(missing) = needed.iter().find(absent) {
            return Err(self.wrong(self.by, format!("`{missing}` is missing, which a {name} has")));
        }
        let sides = self.sides(if name == "plate" { 2 } else { 3 })?;
        let (properties, surface) =
            shaped(name, self.table, &sides, self.weight()?).map_err(|error| self.refused(&error))?;
        let question = question::of(self.text, &self.present, name, needed);
        let sides = if name == "box" { sides.try_into().ok() } else { None };
        Ok(BodyModel { sides, question, ..BodyModel::of(properties, vec![surface]) })
    }

    /// The sides, which must be of this number; none where there are none.
    fn sides(&self, count: usize) -> Result<Vec<f64>, Error> {
        match &self.table.sides {
            Some(sides) if sides.get_ref().len() != count => {
                let hint = decimal_comma(self.text, sides.span().start);
                let found = sides.get_ref().len();
                Err(self.wrong("sides", format!("{count} numbers are expected here, not {found}{hint}")))
            }
            sides => Ok(sides.as_ref().map(|sides| sides.get_ref().clone()).unwrap_or_default()),
        }
    }

    fn points(&self) -> Result<BodyModel, Error> {
        let rows = self.table.points.as_ref().map(|points| points.get_ref().as_slice()).unwrap_or_default();
        let points: Vec<_> = rows.iter().map(|&[mass, x, y, z]| (mass, Vector3::new(x, y, z))).collect();
        let properties = MassProperties::of_points(&points).map_err(|error| self.wrong(self.by, error))?;
        let places = points.into_iter().map(|point| point.1).collect();
        Ok(BodyModel::of(properties, vec![Surface::points(places)]))
    }

    fn mesh(&self) -> Result<BodyModel, Error> {
        let file = self.table.mesh.as_ref().map_or("", |file| file.get_ref());
        let unit = self.table.unit.as_ref().map_or(1.0, |unit| *unit.get_ref());
        let why = format!("{unit} is not above 0 and finite");
        self.unless(unit > 0.0 && unit.is_finite(), "unit", why)?;
        let triangles = mesh::read(&self.files.folder.join(file), self.files);
        let (mut vertices, faces) = triangles.map_err(|error| self.wrong(self.by, error))?;
        for vertex in &mut vertices {
            *vertex *= unit;
        }
        let weight = self.weight()?;
        let properties = Mesh::new(&vertices, &faces).and_then(|mesh| weight.of(&mesh));
        let faces = faces.into_iter().map(|face| face.to_vec()).collect();
        let surface = Surface { vertices, faces, convex: false };
        Ok(BodyModel::of(properties.map_err(|error| self.refused(&error))?, vec![surface]))
    }

    fn parts(&self) -> Result<BodyModel, Error> {
        let (mut whole, mut surfaces, mut question, mut places) =
            (Compound::new(), Vec::new(), None, Vec::new());
        for part in self.table.part.iter().flat_map(Spanned::get_ref) {
            let span = part.span();
            let reader = Reader::new(self.text, part.get_ref(), &span, self.files)?;
            let found = reader.body()?;
            let of_whole = ["spin", "momentum", "attitude"];
            if let Some((field, _)) = reader.present.iter().find(|(field, _)| of_whole.contains(field)) {
                return Err(reader.wrong(field, "it is the whole body's, not a part's"));
            }
            let why = "`mass` (kg) is missing: a part without is no part";
            let mass = found.mass.ok_or_else(|| Error::at(self.text, &span, why))?;
            let of_part = MassProperties::new(mass, &found.centre, found.inertia);
            whole = whole.at(of_part.map_err(|error| self.wrong(self.by, error))?, &Vector3::zeros());
            let far = found.surfaces.iter().flat_map(|s| &s.vertices).map(|p| (p - found.centre).norm());
            places.push((found.centre, far.fold(0.0, f64::max)));
            surfaces.extend(found.surfaces);
            question = question.or(found.question);
            if surfaces.len() > MOST_PARTS {
                let why = format!("more than {MOST_PARTS} solids: no more are read");
                return Err(Error::at(self.text, &span, why).of_field("part"));
            }
        }
        let properties = whole.properties().map_err(|error| self.wrong(self.by, error))?;
        let question = question.or_else(|| question::apart(&places));
        Ok(BodyModel { question, ..BodyModel::of(properties, surfaces) })
    }

    fn moments(&self) -> Result<BodyModel, Error> {
        let (moments, products) = self.table.tensor().unwrap_or_default();
        let ([xx, yy, zz], [xy, xz, yz]) = (moments, products);
        let matrix = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let found = match &self.table.tolerance {
            Some(tolerance) => Inertia::within(&matrix, *tolerance.get_ref()),
            None => Inertia::try_from(matrix).map(|inertia| (inertia, 0.0)),
        };
        let alone = || products != [0.0; 3] && Inertia::from_moments(xx, yy, zz).is_ok();
        let (inertia, moved) = found.map_err(|error| match fields_of(error.subject()) {
            // The moments are right without the products.
            [] if alone() => self.wrong("products", error),
            _ => self.refused(&error),
        })?;
        let mass = self.table.mass.as_ref().map(|mass| *mass.get_ref());
        // Any mass will do where none is given: it is not kept.
        let properties = MassProperties::new(mass.unwrap_or(1.0), &Vector3::zeros(), inertia)
            .map_err(|error| self.refused(&error))?;
        let given = self.table.sides.is_some();
        let sides: Option<[f64; 3]> = if given { self.sides(3)?.try_into().ok() } else { None };
        // Sides say what is drawn.
        if let Some([a, b, c]) = sides {
            Cuboid::new(a, b, c).map_err(|error| self.wrong("sides", error))?;
        }
        let surfaces = sides.iter().map(|sides| Surface::cuboid(&(*sides).into())).collect();
        Ok(BodyModel { mass, moved, sides, ..BodyModel::of(properties, surfaces) })
    }

    fn urdf(&self) -> Result<BodyModel, Error> {
        let path = self.files.folder.join(self.table.urdf.as_ref().map_or("", |file| file.get_ref()));
        let link = self.table.link.as_ref().map(|link| link.get_ref().as_str());
        let tolerance = number(&self.table.tolerance);
        let why = format!("{tolerance} is not a finite number, zero or above");
        self.unless(tolerance >= 0.0 && tolerance.is_finite(), "tolerance", why)?;
        let read = || urdf::read(&self.files.text(&path)?, link, tolerance);
        self.files.body(&path, format!("{link:?} within {tolerance}"), read).map_err(|error| match link {
            // Without a line: not an element of the file, but the name that is not in it.
            Some(_) if error.line.is_none() && error.field.as_deref() == Some("link") => {
                self.wrong("link", error.why)
            }
            _ => self.wrong(self.by, error.in_file(&path)),
        })
    }

    /// A body of the book, or of another file.
    fn named(&self) -> Result<BodyModel, Error> {
        let name = self.table.body.as_ref().map_or("", |name| name.get_ref());
        // Of files in files the outermost and the innermost place are said.
        BodyModel::load_from(name, self.files).map_err(|error| match error.file {
            Some(_) if self.files.depth > 0 => error,
            _ => self.wrong(self.by, error),
        })
    }

    /// The body turned about the origin of its axes, then moved.
    fn placed(&self, mut found: BodyModel) -> Result<BodyModel, Error> {
        if let Some(turn) = &self.table.turn {
            let [x, y, z, degrees] = *turn.get_ref();
            let axis = nalgebra::Unit::try_new(Vector3::new(x, y, z), 0.0);
            let axis = axis.filter(|axis| axis.iter().all(|x| x.is_finite())).ok_or_else(|| {
                let why = "x, y and z must be a direction, of finite numbers that are not all zero";
                self.wrong("turn", why)
            })?;
            let attitude = UnitQuaternion::from_axis_angle(&axis, degrees.to_radians());
            found.inertia = found.inertia.turned(attitude).map_err(|error| self.wrong("turn", error))?;
            found.centre = attitude * found.centre;
            for surface in &mut found.surfaces {
                *surface = surface.mapped(|p| attitude * p);
            }
            found.sides = None;
        }
        if let Some(at) = &self.table.at {
            let place = Vector3::from(*at.get_ref());
            found.centre += place;
            self.unless(found.centre.iter().all(|x| x.is_finite()), "at", "the place must be finite")?;
            let reach = found.surfaces.iter().flat_map(|s| &s.vertices).map(|p| p.amax()).fold(0.0, f64::max);
            let near = found.surfaces.is_empty() || place.amax() <= FARTHEST * reach;
            self.unless(near, "at", "so far away that rounding would change its shape")?;
            for surface in &mut found.surfaces {
                *surface = surface.mapped(|p| p + place);
            }
        }
        Ok(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn body(text: &str) -> Result<BodyModel, Error> {
        BodyModel::from_toml(text, Path::new(""))
    }

    /// Two points on x: a quarter turn about z takes their centre from x to y.
    #[test]
    fn a_part_that_is_turned_takes_its_centre_along() {
        let part =
            "[[part]]\npoints = [[1, 0.5, 0, 0], [1, 1.5, 0, 0]]\nturn = [0, 0, 1, 90]\nat = [0, 0, 3]";
        let other = "[[part]]\nsides = [1, 2, 3]\nmass = 2";
        let found = body(&format!("{part}\n{other}")).unwrap();
        assert!((found.centre - Vector3::new(0.0, 0.5, 1.5)).norm() < 1e-15, "{}", found.centre);
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line_and_its_field() {
        for (text, words) in [
            ("sides = [1, 2, 3]", "line 1, `sides`: `mass` (kg) or `density` (kg/m³) is missing"),
            ("mass = 1", "line 1: what the body is is missing"),
            ("sides = [1, -2, 3]\nmass = 1", "line 1, `sides`: the edge along y is -2.0: it must be"),
            ("sides = [1, 2]\nmass = 1", "line 1, `sides`: 3 numbers are expected here, not 2"),
            ("mass = 1\nshape = 'bal'\nradius = 1", "line 2, `shape`: no shape is called `bal`; there"),
            ("mass = 1\nshape = 'tube'\nradius = 1", "; a tube is a cylinder with `inner`"),
            ("mass = '12.5'\nsides = [1, 2, 3]", "not `12.5`: the unit is missing"),
            (
                "body = 'book'\nturn = { x = 1 }",
                "`turn`: a list is expected here, not map; write turn = [x, y",
            ),
            (
                "mass = 1\nshape = 'ball'\nheight = 1",
                "line 3, `height`: it does not go with `ball`, which takes `radius`, `inner`, `mass`, `density`",
            ),
            ("mass = 1\nshape = 'cone'\nheight = 1", "line 2, `shape`: `radius` is missing"),
            ("mass = 1\nshape = 'ball'\nradius = 1\ninner = 2", "line 4, `inner`: the inner radius"),
            ("moments = [1, 2, 3.1]", "line 1, `moments`: no body has principal moments"),
            ("moments = [1, 2, 2]\nmass = 0", "line 2, `mass`: the mass is 0.0: it must be above zero"),
            ("moments = [1, 2, nan]", "line 1, `moments`"),
            ("density = '7 kg'\nsides = [1, 2, 3]", "such as \"0.7 g/cm3\", not `7 kg`"),
            ("mass = 'a'", "`mass`: a number is expected here, or one with its unit such as \"200 g\""),
            ("sides = ['1 m', '2 g', 3]\nmass = 1", "line 1, `sides`: a number is expected here, or one"),
            ("shape = 'ball'\nradius = 0,07\nmass = 1", "; write 0.07"),
            ("shape = 'ball'\nradius = '7,5 cm'\nmass = 1", "not `7,5 cm`; write '7.5 cm'"),
            ("sides = [7,7, 0.78, 16]\nmass = 1", "3 numbers are expected here, not 4; write 7.7"),
            ("moments = [1, 2]", "line 1, `moments`: 3 numbers are expected here, not 2"),
            ("moments = [1, 2, 2.5, 0]", "line 1, `moments`: 3 numbers are expected here, not 4"),
            ("moments = [1, 2, 2.5]\nproducts = [0, 0, 0, 1]", "line 2, `products`: 3 numbers are expected"),
            ("points = [[1, 0, 0, 0, 9]]", "line 1, `points`: 4 numbers are expected here, not 5"),
            ("shape = 'tetrahedron'\nvertices = [[0, 0, 0]]", "line 2, `vertices`: 4 lists of 3 numbers"),
            ("shape = 3", "line 1, `shape`: a string is expected here, not integer `3`"),
            ("[[part]]\nmass = [1]", "line 2, `mass`: a number is expected here, or a text with its unit"),
            ("[[part]]\nmomets = [1]", "line 2, `momets`: no such field. Did you mean `moments`?"),
            ("[[part]]\nmoments = [1, 2, 3]", "line 1: `mass` (kg) is missing"),
            ("[[part]]\nsides = [1, 2, 3]\nmass = 1\nturn = [0, 0, 0, 1]", "line 4, `turn`: x, y and z"),
            ("mesh = 'none.stl'\nmass = 1", "line 1, `mesh`: none.stl: it cannot be read"),
            ("mass = 1\nshape = 'rod'\nlength = 1", "line 2, `shape`: the smallest principal moment, 0.0"),
            ("moments = [0, 0, 0]\nproducts = [0.1, 0, 0]", "line 1, `moments`: the largest moment of"),
            ("moments = [1, 2, 2.5]\nproducts = [5, 0, 0]", "line 2, `products`: the smallest principal"),
            (
                "[part]\nsides = [1, 2, 3]",
                "line 1, `part`: a list is expected here, not map: each table of a list begins with `[[part]]`",
            ),
            (
                "[[body]]\nmoments = [1, 2, 3]",
                "line 1, `body`: a string is expected here, not sequence: each",
            ),
            ("spin = 0\nmoments = [1, 2, 2]", "line 1, `spin`: 0 rad/s is not above zero"),
            ("[[part]]\nsides = [1, 2, 3]\nmass = 1\nspin = 1", "line 4, `spin`: it is the whole body's"),
            ("points = [[1, 0, 0, 0]]", "line 1, `points`"),
            ("mass = 1\nname = \"a\\u0000b\"\nsides = [1, 2, 3]", "line 2, `name`: '\\0' is not a character"),
            (
                &format!("name = '{}'\nsides = [1, 2, 3]\nmass = 1", "n".repeat(2_000_000)),
                "line 1, `name`: a name of 2000000 characters: at most 100",
            ),
            ("sides = [1, 2, 3]\nmass = 1\nattitude = [1, 0, 0, 0]", "line 3, `attitude`: it is of a body"),
            ("moments = [1, 2, 1e-400]", "line 1, `moments`: 1e-400 is closer to zero"),
            ("sides = [1, 2, 3]\nmass = 1\nat = [1e300, 0, 0]", "line 3, `at`: so far away that rounding"),
        ] {
            let error = body(text).unwrap_err().to_string();
            assert!(error.contains(words), "{text}\n{error}");
        }
    }

    #[test]
    fn a_size_or_a_mass_may_have_its_unit_and_a_number_that_lacks_it_is_questioned() {
        let metres = body("sides = [0.077, 0.0078, 0.16]\nmass = 0.2").unwrap();
        let mixed = body("sides = ['77 mm', '7.8mm', '16 cm']\nmass = '200 g'").unwrap();
        assert!(
            (mixed.inertia.matrix() - metres.inertia.matrix()).amax()
                < 1e-15 * metres.inertia.matrix().amax()
        );
        assert_eq!((mixed.mass, mixed.question, metres.question), (Some(0.2), None, None));
        let both = "cm and kg, or in mm and g";
        for (sides, mass, units) in [
            ("7.7, 0.78, 16", "0.2", both),
            ("7.7, 0.78, 16", "200", "cm and g"),
            ("77, 7.8, 160", "200", "mm and g, or in cm and kg"),
            ("0.077, 0.0078, 0.16", "200", "m and g"),
        ] {
            let question = |head| body(&format!("{head}sides = [{sides}]\nmass = {mass}")).unwrap().question;
            let asked = format!("{mass} kg in {} m: is this in {units}?", sides.replace(',', " ×"));
            assert_eq!([question(""), question("[[part]]\n")], [Some(asked.clone()), Some(asked)]);
        }
        for (text, asked) in [
            ("radius = 33\nmass = 0.058", "0.058 kg in 33 m: is this in mm and kg?"),
            ("radius = '33 mm'\nmass = 58", "58 kg in 33 mm: is this in g?"),
            ("radius = 33\nmass = '58 g'", "58 g in 33 m: is this in mm?"),
            (
                "radius = '3 cm'\nmass = '300 kg'",
                "300 kg in 3 cm: no solid is so light or so heavy. Are the numbers right?",
            ),
            (
                "radius = 1\ndensity = 90000",
                "90000 kg/m³: no solid is so light or so heavy. Are the numbers right?",
            ),
            ("radius = 1\ndensity = 0.7", "0.7 kg/m³: is this in g/cm3?"),
            (
                "radius = 1\nmass = 1e30",
                "1e30 kg in 1 m: no solid is so light or so heavy. Are the numbers right?",
            ),
        ] {
            assert_eq!(body(&format!("shape = 'ball'\n{text}")).unwrap().question.unwrap(), asked);
        }
        let one = body("sides = ['77 mm', 7.8, '160 mm']\nmass = '200 g'").unwrap().question.unwrap();
        assert_eq!(one, "200 g in 77 mm × 7.8 m × 160 mm: is this in mm, or in cm?");
        // A head of 3 cm on a handle of 34 cm, its place without a unit.
        let racket = |at| {
            body(&format!(
                "[[part]]\nshape = 'ball'\nradius = '3 cm'\nmass = '0.1 kg'\nat = [0, 0, {at}]\n[[part]]\nsides = ['3 cm', '3 cm', '34 cm']\nmass = '0.1 kg'"
            ))
        };
        assert_eq!(racket("0.2").unwrap().question, None);
        let far = racket("-15").unwrap().question.unwrap();
        assert_eq!(far, "a part 0.06 m large lies 15 m from the others: is its place in cm, or in mm?");
        let wood = body("sides = [1, 2, 3]\ndensity = '0.7 g/cm3'").unwrap();
        assert!((wood.mass.unwrap() - 4200.0).abs() < 1e-9 && wood.question.is_none());
        // A satellite is light, and of a thin plate nothing is known.
        for text in ["sides = [2, 2, 4]\nmass = 160", "shape = 'plate'\nsides = [2, 1]\nmass = 0.001"] {
            assert_eq!(body(text).unwrap().question, None, "{text}");
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
