//! Radau's nodes, and what integrates a polynomial that is given at them ([HW96](crate::references), IV.5).

use crate::number::Analytic;
use crate::number::quadrature::legendre;
use crate::step::methods::implicit::eliminate;
use alloc::vec;
use alloc::vec::Vec;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The largest number of nodes.
pub(super) const MOST: usize = 16;

/// A row of a matrix, or a value for each node; of fewer nodes, the first ones.
type Row = [f64; MOST];

/// Polynomials on the interval from 0 to 1, given by their values at Radau's nodes.
#[derive(Debug, Clone)]
pub(super) struct Radau {
    /// The nodes, from the last, which is 1, down to the first.
    pub(super) nodes: Vec<f64>,
    /// Row `k` times the values: the coefficient of Legendre's polynomial `k`.
    pub(super) coefficients: Vec<Row>,
    /// Row `i` times the values: the integral from 0 to node `i`.
    pub(super) integrals: Vec<Row>,
}

impl Radau {
    /// With this number of nodes, from 2 to the largest.
    pub(super) fn new(count: usize) -> Self {
        let count = count.clamp(2, MOST);
        let order = count as f64;
        let ends: Vec<f64> = (0..count).map(|i| node(count, i)).collect();
        let mut coefficients = vec![[0.0; MOST]; count];
        for (j, &x) in ends.iter().enumerate() {
            let at: [f64; MOST + 1] = legendre(x);
            let value = order * at[count - 1];
            let weight = if j == 0 { 2.0 / (order * order) } else { (1.0 + x) / (value * value) };
            for (k, row) in coefficients.iter_mut().enumerate() {
                row[j] = (k as f64 + 0.5) * weight * at[k];
            }
        }
        let nodes = ends.iter().map(|x| 0.5 * (x + 1.0)).collect();
        let mut radau = Self { nodes, coefficients, integrals: Vec::new() };
        radau.integrals = radau.nodes.iter().map(|&share| radau.integral(share)).collect();
        radau
    }

    /// What the values are multiplied by for the integral from 0 to a share of the interval.
    fn integral(&self, share: f64) -> Row {
        let x = 2.0 * share - 1.0;
        let at: [f64; MOST + 1] = legendre(x);
        let mut sum = [0.0; MOST];
        for (k, row) in self.coefficients.iter().enumerate() {
            let below = if k == 0 { -1.0 } else { at[k - 1] };
            let area = 0.5 * (at[k + 1] - below) / (2 * k + 1) as f64;
            for (sum, c) in sum.iter_mut().zip(row) {
                *sum += area * c;
            }
        }
        sum
    }

    /// What the values at 0 and at the nodes are multiplied by for the value at a share of the interval, by
    /// the polynomial through all of them.
    pub(super) fn shares(&self, share: f64) -> (f64, Row) {
        let product = |place: f64, own: usize| {
            let others = self.nodes.iter().enumerate().filter(|(j, _)| *j != own);
            others.map(|(_, node)| (share - node) / (place - node)).product::<f64>()
        };
        let mut row = [0.0; MOST];
        for (j, (weight, &node)) in row.iter_mut().zip(&self.nodes).enumerate() {
            *weight = share / node * product(node, j);
        }
        (product(0.0, self.nodes.len()), row)
    }

    /// The integrals `A`, with a decay of the result at this rate: `(1 + rate A)^-1 A`, by elimination.
    pub(super) fn decaying(&self, rate: f64) -> Vec<Row> {
        let row = |(i, integrals): (usize, &Row)| {
            let left = |j: usize| rate * integrals[j] + if i == j { 1.0 } else { 0.0 };
            core::array::from_fn(|j| if j < MOST { left(j) } else { integrals[j - MOST] })
        };
        let mut rows: Vec<[f64; 2 * MOST]> = self.integrals.iter().enumerate().map(row).collect();
        eliminate(&mut rows, self.nodes.len());
        rows.iter().map(|row| core::array::from_fn(|j| row[MOST + j])).collect()
    }
}

/// The root `i` of the difference of Legendre's polynomials of orders `count` and `count - 1`, down from the
/// root 1, by Newton's rule from Chebyshev's.
fn node(count: usize, i: usize) -> f64 {
    if i == 0 {
        return 1.0;
    }
    let n = count as f64;
    let (_, mut x) = Analytic::sin_cos(&(core::f64::consts::TAU * i as f64 / (2.0 * n - 1.0)));
    for _ in 0..5 {
        let at: [f64; MOST + 1] = legendre(x);
        let [before, one, two] = [at[count - 2], at[count - 1], at[count]];
        // `(x² - 1) P' = n (x P - P_before)`.
        let derivative = n * (x * two - one) - (n - 1.0) * (x * one - before);
        x -= (two - one) * (x * x - 1.0) / derivative;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nodes_are_those_of_radau_iia_of_order_5() {
        let radau = Radau::new(3);
        let root = 6.0_f64.sqrt();
        for (node, expected) in radau.nodes.iter().zip([1.0, (4.0 + root) / 10.0, (4.0 - root) / 10.0]) {
            assert!((node - expected).abs() < 1e-15, "{node}");
        }
        let last = [1.0 / 9.0, (16.0 + root) / 36.0, (16.0 - root) / 36.0];
        for (weight, expected) in radau.integrals[0].iter().zip(last) {
            assert!((weight - expected).abs() < 1e-15, "{weight}");
        }
    }

    /// Up to the order `2 n - 2` at the end, and up to `n - 1` at all nodes.
    #[test]
    fn powers_are_integrated_to_rounding() {
        for count in 2..=16 {
            let radau = Radau::new(count);
            for power in 0..2 * count as i32 - 1 {
                let rows = if power < count as i32 { count } else { 1 };
                for (row, end) in radau.integrals[..rows].iter().zip(&radau.nodes) {
                    let sum: f64 = row.iter().zip(&radau.nodes).map(|(w, x)| w * x.powi(power)).sum();
                    let expected = end.powi(power + 1) / f64::from(power + 1);
                    assert!(
                        (sum - expected).abs() < 2.0 * count as f64 * f64::EPSILON,
                        "{count} nodes, power {power}: {sum}, {expected}"
                    );
                }
            }
        }
    }

    /// `u' = -k u + 3 t² + k t³`, whose solution from 0 on is `t³`.
    #[test]
    fn a_cubic_motion_against_a_decay_is_exact_at_every_node() {
        for rate in [0.5, 3.0, 1e3, 1e9] {
            let radau = Radau::new(12);
            for (row, end) in radau.decaying(rate).iter().zip(&radau.nodes) {
                let pulls = radau.nodes.iter().map(|t| 3.0 * t * t + rate * t * t * t);
                let sum: f64 = row.iter().zip(pulls).map(|(w, pull)| w * pull).sum();
                assert!((sum - end * end * end).abs() < 1e-13, "{rate}: {sum} at {end}");
            }
        }
    }
}
