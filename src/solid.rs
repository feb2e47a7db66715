//! Solids: from a shape to its mass, its centre, and how hard it is to turn.
//!
//! Each shape is checked when it is made; then [`Solid::with_mass`] or [`Solid::with_density`] gives its
//! [`MassProperties`]. Next to each shape stands its formula, generic over the number type (such as
//! [`cuboid_moments`]): the shape itself calls that very function. [`Compound`] puts parts together.
//!
//! ```
//! use nalgebra::Vector3;
//! use tumbling::solid::{Cuboid, Solid};
//!
//! // The worked example of the book: 2 m along x, 1 m along y, 3 m along z, 1 kg.
//! let the_box = Cuboid::new(2.0, 1.0, 3.0)?.with_mass(1.0)?;
//! assert_eq!(the_box.inertia().matrix().diagonal() * 12.0, Vector3::new(10.0, 13.0, 5.0));
//! # Ok::<(), tumbling::Error>(())
//! ```

mod ball;
mod capsule;
mod compound;
mod cone;
mod cuboid;
mod cylinder;
mod disk;
mod ellipsoid;
mod hollow_sphere;
mod mesh;
mod plate;
mod point_masses;
mod properties;
mod rod;
#[cfg(feature = "serde")]
mod serial;
mod shells;
mod tetrahedron;
mod topology;
mod tube;

pub use ball::{Ball, ball_moment};
pub use capsule::{Capsule, capsule_moments};
pub use compound::Compound;
pub use cone::{Cone, cone_moments};
pub use cuboid::{Cuboid, cuboid_moments};
pub use cylinder::{Cylinder, cylinder_moments};
pub use disk::{ThinDisk, disk_moments};
pub use ellipsoid::{Ellipsoid, ellipsoid_moments};
pub use hollow_sphere::{HollowSphere, hollow_sphere_moment};
pub use mesh::{Mesh, mesh_moments};
pub use plate::{ThinPlate, plate_moments};
pub use properties::{MassMoments, MassProperties, combined};
pub use rod::{ThinRod, rod_moments};
pub use tetrahedron::{Tetrahedron, tetrahedron_moments};
pub use tube::{Tube, tube_moments};

use crate::error::{Error, positive};
use crate::number::Ring;
use crate::number::extended::Extended;
use nalgebra::{Matrix3, Vector3};

/// A shape filled evenly with mass.
pub trait Solid {
    /// How much of it there is: volume in m³; of a thin plate or disk its area in m², of a thin rod its
    /// length in m. Zero for a shell whose radii are equal.
    ///
    /// # Errors
    /// A measure that `f64` does not hold with all its digits.
    fn measure(&self) -> Result<f64, Error>;

    /// Its mass properties if it weighs `mass` kg.
    ///
    /// # Errors
    /// A mass that is not finite and positive, or a moment that `f64` does not hold with all its digits.
    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error>;

    /// Its mass properties if it weighs `density` per [measure](Self::measure): kg/m³, or kg/m² for what is
    /// thin, or kg/m for a thin rod.
    ///
    /// # Errors
    /// A density that is not finite and positive, a measure of zero, or a mass or moment that `f64` does not
    /// hold with all its digits.
    fn with_density(&self, density: f64) -> Result<MassProperties, Error> {
        positive("the density", density)?;
        let measure = positive("the volume", self.measure()?)?;
        let mass = Extended::from(density) * Extended::from(measure);
        self.with_mass(mass.in_full("the mass")?)
    }
}

/// The properties of a shape whose centre is the origin and whose axes are principal.
fn centred(mass: f64, law: impl FnOnce(&Extended) -> Vector3<Extended>) -> Result<MassProperties, Error> {
    centred_at(Vector3::zeros(), mass, law)
}

/// The same with its centre elsewhere.
fn centred_at(
    centre: Vector3<Extended>,
    mass: f64,
    law: impl FnOnce(&Extended) -> Vector3<Extended>,
) -> Result<MassProperties, Error> {
    let mass = Extended::from(positive("the mass", mass)?);
    let inertia = Matrix3::from_diagonal(&law(&mass));
    MassMoments { mass, centre, inertia }.checked()
}

fn square<T: Ring>(x: &T) -> T {
    x.clone() * x.clone()
}

fn cube<T: Ring>(x: &T) -> T {
    square(x) * x.clone()
}
