//! A body for figures, films and reports.

use crate::error::Error;
use crate::surface::{Surface, drawable};
use nalgebra::{Matrix3, Vector3};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use tumbling::body::named::NamedBody;
use tumbling::{Inertia, MassProperties, PrincipalAxes, PrincipalMoments};

/// A body with a name, ready to be spun and drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyModel {
    /// As in "the book": the `name` in its file, or the file's own name.
    pub name: String,
    /// kg, where it is known.
    pub mass: Option<f64>,
    /// The centre of mass, m, from the origin of the body's axes; zero if it is not given.
    pub centre: Vector3<f64>,
    /// About the centre of mass, in the body's axes. All three principal moments are above zero.
    pub inertia: Inertia,
    /// How far the tensor was moved to become possible, relative to its largest moment; of several parts, the
    /// farthest. Zero unless the file has a `tolerance`.
    pub moved: f64,
    /// The surfaces to draw, in the body's axes, m. Empty if only numbers are known.
    pub surfaces: Vec<Surface>,
    /// The spin in figures and films, rad/s, if the file gives it.
    pub spin: Option<f64>,
    /// The edges along x, y and z of a body that is one box, m.
    pub sides: Option<[f64; 3]>,
    /// A question to the user if the input is unlikely to be intended: units, judged by the density; degrees
    /// instead of rad or the reverse; moments or sizes that do not fit the mass; parts that are far away or
    /// twice in one place; links that fixed joints attach to this one. Or which body one word of its name
    /// was taken for.
    pub question: Option<String>,
    /// The links of robots that it consists of: how often it has each, and the links with inertia that fixed
    /// joints attach to it.
    pub(crate) links: BTreeMap<Link, (usize, Arc<[Link]>)>,
}

/// A robot's file, and the name of a link in it.
pub(crate) type Link = (PathBuf, String);

impl BodyModel {
    /// Without a name and a spin.
    pub(crate) fn of(properties: MassProperties, surfaces: Vec<Surface>) -> Self {
        Self {
            name: String::new(),
            mass: Some(properties.mass()),
            centre: properties.centre(),
            inertia: properties.inertia(),
            moved: 0.0,
            surfaces,
            spin: None,
            sides: None,
            question: None,
            links: BTreeMap::new(),
        }
    }

    /// The principal moments (kg m², smallest first) and axes.
    #[must_use]
    pub fn principal(&self) -> PrincipalAxes {
        self.inertia.principal()
    }

    /// The principal moments, smallest first.
    ///
    /// # Errors
    /// There are none for a model that was read.
    pub fn moments(&self) -> Result<PrincipalMoments, Error> {
        Ok(self.principal().moments().try_into()?)
    }

    /// The box of uniform density with this mass and the body's tensor: its edges along the principal axes,
    /// smallest moment first, m.
    fn even_box(&self, mass: f64) -> Vector3<f64> {
        let moments = self.principal().moments();
        moments.map(|moment| (12.0 * (0.5 * moments.sum() - moment).max(0.0) / mass).sqrt())
    }

    /// What is drawn, from the centre of mass: its own surfaces; else the box of uniform density with the
    /// same mass and tensor; else a box with these proportions and a longest edge of 1.
    ///
    /// ```
    /// use tumbling_bodies::BodyModel;
    /// let even = BodyModel::from_toml("moments = [13, 5, 10]\nmass = 12", "".as_ref())?;
    /// // Of 1 x 3 x 2 m.
    /// let corner = even.drawn()[0].vertices[0].abs();
    /// assert!((corner * 2.0 - nalgebra::Vector3::new(1.0, 3.0, 2.0)).amax() < 1e-14);
    /// # Ok::<(), tumbling_bodies::Error>(())
    /// ```
    #[must_use]
    pub fn drawn(&self) -> Vec<Surface> {
        if !self.surfaces.is_empty() {
            return self.surfaces.iter().map(|surface| surface.mapped(|p| p - self.centre)).collect();
        }
        let of_mass_one = || self.even_box(1.0) / self.even_box(1.0).max();
        let edges = self.mass.map_or_else(of_mass_one, |mass| self.even_box(mass));
        let frame: Matrix3<f64> = self.principal().frame();
        vec![Surface::cuboid(&edges).mapped(|p| frame * p)]
    }

    /// The greatest distance of what is [drawn](Self::drawn) from the centre of mass, m, or relative to the
    /// longest edge where no length is known.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.drawn().iter().flat_map(|s| &s.vertices).map(|p| p.norm()).fold(0.0, f64::max)
    }

    /// Checks that the size of what is drawn is usable, and says why if not.
    pub(crate) fn drawable(&self) -> Result<(), String> {
        drawable(self.drawn().iter().map(Surface::reach).fold(0.0, f64::max))
    }

    /// Whether what is drawn has a length: a surface or a mass was given.
    #[must_use]
    pub fn has_size(&self) -> bool {
        !self.surfaces.is_empty() || self.mass.is_some()
    }
}

/// A name in one line of at most a hundred characters, as drawings, pages and names of files can have it.
pub(crate) fn nameable(name: &str) -> Result<&str, String> {
    match (name.chars().find(|c| c.is_control()), name.chars().count()) {
        (Some(c), _) => Err(format!("{c:?} is not a character to write")),
        (None, count) if count > 100 => Err(format!("a name of {count} characters: at most 100 are read")),
        _ => Ok(name),
    }
}

/// A body's name on a command line.
pub(crate) fn word(body: NamedBody) -> String {
    body.to_string().trim_start_matches("the ").to_lowercase().replace(' ', "-")
}
