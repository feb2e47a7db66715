//! Kicks: the change of the momentum by torques alone.

use crate::body::State;
use crate::step::{System, Torque};
use nalgebra::{Quaternion, Vector3};

#[test]
fn damping_however_strong_slows_a_kick_and_never_turns_it_round() {
    let moments = Vector3::new(1.0, 2.0, 2.6);
    let from = State { attitude: Quaternion::identity(), momentum: Vector3::new(1.0, 2.0, -3.0) };
    for strength in [1e-2, 1.0, 1e2, 1e4, 1e6] {
        let drag = vec![Torque::Damping(Vector3::new(strength, 0.5 * strength, 2.0 * strength))];
        let system = System::with(moments.try_into().unwrap(), drag).unwrap();
        let kicked = system.kick(&from, 1.0);
        for i in 0..3 {
            let left = kicked.momentum[i] / from.momentum[i];
            assert!((0.0..1.0).contains(&left), "{strength}: {left}");
        }
    }
}

#[test]
fn loss_inside_a_body_in_one_long_kick_is_the_limit_of_many_short_ones() {
    let moments = Vector3::new(1.0, 2.0, 2.6);
    let system = System::with(moments.try_into().unwrap(), vec![Torque::Dissipation(0.7)]).unwrap();
    let from = State { attitude: Quaternion::identity(), momentum: Vector3::new(1.0, 0.2, -0.3) };
    let once = system.kick(&from, 2.0);
    let many = (0..64).fold(from, |motion, _| system.kick(&motion, 2.0 / 64.0));
    assert!((once.momentum - many.momentum).norm() < 1e-13);
    // Its rate at the start is the torque.
    let h = 1e-6;
    let rate = (system.kick(&from, h).momentum - system.kick(&from, -h).momentum) / (2.0 * h);
    assert!((rate - system.torque(&from)).norm() < 1e-8);
    let far = system.kick(&from, 1e300);
    assert!((far.momentum - Vector3::new(0.0, 0.0, -from.momentum.norm())).norm() < 1e-15, "{far:?}");
}

#[test]
fn dissipation_is_the_same_in_every_unit_of_momentum() {
    let system = System::of_numbers(Vector3::new(1.0, 2.0, 2.5), vec![Torque::Dissipation(1.0)]);
    let momentum = Vector3::new(1.0, 0.2, -0.3);
    let kick = |scale: f64, time: f64| {
        let start = State { attitude: Quaternion::identity(), momentum: momentum * scale };
        system.kick(&start, time).momentum / scale
    };
    let plain = kick(1.0, 0.7);
    // Its rate goes with the square of the momentum.
    assert!((kick(2_f64.powi(40), 0.7 * 2_f64.powi(-80)) - plain).norm() < 1e-15);
    for scale in [1e-300, 1e-160, 1e160, 1e300] {
        let still = kick(scale, 0.0);
        assert!((still - momentum).norm() < 1e-15, "{scale:e}: {still}");
    }
    assert!((kick(1e200, 1.0) - Vector3::new(0.0, 0.0, -momentum.norm())).norm() < 1e-15);
}

/// The last kind of torque first: the way back.
#[test]
fn the_adjoint_kick_undoes_a_kick() {
    let torques = vec![Torque::InBody(Vector3::x()), Torque::Damping(Vector3::new(1.0, 1.0, 1.0))];
    let system = System::with(Vector3::new(1.0, 1.2, 1.1).try_into().unwrap(), torques).unwrap();
    let start = State { attitude: Quaternion::identity(), momentum: Vector3::x() };
    let end = system.adjoint_kick(&system.kick(&start, 0.1), -0.1);
    assert!((end.momentum - start.momentum).norm() < 1e-15);
}
