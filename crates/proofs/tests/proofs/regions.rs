//! Integrals over solids, from the definition.

use nalgebra::Vector3;
use num_traits::{One, Zero};
use tumbling_proofs::tested::{Region, around};
use tumbling_proofs::{Fraction, Polynomial, Relations, Residue, Symbol};

/// Once around, the integral of a rate of change is nothing, and that of 1 is 2 pi: with
/// `c² + s² = 1` this settles every integral of powers of cosine and sine.
#[test]
fn around_an_angle_every_rate_of_change_sums_to_zero() {
    let [cos, sin] = ["cos", "sin"].map(Symbol::new);
    let [c, s] = ["cos", "sin"].map(Polynomial::variable);
    assert_eq!(around(&Polynomial::one(), &cos, &sin), Polynomial::from(2) * Polynomial::variable("pi"));
    for i in 0..6 {
        for j in 0..6 {
            let p = c.pow(i) * s.pow(j);
            let rate = p.derivative(&sin) * c.clone() - p.derivative(&cos) * s.clone();
            assert!(around(&rate, &cos, &sin).is_zero(), "{p}");
        }
    }
}

#[test]
fn a_region_without_three_parameters_is_refused() {
    let [u, v] = ["u", "v"].map(Fraction::variable);
    let flat = Region::new(Vector3::new(u, v, Fraction::zero()), Relations::none());
    let flat = flat.between("u", &Polynomial::zero(), &Polynomial::one());
    assert!(matches!(flat.sums(), Err(Residue::Missing { .. })));
}
