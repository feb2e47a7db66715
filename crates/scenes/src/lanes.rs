//! Several numbers side by side, in arrays that the compiler turns into vector instructions.
//!
//! Each operation is a loop over an array that contains only operations that round as on `f64`.

use num_traits::{One, Zero};
use std::array::from_fn;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use tumbling::laws::{Lane, Series};

/// `N` numbers side by side. `FUSED` where the machine has an instruction for the fused product sum: without
/// one it is a function of the C library, and Dekker's product is faster. The answers are the same.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub(crate) struct Lanes<const N: usize, const FUSED: bool>([f64; N]);

macro_rules! arithmetic {
    ($Op:ident, $op:ident, $Assign:ident, $assign:ident) => {
        impl<const N: usize, const FUSED: bool> $Op for Lanes<N, FUSED> {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: Self) -> Self {
                Self(from_fn(|k| self.0[k].$op(other.0[k])))
            }
        }
        impl<const N: usize, const FUSED: bool> $Op<f64> for Lanes<N, FUSED> {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: f64) -> Self {
                Self(self.0.map(|x| x.$op(other)))
            }
        }
        impl<const N: usize, const FUSED: bool> $Assign for Lanes<N, FUSED> {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                *self = self.$op(other);
            }
        }
    };
}
arithmetic!(Add, add, AddAssign, add_assign);
arithmetic!(Sub, sub, SubAssign, sub_assign);
arithmetic!(Mul, mul, MulAssign, mul_assign);
arithmetic!(Div, div, DivAssign, div_assign);

/// Functions of each number alone.
macro_rules! alone {
    ($($name:ident: $of:expr),*) => {
        $(#[inline(always)]
        fn $name(self) -> Self {
            Self(self.0.map($of))
        })*
    };
}

impl<const N: usize, const FUSED: bool> Neg for Lanes<N, FUSED> {
    type Output = Self;
    alone!(neg: |x| -x);
}

impl<const N: usize, const FUSED: bool> Zero for Lanes<N, FUSED> {
    #[inline(always)]
    fn zero() -> Self {
        Self([0.0; N])
    }
    fn is_zero(&self) -> bool {
        self.0 == [0.0; N]
    }
}

impl<const N: usize, const FUSED: bool> One for Lanes<N, FUSED> {
    #[inline(always)]
    fn one() -> Self {
        Self([1.0; N])
    }
}

impl<const N: usize, const FUSED: bool> Series for Lanes<N, FUSED> {}
impl<const N: usize, const FUSED: bool> tumbling::laws::Rounding for Lanes<N, FUSED> {}

impl<const N: usize, const FUSED: bool> Lane for Lanes<N, FUSED> {
    /// All bits of a lane or none, which is what a vector's comparison gives.
    type Mask = [u64; N];
    const WIDTH: usize = N;

    #[inline(always)]
    fn from_lanes(of: impl FnMut(usize) -> f64) -> Self {
        Self(from_fn(of))
    }

    #[inline(always)]
    fn lane(&self, k: usize) -> f64 {
        // A number too large says the first again.
        self.0[k % N]
    }

    #[inline(always)]
    fn lt(self, other: Self) -> [u64; N] {
        from_fn(|k| if self.0[k] < other.0[k] { u64::MAX } else { 0 })
    }

    #[inline(always)]
    fn any(mask: [u64; N]) -> bool {
        mask.iter().fold(0, |any, one| any | one) != 0
    }

    #[inline(always)]
    fn select(mask: [u64; N], yes: Self, no: Self) -> Self {
        Self(from_fn(|k| f64::from_bits(yes.0[k].to_bits() & mask[k] | no.0[k].to_bits() & !mask[k])))
    }

    alone!(abs: f64::abs, sqrt: f64::sqrt, round_ties_even: f64::round_ties_even);
    alone!(sign: |x| 1_f64.copysign(x));

    #[inline(always)]
    fn two_product_error(self, other: Self, product: Self) -> Self {
        if !FUSED && fits(self) && fits(other) {
            // Dekker's product, exact as long as nothing leaves the range on the way.
            let (a, b) = (split(self), split(other));
            return ((a[0] * b[0] - product) + a[0] * b[1] + a[1] * b[0]) + a[1] * b[1];
        }
        Self(from_fn(|k| self.0[k].mul_add(other.0[k], -product.0[k])))
    }
}

/// Whether a product of such numbers and all its parts are within the range.
#[inline(always)]
fn fits<const N: usize, const FUSED: bool>(x: Lanes<N, FUSED>) -> bool {
    x.abs().0.iter().fold(true, |all, x| all & ((1e-120..1e120).contains(x) | (*x == 0.0)))
}

/// Its upper 26 bits and the rest, Veltkamp's way.
#[inline(always)]
fn split<const N: usize, const FUSED: bool>(x: Lanes<N, FUSED>) -> [Lanes<N, FUSED>; 2] {
    let scaled = x * 134_217_729.0;
    let upper = scaled - (scaled - x);
    [upper, x - upper]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::side_by_side;
    use nalgebra::{UnitQuaternion, Vector3};
    use proptest::prelude::*;
    use tumbling::exact::{Batch, FreeMotion, Instant};

    fn any_number() -> impl Strategy<Value = f64> {
        prop_oneof![
            proptest::num::f64::ANY.prop_filter("a number", |x| !x.is_nan()),
            -1e3..1e3_f64,
            Just(-0.0),
            Just(0.5),
            Just(-1.5)
        ]
    }

    proptest! {
        // Independent: the same operation on each number alone.
        #[test]
        fn every_operation_rounds_in_every_lane_as_it_does_alone(
            a in proptest::array::uniform8(any_number()), b in proptest::array::uniform8(any_number()),
        ) {
            rounds_as_alone::<Lanes<4, false>>(&a, &b);
            rounds_as_alone::<Lanes<4, true>>(&a, &b);
        }
    }

    fn rounds_as_alone<T: Lane>(a: &[f64; 8], b: &[f64; 8]) {
        let (x, y) = (T::from_lanes(|k| a[k]), T::from_lanes(|k| b[k]));
        let same = |found: T, alone: fn(f64, f64) -> f64| {
            let both = |k: usize| [found.lane(k), alone(a[k], b[k])];
            let equal = |[x, y]: [f64; 2]| x.to_bits() == y.to_bits() || (x.is_nan() && y.is_nan());
            assert!((0..T::WIDTH).all(|k| equal(both(k))), "{found:?} of {a:?} and {b:?}");
        };
        same(x + y, |a, b| a + b);
        same(x - y, |a, b| a - b);
        same(x * y, |a, b| a * b);
        same(x / y, |a, b| a / b);
        same(-x, |a, _| -a);
        same(x.abs().sqrt(), |a, _| a.abs().sqrt());
        same(x.round_ties_even(), |a, _| a.round_ties_even());
        same(x.sign(), |a, _| 1_f64.copysign(a));
        same(T::select(x.lt(y), x, y), |a, b| if a < b { a } else { b });
        let left = |a: f64, b: f64| a.mul_add(b, -(a * b));
        // Where the product leaves the range nothing is promised.
        if (0..T::WIDTH).all(|k| !left(a[k], b[k]).is_nan()) {
            same(x.two_product_error(y, x * y), left);
        }
    }

    /// Motions of every kind: with their axes in every order, spun both ways, at every size, half of them
    /// starting turned.
    fn every_kind() -> Vec<FreeMotion> {
        let kinds: [([f64; 3], [f64; 3]); 12] = [
            ([2.0, 2.0, 2.0], [0.3, -1.0, 0.7]),
            ([1.0, 2.0, 2.5], [0.0, 0.0, 0.0]),
            ([1.0, 2.0, 2.5], [0.0, -3.0, 0.0]),
            ([2.0, 2.0, 3.0], [0.4, 0.5, -1.0]),
            ([2.0, 2.0, 1.0], [0.4, 0.5, 1.0]),
            ([1.0, 2.0, 2.5], [0.2, 0.3, 1.1]),
            ([1.0, 2.0, 2.5], [1.3, 0.2, -0.1]),
            ([1.0, 2.0, 2.5], [0.01, 1.0, 0.02]),
            ([1.0, 2.0, 2.5], [0.02, -1.0, 1e-3]),
            ([1.0, 2.0, 2.5], [1e-90, 1.0, 2e-90]),
            ([1.0, 2.0, 2.5], [1e-9, 1e-9, 1.0]),
            // 6 (6-4) w3² = 3 (4-3) w1² exactly.
            ([3.0, 4.0, 6.0], [2.0, 1.0, 1.0]),
        ];
        let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
        let mut all = Vec::new();
        for (moments, omega) in kinds {
            for (n, order) in orders.into_iter().enumerate() {
                for scale in [1.0, -1.0, 1e-150, 1e150, 1e-200] {
                    let [moments, omega] = [moments, omega].map(|v| Vector3::from(order.map(|i| v[i])));
                    let motion = FreeMotion::new(moments.try_into().unwrap(), &(omega * scale)).unwrap();
                    let attitude = UnitQuaternion::from_euler_angles(0.3 * n as f64, -1.0, 2.0);
                    all.push(if n % 2 == 0 { motion } else { motion.with_attitude(attitude).unwrap() });
                }
            }
        }
        all
    }

    #[test]
    fn bodies_of_every_kind_and_size_answer_in_lanes_as_each_does_alone_to_the_bit() {
        let all = every_kind();
        let kinds = all.iter().map(|motion| std::mem::discriminant(&motion.regime()));
        assert_eq!(kinds.collect::<std::collections::HashSet<_>>().len(), 5, "a kind is missing");
        // The signs of zeros too.
        let spin_bits = |w: &Vector3<f64>| [w.x, w.y, w.z].map(f64::to_bits);
        let bits =
            |at: &Instant| (spin_bits(&at.omega), <[f64; 4]>::from(at.attitude.coords).map(f64::to_bits));
        for speed in [1.0, 1e-150, 1e150] {
            let times = [0.0, 1e-300, 0.37, -2.0, 11.0, 1e3, -1e9, 1e17, 1e300]
                .map(|t: f64| (t / speed).clamp(-1e305, 1e305));
            // More than are computed in one go.
            let times = [times, times.map(|t| 0.7 * t)].concat();
            let mut seen = 0;
            let mut alone = |time: usize, body: usize, found: &Instant| {
                seen += 1;
                let there = all[body].at(times[time]).unwrap();
                assert_eq!(bits(found), bits(&there), "{body} at {:e}", times[time]);
            };
            Batch::<f64>::new(&all).each(&times, |time, body, at: Instant| alone(time, body, &at)).unwrap();
            let put = |time, body, at: Instant| alone(time, body, &at);
            Batch::<Lanes<4, false>>::new(&all).each(&times, put).unwrap();
            // In the lanes and the version for this processor's vectors.
            let put = &mut |time, body, omega, attitude: Option<_>| {
                alone(time, body, &Instant { omega, attitude: attitude.unwrap() });
            };
            side_by_side(&all, true)(&times, put).unwrap();
            let put = &mut |time: usize, body: usize, spin, _| {
                assert_eq!(spin_bits(&spin), spin_bits(&all[body].omega(times[time]).unwrap()));
            };
            side_by_side(&all, false)(&times, put).unwrap();
            assert_eq!(seen, 3 * all.len() * times.len());
        }
    }
}
