//! The bodies of the book's stories.
//!
//! All have the same orientation: the longest side is along z, so that z is the axis with the smallest
//! moment, y the axis with the largest, and **x the middle axis**, about which a body flips, as in the book's
//! box.
//!
//! Each is a list of straight [parts](NamedBody::each_part), from which its mass properties are computed;
//! drawings are made of the same parts.
//!
//! ```
//! use tumbling::{Axis, body::named::NamedBody};
//! for body in NamedBody::ALL {
//!     let principal = body.properties()?.inertia().principal();
//!     assert!(principal.axis(Axis::Middle).x > 1.0 - 1e-12, "{body}");
//! }
//! # Ok::<(), tumbling::Error>(())
//! ```

mod part;
mod sizes;

use part::Fill;
pub use part::{Part, Section};
use sizes::REMOTE_CONTROL;
pub use sizes::{BOOK, Even, PHONE, THE_BOX};

use crate::error::Error;
use crate::inertia::{Inertia, point_mass};
use crate::solid::{MassMoments, MassProperties};
use core::fmt;
use nalgebra::{Matrix3, Vector3};

/// A body with a name, and where its sizes come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum NamedBody {
    /// The box of the worked example: 2 m along x, 1 m along y, 3 m along z, 1 kg. Moments 10/12, 13/12 and
    /// 5/12.
    TheBox,
    /// A paperback of 320 pages, held shut by a rubber band.
    ///
    /// B-format, 129 mm by 198 mm, is a standard British paperback size. The rest is worked out by us for
    /// common paper: 160 leaves at 80 g/m² and a cover at 250 g/m² front and back make 0.340 kg; at 0.125 mm
    /// a leaf they are 20 mm thick.
    Book,
    /// A phone: 71.6 mm by 7.80 mm by 147.6 mm, 171 g.
    ///
    /// The outer sizes and the mass of an iPhone 15 as its maker publishes them. That it is evenly filled is
    /// our simplification: a real phone's battery and cameras shift its centre a little.
    Phone,
    /// A remote control: 35 mm by 9.25 mm by 136 mm, 63 g.
    ///
    /// The outer sizes and the mass of a Siri Remote (second generation) as its maker publishes them. That it
    /// is evenly filled is our simplification.
    RemoteControl,
    /// A hammer: a steel head of 100 mm by 32 mm by 32 mm across the end of an ash handle 290 mm long and 29
    /// mm thick. Head along x, handle along z.
    ///
    /// Typical of a club hammer with a head of about 0.8 kg; the sizes are chosen by us, the densities are
    /// textbook values. The handle ends where the head begins.
    Hammer,
    /// A tennis racket, 685 mm long and 0.327 kg: an oval hoop with 16 by 19 strings, two throat bars and a
    /// handle, with the handle along z and the strings in the xz plane.
    ///
    /// The sizes are typical and chosen by us, within the rules of tennis (at most 737 mm by 317 mm, ITF
    /// Rules of Tennis, appendix II). A real racket to compare it with: the Wilson T-2000 that Brody measured
    /// had 0.00121, 0.01638 and 0.01748 kg m² ([Bro85](crate::references) as quoted in
    /// [Ash91](crate::references)).
    TennisRacket,
    /// A wing nut for thread M10, of steel: a round boss along x with its wings spread along z. It comes off
    /// its screw spinning about x, the middle axis.
    ///
    /// The sizes of boss and span are those of UNI 5448 for M10 (boss 16.5 mm wide and 6.8 mm high, 36.2 mm
    /// over the wings, whose edges are 3.3 mm thick and reach 17.7 mm high; about 13.5 g), as quoted in
    /// dealers' tables: probably right, but not checked against the standard itself. Real wings slant; ours
    /// are upright plates with two thirds of their height. The hole is 9 mm wide. Nobody published the sizes
    /// of the nut that flipped in orbit.
    WingNut,
    /// A T-handle of steel rod 12 mm thick: a crossbar of 100 mm along z, and a stem of 50 mm along x from
    /// its middle. It spins about its stem, the middle axis.
    ///
    /// The shape is that of the handle often filmed in orbit; its sizes are chosen by us. The stem ends where
    /// the crossbar begins.
    THandle,
}

impl NamedBody {
    /// All bodies, in the order in which the book introduces them.
    pub const ALL: [Self; 8] = [
        Self::TheBox,
        Self::Book,
        Self::Phone,
        Self::RemoteControl,
        Self::Hammer,
        Self::TennisRacket,
        Self::WingNut,
        Self::THandle,
    ];

    /// Calls `put` with each of the solids of the body.
    pub fn each_part(self, put: &mut dyn FnMut(Part)) {
        match self {
            Self::TheBox => put(THE_BOX.part("box", "even")),
            Self::Book => put(BOOK.part("pages", "paper")),
            Self::Phone => put(PHONE.part("phone", "even")),
            Self::RemoteControl => put(REMOTE_CONTROL.part("remote control", "even")),
            Self::Hammer => sizes::hammer(put),
            Self::TennisRacket => sizes::racket(put),
            Self::WingNut => sizes::wing_nut(put),
            Self::THandle => sizes::t_handle(put),
        }
    }

    /// Its mass, centre and inertia, each to a few units in the last place: those of its parts by the
    /// parallel-axis theorem. Without the code that checks a tensor, for a program that must be small.
    #[must_use]
    pub fn moments(self) -> MassMoments<f64> {
        let (mut mass, mut first) = (0.0, Vector3::zeros());
        self.each_part(&mut |part| {
            mass += part.mass;
            first += part.middle * part.mass;
        });
        let centre = first / mass;
        let mut inertia = Matrix3::zeros();
        self.each_part(&mut |part| {
            inertia += part.inertia() + point_mass(&part.mass, &(part.middle - centre));
        });
        MassMoments { mass, centre, inertia }
    }

    /// Its [moments](Self::moments), as those of a body.
    ///
    /// # Errors
    /// There are none: the sizes are constants.
    pub fn properties(self) -> Result<MassProperties, Error> {
        let MassMoments { mass, centre, inertia } = self.moments();
        MassProperties::new(mass, &centre, Inertia::try_from(inertia)?)
    }
}

/// What it is called, as in "the phone".
impl fmt::Display for NamedBody {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::TheBox => "the box",
            Self::Book => "the book",
            Self::Phone => "the phone",
            Self::RemoteControl => "the remote control",
            Self::Hammer => "the hammer",
            Self::TennisRacket => "the tennis racket",
            Self::WingNut => "the wing nut",
            Self::THandle => "the T-handle",
        })
    }
}
