//! The turn of a step that keeps energy and momentum for any rate.

use crate::number::Field;

/// The change of the spin in a [`conserving_turn`], rad/s, along the axes before the turn, times
/// `below (below^2 + |tangents|^2)`, from what the turn gives.
#[inline(always)]
pub fn change_of_spin<T: Field>((below, [tangents, slip]): &(T, [[T; 3]; 2])) -> [T; 3] {
    let p = |i: usize, j: usize| tangents[i].clone() * slip[j].clone();
    let along = (p(0, 0) + p(1, 1)) + p(2, 2);
    three(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let across = below.clone() * slip[i].clone() + (p(j, k) - p(k, j));
        below.clone() * across + tangents[i].clone() * along.clone()
    })
}

/// The turn of a free body and the change of its spin. They conserve energy and momentum exactly for any
/// `rate` and any number `b` in `weights`, where the three roots are real and `below` is not zero: this is
/// proven for this function (`crates/proofs/src/proofs/position_stage.rs`). Both conditions follow from
/// bounds that a test compares with the longest parts of a step, which are turns of half a radian at most.
///
/// - `coupling`: `(I_j - I_k) / I_i` for the principal moments `I`, so that `omega_i' = coupling_i omega_j
///   omega_k`.
/// - `weights`: `1 + I_i b` for any `b`, which sets how fast the body turns about its momentum.
/// - `omega`: the spin along the principal axes, rad/s; `h`: the time, s.
/// - `rate`: sets how fast the spin moves along its curve in the body; 1 and terms of the order of the square
///   of the turn.
/// - `root`: the square root.
///
/// Returns a number `below` and two vectors along the principal axes before the turn, both to be divided by
/// `below`: the tangents `c`, which are the axis of the turn times the tangent of half its angle; and the
/// slip `(1 + c x) omega_after - (1 - c x) omega`, where `omega_after` is the spin after the turn in the axes
/// after the turn.
///
/// With `Q_i^2 = rate + coupling_j coupling_k (h omega_i)^2`, the addition theorem of Jacobi's functions
/// gives the spin after the time as `(omega_i Q_j Q_k + coupling_i h omega_j omega_k Q_i) / rate`.
#[inline(always)]
pub fn conserving_turn<T: Field>(
    coupling: &[T; 3],
    weights: &[T; 3],
    omega: &[T; 3],
    h: &T,
    rate: &T,
    mut root: impl FnMut(T) -> T,
) -> (T, [[T; 3]; 2]) {
    let of = |x: &[T; 3], i: usize| x[i % 3].clone();
    let theta = three(|i| of(omega, i) * h.clone());
    let roots = three(|i| {
        let square = of(&theta, i) * of(&theta, i);
        root(rate.clone() + of(coupling, i + 1) * of(coupling, i + 2) * square)
    });
    let product = of(&roots, 1) * of(&roots, 2);
    let bend = three(|i| of(coupling, i) * of(&theta, i + 1));
    // The sum of the spins before and after, times the rate.
    let sum = three(|i| {
        let pair = if i == 0 { product.clone() } else { of(&roots, i + 1) * of(&roots, i + 2) };
        of(omega, i) * (rate.clone() + pair) + of(&bend, i) * of(omega, i + 2) * of(&roots, i)
    });
    let total = (of(&roots, 0) + of(&roots, 1)) + of(&roots, 2);
    let corner = of(&bend, 0) * of(&bend, 1) * of(&bend, 2);
    let below = rate.clone() * (rate.clone() * total + (of(&roots, 0) * product + corner));
    let scaled = three(|i| of(&sum, i) * h.clone());
    let tangents = three(|i| of(weights, i) * (of(&scaled, i) * rate.clone()));
    let slip = three(|i| of(weights, i) * (of(coupling, i) * (of(&scaled, i + 1) * of(&sum, i + 2))));
    (below, [tangents, slip])
}

/// The rate for a [`conserving_turn`] that follows the free motion. Its arguments are the terms `coupling_j
/// coupling_k (h omega_i)^2` that are added to the rate under the roots; `over` returns the reciprocal of a
/// whole number.
///
/// With the first terms of Weierstrass' function, `h^2 P(h) = 1 + g2/20 + g3/28 + g2^2/1200 ...`, in units of
/// the time.
#[inline(always)]
pub fn conserving_rate<T: Field>([a, b, c]: [T; 3], over: impl Fn(u16) -> T) -> T {
    let mean = (a.clone() + b.clone() + c.clone()) * over(3);
    let [a, b, c] = [mean.clone() - a, mean.clone() - b, mean.clone() - c];
    let squares = a.clone() * a.clone() + b.clone() * b.clone() + c.clone() * c.clone();
    let series = squares.clone() * (over(10) + squares * over(300)) + (a * b) * c * over(7);
    (T::one() - mean) + series
}

/// Along each axis.
#[inline(always)]
pub(crate) fn three<T>(mut of: impl FnMut(usize) -> T) -> [T; 3] {
    [of(0), of(1), of(2)]
}
