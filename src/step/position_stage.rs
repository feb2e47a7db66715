//! The position stage of a physics engine: attitude and spin over a time step, with nothing else acting.

pub(crate) mod coefficients;
mod side_by_side;
#[cfg(test)]
mod tests;
pub(crate) mod turn;

use crate::attitude::product;
use crate::error::{Error, Refusal, Subject, finite};
use crate::number::Field;
use coefficients::{Coefficients, value};
use nalgebra::{Quaternion, Scalar, Vector3};
use num_traits::Float;
use turn::{change_of_spin, conserving_turn, three};

/// The longest turn of one part of a step, radians.
const LONGEST: f32 = 0.5;

/// The most parts of one step.
const MOST_PARTS: f32 = 4096.0;

/// The position stage of a physics engine for one body. It starts from the attitude and spin after the
/// velocity stage (forces, damping, contacts and joints), and returns those at the end of the step.
///
/// It replaces both the update of the attitude and the gyroscopic term. It works in `f32` and `f64`,
/// allocates nothing, never panics, and uses only `+ - * /` and the square root. So the bits are the same
/// wherever floats follow IEEE 754, and in C compiled as `examples/engines/c/position_stage.h` says.
///
/// - If no axis is locked, the step changes energy and momentum only by rounding, for any spin and any `h`.
///   So the energy that a body gains is the work of the engine's velocity stages.
/// - A step by `-h` returns to the start, up to rounding.
/// - The error in the rate of the turn is of the sixth order in the turn of one step, the error in the rate
///   of the flips of the tenth. A turn of more than half a radian is taken in parts.
///
/// The step of the spin is the addition theorem of the elliptic functions that solve Euler's equations
/// ([DLMF](crate::references), section 22.8), with the time replaced by the first terms of its series. An
/// error in time along the correct curve changes no conserved quantity.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::step::PositionStage;
/// let body = PositionStage::new(&Vector3::new(1.0_f32, 2.0, 3.0))?;
/// let (mut attitude, mut omega) = (Quaternion::identity(), Vector3::new(0.05, 10.0, 0.0));
/// for _ in 0..600 {
///     // Here the engine applies forces, contacts and damping to `omega`; then:
///     let end = body.step(&attitude, &omega, 1.0 / 60.0);
///     (attitude, omega) = (end.attitude, end.omega);
/// }
/// assert!((attitude.norm() - 1.0).abs() < 1e-6);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PositionStage<T: Scalar> {
    coefficients: Coefficients<T>,
    /// The rotation from the principal axes to the body frame.
    frame: Option<Quaternion<T>>,
}

/// The end of a step of the [`PositionStage`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stepped<T: Scalar> {
    /// From body to world; of length 1 to rounding.
    pub attitude: Quaternion<T>,
    /// The spin in world axes, rad/s.
    pub omega: Vector3<T>,
    /// The number of equal parts in which the step was taken. Zero if the step was not taken; attitude and
    /// spin are then unchanged. This happens for numbers that are not finite, an attitude of length zero, and
    /// a turn of more than about 2000 rad (divided by the largest `|I_j - I_k| / I_i` where that is above 1:
    /// moments that no solid has).
    pub parts: u32,
}

impl<T: Field + Float + From<f32>> PositionStage<T> {
    /// For a body with these moments along the axes of its frame, in any order, kg m².
    ///
    /// A zero moment about one axis means a thin rod, whose spin about its length has no momentum. Moments
    /// that no solid has (the largest above the sum of the others) are accepted.
    ///
    /// # Errors
    /// A moment that is negative or not finite; a zero moment if the other two differ; moments whose ratios
    /// overflow.
    pub fn new(moments: &Vector3<T>) -> Result<Self, Error> {
        Ok(Self { coefficients: Coefficients::of_moments([moments.x, moments.y, moments.z])?, frame: None })
    }

    /// For a body with these inverse moments along the axes of its frame, 1/(kg m²), as engines store them.
    /// Zero locks an axis: no torque turns the body about it.
    ///
    /// With one or more locked axes the spin stays constant over the step and the attitude turns about it.
    /// This is the exact motion of a body that is moved by a script, and of a body whose locked axes are
    /// fixed in the body and have no spin about them. An engine that locks axes of the world passes zeros
    /// while any axis is locked. With two locked axes the constant spin is exact. With one it conserves the
    /// energy, but not the momentum about the two free axes.
    ///
    /// ```
    /// use nalgebra::{Quaternion, Vector3};
    /// use tumbling::step::PositionStage;
    /// let wheel = PositionStage::of_inverse(&Vector3::new(0.0, 0.0, 2.0))?;
    /// let omega = Vector3::new(0.0, 0.0, 9.0);
    /// assert_eq!(wheel.step(&Quaternion::identity(), &omega, 0.01).omega, omega);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// An inverse moment that is negative or not finite, or whose inverse is not finite; and the errors of
    /// [`new`](Self::new).
    pub fn of_inverse(inverse: &Vector3<T>) -> Result<Self, Error> {
        let inverse = [inverse.x, inverse.y, inverse.z];
        Ok(Self { coefficients: Coefficients::of_inverse_moments(inverse)?, frame: None })
    }

    /// The same body with its principal axes turned in the body frame: `frame` is the rotation from principal
    /// axes to body frame. Its length does not matter.
    ///
    /// # Errors
    /// A frame that is not finite, or has length zero.
    pub fn in_frame(self, frame: Quaternion<T>) -> Result<Self, Error> {
        let mut frame = frame.coords;
        // Where squares overflow or underflow.
        let ordinary = number::<T>(1e-30)..=number(1e30);
        if !ordinary.contains(&square(&Quaternion::from_vector(frame))) {
            for x in frame.iter() {
                finite(Subject::AxesTurn, value(*x))?;
            }
            let largest = frame.iter().fold(T::zero(), |most, x| most.max(x.abs()));
            Refusal::ZeroVector { what: Subject::AxesTurn }.when(largest == T::zero())?;
            frame = frame.map(|x| x / largest);
        }
        let norm = square(&Quaternion::from_vector(frame)).sqrt();
        Ok(Self { frame: Some(Quaternion::from_vector(frame.map(|x| x / norm))), ..self })
    }

    /// The step of `h` seconds from an attitude (body to world, length 1) and a spin in world axes, rad/s.
    #[must_use]
    #[inline]
    pub fn step(&self, attitude: &Quaternion<T>, omega: &Vector3<T>, h: T) -> Stepped<T> {
        let end = self.part(attitude, omega, h);
        if end.taken() {
            return end.stepped();
        }
        let (attitude, omega, parts) = self.in_parts(attitude, omega, h);
        Stepped { attitude, omega, parts }
    }

    /// Attitude, spin and number of parts of a step that is too long for one part. If this returned a
    /// [`Stepped`], the numbers of a short step would be moved from registers to memory.
    #[cold]
    #[inline(never)]
    fn in_parts(&self, q: &Quaternion<T>, omega: &Vector3<T>, h: T) -> (Quaternion<T>, Vector3<T>, u32) {
        let left = (*q, *omega, 0);
        let unit = Quaternion::from_vector(q.coords / square(q).sqrt());
        let (_, along) = self.spin(&unit, omega);
        let turn = self.coefficients.fastest(&along, h).sqrt();
        let parts = (turn / number(LONGEST)).ceil().max(T::one());
        if !(turn.is_finite() && parts <= number(MOST_PARTS)) {
            return left;
        }
        let mut end = (unit, *omega, 0);
        let mut done = T::zero();
        while done < parts {
            let next = self.part(&end.0, &end.1, h / parts);
            if !next.taken() {
                return left;
            }
            end = (next.attitude, next.omega, end.2 + 1);
            done += T::one();
        }
        end
    }

    /// The rotation matrix from the principal axes to the world, by rows, and the spin along these axes.
    #[inline(always)]
    fn spin(&self, attitude: &Quaternion<T>, v: &Vector3<T>) -> ([[T; 3]; 3], [T; 3]) {
        let q = match &self.frame {
            None => *attitude,
            Some(frame) => product(attitude, frame),
        };
        let [w, x, y, z] = [q.coords.w, q.coords.x, q.coords.y, q.coords.z];
        let one = T::one();
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        let (xx, xy, xz) = (x * x2, x * y2, x * z2);
        let (yy, yz, zz) = (y * y2, y * z2, z * z2);
        let r = [
            [one - (yy + zz), xy - wz, xz + wy],
            [xy + wz, one - (xx + zz), yz - wx],
            [xz - wy, yz + wx, one - (xx + yy)],
        ];
        let along = |i: usize| r[0][i] * v.x + r[1][i] * v.y + r[2][i] * v.z;
        (r, three(along))
    }

    /// One part.
    #[inline(always)]
    fn part(&self, attitude: &Quaternion<T>, omega: &Vector3<T>, h: T) -> End<T> {
        let steady = turn_square(omega, h) <= self.coefficients.steady;
        if steady { steady_turn(attitude, omega, h) } else { self.turn(attitude, omega, h) }
    }

    /// Where a part ends, whatever its numbers.
    #[inline(always)]
    fn turn(&self, attitude: &Quaternion<T>, before: &Vector3<T>, h: T) -> End<T> {
        let (rotation, omega) = self.spin(attitude, before);
        let q = &attitude.coords;
        let (w, x, y, z) = (q.w, q.x, q.y, q.z);
        let length = square(attitude);
        let fastest = self.coefficients.fastest(&omega, h);
        let (rate, weights) = self.coefficients.rate(&omega, h);
        let turn = conserving_turn(&self.coefficients.coupling, &weights, &omega, &h, &rate, |x| x.sqrt());
        let (below, [tangents, _]) = turn;
        let [a, b, c] = tangents;
        // The attitude is divided by its length, which rounding has changed.
        let square = ((below * below + a * a) + (b * b + c * c)) * length;
        // The root and the division do not wait for each other.
        let scale = T::one() / (below * square);
        let factor = (scale * below) * square.sqrt();
        // The change of the spin is relative to the attitude before the step, and small. So a steady spin
        // keeps its digits; rotating the spin to the body and back would lose some.
        let [u, v, t] = change_of_spin(&turn);
        let back = |i: usize| ((rotation[i][0] * u + rotation[i][1] * v) + rotation[i][2] * t) * scale;
        let omega = Vector3::new(before.x + back(0), before.y + back(1), before.z + back(2));
        let [a, b, c] = self.in_body(tangents);
        let attitude = Quaternion::new(
            (w * below - (x * a + y * b + z * c)) * factor,
            (x * below + (w * a + (y * c - z * b))) * factor,
            (y * below + (w * b + (z * a - x * c))) * factor,
            (z * below + (w * c + (x * b - y * a))) * factor,
        );
        End { attitude, omega, turn: fastest, length, factor }
    }

    /// A vector along the principal axes, in the body frame.
    #[inline(always)]
    fn in_body(&self, v: [T; 3]) -> [T; 3] {
        let Some(frame) = &self.frame else { return v };
        let [w, x, y, z] = [frame.coords.w, frame.coords.x, frame.coords.y, frame.coords.z];
        // v + 2 w (u x v) + 2 u x (u x v), with u the vector part.
        let cross = |[a, b, c]: [T; 3]| [y * c - z * b, z * a - x * c, x * b - y * a];
        let across = cross(v);
        let across = three(|i| across[i] + across[i]);
        let twice = cross(across);
        three(|i| v[i] + (w * across[i] + twice[i]))
    }
}

/// Where a part ends, with the squares of its turn and of the attitude's length before.
#[derive(Clone, Copy)]
struct End<T: Scalar> {
    attitude: Quaternion<T>,
    omega: Vector3<T>,
    turn: T,
    length: T,
    /// The factor of the attitude.
    factor: T,
}

impl<T: Field + Float + From<f32>> End<T> {
    /// Whether the part is short enough for one, from an attitude of length 1, and all is finite.
    #[inline(always)]
    fn taken(&self) -> bool {
        self.turn <= longest()
            && (self.length - T::one()).abs() <= T::epsilon() * number(32.0)
            && (self.omega.x + self.omega.y + self.omega.z + self.factor).is_finite()
    }

    #[inline(always)]
    fn stepped(&self) -> Stepped<T> {
        Stepped { attitude: self.attitude, omega: self.omega, parts: 1 }
    }
}

/// The square of the longest turn of a part, and a little more, to allow for rounding in the parts of a
/// longer step.
#[inline(always)]
fn longest<T: Field + Float + From<f32>>() -> T {
    number::<T>(LONGEST) * number(LONGEST) * number(1.0001)
}

/// The square of the turn about this spin.
#[inline(always)]
fn turn_square<T: Field + Float>(omega: &Vector3<T>, h: T) -> T {
    let [x, y, z] = three(|i| (omega[i] * h) * (omega[i] * h));
    (x + y) + z
}

/// The end of a part that needs no gyroscopic term: a turn about the spin, which is constant.
#[inline(always)]
fn steady_turn<T: Field + Float + From<f32>>(attitude: &Quaternion<T>, omega: &Vector3<T>, h: T) -> End<T> {
    let n = number::<T>;
    let (one, turn, length) = (T::one(), turn_square(omega, h), square(attitude));
    // The series of the tangent of half the turn, divided by half the turn.
    let series = one / n(12.0) + turn * (one / n(120.0) + turn * (n(17.0) / n(20160.0)));
    let half = (one + turn * series) * (h / n(2.0));
    let [a, b, c] = three(|i| omega[i] * half);
    let factor = one / (((one + a * a) + (b * b + c * c)) * length).sqrt();
    let [w, x, y, z] = [attitude.coords.w, attitude.coords.x, attitude.coords.y, attitude.coords.z];
    let attitude = Quaternion::new(
        (w - (a * x + b * y + c * z)) * factor,
        (x + (a * w + (b * z - c * y))) * factor,
        (y + (b * w + (c * x - a * z))) * factor,
        (z + (c * w + (a * y - b * x))) * factor,
    );
    End { attitude, omega: *omega, turn, length, factor }
}

/// The square of the length.
#[inline(always)]
fn square<T: Field + Float>(q: &Quaternion<T>) -> T {
    let [w, x, y, z] = [q.coords.w, q.coords.x, q.coords.y, q.coords.z];
    (w * w + x * x) + (y * y + z * z)
}

/// A number of single precision.
#[inline(always)]
fn number<T: From<f32>>(x: f32) -> T {
    <T as From<f32>>::from(x)
}
