//! The inverse tensor, which takes momentum to spin.

use super::{Inertia, in_range, is_diagonal, moments_of};
use crate::error::{Error, Refusal, Subject};
use crate::number::double_double::{DoubleDouble, difference_of_products};
use crate::number::power_of_two::{exponent, times_power_of_two, ulp};
use nalgebra::Matrix3;

impl Inertia {
    /// The inverse matrix `J` in 1/(kg m²), `w = J L`, along the same axes: to be computed once and turned,
    /// instead of inverting at each step.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// let inverse = tumbling::Inertia::from_moments(2.0, 4.0, 5.0)?.inverse()?;
    /// assert_eq!(inverse * Vector3::new(2.0, 2.0, 0.0), Vector3::new(1.0, 0.5, 0.0));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A smallest moment that is zero to rounding (an ideal rod), or an inverse beyond `f64`.
    pub fn inverse(&self) -> Result<Matrix3<f64>, Error> {
        let m = &self.tensor;
        let diagonal = is_diagonal(m);
        let moments = moments_of(m);
        // The moments of a diagonal tensor are known exactly: only a true zero is singular there.
        let rounding = if diagonal { 0.0 } else { 2.0 * ulp(moments[2]) };
        if moments[0] <= rounding {
            return Err(Refusal::Singular { smallest: moments[0], largest: moments[2] }.into());
        }
        let inverse = if diagonal {
            Matrix3::from_diagonal(&m.diagonal().map(|x| 1.0 / x))
        } else {
            adjugate_inverse(m)
        };
        in_range(Subject::InverseMoment, &inverse)?;
        Ok(inverse)
    }
}

/// The inverse by cofactors. Each cofactor is a difference of products that nearly cancels in a needle's
/// tensor, so it is computed as if exactly; the scale is taken out so that none underflows. Zeros come out
/// without a sign.
fn adjugate_inverse(m: &Matrix3<f64>) -> Matrix3<f64> {
    let scale = exponent(m.amax());
    let a = m.map(|x| times_power_of_two(x, -scale));
    let cofactor = |i: usize, j: usize| {
        let (r, s) = ((i + 1) % 3, (i + 2) % 3);
        let (p, q) = ((j + 1) % 3, (j + 2) % 3);
        difference_of_products(a[(r, p)], a[(s, q)], a[(r, q)], a[(s, p)])
    };
    let determinant = (DoubleDouble::from(a[(0, 0)]) * cofactor(0, 0)
        + DoubleDouble::from(a[(0, 1)]) * cofactor(0, 1)
        + DoubleDouble::from(a[(0, 2)]) * cofactor(0, 2))
    .hi();
    Matrix3::from_fn(|i, j| {
        let (i, j) = (i.min(j), i.max(j));
        times_power_of_two(cofactor(i, j).hi() / determinant, -scale) + 0.0
    })
}
