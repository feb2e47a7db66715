//! Short spans: the variational equations by power series in time and Gauss quadrature.
//!
//! The closed form's derivatives are small differences where little of the motion has passed. Here nothing
//! cancels: the series of the spin `w`, of its derivative `F` by the spin at the start and of the attitude
//! `R` begin with given values. The rest are integrals of products of these: of the turn, in the world, `T =
//! int R F`; of the spin by the tensor `D = F y` with `y = int F^-1 f`, where `f` is the derivative of the
//! angular acceleration by the tensor at a fixed spin; and of the turn by the tensor, at the end `t`, `int R
//! D = int (T(t) - T) F^-1 f`. The flow keeps volumes, so that `F^-1` is the adjugate of `F`.

use super::{ByTensor, Derivatives, SpinDerivatives};
use crate::number::quadrature::{NODE_COUNT, NODES, REMAINING, WEIGHTS};
use nalgebra::{Matrix3, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Terms of the longest series.
const TERMS: usize = 36;
/// The longest step, in radians of Jacobi's argument, or of the angle turned where the attitude is needed.
const STEP: [f64; 2] = [0.5, 0.5];
/// Relative to derivatives of size 1, terms that are left out.
const NEGLIGIBLE: f64 = 1e-17;
/// How far the nearest singularity of the motion is, in radians of Jacobi's argument.
const RADIUS: f64 = 1.5;

/// The factors `(I_B - I_C)/I_A` of Euler's equations.
pub(super) fn factors(moments: &[f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|a| (moments[(a + 1) % 3] - moments[(a + 2) % 3]) / moments[a])
}

/// By how much the other two moments exceed that about axis `c`: of a needle, the difference of the large
/// ones comes first.
pub(super) fn triangle_excess(moments: &[f64; 3], c: usize) -> f64 {
    let (a, b) = (moments[(c + 1) % 3], moments[(c + 2) % 3]);
    (a.max(b) - moments[c]) + a.min(b)
}

/// A bound of the rate of Jacobi's argument.
pub(super) fn argument_rate(moments: &[f64; 3], omega: &[f64; 3]) -> f64 {
    let factors = factors(moments);
    let square = |c: usize| {
        let (a, b) = ((c + 1) % 3, (c + 2) % 3);
        (factors[a] * factors[b]).abs() * omega[c] * omega[c]
    };
    (square(0) + square(1) + square(2)).sqrt()
}

/// The derivative of the angular acceleration by the tensor at a fixed spin, `I^-1 (dI w x w - dI w')`.
pub(super) struct Forcing {
    pub(super) by_moments: [[f64; 3]; 3],
    /// `(I_A + I_B - I_C)/(I_A I_B)` for the product of inertia of the two axes other than `C`.
    by_products: [f64; 3],
    inverse: [f64; 3],
}

impl Forcing {
    pub(super) fn new(moments: &[f64; 3]) -> Self {
        let (factors, inverse) = (factors(moments), moments.map(|i| 1.0 / i));
        let mut by_moments = [[0.0; 3]; 3];
        for a in 0..3 {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            by_moments[a][a] = -factors[a] * inverse[a];
            (by_moments[a][b], by_moments[a][c]) = (inverse[a], -inverse[a]);
        }
        let by_products =
            [0, 1, 2].map(|c| triangle_excess(moments, c) * inverse[(c + 1) % 3] * inverse[(c + 2) % 3]);
        Self { by_moments, by_products, inverse }
    }

    pub(super) fn at(&self, w: &[f64; 3]) -> ByTensor {
        let mut forcing = ByTensor::zeros();
        for c in 0..3 {
            let (a, b) = ((c + 1) % 3, (c + 2) % 3);
            for column in 0..3 {
                forcing[(c, column)] = self.by_moments[c][column] * w[a] * w[b];
            }
            forcing[(a, 3 + c)] = self.by_products[c] * w[a] * w[c];
            forcing[(b, 3 + c)] = -self.by_products[c] * w[b] * w[c];
            forcing[(c, 3 + c)] = self.inverse[c] * (w[b] - w[a]) * (w[b] + w[a]);
        }
        forcing
    }
}

/// What is requested beyond the derivative of the spin by the spin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Request {
    pub(super) attitude: bool,
    pub(super) tensor: bool,
}

/// Three columns of the derivative by the spin at the start, and the spin.
type Row = [f64; 4];

/// Coefficients in powers of the share of the step that has passed.
struct Series {
    order: usize,
    /// Of the three components.
    rows: [[Row; 3]; TERMS + 1],
    /// Of the attitude's quaternion, real part first.
    attitude: [Row; TERMS + 1],
}

/// The spin at the end of `time`, and the derivatives over it, in which the motion runs through `argument`
/// radians of Jacobi's argument and through `angle` radians. What is not requested is zero.
pub(super) fn span(
    moments: &[f64; 3],
    omega: &[f64; 3],
    time: f64,
    [argument, angle]: [f64; 2],
    request: Request,
) -> ([f64; 3], Derivatives) {
    let angle = if request.attitude { angle.abs() } else { 0.0 };
    let steps = (argument.abs() / STEP[0]).max(angle / STEP[1]).ceil().max(1.0);
    let h = time / steps;
    let order = order([argument.abs() / steps, angle / steps]);
    let (factors, forcing) = (factors(moments), Forcing::new(moments));
    let mut sums = Sums { start: *omega, ..Sums::default() };
    let mut rows = [0, 1, 2].map(|a| [0, 1, 2, 3].map(|k| if k == 3 { omega[a] } else { f64::from(a == k) }));
    let mut attitude = if request.attitude { [1.0, 0.0, 0.0, 0.0] } else { [0.0; 4] };
    // Filled with anything but zeros, which would be written byte by byte.
    let mut series = Series { order, rows: [rows; TERMS + 1], attitude: [attitude; TERMS + 1] };
    let mut done = 0.0;
    while done < steps {
        series.expand(rows, attitude, &factors, h, order, request.attitude);
        if request.attitude || request.tensor {
            sums.add(&series, &forcing, h, request);
        }
        (rows, attitude) = series.at(1.0, request.attitude);
        done += 1.0;
    }
    let (spin, rotation) = (matrix(&rows), rotation(&attitude));
    let (back, tensor) = (rotation.transpose(), request.tensor);
    let by_tensor = if tensor { spin * sums.inverse_forced } else { ByTensor::zeros() };
    let derivatives = Derivatives {
        back,
        turn: back * sums.turn,
        turn_by_tensor: if tensor { back * sums.turn_by_tensor } else { ByTensor::zeros() },
        spin: SpinDerivatives { spin, by_tensor, energy: sums.energy },
    };
    (rows.map(|row| row[3]), derivatives)
}

/// As many terms as reach rounding: of a function that is singular at [`RADIUS`], times one that is entire.
fn order([argument, angle]: [f64; 2]) -> usize {
    let (mut singular, mut entire, mut n) = (1.0, 1.0, 0);
    while n < TERMS && (singular + entire) * (n as f64 + 1.0) > 1e-18 {
        n += 1;
        singular *= argument / RADIUS;
        entire *= angle / n as f64;
    }
    // Where the motion is slow, its first terms are not of its own rate.
    (n + 3).min(TERMS)
}

impl Series {
    /// Euler's equations, their derivative `F' = k (F w + w F)`, and `q' = q w/2`, from these values on.
    fn expand(
        &mut self,
        rows: [Row; 3],
        attitude: Row,
        factors: &[f64; 3],
        h: f64,
        longest: usize,
        turning: bool,
    ) {
        (self.order, self.rows[0], self.attitude[0]) = (longest, rows, attitude);
        let mut least = f64::INFINITY;
        for n in 0..longest {
            let part = h / (n + 1) as f64;
            let mut largest = self.advance(n, factors, part);
            if turning {
                largest = largest.max(self.turn(n, 0.5 * part));
            }
            // Two in a row, since every other term may vanish.
            if largest.max(least) < NEGLIGIBLE {
                self.order = n + 1;
                break;
            }
            least = largest;
        }
    }

    /// The next term of the spin and of its derivative; gives the size of the latter.
    fn advance(&mut self, n: usize, factors: &[f64; 3], part: f64) -> f64 {
        let (mut x, mut y, mut z) = ([0.0; 4], [0.0; 4], [0.0; 4]);
        // (C44)
        for (before, after) in self.rows[..=n].iter().zip(self.rows[..=n].iter().rev()) {
            let [a, b, c] = [before[0][3], before[1][3], before[2][3]];
            for k in 0..4 {
                x[k] += b * after[2][k] + c * after[1][k];
                y[k] += c * after[0][k] + a * after[2][k];
                z[k] += a * after[1][k] + b * after[0][k];
            }
        }
        let mut largest = 0.0_f64;
        for (a, sum) in [x, y, z].into_iter().enumerate() {
            let factor = part * factors[a];
            let row = [factor * sum[0], factor * sum[1], factor * sum[2], factor * (0.5 * sum[3])];
            largest = largest.max(row[0].abs()).max(row[1].abs()).max(row[2].abs());
            self.rows[n + 1][a] = row;
        }
        largest
    }

    /// The next term of the attitude; gives its size.
    fn turn(&mut self, n: usize, half: f64) -> f64 {
        let (mut x, mut y, mut z) = ([0.0; 4], [0.0; 4], [0.0; 4]);
        for (rows, q) in self.rows[..=n].iter().zip(self.attitude[..=n].iter().rev()) {
            for k in 0..4 {
                x[k] += rows[0][3] * q[k];
                y[k] += rows[1][3] * q[k];
                z[k] += rows[2][3] * q[k];
            }
        }
        let next = [
            -half * (x[1] + y[2] + z[3]),
            half * (x[0] + z[2] - y[3]),
            half * (y[0] - z[1] + x[3]),
            half * (z[0] + y[1] - x[2]),
        ];
        self.attitude[n + 1] = next;
        next.iter().fold(0.0, |largest, x| x.abs().max(largest))
    }

    /// The spin less that at the start of the step.
    fn gained(&self, share: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for rows in self.rows[1..=self.order].iter().rev() {
            sum = [0, 1, 2].map(|a| (sum[a] + rows[a][3]) * share);
        }
        sum
    }

    /// Smallest terms first.
    fn at(&self, share: f64, attitude: bool) -> ([Row; 3], Row) {
        let mut rows = [[0.0; 4]; 3];
        for terms in self.rows[..=self.order].iter().rev() {
            for (row, term) in rows.iter_mut().zip(terms) {
                for k in 0..4 {
                    row[k] = row[k] * share + term[k];
                }
            }
        }
        let mut turned = [0.0; 4];
        for term in self.attitude[..=if attitude { self.order } else { 0 }].iter().rev() {
            for k in 0..4 {
                turned[k] = turned[k] * share + term[k];
            }
        }
        (rows, turned)
    }
}

fn matrix(rows: &[Row; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|a, k| rows[a][k])
}

fn rotation(&[w, x, y, z]: &Row) -> Matrix3<f64> {
    let [xx, yy, zz] = [x * x, y * y, z * z];
    // By columns.
    Matrix3::from([
        [1.0 - 2.0 * (yy + zz), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
        [2.0 * (x * y - w * z), 1.0 - 2.0 * (xx + zz), 2.0 * (y * z + w * x)],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (xx + yy)],
    ])
}

/// The integrals from the start.
#[derive(Default)]
struct Sums {
    start: [f64; 3],
    /// The spin less that at the start, with digits of its own.
    gained: [f64; 3],
    turn: Matrix3<f64>,
    inverse_forced: ByTensor,
    turn_by_tensor: ByTensor,
    energy: [f64; 6],
}

impl Sums {
    fn add(&mut self, series: &Series, forcing: &Forcing, h: f64, request: Request) {
        let nodes: [_; NODE_COUNT] =
            core::array::from_fn(|j| series.at(0.5 + 0.5 * NODES[j], request.attitude));
        let turning: [_; NODE_COUNT] = core::array::from_fn(|j| {
            let (rows, attitude) = &nodes[j];
            if request.attitude { rotation(attitude) * matrix(rows) } else { Matrix3::zeros() }
        });
        let turn = weighted(&turning, &WEIGHTS) * h;
        self.turn += turn;
        if request.tensor {
            self.turn_by_tensor += turn * self.inverse_forced;
            for (j, (rows, _)) in nodes.iter().enumerate() {
                let (w, weight) = (rows.map(|row| row[3]), h * WEIGHTS[j]);
                let forced = adjugate(rows) * forcing.at(&w) * weight;
                self.inverse_forced += forced;
                if request.attitude {
                    self.turn_by_tensor += weighted(&turning, &REMAINING[j]) * h * forced;
                }
                let gained = series.gained(0.5 + 0.5 * NODES[j]);
                let gained = [0, 1, 2].map(|c| self.gained[c] + gained[c]);
                for c in 0..3 {
                    let (a, b) = ((c + 1) % 3, (c + 2) % 3);
                    self.energy[c] += weight * gained[c] * (w[c] + self.start[c]);
                    self.energy[3 + c] += 2.0 * weight * (gained[a] * w[b] + self.start[a] * gained[b]);
                }
            }
        }
        let gained = series.gained(1.0);
        self.gained = [0, 1, 2].map(|c| self.gained[c] + gained[c]);
    }
}

fn weighted(terms: &[Matrix3<f64>; NODE_COUNT], weights: &[f64; NODE_COUNT]) -> Matrix3<f64> {
    terms.iter().zip(weights).fold(Matrix3::zeros(), |sum, (term, weight)| sum + term * *weight)
}

/// Of a matrix with determinant 1 its inverse.
fn adjugate(rows: &[Row; 3]) -> Matrix3<f64> {
    let [x, y, z] = rows.map(|[x, y, z, _]| Vector3::new(x, y, z));
    Matrix3::from_columns(&[y.cross(&z), z.cross(&x), x.cross(&y)])
}

#[cfg(test)]
mod tests {
    use super::{NEGLIGIBLE, RADIUS, STEP, TERMS};
    use crate::exact::elliptic::quarter_period;

    /// Jacobi's functions are singular at `i K'`, and `K'` is never below a quarter of the circle.
    #[test]
    fn the_terms_reach_rounding_within_the_nearest_singularity() {
        let least = (0..=100).map(|n| quarter_period(f64::from(n) / 100.0)).fold(f64::INFINITY, f64::min);
        assert!(RADIUS < least && least < 1.05 * RADIUS);
        assert!((STEP[0] / RADIUS).powi(TERMS as i32) < f64::EPSILON / 8.0);
        let entire = (1..=TERMS).map(|n| STEP[1] / n as f64).product::<f64>();
        assert!(entire < NEGLIGIBLE && NEGLIGIBLE < f64::EPSILON / 8.0);
    }
}
