//! The closed form on number types other than `f64`: its sums on symbols, for proofs of the laws, and the
//! whole motion on enclosures of real numbers.
//!
//! [`FreeMotion`](super::FreeMotion) runs the same code on `f64`.

pub use super::cayley_klein::{ComplementaryPair, DirectPair};
pub use super::elliptic::{ComplementarySeries, DirectSeries, Parts};

use super::elliptic_motion::EllipticMotion;
use crate::dynamics::invariants::{Asymmetric, discriminant};
use crate::number::Real;
use nalgebra::{Quaternion, Vector3};

/// The free motion of a body with three different moments, neither steady nor on the separatrix, on any
/// [`Real`] numbers.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::{PrincipalMoments, exact::FreeMotion, laws::ClosedForm};
/// let (moments, omega) = ([1.0, 2.0, 3.0], [0.1, 2.0, 0.3]);
/// let motion = ClosedForm::new(moments, omega).unwrap();
/// let known = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 3.0)?, &omega.into())?;
/// assert_eq!(motion.at(9.0).0, known.at(9.0)?.omega);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct ClosedForm<T> {
    motion: EllipticMotion<T>,
    clock: i32,
}

impl<T: Real> ClosedForm<T> {
    /// From the principal moments (kg m²) and the spin (rad/s) along their axes. `None` where the enclosures
    /// do not determine which moment is the middle one or which axis the spin circles, and for any other kind
    /// of motion.
    #[must_use]
    pub fn new(moments: [T; 3], omega: [T; 3]) -> Option<Self> {
        let mut order = [0, 1, 2];
        for (a, b) in [(0, 1), (1, 2), (0, 1)] {
            if moments[order[b]].lt(moments[order[a]]) {
                order.swap(a, b);
            }
        }
        let [low, middle, high] = order.map(|axis| moments[axis]);
        if !(T::zero() < low && low < middle && middle < high) {
            return None;
        }
        let difference = |i: &[T; 3], scale: i32| discriminant(i, &omega, &order, scale)[1];
        let motion = Asymmetric::new(moments, order, omega, difference);
        let steady = |axis: usize| omega[axis] == T::zero();
        if !motion.off_the_separatrix() || (steady(motion.across) && steady(motion.middle)) {
            return None;
        }
        Some(Self { motion: EllipticMotion::new(&motion, &omega).ok()?, clock: motion.clock })
    }

    /// The spin in body axes, rad/s, and the turn since the start, from body to world, at a time in seconds.
    #[must_use]
    pub fn at(&self, time: T) -> (Vector3<T>, Quaternion<T>) {
        self.motion.at(time.times_power_of_two(self.clock))
    }

    /// The half periods from the flip nearest to the start until a time in seconds: at whole numbers the spin
    /// along the middle axis is zero.
    #[must_use]
    pub fn half_periods(&self, time: T) -> T {
        self.motion.half_periods_since_flip(time.times_power_of_two(self.clock))
    }

    /// Half the period of the spin, from one flip to the next, s.
    #[must_use]
    pub fn half_period(&self) -> T {
        self.motion.span_of_half_period().times_power_of_two(-self.clock)
    }
}
