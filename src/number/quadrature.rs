//! Legendre's polynomials, and the rule of Gauss whose nodes are the roots of the eighth of them
//! ([DLMF](crate::references) 3.5(v)).

pub(crate) const NODE_COUNT: usize = 8;

/// The nodes of Gauss's rule on (-1, 1).
pub(crate) const NODES: [f64; NODE_COUNT] = mirrored(
    -1.0,
    [0.183_434_642_495_649_8, 0.525_532_409_916_329, 0.796_666_477_413_626_7, 0.960_289_856_497_536_3],
);

/// Its weights on an interval of length 1.
pub(crate) const WEIGHTS: [f64; NODE_COUNT] = mirrored(
    1.0,
    [0.181_341_891_689_181, 0.156_853_322_938_943_63, 0.111_190_517_226_687_24, 0.050_614_268_145_188_13],
);

const fn mirrored(sign: f64, upper: [f64; NODE_COUNT / 2]) -> [f64; NODE_COUNT] {
    let mut all = [0.0; NODE_COUNT];
    let mut n = 0;
    while n < NODE_COUNT / 2 {
        (all[NODE_COUNT / 2 + n], all[NODE_COUNT / 2 - 1 - n]) = (upper[n], sign * upper[n]);
        n += 1;
    }
    all
}

/// Legendre's polynomials of the degrees 0 to `N - 1`, by their recurrence.
pub(crate) const fn legendre<const N: usize>(x: f64) -> [f64; N] {
    let mut p = [1.0; N];
    if N > 1 {
        p[1] = x;
    }
    let mut n = 1;
    while n + 1 < N {
        p[n + 1] = ((2 * n + 1) as f64 * x * p[n] - n as f64 * p[n - 1]) / (n + 1) as f64;
        n += 1;
    }
    p
}

/// The weights of the integrals from each node to the interval's end.
pub(crate) const REMAINING: [[f64; NODE_COUNT]; NODE_COUNT] = remaining_weights();

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
    use super::*;
    use crate::number::double_double::DoubleDouble;

    /// By a step of Newton's method in twice the precision, from `P8' = 8 (P7 - x P8)/(1 - x²)`.
    #[test]
    fn each_node_is_the_number_nearest_to_a_root_of_the_eighth_polynomial_and_so_is_its_weight() {
        let [one, eight] = [1.0, 8.0].map(DoubleDouble::<f64>::from);
        for (&node, &weight) in NODES.iter().zip(&WEIGHTS) {
            let x = DoubleDouble::from(node);
            let (mut seventh, mut eighth) = (one, x);
            for n in [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0] {
                let next = (x * eighth * (2.0 * n + 1.0) - seventh * n) / DoubleDouble::from(n + 1.0);
                (seventh, eighth) = (eighth, next);
            }
            let (short, slope) = (one - x * x, eight * (seventh - x * eighth));
            let root = x - eighth * short / slope;
            assert_eq!(root.hi(), node);
            // By Legendre's equation the slope does not change there.
            assert_eq!(((one - root * root) / (slope * slope)).hi(), weight, "{node}");
        }
    }

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
