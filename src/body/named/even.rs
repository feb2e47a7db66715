//! Even bodies of the book that have no parts to draw: a plate, a pencil, a ball.

use crate::solid::{ball_moment, cylinder_moments, plate_moments};
use nalgebra::Vector3;

/// An even thin plate in the xy plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvenPlate {
    /// Along x and y, m.
    pub edges: [f64; 2],
    /// kg.
    pub mass: f64,
}

/// An even cylinder along z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvenCylinder {
    /// m.
    pub radius: f64,
    /// Along z, m.
    pub height: f64,
    /// kg.
    pub mass: f64,
}

/// An even ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvenBall {
    /// m.
    pub radius: f64,
    /// kg.
    pub mass: f64,
}

/// The plate of the chapter on two arrows.
pub const PLATE: EvenPlate = EvenPlate { edges: [2.0, 1.0], mass: 1.0 };

/// A pencil.
pub const PENCIL: EvenCylinder = EvenCylinder { radius: 0.0035, height: 0.18, mass: 0.005 };

/// A ball of one metre and one kilogram.
pub const BALL: EvenBall = EvenBall { radius: 0.5, mass: 1.0 };

impl EvenPlate {
    /// Its principal moments about x, y and z, kg m².
    #[must_use]
    pub fn moments(&self) -> Vector3<f64> {
        plate_moments(&self.mass, &self.edges[0], &self.edges[1])
    }
}

impl EvenCylinder {
    /// Its principal moments about x, y and z, kg m².
    #[must_use]
    pub fn moments(&self) -> Vector3<f64> {
        cylinder_moments(&self.mass, &self.radius, &self.height)
    }
}

impl EvenBall {
    /// Its principal moments, all the same, kg m².
    #[must_use]
    pub fn moments(&self) -> Vector3<f64> {
        Vector3::repeat(ball_moment(&self.mass, &self.radius))
    }
}
