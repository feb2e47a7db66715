//! The curves of the spin: the polhode in the body, the herpolhode in the world.

use super::motion;
use crate::common::*;
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::exact::FreeMotion;

proptest! {
    #[test]
    fn the_herpolhode_lies_in_the_invariable_plane(m in moments(), omega in generic_spin()) {
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let momentum = m.component_mul(&omega);
        let height = momentum.dot(&omega);
        for point in motion.herpolhode(30.0, 50).unwrap() {
            prop_assert!((point.dot(&momentum) / height - 1.0).abs() < 1e-13);
        }
    }
}

#[test]
fn a_herpolhode_runs_from_the_start_to_the_end_of_its_time() {
    let motion = motion([1.0, 2.0, 2.5], [0.3, 1.0, -0.4]);
    let at = |t: f64| motion.at(t).unwrap().omega_world();
    assert_eq!(motion.herpolhode(9.0, 4).unwrap(), [0.0, 3.0, 6.0, 9.0].map(at));
    assert_eq!(motion.herpolhode(9.0, 2).unwrap(), [0.0, 9.0].map(at));
    assert_eq!(motion.herpolhode(9.0, 1).unwrap(), [at(0.0)]);
    assert!(motion.herpolhode(9.0, 0).unwrap().is_empty());
    assert!(motion.herpolhode(f64::INFINITY, 3).is_err());
}

#[test]
fn a_curve_of_more_points_than_memory_holds_is_refused() {
    let motion = motion([1.0, 2.0, 3.0], [0.1, 1.0, 0.3]);
    let kind = |points: Result<Vec<_>, tumbling::Error>| points.unwrap_err().kind();
    assert_eq!(kind(motion.polhode(usize::MAX)), tumbling::ErrorKind::TooMany);
    assert_eq!(kind(motion.herpolhode(9.0, usize::MAX)), tumbling::ErrorKind::TooMany);
}

#[test]
fn a_polhode_goes_round_once_in_even_steps() {
    let motion = motion([1.0, 2.0, 2.5], [0.3, 1.0, -0.4]);
    let period = motion.period().unwrap().unwrap();
    let points = motion.polhode(4).unwrap();
    for (k, point) in points.iter().enumerate() {
        assert_eq!(*point, motion.omega(0.25 * period * k as f64).unwrap());
    }
    // It circles the third axis (L² is above 2 E I2): half round, the other two components have changed sign.
    assert!(points.len() == 4 && (points[2] - Vector3::new(-0.3, -1.0, -0.4)).norm() < 1e-14);
}
