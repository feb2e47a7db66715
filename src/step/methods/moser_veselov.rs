//! The discrete Moser-Veselov algorithm [MV91](crate::references), and the same given such moments that its
//! step is the body's own motion to order 4, 6, 8 or 10 ([MZ05](crate::references),
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
//! a/I_j + b`, since then the energy of `K` is a sum of the body's own energy and `|L|^2`. All that such a
//! step can be wrong by is the rates of its two angles, and the two numbers `a` and `b` put those right.
//!
//! Their powers in `h` come from the exact motion: for it, `1/K_j = 4 p0 p_j / (h (L + L')_j)` with `(p0, p)`
//! the turn of one step. `crates/proofs/programs/moser_veselov.py` expands this in exact fractions and prints
//! the sums below. The order of the result is proven of this very code, on power series.

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

/// With a torque, between two half kicks of it: then of order 2, whatever the order without.
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

/// What a step needs of the body and of what the motion conserves.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Prepared<T: nalgebra::Scalar> {
    /// The moments given to the algorithm, the body's first moment for a unit.
    moments: Vector3<T>,
    /// Their inverses.
    inverse: Vector3<T>,
    /// Takes a momentum to `h L / 2` in that unit.
    scale: T,
}

impl<T: Analytic> Prepared<T> {
    /// For a body and all motions with the energy and `|L|` of this momentum.
    ///
    /// # Errors
    /// A step so long that preprocessing would alter an inverse moment by [`MOST_ALTERED`] of itself or more.
    #[inline]
    pub(crate) fn new(system: &System<T>, momentum: &Vector3<T>, h: &T, order: u32) -> Result<Self, Error> {
        let corrections = &system.corrections;
        let inverse = corrections.ratios.clone();
        let whole = system.inverse.x.clone() * h.clone();
        let inverse = if order > 2 {
            let turned = momentum.map(|x| x * whole.clone());
            let (a, b) = corrections.at(&turned, order);
            let altered = inverse.map(|x| a.clone() * x + b.clone());
            for (before, after) in inverse.as_slice().iter().zip(altered.as_slice()) {
                let change = (after.clone() - before.clone()).size();
                if change >= MOST_ALTERED * before.size() {
                    let value = change / before.size();
                    return Err(Refusal::NotBelow {
                        what: Subject::AlteredMoment,
                        value,
                        limit: MOST_ALTERED,
                    }
                    .into());
                }
            }
            altered
        } else {
            inverse
        };
        let moments = inverse.map(|x| T::one() / x);
        Ok(Self { moments, inverse, scale: whole / T::integer(2) })
    }

    /// One step of the free motion.
    ///
    /// # Errors
    /// A turn of [`LONGEST`] or more, or one that Newton's iteration does not find.
    #[inline(always)]
    pub(crate) fn step(&self, start: &State<T>) -> Result<State<T>, Error> {
        let half = start.momentum.map(|x| x * self.scale.clone());
        let c = tangents(&self.moments, &self.inverse, &half)?;
        let square = c.dot(&c);
        if square.size() >= 1.0 {
            let turn = 2.0 * atan2(square.size().sqrt(), 1.0);
            return Err(
                Refusal::NotBelow { what: Subject::MoserVeselovTurn, value: turn, limit: LONGEST }.into()
            );
        }
        let cosine = T::one() / (T::one() + square).sqrt();
        let part = |x: &T| x.clone() * cosine.clone();
        let turned = Quaternion::new(cosine.clone(), part(&c.x), part(&c.y), part(&c.z));
        let momentum = attitude::rotate_inverse(&turned, &start.momentum);
        Ok(State { attitude: attitude::product(&start.attitude, &turned), momentum })
    }
}

/// The most rounds of Newton's iteration: each doubles the digits, so one that has a solution near needs few.
const ROUNDS: usize = 40;

/// The small root of `K c + c x K c = (1 + |c|^2) m`, by Newton's iteration.
#[inline]
fn tangents<T: Analytic>(k: &Vector3<T>, inverse: &Vector3<T>, m: &Vector3<T>) -> Result<Vector3<T>, Error> {
    // Three rounds of c = (1 + |c|^2) u - J (c x K c) with u = J m, each of which gains an order.
    let u = inverse.component_mul(m);
    let bend = |c: &Vector3<T>| inverse.component_mul(&c.cross(&k.component_mul(c)));
    let near = &u - bend(&u);
    let grown = T::one() + u.dot(&u);
    let nearer = u.map(|x| x * grown.clone()) - bend(&near);
    let grown = T::one() + nearer.dot(&nearer);
    let mut c = u.map(|x| x * grown.clone()) - bend(&nearer);
    // An error e leaves one of the order of e^2: below this it leaves less than rounding.
    let enough = T::rounding().sqrt() / 8.0;
    // Half a turn this small is none; of a body at rest but for the smallest numbers there are no digits to
    // find.
    let square = T::rounding() * T::rounding();
    let least = square * square;
    let mut moved = f64::NAN;
    for _ in 0..ROUNDS {
        let kc = k.component_mul(&c);
        let twice = m + m;
        let grown = T::one() + c.dot(&c);
        let miss = &kc + c.cross(&kc) - m.map(|x| x * grown.clone());
        // Columns of the derivative: K_j e_j + (K_j c - K c) x e_j - 2 c_j m.
        let difference = |i: usize, j: usize| k[i].clone() - k[j].clone();
        let (xy, yz, zx) = (difference(0, 1), difference(1, 2), difference(2, 0));
        let p = |x: &T, y: &T| x.clone() * y.clone();
        let column = |j: usize, first: Vector3<T>| first - twice.map(|x| x * c[j].clone());
        let x = column(0, Vector3::new(k.x.clone(), -p(&zx, &c.z), -p(&xy, &c.y)));
        let y = column(1, Vector3::new(-p(&yz, &c.z), k.y.clone(), -p(&xy, &c.x)));
        let z = column(2, Vector3::new(-p(&yz, &c.y), -p(&zx, &c.x), k.z.clone()));
        let change = cramer([x, y, z], &miss);
        let size = |v: &Vector3<T>| v.as_slice().iter().map(Analytic::size).sum::<f64>();
        moved = size(&change);
        c -= change;
        if moved <= enough * size(&c) || moved < least {
            return Ok(c);
        }
        if !moved.is_finite() {
            break;
        }
    }
    Err(Refusal::NotConverged { what: Subject::MoserVeselovTurn, iterations: ROUNDS, residual: moved }.into())
}

/// Sums of integers times products of the elementary symmetric functions.
macro_rules! sum {
    ($($n:literal $first:ident $($rest:ident)*),*) => {
        T::zero() $(+ whole::<T>($n) * $first.clone() $(* $rest.clone())*)*
    };
}

/// What the two numbers `a` and `b` of `1/K = a/I + b` take of the body alone: to order 8, since that is
/// what steps at a fixed rate take at each step.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Corrections<T: nalgebra::Scalar> {
    /// The inverse moments in units of the first: with the step as unit of time everything is a pure number,
    /// and small where the step is.
    ratios: Vector3<T>,
    /// Their elementary symmetric functions.
    symmetric: [T; 3],
    to_4: [[T; 2]; 2],
    to_6: [[T; 3]; 2],
    to_8: [[T; 4]; 2],
}

impl<T: Field> Corrections<T> {
    pub(crate) fn of(inverse: &Vector3<T>) -> Self {
        let unit = &inverse.x;
        let ratio = |x: &T| x.clone() / unit.clone();
        let ratios = Vector3::new(T::one(), ratio(&inverse.y), ratio(&inverse.z));
        let [x, y, z] = [&ratios.x, &ratios.y, &ratios.z];
        let p = |x: &T, y: &T| x.clone() * y.clone();
        let e1 = x.clone() + y.clone() + z.clone();
        let e2 = p(x, y) + p(y, z) + p(z, x);
        let e3 = p(&p(x, y), z);
        Self {
            to_4: over(12, [[sum!(1 e2), sum!(-2 e1)], [sum!(-2 e3), sum!(1 e2)]]),
            to_6: over(
                240,
                [
                    [sum!(2 e2 e2, -6 e1 e3), sum!(-2 e1 e2, 8 e3), sum!(2 e1 e1, -1 e2)],
                    [sum!(-1 e2 e3), sum!(-1 e2 e2, 8 e1 e3), sum!(-1 e1 e2, -6 e3)],
                ],
            ),
            to_8: over(20_160, to_order_8([&e1, &e2, &e3])),
            ratios,
            symmetric: [e1, e2, e3],
        }
    }

    /// `a` and `b` for the momentum times the step, in units of the first moment.
    #[inline]
    fn at(&self, momentum: &Vector3<T>, order: u32) -> (T, T) {
        let square = momentum.dot(momentum);
        let twice_energy = momentum.dot(&self.ratios.component_mul(momentum));
        // sum of parts[j] square^(k - j) twice_energy^j.
        let joined = |parts: &[T]| {
            let [first, others @ ..] = parts else { return T::zero() };
            let mut power = T::one();
            others.iter().fold(first.clone(), |total, part| {
                power *= twice_energy.clone();
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
            let [e1, e2, e3] = &self.symmetric;
            let [to_a, to_b] = over(725_760, to_order_10([e1, e2, e3]));
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
fn to_order_8<T: Field>([e1, e2, e3]: [&T; 3]) -> [[T; 4]; 2] {
    [
        [
            sum!(17 e2 e2 e2, -66 e1 e2 e3, 100 e3 e3),
            sum!(-36 e1 e2 e2, 132 e1 e1 e3, -30 e2 e3),
            sum!(6 e1 e1 e2, 41 e2 e2, -212 e1 e3),
            sum!(-4 e1 e1 e1, 4 e1 e2, 72 e3),
        ],
        [
            sum!(-19 e2 e2 e3, 72 e1 e3 e3),
            sum!(2 e2 e2 e2, -2 e1 e2 e3, -176 e3 e3),
            sum!(13 e1 e2 e2, -64 e1 e1 e3, 110 e2 e3),
            sum!(2 e1 e1 e2, -26 e2 e2, 60 e1 e3),
        ],
    ]
}

/// What the order 10 adds to `a` and `b`: the parts that [`Corrections::at`] joins, times 725_760.
fn to_order_10<T: Field>([e1, e2, e3]: [&T; 3]) -> [[T; 5]; 2] {
    [
        [
            sum!(62 e2 e2 e2 e2, -342 e1 e2 e2 e3, 378 e1 e1 e3 e3, 291 e2 e3 e3),
            sum!(-154 e1 e2 e2 e2, 612 e1 e1 e2 e3, 282 e2 e2 e3, -2256 e1 e3 e3),
            sum!(156 e1 e1 e2 e2, 18 e2 e2 e2, -612 e1 e1 e1 e3, 180 e1 e2 e3, 1908 e3 e3),
            sum!(-4 e1 e1 e1 e2, -264 e1 e2 e2, 1104 e1 e1 e3, -828 e2 e3),
            sum!(2 e1 e1 e1 e1, -3 e1 e1 e2, 153 e2 e2, -486 e1 e3),
        ],
        [
            sum!(-61 e2 e2 e2 e3, 243 e1 e2 e3 e3, -610 e3 e3 e3),
            sum!(-1 e2 e2 e2 e2, 222 e1 e2 e2 e3, -864 e1 e1 e3 e3, 684 e2 e3 e3),
            sum!(-30 e1 e2 e2 e2, 114 e1 e1 e2 e3, -798 e2 e2 e3, 2136 e1 e3 e3),
            sum!(-30 e1 e1 e2 e2, 194 e2 e2 e2, 128 e1 e1 e1 e3, -552 e1 e2 e3, -1296 e3 e3),
            sum!(-1 e1 e1 e1 e2, -6 e1 e2 e2, -126 e1 e1 e3, 459 e2 e3),
        ],
    ]
}
