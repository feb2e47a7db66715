//! Objects in space, seen from far away.

use super::canvas::Canvas;
use super::pen::{Fill, Pen};
use super::point::P;
use crate::ink::Ink;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;

/// A view from infinity: the position of the world's origin on the sheet, the scale, and the direction of
/// view.
#[derive(Debug, Clone, Copy)]
pub(crate) struct View {
    centre: P,
    scale: f64,
    right: Vector3<f64>,
    up: Vector3<f64>,
    toward: Vector3<f64>,
}

impl View {
    /// From `azimuth` (round the world's z from x, degrees) and `elevation` above the xy plane; z is up.
    pub(crate) fn new(centre: P, scale: f64, azimuth: f64, elevation: f64) -> Self {
        let (sa, ca) = azimuth.to_radians().sin_cos();
        let (se, ce) = elevation.to_radians().sin_cos();
        Self {
            centre,
            scale,
            right: Vector3::new(-sa, ca, 0.0),
            up: Vector3::new(-se * ca, -se * sa, ce),
            toward: Vector3::new(ce * ca, ce * sa, se),
        }
    }

    /// The direction to the viewer.
    pub(crate) fn toward(&self) -> Vector3<f64> {
        self.toward
    }

    /// Points to the metre.
    pub(crate) fn scale(&self) -> f64 {
        self.scale
    }

    /// This view, for a world whose origin was moved to `p`.
    pub(crate) fn moved(self, p: &Vector3<f64>) -> Self {
        Self { centre: self.at(p), ..self }
    }

    /// This view, moved so that `p` is drawn where the world's origin was.
    pub(crate) fn moved_back(self, p: &Vector3<f64>) -> Self {
        self.moved(&-p)
    }

    /// The drawn positions of points at an angle from the vertical, all around it.
    pub(crate) fn ring(&self, angle: f64, length: f64) -> Vec<P> {
        let place = |i: i32| {
            let (sin, cos) = (TAU * f64::from(i) / 96.0).sin_cos();
            self.at(&(Vector3::new(angle.sin() * cos, angle.sin() * sin, angle.cos()) * length))
        };
        (0..=96).map(place).collect()
    }

    /// Where a point falls.
    pub(crate) fn at(&self, p: &Vector3<f64>) -> P {
        (self.centre.0 + self.scale * self.right.dot(p), self.centre.1 - self.scale * self.up.dot(p))
    }
}

/// A box with its edges along the columns of a rotation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cuboid {
    /// Body to world.
    pub(crate) rotation: Matrix3<f64>,
    /// Half the edges.
    pub(crate) half: Vector3<f64>,
}

impl Cuboid {
    /// The point at `(x, y, z)` in halves of the edges.
    pub(crate) fn point(&self, x: f64, y: f64, z: f64) -> Vector3<f64> {
        self.rotation * Vector3::new(x, y, z).component_mul(&self.half)
    }

    /// Whether the face on side `sign` of edge direction `axis` faces the viewer.
    pub(crate) fn faces(&self, view: &View, axis: usize, sign: f64) -> bool {
        sign * self.rotation.column(axis).dot(&view.toward()) > 0.0
    }

    /// The corners of that face, in order round it.
    pub(crate) fn face(&self, axis: usize, sign: f64) -> [Vector3<f64>; 4] {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(a, b)| {
            let mut p = Vector3::zeros();
            (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (sign, a, b);
            self.point(p.x, p.y, p.z)
        })
    }

    /// Hidden edges dashed, then the three visible faces, each with its shade.
    pub(crate) fn draw(&self, canvas: &Canvas, view: &View, hidden: Option<Pen>, edge: Pen) {
        if let Some(pen) = hidden {
            // The three hidden edges meet in the corner farthest away.
            let away = |axis: usize| if self.faces(view, axis, 1.0) { -1.0 } else { 1.0 };
            let far = [away(0), away(1), away(2)];
            for axis in 0..3 {
                let mut other = far;
                other[axis] = -other[axis];
                let [from, to] = [far, other].map(|[x, y, z]| view.at(&self.point(x, y, z)));
                canvas.line(from, to, pen);
            }
        }
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                if self.faces(view, axis, sign) {
                    let corners = self.face(axis, sign).map(|p| view.at(&p));
                    // Light from above the viewer's left shoulder.
                    let light = Vector3::new(0.1, -0.3, 1.0).normalize();
                    let shade = 0.5 - 0.5 * sign * self.rotation.column(axis).dot(&light);
                    canvas.area(&corners, Fill::new(Ink::Surface).opacity(0.85), None);
                    canvas.area(&corners, Fill::new(Ink::Text).opacity(0.02 + 0.13 * shade), Some(edge));
                }
            }
        }
    }
}
