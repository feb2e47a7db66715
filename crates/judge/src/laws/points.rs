//! A run of any length in a few stretches of equally many rows; and points, to draw it by.

use nalgebra::Vector3;

/// A stretch of a record: the row it starts with, and what the rows in it reach.
///
/// All stretches but the last have equally many rows, one each in a short record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Of the first row, s from the record's start.
    pub time: f64,
    /// The energy's error, as a share of the first row's: of all rows the one largest in size.
    pub energy: f64,
    /// The error of the momentum's length, as a share of the first row's: the one largest in size.
    pub momentum: f64,
    /// The greatest angle between the momentum and the first one in the world, rad, where there are
    /// attitudes.
    pub direction: Option<f64>,
    /// The error of phase, in periods, that is largest in size, where there is a period.
    pub phase: Option<f64>,
    /// The first row's spin in body axes, rad/s.
    pub spin: Vector3<f64>,
    /// The exact motion's spin at that time.
    pub exact: Vector3<f64>,
    /// The least of each component of the spin in any of the rows, and the greatest.
    pub spin_range: [Vector3<f64>; 2],
    /// The least and the greatest of each component of the exact motion's spin at these rows.
    pub exact_range: [Vector3<f64>; 2],
}

impl Stretch for Point {
    fn join(&self, next: &Self) -> Self {
        let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        let range = |a: &[Vector3<f64>; 2], b: &[Vector3<f64>; 2]| [a[0].inf(&b[0]), a[1].sup(&b[1])];
        Self {
            energy: larger(self.energy, next.energy),
            momentum: larger(self.momentum, next.momentum),
            direction: self.direction.zip(next.direction).map(|(a, b)| larger(a, b)),
            phase: self.phase.zip(next.phase).map(|(a, b)| larger(a, b)),
            spin_range: range(&self.spin_range, &next.spin_range),
            exact_range: range(&self.exact_range, &next.exact_range),
            ..*self
        }
    }
}

/// What is kept of the rows of a stretch.
pub(crate) trait Stretch: Copy {
    /// A stretch and the one after it as one.
    fn join(&self, next: &Self) -> Self;
}

/// Stretches gathered from row to row, each of twice as many rows whenever there are too many.
#[derive(Debug, Clone)]
pub(crate) struct Stretches<T> {
    pub all: Vec<T>,
    most: usize,
    rows_each: usize,
    last_rows: usize,
}

impl<T: Stretch> Stretches<T> {
    pub(crate) const fn new(most: usize) -> Self {
        Self { all: Vec::new(), most, rows_each: 1, last_rows: 0 }
    }

    /// One row.
    pub(crate) fn push(&mut self, row: T) {
        match self.all.last_mut() {
            Some(last) if self.last_rows < self.rows_each => {
                *last = last.join(&row);
                self.last_rows += 1;
            }
            _ => {
                if self.all.len() == self.most {
                    self.all = self.all.chunks(2).map(|two| two[0].join(&two[two.len() - 1])).collect();
                    self.rows_each *= 2;
                }
                self.all.push(row);
                self.last_rows = 1;
            }
        }
    }
}
