//! The sums of products that give the coefficients of a power series.
//!
//! One pass over the coefficients computes all sums of an order that contain the spin. The compiler processes
//! two numbers of a row at a time as a vector, so the factors stand in pairs. Both
//! factors of a sum are read in increasing order of memory, so the second factor is stored with its highest
//! power first. The cost of an order depends on the latency of its last coefficient as much as on the number
//! of products, so terms with that coefficient come last in each sum. A value that was just stored is loaded
//! quickly only in the pairs in which it was stored, so new values are not loaded in other pairs.

/// A quaternion's scalar part, and its components along x, along z, and along y with the opposite sign; or a
/// vector, of which the fourth repeats the third.
pub(super) type Lanes = [f64; 4];

pub(super) fn lanes([x, y, z]: [f64; 3]) -> Lanes {
    [x, y, z, z]
}

// Not by `from_fn`, which calls a function for each.
#[inline(always)]
pub(super) fn each(of: impl Fn(usize) -> f64) -> Lanes {
    [of(0), of(1), of(2), of(3)]
}

#[inline(always)]
pub(super) fn scaled(a: &Lanes, by: f64) -> Lanes {
    each(|i| a[i] * by)
}

#[inline(always)]
pub(super) fn add_scaled(sum: &mut Lanes, a: &Lanes, by: f64) {
    for i in 0..4 {
        sum[i] += a[i] * by;
    }
}

#[inline(always)]
fn add_two(sum: &mut [f64; 2], a: [f64; 2], b: [f64; 2]) {
    for i in 0..2 {
        sum[i] += a[i] * b[i];
    }
}

/// Two numbers that are processed together.
type Pair = [f64; 2];

/// A vector's second component and its first, and its third twice: its factors in a cross product.
pub(super) type Factors = [Pair; 2];

#[inline(always)]
fn factors_of(&[x, y, z, again]: &Lanes) -> Factors {
    [[y, x], [z, again]]
}

#[inline(always)]
fn plus(a: Pair, b: Pair) -> Pair {
    [a[0] + b[0], a[1] + b[1]]
}

#[inline(always)]
fn minus(a: Pair, b: Pair) -> Pair {
    [a[0] - b[0], a[1] - b[1]]
}

/// The sums of an order: the compiler keeps numbers together that are stored together.
pub(super) struct Sums {
    /// Four times the attitude's rate.
    pub(super) turn: [Pair; 2],
    /// The spin's first two components times its own factors.
    pub(super) pairs: [Pair; 2],
    /// A vector times the spin.
    pub(super) across: AcrossSums,
}

/// The sums of a cross product `g x w`: of `g`'s first two components times `w`'s third, of its third times
/// the second and the first of `w`, and of its first two times these.
pub(super) type AcrossSums = [Pair; 3];

#[inline(always)]
fn add_across(sums: &mut AcrossSums, g: &Lanes, [other, z]: Factors) {
    add_two(&mut sums[0], [g[0], g[1]], z);
    add_two(&mut sums[1], [g[2], g[3]], other);
    add_two(&mut sums[2], [g[0], g[1]], other);
}

#[inline(always)]
fn add_pairs(sums: &mut [Pair; 2], v: &Lanes, [other, z]: Factors) {
    add_two(&mut sums[0], [v[0], v[1]], z);
    add_two(&mut sums[1], [v[0], v[1]], other);
}

/// The attitude from the lowest power up, and the factors of its product with the spin in eight
/// multiplications instead of twelve [HL75](crate::references): of the spin from the highest power down.
#[derive(Debug, Clone)]
// Aligned, so that the processor multiplies the factors where they stand.
#[repr(align(16))]
pub(super) struct Turning<const N: usize> {
    pub(super) up: [Lanes; N],
    attitude: [[Pair; 4]; N],
    spin: [[Pair; 3]; N],
}

impl<const N: usize> Turning<N> {
    pub(super) const NONE: Self =
        Self { up: [[0.0; 4]; N], attitude: [[[0.0; 2]; 4]; N], spin: [[[0.0; 2]; 3]; N] };

    #[inline(always)]
    pub(super) fn set(&mut self, power: usize, attitude: Lanes, [x, y, z, _]: Lanes) {
        let [w, a, c, less_b] = attitude;
        self.up[power] = attitude;
        let (first, second, along, across) = ([w, a], [c, -less_b], [c, w], [less_b, a]);
        let ([up, down], more) = (minus(first, second), plus(first, second));
        self.attitude[power] = [minus(along, across), plus(along, across), more, [down, up]];
        self.spin[N - 1 - power] = [[z + x, y], [z - x, y], [y - x, y + x]];
    }
}

#[inline(always)]
fn add_turn(sums: &mut [Pair; 4], q: &[Pair; 4], w: &[Pair; 3], [_, z]: Factors) {
    add_two(&mut sums[0], q[0], w[0]);
    add_two(&mut sums[1], q[1], w[1]);
    add_two(&mut sums[2], q[2], z);
    add_two(&mut sums[3], q[3], w[2]);
}

/// The turn from the sums of the eight products.
#[inline(always)]
fn joined([c, d, b, a]: [Pair; 4]) -> [Pair; 2] {
    let [x, y] = minus(c, d);
    let (one, other) = (minus(plus(a, b), plus(c, d)), plus(minus(a, b), [y, x]));
    [plus(one, other), minus(one, other)]
}

/// The first `n` products of attitude, spin and, if requested, a vector `g`, from the lowest power up, with
/// the spin from the highest power down to the lowest.
// Not inlined, as the others: alone it has the registers to itself.
#[inline(never)]
pub(super) fn sums<const N: usize, const ACROSS: bool>(
    n: usize,
    turning: &Turning<N>,
    g: &[Lanes; N],
    Coefficients { up: v, down }: &Coefficients<N>,
) -> Sums {
    let n = n.clamp(1, N);
    let (q, v, g) = (&turning.attitude[..n], &v[..n], &g[..n]);
    let (w, factors) = (&turning.spin[N - n..][..n], &down[N - n..][..n]);
    let none = [0.0; 2];
    let (mut turn, mut pairs, mut across) = ([none; 4], [none; 2], [none; 3]);
    // The highest power of the spin comes last: it is computed while the others are added.
    for k in 1..n {
        add_turn(&mut turn, &q[k], &w[k], factors[k]);
        add_pairs(&mut pairs, &v[k], factors[k]);
        if ACROSS {
            add_across(&mut across, &g[k], factors[k]);
        }
    }
    add_turn(&mut turn, &q[0], &w[0], factors[0]);
    add_pairs(&mut pairs, &v[0], factors[0]);
    if ACROSS {
        add_across(&mut across, &g[0], factors[0]);
    }
    Sums { turn: joined(turn), pairs, across }
}

/// The first `n` products of `g` with `w` as above.
#[inline(never)]
pub(super) fn across_sums<const N: usize>(
    n: usize,
    g: &[Lanes; N],
    Coefficients { up, down }: &Coefficients<N>,
) -> AcrossSums {
    let n = n.clamp(1, N);
    let w = &down[N - n..];
    let mut sums = [[0.0; 2]; 3];
    for k in 1..n {
        add_across(&mut sums, &g[k], w[k]);
    }
    add_across(&mut sums, &g[0], factors_of(&up[n - 1]));
    sums
}

/// The first `n` products of a vector with its own factors.
#[inline(never)]
pub(super) fn pair_sums<const N: usize>(n: usize, Coefficients { up, down }: &Coefficients<N>) -> [Pair; 2] {
    let n = n.clamp(1, N);
    let w = &down[N - n..];
    let mut sums = [[0.0; 2]; 2];
    for k in 1..n {
        add_pairs(&mut sums, &up[k], w[k]);
    }
    add_pairs(&mut sums, &up[0], factors_of(&up[n - 1]));
    sums
}

/// `g x w`.
#[inline(always)]
pub(super) fn across([s, t, u]: &AcrossSums) -> Lanes {
    lanes([s[1] - t[0], t[1] - s[0], u[0] - u[1]])
}

/// The products `w2 w3`, `w3 w1`, `w1 w2`.
#[inline(always)]
pub(super) fn pairs([first, second]: &[Pair; 2]) -> Lanes {
    lanes([first[1], first[0], second[0]])
}

/// Coefficients of a vector, from the lowest power up, and its factors from the highest down.
#[derive(Debug, Clone)]
#[repr(align(16))]
pub(super) struct Coefficients<const N: usize> {
    pub(super) up: [Lanes; N],
    down: [Factors; N],
}

impl<const N: usize> Coefficients<N> {
    pub(super) const NONE: Self = Self { up: [[0.0; 4]; N], down: [[[0.0; 2]; 2]; N] };

    #[inline(always)]
    pub(super) fn set(&mut self, power: usize, value: Lanes) {
        self.up[power] = value;
        self.down[N - 1 - power] = factors_of(&value);
    }
}
