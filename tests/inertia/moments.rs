//! Principal moments: their order, what a body can have, and the nearest moments to printed ones.

use crate::common::{anything, moments, refused};
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::{Axis, ErrorKind, Inertia, PrincipalMoments, Subject};

/// The axes with the smallest, middle and largest moment.
fn order(moments: &PrincipalMoments) -> [usize; 3] {
    Axis::ALL.map(|axis| moments.axis(axis))
}

const ARRANGEMENTS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

proptest! {
    #[test]
    fn moments_stay_in_the_order_given_and_their_axes_are_sorted(given in moments()) {
        for arrangement in ARRANGEMENTS {
            let [a, b, c] = arrangement.map(|i| given[i]);
            let moments = PrincipalMoments::new(a, b, c).unwrap();
            prop_assert_eq!(moments.vector(), Vector3::new(a, b, c));
            prop_assert_eq!([moments[0], moments[1], moments[2]], <[f64; 3]>::from(moments));
            let [low, middle, high] = order(&moments);
            prop_assert!(moments[low] <= moments[middle] && moments[middle] <= moments[high]);
            prop_assert_eq!(low + middle + high, 3);
            prop_assert_eq!((moments.vector().min(), moments.vector().max()), (moments[low], moments[high]));
            prop_assert_eq!(Inertia::from(moments), Inertia::from_moments(a, b, c).unwrap());
        }
    }

    #[test]
    fn a_unit_of_mass_changes_neither_order_nor_verdict(
        given in prop::array::uniform3(0.1..2.0_f64), power in -900..900_i32,
    ) {
        let [a, b, c] = given;
        let unit = 2.0_f64.powi(power);
        let scaled = PrincipalMoments::new(a * unit, b * unit, c * unit);
        match PrincipalMoments::new(a, b, c) {
            Ok(moments) => prop_assert_eq!(order(&moments), order(&scaled.unwrap())),
            Err(error) => prop_assert_eq!(error.kind(), scaled.unwrap_err().kind()),
        }
    }

    #[test]
    fn a_body_of_three_masses_has_its_moments_and_none_flatter_than_a_plate(
        masses in prop::array::uniform3(0.01..2.0_f64), beyond in 20.0..1e6_f64,
    ) {
        let [p, q, r] = masses;
        PrincipalMoments::new(q + r, p + r, p + q).unwrap();
        let plate = PrincipalMoments::new(p, p + q, q).unwrap();
        prop_assert_eq!(plate.axis(Axis::Largest), 1);
        // Far more than rounding above a plate is refused, whichever of the three is the largest.
        let too_large = (p + q) * (1.0 + beyond * f64::EPSILON);
        for [a, b, c] in [[p, q, too_large], [too_large, p, q], [q, too_large, p]] {
            refused(PrincipalMoments::new(a, b, c), ErrorKind::Impossible, "triangle inequality");
        }
    }

    #[test]
    fn any_three_numbers_are_moments_or_refused(given in prop::array::uniform3(anything())) {
        let [a, b, c] = given;
        let possible = |m: &PrincipalMoments| {
            m.vector().min() > 0.0 && m.vector().max().is_finite()
                && m.vector().max() - m[m.axis(Axis::Middle)] <= m.vector().min() + 8.0 * f64::EPSILON * m.vector().max()
        };
        if let Ok(moments) = PrincipalMoments::new(a, b, c) {
            prop_assert!(possible(&moments) && moments.vector() == Vector3::from(given));
        }
    }
}

#[test]
fn of_equal_moments_the_one_given_first_is_the_smaller() {
    let order = |a, b, c| order(&PrincipalMoments::new(a, b, c).unwrap());
    assert_eq!(order(2.0, 1.5, 2.0), [1, 0, 2]);
    assert_eq!(order(2.0, 2.5, 2.0), [0, 2, 1]);
    assert_eq!(order(2.0, 2.0, 1.0), [2, 0, 1]);
    assert_eq!(order(0.4, 0.4, 0.4), [0, 1, 2]);
}

#[test]
fn a_plate_may_miss_the_triangle_inequality_by_four_units_in_the_last_place() {
    // Below 1 a unit in the last place is half of that at 1.
    let (a, b, unit) = (0.3125, 0.5, f64::EPSILON / 2.0);
    PrincipalMoments::new(a, a + b + 4.0 * unit, b).unwrap();
    let error = refused(
        PrincipalMoments::new(a, a + b + 5.0 * unit, b),
        ErrorKind::Impossible,
        "triangle inequality",
    );
    assert!(error.to_string().contains("within"), "{error}");
    // Too far from a possible tensor for rounded digits: the message suggests nothing.
    let error =
        refused(PrincipalMoments::new(1.0, 2.0, 3.5), ErrorKind::Impossible, "2 + 1 >= 3.5 fails by 0.5");
    assert!(!error.to_string().contains("within"), "{error}");
}

#[test]
fn moments_that_are_no_numbers_above_zero_are_refused_by_value() {
    for (value, kind) in [
        (0.0, ErrorKind::OutOfBounds),
        (-0.0, ErrorKind::OutOfBounds),
        (-1.5, ErrorKind::OutOfBounds),
        (f64::NAN, ErrorKind::NotFinite),
        (f64::INFINITY, ErrorKind::NotFinite),
    ] {
        for place in 0..3 {
            let mut given = [1.0, 1.5, 1.25];
            given[place] = value;
            let error =
                refused(PrincipalMoments::try_from(given), kind, &format!("a principal moment is {value}"));
            assert_eq!(error.subject(), Subject::PrincipalMoment);
        }
    }
}
