//! The bodies of the book's stories, each with where its sizes come from.
//!
//! All lie alike: the long way along z, so that z is the axis with the smallest moment, y the one with the
//! largest, and **x the middle one**, the one that flips, as in the book's box.
//!
//! ```
//! use tumbling::Axis;
//! for body in tumbling::body::named::all() {
//!     let principal = body.properties()?.inertia().principal();
//!     assert!(principal.axis(Axis::Middle).x > 1.0 - 1e-12, "{}", body.name());
//! }
//! # Ok::<(), tumbling::Error>(())
//! ```

use crate::body::attitude::turn;
use crate::error::Error;
use crate::number::functions::{atan2, hypot, sin_cos};
use crate::solid::{Compound, Cuboid, Cylinder, MassProperties, Solid, ThinRod, Tube};
use core::f64::consts::{FRAC_1_SQRT_2, TAU};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Density of steel, kg/m³: a textbook value.
const STEEL: f64 = 7850.0;

/// Density of ash wood, kg/m³: a textbook value; real handles differ by a tenth either way.
const ASH: f64 = 680.0;

/// A body with a name, as listed by [`all`].
#[derive(Debug, Clone, Copy)]
pub struct NamedBody {
    name: &'static str,
    sizes_from: &'static str,
    make: fn() -> Result<MassProperties, Error>,
}

impl NamedBody {
    /// What it is called, as in "the phone".
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Where its sizes and mass come from, in a few words.
    #[must_use]
    pub fn sizes_from(&self) -> &'static str {
        self.sizes_from
    }

    /// Its mass, centre and inertia.
    ///
    /// # Errors
    /// None: the sizes are constants.
    pub fn properties(&self) -> Result<MassProperties, Error> {
        (self.make)()
    }
}

/// Every named body, in the order in which the book meets them.
#[must_use]
pub fn all() -> &'static [NamedBody] {
    const fn body(
        name: &'static str,
        sizes_from: &'static str,
        make: fn() -> Result<MassProperties, Error>,
    ) -> NamedBody {
        NamedBody { name, sizes_from, make }
    }
    const ALL: [NamedBody; 8] = [
        body("the box", "the book's worked example", the_box),
        body("the book", "a standard paperback format; thickness and mass worked out from its paper", book),
        body("the phone", "its maker's published sizes, evenly filled", phone),
        body("the remote control", "its maker's published sizes, evenly filled", remote_control),
        body("the hammer", "typical, chosen by us; textbook densities", hammer),
        body("the tennis racket", "typical, chosen by us; compared with a measured racket", tennis_racket),
        body("the wing nut", "a standard's table for thread M10; its wings simplified by us", wing_nut),
        body("the T-handle", "chosen by us", t_handle),
    ];
    &ALL
}

/// The box of the worked example: 2 m along x, 1 m along y, 3 m along z, 1 kg. Moments 10/12, 13/12 and 5/12.
///
/// # Errors
/// None: the sizes are constants.
pub fn the_box() -> Result<MassProperties, Error> {
    Cuboid::new(2.0, 1.0, 3.0)?.with_mass(1.0)
}

/// A paperback of 320 pages, held shut by a rubber band.
///
/// B-format, 129 mm by 198 mm, is a standard British paperback size. The rest is worked out by us for common
/// paper: 160 leaves at 80 g/m² and a cover at 250 g/m² front and back make 0.340 kg; at 0.125 mm a leaf
/// they are 20 mm thick.
///
/// # Errors
/// None: the sizes are constants.
pub fn book() -> Result<MassProperties, Error> {
    Cuboid::new(0.129, 0.020, 0.198)?.with_mass(0.340)
}

/// A phone: 71.6 mm by 7.80 mm by 147.6 mm, 171 g.
///
/// The outer sizes and the mass of an iPhone 15 as its maker publishes them. That it is evenly filled is our
/// simplification: a real phone's battery and cameras shift its centre a little.
///
/// # Errors
/// None: the sizes are constants.
pub fn phone() -> Result<MassProperties, Error> {
    Cuboid::new(0.0716, 0.0078, 0.1476)?.with_mass(0.171)
}

/// A remote control: 35 mm by 9.25 mm by 136 mm, 63 g.
///
/// The outer sizes and the mass of a Siri Remote (second generation) as its maker publishes them. That it is
/// evenly filled is our simplification.
///
/// # Errors
/// None: the sizes are constants.
pub fn remote_control() -> Result<MassProperties, Error> {
    Cuboid::new(0.035, 0.00925, 0.136)?.with_mass(0.063)
}

/// A hammer: a steel head of 100 mm by 32 mm by 32 mm across the end of an ash handle 290 mm long and 29 mm
/// thick. Head along x, handle along z.
///
/// Typical of a club hammer with a head of about 0.8 kg; the sizes are chosen by us, the densities are
/// textbook values. The handle ends where the head begins.
///
/// # Errors
/// None: the sizes are constants.
pub fn hammer() -> Result<MassProperties, Error> {
    let (handle, side) = (0.290, 0.032);
    Compound::new()
        .at(Cylinder::new(0.0145, handle)?.with_density(ASH)?, along_z(0.5 * handle))
        .at(Cuboid::new(0.100, side, side)?.with_density(STEEL)?, along_z(handle + 0.5 * side))
        .properties()
}

/// A tennis racket, 685 mm long and 0.327 kg: an oval hoop with 16 by 19 strings, two throat bars and a
/// handle, with the handle along z and the strings in the xz plane.
///
/// The sizes are typical and chosen by us, within the rules of tennis (at most 737 mm by 317 mm,
/// ITF Rules of Tennis, appendix II). A real racket to compare it with: the Wilson T-2000 that Brody measured had 0.00121,
/// 0.01638 and 0.01748 kg m² ([Bro85](crate::references) as quoted in [Ash91](crate::references)).
///
/// # Errors
/// None: the sizes are constants.
pub fn tennis_racket() -> Result<MassProperties, Error> {
    // The hoop, as 48 straight bars of the same mass; its middle is 520 mm from the butt.
    let (wide, long, middle) = (0.122, 0.165, 0.520);
    let corner = |i: u32| {
        let (sin, cos) = sin_cos(TAU * f64::from(i) / 48.0);
        [wide * cos, middle + long * sin]
    };
    let mut racket = Compound::new();
    for i in 0..48 {
        racket = bar(racket, 0.150 / 48.0, corner(i), corner(i + 1))?;
    }
    // The strings, mains along z and crosses along x, 17 g shared out by their lengths.
    let half_chord = |at: f64| (1.0 - at * at).sqrt();
    let places = |count: u32| (1..=count).map(move |i| f64::from(2 * i) / f64::from(count + 1) - 1.0);
    let chords = |count: u32, half: f64| places(count).map(half_chord).sum::<f64>() * 2.0 * half;
    let per_metre = 0.017 / (chords(16, long) + chords(19, wide));
    for at in places(16) {
        let half = long * half_chord(at);
        racket = bar(racket, per_metre * 2.0 * half, [wide * at, middle - half], [wide * at, middle + half])?;
    }
    for at in places(19) {
        let (half, z) = (wide * half_chord(at), middle + long * at);
        racket = bar(racket, per_metre * 2.0 * half, [-half, z], [half, z])?;
    }
    for side in [-1.0, 1.0] {
        racket = bar(racket, 0.025, [side * 0.012, 0.190], [side * 0.080, 0.395])?;
    }
    let handle = Cuboid::new(0.034, 0.029, 0.190)?.with_mass(0.110)?;
    racket.at(handle, along_z(0.095)).properties()
}

/// A wing nut for thread M10, of steel: a round boss along x with its wings spread along z. It comes off its
/// screw spinning about x, the middle axis.
///
/// Boss and span are those that UNI 5448 lists for M10 (boss 16.5 mm wide and 6.8 mm high, 36.2 mm over the
/// wings, whose edges are 3.3 mm thick and reach 17.7 mm high; about 13.5 g), as quoted in dealers' tables: likely,
/// not checked against the standard itself. The wings slant; ours are upright plates as high as two thirds of
/// theirs, the hole is 9 mm wide. Nobody published the sizes of the nut that flipped in orbit.
///
/// # Errors
/// None: the sizes are constants.
pub fn wing_nut() -> Result<MassProperties, Error> {
    let (radius, height, top, span) = (0.00825, 0.0068, 0.0177, 0.0362);
    let (wing_height, reach) = (0.0118, 0.5 * span - radius);
    let boss = Tube::new(0.0045, radius, height)?.with_density(STEEL)?;
    let wing = Cuboid::new(wing_height, 0.0033, reach)?.with_density(STEEL)?;
    let place = |side: f64| Vector3::new(top - 0.5 * wing_height, 0.0, side * (radius + 0.5 * reach));
    Compound::new()
        .with(boss, Vector3::new(0.5 * height, 0.0, 0.0), z_to_x())
        .at(wing, place(1.0))
        .at(wing, place(-1.0))
        .properties()
}

/// A T-handle of steel rod 12 mm thick: a crossbar of 100 mm along z, and a stem of 50 mm along x from its
/// middle. It spins about its stem, the middle axis.
///
/// The shape is that of the handle often filmed in orbit; its sizes are chosen by us. The stem ends where the
/// crossbar begins.
///
/// # Errors
/// None: the sizes are constants.
pub fn t_handle() -> Result<MassProperties, Error> {
    let (radius, stem) = (0.006, 0.050);
    Compound::new()
        .at(Cylinder::new(radius, 0.100)?.with_density(STEEL)?, Vector3::zeros())
        .with(
            Cylinder::new(radius, stem)?.with_density(STEEL)?,
            Vector3::new(radius + 0.5 * stem, 0.0, 0.0),
            z_to_x(),
        )
        .properties()
}

/// The compound and a thin bar in its xz plane, from one `[x, z]` to another.
fn bar(compound: Compound, mass: f64, from: [f64; 2], to: [f64; 2]) -> Result<Compound, Error> {
    let (dx, dz) = (to[0] - from[0], to[1] - from[1]);
    let middle = Vector3::new(0.5 * (from[0] + to[0]), 0.0, 0.5 * (from[1] + to[1]));
    let attitude = UnitQuaternion::new_unchecked(turn(&Vector3::new(0.0, atan2(dx, dz), 0.0)));
    Ok(compound.with(ThinRod::new(hypot(dx, dz))?.with_mass(mass)?, middle, attitude))
}

fn along_z(z: f64) -> Vector3<f64> {
    Vector3::new(0.0, 0.0, z)
}

/// The quarter turn that lays what stood along z along x, with no rounding between its components.
fn z_to_x() -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(Quaternion::new(FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2, 0.0))
}
