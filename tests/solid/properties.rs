//! Parts, places and axes: the parallel-axis theorem, turning, and what is refused.

use super::shared::{assert_same, moved, size, together, vector};
use crate::common::{any_vector, anything, refused};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use num_rational::Ratio;
use proptest::prelude::*;
use tumbling::solid::*;
use tumbling::{ErrorKind, Inertia};

fn attitude() -> impl Strategy<Value = UnitQuaternion<f64>> {
    proptest::array::uniform4(-1.0..1.0_f64)
        .prop_filter("no direction", |q| q.iter().map(|x| x * x).sum::<f64>() > 0.01)
        .prop_map(|[w, x, y, z]| UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)))
}

/// A lopsided body: its centre is nowhere special and all its products are there.
fn lopsided() -> MassProperties {
    let turn = UnitQuaternion::from_euler_angles(0.3, -0.7, 1.1);
    Compound::new()
        .at(Cuboid::new(1.0, 2.0, 3.5).unwrap().with_mass(2.0).unwrap(), &Vector3::new(0.1, -0.2, 0.3))
        .at(
            Cone::new(0.5, 2.0).unwrap().with_mass(1.5).unwrap().turned(turn).unwrap(),
            &Vector3::new(1.0, 2.0, -1.0),
        )
        .at(ThinRod::new(3.0).unwrap().with_mass(0.4).unwrap(), &Vector3::new(-1.0, 0.5, 0.25))
        .properties()
        .unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    // Independent: the definition, on four point masses turned one by one.
    #[test]
    fn a_turned_body_is_the_body_of_its_turned_points(q in attitude(), far in vector(-3.0..3.0)) {
        let points = [
            (1.0, Vector3::new(1.0, 0.5, -0.25)),
            (2.5, Vector3::new(-1.0, 2.0, 0.0)),
            (0.5, Vector3::new(0.0, -1.0, 3.0)),
            (1.25, far),
        ];
        let turned = points.map(|(m, p)| (m, q * p));
        let whole = MassProperties::of_points(&points).unwrap().turned(q).unwrap();
        assert_same("points", &MassProperties::of_points(&turned).unwrap(), &whole, 1e-14, 10.0);
    }

    #[test]
    fn point_masses_match_their_sums_in_fractions(
        masses in proptest::array::uniform4(1_u8..9), places in proptest::array::uniform12(-9_i8..9),
    ) {
        let place = |i: usize| Vector3::new(places[3 * i], places[3 * i + 1], places[3 * i + 2]);
        prop_assume!((1..4).any(|i| place(i) != place(0)));
        let exact: Vec<_> = (0..4)
            .map(|i| MassMoments {
                mass: Ratio::from_integer(i128::from(masses[i])),
                centre: place(i).map(|x| Ratio::from_integer(x.into())),
                inertia: nalgebra::Matrix3::zeros(),
            })
            .collect();
        let exact = combined(&exact, &Vector3::repeat(Ratio::from_integer(0)));
        let float: Vec<_> = (0..4).map(|i| (f64::from(masses[i]), place(i).map(f64::from))).collect();
        let ours = MassProperties::of_points(&float).unwrap();
        let to_f64 = |q: &Ratio<i128>| *q.numer() as f64 / *q.denom() as f64;
        let inertia = exact.inertia.map(|x| to_f64(&x));
        let off = (ours.inertia().matrix() - inertia).amax();
        prop_assert!(off <= 1e-14 * inertia.amax(), "{off:e}");
        prop_assert!((ours.centre() - exact.centre.map(|x| to_f64(&x))).amax() <= 1e-14 * 9.0);
    }

    #[test]
    fn any_numbers_at_all_give_properties_or_a_typed_error(
        mass in anything(), at in any_vector(), moments in any_vector(), offset in any_vector(),
        q in proptest::array::uniform4(anything()),
    ) {
        let [w, x, y, z] = q;
        let attitude = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
        let inertia = Inertia::from_moments(moments.x, moments.y, moments.z);
        let inertia = inertia.unwrap_or(Inertia::from_moments(1.0, 2.0, 2.5).unwrap());
        let body = MassProperties::new(mass, &at, inertia);
        let body = body.unwrap_or(MassProperties::new(1.0, &Vector3::zeros(), inertia).unwrap());
        let turn = UnitQuaternion::from_euler_angles(1.0, 2.0, 3.0);
        let results = [
            Ok(body),
            moved(&body, &offset),
            body.turned(attitude),
            body.turned(turn),
            body.about(&offset).and_then(|i| MassProperties::new(1.0, &offset, i)),
            together(&[body, lopsided()]),
            moved(&body, &offset).and_then(|moved| together(&[body, moved])),
            body.turned(attitude).and_then(|body| Compound::new().at(lopsided(), &Vector3::zeros()).at(body, &offset).properties()),
            MassProperties::of_points(&[(mass, at), (1.0, offset)]),
        ];
        for result in results {
            match result {
                Ok(p) => {
                    prop_assert!(p.mass() > 0.0 && p.mass().is_finite());
                    prop_assert!(p.centre().iter().chain(p.inertia().matrix().iter()).all(|x| x.is_finite()));
                    prop_assert!(p.inertia().matrix().diagonal().max() > 0.0);
                }
                Err(e) => prop_assert!(!e.to_string().is_empty()),
            }
        }
    }

    #[test]
    fn masses_on_one_line_make_a_rod_that_can_be_turned_and_joined(q in attitude(), a in size(), b in size()) {
        let line = MassProperties::of_points(&[
            (1.0, Vector3::new(0.0, 0.0, -a)), (2.0, Vector3::zeros()), (0.5, Vector3::new(0.0, 0.0, b)),
        ]).unwrap();
        prop_assert_eq!(line.inertia().matrix()[(2, 2)], 0.0);
        let singular = line.inertia().inverse().is_err_and(|error| error.kind() == ErrorKind::NotInvertible);
        prop_assert!(singular);
        let cross = together(&[line, line.turned(q).unwrap()]).unwrap();
        prop_assert!((cross.mass() - 7.0).abs() < 1e-15);
    }
}

// A box and a ball, near and 2^30 m away: offsets are exact there, so not a digit may change.
#[test]
fn a_body_far_from_the_origin_keeps_every_digit() {
    let far = Vector3::new(2.0_f64.powi(30), -(2.0_f64.powi(29)), 2.0_f64.powi(31));
    let parts = [
        Cuboid::new(1.0, 2.0, 3.0).unwrap().with_mass(3.0).unwrap(),
        moved(&Ball::new(0.7).unwrap().with_mass(0.9).unwrap(), &Vector3::new(0.5, 1.25, -2.0)).unwrap(),
    ];
    let near = together(&parts).unwrap();
    let away = together(&parts.map(|p| moved(&p, &far).unwrap())).unwrap();
    assert_eq!(away.inertia(), near.inertia());
    assert_eq!(away.centre(), near.centre() + far);
}

#[test]
fn parts_of_opposite_extremes_combine_without_overflow_on_the_way() {
    // 1e200 apart, masses 1e-100: m d^2 / 2 with 1e-100 * 1e400 / 2 is beyond; with masses 1e-250 it is not.
    let at = |mass: f64| [(mass, Vector3::zeros()), (mass, Vector3::new(0.0, 1e200, 0.0))];
    refused(
        MassProperties::of_points(&at(1e-90)),
        ErrorKind::Unrepresentable,
        "a moment of inertia comes out as inf",
    );
    let pair = MassProperties::of_points(&at(1e-250)).unwrap();
    let moment = pair.inertia().matrix()[(0, 0)];
    assert!((moment - 5e149).abs() <= 1e-15 * moment, "{moment:e}");
}

#[test]
fn what_is_no_body_is_refused_by_name() {
    let one = Vector3::new(1.0, 2.0, 3.0);
    let too_few =
        |points: &[_], words| refused(MassProperties::of_points(points), ErrorKind::OutOfBounds, words);
    too_few(&[], "0 distinct points given: at least 2 needed");
    for points in [vec![(1.0, one)], vec![(1.0, one); 3]] {
        too_few(&points, "1 distinct points given: at least 2 needed");
    }
    let error = MassProperties::of_points(&[(1.0, one), (-2.0, Vector3::zeros())]).unwrap_err();
    assert_eq!(error.to_string(), "part 1: the mass is -2.0: it must be above zero");
    refused(together(&[]), ErrorKind::OutOfBounds, "0 parts given: at least 1 needed");
    refused(Compound::new().properties(), ErrorKind::OutOfBounds, "0 parts given: at least 1 needed");
    let nowhere = Vector3::new(0.0, f64::NAN, 0.0);
    let bad = Compound::new().at(lopsided(), &one).at(lopsided(), &nowhere).properties();
    let bad = refused(bad, ErrorKind::NotFinite, "part 1: the offset is NaN");
    let of_the_part = std::error::Error::source(&bad).unwrap();
    assert_eq!(bad.to_string(), format!("part 1: {of_the_part}"));
}
