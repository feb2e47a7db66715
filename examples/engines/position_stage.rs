//! The position stage of a physics engine: attitude and spin over a time step, with nothing else acting. It
//! keeps energy and momentum to rounding, whatever the spin and the step, if no axis is locked. In the
//! engine's loop, after forces, damping, contacts and joints have changed the spin, it replaces the
//! gyroscopic term and the update of the attitude.
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

/// The square of the longest turn of a part of a step, and a hair more for what the parts of a longer one are
/// rounded by.
const LONGEST: Real = 0.5 * 0.5 * 1.0001_f32 as Real;

/// A body, prepared once: pure numbers. A turn whose square is at most `steady` needs no gyroscopic term: the
/// body is round, or the term is below rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PositionStage {
    coupling: Triple,
    relative: Triple,
    twist: Triple,
    twist_2: [Real; 6],
    bound: Triple,
    steady: Real,
    frame: Option<[Real; 4]>,
}

impl PositionStage {
    /// From the inverse moments along the principal axes, and the turn (w, x, y, z) from these to the body's
    /// axes. With one of zero (a locked axis), and with what no body has (a moment that is negative or not
    /// finite, ratios of moments beyond the numbers, a turn of no length), the spin stays constant.
    pub fn of_inverse(inverse: Triple, frame: [Real; 4]) -> Self {
        let moments = inverse.map(|x| 1.0 / x);
        let free = inverse.iter().chain(&moments).all(|x| *x > 0.0 && x.is_finite());
        let Some(frame) = unit(frame) else { return Self::of_inverse([1.0; 3], [1.0, 0.0, 0.0, 0.0]) };
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
        let bound = bound.map(|x| x * most * most);
        let body = Self {
            coupling: a,
            relative: m.map(|x| x / mid),
            twist,
            twist_2,
            bound,
            steady: if a == [0.0; 3] { LONGEST } else { steady(&bound) },
            frame: (frame != [1.0, 0.0, 0.0, 0.0]).then_some(frame),
        };
        let mut numbers = [&body.relative[..], &body.twist, &body.twist_2, &body.bound].into_iter().flatten();
        if numbers.all(|x| x.is_finite()) { body } else { Self::of_inverse([1.0; 3], [1.0, 0.0, 0.0, 0.0]) }
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
        if !(0..parts as u32).all(|_| self.part(&mut q, &mut w, h / parts)) {
            return 0;
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
        let s = three(|i| (omega[i] * h) * (omega[i] * h));
        (r, omega, self.bound[0] * s[0] + self.bound[1] * s[1] + self.bound[2] * s[2])
    }

    /// One part of a step, of half a radian at most; false if it is longer or not finite.
    #[inline(always)]
    fn part(&self, attitude: &mut [Real; 4], spin: &mut Triple, h: Real) -> bool {
        let steady = turn_square(spin, h) <= self.steady;
        let end = if steady { steady_turn(attitude, spin, h) } else { self.turn(attitude, spin, h) };
        if taken(&end) {
            (*attitude, *spin) = ([end[0], end[1], end[2], end[3]], [end[4], end[5], end[6]]);
        }
        taken(&end)
    }

    /// Where a part ends, whatever its numbers.
    #[inline(always)]
    fn turn(&self, attitude: &[Real; 4], spin: &Triple, h: Real) -> End {
        let (r, omega, turn) = self.spin(attitude, spin, h);
        let length = square(attitude);
        let (a, t, u) = (&self.coupling, &self.twist, &self.twist_2);
        let s = three(|i| (omega[i] * h) * (omega[i] * h));
        let m = three(|i| a[(i + 1) % 3] * a[(i + 2) % 3] * s[i]);
        let mean = (m[0] + m[1] + m[2]) * (1.0 / 3.0);
        let e = three(|i| mean - m[i]);
        let squares = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        let series = squares * (1.0 / 10.0 + squares * (1.0 / 300.0)) + (e[0] * e[1]) * e[2] * (1.0 / 7.0);
        let twist = t[0] * s[0] + t[1] * s[1] + t[2] * s[2];
        let more = s[0] * (u[0] * s[0] + u[1] * s[1] + u[2] * s[2])
            + s[1] * (u[3] * s[1] + u[4] * s[2])
            + s[2] * (u[5] * s[2]);
        let twist = twist + more * (1.0 + twist * (17.0 / 14.0));
        let rate = (1.0 - mean) + series;
        let k = three(|i| 1.0 + self.relative[i] * twist);
        let root = three(|i| (rate + m[i]).sqrt());
        let bend = three(|i| a[i] * (omega[(i + 1) % 3] * h));
        let sum = three(|i| {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            omega[i] * (rate + root[j] * root[l]) + bend[i] * omega[l] * root[i]
        });
        let product = root[0] * (root[1] * root[2]) + bend[0] * bend[1] * bend[2];
        let below = rate * (rate * ((root[0] + root[1]) + root[2]) + product);
        let scaled = three(|i| sum[i] * h);
        let c = three(|i| k[i] * (scaled[i] * rate));
        let b = three(|i| k[i] * (a[i] * (scaled[(i + 1) % 3] * sum[(i + 2) % 3])));
        let along = (c[0] * b[0] + c[1] * b[1]) + c[2] * b[2];
        let square = ((below * below + c[0] * c[0]) + (c[1] * c[1] + c[2] * c[2])) * length;
        // The root and the division do not wait for each other.
        let scale = 1.0 / (below * square);
        let over = (scale * below) * square.sqrt();
        let change = three(|i| {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            below * (below * b[i] + (c[j] * b[l] - c[l] * b[j])) + c[i] * along
        });
        let back = |r: &Triple| (r[0] * change[0] + r[1] * change[1]) + r[2] * change[2];
        let v = three(|i| spin[i] + back(&r[i]) * scale);
        let (c, d) = (self.in_body(c), below);
        let [w, x, y, z] = *attitude;
        let turned = [
            (w * d - (x * c[0] + y * c[1] + z * c[2])) * over,
            (x * d + (w * c[0] + (y * c[2] - z * c[1]))) * over,
            (y * d + (w * c[1] + (z * c[0] - x * c[2]))) * over,
            (z * d + (w * c[2] + (x * c[1] - y * c[0]))) * over,
        ];
        end(turned, &v, [turn, length, over])
    }

    #[inline(always)]
    fn in_body(&self, v: Triple) -> Triple {
        let Some([w, x, y, z]) = self.frame else { return v };
        let cross = |[a, b, c]: Triple| [y * c - z * b, z * a - x * c, x * b - y * a];
        let across = cross(v);
        let across = three(|i| across[i] + across[i]);
        let twice = cross(across);
        three(|i| v[i] + (w * across[i] + twice[i]))
    }
}

/// The square of a turn in which the gyroscopic term is below rounding.
fn steady([a, b, c]: &Triple) -> Real {
    (Real::EPSILON / 4.0) * (Real::EPSILON / 4.0) / a.max(*b).max(*c)
}

/// Where a part ends: attitude (w, x, y, z), spin, the squares of its turn and of the attitude's length,
/// and what the attitude was divided by.
type End = [Real; 10];

/// Whether the part is short enough, from an attitude of length 1, and all is finite.
#[inline(always)]
fn taken(&[_, _, _, _, a, b, c, turn, length, over]: &End) -> bool {
    turn <= LONGEST && (length - 1.0).abs() <= Real::EPSILON * 32.0 && (a + b + c + over).is_finite()
}

/// The square of the turn about this spin.
#[inline(always)]
fn turn_square([x, y, z]: &Triple, h: Real) -> Real {
    ((x * h) * (x * h) + (y * h) * (y * h)) + (z * h) * (z * h)
}

/// A turn about the spin, which stays: the end of a part that needs no gyroscopic term.
#[inline(always)]
fn steady_turn(&[w, x, y, z]: &[Real; 4], omega: &Triple, h: Real) -> End {
    let (turn, length) = (turn_square(omega, h), square(&[w, x, y, z]));
    let series = 1.0 / 12.0 + turn * (1.0 / 120.0 + turn * (17.0 / 20160.0));
    let half = (1.0 + turn * series) * (h / 2.0);
    let [a, b, c] = three(|i| omega[i] * half);
    let over = 1.0 / (((1.0 + a * a) + (b * b + c * c)) * length).sqrt();
    let turned = [
        (w - (a * x + b * y + c * z)) * over,
        (x + (a * w + (b * z - c * y))) * over,
        (y + (b * w + (c * x - a * z))) * over,
        (z + (c * w + (a * y - b * x))) * over,
    ];
    end(turned, omega, [turn, length, over])
}

#[inline(always)]
fn end([w, x, y, z]: [Real; 4], [a, b, c]: &Triple, [turn, length, over]: Triple) -> End {
    [w, x, y, z, *a, *b, *c, turn, length, over]
}

/// The number of bodies that go side by side, and what is read of them.
const LANES: usize = 8;
type Rows = [[Real; LANES]; 29];

/// The [step](PositionStage::step) of `h` seconds of many bodies, eight at once in vector registers, with the
/// bits that each has alone. `read` gives a body's stage, attitude and spin; `write` gets those at the end,
/// and the number of parts. They are called in no order; no body may be named twice.
#[allow(dead_code, reason = "an engine may step its bodies one by one")]
pub fn step_all<A: ?Sized, I: Copy>(
    all: &mut A,
    bodies: impl IntoIterator<Item = I>,
    h: Real,
    read: impl Fn(&A, I) -> (&PositionStage, [Real; 4], Triple),
    mut write: impl FnMut(&mut A, I, [Real; 4], Triple, u32),
) {
    // Those with principal axes of their own wait for each other, and the rest.
    let mut kinds: [(Rows, [Option<I>; LANES], usize); 2] = [([[0.0; LANES]; 29], [None; LANES], 0); 2];
    for body in bodies {
        let (stage, mut q, mut w) = read(all, body);
        if turn_square(&w, h) <= stage.steady {
            let parts = stage.step(&mut q, &mut w, h);
            write(all, body, q, w, parts);
            continue;
        }
        let framed = stage.frame.is_some();
        let (rows, waiting, count) = &mut kinds[usize::from(framed)];
        fill(rows, *count, stage, &q, &w);
        waiting[*count] = Some(body);
        *count += 1;
        if *count == LANES {
            *count = 0;
            let ends = if framed { ends::<true> } else { ends::<false> }(rows, h);
            for (k, body) in waiting.iter_mut().enumerate() {
                let Some(body) = body.take() else { continue };
                let at = |i: usize| ends[i][k];
                let (q, w) = ([at(0), at(1), at(2), at(3)], three(|i| at(4 + i)));
                let is_taken = taken(&end(q, &w, three(|i| at(7 + i))));
                let (q, w, parts) = if is_taken { (q, w, 1) } else { alone(read(all, body), h) };
                write(all, body, q, w, parts);
            }
        }
    }
    for body in kinds.into_iter().flat_map(|(_, waiting, _)| waiting).flatten() {
        let (q, w, parts) = alone(read(all, body), h);
        write(all, body, q, w, parts);
    }
}

#[inline(never)]
fn alone((stage, mut q, mut w): (&PositionStage, [Real; 4], Triple), h: Real) -> ([Real; 4], Triple, u32) {
    let parts = stage.step(&mut q, &mut w, h);
    (q, w, parts)
}

#[inline(always)]
fn fill(rows: &mut Rows, k: usize, stage: &PositionStage, q: &[Real; 4], w: &Triple) {
    let mut put = |from: usize, numbers: &[Real]| {
        for (i, x) in numbers.iter().enumerate() {
            rows[from + i][k] = *x;
        }
    };
    put(0, q);
    put(4, w);
    put(7, &stage.coupling);
    put(10, &stage.relative);
    put(13, &stage.twist);
    put(16, &stage.twist_2);
    put(22, &stage.bound);
    if let Some(frame) = &stage.frame {
        put(25, frame);
    }
}

/// The ends of eight bodies, by rows. Its loop is what the compiler makes vectors of.
#[inline(never)]
fn ends<const FRAMED: bool>(rows: &Rows, h: Real) -> [[Real; LANES]; 10] {
    let mut ends = [[0.0; LANES]; 10];
    for k in 0..LANES {
        let row = |i: usize| rows[i][k];
        let at = |n: usize| three(|i| row(n + i));
        let four = |n: usize| [row(n), row(n + 1), row(n + 2), row(n + 3)];
        let twist_2 = [row(16), row(17), row(18), row(19), row(20), row(21)];
        let frame = if FRAMED { Some(four(25)) } else { None };
        let (coupling, relative, twist, bound) = (at(7), at(10), at(13), at(22));
        let stage = PositionStage { coupling, relative, twist, twist_2, bound, steady: 0.0, frame };
        let end = stage.turn(&four(0), &at(4), h);
        for (row, x) in ends.iter_mut().zip(end) {
            row[k] = x;
        }
    }
    ends
}

#[inline(always)]
fn three(mut of: impl FnMut(usize) -> Real) -> Triple {
    [of(0), of(1), of(2)]
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
