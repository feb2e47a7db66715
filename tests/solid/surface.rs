//! Surfaces of triangles that the tests of meshes are made of.

use nalgebra::{UnitQuaternion, Vector3};
use tumbling::Error;
use tumbling::solid::*;

pub type Surface = (Vec<Vector3<f64>>, Vec<[usize; 3]>);

/// A box from `low` to `low + edges`, two triangles a side.
pub fn brick(low: Vector3<f64>, edges: Vector3<f64>) -> Surface {
    let corner = |i: usize| {
        let bit = |k: usize| if i >> k & 1 == 1 { edges[k] } else { 0.0 };
        low + Vector3::new(bit(0), bit(1), bit(2))
    };
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces = sides.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    ((0..8).map(corner).collect(), faces)
}

/// Both surfaces as one.
pub fn both(mut a: Surface, b: Surface) -> Surface {
    let start = a.0.len();
    a.0.extend(b.0);
    a.1.extend(b.1.iter().map(|face| face.map(|v| v + start)));
    a
}

pub fn inside_out(mut a: Surface) -> Surface {
    a.1.iter_mut().for_each(|face| face.swap(1, 2));
    a
}

pub fn solid(surface: &Surface) -> Result<Mesh, Error> {
    Mesh::new(&surface.0, &surface.1)
}

pub fn cube(low: [f64; 3], edge: f64) -> Surface {
    brick(Vector3::from(low), Vector3::repeat(edge))
}

/// This surface with one vertex at each place.
pub fn welded((corners, mut faces): Surface) -> Surface {
    for vertex in faces.iter_mut().flatten() {
        *vertex = corners.iter().position(|v| *v == corners[*vertex]).unwrap();
    }
    (corners, faces)
}

pub fn turned_and_carried((mut corners, faces): Surface, angles: [f64; 3], by: Vector3<f64>) -> Surface {
    let turn = UnitQuaternion::from_euler_angles(angles[0], angles[1], angles[2]);
    corners.iter_mut().for_each(|v| *v = turn * *v + by);
    (corners, faces)
}
