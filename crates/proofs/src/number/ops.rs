//! Spares each number type the many ways of writing an operation: all follow from one function.

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
