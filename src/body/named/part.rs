//! A part of a named body: a straight bar.

use crate::error::Error;
use crate::number::functions::{atan2, hypot, sin_cos};
use crate::solid::{Cuboid, Cylinder, MassProperties, Shape, Solid, ThinRod};
use core::f64::consts::{FRAC_1_SQRT_2, PI};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

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
    /// Its mass to a few units in the last place, kg.
    pub mass: f64,
    fill: Fill,
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
        Self { name, material, section, middle, along, mass, fill }
    }

    /// Its length, m.
    fn length(&self) -> f64 {
        hypot(self.along.x, self.along.z)
    }

    /// The turn, part to body, that lays its own z axis along it.
    pub(super) fn attitude(&self) -> UnitQuaternion<f64> {
        if self.along.z == 0.0 && self.along.x > 0.0 {
            // A quarter turn with no rounding between its components.
            return UnitQuaternion::new_unchecked(Quaternion::new(FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2, 0.0));
        }
        let (sine, cosine) = sin_cos(0.5 * atan2(self.along.x, self.along.z));
        UnitQuaternion::new_unchecked(Quaternion::new(cosine, 0.0, sine, 0.0))
    }

    /// Its mass, centre and inertia in its own axes: the origin in its middle, z along it.
    pub(super) fn properties(&self) -> Result<MassProperties, Error> {
        let length = self.length();
        match self.section {
            Section::Line => self.filled(&ThinRod::new(length)?),
            Section::Rectangle { wide, thick } => self.filled(&Cuboid::new(wide, thick, length)?),
            Section::Round { radius } => self.filled(&Cylinder::new(radius, length)?),
            Section::Ring { inner, outer } => self.filled(&Cylinder::hollow(inner, outer, length)?),
        }
    }

    /// Its inertia about its middle in the body's axes, by the bare formulas: accurate to a few units in the
    /// last place, and unchecked.
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

    fn filled(&self, solid: &impl Solid) -> Result<MassProperties, Error> {
        match self.fill {
            Fill::Mass(mass) => solid.with_mass(mass),
            Fill::Density(density) => solid.with_density(density),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::NamedBody;
    use super::*;

    #[test]
    fn each_part_lies_along_its_own_z_axis_and_weighs_what_its_solid_does() {
        for body in NamedBody::ALL {
            body.each_part(&mut |part| {
                let (z, y) = (part.attitude() * Vector3::z(), part.attitude() * Vector3::y());
                assert!((z * part.along.norm() - part.along).amax() < 1e-15, "{body} {}", part.name);
                assert!((y - Vector3::y()).amax() < 1e-15, "{body} {}", part.name);
                assert!((part.properties().unwrap().mass() / part.mass - 1.0).abs() < 1e-14, "{}", part.name);
            });
        }
    }
}
