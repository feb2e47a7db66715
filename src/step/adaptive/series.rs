//! The motion as power series in the time, by recurrences [JZ05](crate::references).
//!
//! Spin, attitude and world vectors in body axes are bilinear in each other: each coefficient is a sum of
//! products of those before. All of them are kept in rows of four numbers, which the compiler takes as
//! vectors: the spin is also at hand with its components moved round, so that a row of sums holds twelve
//! products of the attitude, or the six of a cross product, and is sorted out once for each coefficient.

use super::columns::Columns;
use super::law::Law;
use super::switching::signed;
use crate::attitude::rotate_inverse;
use crate::number::Analytic;
use nalgebra::{Quaternion, Vector3};

/// The largest order.
pub(super) const MOST: usize = 26;

type Four<T> = [T; 4];
type Rows<T> = [Four<T>; MOST + 1];
/// A vector, the same with its components moved up by one place and by two; the fourth repeats the first.
type Round<T> = [Four<T>; 3];

#[inline(always)]
fn add_product<T: Analytic + Copy>(sum: &mut Four<T>, a: &Four<T>, b: &Four<T>) {
    for i in 0..4 {
        sum[i] += a[i] * b[i];
    }
}

#[inline(always)]
fn round<T: Copy>([x, y, z]: [T; 3]) -> Round<T> {
    [[x, y, z, x], [y, z, x, y], [z, x, y, z]]
}

/// `a x b` of the products of `a` with `b` moved up by one place and by two.
#[inline(always)]
fn cross<T: Analytic + Copy>([one, two]: &[Four<T>; 2]) -> [T; 3] {
    [one[1] - two[2], one[2] - two[0], one[0] - two[1]]
}

/// The sums over `k` of the products of `a[k]` with `b[n - k]` moved up by one place and by two, with `n` the
/// last of both.
// Not inlined, as the next: the compiler keeps rows together that are stored together.
#[inline(never)]
fn round_sums<T: Analytic + Copy>(a: &[Four<T>], b: &[Round<T>]) -> [Four<T>; 2] {
    let (mut one, mut two) = ([T::zero(); 4], [T::zero(); 4]);
    for (a, b) in a.iter().zip(b.iter().rev()) {
        add_product(&mut one, a, &b[1]);
        add_product(&mut two, a, &b[2]);
    }
    [one, two]
}

/// The same with all three of `b`, and of the first of `b[k]` with the second of `b[n - k]`.
#[inline(never)]
fn attitude_sums<T: Analytic + Copy>(a: &[Four<T>], b: &[Round<T>]) -> [Four<T>; 4] {
    let [mut none, mut one, mut two, mut pairs] = [[T::zero(); 4]; 4];
    for ((a, front), b) in a.iter().zip(b).zip(b.iter().rev()) {
        add_product(&mut none, a, &b[0]);
        add_product(&mut one, a, &b[1]);
        add_product(&mut two, a, &b[2]);
        add_product(&mut pairs, &front[0], &b[1]);
    }
    [none, one, two, pairs]
}

/// The sums over `k` of `a[k] x b[n - k]`.
fn cross_sum<T: Analytic + Copy>(a: &[Four<T>], b: &[Round<T>]) -> [T; 3] {
    cross(&round_sums(a, b))
}

/// Coefficients of powers of the time in units.
#[derive(Debug, Clone)]
pub(super) struct Series<T: nalgebra::Scalar> {
    /// The highest power.
    pub(super) order: usize,
    /// The quaternion's vector part, then its scalar part.
    attitude: Rows<T>,
    spin: [Round<T>; MOST + 1],
    /// World vectors in body axes.
    world: [Rows<T>; 3],
    /// What the spin changes by without a torque, for dissipation: times the moments.
    coupling: [Round<T>; MOST + 1],
    /// And the momentum.
    momentum: Rows<T>,
    /// For the gravity gradient: the direction in body axes, alone and moved round, and how it turns.
    toward: Rows<T>,
    direction: [Round<T>; MOST + 1],
    turning: [Round<T>; MOST + 1],
    orbit: Rows<T>,
}

impl<T: Analytic + Copy> Series<T> {
    pub(super) fn new() -> Self {
        let rows = [[T::zero(); 4]; MOST + 1];
        let rounds = [[[T::zero(); 4]; 3]; MOST + 1];
        Self {
            order: 0,
            attitude: rows,
            spin: rounds,
            world: [rows; 3],
            coupling: rounds,
            momentum: rows,
            toward: rows,
            direction: rounds,
            turning: rounds,
            orbit: rows,
        }
    }

    /// The first coefficients: the state itself, its spin in units, and the gravity gradient's direction in
    /// world axes.
    pub(super) fn begin(
        &mut self,
        law: &Law<T>,
        attitude: &Quaternion<T>,
        spin: [T; 3],
        direction: Vector3<T>,
    ) {
        let in_body = |v: &Vector3<T>| -> [T; 3] { rotate_inverse(attitude, v).into() };
        let padded = |[x, y, z]: [T; 3]| [x, y, z, T::zero()];
        self.order = 0;
        let q = &attitude.coords;
        self.attitude[0] = [q.x, q.y, q.z, q.w];
        self.spin[0] = round(spin);
        for (rows, one) in self.world.iter_mut().zip(&law.world[..law.count]) {
            rows[0] = padded(in_body(&one.vector));
        }
        if let Some(gradient) = &law.gradient {
            let orbit = in_body(&gradient.orbit);
            self.orbit[0] = padded(orbit);
            self.direction[0] = round(in_body(&direction));
            self.toward[0] = self.direction[0][0];
            self.turning[0] = round([spin[0] - orbit[0], spin[1] - orbit[1], spin[2] - orbit[2]]);
        }
    }

    /// The next coefficient of everything.
    pub(super) fn extend(&mut self, law: &Law<T>) {
        let n = self.order;
        let over = T::one() / T::integer(n as u32 + 1);
        let (turn, pairs) = self.attitude_and_pairs();
        let half = over / T::integer(2);
        self.attitude[n + 1] = turn.map(|x| x * half);
        let mut free = [pairs[1], pairs[2], pairs[0]];
        if let Some(gradient) = &law.gradient {
            let tide = self.directions();
            free = core::array::from_fn(|i| free[i] - gradient.strength * tide[i]);
            self.extend_direction(over);
        }
        let mut rate: [T; 3] = core::array::from_fn(|i| law.coupling[i] * free[i]);
        if !law.dissipation.is_zero() {
            let lost = self.dissipated(law, &pairs);
            rate = core::array::from_fn(|i| rate[i] + lost[i]);
        }
        let here = self.spin[n][0];
        for i in 0..3 {
            rate[i] -= law.decay[i] * here[i];
        }
        if n == 0 {
            rate = core::array::from_fn(|i| rate[i] + law.constant[i]);
        }
        for (rows, one) in self.world.iter_mut().zip(&law.world[..law.count]) {
            let [x, y, z, _] = rows[n];
            let m = &one.acceleration;
            for i in 0..3 {
                rate[i] += m[(i, 0)] * x + m[(i, 1)] * y + m[(i, 2)] * z;
            }
            let [x, y, z] = cross_sum(&rows[..=n], &self.spin[..=n]).map(|x| x * over);
            rows[n + 1] = [x, y, z, T::zero()];
        }
        self.spin[n + 1] = round(rate.map(|x| x * over));
        if law.gradient.is_some() {
            let ([x, y, z, _], [u, v, w, _]) = (self.spin[n + 1][0], self.orbit[n + 1]);
            self.turning[n + 1] = round([x - u, y - v, z - w]);
        }
        self.order = n + 1;
    }

    /// Twice the rate of the attitude, and the products `w1 w2`, `w2 w3`, `w3 w1`.
    #[inline(always)]
    fn attitude_and_pairs(&self) -> (Four<T>, Four<T>) {
        let n = self.order;
        let [a, b, c, pairs] = attitude_sums(&self.attitude[..=n], &self.spin[..=n]);
        let turn = [a[3] + b[1] - c[2], b[3] + b[2] - c[0], c[3] + b[0] - c[1], -(a[0] + a[1] + a[2])];
        (turn, pairs)
    }

    /// The products `n2 n3`, `n3 n1`, `n1 n2` of the direction's components.
    fn directions(&self) -> [T; 3] {
        let n = self.order;
        let [pairs, _] = round_sums(&self.toward[..=n], &self.direction[..=n]);
        [pairs[1], pairs[2], pairs[0]]
    }

    fn extend_direction(&mut self, over: T) {
        let n = self.order;
        let across = cross_sum(&self.toward[..=n], &self.turning[..=n]);
        self.direction[n + 1] = round(across.map(|x| x * over));
        self.toward[n + 1] = self.direction[n + 1][0];
        let [x, y, z] = cross_sum(&self.orbit[..=n], &self.spin[..=n]).map(|x| x * over);
        self.orbit[n + 1] = [x, y, z, T::zero()];
    }

    /// The angular acceleration `J k L x (L x w)`.
    fn dissipated(&mut self, law: &Law<T>, pairs: &Four<T>) -> [T; 3] {
        let n = self.order;
        let m = &law.moments;
        let free = [pairs[1], pairs[2], pairs[0]];
        self.coupling[n] = round(core::array::from_fn(|i| m[i] * law.coupling[i] * free[i]));
        let w = &self.spin[n][0];
        self.momentum[n] = [m[0] * w[0], m[1] * w[1], m[2] * w[2], T::zero()];
        let across = cross_sum(&self.momentum[..=n], &self.coupling[..=n]);
        core::array::from_fn(|i| law.dissipation * across[i] / m[i])
    }

    /// The larger of the attitude's coefficient of this power, and the momentum's in units of `1 / weights`;
    /// or of their derivatives, if these are larger in sizes of their columns.
    #[inline(always)]
    pub(super) fn size(&self, power: usize, weights: &[f64; 3], columns: Option<&Columns<T>>) -> f64 {
        let spin = &self.spin[power][0];
        let momentum = [0, 1, 2].map(|i| spin[i].size() * weights[i]);
        let attitude = &self.attitude[power];
        let size = super::largest(&[super::largest(attitude), super::largest(&momentum)]);
        match columns {
            Some(columns) => super::largest(&[size, columns.share(attitude.iter().chain(&spin[..3]))]),
            None => size,
        }
    }

    /// The coefficients of a component of the spin.
    pub(super) fn spin(&self, axis: usize) -> [f64; MOST + 1] {
        core::array::from_fn(|power| signed(self.spin[power][0][axis % 3]))
    }

    /// What attitude (vector part first) and spin have changed by at `x` units of time.
    pub(super) fn value(&self, x: T) -> [Four<T>; 2] {
        let [mut q, mut w] = [[T::zero(); 4]; 2];
        let powers = 1..=self.order;
        for (attitude, spin) in self.attitude[powers.clone()].iter().zip(&self.spin[powers]).rev() {
            for i in 0..4 {
                q[i] = q[i] * x + attitude[i];
                w[i] = w[i] * x + spin[0][i];
            }
        }
        [q.map(|y| y * x), w.map(|y| y * x)]
    }

    /// What attitude (vector part first) and spin have changed by, and at which rate they change, at `x`
    /// units of time.
    #[inline]
    pub(super) fn at(&self, x: T) -> [Four<T>; 4] {
        let zero = [T::zero(); 4];
        let [mut q, mut w, mut dq, mut dw] = [zero; 4];
        let powers = 1..=self.order;
        for (attitude, spin) in self.attitude[powers.clone()].iter().zip(&self.spin[powers]).rev() {
            for i in 0..4 {
                dq[i] = dq[i] * x + q[i];
                dw[i] = dw[i] * x + w[i];
                q[i] = q[i] * x + attitude[i];
                w[i] = w[i] * x + spin[0][i];
            }
        }
        let rate = |value: &Four<T>, slope: &Four<T>| core::array::from_fn(|i| value[i] + slope[i] * x);
        [q.map(|y| y * x), w.map(|y| y * x), rate(&q, &dq), rate(&w, &dw)]
    }
}
