//! A body by its name or by its file.

use crate::error::Error;
use crate::file::Reader;
use crate::files::{Files, Read};
use crate::model::{BodyModel, word};
use crate::surface::Surface;
use crate::table::Table;
use crate::{file, urdf};
use nalgebra::{Rotation3, Vector3};
use std::path::Path;
use toml::Spanned;
use tumbling::body::named::{NamedBody, Part, Section};

impl BodyModel {
    /// A body of the library by its name (`box`, `book`, `phone`, `remote-control`, `hammer`,
    /// `tennis-racket`, `wing-nut`, `t-handle`; `racket` and `the wing nut` will do), or from a file:
    /// `FILE.toml`, `FILE.urdf`, or `FILE.urdf#LINK`.
    ///
    /// # Errors
    /// A file that cannot be read, with the line, the field and the rule that it breaks; an unknown name.
    ///
    /// ```
    /// use tumbling_bodies::BodyModel;
    /// for called in ["wing-nut", "The wing nut", "wingnut", "nut"] {
    ///     assert_eq!(BodyModel::load(called)?.name, "the wing nut");
    /// }
    /// // One word alone is enough, so that the body says which one it is.
    /// assert_eq!(BodyModel::load("control")?.question.unwrap(), "`control`: this is the remote control");
    /// assert_eq!(BodyModel::load("remote control")?.question, None);
    /// assert!(BodyModel::load("hamer").unwrap_err().to_string().contains("`hammer`"));
    /// # Ok::<(), tumbling_bodies::Error>(())
    /// ```
    pub fn load(argument: &str) -> Result<Self, Error> {
        Self::load_from(argument, &Files::new(Path::new(""), &Read::default())).map(urdf::asked)
    }

    /// Like [`load`](Self::load), with paths relative to a folder.
    pub(crate) fn load_from(argument: &str, files: &Files<'_>) -> Result<Self, Error> {
        // The name, however its words are joined, or one of them alone.
        let called = argument.to_lowercase().replace("the ", "").replace(['-', ' ', '_'], "");
        let plain = |body| word(body).replace('-', "");
        let is = |&body: &NamedBody| word(body).split('-').any(|one| one == called) || plain(body) == called;
        if let Some(body) = NamedBody::ALL.into_iter().find(is) {
            let near = (plain(body) != called).then(|| format!("`{argument}`: this is {body}"));
            return Ok(Self { question: near, ..Self::named(body)? });
        }
        let (path, link) = argument.split_once('#').map_or((argument, None), |(a, b)| (a, Some(b)));
        let path = files.folder.join(path);
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());

        let here = |error: Error| error.in_file(&path);
        let mut model = files.body(&path, format!("{link:?}"), || match ending.as_deref() {
            Some("toml") if link.is_some() => Err(here(Error::new("`#` names a link of a robot, in a file that ends in .urdf"))),
            Some("toml") => {
                let (text, files) = (files.text(&path)?, files.next_to(&path)?);
                file::read(&text, &files).map_err(here)
            }
            Some("urdf" | "xml") => {
                let read = urdf::read(&files.text(&path)?, link, &path, 0.0);
                read.and_then(Self::ready).map_err(here)
            }
            Some("stl" | "obj") => Err(here(Error::new(
                "a mesh alone does not say what it weighs: name it in a TOML file, `mesh = \"...\"` with `mass = ...` (kg)",
            ))),
            _ => {
                let names = NamedBody::ALL.map(|body| format!("`{}`", word(body))).join(", ");
                Err(Error::new(format!(
                    "`{argument}` is neither a body of the book ({names}) nor a file that ends in .toml or .urdf; \
                     examples/bodies has a coin and others"
                )))
            }
        })?;
        if model.name.is_empty() {
            model.name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        }
        Ok(model)
    }

    /// A body of the library.
    ///
    /// # Errors
    /// There are none: the sizes are constants.
    pub fn named(body: NamedBody) -> Result<Self, Error> {
        let (properties, mut surfaces, mut sides) = (body.properties()?, Vec::new(), None);
        body.each_part(&mut |part| {
            surfaces.push(bar(&part));
            let long = part.along.norm();
            sides = match part.section {
                Section::Rectangle { wide, thick } if surfaces.len() == 1 => Some([wide, thick, long]),
                _ => None,
            };
        });
        Ok(Self { name: body.to_string(), sides, ..Self::of(properties, surfaces) })
    }

    /// From the text of a TOML file; the files that it names lie in `folder`. The name is empty where
    /// the file has none.
    ///
    /// # Errors
    /// The line, the field and the rule that it breaks.
    pub fn from_toml(text: &str, folder: &Path) -> Result<Self, Error> {
        file::read(text, &Files::new(folder, &Read::default())).map(urdf::asked)
    }

    /// Refuses an ideal rod, since its momentum does not determine its spin about its own axis.
    pub(crate) fn ready(self) -> Result<Self, Error> {
        self.inertia.inverse()?;
        self.moments().map(|_| self)
    }
}

/// Makes bodies from the tables of one text; the limits on files apply to all of them together.
#[derive(Debug)]
pub struct SceneBodies<'a> {
    text: &'a str,
    folder: &'a Path,
    read: Read,
}

impl<'a> SceneBodies<'a> {
    /// For tables of this text; the files that they name are in `folder`.
    #[must_use]
    pub fn new(text: &'a str, folder: &'a Path) -> Self {
        Self { text, folder, read: Read::default() }
    }

    /// The tensor about the centre of mass: moments (xx, yy, zz) and products (xy, xz, yz), kg m². A table of
    /// these alone is not checked.
    ///
    /// # Errors
    /// The line, the field and the rule that it breaks.
    pub fn tensor(&self, table: &Spanned<Table>) -> Result<([f64; 3], [f64; 3]), Error> {
        let of_start = ["name", "moments", "products", "spin", "momentum", "attitude"];
        let alone = table.get_ref().present().iter().all(|(field, _)| of_start.contains(field));
        if let Some(tensor) = table.get_ref().tensor().filter(|_| alone) {
            return Ok(tensor);
        }
        let files = Files::new(self.folder, &self.read);
        let reader = Reader::new(self.text, table, &files)?;
        let matrix = reader.body()?.inertia.matrix();
        let products = [(0, 1), (0, 2), (1, 2)].map(|place| matrix[place]);
        Ok((matrix.diagonal().into(), products))
    }
}

/// A part of a named body, in the body's axes.
fn bar(part: &Part) -> Surface {
    let length = part.along.norm();
    let straight = match part.section {
        Section::Line => Surface::line(length),
        Section::Rectangle { wide, thick } => Surface::cuboid(&Vector3::new(wide, thick, length)),
        Section::Round { radius } => Surface::cylinder(0.0, radius, length),
        Section::Ring { inner, outer } => Surface::cylinder(inner, outer, length),
    };
    let angle = part.along.x.atan2(part.along.z);
    let turn = Rotation3::from_axis_angle(&Vector3::y_axis(), angle);
    straight.mapped(|p| turn * p + part.middle)
}
