//! The sums of products that make the coefficients of a power series.
//!
//! One pass over the coefficients makes all sums of an order that have the spin for a factor. They are kept
//! in rows of which the compiler takes two numbers at a time as a vector: a row times one component of the
//! spin. So that both factors of a sum are read in the order of memory, the second stands there with its
//! highest power first. What an order costs is as much the time until its last coefficient is made as the
//! number of products, so what needs that comes last in each sum.

use crate::number::Analytic;

/// A quaternion's vector part, then its scalar part; or a vector, of which the fourth repeats the first.
pub(super) type Four<T> = [T; 4];

pub(super) fn four<T: Copy>([x, y, z]: [T; 3]) -> Four<T> {
    [x, y, z, x]
}

#[inline(always)]
pub(super) fn scaled<T: Analytic + Copy>(a: &Four<T>, by: T) -> Four<T> {
    core::array::from_fn(|i| a[i] * by)
}

#[inline(always)]
pub(super) fn add_scaled<T: Analytic + Copy>(sum: &mut Four<T>, a: &Four<T>, by: T) {
    for i in 0..4 {
        sum[i] += a[i] * by;
    }
}

#[inline(always)]
fn add_two<T: Analytic + Copy>(sum: &mut [T; 2], a: [T; 2], b: [T; 2]) {
    for i in 0..2 {
        sum[i] += a[i] * b[i];
    }
}

/// Each component of a vector, twice.
pub(super) type Doubled<T> = [[T; 2]; 3];

/// The sums of an order, as they are made: the compiler keeps numbers together that are stored together.
pub(super) struct Sums<T> {
    /// Of the attitude's halves times each component of the spin.
    pub(super) turn: [[T; 2]; 6],
    /// Of the spin's other components times the first and the second.
    pub(super) pairs: [[T; 2]; 2],
    /// Of the two other components of a vector times each.
    pub(super) across: [[T; 2]; 3],
}

impl<T: Analytic + Copy> Sums<T> {
    #[inline(always)]
    fn add<const ACROSS: bool>(&mut self, q: &Four<T>, v: &Four<T>, g: &Four<T>, [x, y, z]: Doubled<T>) {
        let (one, two) = ([q[0], q[1]], [q[2], q[3]]);
        add_two(&mut self.turn[0], one, x);
        add_two(&mut self.turn[1], two, x);
        add_two(&mut self.pairs[0], [v[1], v[2]], x);
        if ACROSS {
            add_two(&mut self.across[0], [g[1], g[2]], x);
        }
        add_two(&mut self.turn[2], one, y);
        add_two(&mut self.turn[3], two, y);
        add_two(&mut self.pairs[1], [v[2], v[3]], y);
        if ACROSS {
            add_two(&mut self.across[1], [g[2], g[3]], y);
        }
        add_two(&mut self.turn[4], one, z);
        add_two(&mut self.turn[5], two, z);
        if ACROSS {
            add_two(&mut self.across[2], [g[0], g[1]], z);
        }
    }
}

/// The first `n` products of attitude `q`, spin `v` and, if requested, a vector `g`, from the lowest power
/// up, with the spin `w` from the highest power down to the lowest.
// Not inlined, as the next: see `Sums`.
#[inline(never)]
pub(super) fn sums<T: Analytic + Copy, const N: usize, const ACROSS: bool>(
    n: usize,
    q: &[Four<T>; N],
    v: &[Four<T>; N],
    g: &[Four<T>; N],
    w: &[Doubled<T>; N],
) -> Sums<T> {
    let n = n.min(N);
    let w = &w[N - n..];
    let none = [T::zero(); 2];
    let mut sums = Sums { turn: [none; 6], pairs: [none; 2], across: [none; 3] };
    // The highest power of the spin last: it is still being made while the others are added.
    for k in 1..n {
        sums.add::<ACROSS>(&q[k], &v[k], &g[k], w[k]);
    }
    sums.add::<ACROSS>(&q[0], &v[0], &g[0], w[0]);
    sums
}

/// The first `n` products of `g` with `w` as above.
#[inline(never)]
pub(super) fn across_sums<T: Analytic + Copy, const N: usize>(
    n: usize,
    g: &[Four<T>; N],
    w: &[Doubled<T>; N],
) -> [[T; 2]; 3] {
    let n = n.min(N);
    let w = &w[N - n..];
    let mut sums = [[T::zero(); 2]; 3];
    let mut add = |g: &Four<T>, [x, y, z]: Doubled<T>| {
        add_two(&mut sums[0], [g[1], g[2]], x);
        add_two(&mut sums[1], [g[2], g[3]], y);
        add_two(&mut sums[2], [g[0], g[1]], z);
    };
    for k in 1..n {
        add(&g[k], w[k]);
    }
    add(&g[0], w[0]);
    sums
}

/// Twice the rate of the attitude.
#[inline(always)]
pub(super) fn turn<T: Analytic + Copy>([a, b, c, d, e, f]: &[[T; 2]; 6]) -> Four<T> {
    [b[1] + e[1] - d[0], d[1] + b[0] - e[0], f[1] + c[0] - a[1], -(a[0] + c[1] + f[0])]
}

/// `g x w`.
#[inline(always)]
pub(super) fn across<T: Analytic + Copy>([s, t, u]: &[[T; 2]; 3]) -> Four<T> {
    four([u[1] - t[0], s[1] - u[0], t[1] - s[0]])
}

/// The products `w2 w3`, `w3 w1`, `w1 w2`.
#[inline(always)]
pub(super) fn pairs<T: Analytic + Copy>(first: &[T; 2], second: &[T; 2]) -> Four<T> {
    four([second[0], first[1], first[0]])
}

/// Coefficients of a vector, from the lowest power up and from the highest down.
#[derive(Debug, Clone)]
pub(super) struct Both<T, const N: usize> {
    pub(super) up: [Four<T>; N],
    pub(super) down: [Doubled<T>; N],
}

impl<T: Copy, const N: usize> Both<T, N> {
    #[inline(always)]
    pub(super) fn set(&mut self, power: usize, value: Four<T>) {
        let [x, y, z, _] = value;
        self.up[power] = value;
        self.down[N - 1 - power] = [[x; 2], [y; 2], [z; 2]];
    }
}
