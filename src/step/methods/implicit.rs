//! The equations of an implicit step `x = next(x)`: by iteration, and where that fails by Newton's method;
//! and linear ones.

use crate::body::Rate;
use crate::error::{Error, Refusal, Subject};
use crate::number::{Analytic, Field, Ring};
use nalgebra::Vector3;

/// The most rounds of an iteration. Where it converges at all it gains a digit in a few rounds.
const ROUNDS: usize = 200;

/// The most rounds of Newton's method.
const NEWTON_ROUNDS: usize = 40;

/// The most unknowns: three stages of an attitude and a momentum.
const MOST: usize = 21;

/// Unknowns, as numbers one by one.
pub(super) trait Unknowns<T>: Clone {
    const COUNT: usize;
    fn part(&mut self, index: usize) -> &mut T;
}

impl<T: Analytic> Unknowns<T> for Vector3<T> {
    const COUNT: usize = 3;
    fn part(&mut self, index: usize) -> &mut T {
        &mut self[index % 3]
    }
}

impl<T: Analytic, const N: usize> Unknowns<T> for [Rate<T>; N] {
    const COUNT: usize = 7 * N;
    fn part(&mut self, index: usize) -> &mut T {
        let rate = &mut self[index / 7 % N];
        match index % 7 {
            i @ 0..4 => &mut rate.attitude.coords[i],
            i => &mut rate.momentum[i - 4],
        }
    }
}

/// An equation `x = next(x)`.
pub(super) struct Equation<N, D> {
    /// What `x` is, for a refusal.
    pub(super) what: Subject,
    pub(super) next: N,
    /// How far two are apart, relative to what they are rounded by.
    pub(super) apart: D,
}

/// How an equation was solved.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum By {
    Iteration,
    Newton,
}

impl<N, D> Equation<N, D> {
    /// A solution to rounding, by iteration from `guess`, or if that fails by Newton's method in these units
    /// of the unknowns.
    #[inline(always)]
    pub(super) fn solve<T: Analytic, S: Unknowns<T>>(
        &self,
        guess: S,
        units: impl FnOnce() -> S,
    ) -> Result<(S, By), Error>
    where
        N: Fn(&S) -> S,
        D: Fn(&S, &S) -> f64,
    {
        match self.iterated(guess.clone(), T::rounding()) {
            Ok(found) => Ok((found, By::Iteration)),
            Err(residual) => self.newton(guess, units()).map(|found| (found, By::Newton)).ok_or_else(|| {
                Refusal::NotConverged { what: self.what, iterations: ROUNDS, residual }.into()
            }),
        }
    }

    /// The fixed point, iterated until it moves by no more than rounding; or else how far it moved at last.
    /// On power series each round settles one power, until nothing moves at all.
    #[inline(always)]
    fn iterated<S>(&self, mut guess: S, rounding: f64) -> Result<S, f64>
    where
        N: Fn(&S) -> S,
        D: Fn(&S, &S) -> f64,
    {
        let mut moved = f64::INFINITY;
        for _ in 0..ROUNDS {
            let before = moved;
            let better = (self.next)(&guess);
            moved = (self.apart)(&guess, &better);
            guess = better;
            if settled(moved, before, rounding) {
                return Ok(guess);
            }
            if !moved.is_finite() {
                break;
            }
        }
        Err(if moved.is_nan() { f64::INFINITY } else { moved })
    }

    // Not inlined, as what it calls: few steps come here.
    #[inline(never)]
    fn newton<T: Analytic, S: Unknowns<T>>(&self, mut guess: S, mut units: S) -> Option<S>
    where
        N: Fn(&S) -> S,
        D: Fn(&S, &S) -> f64,
    {
        let rounding = T::rounding();
        if rounding == 0.0 {
            return None;
        }
        // The root of the rounding: of f64 or of f32.
        let nudge = T::one() / T::integer(if rounding < 1e-12 { 1 << 26 } else { 1 << 12 });
        let mut moved = f64::INFINITY;
        for _ in 0..NEWTON_ROUNDS {
            let mut here = (self.next)(&guess);
            let mut rows: [[T; MOST + 1]; MOST] =
                core::array::from_fn(|_| core::array::from_fn(|_| T::zero()));
            for j in 0..S::COUNT {
                let mut near = guess.clone();
                *near.part(j) += units.part(j).clone() * nudge.clone();
                let mut there = (self.next)(&near);
                for (i, row) in rows.iter_mut().enumerate().take(S::COUNT) {
                    let derivative = (there.part(i).clone() - here.part(i).clone())
                        / (nudge.clone() * units.part(i).clone());
                    row[j] = if i == j { T::one() - derivative } else { -derivative };
                }
            }
            for (i, row) in rows.iter_mut().enumerate().take(S::COUNT) {
                row[MOST] = (here.part(i).clone() - guess.part(i).clone()) / units.part(i).clone();
            }
            eliminate(&mut rows, S::COUNT);
            let mut better = guess.clone();
            for (i, row) in rows.iter().enumerate().take(S::COUNT) {
                *better.part(i) += row[MOST].clone() * units.part(i).clone();
            }
            let before = moved;
            moved = (self.apart)(&guess, &better);
            guess = better;
            if settled(moved, before, rounding) {
                return Some(guess);
            }
            if !moved.is_finite() {
                return None;
            }
        }
        None
    }
}

/// Whether the remaining changes are rounding: a change is not smaller than the one before, or so much
/// smaller that the next would be far below rounding. A systematic remainder in each step would add up
/// linearly.
fn settled(moved: f64, before: f64, rounding: f64) -> bool {
    let small = moved <= 64.0 * rounding;
    moved == 0.0 || small && (moved >= 0.5 * before || moved * moved <= 1e-6 * rounding * before)
}

/// Solves `count` linear equations, whose coefficients are the first columns: the further columns are the
/// right sides, which the solutions replace.
pub(crate) fn eliminate<T: Analytic, const N: usize>(rows: &mut [[T; N]], count: usize) {
    for k in 0..count {
        let pivot = (k..count).max_by(|&i, &j| rows[i][k].size().total_cmp(&rows[j][k].size())).unwrap_or(k);
        rows.swap(k, pivot);
        let row = rows[k].clone();
        for (i, other) in rows.iter_mut().enumerate().take(count) {
            if i == k {
                other.iter_mut().for_each(|x| *x /= row[k].clone());
                continue;
            }
            let share = other[k].clone() / row[k].clone();
            for (x, y) in other.iter_mut().zip(&row) {
                *x -= share.clone() * y.clone();
            }
        }
    }
}

/// The solution of three linear equations, by the columns of their coefficients.
#[inline(always)]
pub(crate) fn cramer<T: Field>([x, y, z]: [Vector3<T>; 3], right: &Vector3<T>) -> Vector3<T> {
    let (yz, zx, xy) = (y.cross(&z), z.cross(&x), x.cross(&y));
    let inverse = T::one() / x.dot(&yz);
    Vector3::new(yz.dot(right), zx.dot(right), xy.dot(right)).map(|x| x * inverse.clone())
}

/// An integer over another.
pub(crate) fn ratio<T: Field>(n: i32, below: u32) -> T {
    whole::<T>(n) / T::integer(below)
}

/// An integer.
#[inline(always)]
pub(crate) fn whole<T: Ring>(n: i32) -> T {
    let size = T::integer(n.unsigned_abs());
    if n < 0 { -size } else { size }
}
