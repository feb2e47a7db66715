//! A part of a named body: a straight bar.

use crate::number::functions::hypot;
use crate::solid::{Cuboid, Cylinder, Shape, ThinRod};
use core::f64::consts::PI;
use nalgebra::{Matrix3, Vector3};

/// A straight bar in the xz plane of a body, with one cross-section all along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// What it is, as in "handle".
    pub name: &'static str,
    /// What it is made of, as in "steel".
    pub material: &'static str,
    /// Its cross-section.
    pub section: Section,
    /// Where its middle lies, m.
    pub middle: Vector3<f64>,
    /// From one end to the other, m; without a component along y.
    pub along: Vector3<f64>,
    /// Its mass, kg.
    pub mass: f64,
}

/// The cross-section of a [`Part`], m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Section {
    /// None: an ideal thin rod.
    Line,
    /// A rectangle.
    Rectangle {
        /// Its edge in the xz plane; along x where the part lies along z.
        wide: f64,
        /// Its edge along y.
        thick: f64,
    },
    /// A full circle.
    Round {
        /// Its radius.
        radius: f64,
    },
    /// A circle with a hole.
    Ring {
        /// Radius of the hole.
        inner: f64,
        /// Radius of the whole.
        outer: f64,
    },
}

/// How the mass of a [`Part`] is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Fill {
    /// By its mass, kg.
    Mass(f64),
    /// By its density, kg/m³.
    Density(f64),
}

impl Part {
    pub(super) fn new(
        [name, material]: [&'static str; 2],
        section: Section,
        middle: Vector3<f64>,
        along: Vector3<f64>,
        fill: Fill,
    ) -> Self {
        let area = match section {
            Section::Line => 0.0,
            Section::Rectangle { wide, thick } => wide * thick,
            Section::Round { radius } => PI * radius * radius,
            Section::Ring { inner, outer } => PI * (outer - inner) * (outer + inner),
        };
        let mass = match fill {
            Fill::Mass(mass) => mass,
            Fill::Density(density) => density * area * hypot(along.x, along.z),
        };
        Self { name, material, section, middle, along, mass }
    }

    /// Its length, m.
    fn length(&self) -> f64 {
        hypot(self.along.x, self.along.z)
    }

    /// Its inertia about its middle in the body's axes, kg m².
    pub(super) fn inertia(&self) -> Matrix3<f64> {
        let (mass, length) = (self.mass, self.length());
        let [across, y, along] = match self.section {
            Section::Line => ThinRod::moments(&mass, [&length]),
            Section::Rectangle { wide, thick } => Cuboid::moments(&mass, [&wide, &thick, &length]),
            Section::Round { radius } => Cylinder::moments(&mass, [&radius, &length]),
            Section::Ring { inner, outer } => Cylinder::moments(&mass, [&inner, &outer, &length]),
        }
        .into();
        // Its x and z axes turned in the xz plane.
        let (sine, cosine) = (self.along.x / length, self.along.z / length);
        let product = (along - across) * sine * cosine;
        let (ss, cc) = (sine * sine, cosine * cosine);
        Matrix3::from([
            [across * cc + along * ss, 0.0, product],
            [0.0, y, 0.0],
            [product, 0.0, across * ss + along * cc],
        ])
    }
}
