//! The coefficients of the longest splitting: its step is composed of them, and exact ones lie next to them.
//!
//! A symmetric composition of a symmetric method of order 2 has order 6 if its coefficients satisfy four
//! conditions ([HLW06](tumbling::references), V.3). Decimals satisfy them up to a residue, `F`. With `A` near
//! the inverse of the matrix of derivatives, `x - A F(x)` maps a ball around the decimals into itself and is
//! a contraction there: at its fixed point `F` is zero.

use crate::number::{Fraction, Rational};
use crate::proof::{Outcome, Residue};
use crate::proofs::methods::{alike, cases, step};
use crate::proofs::order::{Number, components, constant};
use crate::symbols::variables;
use crate::tex::Scope;
use crate::{Interval, given};
use nalgebra::{Matrix4, Vector4};
use num_traits::{One, Zero};
use tumbling::step::Method;

/// The coefficients of the library; the first is free.
const SHARES: [&str; 5] = [
    "0.392161444007314139279250560",
    "0.332599136789359438599748634",
    "-0.706246172557639359809964820",
    "0.082213596293550800231490449",
    "0.798543990934829963398950353",
];
const NAMES: [&str; 4] = ["b", "c", "d", "e"];

proofs! {
    "step" {
        [Numbers] "exact-shares-of-order-6": shares(5),
            r"Nine of the library's steps of order 2 with five decimal shares, and these backwards, make its splitting of order 6, through the power 7 of the step from a start in exact fractions. Within a septillionth of the last $n = 4$ shares there are exact ones that with the first have the sum 1, third and fifth powers with the sum 0, and also third powers, each times the square of the sum of the shares before it and half of its own, with the sum 0. That these conditions give order 6 is no part of it.";
            but "fourth powers for the fifth": shares(4),
    }
}

fn shares(power: u32) -> Result<Scope, Residue> {
    let shares = SHARES.map(Rational::of_literal);
    made_of(&shares).and_then(|()| nearby(&shares, power))
}

fn made_of(shares: &[Rational; 5]) -> Outcome {
    const LAST: usize = 7;
    let ([(system, start), _], h) = (cases(), Number::step(LAST));
    let whole = components(&step(Method::RotationSplitting6, &system, &start, &h)?);
    let mut parts = start;
    for k in [0, 1, 2, 3, 4, 3, 2, 1, 0] {
        let share = constant(&shares[k].clone().into());
        parts = step(Method::RotationSplitting2, &system, &parts, &(share * h.clone()))?;
    }
    alike("the splitting", Method::RotationSplitting2, &whole, &components(&parts), 0..=LAST)
}

fn nearby(shares: &[Rational; 5], power: u32) -> Result<Scope, Residue> {
    let ([b, c, d, e], a) = (variables(NAMES), Fraction::from(shares[0].clone()));
    let mut left = [-Fraction::one(), Fraction::zero(), Fraction::zero(), Fraction::zero()];
    let mut before = Fraction::zero();
    for share in [&a, &b, &c, &d, &e, &d, &c, &b, &a] {
        let (cube, middle) = (share.pow(3), &before + share * Fraction::ratio(1, 2));
        let terms = [share.clone(), cube.clone(), share.pow(power), cube * middle.pow(2)];
        left.iter_mut().zip(terms).for_each(|(left, term)| *left += term);
        before += share.clone();
    }
    let decimals: Vec<_> = NAMES.into_iter().zip(shares[1..].iter().cloned()).collect();
    let slopes = Matrix4::from_fn(|i, j| left[i].derivative(&NAMES[j].into()));
    let inverse = slopes.map(|x| x.at(&decimals).to_f64()).try_inverse();
    let inverse = inverse.ok_or_else(|| Residue::Missing { claim: "an inverse".to_owned() })?;
    let inverse = inverse.map(|x| Interval::from(Rational::of_f64(x)));
    let (one, ball, wide): (Interval, Interval, Interval) = (given!(1), given!(1e-24), given!(1e-10));
    let around = |name: &str| {
        let (_, decimal) = decimals.iter().find(|known| known.0 == name)?;
        let decimal = Interval::from(decimal.clone());
        Some((decimal - wide).hull(decimal + wide))
    };
    let slopes = slopes.map(|x| x.evaluate(|symbol| around(symbol.name())).unwrap_or(Interval::ALL));
    let rest = Matrix4::identity() - inverse * slopes;
    let moved = inverse * Vector4::from(left.map(|x| Interval::from(x.at(&decimals))));
    let stays = |i: &usize| {
        let drawn = rest.row(*i).iter().fold(Interval::zero(), |sum, x| sum + x.abs());
        moved[*i].abs() < (one - drawn) * ball
    };
    Ok(Scope::default().with("n", Fraction::from((0..4).filter(stays).count() as i64)))
}
