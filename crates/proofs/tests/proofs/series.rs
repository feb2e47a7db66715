//! Roots, sines and exponentials of power series.

use num_traits::{One, Zero};
use tumbling::number::Analytic;
use tumbling_proofs::{Rational, Series};

type Powers = Series<Rational>;

fn sample() -> Powers {
    let h = Powers::step(6);
    let two = Powers::constant(Rational::from(2));
    two * h.clone() - h.clone() * h.clone() * Powers::constant(Rational::new(1, 3))
        + h.clone() * h.clone() * h
}

#[test]
fn the_sine_and_cosine_of_a_series_have_squares_that_sum_to_one() {
    let (s, c) = sample().sin_cos();
    assert_eq!(s.clone() * s.clone() + c.clone() * c.clone(), Powers::one());
    assert_eq!(Powers::step(5).sin_cos().0.to_string(), "h - 1/6 h^3 + 1/120 h^5 + ...");
    assert_eq!(Powers::step(4).sin_cos().1.to_string(), "1 - 1/2 h^2 + 1/24 h^4 + ...");
    // cos(r) and sin(r)/r by the square of r.
    let (cosine, sinc) = (sample() * sample()).cos_sinc_of_root();
    assert_eq!((cosine, sinc * sample()), (c.clone(), s.clone()));
    // The addition theorem ties the two series to one another.
    let (s2, _) = (sample() + sample()).sin_cos();
    assert_eq!(s2, s.clone() * c.clone() + c * s);
}

#[test]
fn the_exponential_of_a_sum_is_the_product() {
    let (a, b) = (sample(), Powers::step(6));
    assert_eq!((a.clone() + b.clone()).exp(), a.exp() * b.exp());
    assert_eq!(Powers::step(3).exp().to_string(), "1 + h + 1/2 h^2 + 1/6 h^3 + ...");
}

#[test]
fn the_square_of_the_root_is_the_series_and_irrational_values_are_undefined() {
    let square = Powers::constant(Rational::new(49, 4)) + sample();
    assert_eq!(square.sqrt() * square.sqrt(), square);
    assert_eq!(Powers::constant(Rational::new(9, 16)).sqrt(), Powers::constant(Rational::new(3, 4)));
    let one = Powers::one;
    assert!((Powers::constant(Rational::from(2)) + sample()).sqrt().is_undefined());
    assert!((one() + sample()).exp().is_undefined());
    assert!((one() + sample()).sin_cos().0.is_undefined());
    assert!((-one() + sample()).sqrt().is_undefined());
    assert!(sample().sqrt().is_undefined(), "its root has half powers");
}

#[test]
fn sizes_fall_with_the_lowest_power_and_vanish_for_zero_alone() {
    let h = Powers::step(3);
    assert_eq!([Powers::one().size(), h.size(), (h.clone() * h).size()], [1.0, 0.5, 0.25]);
    assert_eq!(Powers::zero().size(), 0.0);
    assert!((Powers::one() / Powers::zero()).size().is_nan());
}
