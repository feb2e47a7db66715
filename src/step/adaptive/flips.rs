//! Changes of sign of the spin about the middle axis, from the series of each step.

use super::series::LENGTH;
use crate::body::State;
use crate::inertia::ascending;
use crate::step::system::System;
use alloc::vec::Vec;

/// A polynomial from 0 to 1 in Bernstein form. Its number of roots there is the number of sign changes of its
/// coefficients, or less by an even number.
type Bernstein = [f64; LENGTH];

/// The number of halvings of an interval to separate two roots; after them its length is below the rounding
/// of its ends.
const HALVINGS: u32 = 48;

/// The sign changes found in one component of the spin.
#[derive(Debug, Clone)]
pub(super) struct Flips {
    pub(super) axis: usize,
    /// The sign at the end of the last step, or zero if it is not known yet.
    sign: f64,
    /// The last flip found, s after the start of the run.
    last: Option<f64>,
    found: Vec<f64>,
}

impl Flips {
    /// `before` is the sign of the spin before the start, or zero if it is not known.
    pub(super) fn new(system: &System<f64>, start: &State<f64>, before: f64) -> Self {
        let [_, axis, _] = ascending(system.moments());
        let sign = if before == 0.0 { sign(start.momentum[axis]) } else { before };
        Self { axis, sign, last: None, found: Vec::new() }
    }

    /// Removes and returns the flips before a time (s after the start of the run, which may run backward),
    /// and the sign before that time.
    pub(super) fn take_before(&mut self, time: f64, back: bool) -> (Vec<f64>, f64) {
        let count =
            self.found.iter().take_while(|&&flip| if back { flip > time } else { flip < time }).count();
        let later = self.found.split_off(count);
        let sign = if later.len().is_multiple_of(2) { self.sign } else { -self.sign };
        (core::mem::replace(&mut self.found, later), sign)
    }

    fn push(&mut self, time: f64) {
        self.found.push(time);
        self.last = Some(time);
    }

    /// Looks for flips in a step of `length` units from `start` (s after the start of the run), where the
    /// spin has these coefficients.
    pub(super) fn find(&mut self, coefficients: &[f64], length: f64, start: f64, unit: f64) {
        let mut scaled = [0.0; LENGTH];
        let mut power = 1.0;
        for (term, c) in scaled.iter_mut().zip(coefficients) {
            *term = c * power;
            power *= length;
        }
        let scaled = &mut scaled[..coefficients.len()];
        let here = sign_at_start(scaled);
        let [first, rest @ ..] = &*scaled else { return };
        let whole = length * unit;
        // The sign differs from the sign after the step before. Either both steps missed a flip, or the step
        // before found it at its end and this step would find it again at its start.
        let mut known = false;
        if here * self.sign < 0.0 {
            known = self.last.is_some_and(|last| (last - start).abs() < 1e-6 * whole.abs());
            if !known {
                self.push(start);
            }
        }
        if here != 0.0 {
            self.sign = here;
        }
        if rest.iter().map(|x| x.abs()).sum::<f64>() < first.abs() {
            return;
        }
        let mut shares = Vec::new();
        roots(&bernstein(scaled), scaled.len(), (0.0, 1.0), HALVINGS, &mut shares);
        for share in shares {
            self.sign = -self.sign;
            if !(core::mem::take(&mut known) && share < 1e-6) {
                self.push(start + sharpened(scaled, share) * whole);
            }
        }
    }
}

fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { 1.0_f64.copysign(x) }
}

/// The sign of the spin at the start; if the spin is zero there, the sign that it takes next; zero if it
/// stays zero. Leading coefficients that are only rounding are set to zero.
fn sign_at_start(coefficients: &mut [f64]) -> f64 {
    if coefficients.first() == Some(&0.0) {
        let noise = 1e-14 * coefficients.iter().fold(0.0, |most, x| x.abs().max(most));
        coefficients.iter_mut().take_while(|x| x.abs() <= noise).for_each(|x| *x = 0.0);
    }
    coefficients.iter().find(|x| **x != 0.0).map_or(0.0, |x| sign(*x))
}

/// The Bernstein coefficients from the coefficients of powers: `b[i]` is the sum of `C(i, k) / C(n, k) c[k]`.
fn bernstein(coefficients: &[f64]) -> Bernstein {
    let mut out = [0.0; LENGTH];
    let n = coefficients.len().saturating_sub(1);
    for (i, b) in out.iter_mut().enumerate().take(n + 1) {
        let mut share = 1.0;
        for (k, c) in coefficients.iter().enumerate().take(i + 1) {
            *b += share * c;
            share *= (i - k) as f64 / (n - k).max(1) as f64;
        }
    }
    out
}

/// The roots in an interval: it is halved until each part has one root, and then until the root is found.
fn roots(b: &Bernstein, count: usize, (low, high): (f64, f64), left: u32, found: &mut Vec<f64>) {
    let signs = b[..count].iter().filter(|x| **x != 0.0).map(|x| x.is_sign_negative());
    let (mut changes, mut before) = (0, None);
    for negative in signs {
        changes += u32::from(before.is_some_and(|other| other != negative));
        before = Some(negative);
    }
    let middle = 0.5 * (low + high);
    if changes == 0 {
        return;
    }
    if left == 0 {
        // Two roots that coincide are not a flip: the sign is the same before and after.
        if changes % 2 == 1 {
            found.push(middle);
        }
        return;
    }
    let (mut lower, mut upper) = (*b, *b);
    for round in 1..count {
        for i in (round..count).rev() {
            lower[i] = 0.5 * (lower[i - 1] + lower[i]);
        }
        for i in 0..count - round {
            upper[i] = 0.5 * (upper[i] + upper[i + 1]);
        }
    }
    roots(&lower, count, (low, middle), left - 1, found);
    // A root at the middle itself is in neither half.
    if upper[0] == 0.0 {
        let before = lower[..count].iter().rev().find(|x| **x != 0.0);
        let after = upper[..count].iter().find(|x| **x != 0.0);
        if before.zip(after).is_some_and(|(a, b)| a.is_sign_negative() != b.is_sign_negative()) {
            found.push(middle);
        }
    }
    roots(&upper, count, (middle, high), left - 1, found);
}

/// Improves a root by one step of Newton's method, if the step is shorter than 1e-10.
fn sharpened(coefficients: &[f64], root: f64) -> f64 {
    let (mut value, mut derivative) = (0.0, 0.0);
    for c in coefficients.iter().rev() {
        derivative = derivative * root + value;
        value = value * root + c;
    }
    let better = root - value / derivative;
    if (better - root).abs() < 1e-10 { better } else { root }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(x - 0.2)(x - 0.2000001)(x - 0.7)(x + 1)`, and `(x - 0.5)² + 1e-9`, which only comes near.
    #[test]
    fn near_roots_are_told_apart_and_a_near_miss_is_none() {
        let product = |roots: &[f64]| {
            roots.iter().fold(vec![1.0], |sum: Vec<f64>, root| {
                let mut next = vec![0.0; sum.len() + 1];
                for (k, c) in sum.iter().enumerate() {
                    next[k] -= root * c;
                    next[k + 1] += c;
                }
                next
            })
        };
        let found = |c: &[f64]| {
            let mut all = Vec::new();
            roots(&bernstein(c), c.len(), (0.0, 1.0), HALVINGS, &mut all);
            all.iter().map(|&x| sharpened(c, x)).collect::<Vec<f64>>()
        };
        let three = found(&product(&[0.2, 0.200_000_1, 0.7, -1.0]));
        assert_eq!(three.len(), 3, "{three:?}");
        for (x, expected) in three.iter().zip([0.2, 0.200_000_1, 0.7]) {
            assert!((x - expected).abs() < 1e-8, "{x}");
        }
        assert!(found(&[0.25 + 1e-9, -1.0, 1.0]).is_empty());
        // At the middle of the step, where its halves meet.
        assert_eq!(found(&[1.0, -2.0]), [0.5]);
        assert_eq!(found(&product(&[0.25, 0.5, 2.0])), [0.25, 0.5]);
    }
    /// The flips found in a step of 2 s from 10 s, if the spin was positive and flipped before.
    #[test]
    fn a_flip_where_two_steps_meet_is_found_once_and_two_a_little_apart_are_two() {
        let found = |last: f64, coefficients: &[f64]| {
            let mut flips = Flips { axis: 1, sign: 1.0, last: Some(last), found: Vec::new() };
            flips.find(coefficients, 1.0, 10.0, 2.0);
            flips.found
        };
        // Below zero from the start: seen at the end of the step before, or in neither.
        assert!(found(10.0 - 1e-6, &[-0.5, -0.1]).is_empty());
        assert_eq!(found(10.0 - 4e-6, &[-0.5, -0.1]), [10.0]);
        // Back above zero after a share of the step: one flip seen by both, or another.
        assert!(found(10.0 - 1e-6, &[-1e-7, 1.0]).is_empty());
        let two = found(10.0 - 1e-6, &[-1e-5, 1.0]);
        assert!(two.len() == 1 && (two[0] - 10.00002).abs() < 1e-12, "{two:?}");
    }

    #[test]
    fn a_spin_that_leaves_zero_takes_the_sign_of_the_first_coefficient_above_rounding() {
        assert_eq!(sign_at_start(&mut [0.0, 0.9e-14, -1.0]), -1.0);
        assert_eq!(sign_at_start(&mut [0.0, 1.1e-14, -1.0]), 1.0);
        // A number that is not zero keeps its sign, however small it is.
        assert_eq!(sign_at_start(&mut [1e-20, -1.0]), 1.0);
    }

    /// From the line through 0.3, and from a parabola that only just meets zero at a half.
    #[test]
    fn a_root_is_sharpened_by_less_than_its_interval() {
        assert_eq!(sharpened(&[-0.3, 1.0], 0.3 + 0.9e-10), 0.3);
        let far = 0.3 + 1.1e-10;
        assert_eq!(sharpened(&[-0.3, 1.0], far), far);
        let near_double = 0.5 + 1e-9;
        assert_eq!(sharpened(&[0.25, -1.0, 1.0], near_double), near_double);
    }
}
