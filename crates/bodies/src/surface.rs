//! Surfaces of solids, as flat faces to draw.

use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};

/// Flat faces that share vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// m.
    pub vertices: Vec<Vector3<f64>>,
    /// The vertices of each face by their numbers, counter-clockwise seen from outside. One with two is a
    /// line, one with one a point.
    pub faces: Vec<Vec<usize>>,
    /// Whether it bounds a convex solid: no face hides another that is turned to the viewer.
    pub convex: bool,
}

/// The smallest and the largest distance of a drawn surface from its origin, m: squares and ratios of these
/// do not overflow or underflow.
const SMALLEST: f64 = 1e-100;
const LARGEST: f64 = 1e100;

/// The farthest place of a body whose shape is still drawn to a millionth, relative to its size.
pub(crate) const FARTHEST: f64 = 1e9;

/// How many corners a circle has.
const ROUND: usize = 48;

impl Surface {
    /// A line of this length along z.
    pub(crate) fn line(length: f64) -> Self {
        let vertices = vec![Vector3::new(0.0, 0.0, -0.5 * length), Vector3::new(0.0, 0.0, 0.5 * length)];
        Self { vertices, faces: vec![vec![0, 1]], convex: true }
    }

    /// Single points.
    pub(crate) fn points(vertices: Vec<Vector3<f64>>) -> Self {
        let faces = (0..vertices.len()).map(|i| vec![i]).collect();
        Self { vertices, faces, convex: true }
    }

    /// A box with these edges.
    pub(crate) fn cuboid(edges: &Vector3<f64>) -> Self {
        let corner =
            |bits: usize| Vector3::from_fn(|i, _| if bits >> i & 1 == 1 { 0.5 } else { -0.5 } * edges[i]);
        let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        Self { vertices: (0..8).map(corner).collect(), faces: faces.map(Vec::from).into(), convex: true }
    }

    /// A tetrahedron, its vertices in any order.
    pub(crate) fn tetrahedron(vertices: [Vector3<f64>; 4]) -> Self {
        let [a, b, c, d] = vertices;
        let flipped = (b - a).cross(&(c - a)).dot(&(d - a)) < 0.0;
        let outwards = |[a, b, c]: [usize; 3]| if flipped { vec![a, c, b] } else { vec![a, b, c] };
        let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map(outwards);
        Self { vertices: vertices.into(), faces: faces.into(), convex: true }
    }

    /// A flat polygon in the xy plane, seen from both sides.
    fn sheet(vertices: Vec<Vector3<f64>>) -> Self {
        let front: Vec<usize> = (0..vertices.len()).collect();
        let back = front.iter().rev().copied().collect();
        Self { vertices, faces: vec![front, back], convex: true }
    }

    /// A thin plate with these edges along x and y.
    pub(crate) fn plate(a: f64, b: f64) -> Self {
        let corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)];
        Self::sheet(corners.map(|(x, y)| Vector3::new(x * a, y * b, 0.0)).into())
    }

    /// A thin disk in the xy plane.
    pub(crate) fn disk(radius: f64) -> Self {
        Self::sheet(circle(radius, 0.0))
    }

    /// The surface of revolution about the z axis of a profile of distances from that axis and heights. The
    /// profile runs upwards, with the solid between it and the axis; if `closed`, it runs round the solid.
    fn revolved(profile: &[[f64; 2]], closed: bool) -> Self {
        let (mut vertices, mut rings) = (Vec::new(), Vec::new());
        for &[r, z] in profile {
            let start = vertices.len();
            vertices.extend(if r == 0.0 { vec![Vector3::new(0.0, 0.0, z)] } else { circle(r, z) });
            rings.push((start, vertices.len() - start));
        }
        let vertex = |(start, count): (usize, usize), k: usize| start + k % count;
        let mut faces = Vec::new();
        let pairs = rings.windows(2).map(|pair| (pair[0], pair[1]));
        let last = closed.then(|| (rings[rings.len() - 1], rings[0]));
        for (low, high) in pairs.chain(last) {
            for k in 0..ROUND {
                let mut face = vec![vertex(low, k), vertex(low, k + 1), vertex(high, k + 1), vertex(high, k)];
                face.dedup();
                if face.first() == face.last() {
                    face.pop();
                }
                faces.push(face);
            }
        }
        let ends = [(rings[0], false), (rings[rings.len() - 1], true)];
        for ((start, count), up) in ends.into_iter().filter(|((_, count), _)| !closed && *count > 1) {
            let ring = start..start + count;
            faces.push(if up { ring.collect() } else { ring.rev().collect() });
        }
        Self { vertices, faces, convex: !closed }
    }

    /// A cylinder along z about the origin, full where `inner` is zero.
    pub(crate) fn cylinder(inner: f64, outer: f64, height: f64) -> Self {
        let h = 0.5 * height;
        let profile = [[inner, -h], [outer, -h], [outer, h], [inner, h]];
        if inner == 0.0 { Self::revolved(&profile[1..3], false) } else { Self::revolved(&profile, true) }
    }

    /// A cone with its base in the xy plane and its tip above.
    pub(crate) fn cone(radius: f64, height: f64) -> Self {
        Self::revolved(&[[radius, 0.0], [0.0, height]], false)
    }

    /// A cylinder of this length along z between two half balls.
    pub(crate) fn capsule(radius: f64, length: f64) -> Self {
        let steps = ROUND / 2;
        let place = |k: usize| {
            let (k, shift) = if k <= steps / 2 { (k, -0.5) } else { (k - 1, 0.5) };
            let (s, c) = (PI * k as f64 / steps as f64).sin_cos();
            [if k % steps == 0 { 0.0 } else { radius * s }, shift * length - radius * c]
        };
        Self::revolved(&(0..=steps + 1).map(place).collect::<Vec<_>>(), false)
    }

    /// An ellipsoid with these semi-axes.
    pub(crate) fn ellipsoid(semiaxes: &Vector3<f64>) -> Self {
        Self::capsule(1.0, 0.0).mapped(|p| p.component_mul(semiaxes))
    }

    /// The largest coordinate; infinite where one is not a number.
    pub(crate) fn reach(&self) -> f64 {
        let sizes = self.vertices.iter().flatten().map(|x| if x.is_nan() { f64::INFINITY } else { x.abs() });
        sizes.fold(0.0, f64::max)
    }

    /// This surface with each vertex moved.
    #[must_use]
    pub fn mapped(&self, place: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Self {
        Self { vertices: self.vertices.iter().map(place).collect(), ..self.clone() }
    }
}

/// Checks that a body of this extent, m, can be drawn.
pub(crate) fn drawable(reach: f64) -> Result<(), String> {
    let why = || format!("it reaches {reach:?} m: what is drawn is from {SMALLEST:e} m to {LARGEST:e} m");
    (SMALLEST..=LARGEST).contains(&reach).then_some(()).ok_or_else(why)
}

/// Corners of a circle round the z axis, counter-clockwise from above.
fn circle(radius: f64, z: f64) -> Vec<Vector3<f64>> {
    let corner = |k: usize| {
        let (s, c) = (TAU * k as f64 / ROUND as f64).sin_cos();
        Vector3::new(radius * c, radius * s, z)
    };
    (0..ROUND).map(corner).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six times the volume that the faces bound, each split into a fan.
    fn six_volumes(surface: &Surface) -> f64 {
        let v = |i: usize| surface.vertices[i];
        let fan =
            |f: &Vec<usize>| (1..f.len() - 1).map(|k| v(f[0]).dot(&v(f[k]).cross(&v(f[k + 1])))).sum::<f64>();
        surface.faces.iter().map(fan).sum()
    }

    #[test]
    fn faces_look_outwards_and_bound_the_volume_of_the_solid() {
        let corner = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 0.0, 6.0], [0.0, 4.0, 0.0]];
        let ball = Surface::ellipsoid(&Vector3::new(1.0, 2.0, 3.0));
        for (surface, volume, within) in [
            (Surface::cuboid(&Vector3::new(2.0, 3.0, 5.0)), 30.0, 1e-14),
            (Surface::tetrahedron(corner.map(Vector3::from)), 16.0, 1e-14),
            (Surface::cylinder(0.0, 2.0, 5.0), 20.0 * PI, 4e-3),
            (Surface::cylinder(1.0, 2.0, 5.0), 15.0 * PI, 4e-3),
            (Surface::cone(2.0, 3.0), 4.0 * PI, 4e-3),
            (Surface::capsule(1.0, 3.0), (4.0 / 3.0 + 3.0) * PI, 1e-2),
            (ball, 8.0 * PI, 1e-2),
        ] {
            let found = six_volumes(&surface) / 6.0;
            assert!((found / volume - 1.0).abs() < within, "{found} {volume}");
        }
    }
}
