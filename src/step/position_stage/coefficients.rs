//! The coefficients of a body for the position stage, computed once.

use super::turn::{conserving_rate, three};
use super::{longest, number};
use crate::error::{Error, Refusal, Subject, not_negative};
use crate::inertia::ascending;
use crate::number::Field;
use num_traits::Float;

/// Dimensionless numbers: the unit of mass cancels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Coefficients<T> {
    /// `(I_j - I_k) / I_i`.
    pub(super) coupling: [T; 3],
    /// The moments in units of the middle one.
    pub(super) relative: [T; 3],
    /// The first term of the series for the turn about the momentum: factors of the squares of the spin's
    /// components.
    pub(super) twist: [T; 3],
    /// The second term: factors of the products of two such squares, 11, 12, 13, 22, 23, 33.
    pub(super) twist_2: [T; 6],
    /// A bound on the square of the fastest spin of the motion: factors of the squares of the spin's
    /// components.
    pub(super) bound: [T; 3],
    /// A turn whose square is at most this needs no gyroscopic term: the body is round, or the term is below
    /// rounding.
    pub(super) steady: T,
}

impl<T: Field + Float + From<f32>> Coefficients<T> {
    pub(super) fn of_moments(moments: [T; 3]) -> Result<Self, Error> {
        for moment in moments {
            valid(Subject::Moment, moment)?;
        }
        if moments.contains(&T::zero()) {
            return Self::of_rod(moments);
        }
        let [a, b, c] = moments;
        Self::new(moments, [(b - c) / a, (c - a) / b, (a - b) / c]).representable()
    }

    /// An error if a coefficient overflows.
    fn representable(self) -> Result<Self, Error> {
        let all = [&self.relative[..], &self.twist, &self.twist_2, &self.bound];
        match all.into_iter().flatten().find(|x| !x.is_finite()) {
            Some(x) => Err(Refusal::OutOfRange { what: Subject::MomentRatio, value: value(*x) }.into()),
            None => Ok(self),
        }
    }

    /// A zero moment: a spin about that axis has no momentum, and no gyroscopic torque acts on it if the
    /// other moments are equal.
    fn of_rod(moments: [T; 3]) -> Result<Self, Error> {
        let [i, j, k] = order_of(&moments);
        let sorted = [i, j, k].map(|n| value(moments[n]));
        let excess = sorted[2] - sorted[1];
        Refusal::TriangleInequality { moments: sorted, excess, tolerance: 0.0, printed: false }
            .when(moments[j] != moments[k])?;
        if moments[k] == T::zero() {
            return Ok(Self::constant_spin());
        }
        let mut coupling = [T::zero(); 3];
        coupling[(i + 1) % 3] = T::one();
        coupling[(i + 2) % 3] = -T::one();
        Ok(Self::new(moments, coupling))
    }

    pub(super) fn of_inverse_moments(inverse: [T; 3]) -> Result<Self, Error> {
        for x in inverse {
            valid(Subject::InverseMoment, x)?;
        }
        if inverse.contains(&T::zero()) {
            return Ok(Self::constant_spin());
        }
        Self::of_moments(inverse.map(|x| T::one() / x))
    }

    /// Locked axes: the spin is constant.
    fn constant_spin() -> Self {
        Self::new([T::one(); 3], [T::zero(); 3])
    }

    fn new(moments: [T; 3], coupling: [T; 3]) -> Self {
        let n = number::<T>;
        let middle = order_of(&moments)[1];
        let (mut twist, mut twist_2) = ([T::zero(); 3], [T::zero(); 6]);
        let axes = [middle, (middle + 1) % 3, (middle + 2) % 3];
        let (y, z) = (coupling[axes[1]], coupling[axes[2]]);
        let yz = y * z;
        let one = T::one();
        let below = n(12.0);
        for (axis, x) in axes.into_iter().zip([one + yz, one + z, one - y]) {
            twist[axis] = x / below;
        }
        // From the exact motion, as the powers of the preprocessed Moser-Veselov algorithm are.
        let first = [
            (n(6.0) - yz) * (one + yz),
            n(2.0) * (n(6.0) + n(3.0) * (yz + z) + n(4.0) * (y - one) * z * z),
            n(2.0) * (n(6.0) + n(3.0) * (yz - y) - n(4.0) * (z + one) * y * y),
            (one + z) * (n(6.0) + n(7.0) * yz + z * z) / (one + yz),
            n(2.0)
                * (n(6.0) - yz * (n(2.0) + n(3.0) * (y - z)) - n(4.0) * (y * y + z * z) + n(3.0) * (z - y))
                / (one + yz),
            (one - y) * (n(6.0) + n(7.0) * yz + y * y) / (one + yz),
        ];
        let pairs = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
        for ((i, j), x) in pairs.into_iter().zip(first) {
            let (i, j) = (axes[i].min(axes[j]), axes[i].max(axes[j]));
            twist_2[pairs.iter().position(|&pair| pair == (i, j)).unwrap_or(0)] = x / n(720.0);
        }
        let bound = bound(&moments, &coupling);
        let rounding = T::epsilon() / n(4.0);
        let steady = if coupling == [T::zero(); 3] {
            longest()
        } else {
            rounding * rounding / bound[0].max(bound[1]).max(bound[2])
        };
        Self { coupling, relative: moments.map(|x| x / moments[middle]), twist, twist_2, bound, steady }
    }

    /// An upper bound on the square of the turn in time `h`, at any spin of the motion.
    #[inline(always)]
    pub(super) fn fastest(&self, omega: &[T; 3], h: T) -> T {
        let [x, y, z] = three(|i| (omega[i] * h) * (omega[i] * h));
        self.bound[0] * x + self.bound[1] * y + self.bound[2] * z
    }

    /// The rate and the weights for [`conserving_turn`](crate::laws::conserving_turn).
    #[inline(always)]
    pub(super) fn rate(&self, omega: &[T; 3], h: T) -> (T, [T; 3]) {
        let one = T::one();
        let [x, y, z] = three(|i| (omega[i] * h) * (omega[i] * h));
        let [a, b, c] = self.coupling;
        let rate = conserving_rate([b * c * x, c * a * y, a * b * z], |n| one / number::<T>(n.into()));
        let s = &self.twist_2;
        let twist = self.twist[0] * x + self.twist[1] * y + self.twist[2] * z;
        let more = x * (s[0] * x + s[1] * y + s[2] * z) + y * (s[3] * y + s[4] * z) + z * (s[5] * z);
        let twist = twist + more * (one + twist * (number::<T>(17.0) / number::<T>(14.0)));
        (rate, three(|i| one + self.relative[i] * twist))
    }
}

/// A linear form in the squares of the spin's components that is an upper bound on the square of every later
/// spin. No coefficient is below the square of any coupling; the proof that the roots of a step are real uses
/// this.
pub(crate) fn bound<T: Field + Float + From<f32>>(moments: &[T; 3], coupling: &[T; 3]) -> [T; 3] {
    let one = T::one();
    let order = order_of(moments);
    let [a, b, c] = order.map(|i| moments[i]);
    // The largest amount that one component can pass to another.
    let share = |[weight, over]: [T; 2], [apart, span]: [T; 2]| {
        if apart == T::zero() { T::zero() } else { (weight / over) * (apart / span) }
    };
    let mut bound = [one; 3];
    if a > T::zero() {
        bound[order[1]] = one + share([b, a], [c - b, c - a]) + share([b, c], [b - a, c - a]);
    }
    // The middle component can gain from both others, but never more than either limit allows.
    let (end, extra) =
        if c - b > b - a { (0, share([a, b], [c - a, c - b])) } else { (2, share([c, b], [c - a, b - a])) };
    bound[order[end]] = one + extra;
    // For moments that no solid has, the series converge only for shorter times.
    let strongest = coupling.iter().fold(one, |most, x| most.max(x.abs()));
    bound.map(|x| x * strongest * strongest)
}

pub(super) fn value<T: Float>(x: T) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

/// Checks that a number of either type is finite and not negative.
fn valid<T: Float>(what: Subject, x: T) -> Result<(), Error> {
    not_negative(what, value(x)).map(drop)
}

/// The axes, smallest moment first.
fn order_of<T: Float>(moments: &[T; 3]) -> [usize; 3] {
    ascending(&moments.map(value).into())
}
