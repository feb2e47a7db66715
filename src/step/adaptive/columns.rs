//! The errors of the derivatives that numbers carry: each column relative to its own size.

use super::{largest, over};

/// How many derivatives a number carries at most.
pub(super) const COLUMNS: usize = 6;

/// The sizes of the derivatives of a number.
pub(super) type Slopes<T> = fn(&T) -> [f64; COLUMNS];

/// The derivatives of a state by each variable.
#[derive(Debug, Clone, Copy)]
pub(super) struct Columns<T> {
    slopes: Slopes<T>,
    /// The size of each column.
    sizes: [f64; COLUMNS],
}

impl<T> Columns<T> {
    /// Of an attitude and of a spin in radians in the unit of time.
    pub(super) fn of(slopes: Slopes<T>, attitude: &[T], spin: &[T]) -> Self {
        let mut columns = Self { slopes, sizes: [1.0; COLUMNS] };
        columns.sizes = columns.shares(attitude.iter().chain(spin));
        columns
    }

    /// The largest derivative of each column, in sizes of the column.
    fn shares<'a>(&self, parts: impl Iterator<Item = &'a T>) -> [f64; COLUMNS]
    where
        T: 'a,
    {
        parts.map(self.slopes).fold([0.0; COLUMNS], |most, slopes| {
            core::array::from_fn(|i| largest(&[most[i], over(slopes[i], self.sizes[i])]))
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
