//! The curves of the spin: the polhode in the body, the herpolhode in the world.

use crate::common::*;
use proptest::prelude::*;
use tumbling::exact::FreeMotion;

proptest! {
    #[test]
    fn the_herpolhode_lies_in_the_invariable_plane(m in moments(), omega in generic_spin()) {
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let momentum = m.component_mul(&omega);
        let height = momentum.dot(&omega);
        for k in 0..50 {
            let at = motion.at(30.0 / 49.0 * f64::from(k)).unwrap();
            let point = at.attitude * at.omega;
            prop_assert!((point.dot(&momentum) / height - 1.0).abs() < 1e-13);
        }
    }
}
