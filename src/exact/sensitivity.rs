//! How the motion answers to small changes of its start and of the body.

use super::FreeMotion;
use crate::error::{Error, finite};
use crate::inertia::length;
use nalgebra::{Matrix3, Vector3};

/// Derivatives of spin and attitude at one instant; see [`FreeMotion::sensitivity`].
///
/// Column `j` of each matrix belongs to the change of component `j` of the start's spin or of moment `j`, along the
/// principal axes in the order of [`FreeMotion::moments`]; the changes are along those axes too, and those of
/// the start for the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensitivity {
    /// Change of the spin in body axes by that of the spin at the start, pure numbers.
    pub omega_by_omega: Matrix3<f64>,
    /// Change of the spin in body axes by that of the moments, rad/s per kg m².
    pub omega_by_moments: Matrix3<f64>,
    /// The turn in the world (rotation vector, radians) that the attitude is changed by, by the change of the
    /// spin at the start, per rad/s.
    pub turn_by_omega: Matrix3<f64>,
    /// The same by the change of the moments, per kg m².
    pub turn_by_moments: Matrix3<f64>,
    /// An estimate of the relative error of the worst of the twelve columns.
    pub error: f64,
}

/// Both derivatives by one input.
type Column = (Vector3<f64>, Vector3<f64>);

/// How many steps the extrapolation may take, and by how much each is shorter.
const STEPS: usize = 9;
const SHORTER: f64 = 0.6;

impl FreeMotion {
    /// How the motion at time `t` changes with the spin at the start and with the moments.
    ///
    /// The motion is an analytic function of all of them, across every border between regimes. So
    /// the derivatives are taken from the exact motions of neighbours at several distances to both sides,
    /// extrapolated to no distance [Rid82](crate::references): one rule for all regimes, with an estimate of its own error. That is
    /// the rounding of the motions over the distance: some 1e-13 for an ordinary motion of a few turns, more as
    /// the derivatives themselves grow.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::exact::FreeMotion;
    /// // A spin about the middle axis: a push across it grows as cosh(rate t), with rate² = 100/3.
    /// let steady = FreeMotion::new(&Vector3::new(1.0, 2.0, 3.0), &Vector3::new(0.0, 10.0, 0.0))?;
    /// let change = steady.sensitivity(0.5)?;
    /// let growth = (10.0 / 3_f64.sqrt() * 0.5).cosh();
    /// assert!((change.omega_by_omega[(2, 2)] / growth - 1.0).abs() < 1e-10);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A time that is not finite, or derivatives beyond `f64`, such as of a motion so long or so close to a
    /// border of what `f64` holds that its neighbours are not there.
    pub fn sensitivity(&self, t: f64) -> Result<Sensitivity, Error> {
        finite("the time", t)?;
        let speed = length(&self.start);
        // Changes that matter: of the spin beside its size, of the moments beside the smallest; and so small
        // that they turn the body by less than a radian by then.
        let turns = speed * t.abs();
        let gentle = if turns > 1.0 { 0.3 / turns } else { 0.3 };
        let spin_scale = if speed > 0.0 { speed } else { 1.0 / t.abs().max(1.0) };
        let mut columns = [(Vector3::zeros(), Vector3::zeros()); 6];
        let mut error = 0.0_f64;
        for (k, column) in columns.iter_mut().enumerate() {
            let scale = if k < 3 { spin_scale } else { self.moments.min() };
            let (best, off) = self.extrapolated(k, scale * gentle, t)?;
            *column = best;
            error = error.max(off);
        }
        let matrix = |first: usize, part: fn(&Column) -> Vector3<f64>| {
            Matrix3::from_columns(&[0, 1, 2].map(|k| part(&columns[first + k])))
        };
        Ok(Sensitivity {
            omega_by_omega: matrix(0, |c| c.0),
            omega_by_moments: matrix(3, |c| c.0),
            turn_by_omega: matrix(0, |c| c.1),
            turn_by_moments: matrix(3, |c| c.1),
            error,
        })
    }

    /// The derivative by input `k` from ever smaller distances, and how far the last two best agree.
    fn extrapolated(&self, k: usize, distance: f64, t: f64) -> Result<(Column, f64), Error> {
        let mut table: Vec<Vec<Column>> = Vec::new();
        let mut best = ((Vector3::zeros(), Vector3::zeros()), f64::INFINITY);
        let mut h = distance;
        for row in 0..STEPS {
            let mut entries = vec![self.quotient(k, h, t)?];
            let mut factor = 1.0;
            for j in 1..=row {
                // Errors are even in the distance: each column takes off two more powers.
                factor /= SHORTER * SHORTER;
                let (a, b) = (entries[j - 1], table[row - 1][j - 1]);
                let next = |a: Vector3<f64>, b: Vector3<f64>| a + (a - b) / (factor - 1.0);
                let entry = (next(a.0, b.0), next(a.1, b.1));
                let off = relative(&entry, &a).max(relative(&entry, &b));
                if off < best.1 {
                    best = (entry, off);
                }
                entries.push(entry);
            }
            table.push(entries);
            h *= SHORTER;
        }
        let finite_entries = best.0.0.iter().chain(best.0.1.iter()).all(|x| x.is_finite());
        if !finite_entries || best.1.is_infinite() {
            return Err(Error::OutOfRange { what: "a derivative of the motion", value: best.1 });
        }
        Ok(best)
    }

    /// The symmetric difference quotient at the distance `h`.
    fn quotient(&self, k: usize, h: f64, t: f64) -> Result<Column, Error> {
        let neighbour = |sign: f64| {
            let (mut moments, mut omega) = (self.moments, self.start);
            let input = if k < 3 { &mut omega[k] } else { &mut moments[k - 3] };
            *input += sign * h;
            let moved = *input;
            Ok((Self::of_principal(&moments, &omega)?.at(t)?, moved))
        };
        let ((after, high), (before, low)) = (neighbour(1.0)?, neighbour(-1.0)?);
        // The distance that the rounded inputs really are apart.
        let over = 1.0 / (high - low);
        let turn = (after.attitude * before.attitude.inverse()).into_inner();
        let turn = if turn.w < 0.0 { -turn } else { turn };
        let sine = turn.imag().norm();
        let angle = 2.0 * sine.atan2(turn.w);
        let vector = if sine > 0.0 { turn.imag() * (angle / sine) } else { Vector3::zeros() };
        Ok(((after.omega - before.omega) * over, vector * over))
    }
}

/// How far two columns are apart beside the larger of their parts, spin and turn each beside its own.
fn relative(a: &Column, b: &Column) -> f64 {
    let part = |a: &Vector3<f64>, b: &Vector3<f64>| {
        let size = a.norm().max(b.norm());
        if size > 0.0 { (a - b).norm() / size } else { 0.0 }
    };
    part(&a.0, &b.0).max(part(&a.1, &b.1))
}
