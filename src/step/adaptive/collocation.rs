//! Steps by collocation at Radau's nodes, for damping that is far faster than the motion. The damping is
//! solved for exactly; all other terms are iterated.
//!
//! The weights integrate the polynomial through the values at the nodes ([HW96](crate::references), IV.5).

use super::{Run, TRIES, largest, logarithm, ratio};
use crate::body::{Rate, State};
use crate::error::Error;
use crate::number::functions::{exp, sin_cos};
use crate::number::quadrature::legendre;
use crate::step::methods::implicit::eliminate;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::{Quaternion, Vector3, Vector4};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The number of iterations for the states at the nodes before a shorter step is tried.
const ROUNDS: usize = 40;

/// A step costs about as much as this number of steps by series, so a shorter step is not worth it.
const DEARER: f64 = 10.0;

/// Where damping over a step is below this, it is iterated with the other terms.
const SLOW: f64 = 0.1;

/// The polynomial of the last step: its states at the nodes.
#[derive(Debug, Clone)]
pub(super) struct Collocation {
    radau: Radau,
    /// The decay rates of the momentum's components by damping, 1/s.
    decay: Vector3<f64>,
    states: Vec<State<f64>>,
    rates: Vec<Rate<f64>>,
    /// The last step, s.
    length: f64,
    /// The next, s.
    next: f64,
}

/// The weights from which the states at the nodes are computed: for each component of the momentum, with the
/// damping that is solved for, and for the attitude.
struct Weights {
    /// The decay rate that is solved for, 1/s; zero where the damping is iterated.
    decay: [f64; 3],
    /// The fraction of the start's momentum that remains at each node.
    left: Vec<[f64; 3]>,
    /// For each node, the weights of the rates at all nodes, s.
    rates: Vec<[f64; 4]>,
}

impl Weights {
    fn new(radau: &Radau, decay: &Vector3<f64>, h: f64) -> Self {
        let count = radau.nodes.len();
        let mut weights = Self {
            decay: [0.0; 3],
            left: vec![[1.0; 3]; count],
            rates: radau.integrals.iter().flat_map(|row| &row[..count]).map(|w| [w * h; 4]).collect(),
        };
        for axis in 0..3 {
            let rate = decay[axis].abs() * h;
            if rate < SLOW {
                continue;
            }
            weights.decay[axis] = decay[axis];
            let integrals = radau.decaying(rate);
            for (left, row) in weights.left.iter_mut().zip(&integrals) {
                left[axis] = 1.0 - rate * row[..count].iter().sum::<f64>();
            }
            for (weight, w) in weights.rates.iter_mut().zip(integrals.iter().flat_map(|row| &row[..count])) {
                weight[axis] = w * h;
            }
        }
        weights
    }

    /// The state at a node, from the rates at all nodes.
    fn state(&self, start: &State<f64>, node: usize, rates: &[Rate<f64>]) -> State<f64> {
        let mut momentum: [f64; 3] = core::array::from_fn(|i| start.momentum[i] * self.left[node][i]);
        let mut attitude: [f64; 4] = start.attitude.coords.into();
        for (weight, rate) in self.rates[node * rates.len()..].iter().zip(rates) {
            for i in 0..3 {
                momentum[i] += weight[i] * rate.momentum[i];
            }
            for (sum, rate) in attitude.iter_mut().zip(&rate.attitude.coords) {
                *sum += weight[3] * *rate;
            }
        }
        State { attitude: Quaternion::from_vector(attitude.into()), momentum: momentum.into() }
    }
}

impl Collocation {
    /// Continues from the state of a run, with a first step twice as long as the run's last.
    pub(super) fn new(run: &Run) -> Self {
        let radau = Radau::new(nodes(run.tolerance));
        let decay = run.system.sum.damping.component_mul(&run.system.inverse);
        let rate = run.system.rate_after(&run.state, &run.time);
        let (states, rates) = (vec![run.state; radau.nodes.len()], vec![rate; radau.nodes.len()]);
        Self { radau, decay, states, rates, length: run.last, next: 2.0 * run.last }
    }

    /// Takes one step, with shorter tries until its error is within the tolerance (or 32 `f64::EPSILON`, if
    /// that is more).
    pub(super) fn advance(&mut self, run: &mut Run) -> Result<(), Error> {
        let order = self.radau.nodes.len() as f64 + 1.0;
        let tolerance = run.tolerance.max(32.0 * f64::EPSILON);
        for _ in 0..TRIES {
            let (h, next) = run.fitted(self.next)?;
            let error = if self.solve(run, h) { self.error(run) } else { f64::NAN };
            let mut end = self.states[0];
            let error = largest(&[error, run.settle(&mut end)]) / tolerance;
            // As usual: aim a little below the tolerance, and keep the change of the step within bounds.
            let factor = exp(-logarithm(2.0 * error) / order).clamp(0.2, 4.0);
            self.next = h * if error.is_nan() { 0.25 } else { factor };
            if error <= 1.0 {
                self.length = h;
                run.count_stiffness(largest(self.decay.as_slice()) * h / DEARER);
                run.take(end, h, next);
                return Ok(());
            }
            run.rejected += 1;
        }
        Err(run.no_step(self.next))
    }

    /// The states at the nodes of a step of `h` seconds; whether they were found.
    fn solve(&mut self, run: &Run, h: f64) -> bool {
        let (start, (system, time)) = (run.state, run.now());
        let weights = Weights::new(&self.radau, &self.decay, h);
        self.states.fill(start);
        let unit = largest(start.momentum.as_slice()).max(f64::MIN_POSITIVE / run.tolerance);
        let goal = 0.01 * run.tolerance;
        // The changes of the last two iterations, latest first: attitude and momentum may change in turns.
        let mut before = [0.0; 2];
        for round in 0..ROUNDS {
            for ((rate, state), node) in self.rates.iter_mut().zip(&self.states).zip(&self.radau.nodes) {
                *rate = system.rate_after(state, &(time + node * h));
                for (i, decay) in weights.decay.iter().enumerate() {
                    rate.momentum[i] += *decay * state.momentum[i];
                }
            }
            let mut moved: f64 = 0.0;
            for node in 0..self.states.len() {
                let state = weights.state(&start, node, &self.rates);
                let off = self.states[node];
                let turned = largest((state.attitude.coords - off.attitude.coords).as_slice());
                let pushed = largest((state.momentum - off.momentum).as_slice());
                moved = largest(&[moved, turned, pushed / unit]);
                self.states[node] = state;
            }
            // The contraction over two iterations bounds the remaining changes.
            let share = ratio(moved, before[1]).min(0.9);
            if moved <= 4.0 * f64::EPSILON || (moved + before[0]) * share <= (1.0 - share) * goal {
                return true;
            }
            if moved.is_nan() || (round > 3 && moved > before[1]) {
                return false;
            }
            before = [moved, before[0]];
        }
        false
    }

    /// The error of the polynomial, estimated from the decrease of its last Legendre coefficients.
    fn error(&self, run: &Run) -> f64 {
        let unit = largest(run.state.momentum.as_slice())
            .max(largest(self.states[0].momentum.as_slice()))
            .max(f64::MIN_POSITIVE / run.tolerance);
        let size = |order: usize| {
            let row = || self.radau.coefficients[order].iter().zip(&self.states);
            let attitude: Vector4<f64> = row().map(|(c, state)| state.attitude.coords * *c).sum();
            let momentum: Vector3<f64> = row().map(|(c, state)| state.momentum * *c).sum();
            largest(&[largest(attitude.as_slice()), largest(momentum.as_slice()) / unit])
        };
        let count = self.radau.nodes.len();
        let [most, before] = [count - 1, count - 3].map(|order| largest(&[size(order), size(order - 1)]));
        // Two orders each, since one can be small by chance; the first omitted order is three higher.
        let fall = ratio(most, before).min(1.0);
        most * fall * fall.sqrt()
    }

    /// The state `time` seconds after the start of the last step, where the body was in the state `start`.
    pub(super) fn within(&self, run: &Run, start: &State<f64>, time: f64) -> State<f64> {
        let (first, others) = self.radau.shares(time / self.length);
        let mut there = *start;
        there.attitude.coords *= first;
        there.momentum *= first;
        for (share, state) in others.iter().zip(&self.states) {
            there.attitude.coords += state.attitude.coords * *share;
            there.momentum += state.momentum * *share;
        }
        run.project(&mut there);
        there
    }
}

/// The number of nodes that needs the fewest operations for this tolerance of a step.
fn nodes(tolerance: f64) -> usize {
    let digits = -logarithm(tolerance) / core::f64::consts::LN_10;
    ((3.0 + 0.8 * digits) as usize).clamp(4, MOST)
}

/// The largest number of nodes.
const MOST: usize = 16;

/// A row of a matrix, or a value for each node. With fewer nodes only the first entries are used.
type Row = [f64; MOST];

/// Polynomials on the interval from 0 to 1, given by their values at Radau's nodes.
#[derive(Debug, Clone)]
struct Radau {
    /// The nodes, from the last, which is 1, down to the first.
    nodes: Vec<f64>,
    /// Row `k` times the values: the coefficient of Legendre's polynomial `k`.
    coefficients: Vec<Row>,
    /// Row `i` times the values: the integral from 0 to node `i`.
    integrals: Vec<Row>,
}

impl Radau {
    /// With this number of nodes, from 2 to the largest.
    fn new(count: usize) -> Self {
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

    /// The weights of the values for the integral from 0 to a fraction of the interval.
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

    /// The weights of the values at 0 and at the nodes for the value at a fraction of the interval, by the
    /// polynomial through all of them.
    fn shares(&self, share: f64) -> (f64, Row) {
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

    /// The integrals `A` for a result that decays at this rate: `(1 + rate A)^-1 A`, by elimination.
    fn decaying(&self, rate: f64) -> Vec<Row> {
        let row = |(i, integrals): (usize, &Row)| {
            let left = |j: usize| rate * integrals[j] + if i == j { 1.0 } else { 0.0 };
            core::array::from_fn(|j| if j < MOST { left(j) } else { integrals[j - MOST] })
        };
        let mut rows: Vec<[f64; 2 * MOST]> = self.integrals.iter().enumerate().map(row).collect();
        eliminate(&mut rows, self.nodes.len());
        rows.iter().map(|row| core::array::from_fn(|j| row[MOST + j])).collect()
    }
}

/// The root `i`, counted down from the root 1, of the difference of Legendre's polynomials of orders `count`
/// and `count - 1`, by Newton's method from a root of Chebyshev's.
fn node(count: usize, i: usize) -> f64 {
    if i == 0 {
        return 1.0;
    }
    let n = count as f64;
    let (_, mut x) = sin_cos(core::f64::consts::TAU * i as f64 / (2.0 * n - 1.0));
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
