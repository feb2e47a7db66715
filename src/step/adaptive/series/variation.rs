//! The motion's first variations as power series, once its own series are known.
//!
//! An attitude error `e` (body axes) and a spin error `d` obey `e' = d - w x e`. A vector that is fixed in
//! the world and has body components `v` varies by `v x e`. The law is bilinear, so each coefficient is a sum
//! of products of a series of the motion and a series of the variations.

use super::{Lanes, Law, Series};
use alloc::vec::Vec;
use core::array;

/// The derivatives of a vector by each of six variables.
type Columns = [[f64; 6]; 3];

/// The number of leading zero columns, which are skipped where the spin does not depend on the attitude; the
/// remaining four fill whole vectors.
const SKIPPED: usize = 2;

/// The derivatives of the attitude, as an error vector in body axes (rad), and of the spin.
pub(in super::super) type Variation = [Columns; 2];

#[inline(always)]
fn columns(of: impl Fn(usize, usize) -> f64) -> Columns {
    // Not by `from_fn`, which calls a function for each.
    let mut all = [[0.0; 6]; 3];
    for (i, row) in all.iter_mut().enumerate() {
        for (column, place) in row.iter_mut().enumerate() {
            *place = of(i, column);
        }
    }
    all
}

#[inline(always)]
fn add(sum: &mut Columns, of: impl Fn(usize, usize) -> f64) {
    *sum = columns(|i, column| sum[i][column] + of(i, column));
}

/// By the attitude and the spin themselves.
pub(in super::super) fn identity() -> Variation {
    [0, 3].map(|first| columns(|i, column| if column == first + i { 1.0 } else { 0.0 }))
}

/// With the spin in other units of time.
pub(in super::super) fn in_units([e, d]: &Variation, unit: f64) -> Variation {
    [*e, columns(|i, column| d[i][column] * unit)]
}

#[derive(Debug, Clone)]
pub(in super::super) struct Variations<const N: usize> {
    /// The highest power.
    pub(super) order: usize,
    /// The size of each column at the start.
    sizes: [f64; 6],
    /// Whether the spin does not depend on the attitude at the start.
    apart: bool,
    attitude: [Columns; N],
    spin: [Columns; N],
    /// The terms for dissipation and for each gravity gradient, as in the series of the motion.
    momentum: [Columns; N],
    coupling: [Columns; N],
    direction: Vec<[Columns; N]>,
}

impl<const N: usize> Variations<N> {
    pub(super) fn new(gradients: usize) -> Self {
        let [attitude, spin, momentum, coupling] = [[[[0.0; 6]; 3]; N]; 4];
        let direction = alloc::vec![attitude; gradients];
        Self { order: 0, sizes: [1.0; 6], apart: false, attitude, spin, momentum, coupling, direction }
    }

    /// From the variations at the start, with the spin in units.
    pub(in super::super) fn begin(&mut self, &[attitude, spin]: &Variation) {
        (self.order, self.attitude[0], self.spin[0]) = (0, attitude, spin);
        self.apart = spin.iter().all(|row| row[..SKIPPED].iter().all(|x| *x == 0.0));
        // Below this size a column has no significant digits.
        let least = f64::MIN_POSITIVE / f64::EPSILON;
        let parts = || attitude.iter().chain(&spin);
        self.sizes = array::from_fn(|i| parts().fold(least, |most: f64, row| most.max(row[i].abs())));
    }

    /// The coefficients of a power: of the power 0, the values at the start; of the power 1, the rates.
    pub(in super::super) fn coefficient(&self, power: usize) -> Variation {
        [self.attitude[power], self.spin[power]]
    }

    /// The next coefficient, given the motion's own series about the same start, of this order or more.
    pub(super) fn extend(&mut self, of: &Series<N>, law: &Law) {
        let n = self.order.min(N - 2);
        let (w, spin) = (&of.spin.up, self.spin[n]);
        let apart = self.apart && law.world.is_empty() && law.gradients.is_empty();
        let of_spin = if apart { products::<N, false, SKIPPED> } else { products::<N, false, 0> };
        let pairs = of_spin(n, w, &self.spin);
        let free = columns(|i, column| law.coupling[i] * pairs[i][column]);
        let mut rate = free;
        if let Some(decay) = &law.decay {
            add(&mut rate, |i, column| -(decay[i] * spin[i][column]));
        }
        for (rows, one) in of.world.iter().zip(&law.world) {
            let vector = products::<N, true, 0>(n, rows, &self.attitude);
            let [x, y, z] = &one.acceleration;
            add(&mut rate, |i, c| x[i] * vector[0][c] + y[i] * vector[1][c] + z[i] * vector[2][c]);
        }
        if let (Some(own), Some(law)) = (&of.dissipation, &law.dissipation) {
            self.momentum[n] = columns(|i, column| law.moments[i] * spin[i][column]);
            self.coupling[n] = columns(|i, column| law.moments[i] * free[i][column]);
            let cross = if apart { products::<N, true, SKIPPED> } else { products::<N, true, 0> };
            let one = cross(n, &own.momentum, &self.coupling);
            let other = cross(n, &own.coupling.up, &self.momentum);
            add(&mut rate, |i, column| law.acceleration[i] * (one[i][column] - other[i][column]));
        }
        for ((own, law), direction) in of.gradients.iter().zip(&law.gradients).zip(&mut self.direction) {
            direction[n] = products::<N, true, 0>(n, &own.direction.up, &self.attitude);
            let pairs = products::<N, false, 0>(n, &own.direction.up, direction);
            add(&mut rate, |i, column| -(law.acceleration[i] * pairs[i][column]));
        }
        let inverse = 1.0 / (n + 1) as f64;
        let turned = products::<N, true, 0>(n, w, &self.attitude);
        self.attitude[n + 1] = columns(|i, column| (spin[i][column] - turned[i][column]) * inverse);
        self.spin[n + 1] = columns(|i, column| rate[i][column] * inverse);
        self.order = n + 1;
    }

    /// The largest entry of a power, relative to the size of its column.
    pub(super) fn size(&self, power: usize) -> f64 {
        self.share(&self.coefficient(power))
    }

    /// The largest entry, relative to the size of its column.
    fn share(&self, parts: &Variation) -> f64 {
        let rows = parts.as_flattened().iter();
        let shares = rows.flat_map(|row| row.iter().zip(&self.sizes).map(|(x, size)| x.abs() / size));
        shares.fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most })
    }

    /// The largest difference, relative to the size of its column.
    pub(in super::super) fn off(&self, one: &Variation, other: &Variation) -> f64 {
        self.share(&[0, 1].map(|part| columns(|i, column| one[part][i][column] - other[part][i][column])))
    }

    /// The variations and their rates after `x` units of time.
    pub(in super::super) fn at(&self, x: f64) -> [Variation; 2] {
        let at = |rows: &[Columns; N]| {
            let [mut value, mut rate] = [[[0.0; 6]; 3]; 2];
            for row in rows[..=self.order].iter().rev() {
                rate = columns(|i, column| rate[i][column] * x + value[i][column]);
                value = columns(|i, column| value[i][column] * x + row[i][column]);
            }
            [value, rate]
        };
        let ([e, de], [d, dd]) = (at(&self.attitude), at(&self.spin));
        [[e, d], [de, dd]]
    }
}

/// The coefficient of a power of `a x b`, or of `a2 b3 + a3 b2` and so on round; columns before the first are
/// zero.
// Not inlined: alone it has the registers to itself.
#[inline(never)]
fn products<const N: usize, const CROSS: bool, const FIRST: usize>(
    power: usize,
    a: &[Lanes; N],
    b: &[Columns; N],
) -> Columns {
    let mut sum = [[0.0; 6]; 3];
    for (a, b) in a[..=power].iter().zip(b[..=power].iter().rev()) {
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            for column in FIRST..6 {
                let (one, other) = (a[j] * b[k][column], a[k] * b[j][column]);
                sum[i][column] += if CROSS { one - other } else { one + other };
            }
        }
    }
    sum
}
