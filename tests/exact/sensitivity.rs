//! Derivatives of the exact motion against differences with hundreds of digits, and against laws that they
//! must obey.

mod any_axes;

use super::{ROUNDING, motion};
use crate::common::*;
use nalgebra::{Matrix3, SMatrix, Vector3, Vector6};
use proptest::prelude::*;
use serde_json::Value;
use tumbling::exact::FreeMotion;
use tumbling::{Error, ErrorKind};

const NAMES: [&str; 4] = ["spin by spin", "spin by tensor", "turn by spin", "turn by tensor"];

type ByTensor = SMatrix<f64, 3, 6>;

/// The derivatives of a motion that starts along its principal axes, with the turn in the world.
#[derive(Debug, PartialEq)]
struct Derivatives {
    omega_by_omega: Matrix3<f64>,
    omega_by_tensor: ByTensor,
    turn_by_omega: Matrix3<f64>,
    turn_by_tensor: ByTensor,
}

fn derivatives(motion: &FreeMotion, t: f64) -> Result<Derivatives, Error> {
    let (transition, by_tensor) = motion.sensitivities(t)?;
    let rotation = motion.at(t)?.attitude.to_rotation_matrix();
    Ok(Derivatives {
        omega_by_omega: transition.fixed_view::<3, 3>(3, 3).into(),
        omega_by_tensor: by_tensor.fixed_rows::<3>(3).into(),
        turn_by_omega: rotation * transition.fixed_view::<3, 3>(0, 3),
        turn_by_tensor: rotation * by_tensor.fixed_rows::<3>(0),
    })
}

/// The root of the sum of the squares, of numbers of any size.
fn norm<const N: usize>(m: &SMatrix<f64, 3, N>) -> f64 {
    let size = m.amax();
    if size > 0.0 { size * (m / size).norm() } else { 0.0 }
}

/// The condition of the angle that the body has spun through, and of the derivatives with it, for one
/// rounding of the spin or of the time: that angle in radians, or 1.
fn condition(omega: &Vector3<f64>, t: f64) -> f64 {
    (omega.norm() * t.abs()).max(1.0)
}

/// Error of a block relative to its own norm, in roundings times the condition.
fn units<const N: usize>(found: &SMatrix<f64, 3, N>, exact: &SMatrix<f64, 3, N>, condition: f64) -> f64 {
    let off = norm(&(found - exact));
    if off == 0.0 { 0.0 } else { off / norm(exact) / (ROUNDING * condition) }
}

/// The worst errors of the four blocks, and where.
fn judge(table: &str) -> [(f64, String); 4] {
    let file: Value = serde_json::from_str(table).unwrap();
    let number = |x: &Value| x.as_str().unwrap().parse::<f64>().unwrap();
    let vector = |x: &Value| Vector3::from_iterator(x.as_array().unwrap().iter().map(number));
    let mut worst = [(); 4].map(|()| (0.0, String::new()));
    for case in file["cases"].as_array().unwrap() {
        let (moments, omega, t) = (vector(&case["inertia"]), vector(&case["w0"]), number(&case["t"]));
        let column =
            |k: usize| Vector6::from_iterator(case["columns"][k].as_array().unwrap().iter().map(number));
        let exact: SMatrix<f64, 6, 9> = SMatrix::from_columns(&std::array::from_fn::<_, 9, _>(column));
        let found = derivatives(&free_motion(moments, &omega), t).unwrap();
        let condition = condition(&omega, t);
        let units = [
            units(&found.omega_by_omega, &exact.fixed_view::<3, 3>(0, 0).into(), condition),
            units(&found.omega_by_tensor, &exact.fixed_view::<3, 6>(0, 3).into(), condition),
            units(&found.turn_by_omega, &exact.fixed_view::<3, 3>(3, 0).into(), condition),
            units(&found.turn_by_tensor, &exact.fixed_view::<3, 6>(3, 3).into(), condition),
        ];
        for (worst, units) in worst.iter_mut().zip(units) {
            if units.is_nan() || units > worst.0 {
                let motion = format!("{:?} {:?}", moments.as_slice(), omega.as_slice());
                *worst = (units, format!("{} {motion} at {t:e}", case["family"]));
            }
        }
    }
    worst
}

#[test]
fn the_derivatives_agree_with_differences_of_many_digits_in_every_regime() {
    for (name, (units, at)) in NAMES.iter().zip(judge(include_str!("../data/sensitivity.json"))) {
        assert!(units <= 8.0, "{name}: {units} {at}");
    }
}

/// Spins of about 1 rad/s: oblique, or near one of the axes by down to 1e-12, or without one component, of
/// either sign of zero: half-way round Jacobi's circle, where signs are easily confused.
fn spin() -> impl Strategy<Value = Vector3<f64>> {
    let near = (generic_spin(), 0..3_usize, 0.0..12.0_f64).prop_map(|(spin, axis, digits)| {
        let push = 10_f64.powf(-digits);
        Vector3::from_fn(|k, _| if k == axis { spin[k] } else { push * spin[k] })
    });
    let without = (generic_spin(), 0..3_usize)
        .prop_map(|(spin, axis)| Vector3::from_fn(|k, _| if k == axis { 0.0 * spin[k] } else { spin[k] }));
    prop_oneof![generic_spin(), near, without]
}

/// Those of [`moments`], and bodies near spheres, tops, and needles.
fn body() -> impl Strategy<Value = Vector3<f64>> {
    let near =
        (0.0..12.0_f64, 0.1..0.9_f64, 0..3_usize, 0..4_usize).prop_map(|(digits, share, first, kind)| {
            let small = 10_f64.powf(-digits);
            let moments = match kind {
                0 => [1.0, 1.0 + share * small, 1.0 + small],
                1 => [small, 1.0, 1.0 + share * small],
                2 => [1.0, 1.0 + small, 1.0 + share],
                _ => [1.0, 1.0, 1.0 + share],
            };
            Vector3::from_fn(|k, _| moments[(k + first) % 3])
        });
    prop_oneof![moments(), near]
}

/// Of short spans, and of some turns.
fn time() -> impl Strategy<Value = f64> {
    prop_oneof![
        -20.0..20.0_f64,
        (-9.0..0.0_f64, any::<bool>()).prop_map(|(e, back)| {
            let t = 10_f64.powf(e);
            if back { -t } else { t }
        })
    ]
}

/// Checks that two sides agree to some roundings of the terms in their sums.
fn agree<const N: usize>(
    left: &SMatrix<f64, 3, N>,
    right: &SMatrix<f64, 3, N>,
    size: f64,
    condition: f64,
) -> bool {
    norm(&(left - right)) <= 32.0 * ROUNDING * condition * size
}

fn diagonal(v: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::from_diagonal(v)
}

proptest! {
    // The momentum in the world is the start's, so its change is too: R (I dw + dI w) + turn x L = dL.
    #[test]
    fn the_change_of_momentum_in_the_world_is_that_of_the_start(m in body(), omega in spin(), t in time()) {
        let motion = free_motion(m, &omega);
        let (at, change) = (motion.at(t).unwrap(), derivatives(&motion, t).unwrap());
        let rotation = at.attitude.to_rotation_matrix().into_inner();
        let tensor = diagonal(&m);
        let momentum = m.component_mul(&omega);
        let turned = |turn: &Matrix3<f64>| -momentum.cross_matrix() * turn;
        let condition = condition(&omega, t);
        let by_spin = rotation * tensor * change.omega_by_omega + turned(&change.turn_by_omega);
        let size = norm(&(tensor * change.omega_by_omega)) + momentum.norm() * norm(&change.turn_by_omega);
        prop_assert!(agree(&by_spin, &tensor, size, condition), "{by_spin}");
        let [spin_by, turn_by] = [change.omega_by_tensor, change.turn_by_tensor]
            .map(|by_tensor| by_tensor.fixed_columns::<3>(0).into_owned());
        let by_moments = rotation * (tensor * spin_by + diagonal(&at.omega)) + turned(&turn_by);
        // The accuracy is relative to the norm of the whole derivative by the tensor: its columns may have
        // any size.
        let size = norm(&(tensor * change.omega_by_tensor)) + omega.norm()
            + momentum.norm() * norm(&change.turn_by_tensor);
        prop_assert!(agree(&by_moments, &diagonal(&omega), size, condition), "{by_moments}");
    }
}

#[test]
fn at_the_start_the_change_is_the_one_that_is_made() {
    for omega in [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.3, -0.7, 1e-300], [2.0, 1.0, 1.0]] {
        let change = derivatives(&motion([3.0, 4.0, 6.0], omega), 0.0).unwrap();
        assert_eq!(change.omega_by_omega, Matrix3::identity());
        assert_eq!(change.turn_by_omega, Matrix3::zeros());
        assert_eq!((change.omega_by_tensor, change.turn_by_tensor), (ByTensor::zeros(), ByTensor::zeros()));
    }
}

#[test]
fn derivatives_beyond_f64_are_refused() {
    let refused = |omega: [f64; 3], t: f64| {
        motion([3.0, 4.0, 6.0], omega)
            .state_transition(t)
            .is_err_and(|error| error.kind() == ErrorKind::Unrepresentable)
    };
    // The rate about the middle axis is 1/3: grown e^(1500/3) fold it fits, e^(3000/3) fold not.
    assert!(!refused([0.0, 1.0, 0.0], 1500.0));
    assert!(refused([0.0, 1.0, 0.0], 3000.0));
    // So on the separatrix.
    assert!(!refused([2.0, 1.0, 1.0], 300.0));
    assert!(refused([2.0, 1.0, 1.0], 3000.0));
}
