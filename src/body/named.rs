//! The bodies of the book's stories, each with where its sizes come from.
//!
//! All lie in the same way: the long way along z, so that z is the axis with the smallest moment, y the one
//! with the largest, and **x the middle one**, the one that flips, as in the book's box.
//!
//! Each is a list of straight [parts](NamedBody::parts), from which its mass properties are computed;
//! drawings are made of the same parts.
//!
//! ```
//! use tumbling::Axis;
//! for body in tumbling::body::named::all() {
//!     let principal = body.properties()?.inertia().principal();
//!     assert!(principal.axis(Axis::Middle).x > 1.0 - 1e-12, "{}", body.name());
//! }
//! # Ok::<(), tumbling::Error>(())
//! ```

mod boxes;
mod even;
mod part;
mod racket;
mod steel;

use alloc::vec::Vec;
pub use boxes::{BOOK, EvenBox, PHONE, REMOTE_CONTROL, THE_BOX};
pub use even::{BALL, EvenBall, EvenCylinder, EvenPlate, PENCIL, PLATE};
pub use part::{Fill, Part, Section};

use crate::error::Error;
use crate::inertia::point_mass;
use crate::solid::{Compound, MassMoments, MassProperties};
use nalgebra::{Matrix3, Vector3};

/// A body with a name, as listed by [`all`].
#[derive(Debug, Clone, Copy)]
pub struct NamedBody {
    name: &'static str,
    sizes_from: &'static str,
    parts: fn(&mut dyn FnMut(Part)),
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

    /// The solids of which it consists.
    #[must_use]
    pub fn parts(&self) -> Vec<Part> {
        let mut parts = Vec::new();
        self.each_part(&mut |part| parts.push(part));
        parts
    }

    /// Hands each of its [parts](Self::parts) to `put`, without a list in between.
    pub fn each_part(&self, put: &mut dyn FnMut(Part)) {
        (self.parts)(put);
    }

    /// Its mass, centre and inertia by the laws alone: [`properties`](Self::properties) to some units in the last place, without what
    /// checks sizes and keeps digits, for a program that must be small.
    ///
    /// ```
    /// use tumbling::body::named;
    /// for body in named::all() {
    ///     let (plain, checked) = (body.moments(), body.properties()?);
    ///     let tensor = checked.inertia().matrix();
    ///     assert!((plain.inertia - tensor).amax() < 2e-15 * tensor.amax());
    ///     assert!((plain.centre - checked.centre()).amax() < 1e-15 && (plain.mass / checked.mass() - 1.0).abs() < 1e-15);
    /// }
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    #[must_use]
    pub fn moments(&self) -> MassMoments<f64> {
        let (mut mass, mut first) = (0.0, Vector3::zeros());
        self.each_part(&mut |part| {
            mass += part.mass();
            first += part.middle * part.mass();
        });
        let centre = first / mass;
        let mut inertia = Matrix3::zeros();
        self.each_part(&mut |part| {
            inertia += part.inertia() + point_mass(&part.mass(), &(part.middle - centre));
        });
        MassMoments { mass, centre, inertia }
    }

    /// Its mass, centre and inertia.
    ///
    /// # Errors
    /// None: the sizes are constants.
    pub fn properties(&self) -> Result<MassProperties, Error> {
        let mut whole = Compound::new();
        for part in self.parts() {
            whole = whole.with(part.properties()?, part.middle, part.attitude());
        }
        whole.properties()
    }
}

const fn body(name: &'static str, sizes_from: &'static str, parts: fn(&mut dyn FnMut(Part))) -> NamedBody {
    NamedBody { name, sizes_from, parts }
}

const ALL: [NamedBody; 8] = [
    body("the box", "the book's worked example", |put| put(THE_BOX.part("box", "even"))),
    body("the book", "a standard paperback format; thickness and mass worked out from its paper", |put| {
        put(BOOK.part("pages", "paper"));
    }),
    body("the phone", "its maker's published sizes, evenly filled", |put| put(PHONE.part("phone", "even"))),
    body("the remote control", "its maker's published sizes, evenly filled", |put| {
        put(REMOTE_CONTROL.part("remote control", "even"));
    }),
    body("the hammer", "typical, chosen by us; textbook densities", steel::hammer),
    body("the tennis racket", "typical, chosen by us; compared with a measured racket", racket::parts),
    body("the wing nut", "a standard's table for thread M10; its wings simplified by us", steel::wing_nut),
    body("the T-handle", "chosen by us", steel::t_handle),
];

/// Every named body, in the order in which the book meets them.
#[must_use]
pub fn all() -> &'static [NamedBody] {
    &ALL
}

/// The box of the worked example: 2 m along x, 1 m along y, 3 m along z, 1 kg. Moments 10/12, 13/12 and 5/12.
///
/// # Errors
/// None: the sizes are constants.
pub fn the_box() -> Result<MassProperties, Error> {
    ALL[0].properties()
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
    ALL[1].properties()
}

/// A phone: 71.6 mm by 7.80 mm by 147.6 mm, 171 g.
///
/// The outer sizes and the mass of an iPhone 15 as its maker publishes them. That it is evenly filled is our
/// simplification: a real phone's battery and cameras shift its centre a little.
///
/// # Errors
/// None: the sizes are constants.
pub fn phone() -> Result<MassProperties, Error> {
    ALL[2].properties()
}

/// A remote control: 35 mm by 9.25 mm by 136 mm, 63 g.
///
/// The outer sizes and the mass of a Siri Remote (second generation) as its maker publishes them. That it is
/// evenly filled is our simplification.
///
/// # Errors
/// None: the sizes are constants.
pub fn remote_control() -> Result<MassProperties, Error> {
    ALL[3].properties()
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
    ALL[4].properties()
}

/// A tennis racket, 685 mm long and 0.327 kg: an oval hoop with 16 by 19 strings, two throat bars and a
/// handle, with the handle along z and the strings in the xz plane.
///
/// The sizes are typical and chosen by us, within the rules of tennis (at most 737 mm by 317 mm, ITF Rules of
/// Tennis, appendix II). A real racket to compare it with: the Wilson T-2000 that Brody measured had 0.00121,
/// 0.01638 and 0.01748 kg m² ([Bro85](crate::references) as quoted in [Ash91](crate::references)).
///
/// # Errors
/// None: the sizes are constants.
pub fn tennis_racket() -> Result<MassProperties, Error> {
    ALL[5].properties()
}

/// A wing nut for thread M10, of steel: a round boss along x with its wings spread along z. It comes off its
/// screw spinning about x, the middle axis.
///
/// Boss and span are those that UNI 5448 lists for M10 (boss 16.5 mm wide and 6.8 mm high, 36.2 mm over the
/// wings, whose edges are 3.3 mm thick and reach 17.7 mm high; about 13.5 g), as quoted in dealers' tables:
/// likely, not checked against the standard itself. The wings slant; ours are upright plates as high as two
/// thirds of theirs, the hole is 9 mm wide. Nobody published the sizes of the nut that flipped in orbit.
///
/// # Errors
/// None: the sizes are constants.
pub fn wing_nut() -> Result<MassProperties, Error> {
    ALL[6].properties()
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
    ALL[7].properties()
}
