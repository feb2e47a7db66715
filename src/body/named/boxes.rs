//! The named bodies that are evenly filled boxes. Where their sizes come from stands at [`super::NamedBody`].

use super::{Fill, Part, Section};
use crate::solid::{Cuboid, Shape};
use nalgebra::Vector3;

/// An evenly filled box about the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvenBox {
    /// Edges along x, y and z, m.
    pub edges: [f64; 3],
    /// Mass, kg.
    pub mass: f64,
}

/// The sizes of [the box](super::NamedBody::TheBox).
pub const THE_BOX: EvenBox = EvenBox { edges: [2.0, 1.0, 3.0], mass: 1.0 };

/// The sizes of [the book](super::NamedBody::Book).
pub const BOOK: EvenBox = EvenBox { edges: [0.129, 0.020, 0.198], mass: 0.340 };

/// The sizes of [the phone](super::NamedBody::Phone).
pub const PHONE: EvenBox = EvenBox { edges: [0.0716, 0.0078, 0.1476], mass: 0.171 };

pub(super) const REMOTE_CONTROL: EvenBox = EvenBox { edges: [0.035, 0.00925, 0.136], mass: 0.063 };

impl EvenBox {
    /// Its moments about x, y and z, kg m².
    #[must_use]
    pub fn moments(&self) -> Vector3<f64> {
        let [a, b, c] = &self.edges;
        Cuboid::moments(&self.mass, [a, b, c])
    }

    pub(super) fn part(&self, name: &'static str, material: &'static str) -> Part {
        let [wide, thick, length] = self.edges;
        Part {
            name,
            material,
            section: Section::Rectangle { wide, thick },
            middle: Vector3::zeros(),
            along: Vector3::new(0.0, 0.0, length),
            fill: Fill::Mass(self.mass),
        }
    }
}
