//! Short spans: the motion and its neighbours as power series in time.
//!
//! The closed form's derivatives are small differences where little of the motion has passed. Here nothing is: the series
//! start from the derivatives at the start, which are given, and the moments enter by their differences alone.

use super::Change;
use nalgebra::Vector3;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Terms of the longest series.
const TERMS: usize = 24;
/// The longest step, in radians of the fastest motion in question.
const STEP: f64 = 0.25;

/// The factors `(I_B - I_C)/I_A` of Euler's equations, and their derivatives by the three moments.
pub(super) struct Ratios {
    pub(super) factor: [f64; 3],
    pub(super) by_moments: [[f64; 3]; 3],
}

impl Ratios {
    pub(super) fn new(moments: &[f64; 3]) -> Self {
        let mut by_moments = [[0.0; 3]; 3];
        let factor = [0, 1, 2].map(|a| {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            let factor = (moments[b] - moments[c]) / moments[a];
            by_moments[a][a] = -factor / moments[a];
            by_moments[a][b] = 1.0 / moments[a];
            by_moments[a][c] = -1.0 / moments[a];
            factor
        });
        Self { factor, by_moments }
    }
}

/// The change, and that of the attitude as rotation vectors in body axes.
pub(super) struct Short {
    pub(super) change: Change,
    pub(super) turn: [Vector3<f64>; 6],
    /// The spin itself.
    pub(super) omega: [f64; 3],
}

/// Coefficients of three components in powers of the share of the step that has passed.
type Series = [[f64; TERMS + 1]; 3];

/// Over `time`, in which the fastest motion in question runs through `angle` radians.
pub(super) fn short(moments: &[f64; 3], omega: &[f64; 3], time: f64, angle: f64) -> Short {
    let ratios = Ratios::new(moments);
    let steps = (angle.abs() / STEP).ceil().max(1.0);
    let h = time / steps;
    let order = order(angle.abs() / steps);
    let mut w = *omega;
    let mut spin = [0, 1, 2, 3, 4, 5].map(|k| if k < 3 { unit(k) } else { [0.0; 3] });
    let mut turn = [[0.0; 3]; 6];
    let (mut squares, mut gained) = ([0.0; 3], [0.0; 3]);
    let mut done = 0.0;
    while done < steps {
        let motion = motion(&ratios, &w, h, order);
        for k in 0..3 {
            // Integral of the square less that at the step's start, then less that at the very start.
            let (mut excess, mut integral) = (0.0, 0.0);
            for n in (1..=order).rev() {
                let term: f64 = (0..=n).map(|j| motion[k][j] * motion[k][n - j]).sum();
                excess += term;
                integral += term / (n + 1) as f64;
            }
            squares[k] += h * (integral + gained[k]);
            gained[k] += excess;
        }
        for column in 0..6 {
            let forced =
                if column < 3 { [0.0; 3] } else { [0, 1, 2].map(|a| ratios.by_moments[a][column - 3]) };
            (spin[column], turn[column]) =
                step(&ratios, &forced, &motion, [&spin[column], &turn[column]], h, order);
        }
        w = total(&motion, order);
        done += 1.0;
    }
    Short { change: Change { spin: spin.map(Into::into), squares }, turn: turn.map(Into::into), omega: w }
}

/// As many terms as reach rounding: all is analytic to a quarter period of complex time, at least a quarter turn.
fn order(angle: f64) -> usize {
    let (mut left, mut n) = (1.0, 0);
    while n < TERMS && left * (n as f64 + 1.0) > 1e-18 {
        left *= angle / 1.5;
        n += 1;
    }
    // Where the motion is slow the first terms are not of its own rate: a change of the moments sets one component off,
    // and that the others.
    (n + 3).min(TERMS)
}

fn unit(k: usize) -> [f64; 3] {
    let mut vector = [0.0; 3];
    vector[k] = 1.0;
    vector
}

/// Smallest terms first.
fn total(series: &Series, order: usize) -> [f64; 3] {
    [0, 1, 2].map(|k| series[k][..=order].iter().rev().sum())
}

/// Of the product of two series, the term of power `n`.
fn product(a: &[f64; TERMS + 1], b: &[f64; TERMS + 1], n: usize) -> f64 {
    a[..=n].iter().zip(b[..=n].iter().rev()).map(|(x, y)| x * y).sum()
}

fn motion(ratios: &Ratios, omega: &[f64; 3], h: f64, order: usize) -> Series {
    let mut w = [[0.0; TERMS + 1]; 3];
    for k in 0..3 {
        w[k][0] = omega[k];
    }
    for n in 0..order {
        let part = h / (n + 1) as f64;
        let next = [0, 1, 2].map(|a| part * ratios.factor[a] * product(&w[(a + 1) % 3], &w[(a + 2) % 3], n));
        for a in 0..3 {
            w[a][n + 1] = next[a];
        }
    }
    w
}

/// One input's change of the spin, `d' = k (d w + w d) + dk w w`, and of the attitude in body axes, `e' = d + e x w`.
fn step(
    ratios: &Ratios,
    forced: &[f64; 3],
    w: &Series,
    start: [&[f64; 3]; 2],
    h: f64,
    order: usize,
) -> ([f64; 3], [f64; 3]) {
    let (mut d, mut e) = ([[0.0; TERMS + 1]; 3], [[0.0; TERMS + 1]; 3]);
    for k in 0..3 {
        (d[k][0], e[k][0]) = (start[0][k], start[1][k]);
    }
    for n in 0..order {
        let part = h / (n + 1) as f64;
        for a in 0..3 {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            let linear = product(&d[b], &w[c], n) + product(&w[b], &d[c], n);
            let force = if forced[a] == 0.0 { 0.0 } else { forced[a] * product(&w[b], &w[c], n) };
            d[a][n + 1] = part * (ratios.factor[a] * linear + force);
            e[a][n + 1] = part * (d[a][n] + (product(&e[b], &w[c], n) - product(&e[c], &w[b], n)));
        }
    }
    (total(&d, order), total(&e, order))
}
