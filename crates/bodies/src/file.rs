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
use std::collections::BTreeMap;
use std::fmt::Display;
use std::ops::Range;
use toml::Spanned;
use tumbling::solid::{Compound, Cuboid, Mesh, Solid as _};
use tumbling::{ErrorKind, Inertia, MassProperties};

/// The largest number of parts of a body, and of solids including those in the files that its parts name.
const MOST_PARTS: usize = 10_000;

pub(crate) fn read(text: &str, files: &Files<'_>) -> Result<BodyModel, Error> {
    let table = Spanned::new(0..0, from_toml::<Table>(text)?);
    for (field, span) in table.get_ref().present() {
        let in_scene = matches!(table.get_ref().spin.as_ref().map(Spanned::get_ref), Some(Spin::Vector(_)));
        if ["momentum", "attitude"].contains(&field) || (field == "spin" && in_scene) {
            let why = "it is of a body in a scene: here, `spin` is one number";
            return Err(Error::at(text, &span, why).of_field(field));
        }
    }
    let reader = Reader::new(text, &table, files)?;
    reader.body()?.ready().map_err(|error| reader.wrong(reader.by, error.why))
}

/// What a table says, and where.
pub(crate) struct Reader<'a> {
    text: &'a str,
    files: &'a Files<'a>,
    table: &'a Table,
    span: Range<usize>,
    present: Vec<(&'static str, Range<usize>)>,
    /// The one field that says what the body is.
    by: &'static str,
}

pub(crate) fn number(field: &Option<Spanned<f64>>) -> f64 {
    field.as_ref().map_or(0.0, |x| *x.get_ref())
}

impl<'a> Reader<'a> {
    /// For a table of a text.
    pub(crate) fn new(text: &'a str, table: &'a Spanned<Table>, files: &'a Files<'a>) -> Result<Self, Error> {
        let (span, table) = (table.span(), table.get_ref());
        let (count, depth) = table.parts();
        let first = table.part.as_ref().map_or(0..0, Spanned::span);
        let deep = "bodies, one the part of the other";
        for (found, of, most) in [(count, "parts", MOST_PARTS), (depth, deep, DEEPEST)] {
            if found > most {
                let why = format!("{found} {of}: at most {most} are read");
                return Err(Error::at(text, &first, why).of_field("part"));
            }
        }
        let present = table.present();
        let has = |name: &str| present.iter().any(|(field, _)| *field == name);
        let Some((by, with)) = GIVEN_BY.into_iter().find(|(name, _)| has(name)) else {
            let all = GIVEN_BY.map(|(name, _)| format!("`{name}`")).join(", ");
            let why = format!("what the body is is missing: one of {all}");
            return Err(Error::at(text, &span, why));
        };
        let reader = Self { text, files, table, span, present, by };
        let sizes = match &table.shape {
            Some(shape) => reader.kind(shape.get_ref())?.1,
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

    /// An error at a field, or at the head of the table if it has no field of this name.
    fn wrong(&self, field: &str, why: impl Display) -> Error {
        let span = self.present.iter().find(|(name, _)| *name == field).map_or(&self.span, |(_, span)| span);
        Error::at(self.text, span, why).of_field(field)
    }

    /// Checks a field, and says what is wrong with it.
    fn unless(&self, right: bool, field: &str, why: impl Display) -> Result<(), Error> {
        if right { Ok(()) } else { Err(self.wrong(field, why)) }
    }

    /// The first of these fields that is present, or the one that says what the body is.
    fn blamed(&self, fields: &[&'static str]) -> &'static str {
        let has = |field: &&&str| self.present.iter().any(|(name, _)| name == *field);
        fields.iter().find(has).copied().unwrap_or(self.by)
    }

    /// An error of the library, at the field that it is about or at the one that says what the body is.
    fn refused(&self, error: &tumbling::Error) -> Error {
        // A surface that bounds nothing does so in any unit.
        let at = if error.kind() != ErrorKind::BadMesh { fields_of(error.subject()) } else { &["vertices"] };
        self.wrong(self.blamed(at), error)
    }

    fn kind(&self, shape: &str) -> Result<(&str, &'static [&'static str], &str), Error> {
        KINDS.into_iter().find(|kind| kind.0 == shape).ok_or_else(|| {
            let names = KINDS.map(|kind| kind.0).join(", ");
            let why =
                format!("no shape is called `{shape}`; there are {names}; a tube is a cylinder with `inner`");
            self.wrong("shape", why)
        })
    }

    /// The body, placed and turned.
    pub(crate) fn body(&self) -> Result<BodyModel, Error> {
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
            found.name = nameable(name.get_ref()).map_err(|why| self.wrong("name", why))?.to_owned();
        }
        if let Some(Spin::Speed(spin)) = self.table.spin.as_ref().map(Spanned::get_ref) {
            let why = format!("{spin} rad/s is not above zero and finite");
            self.unless(*spin > 0.0 && spin.is_finite(), "spin", why)?;
            found.spin = Some(*spin);
        }
        self.placed(found)
    }

    /// Among the fields that make a body large or small, the one whose number is farthest from 1.
    fn extreme(&self) -> &'static str {
        let sizes = ["unit", "sides", "semiaxes", "vertices", "radius", "height", "length", "moments"];
        let counts = |field: &str| sizes.contains(&field) || (field == "mass" && self.by == "moments");
        let off = |(_, span): &&(&str, Range<usize>)| {
            let words = self.text[span.clone()].split(|c: char| !c.is_alphanumeric() && !"+-.".contains(c));
            let numbers = words.map(|word| word.trim_end_matches(char::is_alphabetic).parse().unwrap_or(0.0));
            numbers.filter(|x| *x != 0.0).map(|x: f64| x.abs().log10().abs()).fold(0.0, f64::max)
        };
        let fields = self.present.iter().filter(|(field, _)| counts(field));
        fields.max_by(|a, b| off(a).total_cmp(&off(b))).map_or(self.by, |(field, _)| *field)
    }

    /// Its mass, or its density in the unit `per`.
    fn weight(&self, per: &str) -> Result<Weight, Error> {
        let none = format!("`mass` (kg) or `density` ({per}) is missing, which goes with it");
        let both = "either `mass` or `density` is expected, not both";
        match (&self.table.mass, &self.table.density) {
            (Some(mass), None) => Ok(Weight::Mass(*mass.get_ref())),
            (None, Some(density)) => {
                let fits = per == "kg/m³" || question::bare(&self.text[density.span()]);
                self.unless(fits, "density", format!("a number in {per} is expected here, without a unit"))?;
                Ok(Weight::Density(*density.get_ref()))
            }
            (None, None) => Err(self.wrong(self.by, none)),
            (Some(_), Some(_)) => Err(self.wrong("density", both)),
        }
    }

    fn shape(&self) -> Result<BodyModel, Error> {
        let name = self.table.shape.as_ref().map_or("box", |shape| shape.get_ref());
        let (_, needed, per) = self.kind(name)?;
        let absent = |field: &&&str| **field != "inner" && self.present.iter().all(|p| p.0 != **field);
        if let Some(missing) = needed.iter().find(absent) {
            return Err(self.wrong(self.by, format!("`{missing}` is missing, which a {name} has")));
        }
        let sides = self.sides(if name == "plate" { 2 } else { 3 })?;
        let (properties, surface) =
            shaped(name, self.table, self.weight(per)?).map_err(|error| self.refused(&error))?;
        let question = question::of(self.text, &self.present, name, needed);
        Ok(BodyModel { sides: sides.try_into().ok(), question, ..BodyModel::of(properties, vec![surface]) })
    }

    /// The sides, which must be this many; `None` if there are none.
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
        // Where a heavy point has a light one far away, what is drawn is larger than a ring would be.
        let question = question::spread(&BodyModel::of(properties, Vec::new()));
        Ok(BodyModel { question, ..BodyModel::of(properties, vec![Surface::points(places)]) })
    }

    fn mesh(&self) -> Result<BodyModel, Error> {
        let file = self.table.mesh.as_ref().map_or("", |file| file.get_ref());
        let unit = self.table.unit.as_ref().map_or(1.0, |unit| *unit.get_ref());
        let why = format!("{unit} is not above 0 and finite");
        self.unless(unit > 0.0 && unit.is_finite(), "unit", why)?;
        let triangles = mesh::read(&self.files.folder.join(file), self.files);
        let (mut vertices, mut faces) = triangles.map_err(|error| self.wrong(self.by, error))?;
        let finite = vertices.iter().flatten().all(|x| x.is_finite());
        self.unless(finite, self.by, "a number of a vertex is not finite")?;
        vertices.iter_mut().for_each(|vertex| *vertex *= unit);
        let weight = self.weight("kg/m³")?;
        // A surface that is closed as listed stays as listed, even where vertices of it touch.
        if Mesh::new(&vertices, &faces).is_err() {
            mesh::weld(&vertices, &mut faces);
        }
        let mesh = Mesh::new(&vertices, &faces).map_err(|error| self.refused(&error))?;
        let properties = weight.of(&mesh).map_err(|error| self.refused(&error))?;
        let question = match (&self.table.density, self.table.unit.is_some()) {
            (Some(_), _) => question::of(self.text, &self.present, self.by, &[]),
            (None, set) => question::filled(properties.mass(), mesh.measure().unwrap_or_default(), set),
        };
        let faces = faces.into_iter().map(|face| face.to_vec()).collect();
        let surface = Surface { vertices, faces, convex: false };
        Ok(BodyModel { question, ..BodyModel::of(properties, vec![surface]) })
    }

    fn parts(&self) -> Result<BodyModel, Error> {
        let (mut whole, mut question, mut links) = (Compound::new(), None, BTreeMap::new());
        let (mut surfaces, mut places, mut moved) = (Vec::new(), Vec::new(), 0.0_f64);
        let parts = self.table.part.as_ref().map_or(&[][..], |parts| parts.get_ref());
        for part in parts {
            let span = part.span();
            let reader = Reader::new(self.text, part, self.files)?;
            let found = reader.body()?;
            let of_whole = ["spin", "momentum", "attitude"];
            if let Some((field, _)) = reader.present.iter().find(|(field, _)| of_whole.contains(field)) {
                return Err(reader.wrong(field, "it is the whole body's, not a part's"));
            }
            let why = "`mass` (kg) is missing: a part without is no part";
            let mass = found.mass.ok_or_else(|| Error::at(self.text, &span, why))?;
            let of_part = MassProperties::new(mass, &found.centre, found.inertia);
            let of_part = of_part.map_err(|error| self.wrong(self.by, error))?;
            whole = whole.at(of_part, &Vector3::zeros());
            let far = found.surfaces.iter().flat_map(|s| &s.vertices).map(|p| (p - found.centre).norm());
            places.push((of_part, far.fold(0.0, f64::max)));
            surfaces.extend(found.surfaces);
            question = question.or(found.question);
            moved = moved.max(found.moved);
            for (link, (count, held)) in found.links {
                let (all, _) = links.entry(link).or_insert((0_usize, held));
                *all = all.saturating_add(count);
            }
            if surfaces.len() > MOST_PARTS {
                let why = format!("more than {MOST_PARTS} solids: no more are read");
                return Err(Error::at(self.text, &span, why).of_field("part"));
            }
        }
        let properties = whole.properties().map_err(|error| self.wrong(self.by, error))?;
        let question = question.or_else(|| question::placed(&places));
        Ok(BodyModel { moved, question, links, ..BodyModel::of(properties, surfaces) })
    }

    fn moments(&self) -> Result<BodyModel, Error> {
        let ([xx, yy, zz], products @ [xy, xz, yz]) = self.table.tensor().unwrap_or_default();
        let matrix = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let found = within(matrix, self.table.tolerance.as_ref().map(|tolerance| *tolerance.get_ref()));
        let alone = || products != [0.0; 3] && Inertia::from_moments(xx, yy, zz).is_ok();
        let (inertia, moved) = found.map_err(|error| match fields_of(error.subject()) {
            // The moments are right without the products.
            [] if alone() => self.wrong("products", error),
            _ => self.refused(&error),
        })?;
        let mass = self.table.mass.as_ref().map(|mass| *mass.get_ref());
        // If no mass is given, any mass serves: it is not stored.
        let properties = MassProperties::new(mass.unwrap_or(1.0), &Vector3::zeros(), inertia)
            .map_err(|error| self.refused(&error))?;
        let sides: Option<[f64; 3]> = self.sides(3)?.try_into().ok();
        // Sides determine what is drawn.
        if let Some([a, b, c]) = sides {
            Cuboid::new(a, b, c).map_err(|error| self.wrong("sides", error))?;
        }
        let surfaces = sides.iter().map(|sides| Surface::cuboid(&(*sides).into())).collect();
        let model = BodyModel { mass, moved, sides, ..BodyModel::of(properties, surfaces) };
        Ok(BodyModel { question: question::spread(&model), ..model })
    }

    fn urdf(&self) -> Result<BodyModel, Error> {
        let path = self.files.folder.join(self.table.urdf.as_ref().map_or("", |file| file.get_ref()));
        let link = self.table.link.as_ref().map(|link| link.get_ref().as_str());
        let tolerance = number(&self.table.tolerance);
        let why = format!("{tolerance} is not a finite number, zero or above");
        self.unless(tolerance >= 0.0 && tolerance.is_finite(), "tolerance", why)?;
        let meant = format!("{link:?} within {tolerance}");
        let read = || urdf::read(&self.files.text(&path)?, link, &path, tolerance);
        self.files.body(&path, meant, read).map_err(|error| match link {
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
        // For nested files, the error states the outermost and the innermost line.
        BodyModel::load_from(name, self.files).map_err(|error| match error.file {
            Some(_) if self.files.depth > 0 && error.line.is_some() => error,
            _ => self.wrong(self.by, error),
        })
    }

    /// The body turned about the origin of its axes, then moved.
    fn placed(&self, mut found: BodyModel) -> Result<BodyModel, Error> {
        if let Some(turn) = &self.table.turn {
            let [x, y, z, degrees] = *turn.get_ref();
            let (axis, why) = (Vector3::new(x, y, z), "x, y and z must be a direction: they are all zero");
            // By its largest component, so that no square leaves the range.
            let axis = nalgebra::Unit::try_new(axis / axis.amax(), 0.0);
            let axis = axis.ok_or_else(|| self.wrong("turn", why))?;
            found.question = found.question.or_else(|| question::turned(degrees));
            let attitude = UnitQuaternion::from_axis_angle(&axis, (degrees % 360.0).to_radians());
            found.inertia = found.inertia.turned(attitude).map_err(|error| self.wrong("turn", error))?;
            found.centre = attitude * found.centre;
            found.surfaces.iter_mut().for_each(|surface| *surface = surface.mapped(|p| attitude * p));
            found.sides = None;
        }
        if let Some(at) = &self.table.at {
            let place = Vector3::from(*at.get_ref());
            found.centre += place;
            self.unless(found.centre.iter().all(|x| x.is_finite()), "at", "the place must be finite")?;
            let reach = found.surfaces.iter().flat_map(|s| &s.vertices).map(|p| p.amax()).fold(0.0, f64::max);
            let near = found.surfaces.is_empty() || place.amax() <= FARTHEST * reach;
            self.unless(near, "at", "so far away that rounding would change its shape")?;
            found.surfaces.iter_mut().for_each(|surface| *surface = surface.mapped(|p| p + place));
        }
        Ok(found)
    }
}

/// The tensor of a matrix, and how far it was moved: by at most the tolerance, and not at all without one.
pub(crate) fn within(matrix: Matrix3<f64>, most: Option<f64>) -> Result<(Inertia, f64), tumbling::Error> {
    let as_given = || Inertia::try_from(matrix).map(|inertia| (inertia, 0.0));
    most.map_or_else(as_given, |most| Inertia::within(&matrix, most))
}

#[cfg(test)]
mod tests;
