//! Many free motions at once: bodies with the same kind of motion are computed in the lanes of one vector.

mod group;

use super::elementary::{TopSpin, Turn};
use super::elliptic_motion::{
    ComplementaryAttitude, ComplementarySpin, DirectAttitude, DirectSpin, EllipticMotion,
};
use super::{FreeMotion, Instant, Motion};
use crate::error::{Error, Subject, finite};
use crate::number::Rounding;
use alloc::vec::Vec;
use core::marker::PhantomData;
use group::Group;
use nalgebra::Vector3;

/// Many bodies in free motion, computed together: as many at once as the number type has
/// [lanes](crate::laws::Lane).
///
/// Every result equals that of [`FreeMotion::at`] to the last bit, whatever the other bodies and their
/// order: bodies are sorted by their kind of motion, the same functions run on several numbers at once, and
/// the last lanes of a kind are filled with copies. A body on the separatrix or extremely near it, or with
/// a spin outside 1e±180 rad/s, is computed alone.
///
/// The answer `A` is spin and attitude as an [`Instant`], or the spin alone as a `Vector3<f64>` in body axes
/// (rad/s): then the constants and the computation for attitudes are omitted.
///
/// With `f64`, which is one lane, a batch of many instants a call is about as fast as its bodies one by one;
/// with one instant a call it is slower. The crate `tumbling-scenes` has types with four lanes:
/// arrays that the compiler turns into vector instructions.
///
/// A batch of some hundred bodies fits the second-level cache of a processor; for more bodies, make several
/// batches.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::{PrincipalMoments, exact::{Batch, FreeMotion}};
/// let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
/// let motions = [[0.0, 0.0, 5.0], [1.0, 2.0, 3.0], [0.0, 10.0, 0.001]]
///     .into_iter()
///     .map(|omega| FreeMotion::new(moments, &omega.into()))
///     .collect::<Result<Vec<_>, _>>()?;
/// // `f64` is one lane. A vector type that implements `laws::Lane` answers several bodies at once, with
/// // the same bits.
/// let (both, spins) = (Batch::<f64>::new(&motions), Batch::<f64, Vector3<f64>>::new(&motions));
/// let times = [1.0, 1e6];
/// both.each(&times, |time, body, instant| {
///     assert_eq!(Ok(instant), motions[body].at(times[time]));
/// })?;
/// spins.each(&times, |time, body, omega| assert_eq!(Ok(omega), motions[body].omega(times[time])))?;
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Batch<T, A = Instant> {
    direct: Group<T, DirectSpin<T>, DirectAttitude<T>>,
    complementary: Group<T, ComplementarySpin<T>, ComplementaryAttitude<T>>,
    tops: Group<T, TopSpin<T>, Turn<T>>,
    steady: Group<T, Vector3<T>, Turn<T>>,
    alone: Vec<(usize, FreeMotion)>,
    /// As they were given.
    starts: Vec<Instant>,
    answer: PhantomData<A>,
}

/// A kind of answer of a batch.
pub trait Answer {
    /// Whether it has an attitude.
    const ATTITUDE: bool;

    /// Made from the state of a body at an instant; the attitude is arbitrary if it is not needed.
    fn of(instant: Instant) -> Self;
}

impl Answer for Instant {
    const ATTITUDE: bool = true;

    #[inline(always)]
    fn of(instant: Instant) -> Self {
        instant
    }
}

impl Answer for Vector3<f64> {
    const ATTITUDE: bool = false;

    #[inline(always)]
    fn of(instant: Instant) -> Self {
        instant.omega
    }
}

impl<T: Rounding, A: Answer> Batch<T, A> {
    /// Prepares these motions; the index of a body is its position in this list.
    #[must_use]
    pub fn new(motions: &[FreeMotion]) -> Self {
        fn elliptic(motion: &FreeMotion) -> Option<&EllipticMotion> {
            if let Motion::Elliptic(elliptic) = &motion.law { Some(elliptic) } else { None }
        }
        fn alone(motion: &FreeMotion) -> bool {
            elliptic(motion).is_some_and(|e| e.direct().is_none() && e.complementary().is_none())
        }
        Self {
            direct: Group::new(motions, A::ATTITUDE, |motion| elliptic(motion)?.direct()),
            complementary: Group::new(motions, A::ATTITUDE, |motion| elliptic(motion)?.complementary()),
            tops: Group::new(motions, A::ATTITUDE, |motion| match &motion.law {
                Motion::Symmetric(top) => Some((&top.spin, &top.about_momentum)),
                _ => None,
            }),
            steady: Group::new(motions, A::ATTITUDE, |motion| match &motion.law {
                Motion::AtRest => Some((&motion.start, &Turn::NONE)),
                Motion::Steady(turn) => Some((&motion.start, turn)),
                _ => None,
            }),
            alone: motions.iter().copied().enumerate().filter(|(_, motion)| alone(motion)).collect(),
            starts: motions.iter().map(FreeMotion::first).collect(),
            answer: PhantomData,
        }
    }

    /// Computes every body at each of `times`. `put` is called with the index of the time, the index of the
    /// body, and the answer, in no particular order.
    ///
    /// # Errors
    /// A time that is not finite; `put` is then never called.
    // Inlined, as all in it but rare cases, so that it is compiled for the vectors of a caller that has them.
    #[inline(always)]
    pub fn each(&self, times: &[f64], mut put: impl FnMut(usize, usize, A)) -> Result<(), Error> {
        for &t in times {
            finite(Subject::Time, t)?;
        }
        self.direct.each(times, &self.starts, &mut put);
        self.complementary.each(times, &self.starts, &mut put);
        self.tops.each(times, &self.starts, &mut put);
        self.steady.each(times, &self.starts, &mut put);
        for (body, motion) in &self.alone {
            for (k, &t) in times.iter().enumerate() {
                put(k, *body, A::of(motion.at(t)?));
            }
        }
        Ok(())
    }
}
