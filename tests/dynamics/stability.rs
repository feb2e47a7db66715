//! Growth, libration and the time between flips, against numbers computed elsewhere.

use crate::common::*;
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::dynamics::stability::{Stability, of_spin};
use tumbling::exact::time_between_flips;
use tumbling::{Axis, PrincipalMoments};

/// A spin a few units in the last place to either side of the separatrix: k'² = 2 D / Q², exactly computable.
#[test]
fn either_side_of_the_separatrix_the_time_is_right_though_the_terms_nearly_cancel() {
    // I = (1, 2, 3): D = 3 w3² - w1²; on the separatrix where w1 = sqrt(3) w3.
    let w3 = 0.75_f64;
    let on = (3.0_f64).sqrt() * w3;
    for w1 in [on.next_down(), on.next_up(), on * (1.0 + 1e-14), on * (1.0 - 1e-14)] {
        let omega = Vector3::new(w1, 0.5, w3);
        let d = exact(3.0) * exact(w3) * exact(w3) - exact(w1) * exact(w1);
        let d = rounded(&d).abs();
        // Which axis it circles makes no difference in the limit: Q² = 2 (2-1) w2² + 6 w3² and rate² = Q²/6.
        let q_squared = 2.0 * 0.25 + 6.0 * w3 * w3;
        let (rate, complement) = ((q_squared / 6.0).sqrt(), (2.0 * d / q_squared).sqrt());
        let expected = 2.0 / rate * (4.0 / complement).ln();
        let ours =
            time_between_flips(PrincipalMoments::new(1.0, 2.0, 3.0).unwrap(), &omega).unwrap().unwrap();
        assert!((ours / expected - 1.0).abs() < 1e-12, "{ours} {expected}");
    }
}

#[test]
fn steady_spins_equal_moments_and_the_separatrix_itself_never_flip() {
    let never = |moments: [f64; 3], omega: [f64; 3]| {
        time_between_flips(moments.try_into().unwrap(), &omega.into()).unwrap().is_none()
    };
    for axis in 0..3 {
        let mut omega = [0.0; 3];
        omega[axis] = -3.0;
        assert!(never([1.0, 2.0, 2.5], omega));
    }
    assert!(never([1.0, 2.0, 2.5], [0.0; 3]));
    assert!(never([2.0, 2.0, 2.0], [1.0, 2.0, 3.0]));
    assert!(never([1.0, 2.0, 2.0], [1.0, 2.0, 3.0]));
    assert!(never([2.0, 2.0, 1.0], [1.0, 2.0, 3.0]));
    // Exactly on the separatrix: 6 (6-4) w3² = 3 (4-3) w1² where w1 = 2 w3.
    assert!(never([3.0, 4.0, 6.0], [2.0, 1.0, 1.0]));
    assert!(!never([3.0, 4.0, 6.0], [2.0, 1.0, 1.0_f64.next_up()]));
}

proptest! {
    #[test]
    fn the_middle_axis_is_the_only_unstable_one(m in moments(), spin in 0.1..10.0_f64) {
        let m: [f64; 3] = m.into();
        prop_assert!(matches!(of_spin(m.try_into().unwrap(), Axis::Smallest, spin).unwrap(), Stability::Libration { .. }), "smallest");
        prop_assert!(matches!(of_spin(m.try_into().unwrap(), Axis::Middle, spin).unwrap(), Stability::Growth { .. }), "middle");
        prop_assert!(matches!(of_spin(m.try_into().unwrap(), Axis::Largest, spin).unwrap(), Stability::Libration { .. }), "largest");
    }
}

#[test]
fn a_disturbance_of_equal_moments_is_neutral_and_a_spin_that_is_no_number_is_refused() {
    assert_eq!(of_spin([1.0, 1.0, 1.5].try_into().unwrap(), Axis::Middle, 2.0).unwrap(), Stability::Neutral);
    assert_eq!(of_spin([1.0, 2.0, 2.5].try_into().unwrap(), Axis::Middle, 0.0).unwrap(), Stability::Neutral);
    assert!(of_spin([1.0, 2.0, 2.5].try_into().unwrap(), Axis::Middle, f64::NAN).is_err());
}
