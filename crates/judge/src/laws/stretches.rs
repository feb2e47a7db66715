//! A run of any length in a few stretches of equally many rows.

/// What is kept of the rows of a stretch.
pub(crate) trait Stretch: Copy {
    /// A stretch and the one after it as one.
    fn join(&self, next: &Self) -> Self;
}

/// Stretches gathered from row to row, each of twice as many rows whenever there are too many.
#[derive(Debug, Clone)]
pub(crate) struct Stretches<T> {
    all: Vec<T>,
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

    pub(crate) fn all(&self) -> &[T] {
        &self.all
    }

    pub(crate) fn into_all(self) -> Vec<T> {
        self.all
    }
}
