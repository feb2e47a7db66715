//! Square root, sine, cosine and exponential of power series with exact coefficients, for steppers.
//!
//! Each follows from a differential equation that determines one power after another, and is exact. If the
//! first coefficient has no exact value (the sine of 1), the result is undefined, never rounded.

use super::{Fraction, Rational, Series};
use num_traits::{One, Zero};
use tumbling::number::{Analytic, Field};

/// Coefficients of which some have a square root.
pub trait Rooted: Field {
    /// The square root, where there is one.
    fn square_root(&self) -> Option<Self>;
}

impl Rooted for Rational {
    fn square_root(&self) -> Option<Self> {
        self.root()
    }
}

/// A number without a root in fractions gets a variable for it, `root(3)`: statements about it hold under the
/// relation `root(3)^2 = 3`.
impl Rooted for Fraction {
    fn square_root(&self) -> Option<Self> {
        let value = Rational::from(self.as_constant()?);
        let named = |x: &Rational| Self::variable(&format!("root({x})"));
        let positive = value > Rational::zero();
        value.root().map(Self::from).or_else(|| positive.then(|| named(&value)))
    }
}

fn undefined<T: Field>() -> Series<T> {
    Series::one() / Series::zero()
}

fn whole<T: Field>(n: usize) -> T {
    T::integer(u32::try_from(n).unwrap_or(u32::MAX))
}

/// `0, 1, ...` times the coefficients: `h` times the derivative.
fn weighed<T: Field>(a: &[T]) -> Vec<T> {
    a.iter().enumerate().map(|(n, x)| x.clone() * whole::<T>(n)).collect()
}

/// All coefficients that are known, if they end somewhere.
fn known<T: Field>(series: &Series<T>) -> Option<Vec<T>> {
    let order = series.order()?;
    (0..=order).map(|n| series.coefficient(n)).collect()
}

/// Whether it is a plain number, with no `h` in it.
fn plain<T: Field>(series: &Series<T>) -> Option<T> {
    let settled = !series.is_undefined() && series.order().is_none();
    let first = series.coefficient(0)?;
    (settled && (series.clone() - Series::constant(first.clone())).is_zero()).then_some(first)
}

fn sum_of_products<T: Field>(a: &[T], b: &[T], n: usize) -> T {
    (1..=n).fold(T::zero(), |sum, k| sum + a[k].clone() * b[n - k].clone())
}

impl<T: Rooted> Analytic for Series<T> {
    /// From `2 r_0 r_n = a_n - sum r_k r_(n-k)`.
    fn sqrt(&self) -> Self {
        if let Some(value) = plain(self) {
            return value.square_root().map_or_else(undefined, Self::constant);
        }
        let Some(a) = known(self) else { return undefined() };
        let Some(first) = a[0].square_root().filter(|root| !root.is_zero()) else { return undefined() };
        let mut r = vec![first.clone()];
        for n in 1..a.len() {
            let crossed = (1..n).fold(T::zero(), |sum, k| sum + r[k].clone() * r[n - k].clone());
            r.push((a[n].clone() - crossed) / (first.clone() + first.clone()));
        }
        Self::new(r, a.len() - 1)
    }

    /// From `s' = a' c` and `c' = -a' s`.
    fn sin_cos(&self) -> (Self, Self) {
        if plain(self).is_some_and(|value| value.is_zero()) {
            return (Self::zero(), Self::one());
        }
        let Some(a) = known(self).filter(|a| a[0].is_zero()) else { return (undefined(), undefined()) };
        let (slope, mut s, mut c) = (weighed(&a), vec![T::zero()], vec![T::one()]);
        for n in 1..a.len() {
            let (sine, cosine) = (sum_of_products(&slope, &c, n), -sum_of_products(&slope, &s, n));
            s.push(sine / whole::<T>(n));
            c.push(cosine / whole::<T>(n));
        }
        (Self::new(s, a.len() - 1), Self::new(c, a.len() - 1))
    }

    /// From `e' = a' e`.
    fn exp(&self) -> Self {
        if plain(self).is_some_and(|value| value.is_zero()) {
            return Self::one();
        }
        let Some(a) = known(self).filter(|a| a[0].is_zero()) else { return undefined() };
        let (slope, mut e) = (weighed(&a), vec![T::one()]);
        for n in 1..a.len() {
            e.push(sum_of_products(&slope, &e, n) / whole::<T>(n));
        }
        Self::new(e, a.len() - 1)
    }

    /// The sums of `(-x)^n / (2n)!` and of `(-x)^n / (2n + 1)!`.
    fn cos_sinc_of_root(&self) -> (Self, Self) {
        if plain(self).is_some_and(|value| value.is_zero()) {
            return (Self::one(), Self::one());
        }
        let Some(order) = self.order().filter(|_| self.coefficient(0).is_some_and(|x| x.is_zero())) else {
            return (undefined(), undefined());
        };
        let mut term = Self::one();
        let (mut cosine, mut sinc) = (Self::zero(), Self::zero());
        for n in 0..=order {
            let over = |k: usize| Self::constant(T::one() / whole(k));
            cosine += term.clone();
            let odd = term * over(2 * n + 1);
            sinc += odd.clone();
            term = -(odd * over(2 * n + 2)) * self.clone();
        }
        // Exact ones are known to every power, the sums no further than x.
        (cosine.cut(order), sinc.cut(order))
    }

    /// `2^-n` for a lowest power `n`, 0 for zero, NaN if undefined.
    fn size(&self) -> f64 {
        if self.is_undefined() {
            return f64::NAN;
        }
        let end = self.order().map_or(usize::MAX, |order| order + 1).min(1000);
        let lowest = (0..end).find(|&n| self.coefficient(n).is_some_and(|x| !x.is_zero()));
        lowest.map_or(0.0, |n| 0.5_f64.powi(i32::try_from(n).unwrap_or(i32::MAX)))
    }

    fn rounding() -> f64 {
        0.0
    }
}
