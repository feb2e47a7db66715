//! The sums of products that give the coefficients of a power series.
//!
//! One pass over the coefficients computes all sums of an order that contain the spin. Each row is multiplied
//! by one component of the spin, and the compiler processes two numbers of a row at a time as a vector. Both
//! factors of a sum are read in increasing order of memory, so the second factor is stored with its highest
//! power first. The cost of an order depends on the latency of its last coefficient as much as on the number
//! of products, so terms with that coefficient come last in each sum. A value that was just stored is loaded
//! quickly only in the pairs in which it was stored, so new values are not loaded in other pairs.

/// A quaternion's vector part, then its scalar part; or a vector, of which the fourth repeats the first.
pub(super) type Lanes = [f64; 4];

pub(super) fn lanes([x, y, z]: [f64; 3]) -> Lanes {
    [x, y, z, x]
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

/// The second component of a vector, its first and its third, each twice: the first two stand together in the
/// middle.
pub(super) type Pairs = [[f64; 2]; 3];

#[inline(always)]
fn pairs_of(&[x, y, z, _]: &Lanes) -> Pairs {
    [[y; 2], [x; 2], [z; 2]]
}

/// The sums of an order while they are computed: the compiler keeps numbers together that are stored
/// together.
pub(super) struct Sums {
    /// The attitude's halves times each component of the spin.
    pub(super) turn: [[f64; 2]; 6],
    /// The spin's first two components times the third and the second.
    pub(super) pairs: [[f64; 2]; 2],
    /// A vector times the spin.
    pub(super) across: AcrossSums,
}

/// The sums of a cross product `g x w`: of `g`'s first two components times `w`'s third, of its third times
/// the second and the first of `w`, and of its first two times these.
pub(super) type AcrossSums = [[f64; 2]; 3];

#[inline(always)]
fn add_across(sums: &mut AcrossSums, g: &Lanes, [y, x, z]: Pairs) {
    let other = [y[1], x[0]];
    add_two(&mut sums[0], [g[0], g[1]], z);
    add_two(&mut sums[1], [g[2]; 2], other);
    add_two(&mut sums[2], [g[0], g[1]], other);
}

#[inline(always)]
fn add_pairs(sums: &mut [[f64; 2]; 2], v: &Lanes, [y, _, z]: Pairs) {
    add_two(&mut sums[0], [v[0], v[1]], z);
    add_two(&mut sums[1], [v[0], v[1]], y);
}

impl Sums {
    // In this order: each number is loaded once, and no sum leaves its register.
    #[inline(always)]
    fn add<const ACROSS: bool>(&mut self, q: &Lanes, v: &Lanes, g: &Lanes, w: Pairs) {
        let ([y, x, z], one, two) = (w, [q[0], q[1]], [q[2], q[3]]);
        add_two(&mut self.turn[4], one, z);
        add_two(&mut self.turn[5], two, z);
        add_two(&mut self.pairs[0], [v[0], v[1]], z);
        if ACROSS {
            add_two(&mut self.across[0], [g[0], g[1]], z);
        }
        add_two(&mut self.turn[2], one, y);
        add_two(&mut self.turn[3], two, y);
        add_two(&mut self.pairs[1], [v[0], v[1]], y);
        add_two(&mut self.turn[0], one, x);
        add_two(&mut self.turn[1], two, x);
        if ACROSS {
            let other = [y[1], x[0]];
            add_two(&mut self.across[1], [g[2]; 2], other);
            add_two(&mut self.across[2], [g[0], g[1]], other);
        }
    }
}

/// The first `n` products of attitude `q`, spin and, if requested, a vector `g`, from the lowest power up,
/// with the spin from the highest power down to the lowest.
// Not inlined, as the others: see `Sums`.
#[inline(never)]
pub(super) fn sums<const N: usize, const ACROSS: bool>(
    n: usize,
    q: &[Lanes; N],
    g: &[Lanes; N],
    Coefficients { up: v, down }: &Coefficients<N>,
) -> Sums {
    let n = n.clamp(1, N);
    let w = &down[N - n..];
    let none = [0.0; 2];
    let mut sums = Sums { turn: [none; 6], pairs: [none; 2], across: [none; 3] };
    // The highest power of the spin comes last: it is computed while the others are added.
    for k in 1..n {
        sums.add::<ACROSS>(&q[k], &v[k], &g[k], w[k]);
    }
    sums.add::<ACROSS>(&q[0], &v[0], &g[0], pairs_of(&v[n - 1]));
    sums
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
    add_across(&mut sums, &g[0], pairs_of(&up[n - 1]));
    sums
}

/// The sums of [`across_sums`], and the first `n` products of `g` with its own third and second components.
#[inline(never)]
pub(super) fn own_sums<const N: usize>(
    n: usize,
    Coefficients { up: g, down: own }: &Coefficients<N>,
    Coefficients { up, down }: &Coefficients<N>,
) -> (AcrossSums, [[f64; 2]; 2]) {
    let n = n.clamp(1, N);
    let (w, own) = (&down[N - n..], &own[N - n..]);
    let none = [0.0; 2];
    let (mut across, mut pairs) = ([none; 3], [none; 2]);
    for k in 1..n {
        add_across(&mut across, &g[k], w[k]);
        add_pairs(&mut pairs, &g[k], own[k]);
    }
    add_across(&mut across, &g[0], pairs_of(&up[n - 1]));
    add_pairs(&mut pairs, &g[0], pairs_of(&g[n - 1]));
    (across, pairs)
}

/// Twice the rate of the attitude.
#[inline(always)]
pub(super) fn turn([a, b, c, d, e, f]: &[[f64; 2]; 6]) -> Lanes {
    [b[1] + e[1] - d[0], d[1] + b[0] - e[0], f[1] + c[0] - a[1], -(a[0] + c[1] + f[0])]
}

/// `g x w`.
#[inline(always)]
pub(super) fn across([s, t, u]: &AcrossSums) -> Lanes {
    lanes([s[1] - t[0], t[1] - s[0], u[0] - u[1]])
}

/// The products `w2 w3`, `w3 w1`, `w1 w2`.
#[inline(always)]
pub(super) fn pairs([first, second]: &[[f64; 2]; 2]) -> Lanes {
    lanes([first[1], first[0], second[0]])
}

/// Coefficients of a vector, from the lowest power up and from the highest down.
#[derive(Debug, Clone)]
pub(super) struct Coefficients<const N: usize> {
    pub(super) up: [Lanes; N],
    pub(super) down: [Pairs; N],
}

impl<const N: usize> Coefficients<N> {
    #[inline(always)]
    pub(super) fn set(&mut self, power: usize, value: Lanes) {
        self.up[power] = value;
        self.down[N - 1 - power] = pairs_of(&value);
    }
}
