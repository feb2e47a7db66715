//! Macros that implement all forms of an operator of a number type from one function.

/// Implements an operator for values and references, and its assigning form, by `fn(&Self, &Self) -> Self`.
macro_rules! operator {
    ($T:ident: $Op:ident $op:ident $OpAssign:ident $op_assign:ident = $by:path $(where $P:ident: $Bound:path)?) => {
        impl$(<$P: $Bound>)? std::ops::$Op for $T$(<$P>)? {
            type Output = Self;
            fn $op(self, other: Self) -> Self {
                $by(&self, &other)
            }
        }
        impl$(<$P: $Bound>)? std::ops::$Op<&Self> for $T$(<$P>)? {
            type Output = Self;
            fn $op(self, other: &Self) -> Self {
                $by(&self, other)
            }
        }
        impl$(<$P: $Bound>)? std::ops::$Op<$T$(<$P>)?> for &$T$(<$P>)? {
            type Output = $T$(<$P>)?;
            fn $op(self, other: $T$(<$P>)?) -> $T$(<$P>)? {
                $by(self, &other)
            }
        }
        impl<'a$(, $P: $Bound)?> std::ops::$Op<&'a $T$(<$P>)?> for &'a $T$(<$P>)? {
            type Output = $T$(<$P>)?;
            fn $op(self, other: Self) -> $T$(<$P>)? {
                $by(self, other)
            }
        }
        impl$(<$P: $Bound>)? std::ops::$OpAssign for $T$(<$P>)? {
            fn $op_assign(&mut self, other: Self) {
                *self = $by(self, &other);
            }
        }
    };
}
pub(crate) use operator;

/// Implements how a number is made of another kind.
macro_rules! from {
    ($($T:ty, $From:ty: |$x:ident| $by:expr;)*) => {$(
        impl From<$From> for $T {
            fn from($x: $From) -> Self {
                $by
            }
        }
    )*};
}
pub(crate) use from;

/// Implements zero, one and the negative of a number that is made of whole numbers.
macro_rules! constants {
    ($T:ty: |$x:ident| $is_zero:expr, |$y:ident| $negative:expr) => {
        impl num_traits::Zero for $T {
            fn zero() -> Self {
                Self::from(0)
            }
            fn is_zero(&self) -> bool {
                let $x = self;
                $is_zero
            }
        }
        impl num_traits::One for $T {
            fn one() -> Self {
                Self::from(1)
            }
        }
        impl std::ops::Neg for $T {
            type Output = Self;
            fn neg(self) -> Self {
                let $y = self;
                $negative
            }
        }
    };
}
pub(crate) use constants;
