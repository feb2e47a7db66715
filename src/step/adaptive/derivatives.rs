//! The errors of the derivatives that numbers carry: each column relative to its own size.

use super::{largest, ratio};

/// How many derivatives a number carries at most.
pub(super) const DIRECTIONS: usize = 6;

/// The sizes of the derivatives of a number.
pub(super) type DerivativeSizes<T> = fn(&T) -> [f64; DIRECTIONS];

/// The derivatives of a state by each variable.
#[derive(Debug, Clone, Copy)]
pub(super) struct Derivatives<T> {
    of: DerivativeSizes<T>,
    /// The size of each column.
    sizes: [f64; DIRECTIONS],
}

impl<T> Derivatives<T> {
    /// Of an attitude and of a spin in radians in the unit of time.
    pub(super) fn of(of: DerivativeSizes<T>, attitude: &[T], spin: &[T]) -> Self {
        let mut derivatives = Self { of, sizes: [1.0; DIRECTIONS] };
        derivatives.sizes = derivatives.shares(attitude.iter().chain(spin));
        derivatives
    }

    /// The largest derivative of each column, in sizes of the column.
    fn shares<'a>(&self, parts: impl Iterator<Item = &'a T>) -> [f64; DIRECTIONS]
    where
        T: 'a,
    {
        parts.map(self.of).fold([0.0; DIRECTIONS], |most, derivatives| {
            core::array::from_fn(|i| largest(&[most[i], ratio(derivatives[i], self.sizes[i])]))
        })
    }

    /// The largest derivative, in sizes of its column.
    pub(super) fn share<'a>(&self, parts: impl Iterator<Item = &'a T>) -> f64
    where
        T: 'a,
    {
        largest(&self.shares(parts))
    }
}
