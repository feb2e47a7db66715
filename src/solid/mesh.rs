//! A tetrahedron, and any solid bounded by triangles, by the divergence theorem.
//!
//! Each face and a reference point span a tetrahedron, counted negative where the face looks towards the
//! point; together they fill the solid. The sums over them are polynomials in the coordinates; only the final
//! results need divisions. Source: [Ebe02](crate::references).

use super::{MassMoments, MassProperties, Solid, shells};
use crate::error::{Error, Refusal, Subject, finite_vector, positive};
use crate::inertia::{moments_of, point_mass};
use crate::number::{Extended, Field, Ring, ulp};
use alloc::vec::Vec;
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;

/// Volume, centre and inertia about the centre, for density 1, of the solid that the triangles bound: by
/// tetrahedra between each of them and `reference`, whose choice changes nothing in exact numbers.
///
/// A tetrahedron from the origin to `a`, `b`, `c` has `6 V = a . (b x c)`; its first moments are
/// `V/4 s` and its second `V/20 (a a^T + b b^T + c c^T + s s^T)`, with `s = a + b + c`.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::laws::mesh_moments;
/// let [o, a, b, c] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 6.0]].map(Vector3::from);
/// let corner = [[&o, &b, &a], [&o, &c, &b], [&o, &a, &c], [&a, &b, &c]];
/// let solid = mesh_moments(corner, &o);
/// assert_eq!(solid.mass, 16.0);
/// assert_eq!(solid.centre, Vector3::new(1.0, 1.0, 1.5));
/// ```
#[must_use]
pub fn mesh_moments<'a, T: Field>(
    triangles: impl IntoIterator<Item = [&'a Vector3<T>; 3]>,
    reference: &Vector3<T>,
) -> MassMoments<T> {
    // Six volumes, 24 first moments and 120 second ones, about the reference: no division in the loop.
    let (mut six_volumes, mut first, mut second) = (T::zero(), Vector3::zeros(), Matrix3::zeros());
    for triangle in triangles {
        let own = spanned(triangle, reference, |v| triple(v[0], v[1], v[2]));
        let [a, b, c] = triangle.map(|vertex| vertex - reference);
        let s = &a + &b + &c;
        let mut squares: Matrix3<T> = Matrix3::zeros();
        for v in [&a, &b, &c, &s] {
            squares += v * v.transpose();
        }
        first += s * own.clone();
        second += squares * own.clone();
        six_volumes += own;
    }
    let n = T::integer;
    let mass = six_volumes.clone() / n(6);
    let middle = first.map(|x| x / (n(4) * six_volumes.clone()));
    let spread = second.map(|x| x / n(120)) - &middle * middle.transpose() * mass.clone();
    // Sums of two, not the trace less one: a needle's smallest moment keeps its digits.
    let s = |i: usize, j: usize| spread[(i % 3, j % 3)].clone();
    let inertia = Matrix3::from_fn(|i, j| if i == j { s(i + 1, i + 1) + s(i + 2, i + 2) } else { -s(i, j) });
    MassMoments { mass, centre: reference + middle, inertia }
}

/// `measure` of three vectors that span what a triangle and the reference point span: to one corner, and
/// along two edges. Of the three corners' own vectors it would be the same number, but far from the
/// reference these are long and nearly parallel, and rounding would drown a small face.
fn spanned<T: Ring, M>(
    [a, b, c]: [&Vector3<T>; 3],
    reference: &Vector3<T>,
    measure: impl FnOnce([&Vector3<T>; 3]) -> M,
) -> M {
    measure([&(a - reference), &(b - a), &(c - a)])
}

/// A solid bounded by triangles.
///
/// The faces must close, and run counter-clockwise seen from outside. Several separate surfaces are fine, and
/// so are cavities (surfaces inside another, their faces seen counter-clockwise from the cavity), and parts
/// that touch along an edge. Vertices that no face uses are ignored. Two vertices at the same place are
/// different vertices, so loose triangles form an open surface until their vertices are merged. A shell with
/// the wrong orientation or nesting is refused, such as a cavity outside; this check visits all faces for
/// each shell. The library does not search for surfaces that intersect themselves or each other; it refuses
/// them only if this check finds them, or if no body can have the resulting tensor.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::ErrorKind;
/// use tumbling::solid::{Mesh, Solid};
///
/// let corner = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 6.0]].map(Vector3::from);
/// let faces = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];
/// let solid = Mesh::new(&corner, &faces)?;
/// assert_eq!(solid.measure()?, 16.0);
/// assert_eq!(solid.with_mass(2.0)?.centre(), Vector3::new(1.0, 1.0, 1.5));
///
/// let open = Mesh::new(&corner, &[faces[0], faces[1], faces[2], [0, 3, 1]]).unwrap_err();
/// assert_eq!(open.kind(), ErrorKind::BadMesh);
/// assert!(open.to_string().contains("from vertex 0 to vertex 1 belongs to 3 face(s)"), "{open}");
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// For density 1.
    moments: MassMoments<Extended>,
}

impl Mesh {
    /// From vertices (m) and faces; each face has the indices of three vertices, from 0.
    ///
    /// # Errors
    /// Fewer than four vertices or faces, a vertex that is not finite, a face with a missing or a repeated
    /// vertex, a face listed twice, an edge that is open, a face that is flipped, a volume that is not
    /// positive by more than rounding, a shell that is inside out or wrongly nested, or a tensor that no body
    /// has.
    pub fn new(vertices: &[Vector3<f64>], faces: &[[usize; 3]]) -> Result<Self, Error> {
        for (what, count) in [(Subject::Vertices, vertices.len()), (Subject::Faces, faces.len())] {
            Refusal::TooFew { what, count, needed: 4 }.when(count < 4)?;
        }
        for (index, vertex) in vertices.iter().enumerate() {
            finite_vector(Subject::Vertex, vertex).map_err(|e| e.of_part(index))?;
        }
        let shell = shells::of_faces(faces, vertices.len())?;
        let wide: Vec<_> = vertices.iter().map(|v| v.map(Extended::from)).collect();
        let triangles = || faces.iter().map(|face| face.map(|v| &wide[v]));
        let near = mean(triangles());
        enclosed(triangles(), &near)?;
        shells::check(&wide, faces, &shell)?;
        // Once to find the centre; again about the centre, where the least cancels.
        let rough = mesh_moments(triangles(), &near);
        let moments = mesh_moments(triangles(), &rough.centre);
        possible(&moments.inertia, faces.len())?;
        Ok(Self { moments })
    }
}

impl Solid for Mesh {
    fn measure(&self) -> Result<f64, Error> {
        self.moments.mass.in_full(Subject::Volume)
    }

    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error> {
        let mass = Extended::from(positive(Subject::Mass, mass)?);
        let density = mass / self.moments.mass;
        MassMoments { mass, centre: self.moments.centre, inertia: self.moments.inertia * density }.checked()
    }
}

/// The mean of all corners, as steps from the first, so that far from the origin no digits are lost.
fn mean<'a>(mut triangles: impl Iterator<Item = [&'a Vector3<Extended>; 3]>) -> Vector3<Extended> {
    let mut sum = Vector3::zeros();
    let mut count = Extended::from(1.0);
    let Some([start, ..]) = triangles.next() else {
        return sum;
    };
    for corner in triangles.flatten() {
        sum += corner - start;
        count += Extended::from(1.0);
    }
    start + sum.map(|x| x / count)
}

/// That the volume is positive by more than rounding.
fn enclosed<'a>(
    triangles: impl Iterator<Item = [&'a Vector3<Extended>; 3]>,
    reference: &Vector3<Extended>,
) -> Result<(), Error> {
    let (mut six_volumes, mut size, mut count) = (Extended::zero(), Extended::zero(), 0.0);
    for triangle in triangles {
        let (term, bound) = spanned(triangle, reference, determinant);
        six_volumes += term;
        size += bound;
        count += 1.0;
    }
    // Eight half units for each term, as in a tetrahedron, and one for each addition.
    let rounding = size * Extended::from((8.0 + count) * 0.5 * f64::EPSILON);
    above_rounding(six_volumes, rounding)
}

fn above_rounding(six_volumes: Extended, rounding: Extended) -> Result<(), Error> {
    let sixth = |x: Extended| (x / Extended::from(6.0)).nearest();
    Refusal::NoVolume { volume: sixth(six_volumes), tolerance: sixth(rounding) }
        .when(!(six_volumes - rounding).is_positive())
}

/// That some body could have this tensor, to the rounding of a sum of `count` terms: a surface that passes
/// through itself may give one that none has.
fn possible(tensor: &Matrix3<Extended>, count: usize) -> Result<(), Error> {
    let largest = shells::largest(&tensor.diagonal());
    let moments = moments_of(&tensor.map(|x| (x / largest).nearest()));
    let tolerance = (64.0 + count as f64) * ulp(moments[2]);
    let excess = (moments[2] - moments[1]) - moments[0];
    let size = |x: f64| (Extended::from(x) * largest).nearest();
    let moments = moments.map(size).into();
    Refusal::TriangleInequality { moments, excess: size(excess), tolerance: size(tolerance), printed: false }
        .when(excess > tolerance)
}

/// Centre and inertia of a full tetrahedron: as if a twentieth of its mass sat at each vertex, measured from
/// the centre.
///
/// The second moments of a simplex are `m/20 (sum v v^T + s s^T)` with `s` the sum of the vertices, which
/// vanishes from the centre. Source: [Ebe02](crate::references), for the integrals.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]].map(Vector3::from);
/// let body = tumbling::laws::tetrahedron_moments(&5.0, &corner);
/// assert_eq!(body.centre, Vector3::new(1.0, 1.0, 1.0));
/// assert_eq!(body.inertia, Matrix3::new(6.0, 1.0, 1.0, 1.0, 6.0, 1.0, 1.0, 1.0, 6.0));
/// ```
#[must_use]
pub fn tetrahedron_moments<T: Field>(mass: &T, vertices: &[Vector3<T>; 4]) -> MassMoments<T> {
    let [a, b, c, d] = vertices;
    let edges = [b - a, c - a, d - a];
    let middle = (&edges[0] + &edges[1] + &edges[2]).map(|x| x / T::integer(4));
    let share = mass.clone() / T::integer(20);
    let mut inertia: Matrix3<T> = point_mass(&share, &middle);
    for edge in &edges {
        inertia += point_mass(&share, &(edge - &middle));
    }
    MassMoments { mass: mass.clone(), centre: a + middle, inertia }
}

/// A full tetrahedron, its four vertices in any order.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Solid, Tetrahedron};
/// let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 6.0]].map(Vector3::from);
/// let body = Tetrahedron::new(corner)?;
/// assert_eq!(body.measure()?, 16.0);
/// assert_eq!(body.with_mass(1.0)?.centre(), Vector3::new(1.0, 1.0, 1.5));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tetrahedron {
    vertices: [Vector3<f64>; 4],
}

impl Tetrahedron {
    /// From its vertices, m, in either orientation: the interior of four points is the same.
    ///
    /// # Errors
    /// A vertex that is not finite, or four in one plane to rounding.
    pub fn new(vertices: [Vector3<f64>; 4]) -> Result<Self, Error> {
        for vertex in &vertices {
            finite_vector(Subject::Vertex, vertex)?;
        }
        let (six_volume, rounding) = six_volume(&vertices);
        above_rounding(six_volume, rounding).map(|()| Self { vertices })
    }
}

impl Solid for Tetrahedron {
    fn measure(&self) -> Result<f64, Error> {
        (six_volume(&self.vertices).0 / Extended::from(6.0)).in_full(Subject::Volume)
    }

    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error> {
        let mass = Extended::from(positive(Subject::Mass, mass)?);
        tetrahedron_moments(&mass, &self.vertices.map(|v| v.map(Extended::from))).checked()
    }
}

/// Six times the volume, and how far rounding may have moved it.
fn six_volume(vertices: &[Vector3<f64>; 4]) -> (Extended, Extended) {
    let [a, b, c, d] = vertices.map(|v| v.map(Extended::from));
    let (volume, size) = determinant([&(b - a), &(c - a), &(d - a)]);
    // Three roundings of the edges, two of each product, three of the sum: eight half units.
    (volume.abs(), size * Extended::from(4.0 * f64::EPSILON))
}

/// The determinant of three vectors, and the same with every term taken positive, which bounds its rounding.
fn determinant([a, b, c]: [&Vector3<Extended>; 3]) -> (Extended, Extended) {
    let size = |v: &Vector3<Extended>| v.map(Extended::abs);
    let plus = |p: &Vector3<Extended>, q: &Vector3<Extended>| {
        Vector3::new(p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x)
    };
    let dot = |p: &Vector3<Extended>, q: &Vector3<Extended>| p.x * q.x + p.y * q.y + p.z * q.z;
    (triple(a, b, c), dot(&size(a), &plus(&size(b), &size(c))))
}

/// `a . (b x c)`.
pub(super) fn triple<T: Ring>(a: &Vector3<T>, b: &Vector3<T>, c: &Vector3<T>) -> T {
    a.dot(&b.cross(c))
}
