//! The free motion of a body, enclosed: the library's own closed form, run on intervals.
//!
//! All of it, from moments and spin to spin and attitude, is the code that runs on floats ([`ClosedForm`]),
//! with bounds on the remainders of the sums added.

use super::real::Enclosed;
use super::{Interval, whole};
use nalgebra::{Quaternion, Vector3};
use num_traits::Zero;
use std::fmt;
use tumbling::laws::ClosedForm;

/// The free motion of a body with three different moments that is neither steady nor on the separatrix.
#[derive(Debug, Clone)]
pub struct FreeMotion {
    moments: Vector3<Interval>,
    motion: ClosedForm<Enclosed>,
    starts_at_a_flip: bool,
}

/// The reason why a motion is not enclosed: the intervals do not determine its kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Open {
    /// It is undecided which moment is the middle one, or whether two are equal.
    Moments,
    /// It is undecided which axis the spin circles, or whether the motion is steady.
    Spin,
}

impl fmt::Display for Open {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Moments => "the intervals of the moments leave open which is the middle one",
            Self::Spin => "the intervals of the spin leave open which axis it circles, or it is steady",
        })
    }
}

impl std::error::Error for Open {}

/// If the phase is wider than this fraction of a half period, the series are not known to hold.
const WIDEST: f64 = 0.25;

/// An instant: the spin in body axes, rad/s, and the turn since the start, from body to world.
type Instant = (Vector3<Interval>, Quaternion<Interval>);

impl FreeMotion {
    /// From the principal moments (kg m²) and the spin (rad/s) along their axes, in any order.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling_proofs::{Interval, given, interval::motion::FreeMotion};
    /// let moments: Vector3<Interval> = Vector3::new(given!(10), given!(13), given!(5));
    /// let omega = Vector3::new(given!(10), given!(1), given!(0));
    /// let motion = FreeMotion::new(&moments, &omega).unwrap();
    /// assert_eq!(format!("{:.2} s", motion.between_flips()), "1.38 s");
    /// ```
    ///
    /// # Errors
    /// Intervals that leave open which kind of motion it is.
    pub fn new(moments: &Vector3<Interval>, omega: &Vector3<Interval>) -> Result<Self, Open> {
        let [a, b, c] = [moments.x, moments.y, moments.z];
        let apart = |x: Interval, y: Interval| x < y || y < x;
        let positive = moments.iter().all(|i| *i > Interval::zero());
        if !(positive && apart(a, b) && apart(b, c) && apart(c, a)) {
            return Err(Open::Moments);
        }
        let middle = (0..3).find(|&k| {
            let below = |j: usize| moments[(k + j) % 3] < moments[k];
            below(1) != below(2)
        });
        let motion = ClosedForm::new((*moments).map(Enclosed).into(), (*omega).map(Enclosed).into());
        let starts_at_a_flip = middle.is_some_and(|k| omega[k].is_zero());
        Ok(Self { moments: *moments, motion: motion.ok_or(Open::Spin)?, starts_at_a_flip })
    }

    /// The spin at a time (s), rad/s; all numbers if nothing is known of it.
    #[must_use]
    pub fn omega(&self, t: Interval) -> Vector3<Interval> {
        self.at(t).0
    }

    /// The momentum in body axes at a time (s), kg m²/s.
    #[must_use]
    pub fn momentum(&self, t: Interval) -> Vector3<Interval> {
        self.moments.component_mul(&self.omega(t))
    }

    /// The spin in body axes (rad/s) and the attitude, from body to world and up to its sign, at a time (s);
    /// the world axes are the body's axes at time 0. Both are all numbers if nothing is known of them. This
    /// happens if, however short the parts into which the time is divided, the phase is wider than a quarter
    /// of the time between flips.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling_proofs::{Interval, given, interval::motion::FreeMotion};
    /// let moments: Vector3<Interval> = Vector3::new(given!(1), given!(2), given!(3));
    /// let motion = FreeMotion::new(&moments, &Vector3::new(given!(0.5), given!(1), given!(2))).unwrap();
    /// let (spin, attitude) = motion.at(given!(1000000000)); // 646 million flips later
    /// assert!(spin.y.width() < 1e-14 && attitude.coords.w.width() < 1e-5);
    /// ```
    #[must_use]
    pub fn at(&self, t: Interval) -> Instant {
        self.in_parts(t, 12)
    }

    fn in_parts(&self, t: Interval, halvings: u32) -> Instant {
        if self.half_periods(t).width() <= WIDEST {
            let (spin, turn) = self.motion.at(Enclosed(t));
            return (spin.map(|x| x.0), turn.coords.map(|x| x.0).into());
        }
        let middle = 0.5 * t.low + 0.5 * t.high;
        if halvings == 0 || !(t.low < middle && middle < t.high) {
            return (Vector3::repeat(Interval::ALL), Quaternion::from_vector([Interval::ALL; 4].into()));
        }
        let parts = [Interval { high: middle, ..t }, Interval { low: middle, ..t }];
        let [(spin, turn), (later, turned)] = parts.map(|part| self.in_parts(part, halvings - 1));
        (spin.zip_map(&later, Interval::hull), turn.coords.zip_map(&turned.coords, Interval::hull).into())
    }

    /// The number of half periods from the flip nearest to the start until a time, s.
    fn half_periods(&self, t: Interval) -> Interval {
        self.motion.half_periods(Enclosed(t)).0
    }

    /// The time from one flip to the next, s.
    #[must_use]
    pub fn between_flips(&self) -> Interval {
        self.motion.half_period().0
    }

    /// The time of the flip with this number after the start, counted from 0, s: there the spin along the
    /// middle axis is zero. A flip exactly at the start does not count. All numbers if it is undecided
    /// whether a flip has passed.
    #[must_use]
    pub fn flip(&self, number: u32) -> Interval {
        let (zero, start) = (Interval::zero(), self.half_periods(Interval::zero()));
        let ahead = if self.half_periods(self.between_flips()) > start { start } else { -start };
        let to_come = (-1..=1).map(|halves| whole(halves) - ahead);
        // A start at a flip is one of these zeros itself.
        let mut open = to_come.filter(|gap| !(*gap < zero || (self.starts_at_a_flip && gap.has_zero())));
        let Some(first) = open.next().filter(|gap| *gap > zero) else { return Interval::ALL };
        (first + whole(number)) * self.between_flips()
    }

    /// The number of flips from the start to this time, s, as an interval of one number, if it is certain.
    #[must_use]
    pub fn flips_until(&self, end: Interval) -> Interval {
        let mut count = 0;
        while count < 1_000_000 && self.flip(count) < end {
            count += 1;
        }
        if self.flip(count) > end { whole(count) } else { Interval::ALL }
    }
}

/// A body's name, its moments (kg m²) and its spin (rad/s).
pub type Body = (&'static str, [f64; 3], [f64; 3]);

/// Six bodies whose numbers are all floats: see [`widths`].
pub const BODIES: [Body; 6] = [
    ("box", [10.0, 13.0, 5.0], [1.0, 0.25, 0.5]),
    ("racket", [1.25, 16.5, 17.75], [0.25, 10.0, 0.125]),
    ("needle", [1.0, 1.00048828125, 0.0009765625], [0.5, 0.25, 8.0]),
    ("plate", [1.0, 2.0, 3.0], [0.5, 1.0, 2.0]),
    ("next to the separatrix", [5.0, 10.0, 13.0], [0.0, 1.0, 9.094947017729282e-13]),
    ("nearly a ball", [1.0, 1.0009765625, 1.00390625], [1.0, 0.5, 0.25]),
];

/// The numbers of flips after which their widths are listed.
pub const FLIPS: [f64; 4] = [1.0, 1e3, 1e6, 1e9];

/// The free motion of a body whose moments and spin are these floats, and the float next to the time of this
/// many times that between its flips.
///
/// # Errors
/// As [`FreeMotion::new`].
pub fn of_floats(moments: [f64; 3], omega: [f64; 3], flips: f64) -> Result<(FreeMotion, f64), Open> {
    let numbers = |x: [f64; 3]| x.map(whole).into();
    let motion = FreeMotion::new(&numbers(moments), &numbers(omega))?;
    let late = flips * motion.between_flips().low();
    Ok((motion, late))
}

/// The widths of the enclosures at that time: of the spin relative to its size, and of the attitude.
///
/// # Errors
/// As [`FreeMotion::new`].
pub fn widths(moments: [f64; 3], omega: [f64; 3], flips: f64) -> Result<[f64; 2], Open> {
    let (motion, t) = of_floats(moments, omega, flips)?;
    let (spin, turn) = motion.at(Interval { low: t, high: t });
    let widest = |x: &[Interval]| x.iter().map(|x| x.width()).fold(0.0, f64::max);
    let size = spin.iter().map(|x| x.abs().high()).fold(0.0, f64::max);
    Ok([widest(spin.as_slice()) / size, widest(turn.coords.as_slice())])
}

/// A row of the book's table for each of [`BODIES`]: the widest spin, and the attitude after [`FLIPS`].
///
/// # Errors
/// As [`FreeMotion::new`].
pub fn table() -> Result<Vec<String>, Open> {
    let row = |(name, moments, omega): &Body| {
        let mut found = [[0.0; 2]; 4];
        for (found, flips) in found.iter_mut().zip(FLIPS) {
            *found = widths(*moments, *omega, flips)?;
        }
        let spin = found.iter().map(|widths| widths[0]).fold(0.0, f64::max);
        let attitude: Vec<_> = found.iter().map(|widths| format!("{:.0e}", widths[1])).collect();
        Ok(format!("| {name} | {spin:.0e} | {} |", attitude.join(" | ")))
    };
    BODIES.iter().map(row).collect()
}
