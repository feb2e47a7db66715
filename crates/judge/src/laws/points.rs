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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::thresholds::POINTS;

    #[test]
    fn however_long_the_record_there_are_few_points_and_no_extreme_is_lost() {
        for rows in [2, 256, 257, 5000, 100_003] {
            let mut points = Stretches::new(POINTS);
            for i in 0..rows {
                let x = if i == rows / 3 { -9.0 } else { f64::from(i % 7) };
                let spin = Vector3::new(x, 0.0, 1.0);
                points.push(Point {
                    time: f64::from(i),
                    energy: x,
                    momentum: 0.0,
                    direction: Some(x.abs()),
                    phase: None,
                    spin,
                    exact: spin,
                    spin_range: [spin; 2],
                    exact_range: [spin; 2],
                });
            }
            let all = points.all;
            assert!(all.len() <= POINTS && all.len() >= usize::try_from(rows).unwrap().min(POINTS / 2));
            let apart: Vec<f64> = all.windows(2).map(|two| two[1].time - two[0].time).collect();
            assert!(all[0].time == 0.0 && apart.iter().all(|x| *x == apart[0]), "evenly");
            assert!(all.iter().any(|p| p.energy == -9.0 && p.direction == Some(9.0)), "{rows}");
            assert!(all.iter().any(|p| p.spin_range[0].x == -9.0));
            assert_eq!(
                all.iter().map(|p| p.spin_range[1].x).fold(0.0, f64::max),
                6.0_f64.min(f64::from(rows - 1))
            );
        }
    }
}
