//! The discrete Moser-Veselov algorithm [MV91](crate::references), and the same algorithm with altered
//! moments, for which its step is the body's motion to order 4, 6, 8 or 10 ([MZ05](crate::references),
//! [HV06](crate::references)).
//!
//! One step turns the body by the half-angle tangents `c` (the axis times the tangent of half the angle) that
//! solve
//!
//! ```text
//! K c + c x K c = (1 + |c|^2) h L / 2
//! ```
//!
//! with `K` the moments. Energy, momentum in the world and the length of the attitude are kept by every step
//! that turns the body by less than a quarter turn (longer ones are refused), and so by any `K` with `1/K_j =
//! a/I_j + b`, since then the energy of `K` is a sum of the body's own energy and `|L|^2`. So the only errors
//! of such a step are in the rates of its two angles, and the two numbers `a` and `b` correct these.
//!
//! Their powers in `h` come from the exact motion: for it, `1/K_j = 4 p0 p_j / (h (L + L')_j)` with `(p0, p)`
//! the turn of one step. `crates/proofs/programs/moser_veselov.py` expands this in exact fractions and prints
//! the sums below. The order of the result is proven for this same code, on power series: up to order 6 of
//! the whole step; for each order of the altered moments, with the smallest moment about each axis. With them
//! the motion itself obeys, to that order, the equation that the step solves.

use super::implicit::{cramer, whole};
use crate::attitude;
use crate::body::State;
use crate::error::{Error, Refusal, Subject};
use crate::number::functions::atan2;
use crate::number::{Analytic, Field};
use crate::step::system::System;
use nalgebra::{Quaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// With a torque, the free step lies between two half kicks; the order is then 2.
pub(crate) fn step<T: Analytic>(
    system: &System<T>,
    start: &State<T>,
    h: &T,
    order: u32,
) -> Result<State<T>, Error> {
    let half = h.clone() / T::integer(2);
    let start = system.kick(start, half.clone());
    let end = Prepared::new(system, &start.momentum, h, order)?.step(&start)?;
    Ok(system.adjoint_kick(&end, half))
}

/// The longest turn of a step, rad: there `|c| = 1`.
///
/// The equation has several solutions. With `D = tr(K)/2 - K`, the turn `R` and `W = R D` it is `W - W^T = M`
/// with `W^T W = D^2`; two solutions `V` and `W` then obey `V^T (V - W) + (V - W) W = 0`, which leaves no
/// difference where the eigenvalues of both have positive real parts. Below a quarter turn they do, since
/// then `R + R^T` is positive definite. So no other solution is taken for this one, forth or back.
const LONGEST: f64 = core::f64::consts::FRAC_PI_2;

/// The greatest relative change of an inverse moment by preprocessing: beyond it the powers of the step no
/// longer converge, and the altered moments may be those of no body.
const MOST_ALTERED: f64 = 0.5;

/// In units of rounding, the least ratio of the smallest moment to the others: below it the rounding of a
/// turned momentum, over the smallest moment, is a spin of a thousandth of the whole.
const LEAST_RATIO: f64 = 1000.0;

/// What a step needs of the body and of what the motion conserves.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Prepared<T: nalgebra::Scalar> {
    /// The moments given to the algorithm, in units of [`Corrections`].
    moments: Vector3<T>,
    /// Their inverses.
    inverse: Vector3<T>,
    /// The third less the second, the first less the third, the second less the first: of a needle's nearly
    /// equal moments the differences would not have the digits.
    differences: Vector3<T>,
    /// Takes a momentum to `h L / 2` in that unit.
    scale: T,
}

impl<T: Analytic> Prepared<T> {
    /// For a body and all motions with the energy and `|L|` of this momentum.
    ///
    /// # Errors
    /// A needle below [`LEAST_RATIO`], or a step so long that preprocessing would alter an inverse moment by
    /// [`MOST_ALTERED`] of itself or more.
    #[inline]
    pub(crate) fn new(system: &System<T>, momentum: &Vector3<T>, h: &T, order: u32) -> Result<Self, Error> {
        let corrections = &system.corrections;
        let (value, least) = (corrections.shape[0].size(), LEAST_RATIO * T::rounding());
        let meaning = "for the momentum to have digits of the spin about each axis";
        Refusal::TooSmall { what: Subject::MomentRatio, value, least, meaning }.when(value < least)?;
        let whole = corrections.unit.clone() * h.clone();
        let (a, inverse) = corrections.altered(&momentum.map(|x| x * whole.clone()), order);
        for (before, after) in corrections.ratios.as_slice().iter().zip(inverse.as_slice()) {
            let change = (after.clone() - before.clone()).size();
            if change >= MOST_ALTERED * before.size() {
                let value = change / before.size();
                let refusal = Refusal::NotBelow { what: Subject::AlteredMoment, value, limit: MOST_ALTERED };
                return Err(refusal.into());
            }
        }
        let moments = inverse.map(|x| T::one() / x);
        let [x, y, z] = [&moments.x, &moments.y, &moments.z].map(|x| a.clone() * x.clone());
        let products =
            Vector3::new(y.clone() * moments.z.clone(), z * moments.x.clone(), x * moments.y.clone());
        let differences = corrections.differences.component_mul(&products);
        Ok(Self { moments, inverse, differences, scale: whole / T::integer(2) })
    }

    /// One step of the free motion.
    ///
    /// # Errors
    /// A turn of [`LONGEST`] or more, or one that Newton's iteration does not find.
    #[inline(always)]
    pub(crate) fn step(&self, start: &State<T>) -> Result<State<T>, Error> {
        let half = start.momentum.map(|x| x * self.scale.clone());
        let c = self.tangents(&half)?;
        let square = c.dot(&c);
        if square.size() >= 1.0 {
            let value = 2.0 * atan2(square.size().sqrt(), 1.0);
            return Err(Refusal::NotBelow { what: Subject::MoserVeselovTurn, value, limit: LONGEST }.into());
        }
        let cosine = T::one() / (T::one() + square).sqrt();
        let part = |x: &T| x.clone() * cosine.clone();
        let turned = Quaternion::new(cosine.clone(), part(&c.x), part(&c.y), part(&c.z));
        let momentum = attitude::rotate_inverse(&turned, &start.momentum);
        Ok(State { attitude: attitude::product(&start.attitude, &turned), momentum })
    }

    /// The small root of `K c + c x K c = (1 + |c|^2) m`, by Newton's iteration.
    #[inline]
    fn tangents(&self, m: &Vector3<T>) -> Result<Vector3<T>, Error> {
        // Three rounds of c = (1 + |c|^2) u - J (c x K c) with u = J m, each of which gains an order.
        let (k, inverse) = (&self.moments, &self.inverse);
        let u = inverse.component_mul(m);
        let bending = inverse.component_mul(&self.differences);
        let bend = |c: &Vector3<T>| {
            bending.component_mul(&Vector3::new(times(&c.y, &c.z), times(&c.z, &c.x), times(&c.x, &c.y)))
        };
        let near = &u - bend(&u);
        let grown = T::one() + u.dot(&u);
        let nearer = u.map(|x| x * grown.clone()) - bend(&near);
        let grown = T::one() + nearer.dot(&nearer);
        let mut c = u.map(|x| x * grown.clone()) - bend(&nearer);
        // An error e leaves one of the order of e^2: below this it leaves less than rounding.
        let enough = T::rounding().sqrt() / 8.0;
        // Half a turn this small is none; of a body at rest but for the smallest numbers there are no digits
        // to find.
        let square = T::rounding() * T::rounding();
        let least = square * square;
        let mut residual = f64::NAN;
        for _ in 0..ROUNDS {
            let grown = T::one() + c.dot(&c);
            let [x, y, z] = [0, 1, 2].map(|i| self.differences.map(|d| d * c[i].clone()));
            let across = Vector3::new(times(&y.x, &c.z), times(&z.y, &c.x), times(&x.z, &c.y));
            let miss = k.component_mul(&c) + across - m.map(|x| x * grown.clone());
            // Columns of the derivative.
            let twice = m + m;
            let column = |j: usize, first: [&T; 3]| {
                Vector3::from(first.map(T::clone)) - twice.map(|x| x * c[j].clone())
            };
            let columns =
                [column(0, [&k.x, &z.y, &y.z]), column(1, [&z.x, &k.y, &x.z]), column(2, [&y.x, &x.y, &k.z])];
            let change = cramer(columns, &miss);
            let size = |v: &Vector3<T>| v.as_slice().iter().map(Analytic::size).sum::<f64>();
            residual = size(&change);
            c -= change;
            if residual <= enough * size(&c) || residual < least {
                return Ok(c);
            }
            if !residual.is_finite() {
                break;
            }
        }
        Err(Refusal::NotConverged { what: Subject::MoserVeselovTurn, iterations: ROUNDS, residual }.into())
    }
}

/// The altered inverse moments of a body, for a momentum times the step, and the differences of its own that
/// the step takes, with the smallest moment about the axis `x`: no letter is, so proofs choose.
pub fn altered<T: Analytic>(x: usize, moments: &Vector3<T>, l: &Vector3<T>, order: u32) -> [Vector3<T>; 2] {
    let corrections = Corrections::about(x % 3, moments);
    let in_unit = |v: &Vector3<T>| v.map(|x| x * corrections.unit.clone());
    [in_unit(&corrections.altered(&in_unit(l), order).1), in_unit(&corrections.differences)]
}

fn times<T: Field>(x: &T, y: &T) -> T {
    x.clone() * y.clone()
}

/// The most rounds of Newton's iteration: each doubles the digits, so one that has a solution near needs few.
const ROUNDS: usize = 40;

/// Sums of integers times products: a row for each that `a` takes, and for `b`.
macro_rules! sums {
    ($([$($n:literal $($factor:ident)*),*])*; $($b:tt)*) => { [sums!($([$($n $($factor)*),*])*), sums!($($b)*)] };
    ($([$($n:literal $($factor:ident)*),*])*) => { [$(T::zero() $(+ whole::<T>($n) $(* $factor.clone())*)*),*] };
}

/// What the two numbers `a` and `b` of `1/K = a/I + b` take of the body alone: to order 8, since that is
/// what steps at a fixed rate take at each step.
///
/// All in numbers that a needle does not make large, so that its sums do not cancel. In units of the mean of
/// the other two, the inverse moments are `1/w` for the smallest moment and `1 - d`, `1 + d`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Corrections<T: nalgebra::Scalar> {
    /// The mean: with the step as unit of time everything is a pure number, and small where the step is.
    unit: T,
    /// The inverse moments in this unit.
    ratios: Vector3<T>,
    /// The second of these less the third, the third less the first, the first less the second.
    differences: Vector3<T>,
    /// What squares of the momentum make `U` of: twice the energy is `|L|^2 + w U`.
    weights: Vector3<T>,
    /// `w`, `(d/w)^2` and `d^2`.
    shape: [T; 3],
    to_4: [[T; 2]; 2],
    to_6: [[T; 3]; 2],
    to_8: [[T; 4]; 2],
}

impl<T: Analytic> Corrections<T> {
    /// Where the moment about this axis is the smallest; right for any, but for rounding.
    pub(crate) fn about(x: usize, moments: &Vector3<T>) -> Self {
        let (y, z) = ((x + 1) % 3, (x + 2) % 3);
        let [first, second, third] = [x, y, z].map(|i| &moments[i]);
        let more = T::one() + second.clone() / third.clone();
        let d = (second.clone() - third.clone()) / third.clone() / more.clone();
        let w = first.clone() / second.clone() * more.clone() / T::integer(2);
        let bend = d.clone() / w.clone();
        let inverse = T::one() / w.clone();
        let along = |first: T, second: T, third: T| {
            let mut vector = Vector3::from_element(first);
            (vector[y], vector[z]) = (second, third);
            vector
        };
        let ratios = along(inverse.clone(), T::one() - d.clone(), T::one() + d.clone());
        let over_mean = inverse.clone() - T::one();
        let differences =
            along(-(d.clone() + d.clone()), d.clone() - over_mean.clone(), d.clone() + over_mean.clone());
        let weights = along(over_mean * inverse, -bend.clone(), bend.clone());
        let shape = [w, times(&bend, &bend), times(&d, &d)];
        let [w, s, t] = &shape;
        Self {
            unit: more / T::integer(2) / second.clone(),
            to_4: over(
                12,
                sums! {
                    [-3, -1 t]
                    [-2, -4 w];
                    [1, 2 w s, -1 t]
                    [2, 1 w, -1 w t]
                },
            ),
            to_6: over(
                240,
                sums! {
                    [5, 6 s, -2 w s, 1 t, 2 t t]
                    [10, 10 w, -6 t, 6 w t]
                    [2, 6 w, 7 w w, 1 w w t];
                    [-3, -6 s, -3 w s, 4 t, -1 w s t, -1 t t]
                    [-10, -5 w, -8 w s, 2 t, 6 w t, -1 w t t]
                    [-2, -11 w, -2 w w, 7 w t, 2 w w t]
                },
            ),
            to_8: over(20_160, to_order_8([w, s, t])),
            ratios,
            differences,
            weights,
            shape,
        }
    }

    /// `a`, and the altered inverse moments, for the momentum times the step.
    #[inline]
    fn altered(&self, momentum: &Vector3<T>, order: u32) -> (T, Vector3<T>) {
        let (a, b) = if order > 2 { self.at(momentum, order) } else { (T::one(), T::zero()) };
        let inverse = self.ratios.map(|x| a.clone() * x + b.clone());
        (a, inverse)
    }

    /// `a` and `b` for the momentum times the step, in units of the mean inverse moment.
    #[inline]
    fn at(&self, momentum: &Vector3<T>, order: u32) -> (T, T) {
        let square = momentum.dot(momentum);
        let bent = momentum.dot(&self.weights.component_mul(momentum));
        // sum of parts[j] square^(k - j) bent^j.
        let joined = |parts: &[T]| {
            let [first, others @ ..] = parts else { return T::zero() };
            let mut power = T::one();
            others.iter().fold(first.clone(), |total, part| {
                power *= bent.clone();
                total * square.clone() + part.clone() * power.clone()
            })
        };
        let [to_a, to_b] = &self.to_4;
        let mut a = T::one() + joined(to_a);
        let mut b = joined(to_b);
        if order > 4 {
            let [to_a, to_b] = &self.to_6;
            a += joined(to_a);
            b += joined(to_b);
        }
        if order > 6 {
            let [to_a, to_b] = &self.to_8;
            a += joined(to_a);
            b += joined(to_b);
        }
        if order > 8 {
            let [w, s, t] = &self.shape;
            let [to_a, to_b] = over(725_760, to_order_10([w, s, t]));
            a += joined(&to_a);
            b += joined(&to_b);
        }
        (a, b)
    }
}

/// These numbers over a whole one, once for a body: a division costs as much as many products.
fn over<T: Field, const N: usize>(whole: u32, parts: [[T; N]; 2]) -> [[T; N]; 2] {
    parts.map(|parts| parts.map(|part| part / T::integer(whole)))
}

/// What the order 8 adds to `a` and `b`: the parts that [`Corrections::at`] joins, times 20_160.
fn to_order_8<T: Field>([w, s, t]: [&T; 3]) -> [[T; 4]; 2] {
    sums! {
        [-14, -126 s, 112 w s, -21 t, 34 s t, -96 w s t, 20 t t, -17 t t t]
        [-70, -14 w, -132 s, 88 w s, 136 t, -92 w t, -66 t t, 10 w t t]
        [-42, -56 w, -7 w w, 206 t, 8 w t, -130 w w t, 41 w w t t]
        [-4, -16 w, 44 w w, -24 w w w, -76 w w t, -8 w w w t];
        [10, 126 s, -77 w s, -14 t, 72 w s s, -110 s t, 74 w s t, 6 t t, 19 w s t t, -2 t t t]
        [70, 132 s, 122 w s, -276 t, 22 w t, -178 w s t, 254 t t, -20 w t t, -2 w t t t]
        [42, 91 w, -28 w w, 64 w s, -202 t, -166 w t, 80 w w t, 123 w t t, -52 w w t t]
        [4, -26 w, 40 w w, -18 w w w, -62 w t, -24 w w t, 44 w w w t, -26 w w w t t]
    }
}

/// What the order 10 adds to `a` and `b`: the parts that [`Corrections::at`] joins, times 725_760.
fn to_order_10<T: Field>([w, s, t]: [&T; 3]) -> [[T; 5]; 2] {
    sums! {
        [9, 378 s, -504 w s, 168 t, 378 s s, -918 w s s, 495 s t, 420 w s t, -249 t t, 51 s t t, 60 w s t t,
         42 t t t, 62 t t t t]
        [84, -12 w, 1188 s, -1716 w s, 120 t, 408 w t, -1644 s t, 2628 w s t, -108 t t, -540 w t t,
         -128 t t t, 272 w t t t]
        [126, 612 s, -612 w s, -2682 t, 2232 w t, 198 w w t, 2244 t t, -2184 w t t, 12 w w t t,
         -18 w w t t t]
        [36, 60 w, -228 w w, 132 w w w, -1100 t, 276 w t, 1416 w w t, -88 w w w t, -1092 w w t t,
         84 w w w t t]
        [2, 10 w, 147 w w, -332 w w w, 173 w w w w, 489 w w t, 372 w w w t, -294 w w w w t, 153 w w w w t t];
        [-7, -378 s, 462 w s, -126 t, -378 s s, 189 w s s, 852 s t, -1053 w s t, 264 t t, 367 w s s t,
         -1026 s t t, 636 w s t t, -130 t t t, -61 w s t t t, -1 t t t t]
        [-84, 21 w, -1188 s, 1086 w s, 636 t, -534 w t, -864 w s s, 3300 s t, -1908 w s t, -1836 t t,
         972 w t t, -906 w s t t, 1220 t t t, -458 w t t t, -1 w t t t t]
        [-126, -42 w, 42 w w, -612 s, 270 w s, 2532 t, -1032 w t, -654 w w t, 2250 w s t, -4278 t t,
         150 w t t, 1134 w w t t, 828 w t t t, -522 w w t t t]
        [-36, 66 w, -24 w w, -6 w w w, -128 w s, 964 t, 1044 w t, -1792 w w t, -214 w w w t, -1878 w t t,
         1752 w w t t, 414 w w w t t, -194 w w w t t t]
        [-2, -163 w, 312 w w, -127 w w w, -20 w w w w, 127 w t, -384 w w t, -342 w w w t, 32 w w w w t,
         453 w w w t t, -12 w w w w t t]
    }
}
