//! The implicit midpoint rule in a form that keeps all that [`MethodInfo`](crate::step::MethodInfo) names,
//! and Gauss's collocation of orders 4 and 6 ([But64](crate::references), [HLW06](crate::references)), solved
//! to rounding by iteration or by Newton's method.
//!
//! Their errors in conserved quantities are a random walk of roundings. This needs equations that conserve
//! them even with rounded coefficients ([HMR08](crate::references)): if the rounding of a coefficient
//! violated a law, each step would have the same error.

use super::implicit::{By, Equation, cramer, ratio};
use crate::attitude;
use crate::body::{Rate, State};
use crate::error::{Error, Refusal, Subject};
use crate::number::Analytic;
use crate::step::system::System;
use nalgebra::{Quaternion, Vector3};

fn size<T: Analytic>(v: &Vector3<T>) -> f64 {
    v.as_slice().iter().map(Analytic::size).sum()
}

/// The largest component.
fn largest<T: Analytic>(v: &Vector3<T>) -> T {
    v[v.map(|x| x.size()).imax()].clone()
}

/// What a momentum that changes by about this much is measured in.
fn unit<T: Analytic>(momentum: &Vector3<T>, change: &Vector3<T>) -> f64 {
    match size(momentum) + size(change) {
        0.0 => 1.0,
        size => size,
    }
}

/// The sizes of the components of a momentum about as large as this one: along the axis of a needle they are
/// far smaller than across.
fn units<T: Analytic>(system: &System<T>, momentum: &Vector3<T>) -> Vector3<T> {
    let (most, fastest) = (largest(momentum), largest(&system.omega(momentum)));
    system.moments().map(|moment| {
        let by_spin = moment * fastest.clone();
        if by_spin.size() < most.size() { by_spin } else { most.clone() }
    })
}

/// Relative to the size of a state: farther apart, two are not the same.
const NEAR: f64 = 1e-3;

/// A step whose equations may have several solutions is taken only if the same step back finds the start.
fn checked<T: Analytic>(
    start: &State<T>,
    (end, sure): (State<T>, bool),
    back: impl FnOnce(&State<T>) -> Result<(State<T>, bool), Error>,
) -> Result<State<T>, Error> {
    if sure { Ok(end) } else { undone(start, end, back) }
}

// Not inlined: few steps come here.
#[inline(never)]
fn undone<T: Analytic>(
    start: &State<T>,
    end: State<T>,
    back: impl FnOnce(&State<T>) -> Result<(State<T>, bool), Error>,
) -> Result<State<T>, Error> {
    let (again, _) = back(&end)?;
    let apart = apart(&again, start, NEAR * (size(&start.momentum) + size(&end.momentum)));
    let why = "the equations of the method have several solutions: the step back finds another start";
    let returned = apart.0 < NEAR && apart.1 <= 1.0;
    Refusal::Undefined { what: Subject::StepEnd, why }.when(!returned).map(|()| end)
}

/// How far two attitudes are apart, and two momenta in this unit.
fn apart<T: Analytic>(a: &State<T>, b: &State<T>, unit: f64) -> (f64, f64) {
    let turn = a.attitude.coords.clone() - &b.attitude.coords;
    (turn.iter().map(Analytic::size).sum::<f64>(), size(&(&a.momentum - &b.momentum)) / unit)
}

/// `L' - L = h (M x w + torque)` with `M` the mean of the momenta and `w = J M`, and a turn by half-angle
/// tangents `h w / 2`. That turn, without a torque, is what the rule itself makes of the momentum; so
/// attitude and momentum move as one, and the momentum stays in the world. The torque is taken at the mean of
/// the attitudes.
pub(crate) fn midpoint<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Result<State<T>, Error> {
    let half = h.clone() / T::integer(2);
    let found = halved(system, start, &half, &half)?;
    checked(start, found, |end| halved(system, end, &-half.clone(), &half))
}

/// Half-angle tangents with a square below this belong to one solution of a free body's equation at most: of
/// two solutions, the difference `d` obeys `d = d x c + h/2 S x J d` with `S` the mean of the two and `c`
/// that of its tangents, and as a map of spins the right side has no entry above a component of `c`, since no
/// moments differ by more than the third; so it is shorter than `sqrt(2) |c|` times `d`.
const UNIQUE: f64 = 0.5;

/// The step by twice `half` seconds, whose middle is at `time`; whether its equations have no other
/// solution.
#[inline(always)]
fn halved<T: Analytic>(
    system: &System<T>,
    start: &State<T>,
    half: &T,
    time: &T,
) -> Result<(State<T>, bool), Error> {
    let g = system.inverse.map(|x| x * half.clone());
    let tangents = |mean: &Vector3<T>| mean.component_mul(&g);
    let turn = |c: &Vector3<T>| {
        let cosine = T::one() / (T::one() + c.dot(c)).sqrt();
        let [x, y, z] = [&c.x, &c.y, &c.z].map(|x| x.clone() * cosine.clone());
        Quaternion::new(cosine, x, y, z)
    };
    let kick = |mean: &Vector3<T>, c: &Vector3<T>| {
        let mut sum = turn(c).coords;
        sum.w += T::one();
        let length = sum.dot(&sum).sqrt();
        let middle = Quaternion::from_vector(sum.map(|x| x / length.clone()));
        let here = State { attitude: attitude::product(&start.attitude, &middle), momentum: mean.clone() };
        system.torque_after(&here, time).map(|x| x * half.clone())
    };
    let [p, q, r] = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| difference(&g[i], &g[j]));
    let couplings = [p.0, q.0, r.0];
    let roundings = [p.1, q.1, r.1];
    let next = |mean: &Vector3<T>| {
        // The product `M x c` by differences, since of a needle's products two nearly cancel; of the very
        // tangents of the turn, and with what the differences are rounded by: else it would be off the turn
        // by the same in each step.
        let c = tangents(mean);
        let cross = Vector3::from_fn(|i, _| {
            let product = mean[(i + 1) % 3].clone() * mean[(i + 2) % 3].clone();
            -(couplings[i].clone() * product.clone() + roundings[i].clone() * product)
        });
        let mut miss = (&start.momentum - mean) + cross;
        if !system.is_free() {
            miss += kick(mean, &c);
        }
        if c.dot(&c).size() >= UNIQUE {
            return mean + miss;
        }
        mean + newton(&couplings, mean, &miss)
    };
    let push = system.torque_after(start, time).map(|x| x * half.clone());
    let unit = unit(&start.momentum, &push);
    let apart = |a: &Vector3<T>, b: &Vector3<T>| size(&(b - a)) / unit;
    let equation = Equation { what: Subject::Midpoint, next, apart };
    let units = || units(system, &(&start.momentum + &push));
    let (mean, by) = equation.solve(start.momentum.clone(), units)?;
    let c = tangents(&mean);
    let turned = turn(&c);
    let momentum = if system.is_free() {
        attitude::rotate_inverse(&turned, &start.momentum)
    } else {
        let push = kick(&mean, &c);
        attitude::rotate_inverse(&turned, &(&start.momentum + &push)) + push
    };
    let sure = by == By::Iteration && c.dot(&c).size() < UNIQUE;
    Ok((State { attitude: attitude::product(&start.attitude, &turned), momentum }, sure))
}

/// `a - b` as rounded, and what it is rounded by.
fn difference<T: Analytic>(a: &T, b: &T) -> (T, T) {
    let d = a.clone() - b.clone();
    let back = d.clone() - a.clone();
    let lost = (a.clone() - (d.clone() - back.clone())) - (b.clone() + back);
    (d, lost)
}

/// Newton's step for what the midpoint misses its equation by, but for how the torque changes.
#[inline(always)]
fn newton<T: Analytic>([p, q, r]: &[T; 3], mean: &Vector3<T>, miss: &Vector3<T>) -> Vector3<T> {
    let t = |x: &T, y: &T| x.clone() * y.clone();
    let x = Vector3::new(T::one(), t(q, &mean.z), t(r, &mean.y));
    let y = Vector3::new(t(p, &mean.z), T::one(), t(r, &mean.x));
    let z = Vector3::new(t(p, &mean.y), t(q, &mean.x), T::one());
    cramer([x, y, z], miss)
}

/// A collocation method with coefficients `b_j (1/2 + off_ij)`. It conserves squares because `off` is
/// antisymmetric, which it also is as rounded.
pub(crate) struct Tableau<T, const N: usize> {
    nodes: [T; N],
    /// `b`.
    weights: [T; N],
    off: [[T; N]; N],
}

pub(crate) fn order_4<T: Analytic>() -> Tableau<T, 2> {
    let half = T::one() / T::integer(2);
    let off = T::one() / T::integer(3).sqrt();
    Tableau {
        nodes: [half.clone() - off.clone() * half.clone(), half.clone() + off.clone() * half.clone()],
        weights: [half.clone(), half],
        off: [[T::zero(), -off.clone()], [off, T::zero()]],
    }
}

pub(crate) fn order_6<T: Analytic>() -> Tableau<T, 3> {
    let root = |n: i32, below: u32| T::integer(15).sqrt() * ratio(n, below);
    let (half, near, far) = (ratio::<T>(1, 2), root(3, 20), root(3, 25));
    Tableau {
        nodes: [half.clone() - root(1, 10), half.clone(), half + root(1, 10)],
        weights: [ratio(5, 18), ratio(4, 9), ratio(5, 18)],
        off: [
            [T::zero(), -near.clone(), -far.clone()],
            [near.clone(), T::zero(), -near.clone()],
            [far, near, T::zero()],
        ],
    }
}

/// The antisymmetric parts of both methods' coefficients: `a_ij / b_j - 1/2`.
pub fn rests_of_gauss<T: Analytic>() -> ([[T; 2]; 2], [[T; 3]; 3]) {
    (order_4().off, order_6().off)
}

/// A step by collocation.
pub(crate) fn collocated<T: Analytic, const N: usize>(
    system: &System<T>,
    start: &State<T>,
    h: &T,
    tableau: &Tableau<T, N>,
) -> Result<State<T>, Error> {
    let found = stages(system, start, &T::zero(), h, tableau)?;
    checked(start, found, |end| stages(system, end, h, &-h.clone(), tableau))
}

/// The step of `h` seconds from a start at `time`; whether iteration finds its equations' solution. The
/// unknowns are what each stage changes the state by.
#[inline(always)]
fn stages<T: Analytic, const N: usize>(
    system: &System<T>,
    start: &State<T>,
    time: &T,
    h: &T,
    Tableau { nodes, weights, off }: &Tableau<T, N>,
) -> Result<(State<T>, bool), Error> {
    let half = T::one() / T::integer(2);
    let weights = weights.each_ref().map(|b| b.clone() * h.clone());
    let total = |changes: &[Rate<T>; N]| {
        changes.iter().skip(1).fold(changes[0].clone(), |sum, change| sum.plus(change, T::one()))
    };
    let next = |changes: &[Rate<T>; N]| -> [Rate<T>; N] {
        let mean = total(changes).times(&half);
        let mut better = changes.clone();
        for (i, better) in better.iter_mut().enumerate() {
            // The small numbers first.
            let mut change = mean.clone();
            for j in (0..N).filter(|&j| j != i) {
                change = change.plus(&changes[j], off[i][j].clone());
            }
            let there = start.plus(&change, T::one());
            let rate = system.rate_after(&there, &(time.clone() + nodes[i].clone() * h.clone()));
            *better = rate.times(&weights[i]);
        }
        better
    };
    let first = system.rate_after(start, time);
    // Both in units of their own: the attitude's length, the momentum's.
    let gained = first.momentum.map(|x| x * h.clone());
    let unit = unit(&start.momentum, &gained);
    let apart = |a: &[Rate<T>; N], b: &[Rate<T>; N]| {
        a.iter().zip(b).fold(0.0, |sum, (a, b)| {
            let turn = b.attitude.coords.clone() - &a.attitude.coords;
            sum + turn.iter().map(Analytic::size).sum::<f64>() + size(&(&b.momentum - &a.momentum)) / unit
        })
    };
    let units = || {
        let momenta = units(system, &(&start.momentum + &gained));
        core::array::from_fn(|_| Rate {
            attitude: Quaternion::from_vector(start.attitude.coords.map(|_| T::one())),
            momentum: momenta.clone(),
        })
    };
    // Rates along a line from the start to the end of a step straight ahead.
    let last = system.rate_after(&start.plus(&first, h.clone()), &(time.clone() + h.clone()));
    let bend = last.plus(&first, -T::one());
    let guess = core::array::from_fn(|i| first.plus(&bend, nodes[i].clone()).times(&weights[i]));
    let equation = Equation { what: Subject::Stages, next, apart };
    let (changes, by) = equation.solve(guess, units)?;
    Ok((start.plus(&total(&changes), T::one()), by == By::Iteration))
}
