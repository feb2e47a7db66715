//! Integrals over solids: volume, centre and inertia from the definition, in symbols.

use crate::number::{Derivation, Fraction, Polynomial, Relations, Symbol};
use crate::proof::Residue;
use crate::symbols::{Matrix, Vector};
use num_traits::{One, Zero};

/// A solid swept by three parameters: where each point is, and how far the parameters run.
///
/// The volume element is computed, as the determinant of the derivatives.
#[derive(Debug, Clone)]
pub struct Region {
    position: Vector,
    relations: Relations,
    ranges: Vec<Range>,
}

#[derive(Debug, Clone)]
struct Range {
    rate: Derivation,
    run: Run,
}

#[derive(Debug, Clone)]
enum Run {
    Between(Symbol, Polynomial, Polynomial),
    /// Once around: cosine and sine.
    Around(Symbol, Symbol),
}

impl Region {
    /// The point at each value of the parameters, which may hold symbols tied by `relations`.
    pub fn new(position: Vector, relations: Relations) -> Self {
        Self { position, relations, ranges: Vec::new() }
    }

    /// A parameter that runs from `from` to `to`, which may hold the parameters before it.
    pub fn between(self, name: &str, from: &Polynomial, to: &Polynomial) -> Self {
        self.along(name, from, to, Derivation::default())
    }

    /// A parameter with which other symbols change too.
    pub fn along(mut self, name: &str, from: &Polynomial, to: &Polynomial, also: Derivation) -> Self {
        let run = Run::Between(name.into(), from.clone(), to.clone());
        self.ranges.push(Range { rate: also.and(name, Fraction::one()), run });
        self
    }

    /// An angle that runs once around, by the names of its cosine and sine.
    pub fn around(mut self, cos: &str, sin: &str) -> Self {
        let rate = Derivation::new([(cos, -Fraction::variable(sin)), (sin, Fraction::variable(cos))]);
        self.ranges.push(Range { rate, run: Run::Around(cos.into(), sin.into()) });
        self
    }

    /// The integral over the solid of a function of the position, `pi` being a symbol.
    fn integral(&self, integrand: &Fraction) -> Result<Fraction, Residue> {
        let claim = "the integral over a solid of a polynomial".to_owned();
        let [a, b, c] = &self.ranges[..] else { return Err(Residue::Missing { claim }) };
        let [a, b, c] = [a, b, c].map(|range| self.position.map(|x| range.rate.of(&x)));
        let element = self.relations.reduce_fraction(&a.dot(&b.cross(&c)));
        let whole = self.relations.reduce_fraction(&(element * integrand.clone()));
        let Some(mut value) = whole.as_polynomial().cloned() else { return Err(Residue::Missing { claim }) };
        for range in self.ranges.iter().rev() {
            value = match &range.run {
                Run::Between(symbol, from, to) => value.integral(symbol, from, to),
                Run::Around(cos, sin) => around(&value, cos, sin),
            };
            value = self.relations.reduce(&value);
        }
        Ok(value.into())
    }

    /// Volume, first moments `∫ r` and inertia `∫ (y² + z²)`, `-∫ x y`, ... about the origin.
    pub fn sums(&self) -> Result<Sums, Residue> {
        let r = &self.position;
        let square = |i: usize| &r[i] * &r[i];
        let mut first = Vector::zeros();
        let mut inertia = Matrix::zeros();
        for i in 0..3 {
            first[i] = self.integral(&r[i])?;
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            inertia[(i, i)] = self.integral(&(square(j) + square(k)))?;
            inertia[(i, j)] = self.integral(&-(&r[i] * &r[j]))?;
            inertia[(j, i)] = inertia[(i, j)].clone();
        }
        Ok(Sums { volume: self.integral(&Fraction::one())?, first, inertia })
    }
}

/// Volume, first moments and inertia about the origin, all for density 1. Bodies add, holes subtract.
#[derive(Debug, Clone)]
pub struct Sums {
    pub(crate) volume: Fraction,
    pub(crate) first: Vector,
    pub(crate) inertia: Matrix,
}

impl Sums {
    /// The sum of this and a multiple of the other.
    fn plus(self, times: i64, other: &Self) -> Self {
        let times = |x: &Fraction| x * Fraction::from(times);
        Self {
            volume: self.volume + times(&other.volume),
            first: self.first + other.first.map(|x| times(&x)),
            inertia: self.inertia + other.inertia.map(|x| times(&x)),
        }
    }

    /// Both together.
    pub fn and(self, other: &Self) -> Self {
        self.plus(1, other)
    }

    /// This with `hole` taken out.
    pub fn without(self, hole: &Self) -> Self {
        self.plus(-1, hole)
    }
}

/// The integral once around an angle: odd powers of sine or cosine leave nothing, and
/// `∫ sin^n = 2 pi (1/2) (3/4) ... ((n - 1)/n)` for even `n`.
pub fn around(p: &Polynomial, cos: &Symbol, sin: &Symbol) -> Polynomial {
    let circle = Relations::circle(cos.name(), sin.name());
    let mut sum = Polynomial::zero();
    let even_in_cos = circle.reduce(p).in_powers_of(cos).swap_remove(0);
    let mut mean = Polynomial::from(2) * Polynomial::variable("pi");
    let mut n: i64 = 0;
    for (power, part) in even_in_cos.in_powers_of(sin).into_iter().enumerate() {
        if power % 2 == 1 {
            continue;
        }
        if power > 0 {
            n += 2;
            mean = mean.scaled(&num_rational::BigRational::new((n - 1).into(), n.into()));
        }
        sum += part * mean.clone();
    }
    sum
}
