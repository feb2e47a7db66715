//! A tetrahedron: the solid that every other with flat faces is cut into.

use super::{MassMoments, MassProperties, Solid};
use crate::error::{Error, Refusal, Subject, finite_vector, positive};
use crate::inertia::point_mass;
use crate::number::extended::Extended;
use crate::number::{Field, Ring};
use nalgebra::{Matrix3, Vector3};

/// Centre and inertia of a full tetrahedron: as if a twentieth of its mass sat at each vertex, measured from
/// the centre.
///
/// The second moments of a simplex are `m/20 (sum v v^T + s s^T)` with `s` the sum of the vertices, which
/// vanishes from the centre. Source: [Ebe02](crate::references), for the integrals.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]].map(Vector3::from);
/// let body = tumbling::solid::tetrahedron_moments(&5.0, &corner);
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
    /// From its vertices, m. Their order may turn either way: the inside of four points is the same.
    ///
    /// # Errors
    /// A vertex that is not finite, or four in one plane to rounding.
    pub fn new(vertices: [Vector3<f64>; 4]) -> Result<Self, Error> {
        for vertex in &vertices {
            finite_vector(Subject::Vertex, vertex)?;
        }
        let (six_volume, rounding) = six_volume(&vertices);
        if (six_volume - rounding).is_positive() {
            return Ok(Self { vertices });
        }
        let sixth = |x: Extended| (x / Extended::from(6.0)).nearest();
        Err(Refusal::NoVolume { volume: sixth(six_volume), tolerance: sixth(rounding) }.into())
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
pub(super) fn determinant([a, b, c]: [&Vector3<Extended>; 3]) -> (Extended, Extended) {
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
