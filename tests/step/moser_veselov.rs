//! The discrete Moser-Veselov algorithm where its equation has more than one root, or none near.

use super::free;
use crate::common::*;
use nalgebra::{Quaternion, Vector3};
use tumbling::ErrorKind;
use tumbling::step::{Method, State};

#[test]
fn the_other_root_of_the_moser_veselov_equation_is_refused_by_its_turn() {
    let moments = Vector3::new(1.126028325178734, 0.49960972808046744, 0.8697129298264454);
    let momentum = Vector3::new(-1.018519532854051, -0.5850619803087775, -1.5600563168390509);
    let system = free(moments);
    let start = State { attitude: Quaternion::identity(), momentum };
    // 4.5 rad: the step that was taken here came back 100 % wrong.
    let step = Method::MoserVeselov10.step(&system, &start, 1.8665812127762909);
    refused(step, ErrorKind::OutOfBounds, "turn");
    // About a principal axis the equation is sin(angle) = h w: of its two roots the one below a quarter turn
    // is taken.
    let steady = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.0, 0.0, moments.z) };
    let end = Method::MoserVeselov2.step(&system, &steady, 0.999).unwrap();
    assert!((2.0 * end.attitude.k.asin() - 0.999_f64.asin()).abs() < 1e-12);
    assert!(Method::MoserVeselov2.step(&system, &steady, 1.001).is_err());
}

#[test]
fn a_long_moser_veselov_step_comes_back_or_is_refused() {
    let mut random = same_bits::Random(12345);
    let is_one = |method: &&Method| method.info().name.starts_with("Moser");
    for &method in Method::ALL.iter().filter(is_one).cycle().take(20_000) {
        let halves = random.vector().abs().add_scalar(0.01);
        let moments = halves + halves.yzx();
        let system = free(moments);
        let momentum = random.vector();
        let start = State { attitude: Quaternion::identity(), momentum };
        let h = 4.0 * random.signed().abs();
        let Ok(end) = method.step(&system, &start, h) else { continue };
        let back = method.step(&system, &end, -h).unwrap();
        let off = (back.momentum - momentum).norm();
        assert!(off < 1e-12, "{method} of {moments:?} by {h} from {momentum:?}: {off:e}");
    }
}
