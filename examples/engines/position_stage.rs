//! The position stage of a physics engine: attitude and spin over a time step, with nothing else acting. It
//! keeps energy and momentum to rounding, whatever the body, the spin and the step. In the engine's loop,
//! after forces, damping, contacts and joints have changed the spin, it replaces the gyroscopic term and the
//! update of the attitude.
//!
//! One file without dependencies; `Real` is what the module around it calls so, `f32` or `f64`. It gives the
//! same bits as the library it is taken from, `tumbling::step::PositionStage`.
//!
//! Version: 0.1.0
//! Home: not yet published
//!
//! MIT License
//!
//! Copyright (c) 2026 the tumbling maintainers
//!
//! Permission is hereby granted, free of charge, to any person obtaining a copy
//! of this software and associated documentation files (the "Software"), to deal
//! in the Software without restriction, including without limitation the rights
//! to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
//! copies of the Software, and to permit persons to whom the Software is
//! furnished to do so, subject to the following conditions:
//!
//! The above copyright notice and this permission notice shall be included in all
//! copies or substantial portions of the Software.
//!
//! THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
//! IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
//! FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
//! AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
//! LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
//! OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
//! SOFTWARE.
//!
//! Or, at your choice, the Apache License, version 2.0.
//! SPDX-License-Identifier: MIT OR Apache-2.0

use super::Real;

type Triple = [Real; 3];

/// A body, prepared once: pure numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PositionStage {
    coupling: Triple,
    modulus: Triple,
    relative: Triple,
    twist: Triple,
    twist_2: [Real; 6],
    bound: Triple,
    frame: Option<[Real; 4]>,
}

impl PositionStage {
    /// From the inverse moments along the principal axes, and the turn (w, x, y, z) from these to the body's
    /// axes. With one of zero (a locked axis), and with what no body has (a moment that is negative or not
    /// finite, ratios of moments beyond the numbers, a turn of no length), the spin stays constant.
    pub fn new(inverse: Triple, frame: [Real; 4]) -> Self {
        let moments = inverse.map(|x| 1.0 / x);
        let free = inverse.iter().chain(&moments).all(|x| *x > 0.0 && x.is_finite());
        let Some(frame) = unit(frame) else { return Self::new([1.0; 3], [1.0, 0.0, 0.0, 0.0]) };
        let m = if free { moments } else { [1.0; 3] };
        let a = three(|i| (m[(i + 1) % 3] - m[(i + 2) % 3]) / m[i]);
        let mut order = [0, 1, 2];
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            if m[order[j]] < m[order[i]] {
                order.swap(i, j);
            }
        }
        let axes = [order[1], (order[1] + 1) % 3, (order[1] + 2) % 3];
        let (y, z) = (a[axes[1]], a[axes[2]]);
        let yz = y * z;
        let first = [
            (6.0 - yz) * (1.0 + yz),
            2.0 * (6.0 + 3.0 * (yz + z) + 4.0 * (y - 1.0) * z * z),
            2.0 * (6.0 + 3.0 * (yz - y) - 4.0 * (z + 1.0) * y * y),
            (1.0 + z) * (6.0 + 7.0 * yz + z * z) / (1.0 + yz),
            2.0 * (6.0 - yz * (2.0 + 3.0 * (y - z)) - 4.0 * (y * y + z * z) + 3.0 * (z - y)) / (1.0 + yz),
            (1.0 - y) * (6.0 + 7.0 * yz + y * y) / (1.0 + yz),
        ];
        let (mut twist, mut twist_2) = ([0.0; 3], [0.0; 6]);
        for (i, x) in [1.0 + yz, 1.0 + z, 1.0 - y].into_iter().enumerate() {
            twist[axes[i]] = x / 12.0;
        }
        let at = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];
        for (i, j) in [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)] {
            twist_2[at[axes[i]][axes[j]]] = first[at[i][j]] / 720.0;
        }
        let [lo, mid, hi] = order.map(|i| m[i]);
        let share = |weight: Real, over: Real, apart: Real, span: Real| {
            if apart == 0.0 { 0.0 } else { (weight / over) * (apart / span) }
        };
        let mut bound = [1.0; 3];
        bound[order[1]] = 1.0 + share(mid, lo, hi - mid, hi - lo) + share(mid, hi, mid - lo, hi - lo);
        if hi - mid > mid - lo {
            bound[order[0]] = 1.0 + share(lo, mid, hi - lo, hi - mid);
        } else {
            bound[order[2]] = 1.0 + share(hi, mid, hi - lo, mid - lo);
        }
        let most = a.iter().fold(1.0, |most: Real, x| most.max(x.abs()));
        let body = Self {
            coupling: a,
            modulus: three(|i| a[(i + 1) % 3] * a[(i + 2) % 3]),
            relative: m.map(|x| x / mid),
            twist,
            twist_2,
            bound: bound.map(|x| x * most * most),
            frame: (frame != [1.0, 0.0, 0.0, 0.0]).then_some(frame),
        };
        let numbers = [&body.modulus[..], &body.relative, &body.twist, &body.twist_2, &body.bound];
        let finite = numbers.into_iter().flatten().all(|x| x.is_finite());
        if finite { body } else { Self::new([1.0; 3], [1.0, 0.0, 0.0, 0.0]) }
    }

    /// The step of `h` seconds from an attitude (w, x, y, z; body to world; length 1) and a spin in world
    /// axes, rad/s, to those at its end. Returns the number of parts in which it was taken; 0 if it was not,
    /// and both are as they were: numbers that are not finite, a turn of more than about 2000 rad.
    #[inline]
    pub fn step(&self, attitude: &mut [Real; 4], omega: &mut Triple, h: Real) -> u32 {
        if self.part(attitude, omega, h) { 1 } else { self.in_parts(attitude, omega, h) }
    }

    #[cold]
    fn in_parts(&self, attitude: &mut [Real; 4], omega: &mut Triple, h: Real) -> u32 {
        let length = square(attitude).sqrt();
        let (mut q, mut w) = (attitude.map(|x| x / length), *omega);
        let turn = self.spin(&q, &w, h).2.sqrt() / 0.5;
        if turn.is_nan() || turn > 4096.0 {
            return 0;
        }
        let parts = turn.ceil().max(1.0);
        for _ in 0..parts as u32 {
            if !self.part(&mut q, &mut w, h / parts) {
                return 0;
            }
        }
        (*attitude, *omega) = (q, w);
        parts as u32
    }

    /// The rotation matrix from the principal axes to the world, the spin along these, the turn's square.
    #[inline(always)]
    fn spin(&self, q: &[Real; 4], v: &Triple, h: Real) -> ([Triple; 3], Triple, Real) {
        let mut u = *q;
        if let Some(f) = &self.frame {
            u = [
                q[0] * f[0] - q[1] * f[1] - q[2] * f[2] - q[3] * f[3],
                q[0] * f[1] + q[1] * f[0] + q[2] * f[3] - q[3] * f[2],
                q[0] * f[2] - q[1] * f[3] + q[2] * f[0] + q[3] * f[1],
                q[0] * f[3] + q[1] * f[2] - q[2] * f[1] + q[3] * f[0],
            ];
        }
        let [w, x, y, z] = u;
        let [x2, y2, z2] = [x + x, y + y, z + z];
        let r = [
            [1.0 - (y * y2 + z * z2), x * y2 - w * z2, x * z2 + w * y2],
            [x * y2 + w * z2, 1.0 - (x * x2 + z * z2), y * z2 - w * x2],
            [x * z2 - w * y2, y * z2 + w * x2, 1.0 - (x * x2 + y * y2)],
        ];
        let omega = three(|i| r[0][i] * v[0] + r[1][i] * v[1] + r[2][i] * v[2]);
        let s = omega.map(|x| (x * h) * (x * h));
        (r, omega, self.bound[0] * s[0] + self.bound[1] * s[1] + self.bound[2] * s[2])
    }

    /// One part of a step, of half a radian at most; false if it is longer or not finite.
    #[inline(always)]
    fn part(&self, attitude: &mut [Real; 4], spin: &mut Triple, h: Real) -> bool {
        let (r, omega, turn) = self.spin(attitude, spin, h);
        let length = square(attitude);
        if !(turn <= 0.5 * 0.5 * 1.0001_f32 as Real && (length - 1.0).abs() <= Real::EPSILON * 32.0) {
            return false;
        }
        let (a, t, u) = (&self.coupling, &self.twist, &self.twist_2);
        let s = omega.map(|x| (x * h) * (x * h));
        let e = three(|i| self.modulus[i] * s[i]);
        let mean = (e[0] + e[1] + e[2]) * (1.0 / 3.0);
        let e = e.map(|x| mean - x);
        let squares = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        let series = squares * (1.0 / 10.0 + squares * (1.0 / 300.0)) + (e[0] * e[1]) * e[2] * (1.0 / 7.0);
        let twist = t[0] * s[0] + t[1] * s[1] + t[2] * s[2];
        let more = s[0] * (u[0] * s[0] + u[1] * s[1] + u[2] * s[2])
            + s[1] * (u[3] * s[1] + u[4] * s[2])
            + s[2] * (u[5] * s[2]);
        let twist = twist + more * (1.0 + twist * (17.0 / 14.0));
        let rate = (1.0 - mean) + series;
        let k = self.relative.map(|x| 1.0 + x * twist);
        let root = three(|i| (rate + a[(i + 1) % 3] * a[(i + 2) % 3] * s[i]).sqrt());
        let bend = three(|i| a[i] * (omega[(i + 1) % 3] * h));
        let sum = three(|i| {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            omega[i] * (rate + root[j] * root[l]) + bend[i] * omega[l] * root[i]
        });
        let product = root[0] * (root[1] * root[2]) + bend[0] * bend[1] * bend[2];
        let below = rate * (rate * ((root[0] + root[1]) + root[2]) + product);
        let scaled = sum.map(|x| x * h);
        let c = three(|i| k[i] * (scaled[i] * rate));
        let b = three(|i| k[i] * (a[i] * (scaled[(i + 1) % 3] * sum[(i + 2) % 3])));
        let along = (c[0] * b[0] + c[1] * b[1]) + c[2] * b[2];
        let stretched = (below * below + c[0] * c[0]) + (c[1] * c[1] + c[2] * c[2]);
        let once = 1.0 / (below * (stretched * length).sqrt());
        let over = once * below;
        let change = three(|i| {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            below * (below * b[i] + (c[j] * b[l] - c[l] * b[j])) + c[i] * along
        });
        let back = |r: &Triple| (r[0] * change[0] + r[1] * change[1]) + r[2] * change[2];
        let v = three(|i| spin[i] + back(&r[i]) * (once * over));
        if !(v[0] + v[1] + v[2] + over).is_finite() {
            return false;
        }
        let (c, d) = (self.in_body(c), below);
        let [w, x, y, z] = *attitude;
        *attitude = [
            (w * d - (x * c[0] + y * c[1] + z * c[2])) * over,
            (x * d + (w * c[0] + (y * c[2] - z * c[1]))) * over,
            (y * d + (w * c[1] + (z * c[0] - x * c[2]))) * over,
            (z * d + (w * c[2] + (x * c[1] - y * c[0]))) * over,
        ];
        *spin = v;
        true
    }

    #[inline(always)]
    fn in_body(&self, v: Triple) -> Triple {
        let Some([w, x, y, z]) = self.frame else { return v };
        let cross = |[a, b, c]: Triple| [y * c - z * b, z * a - x * c, x * b - y * a];
        let across = cross(v).map(|x| x + x);
        let twice = cross(across);
        three(|i| v[i] + (w * across[i] + twice[i]))
    }
}

#[inline(always)]
fn three(of: impl FnMut(usize) -> Real) -> Triple {
    [0, 1, 2].map(of)
}

#[inline(always)]
fn square([w, x, y, z]: &[Real; 4]) -> Real {
    (w * w + x * x) + (y * y + z * z)
}

/// Of length 1; scaled first where its square leaves the range of numbers.
fn unit(q: [Real; 4]) -> Option<[Real; 4]> {
    let largest = q.iter().fold(0.0, |most: Real, x| most.max(x.abs()));
    let ordinary = (1e-30..=1e30).contains(&square(&q));
    let q = if ordinary { q } else { q.map(|x| x / largest) };
    let norm = square(&q).sqrt();
    (norm > 0.0).then(|| q.map(|x| x / norm))
}
