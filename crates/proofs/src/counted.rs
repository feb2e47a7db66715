//! A number that counts its operations: the cost of a formula, found by running it.
//!
//! The library's laws are generic over their numbers. So the cost of a law, in multiplications and additions,
//! can be measured: run it on [`Counted`] numbers inside [`count`] and read the result.
//!
//! ```
//! use nalgebra::{Matrix3, Vector3};
//! use tumbling_proofs::counted::{Counted, count};
//!
//! let r = Matrix3::<f64>::identity().map(Counted::new);
//! let v = Vector3::new(1.0, 2.0, 3.0).map(Counted::new);
//! let (_, cost) = count(|| r * v);
//! assert_eq!((cost.multiplications, cost.additions), (9, 6));
//! ```

use num_traits::{One, Zero};
use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// The number of operations of each kind. A subtraction counts as an addition; a change of
/// sign is free.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cost {
    /// Products.
    pub multiplications: u64,
    /// Sums and differences.
    pub additions: u64,
    /// Quotients.
    pub divisions: u64,
}

thread_local! {
    static COST: Cell<Cost> = const { Cell::new(Cost { multiplications: 0, additions: 0, divisions: 0 }) };
}

/// Runs `work` and returns its result with its cost in [`Counted`] operations on this thread. The operations
/// of an inner count also belong to the outer one.
///
/// ```
/// use tumbling_proofs::counted::{Counted, count};
/// let x = Counted::new(3.0);
/// let (_, outer) = count(|| x * count(|| -x * x + x).0);
/// assert_eq!((outer.multiplications, outer.additions), (2, 1));
/// ```
pub fn count<R>(work: impl FnOnce() -> R) -> (R, Cost) {
    let before = COST.take();
    let result = work();
    let cost = COST.get();
    COST.set(Cost {
        multiplications: before.multiplications + cost.multiplications,
        additions: before.additions + cost.additions,
        divisions: before.divisions + cost.divisions,
    });
    (result, cost)
}

/// An `f64` whose operations are counted, see [`count`].
///
/// A product with the constant [`One::one`] is free: the linear algebra below writes such products where a
/// general factor happens to be 1, and a compiler removes them.
#[derive(Debug, Clone, Copy)]
pub struct Counted {
    value: f64,
    unity: bool,
}

impl PartialEq for Counted {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl PartialOrd for Counted {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl Counted {
    /// A number to be counted with.
    #[must_use]
    pub const fn new(value: f64) -> Self {
        Self { value, unity: false }
    }

    /// The number itself.
    #[must_use]
    pub const fn value(self) -> f64 {
        self.value
    }
}

fn tally(add: impl FnOnce(&mut Cost)) {
    let mut cost = COST.get();
    add(&mut cost);
    COST.set(cost);
}

macro_rules! counted {
    ($Op:ident $op:ident $OpAssign:ident $op_assign:ident $kind:ident) => {
        impl $Op for Counted {
            type Output = Self;
            fn $op(self, other: Self) -> Self {
                let free = stringify!($op) == "mul" && (self.unity || other.unity);
                tally(|cost| cost.$kind += u64::from(!free));
                Self::new(self.value.$op(other.value))
            }
        }
        impl $OpAssign for Counted {
            fn $op_assign(&mut self, other: Self) {
                *self = self.$op(other);
            }
        }
    };
}
counted!(Add add AddAssign add_assign additions);
counted!(Sub sub SubAssign sub_assign additions);
counted!(Mul mul MulAssign mul_assign multiplications);
counted!(Div div DivAssign div_assign divisions);

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value)
    }
}

impl Zero for Counted {
    fn zero() -> Self {
        Self::new(0.0)
    }
    fn is_zero(&self) -> bool {
        self.value == 0.0
    }
}

impl One for Counted {
    fn one() -> Self {
        Self { value: 1.0, unity: true }
    }
}
