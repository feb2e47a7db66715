//! Solids: from a shape to its mass, its centre of mass and its inertia tensor.
//!
//! Each shape is checked when it is made; then [`Solid::with_mass`] or [`Solid::with_density`] gives its
//! [`MassProperties`]. The formula for its moments is in [`Shape`], generic over the number type;
//! [`Solid::with_mass`] runs that same function. [`Compound`] combines parts.
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

mod compound;
mod cuboid;
pub(crate) mod mesh;
mod properties;
mod round;
mod shells;
mod thin;

pub use compound::Compound;
pub use cuboid::{Cuboid, Ellipsoid};
pub use mesh::{Mesh, Tetrahedron};
pub use properties::{MassMoments, MassProperties, combined};
pub use round::{Ball, Capsule, Cone, Cylinder};
pub use thin::{ThinDisk, ThinPlate, ThinRod};

use crate::error::{Error, Refusal, Subject, not_negative, positive};
use crate::number::{Extended, Field, Ring};
use core::f64::consts::PI;
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero as _;

/// A shape filled evenly with mass.
pub trait Solid {
    /// Its volume in m³, the area in m² of a thin plate or disk, or the length in m of a thin rod. It is zero
    /// for a shell whose radii are equal.
    ///
    /// # Errors
    /// A measure that `f64` cannot hold with all its digits.
    fn measure(&self) -> Result<f64, Error>;

    /// Its mass properties for a mass of `mass` kg.
    ///
    /// # Errors
    /// A mass that is not finite and positive, or a moment that `f64` does not hold with all its digits.
    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error>;

    /// Its mass properties for a density per [measure](Self::measure): kg/m³, kg/m² for a thin plate or disk,
    /// or kg/m for a thin rod.
    ///
    /// # Errors
    /// A density that is not finite and positive, a measure of zero, or a mass or moment that `f64` does not
    /// hold with all its digits.
    fn with_density(&self, density: f64) -> Result<MassProperties, Error> {
        positive(Subject::Density, density)?;
        let measure = positive(Subject::Volume, self.measure()?)?;
        let mass = Extended::from(density) * Extended::from(measure);
        self.with_mass(mass.in_full(Subject::Mass)?)
    }
}

/// A shape whose moments follow from its sizes, by one formula for every number type.
pub trait Shape<const N: usize> {
    /// Its principal moments about its centre, kg m², along its own axes, from its mass (kg) and its sizes
    /// (m) in the order of its constructor; unchecked.
    #[must_use]
    fn moments<T: Field>(mass: &T, sizes: [&T; N]) -> Vector3<T>;
}

/// The properties of a shape with these sizes and this centre.
fn even<S: Shape<N>, const N: usize>(
    centre: Vector3<Extended>,
    mass: f64,
    sizes: [f64; N],
) -> Result<MassProperties, Error> {
    let (mass, sizes) = (Extended::from(positive(Subject::Mass, mass)?), sizes.map(Extended::from));
    let inertia = Matrix3::from_diagonal(&S::moments(&mass, sizes.each_ref()));
    MassMoments { mass, centre, inertia }.checked()
}

/// A shape of sizes that are all finite and above zero, and how it is made from them.
macro_rules! shape {
    ($(#[$about:meta])* $Name:ident $(#[$of:meta])* new($($size:ident: $what:ident),*)) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $Name {
            sizes: [f64; [$(stringify!($size)),*].len()],
        }

        impl $Name {
            $(#[$of])*
            pub fn new($($size: f64),*) -> Result<Self, Error> {
                $(positive(Subject::$what, $size)?;)*
                Ok(Self { sizes: [$($size),*] })
            }
        }
    };
}
use shape;

/// Makes a shape a solid: by how much of it there is, from its sizes, and by its centre if that is not the
/// origin.
macro_rules! solid {
    ($Name:ident, $what:ident, |$sizes:pat_param| $measure:expr $(, |$placed:pat_param| $centre:expr)?) => {
        impl Solid for $Name {
            fn measure(&self) -> Result<f64, Error> {
                let $sizes = self.sizes.map(Extended::from);
                ($measure).in_full(Subject::$what)
            }
            fn with_mass(&self, mass: f64) -> Result<MassProperties, Error> {
                let centre = solid!(@centre self.sizes.map(Extended::from) $(, |$placed| $centre)?);
                even::<Self, _>(centre, mass, self.sizes)
            }
        }
    };
    (@centre $given:expr) => { Vector3::zeros() };
    (@centre $given:expr, |$sizes:pat_param| $centre:expr) => {{
        let $sizes = $given;
        $centre
    }};
}
use solid;

fn four_thirds_pi() -> Extended {
    Extended::from(4.0) * Extended::from(PI) / Extended::from(3.0)
}

/// That these can be the radii of a hole and of the whole.
fn ordered(inner: f64, outer: f64) -> Result<(), Error> {
    not_negative(Subject::InnerRadius, inner)?;
    positive(Subject::OuterRadius, outer)?;
    let (smaller, larger) = (Subject::InnerRadius, "the outer radius");
    Refusal::Order { smaller, small: inner, larger, large: outer }.when(inner > outer)
}

fn square<T: Ring>(x: &T) -> T {
    x.clone() * x.clone()
}

/// The sums of the squares of the sizes across each axis.
fn across<T: Ring>(sizes: [&T; 3]) -> Vector3<T> {
    let [aa, bb, cc] = sizes.map(square);
    Vector3::new(bb.clone() + cc.clone(), cc + aa.clone(), aa + bb)
}
