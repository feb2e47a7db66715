//! A row as it is written, and where rows come from: a file or memory.

use crate::error::Error;
use crate::read::Kind;
use nalgebra::{Quaternion, Vector3};

/// Where rows come from.
pub(crate) trait Source {
    /// The next row; `None` after the last, or where the numbers end.
    fn next(&mut self) -> Result<Option<Raw>, Error>;

    /// Where the numbers end before the rows do.
    fn ended(&mut self) -> Option<Error>;
}

/// How a time is printed. Nothing of it is known of a count of steps.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Printed {
    /// Half a unit of its last digit, s.
    pub half: f64,
    /// Its significant digits.
    pub digits: u32,
    /// The power of ten next above it, s.
    pub above: f64,
}

/// A row as it stands in the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Raw {
    pub line: usize,
    /// Seconds, or a count of steps times the step.
    pub t: f64,
    pub attitude: Option<Quaternion<f64>>,
    /// As [`Kind`] says; in radians.
    pub vector: Vector3<f64>,
    /// In the world; zero where it is not read.
    pub position: Vector3<f64>,
    /// How its time is printed.
    pub printed: Printed,
    /// How exact the numbers of the attitude are, and those of the vector.
    pub exact: [Exact; 2],
}

/// How exact numbers are, as they are written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Exact {
    /// The most significant digits of any.
    pub digits: u32,
    /// The most significant bits of any; 24 fit single precision, 11 half precision.
    pub bits: u32,
    /// What a one is worth in the last place of the one that is written most finely.
    pub place: f64,
}

impl Raw {
    /// The spin in body axes for a file that is right.
    pub(crate) fn omega(&self, kind: Kind, moments: &Vector3<f64>) -> Vector3<f64> {
        let mut vector = self.vector;
        if kind.in_world()
            && let Some(attitude) = self.attitude
        {
            let square = attitude.coords.norm_squared();
            let rotation = tumbling::attitude::rotation_matrix(&attitude);
            vector = if square > 0.0 { rotation.tr_mul(&vector) / square } else { vector };
        }
        if kind.is_momentum() { vector.component_div(moments) } else { vector }
    }
}
