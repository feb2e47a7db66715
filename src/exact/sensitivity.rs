//! How the motion answers to small changes of its start and of the body.

mod elementary;
mod needle;
mod series;

use super::circulating::{Elliptic, Halves};
use super::elementary::scaled;
use super::{FreeMotion, Law};
use crate::error::{Error, finite};
use crate::number::Lane;
use crate::number::double_double::DoubleDouble;
use crate::number::power_of_two::{exponent, times_power_of_two};
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
}

/// The change of the spin by the three components of the start's and by the three moments, and the integral over time of
/// the square of each component less that at the start.
pub(super) struct Change {
    pub(super) spin: [Vector3<f64>; 6],
    pub(super) squares: [f64; 3],
}

/// Up to this many radians the power series in time are taken.
const SHORT: f64 = 1.0;

impl FreeMotion {
    /// How the motion at time `t` changes with the spin at the start and with the moments.
    ///
    /// The derivatives are those of the closed form, in every regime: of Jacobi's functions by argument and modulus,
    /// of sines and exponentials, and over short spans of power series in time. The turn needs no
    /// integral but that of the squares of the spin: across the momentum it follows from the momentum's being
    /// constant, along it from the energy's. Each of the four matrices is right to some roundings of its own norm,
    /// times the angle in radians that the body has spun through where that is above 1. Of needles, below a thousandth of the largest
    /// moment, the derivatives by the moments have been seen a thousand roundings off.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::{PrincipalMoments, exact::FreeMotion};
    /// // A spin about the middle axis: a push across it grows as cosh(rate t), with rate² = 100/3.
    /// let steady = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 3.0)?, &Vector3::new(0.0, 10.0, 0.0))?;
    /// let change = steady.sensitivity(0.5)?;
    /// let growth = (10.0 / 3_f64.sqrt() * 0.5).cosh();
    /// assert!((change.omega_by_omega[(2, 2)] / growth - 1.0).abs() < 1e-14);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A time that is not finite, derivatives beyond `f64`, or the separatrix where its spin has been at rest on the
    /// middle axis for so long (700 times the inverse of its rate) that `f64` does not tell it from rest.
    pub fn sensitivity(&self, t: f64) -> Result<Sensitivity, Error> {
        let time = finite("the time", t)? * self.clock;
        let (moments, omega, _) = scaled(&self.moments.into(), &self.start.into());
        let speed = Vector3::from(omega).norm();
        let (change, turn) = if (speed * time).abs() <= SHORT {
            let short = series::short(&moments, &omega, time, speed * time);
            let attitude = self.turned(time);
            (short.change, short.turn.map(|turn| attitude * turn))
        } else {
            let change = self.change(&moments, &omega, time)?;
            let turn = match self.slow_turn(&moments, &omega, time) {
                Some(turn) => turn,
                None => self.turn(&moments, &omega, time, &change),
            };
            (change, turn)
        };
        let heaviest = exponent(self.moments.largest());
        let matrix = |columns: &[Vector3<f64>], power: i32| {
            let matrix = Matrix3::from_columns(columns).map(|x| times_power_of_two(x, power));
            match matrix.iter().find(|x| !x.is_finite()) {
                Some(&value) => Err(Error::OutOfRange { what: "a derivative of the motion", value }),
                None => Ok(matrix),
            }
        };
        Ok(Sensitivity {
            omega_by_omega: matrix(&change.spin[..3], 0)?,
            omega_by_moments: matrix(&change.spin[3..], self.exponent - heaviest)?,
            turn_by_omega: matrix(&turn[..3], -self.exponent)?,
            turn_by_moments: matrix(&turn[3..], -heaviest)?,
        })
    }

    /// The change of the spin, in scaled units, over a span in which the body turns by more than a little.
    fn change(&self, moments: &[f64; 3], omega: &[f64; 3], time: f64) -> Result<Change, Error> {
        Ok(match &self.law {
            Law::AtRest => series::short(moments, omega, time, 0.0).change,
            Law::Steady(_) => {
                let moving = [0, 1, 2].map(|k| omega[k] != 0.0);
                match moving {
                    [true, false, false] => elementary::principal(moments, 0, omega[0], time),
                    [false, true, false] => elementary::principal(moments, 1, omega[1], time),
                    [false, false, true] => elementary::principal(moments, 2, omega[2], time),
                    _ => {
                        let equal = |axis: &usize| moments[(axis + 1) % 3] == moments[(axis + 2) % 3];
                        let axis = (0..3).find(equal).unwrap_or(2);
                        elementary::top(moments, axis, omega, DoubleDouble::ZERO, time)
                    }
                }
            }
            Law::Symmetric(top) => elementary::top(moments, top.axis(), omega, top.wobble(), time),
            Law::Elliptic(motion) => {
                let halves = motion.half_periods(time);
                if halves.argument.abs() <= SHORT {
                    near_return(motion, &halves, moments, omega)
                } else {
                    motion.neighbours(moments, time)?
                }
            }
        })
    }

    /// The turns that belong to it, in the world.
    ///
    /// The momentum in the world is `L = R M`; so `turn x L + R dM = dL`, which gives the part across `L`. Along
    /// it, `d/dt (turn · L) = dw · M`, and `2E` is the start's.
    fn turn(&self, moments: &[f64; 3], omega: &[f64; 3], time: f64, change: &Change) -> [Vector3<f64>; 6] {
        let rotation = self.turned(time);
        let now = self.omega_along(time).map(|w| times_power_of_two(w, -self.exponent));
        let i = Vector3::from(*moments);
        let start = i.component_mul(&Vector3::from(*omega));
        let momentum = start.norm();
        let direction = start / momentum;
        let current = i.component_mul(&now);
        let main = start.iamax();
        core::array::from_fn(|column| {
            let k = column % 3;
            let unit = Vector3::ith(k, 1.0);
            let (mut before, mut after) = (Vector3::zeros(), i.component_mul(&change.spin[column]));
            let along = if column < 3 {
                before += unit * i[k];
                time * start[k]
            } else {
                // Along its largest component the momentum itself may be taken off, which does not change.
                if k == main {
                    before -= (start - unit * start[k]) / i[k];
                    after -= (current - unit * current[k]) / i[k];
                } else {
                    before += unit * omega[k];
                    after += unit * now[k];
                }
                -0.5 * change.squares[k]
            };
            let across = direction.cross(&(before - rotation * after));
            across / momentum + direction * (along / momentum)
        })
    }
}

/// The change near a whole number of half periods, after each of which the spin is that before it with two signs
/// turned: a series over the time that is left, and how much later or earlier the half periods end.
fn near_return(motion: &Elliptic, halves: &Halves, moments: &[f64; 3], omega: &[f64; 3]) -> Change {
    let series::Short { mut change, omega: end, .. } =
        series::short(moments, omega, halves.time, halves.argument);
    if halves.count == 0.0 {
        return change;
    }
    let (later, squares) = motion.whole(moments, halves.count);
    let factor = series::Ratios::new(moments).factor;
    let rate = Vector3::from([0, 1, 2].map(|a| factor[a] * end[(a + 1) % 3] * end[(a + 2) % 3]));
    let odd = halves.count - 2.0 * Lane::round_ties_even(0.5 * halves.count) != 0.0;
    let turned = Vector3::from_fn(|axis, _| if odd && axis != motion.around() { -1.0 } else { 1.0 });
    for (column, later) in change.spin.iter_mut().zip(later) {
        *column = (*column + rate * later).component_mul(&turned);
    }
    for (sum, whole) in change.squares.iter_mut().zip(squares) {
        *sum += whole;
    }
    change
}
