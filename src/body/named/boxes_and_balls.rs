//! Bodies of one even shape. Where the boxes' sizes come from stands at [`super::NamedBody`].

use super::{Fill, Part, Section};
use nalgebra::Vector3;

/// A body of one shape, evenly filled, about the origin: the shape's sizes in the order of its
/// [law](crate::solid::Shape), m, and the mass, kg.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::body::named::THE_BOX;
/// use tumbling::solid::{Cuboid, Shape};
/// let moments = Cuboid::moments(&THE_BOX.mass, THE_BOX.sizes.each_ref());
/// assert!((moments * 12.0 - Vector3::new(10.0, 13.0, 5.0)).amax() < 1e-14);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Even<const N: usize> {
    /// m.
    pub sizes: [f64; N],
    /// kg.
    pub mass: f64,
}

/// The edges along x, y and z of [the box](super::NamedBody::TheBox).
pub const THE_BOX: Even<3> = Even { sizes: [2.0, 1.0, 3.0], mass: 1.0 };

/// The edges along x, y and z of [the book](super::NamedBody::Book).
pub const BOOK: Even<3> = Even { sizes: [0.129, 0.020, 0.198], mass: 0.340 };

/// The edges along x, y and z of [the phone](super::NamedBody::Phone).
pub const PHONE: Even<3> = Even { sizes: [0.0716, 0.0078, 0.1476], mass: 0.171 };

pub(super) const REMOTE_CONTROL: Even<3> = Even { sizes: [0.035, 0.00925, 0.136], mass: 0.063 };

/// The radius of a ball of one metre and one kilogram.
pub const BALL: Even<1> = Even { sizes: [0.5], mass: 1.0 };

impl Even<3> {
    /// The box as the only part of a body.
    pub(super) fn part(&self, name: &'static str, material: &'static str) -> Part {
        let [wide, thick, length] = self.sizes;
        let (section, along) = (Section::Rectangle { wide, thick }, Vector3::new(0.0, 0.0, length));
        Part::new([name, material], section, Vector3::zeros(), along, Fill::Mass(self.mass))
    }
}
