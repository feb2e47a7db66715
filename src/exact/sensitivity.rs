//! Sensitivity of the motion: its state transition matrix, and its derivatives by the tensor.
//!
//! The first row of this table that fits decides how the derivatives are computed.
//!
//! | where | spin | attitude |
//! |---|---|---|
//! | at rest | constant | `time` |
//! | the body turns by at most `SHORT` radians | power series and quadrature (`series`) | the same series |
//! | needles that hardly turn over (`SLOW`) | as below | series over a period, doubled (`needle`) |
//! | a steady spin, two equal moments | sines, exponentials, powers (`elementary`) | momentum and energy (`with_turn`) |
//! | within `NEAR_RETURN` (needles: `SHORT`) of whole half periods | series over the rest (`near_return`) | `with_turn` |
//! | all other motions | the closed form's (`variations`, with `products`) | `with_turn` |

mod elementary;
mod needle;
mod products;
mod series;

use super::elementary::scaled;
use super::elliptic_motion::EllipticMotion;
use super::{FreeMotion, Motion};
use crate::error::{Error, Subject, finite, representable};
use crate::number::{DoubleDouble, Lane, exponent, times_power_of_two};
use nalgebra::{Matrix3, Matrix6, SMatrix, UnitQuaternion, Vector3};
use series::{Request, span};

/// Derivatives of a vector along the principal axes by the tensor's entries there: the three moments, then
/// the three products of inertia, each at the place of the axis that it does not belong to.
pub(super) type ByTensor = SMatrix<f64, 3, 6>;

/// Derivatives of the spin along the principal axes, in scaled units.
pub(super) struct SpinDerivatives {
    /// By the spin at the start.
    pub(super) spin: Matrix3<f64>,
    /// By the tensor; what was not requested is zero.
    pub(super) by_tensor: ByTensor,
    /// The integrals over time of `w_i²` and `2 w_i w_j`, in the order of the tensor's entries, less those of
    /// the start.
    pub(super) energy: [f64; 6],
}

/// Derivatives of spin and attitude along the principal axes, in scaled units; the attitude's are rotation
/// vectors in the axes of the time in question.
struct Derivatives {
    /// Coordinates along the axes at the start to those at the time.
    back: Matrix3<f64>,
    turn: Matrix3<f64>,
    turn_by_tensor: ByTensor,
    spin: SpinDerivatives,
}

/// Up to this angle the power series in time are taken, rad; and up to this distance of Jacobi's argument
/// from whole half periods, for needles up to that of `SHORT`: their closed form cancels more.
const SHORT: f64 = 1.0;
const NEAR_RETURN: f64 = 0.5;
/// A moment below this share of the largest makes a needle.
const NEEDLE: f64 = 1e-3;

impl FreeMotion {
    /// The state transition matrix from the start to time `t`, of attitude error (rad) and spin error
    /// (rad/s), both in body axes. It propagates a covariance `P` at the start to `F P F^T` at `t`. This is a
    /// linear approximation, valid while the attitude error stays well below 1 rad; an error of the spin
    /// makes it grow in proportion to time.
    ///
    /// The attitude error is the small rotation vector `e` of `R exp(e)` relative to the attitude `R`, in the
    /// axes of the body at the same time: the local error that multiplicative attitude filters estimate. Then
    /// `F` does not depend on the initial attitude. Its upper left block is the rotation back from `t` to the
    /// start, its lower left block is zero, and its lower right block is the derivative of the spin with
    /// respect to the spin at the start.
    ///
    /// The derivatives exist in every regime, by the closed form or by series. In tests the error of each
    /// block is at most 8 roundings of its norm, times the angle in radians that the body has spun through
    /// where that is above 1.
    ///
    /// ```
    /// use nalgebra::{Matrix6, UnitQuaternion, Vector3, Vector6};
    /// use tumbling::{Body, Inertia, exact::FreeMotion};
    /// // A CubeSat whose attitude is known to 1 mrad and whose spin is known to 0.1 mrad/s.
    /// let frame = UnitQuaternion::from_euler_angles(0.0, 0.1, 0.02);
    /// let inertia = Inertia::from_moments(0.05, 0.03, 0.07)?.turned(frame)?;
    /// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(0.01, -0.02, 0.03))?;
    /// let motion = FreeMotion::of(&body)?;
    /// let sigma = Vector6::new(1e-3, 1e-3, 1e-3, 1e-4, 1e-4, 1e-4);
    /// let before = Matrix6::from_diagonal(&sigma.map(|sigma| sigma * sigma));
    /// let f = motion.state_transition(60.0)?;
    /// let after = f * before * f.transpose();
    /// // At rest 0.1 mrad/s would make 6 mrad of a minute; the spin turns the error away from where it
    /// // began.
    /// let sigma = (after.fixed_view::<3, 3>(0, 0).trace() / 3.0).sqrt();
    /// assert!((sigma - 4.951e-3).abs() < 1e-6);
    /// // A start that is off by that much comes out as far off as the matrix says.
    /// let (e, w) = (Vector3::new(3e-7, -1e-7, 2e-7), Vector3::new(1e-8, 2e-8, -1e-8));
    /// let off = Body::spinning(inertia, UnitQuaternion::from_scaled_axis(e), &(body.omega_body() + w))?;
    /// let (one, other) = (motion.at(60.0)?, FreeMotion::of(&off)?.at(60.0)?);
    /// let turned = (one.attitude.inverse() * other.attitude).scaled_axis();
    /// let expected = f * Vector6::new(e.x, e.y, e.z, w.x, w.y, w.z);
    /// assert!((turned - expected.fixed_rows::<3>(0)).norm() < 1e-5 * turned.norm());
    /// assert!((other.omega - one.omega - expected.fixed_rows::<3>(3)).norm() < 1e-5 * w.norm());
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A time that is not finite, derivatives beyond `f64`, or a motion on the separatrix whose spin has been
    /// so close to the middle axis for so long (700 times the inverse of its rate) that in `f64` it is
    /// constant.
    pub fn state_transition(&self, t: f64) -> Result<Matrix6<f64>, Error> {
        let transition = self.transition_in_body(&self.derivatives(t, false)?);
        representable(Subject::Derivative, transition.as_slice()).map(|()| transition)
    }

    /// The [`state_transition`](Self::state_transition) to time `t`, and the derivatives of attitude (rad, as
    /// there) and spin (rad/s) at that time by the tensor's entries (kg m²) `Ixx`, `Iyy`, `Izz`, `Ixy`,
    /// `Ixz`, `Iyz` in body axes, at fixed attitude and spin at the start. With `S` this second matrix, a
    /// covariance `C` of these entries that is independent of the covariance of the start adds `S C S^T` to
    /// `F P F^T`.
    ///
    /// The derivative by `Ixy` changes both symmetric entries together; it turns the principal axes. Where
    /// two moments are equal the derivatives are limits, since the motion is smooth in the tensor.
    ///
    /// Accuracy is that of the state transition, relative to the norm of a block of three rows (attitude, or
    /// spin) and all six columns. That norm does not depend on the body's axes; the norm of one column does,
    /// and may be far smaller. For a needle with a smallest moment `e`, the largest columns are of the order
    /// of `1/e`; columns by moments that are small at some instant keep the rounding of the large columns.
    ///
    /// ```
    /// use nalgebra::{Vector3, Vector6};
    /// use tumbling::{PrincipalMoments, exact::FreeMotion};
    /// // A heavier body moves in the same way: along the tensor itself nothing changes.
    /// let moments = PrincipalMoments::new(0.05, 0.03, 0.07)?;
    /// let motion = FreeMotion::new(moments, &Vector3::new(0.1, -0.2, 0.3))?;
    /// let (_, by_tensor) = motion.sensitivities(20.0)?;
    /// let change = by_tensor * Vector6::new(0.05, 0.03, 0.07, 0.0, 0.0, 0.0);
    /// assert!(change.norm() < 1e-14 * by_tensor.norm());
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`state_transition`](Self::state_transition).
    pub fn sensitivities(&self, t: f64) -> Result<(Matrix6<f64>, Matrix6<f64>), Error> {
        let found = self.derivatives(t, true)?;
        let (transition, by_tensor) = (self.transition_in_body(&found), self.by_tensor_in_body(&found));
        representable(Subject::Derivative, transition.as_slice())?;
        representable(Subject::Derivative, by_tensor.as_slice())?;
        Ok((transition, by_tensor))
    }

    fn transition_in_body(&self, found: &Derivatives) -> Matrix6<f64> {
        let frame = self.mount.as_ref().map(|mount| mount.frame.to_body().to_rotation_matrix());
        let in_body = |block: &Matrix3<f64>| frame.map_or(*block, |frame| frame * block * frame.transpose());
        let mut transition = Matrix6::zeros();
        transition.fixed_view_mut::<3, 3>(0, 0).copy_from(&in_body(&found.back));
        transition.fixed_view_mut::<3, 3>(0, 3).copy_from(&in_body(&scaled_by(&found.turn, -self.exponent)));
        transition.fixed_view_mut::<3, 3>(3, 3).copy_from(&in_body(&found.spin.spin));
        transition
    }

    fn by_tensor_in_body(&self, found: &Derivatives) -> Matrix6<f64> {
        let heaviest = exponent(self.moments.largest());
        let frame = self.mount.as_ref().map(|mount| mount.frame.to_body().to_rotation_matrix().into_inner());
        let in_body = |block: &ByTensor, power: i32| {
            let block = match &frame {
                Some(frame) => frame * block * along_principal_axes(frame),
                // The products in the other order.
                None => ByTensor::from_columns(&[0, 1, 2, 5, 4, 3].map(|k| block.column(k))),
            };
            scaled_by(&block, power)
        };
        let mut sensitivity = Matrix6::zeros();
        sensitivity.fixed_rows_mut::<3>(0).copy_from(&in_body(&found.turn_by_tensor, -heaviest));
        sensitivity
            .fixed_rows_mut::<3>(3)
            .copy_from(&in_body(&found.spin.by_tensor, self.exponent - heaviest));
        sensitivity
    }

    fn derivatives(&self, t: f64, tensor: bool) -> Result<Derivatives, Error> {
        let time = finite(Subject::Time, t)? * self.clock;
        let (moments, omega, _) = scaled(&self.moments.into(), &self.start.into());
        if self.law == Motion::AtRest {
            return Ok(Derivatives::at_rest(time));
        }
        let angle = Vector3::from(omega).norm() * time.abs();
        if angle <= SHORT {
            let request = Request { attitude: true, tensor };
            let argument = series::argument_rate(&moments, &omega) * time;
            return Ok(span(&moments, &omega, time, [argument, angle], request).1);
        }
        if let Some(found) = self.slow_turn(&moments, &omega, time, tensor) {
            return found;
        }
        let (now, turned) = self.along_principal_axes(time);
        let now = self.scaled(&now);
        let found = self.spin_derivatives(&moments, &omega, &now, time, tensor)?;
        let back = UnitQuaternion::new_unchecked(turned).inverse().to_rotation_matrix().into_inner();
        Ok(with_turn(&moments, &omega, &now, back, time, found, tensor))
    }

    /// The derivatives of the spin over a span in which the body turns by more than a little.
    #[inline]
    fn spin_derivatives(
        &self,
        moments: &[f64; 3],
        omega: &[f64; 3],
        now: &Vector3<f64>,
        time: f64,
        tensor: bool,
    ) -> Result<SpinDerivatives, Error> {
        Ok(match &self.law {
            Motion::AtRest | Motion::Steady(_) => {
                let alone = |k: &usize| omega[(k + 1) % 3] == 0.0 && omega[(k + 2) % 3] == 0.0;
                if let Some(axis) = (0..3).find(alone) {
                    return Ok(elementary::principal(moments, axis, omega[axis], time));
                }
                let equal = |axis: &usize| moments[(axis + 1) % 3] == moments[(axis + 2) % 3];
                let axis = (0..3).find(equal).unwrap_or(2);
                elementary::top(moments, axis, omega, DoubleDouble::ZERO, time)
            }
            Motion::Symmetric(top) => elementary::top(moments, top.axis, omega, top.spin.nutation, time),
            Motion::Elliptic(motion) => {
                let thin = Vector3::from(*moments).min() < NEEDLE * Vector3::from(*moments).max();
                if motion.half_periods(time).argument.abs() <= if thin { SHORT } else { NEAR_RETURN } {
                    near_return(motion, moments, omega, time, tensor)
                } else {
                    let mut found = motion.derivatives(moments, time, tensor)?;
                    if tensor {
                        products::add(motion, moments, omega, now, time, &mut found);
                    }
                    found
                }
            }
        })
    }

    /// A spin in scaled units.
    fn scaled(&self, omega: &Vector3<f64>) -> Vector3<f64> {
        omega.map(|w| times_power_of_two(w, -self.exponent))
    }
}

/// With the derivatives of the attitude, which need no integral beyond those of the energy.
///
/// The momentum in the world is `L = R M`; so `R (e x M + dM) = dL`, which gives the part of `e` across
/// `M`. Along it, `d/dt (e · M) = dw · M`, and the change of twice the energy, `2 dw · M + w · dI w`, is
/// the start's.
#[inline]
fn with_turn(
    moments: &[f64; 3],
    omega: &[f64; 3],
    now: &Vector3<f64>,
    back: Matrix3<f64>,
    time: f64,
    found: SpinDerivatives,
    tensor: bool,
) -> Derivatives {
    let (i, omega) = (Vector3::from(*moments), Vector3::from(*omega));
    let start = i.component_mul(&omega);
    let current = i.component_mul(now);
    let length = start.norm();
    let direction = current / length;
    // (C42)
    let turn = |before: Vector3<f64>, after: Vector3<f64>, along: f64| {
        (direction.cross(&(back * before - after)) + direction * along) / length
    };
    let columns = [0, 1, 2].map(|k| {
        let after = i.component_mul(&found.spin.column(k));
        turn(Vector3::ith(k, i[k]), after, time * start[k])
    });
    let mut turn_by_tensor = ByTensor::zeros();
    let main = start.iamax();
    for column in 0..if tensor { 6 } else { 0 } {
        let mut after = i.component_mul(&found.by_tensor.column(column));
        let k = column % 3;
        let before = if column >= 3 {
            let (a, b) = ((k + 1) % 3, (k + 2) % 3);
            let of = |w: &Vector3<f64>| Vector3::ith(a, w[b]) + Vector3::ith(b, w[a]);
            after += of(now);
            of(&omega)
        } else if k == main {
            // Along its largest component the momentum itself may be taken off, which does not change.
            after -= (current - Vector3::ith(k, current[k])) / i[k];
            -(start - Vector3::ith(k, start[k])) / i[k]
        } else {
            after += Vector3::ith(k, now[k]);
            Vector3::ith(k, omega[k])
        };
        turn_by_tensor.set_column(column, &turn(before, after, -0.5 * found.energy[column]));
    }
    Derivatives { back, turn: Matrix3::from_columns(&columns), turn_by_tensor, spin: found }
}

impl Derivatives {
    /// A body that is given a spin has it, and turns by it.
    fn at_rest(time: f64) -> Self {
        Self {
            back: Matrix3::identity(),
            turn: Matrix3::identity() * time,
            turn_by_tensor: ByTensor::zeros(),
            spin: SpinDerivatives {
                spin: Matrix3::identity(),
                by_tensor: ByTensor::zeros(),
                energy: [0.0; 6],
            },
        }
    }
}

/// The coefficients of a tensor's entries along its principal axes, in the order of [`ByTensor`], in terms of
/// its entries in body axes, in the order of [`FreeMotion::sensitivities`].
fn along_principal_axes(frame: &Matrix3<f64>) -> Matrix6<f64> {
    Matrix6::from_fn(|row, column| {
        let (a, b) = if row < 3 { (row, row) } else { ((row + 1) % 3, (row + 2) % 3) };
        let (p, q) = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)][column];
        let one = frame[(p, a)] * frame[(q, b)];
        if p == q { one } else { one + frame[(q, a)] * frame[(p, b)] }
    })
}

/// Every entry times `2^exponent`.
fn scaled_by<const N: usize>(block: &SMatrix<f64, 3, N>, exponent: i32) -> SMatrix<f64, 3, N> {
    if (-1022..=1023).contains(&exponent) {
        return block * times_power_of_two(1.0, exponent);
    }
    block.map(|x| times_power_of_two(x, exponent))
}

/// The derivatives near an integer number of half periods, after each of which the spin is that before it
/// with the signs across the circled axis changed: a series over the rest, and by how much earlier or later
/// the half periods end.
fn near_return(
    motion: &EllipticMotion,
    moments: &[f64; 3],
    omega: &[f64; 3],
    time: f64,
    tensor: bool,
) -> SpinDerivatives {
    let halves = motion.half_periods(time);
    let request = Request { attitude: false, tensor };
    let (end, rest) = span(moments, omega, halves.time, [halves.argument, 0.0], request);
    let mut found = rest.spin;
    if halves.count == 0.0 {
        return found;
    }
    let (earlier, squares) = motion.over_half_periods(moments, halves.count);
    let factors = series::factors(moments);
    let rate = Vector3::from([0, 1, 2].map(|a| factors[a] * end[(a + 1) % 3] * end[(a + 2) % 3]));
    let odd = halves.count - 2.0 * Lane::round_ties_even(0.5 * halves.count) != 0.0;
    let signs = Vector3::from_fn(|axis, _| if odd && axis != motion.axes[2] { -1.0 } else { 1.0 });
    for (k, mut column) in found.spin.column_iter_mut().enumerate() {
        let later = &column + rate * earlier[k];
        column.copy_from(&later.component_mul(&signs));
    }
    if tensor {
        for (k, mut column) in found.by_tensor.column_iter_mut().enumerate() {
            let later = &column + rate * earlier[3 + k];
            column.copy_from(&later.component_mul(&signs));
        }
        for (sum, square) in found.energy.iter_mut().zip(squares) {
            *sum += square;
        }
        let end = Vector3::from(end).component_mul(&signs);
        let times = [time - halves.time, halves.time];
        products::after_half_periods(moments, omega, &end, &signs, times, &mut found);
    }
    found
}
