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
//! the motion itself obeys, to that order, the equation that the step solves. The step in closed form takes
//! the quotient `b/a` of the same sums; its order is tested, not proven.

use super::implicit::{cramer, whole};
use crate::attitude;
use crate::body::State;
use crate::error::{Error, Refusal, Subject};
use crate::number::functions::atan2;
use crate::number::{Analytic, Field};
use crate::step::position_stage::coefficients::bound;
use crate::step::position_stage::turn::{conserving_rate, conserving_turn, three};
use crate::step::system::System;
use nalgebra::{Quaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// With a torque, the free step lies between two half kicks; the order is then 2.
///
/// # Errors
/// Those of [`Corrections::in_units`]; a step so long that preprocessing would alter an inverse moment by
/// [`MOST_ALTERED`] of itself or more; a turn of [`LONGEST`] or more, or one that Newton's iteration does not
/// find.
pub(crate) fn step<T: Analytic>(
    system: &System<T>,
    start: &State<T>,
    h: &T,
    order: u32,
) -> Result<State<T>, Error> {
    let half = h.clone() / T::integer(2);
    let start = system.kick(start, half.clone());
    let corrections = &system.corrections;
    let momentum = corrections.in_units(&start.momentum, h)?;
    let (a, inverse) = corrections.altered(&momentum, order);
    for (before, after) in corrections.ratios.as_slice().iter().zip(inverse.as_slice()) {
        let change = (after.clone() - before.clone()).size();
        let (what, value) = (Subject::AlteredMoment, change / before.size());
        Refusal::NotBelow { what, value, limit: MOST_ALTERED }
            .when(change >= MOST_ALTERED * before.size())?;
    }
    // `(K_k - K_j) / K_i`: of a needle's nearly equal moments the differences would not have the digits.
    let scale = a / (times(&inverse.x, &inverse.y) * inverse.z.clone());
    let bending = corrections.differences.zip_map(&inverse, |less, x| less * scale.clone() * times(&x, &x));
    let c = tangents(&bending, &inverse.zip_map(&momentum, |x, l| x * (l / T::integer(2))))?;
    let square = c.dot(&c);
    if square.size() >= 1.0 {
        let value = 2.0 * atan2(square.size().sqrt(), 1.0);
        return Err(Refusal::NotBelow { what: Subject::MoserVeselovTurn, value, limit: LONGEST }.into());
    }
    let cosine = T::one() / (T::one() + square).sqrt();
    let [x, y, z] = [&c.x, &c.y, &c.z].map(|x| times(x, &cosine));
    let turned = Quaternion::new(cosine, x, y, z);
    let momentum = attitude::rotate_inverse(&turned, &start.momentum);
    let end = State { attitude: attitude::product(&start.attitude, &turned), momentum };
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

/// The small root of `K c + c x K c = (1 + |c|^2) K u`, by Newton's iteration; `bending` is what the crossed
/// products of `c` are multiplied by where each row is divided by its moment.
#[inline]
fn tangents<T: Analytic>(bending: &Vector3<T>, u: &Vector3<T>) -> Result<Vector3<T>, Error> {
    // Three rounds of c = (1 + |c|^2) u - bending c c, each of which gains an order.
    let bend = |c: &Vector3<T>| {
        bending.component_mul(&Vector3::new(times(&c.y, &c.z), times(&c.z, &c.x), times(&c.x, &c.y)))
    };
    let grown = |c: &Vector3<T>| u.map(|x| x * (T::one() + c.dot(c)));
    let nearer = grown(u) - bend(&(u - bend(u)));
    let mut c = grown(&nearer) - bend(&nearer);
    // An error e leaves one of the order of e^2: below this it leaves less than rounding.
    let enough = T::rounding().sqrt() / 8.0;
    // Half a turn this small is none; of a body at rest but for the smallest numbers there are no digits
    // to find.
    let square = T::rounding() * T::rounding();
    let least = square * square;
    let twice = u + u;
    let mut residual = f64::NAN;
    for _ in 0..ROUNDS {
        let miss = &c + bend(&c) - grown(&c);
        // Columns of the derivative.
        let [x, y, z] = [0, 1, 2].map(|i| bending.map(|b| b * c[i].clone()));
        let column =
            |j: usize, first: [&T; 3]| Vector3::from(first.map(T::clone)) - twice.map(|x| x * c[j].clone());
        let one = &T::one();
        let columns =
            [column(0, [one, &z.y, &y.z]), column(1, [&z.x, one, &x.z]), column(2, [&y.x, &x.y, one])];
        let change = cramer(columns, &miss);
        let size = |v: &Vector3<T>| v.as_slice().iter().map(Analytic::size).sum::<f64>();
        residual = size(&change);
        c -= change;
        if residual <= enough * size(&c) || residual < least {
            return Ok(c);
        }
    }
    Err(Refusal::NotConverged { what: Subject::MoserVeselovTurn, iterations: ROUNDS, residual }.into())
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

/// What the two numbers `a` and `b` of `1/K = a/I + b` take of the body alone, and what a step at a fixed
/// rate does.
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
    /// The parts of `a`, of `b` and of `b/a` that [`joined`] joins.
    to_4: [[T; 2]; 3],
    to_6: [[T; 3]; 3],
    to_8: [[T; 4]; 3],
    to_10: [[T; 5]; 3],
    /// The moments.
    moments: Vector3<T>,
    /// `(I_j - I_k) / I_i`.
    coupling: [T; 3],
    /// A bound on the square of the fastest spin of a motion, by the squares of the spin's components.
    bound: [f64; 3],
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
        let weights = along(over_mean * inverse.clone(), -bend.clone(), bend.clone());
        let shape = [w, times(&bend, &bend), times(&d, &d)];
        let [w, s, t] = &shape;
        let [a_4, b_4] = over(12, to_order_4([w, s, t]));
        let [a_6, b_6] = over(240, to_order_6([w, s, t]));
        let [a_8, b_8] = over(20_160, to_order_8([w, s, t]));
        let [a_10, b_10] = over(725_760, to_order_10([w, s, t]));
        // The quotient, power by power.
        let q_6 = less(b_6.clone(), &a_4, &b_4);
        let q_8 = less(less(b_8.clone(), &a_4, &q_6), &a_6, &b_4);
        let q_10 = less(less(less(b_10.clone(), &a_4, &q_8), &a_6, &q_6), &a_8, &b_4);
        let moments = ratios.map(|x| T::one() / x);
        let coupling = three(|i| {
            let both = times(&moments[(i + 1) % 3], &moments[(i + 2) % 3]);
            -differences[i].clone() * both * ratios[i].clone()
        });
        let bound = bound(&moments.map(|x| x.size()).into(), &coupling.each_ref().map(T::size));
        Self {
            unit: more / T::integer(2) / second.clone(),
            to_4: [a_4, b_4.clone(), b_4],
            to_6: [a_6, b_6, q_6],
            to_8: [a_8, b_8, q_8],
            to_10: [a_10, b_10, q_10],
            ratios,
            differences,
            weights,
            shape,
            moments,
            coupling,
            bound,
        }
    }

    /// The momentum times the step, in units of the mean inverse moment.
    ///
    /// # Errors
    /// A needle below [`LEAST_RATIO`].
    #[inline]
    pub(crate) fn in_units(&self, momentum: &Vector3<T>, h: &T) -> Result<Vector3<T>, Error> {
        let (value, least) = (self.shape[0].size(), LEAST_RATIO * T::rounding());
        let meaning = "for the momentum to have digits of the spin about each axis";
        Refusal::TooSmall { what: Subject::MomentRatio, value, least, meaning }.when(value < least)?;
        let whole = times(&self.unit, h);
        Ok(momentum.map(|x| x * whole.clone()))
    }

    /// Of such a momentum what the motion conserves: the square of its length, and `U`.
    #[inline]
    fn conserved(&self, momentum: &Vector3<T>) -> [T; 2] {
        [momentum.dot(momentum), momentum.dot(&self.weights.component_mul(momentum))]
    }

    /// `a`, and the altered inverse moments, for the momentum times the step.
    #[inline]
    fn altered(&self, momentum: &Vector3<T>, order: u32) -> (T, Vector3<T>) {
        let conserved = self.conserved(momentum);
        let to = |least: u32, parts: &[T]| if order < least { T::zero() } else { joined(parts, &conserved) };
        let [a, b] = [(0, T::one()), (1, T::zero())].map(|(i, one)| {
            one + to(4, &self.to_4[i]) + to(6, &self.to_6[i]) + to(8, &self.to_8[i]) + to(10, &self.to_10[i])
        });
        let inverse = self.ratios.map(|x| a.clone() * x + b.clone());
        (a, inverse)
    }

    /// A bound on the square of the turn of the free motion in the time of the step.
    #[inline(always)]
    pub(crate) fn most(&self, momentum: &Vector3<T>) -> f64 {
        let turn = self.ratios.component_mul(momentum);
        let [x, y, z] = three(|i| self.bound[i] * times(&turn[i], &turn[i]).size());
        x + y + z
    }

    /// The turn of the free motion in the time of the step, as a quaternion of any length.
    ///
    /// A turn that keeps energy and momentum solves this module's equation for some `a` and `b`: it takes `L`
    /// to `L'`, and its axis is along `K^-1 (L + L')`. So `b/a`, to order 10, and how far the momentum moves
    /// on its curve, to the same order, determine it, and no equation is left to solve.
    #[inline(always)]
    pub(crate) fn turn(&self, momentum: &Vector3<T>) -> Quaternion<T> {
        let conserved = self.conserved(momentum);
        let twist = (joined(&self.to_4[2], &conserved) + joined(&self.to_6[2], &conserved))
            + (joined(&self.to_8[2], &conserved) + joined(&self.to_10[2], &conserved));
        let weights = three(|i| T::one() + times(&self.moments[i], &twist));
        let omega = three(|i| times(&self.ratios[i], &momentum[i]));
        let [a, b, c] = &self.coupling;
        let [x, y, z] = three(|i| times(&omega[i], &omega[i]));
        let added = [times(b, c) * x, times(c, a) * y, times(a, b) * z];
        let rate = conserving_rate(added, |n| T::one() / T::integer(n.into()));
        let (w, [[x, y, z], _]) =
            conserving_turn(&self.coupling, &weights, &omega, &T::one(), &rate, |x| x.sqrt());
        Quaternion::new(w, x, y, z)
    }
}

/// The sum of `parts[j] square^(k - j) bent^j`.
#[inline]
fn joined<T: Field>(parts: &[T], [square, bent]: &[T; 2]) -> T {
    let [first, others @ ..] = parts else { return T::zero() };
    let mut power = T::one();
    others.iter().fold(first.clone(), |total, part| {
        power *= bent.clone();
        total * square.clone() + part.clone() * power.clone()
    })
}

/// Less the product of two such sums.
fn less<T: Field, const N: usize>(mut from: [T; N], one: &[T], other: &[T]) -> [T; N] {
    for (i, x) in one.iter().enumerate() {
        for (y, to) in other.iter().zip(from.iter_mut().skip(i)) {
            *to -= times(x, y);
        }
    }
    from
}

/// These numbers over a whole one, once for a body: a division costs as much as many products.
fn over<T: Field, const N: usize>(whole: u32, parts: [[T; N]; 2]) -> [[T; N]; 2] {
    parts.map(|parts| parts.map(|part| part / T::integer(whole)))
}

/// What the order 4 gives `a` and `b`: the parts that [`joined`] joins, times 12.
fn to_order_4<T: Field>([w, s, t]: [&T; 3]) -> [[T; 2]; 2] {
    sums! {
        [-3, -1 t]
        [-2, -4 w];
        [1, 2 w s, -1 t]
        [2, 1 w, -1 w t]
    }
}

/// What the order 6 adds to `a` and `b`: the parts that [`joined`] joins, times 240.
fn to_order_6<T: Field>([w, s, t]: [&T; 3]) -> [[T; 3]; 2] {
    sums! {
        [5, 6 s, -2 w s, 1 t, 2 t t]
        [10, 10 w, -6 t, 6 w t]
        [2, 6 w, 7 w w, 1 w w t];
        [-3, -6 s, -3 w s, 4 t, -1 w s t, -1 t t]
        [-10, -5 w, -8 w s, 2 t, 6 w t, -1 w t t]
        [-2, -11 w, -2 w w, 7 w t, 2 w w t]
    }
}

/// What the order 8 adds to `a` and `b`: the parts that [`joined`] joins, times 20_160.
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

/// What the order 10 adds to `a` and `b`: the parts that [`joined`] joins, times 725_760.
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
