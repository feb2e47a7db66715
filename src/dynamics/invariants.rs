//! What a free motion conserves and how far it is from the separatrix, from moments and spin.
//!
//! All formulas are products of the differences of the given moments, sums of terms of one sign, or the one
//! difference that matters, which is taken in twice the precision; nothing that is small is formed by
//! subtracting squares. All values are scaled by powers of two, so that a deviation of 5e-324 is treated like
//! any other.

use crate::inertia::PrincipalMoments;
use crate::number::{DoubleDouble, Real, exact_products, exact_sum};
use nalgebra::Vector3;

/// What kind of free motion this is, decided without rounding.
pub(crate) enum Kind {
    /// The spin is constant: at rest, a sphere, a spin about a principal axis, or one in the plane of two
    /// equal moments.
    Steady,
    /// The moment about this axis differs from two equal ones, and the spin is oblique.
    Symmetric(usize),
    /// Three different moments.
    Asymmetric(Asymmetric),
}

/// The constants of the motion of a body with three different moments, in scaled units: moments times
/// `2^-heaviest`, spins and rates times `2^-clock`.
pub(crate) struct Asymmetric<T = f64> {
    pub(crate) clock: i32,
    /// Index of the extreme axis that the spin never leaves, of the other extreme, of the middle.
    pub(crate) around: usize,
    pub(crate) across: usize,
    pub(crate) middle: usize,
    /// Scaled moments, and the distances `|I_C - I_X|`, `|I_C - I_M|`, `|I_M - I_X|`.
    pub(crate) moments: [T; 3],
    pub(crate) d_cx: DoubleDouble<T>,
    pub(crate) d_cm: DoubleDouble<T>,
    pub(crate) d_mx: DoubleDouble<T>,
    /// Exactly on the separatrix.
    pub(crate) separatrix: bool,
    /// `|L² - 2 E I_M|` times `2^(-2 small)`; its sign says which axis is circled.
    discriminant: DoubleDouble<T>,
    pub(crate) small: i32,
    /// `|2 E I_C - L²|` times `2^(-2 off_axis)`, and `|L² - 2 E I_X|`.
    off_squared: DoubleDouble<T>,
    pub(crate) off_axis: i32,
    round_squared: DoubleDouble<T>,
    /// The complementary modulus times `2^-small`.
    scaled_complement: DoubleDouble<T>,
}

fn distance<T: Real>(a: T, b: T) -> DoubleDouble<T> {
    (DoubleDouble::from(a) - DoubleDouble::from(b)).abs()
}

/// The larger of two, by their middles.
fn larger<T: Real>(a: T, b: T) -> T {
    T::select(a.lt(b), b, a)
}

/// The kind of the motion; the spin must be finite.
pub(crate) fn classify(moments: PrincipalMoments, omega: &Vector3<f64>) -> Kind {
    let idle = |i: usize, j: usize| moments[i] == moments[j] || omega[i] == 0.0 || omega[j] == 0.0;
    if idle(0, 1) && idle(1, 2) && idle(2, 0) {
        return Kind::Steady;
    }
    match moments.axis_of_symmetry() {
        Some(axis) => Kind::Symmetric(axis),
        None => {
            let (order, omega) = (moments.order(), (*omega).into());
            let difference =
                |i: &[f64; 3], scale: i32| discriminant_without_rounding(i, &omega, &order, scale);
            Kind::Asymmetric(Asymmetric::new(moments.into(), order, omega, difference))
        }
    }
}

impl<T: Real> Asymmetric<T> {
    /// From three different moments, the places of the smallest, the middle and the largest, and the spin;
    /// and what the discriminant is of scaled moments, and the spin times a negative power of two.
    pub(crate) fn new(
        moments: [T; 3],
        order: [usize; 3],
        omega: [T; 3],
        discriminant: impl Fn(&[T; 3], i32) -> DoubleDouble<T>,
    ) -> Self {
        let [low, middle, high] = order;
        let largest = |v: [T; 3]| v.iter().fold(T::zero(), |m, x| larger(m, x.abs()));
        let heaviest = moments[high].exponent();
        let clock = largest(omega).exponent().clamp(-1000, 1000);
        let i = moments.map(|x| x.times_power_of_two(-heaviest));
        let small = even(larger(omega[low].abs(), omega[high].abs()).exponent() - clock);
        let signed = discriminant(&i, clock + small);
        let negative = signed.hi().lt(T::zero());
        let (around, across) = if negative { (low, high) } else { (high, low) };
        let d_cx = distance(i[around], i[across]);
        let d_cm = distance(i[around], i[middle]);
        let d_mx = distance(i[middle], i[across]);
        let off_axis = even(larger(omega[across].abs(), omega[middle].abs()).exponent() - clock);
        let term = |axis: usize, d: DoubleDouble<T>, scale: i32| {
            let w = omega[axis].times_power_of_two(-scale);
            d * i[axis] * DoubleDouble::product(w, w)
        };
        let discriminant = signed.abs();
        // (C3)
        let round_squared = term(middle, d_mx, clock) + term(around, d_cx, clock);
        Self {
            clock,
            around,
            across,
            middle,
            moments: i,
            d_cx,
            d_cm,
            d_mx,
            separatrix: signed == DoubleDouble::from(T::zero()),
            discriminant,
            small,
            // (C3)
            off_squared: term(across, d_cx, clock + off_axis) + term(middle, d_cm, clock + off_axis),
            off_axis,
            round_squared,
            // (C4)
            scaled_complement: (d_cx * discriminant / (d_cm * round_squared)).sqrt(),
        }
    }

    /// Whether it is certain that the motion is not on the separatrix.
    pub(crate) fn off_the_separatrix(&self) -> bool {
        T::zero() < self.discriminant.hi()
    }

    /// The rate at which Jacobi's argument runs, without its sign.
    pub(crate) fn rate(&self) -> DoubleDouble<T> {
        let [x, m, c] = [self.across, self.middle, self.around].map(|axis| self.moments[axis]);
        // Rooted in two parts, so that a needle's small moment meets its small difference first.
        // (C6)
        let first = self.d_cm / DoubleDouble::from(x);
        (first * self.round_squared / DoubleDouble::product(m, c)).sqrt()
    }

    /// The complementary modulus `k'`, times `2^shift`.
    pub(crate) fn complement(&self, shift: i32) -> DoubleDouble<T> {
        self.scaled_complement.scaled(self.small + shift)
    }

    /// The modulus `k`, at most 1: next to the separatrix its rounding could exceed that.
    pub(crate) fn modulus(&self) -> T {
        let [d_mx, off, d_cm, round] =
            [self.d_mx, self.off_squared, self.d_cm, self.round_squared].map(DoubleDouble::hi);
        (d_mx * off / (d_cm * round)).sqrt().times_power_of_two(self.off_axis).at_most_one()
    }

    /// The square root of the complementary modulus, with all its digits where that is subnormal too.
    pub(crate) fn root_of_complement(&self) -> DoubleDouble<T> {
        self.scaled_complement.sqrt().scaled(self.small / 2)
    }

    /// The largest values of the spin along the across and the middle axis, times `2^lift`, and the around
    /// axis.
    pub(crate) fn amplitudes(&self, lift: i32) -> [DoubleDouble<T>; 3] {
        // (C5)
        let off = |axis: usize, d: DoubleDouble<T>| {
            (self.off_squared / (d * self.moments[axis])).sqrt().scaled(self.off_axis + lift)
        };
        let round = (self.round_squared / (self.d_cx * self.moments[self.around])).sqrt();
        [off(self.across, self.d_cx), off(self.middle, self.d_cm), round]
    }

    /// `L² - 2 E I_M` with the sign chosen so that it is not negative where the larger axis is circled; here
    /// only its magnitude, which may underflow near the separatrix.
    pub(crate) fn distance_from_separatrix(&self) -> T {
        self.discriminant.scaled(2 * self.small).hi()
    }
}

/// The even number at or just below.
fn even(n: i32) -> i32 {
    n & !1
}

/// `I_hi (I_hi - I_M) w_hi² - I_lo (I_M - I_lo) w_lo²`, with the spins times `2^-scale`, as its first term
/// and itself: this is `L² - 2 E I_M`.
pub(crate) fn discriminant<T: Real>(
    i: &[T; 3],
    omega: &[T; 3],
    order: &[usize; 3],
    scale: i32,
) -> [DoubleDouble<T>; 2] {
    let [low, middle, high] = *order;
    let term = |axis: usize| {
        let w = omega[axis].times_power_of_two(-scale);
        distance(i[axis], i[middle]) * i[axis] * DoubleDouble::product(w, w)
    };
    // (C2)
    let above = term(high);
    [above, above - term(low)]
}

/// The discriminant whose sign is right.
fn discriminant_without_rounding(
    i: &[f64; 3],
    omega: &[f64; 3],
    order: &[usize; 3],
    scale: i32,
) -> DoubleDouble {
    let [above, difference] = discriminant(i, omega, order, scale);
    if difference.hi().abs() > 1e-15 * above.hi() {
        return difference;
    }
    let [low, middle, high] = *order;
    // So close that twice the precision may not separate it from the separatrix: without rounding.
    let terms = |axis: usize, sign: f64| {
        let w = omega[axis].times_power_of_two(-scale);
        let apart = DoubleDouble::sum(i[axis], -i[middle]).abs();
        let with_moment = exact_products([apart.lo(), apart.hi()].into_iter(), sign * i[axis]);
        exact_products(exact_products(with_moment, w), w)
    };
    let mut all = terms(high, 1.0).chain(terms(low, -1.0)); // sixteen each
    exact_sum::<32>(core::array::from_fn(|_| all.next().unwrap_or(0.0)))
}
