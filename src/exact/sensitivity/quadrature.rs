//! Gauss's quadrature on one step, to its end and from each node to the end.

pub(super) use crate::number::quadrature::{NODE_COUNT, NODES, WEIGHTS};

use crate::number::quadrature::legendre;

/// The weights of the integrals from each node to the interval's end.
pub(super) const REMAINING: [[f64; NODE_COUNT]; NODE_COUNT] = remaining_weights();

/// Of the polynomial that is 1 at one node and 0 at the others, expanded in Legendre's, whose integrals are
/// differences of their neighbours.
const fn remaining_weights() -> [[f64; NODE_COUNT]; NODE_COUNT] {
    let mut all = [[0.0; NODE_COUNT]; NODE_COUNT];
    let mut j = 0;
    while j < NODE_COUNT {
        let end: [f64; NODE_COUNT + 1] = legendre(NODES[j]);
        let mut k = 0;
        while k < NODE_COUNT {
            let at: [f64; NODE_COUNT + 1] = legendre(NODES[k]);
            let mut sum = NODES[j] + 1.0;
            let mut m = 1;
            while m < NODE_COUNT {
                sum += at[m] * (end[m + 1] - end[m - 1]);
                m += 1;
            }
            // From the start to the node, and mirrored.
            all[NODE_COUNT - 1 - j][NODE_COUNT - 1 - k] = 0.5 * WEIGHTS[k] * sum;
            k += 1;
        }
        j += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::{NODE_COUNT, NODES, REMAINING, WEIGHTS};

    #[test]
    fn the_quadrature_integrates_the_powers_that_it_should() {
        for power in 0..16 {
            let at = |k: usize| (0.5 + 0.5 * NODES[k]).powi(power);
            let whole: f64 = (0..NODE_COUNT).map(|k| WEIGHTS[k] * at(k)).sum();
            assert!((whole * f64::from(power + 1) - 1.0).abs() < 1e-14, "{power}");
            for j in 0..NODE_COUNT {
                let rest: f64 = (0..NODE_COUNT).map(|k| REMAINING[j][k] * at(k)).sum();
                let exact = (1.0 - (0.5 + 0.5 * NODES[j]).powi(power + 1)) / f64::from(power + 1);
                assert!(power >= 8 || (rest - exact).abs() < 1e-15, "{power} {j}");
            }
        }
    }
}
