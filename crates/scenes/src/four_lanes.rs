//! Four numbers side by side, of the crate `wide`.
//!
//! Of its operations only those that round as `f64` does: its own sine, exponential and rounding are not
//! needed, and its fused product is fused on some machines only.

use num_traits::{One, Zero};
use std::array::from_fn;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use tumbling::number::{Lane, Series};
use wide::f64x4;

/// Four numbers side by side: a vector register where the program is built for a machine that has them (`-C
/// target-cpu=native`), a pair of shorter ones elsewhere, with the same answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FourLanes(f64x4);

macro_rules! arithmetic {
    ($Op:ident, $op:ident, $Assign:ident, $assign:ident) => {
        impl $Op for FourLanes {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: Self) -> Self {
                Self(self.0.$op(other.0))
            }
        }
        impl $Op<f64> for FourLanes {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: f64) -> Self {
                Self(self.0.$op(f64x4::splat(other)))
            }
        }
        impl $Assign for FourLanes {
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
impl Neg for FourLanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0 ^ f64x4::splat(-0.0))
    }
}

impl Zero for FourLanes {
    fn zero() -> Self {
        Self(f64x4::splat(0.0))
    }
    fn is_zero(&self) -> bool {
        self.0.to_array() == [0.0; 4]
    }
}

impl One for FourLanes {
    fn one() -> Self {
        Self(f64x4::splat(1.0))
    }
}

/// Of numbers beyond it the last place is no half.
const HALVES: f64 = 2_251_799_813_685_248.0;
/// Added to one up to [`HALVES`] it makes the last place 1.
const UNIT: f64 = 6_755_399_441_055_744.0;
/// Between these (or zero), a product and all its parts are within the range.
const SMALL: f64 = 1e-120;
const LARGE: f64 = 1e120;

impl Series for FourLanes {}
impl tumbling::laws::Rounding for FourLanes {}

impl Lane for FourLanes {
    type Mask = f64x4;
    const WIDTH: usize = 4;

    #[inline(always)]
    fn from_lanes(of: impl FnMut(usize) -> f64) -> Self {
        Self(f64x4::new(from_fn(of)))
    }

    #[inline(always)]
    fn lane(&self, k: usize) -> f64 {
        // There are four: a number too large says the first again.
        self.0.as_array()[k % 4]
    }

    #[inline(always)]
    fn lt(self, other: Self) -> f64x4 {
        self.0.simd_lt(other.0)
    }

    #[inline(always)]
    fn any(mask: f64x4) -> bool {
        mask.any()
    }

    #[inline(always)]
    fn select(mask: f64x4, yes: Self, no: Self) -> Self {
        Self(mask.select(yes.0, no.0))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline(always)]
    fn sign(self) -> Self {
        Self((self.0 & f64x4::splat(-0.0)) | f64x4::splat(1.0))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    fn round_ties_even(self) -> Self {
        // Where there is an instruction for it the compiler takes that, four at once.
        let instruction = cfg!(any(target_feature = "avx", target_arch = "aarch64"));
        if !instruction && self.0.abs().simd_lt(f64x4::splat(HALVES)).all() {
            let unit = f64x4::splat(UNIT);
            // The sign goes on again: what rounds to zero from below is -0.
            return Self(((self.0 + unit) - unit) | (self.0 & f64x4::splat(-0.0)));
        }
        Self(f64x4::new(self.0.to_array().map(f64::round_ties_even)))
    }

    #[inline(always)]
    fn two_product_error(self, other: Self, product: Self) -> Self {
        if cfg!(all(target_feature = "avx", target_feature = "fma")) {
            return Self(self.0.mul_sub(other.0, product.0));
        }
        // Without the instruction: Dekker's product, exact as long as nothing leaves the range on the way.
        if !cfg!(target_arch = "aarch64") && fits(self.0) && fits(other.0) {
            let (a, b) = (split(self.0), split(other.0));
            return Self(((a[0] * b[0] - product.0) + a[0] * b[1] + a[1] * b[0]) + a[1] * b[1]);
        }
        Self(f64x4::new(from_fn(|k| self.lane(k).mul_add(other.lane(k), -product.lane(k)))))
    }
}

#[inline(always)]
fn fits(x: f64x4) -> bool {
    let size = x.abs();
    let between = size.simd_lt(f64x4::splat(LARGE)) & size.simd_gt(f64x4::splat(SMALL));
    (between | size.simd_eq(f64x4::splat(0.0))).all()
}

/// Its upper 26 bits and the rest, Veltkamp's way.
#[inline(always)]
fn split(x: f64x4) -> [f64x4; 2] {
    let scaled = f64x4::splat(134_217_729.0) * x;
    let upper = scaled - (scaled - x);
    [upper, x - upper]
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{UnitQuaternion, Vector3};
    use proptest::prelude::*;
    use tumbling::exact::{Batch, FreeMotion, Instant};

    fn four(x: [f64; 4]) -> FourLanes {
        FourLanes::from_lanes(|k| x[k])
    }

    fn bits(x: FourLanes) -> [u64; 4] {
        [0, 1, 2, 3].map(|k| x.lane(k).to_bits())
    }

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
            a in proptest::array::uniform4(any_number()), b in proptest::array::uniform4(any_number()),
        ) {
            let (x, y) = (four(a), four(b));
            let alone = |f: fn(f64, f64) -> f64| [0, 1, 2, 3].map(|k| f(a[k], b[k]).to_bits());
            let same = |found: FourLanes, expected: [u64; 4]| {
                let nan = |bits: u64| f64::from_bits(bits).is_nan();
                bits(found).iter().zip(&expected).all(|(f, e)| f == e || (nan(*f) && nan(*e)))
            };
            prop_assert!(same(x + y, alone(|a, b| a + b)));
            prop_assert!(same(x - y, alone(|a, b| a - b)));
            prop_assert!(same(x * y, alone(|a, b| a * b)));
            prop_assert!(same(x / y, alone(|a, b| a / b)));
            prop_assert!(same(-x, alone(|a, _| -a)));
            prop_assert!(same(x.abs().sqrt(), alone(|a, _| a.abs().sqrt())));
            prop_assert!(same(x.round_ties_even(), alone(|a, _| a.round_ties_even())));
            prop_assert!(same(x.sign(), alone(|a, _| 1_f64.copysign(a))));
            let lesser = alone(|a, b| if a < b { a } else { b });
            prop_assert!(same(FourLanes::select(x.lt(y), x, y), lesser));
            let (left, product) = (alone(|a, b| a.mul_add(b, -(a * b))), x * y);
            prop_assert!(same(x.two_product_error(y, product), left) || left.iter().any(|x| f64::from_bits(*x).is_nan()));
        }
    }
    /// In every order of its axes, both ways round, at every size, some of them turned.
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
            let mut seen = 0;
            let mut alone = |time: usize, body: usize, found: &Instant| {
                seen += 1;
                assert_eq!(
                    bits(found),
                    bits(&all[body].at(times[time]).unwrap()),
                    "{body} at {:e}",
                    times[time]
                );
            };
            Batch::<FourLanes>::new(&all)
                .each(&times, |time, body, at: Instant| alone(time, body, &at))
                .unwrap();
            Batch::<f64>::new(&all).each(&times, |time, body, at: Instant| alone(time, body, &at)).unwrap();
            assert_eq!(seen, 2 * all.len() * times.len());
            let spins = Batch::<FourLanes, Vector3<f64>>::new(&all).each(&times, |time, body, spin| {
                assert_eq!(spin_bits(&spin), spin_bits(&all[body].omega(times[time]).unwrap()));
            });
            spins.unwrap();
        }
    }
}
