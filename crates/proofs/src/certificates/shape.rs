//! What an expression looks like when the order of its terms and factors does not count.

use crate::number::expression::{Expression, Node};
use num_rational::BigRational;
use num_traits::Zero;
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};

/// A sign, and a number that expressions of one look share: no other is expected to have it.
pub(super) type Shape = (bool, u64);

/// The shape of an expression.
pub(super) fn of(x: &Expression) -> Shape {
    shape(x, &mut HashMap::new())
}

fn hashed(what: impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    what.hash(&mut hasher);
    hasher.finish()
}

fn shape(x: &Expression, known: &mut HashMap<usize, Shape>) -> Shape {
    if let Some(shape) = known.get(&x.address()) {
        return *shape;
    }
    let zero = (false, hashed(BigRational::zero()));
    let result = match x.node() {
        Node::Number(value) => (*value < BigRational::zero(), hashed(num_traits::abs(value.clone()))),
        Node::Variable(symbol) => (false, hashed(symbol.name())),
        Node::Negative(a) => {
            let (minus, shape) = shape(a, known);
            (!minus && shape != zero.1, shape)
        }
        Node::Sum(..) | Node::Difference(..) => {
            let mut terms = Vec::new();
            each_term(x, false, &mut |part, minus| {
                let (own, shape) = shape(part, known);
                terms.push((own != minus, shape));
            });
            terms.sort_unstable_by_key(|(minus, shape)| (*shape, *minus));
            // A sum and its negative have one shape and two signs.
            let sign = terms.first().is_some_and(|(minus, _)| *minus);
            terms.iter_mut().for_each(|(minus, _)| *minus ^= sign);
            (sign, hashed(("+", terms)))
        }
        Node::Product(..) => {
            let (mut factors, mut sign) = (Vec::new(), false);
            each_factor(x, false, &mut |part, negated| {
                let (minus, shape) = shape(part, known);
                factors.push(shape);
                sign ^= minus != negated;
            });
            factors.sort_unstable();
            if factors.contains(&zero.1) { zero } else { (sign, hashed(("*", factors))) }
        }
        Node::Quotient(a, b) => {
            let ((minus, above), (other, below)) = (shape(a, known), shape(b, known));
            if (minus, above) == zero { zero } else { (minus != other, hashed(("/", above, below))) }
        }
        Node::Power(a, n) => {
            let (minus, shape) = shape(a, known);
            (minus && n % 2 == 1, hashed(("^", shape, n)))
        }
    };
    known.insert(x.address(), result);
    result
}

fn each_term(x: &Expression, minus: bool, take: &mut impl FnMut(&Expression, bool)) {
    match x.node() {
        Node::Sum(a, b) | Node::Difference(a, b) => {
            each_term(a, minus, take);
            each_term(b, minus != matches!(x.node(), Node::Difference(..)), take);
        }
        Node::Negative(a) => each_term(a, !minus, take),
        _ => take(x, minus),
    }
}

/// A minus counts with the first factor that it stands before.
fn each_factor(x: &Expression, minus: bool, take: &mut impl FnMut(&Expression, bool)) {
    match x.node() {
        Node::Product(a, b) => {
            each_factor(a, minus, take);
            each_factor(b, false, take);
        }
        Node::Negative(a) => each_factor(a, !minus, take),
        _ => take(x, minus),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Fraction;
    use crate::number::expression::recording;

    #[test]
    fn only_the_order_of_terms_and_factors_does_not_count() {
        let [a, b, zero] = [Fraction::variable("a"), Fraction::variable("b"), Fraction::from(0)];
        let same = |x: &Fraction, y: &Fraction| of(&x.expression()) == of(&y.expression());
        recording(true, || {
            assert!(same(&(&a * &b + &a), &(&a + &b * &a)));
            assert!(same(&(&a * -(&b - &a)), &((&a - &b) * &a)));
            assert!(same(&(&zero / &a), &zero));
            assert!(same(&-(&(&zero / &a) * &b), &zero));
            assert!(
                same(&(&a * -(&b * &a)), &(&a * -(&a * &b))) && same(&(&a * -(&b * &a)), &-(&a * &b * &a))
            );
            assert!(!same(&(&a * (&a + &b)), &(&a * &a + &a * &b)));
            assert!(!same(&(&a - &b), &(&b - &a)));
        });
    }
}
