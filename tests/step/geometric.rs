//! Methods that keep the laws of motion, tested against rounding, long runs, torques and nonsense.

use super::{apart, energy, free, start};
use crate::common::*;
use nalgebra::{Quaternion, Vector3};
use proptest::prelude::*;
use tumbling::ErrorKind;
use tumbling::step::{Method, State, System, fixed_rate};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Steps of a hundredth of a radian up to ten, of any body, flat and needle-like ones among them.
    #[test]
    fn a_reversible_step_that_is_taken_is_undone_by_the_step_back(
        halves in [0.0..1.0_f64, 0.0..1.0, 0.0..1.0],
        thin in prop::sample::select(vec![1.0, 1e-3, 1e-6]),
        momentum in crate::common::vector(3.0),
        turn in -2.0..1.0_f64,
    ) {
        let [x, y, z] = [halves[0], halves[1], halves[2] * thin];
        let moments = Vector3::new(y + z, z + x, x + y);
        let Ok(moments) = moments.try_into() else { return Ok(()) };
        let Ok(system) = System::free(moments) else { return Ok(()) };
        let start = State { attitude: Quaternion::identity(), momentum };
        let h = 10.0_f64.powf(turn) / system.omega(&momentum).norm();
        for &method in Method::ALL.iter().filter(|method| method.info().reversible) {
            let Ok(end) = method.step(&system, &start, h) else { continue };
            match method.step(&system, &end, -h) {
                Ok(back) => {
                    // Roundings are stretched by as much as a nudge is: long steps of thin bodies turn by
                    // many radians.
                    let nudge = Vector3::repeat(1e-9 * momentum.norm());
                    let nudged = State { momentum: end.momentum + nudge, ..end };
                    let Ok(other) = method.step(&system, &nudged, -h) else { continue };
                    let stretch = apart(&other, &back) / 1e-9;
                    // Beyond that no digit of the way back is left: nine splittings of a needle over many
                    // radians.
                    if stretch < 1e6 {
                        let bound = 1e-12 * stretch.max(1.0);
                        prop_assert!(apart(&back, &start) < bound, "{method:?} {h}: {:e}", apart(&back, &start));
                    }
                }
                // Found in this number of rounds forward, and in a few more backward.
                Err(error) if error.to_string().contains("was not found in 200 rounds") => (),
                Err(error) if error.to_string().contains("several solutions") => (),
                Err(error) => prop_assert!(false, "{method:?} {h}: {error}"),
            }
        }
    }

}

#[test]
fn the_energy_of_the_splittings_swings_and_does_not_grow() {
    let system = free([1.0, 2.0, 2.5]);
    let start = start(&system, &Vector3::new(1.0, 1.5, -0.8));
    for method in [
        Method::RotationSplitting2,
        Method::RotationSplitting4,
        Method::RotationSplitting6,
        Method::SymmetricTop,
    ] {
        let mut worst = [0.0_f64; 2];
        let mut motion = start;
        for k in 0..20_000 {
            motion = method.step(&system, &motion, 0.1).unwrap();
            let off = (energy(&system, &motion) / energy(&system, &start) - 1.0).abs();
            worst[k / 10_000] = worst[k / 10_000].max(off);
        }
        assert!(worst[1] < 1.01 * worst[0], "{method:?}: {worst:?}");
    }
}

#[test]
fn a_step_too_long_for_an_implicit_method_is_refused() {
    let system = free([1.0, 2.0, 2.5]);
    let start = start(&system, &Vector3::new(1.0, 1.5, -0.8));
    // A turn by p takes h L / 2 = p0 K p + p x K p, whose size is at most that of K p: with |L| about 3.7, no
    // turn takes a step of 3 s.
    let long = Method::MoserVeselov2.step(&system, &start, 3.0);
    refused(long, ErrorKind::NotConverged, "a Moser-Veselov step was not found in");
    refused(fixed_rate(&system, &start, 1000.0), ErrorKind::OutOfBounds, "it must be below 500");
}
