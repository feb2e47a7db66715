//! The path of the spin over time, and the tensor as the world sees it.

use crate::{Why, motion};
use exchange::Numbers;
use nalgebra::{Matrix3, Vector3};
use tumbling::attitude::rotation_matrix;
use tumbling::dynamics::{euler, observe};
use tumbling::inertia;

/// The most samples in one answer.
const MOST: f64 = 600.0;

/// A stretch of time, `from`, `to`, and how many samples: at each the spin along the body's axes, and that in
/// the world, rad/s.
pub(crate) fn path([from, to, samples]: [f64; 3], row: &Numbers) -> Result<usize, Why> {
    let (motion, ..) = motion()?;
    let samples = samples.clamp(2.0, MOST);
    let mut place = 0;
    for i in 0..samples as u32 {
        let now = motion.at(from + f64::from(i) / (samples - 1.0) * (to - from))?;
        place = row.fill_from(place, now.omega.as_slice());
        place = row.fill_from(place, (now.attitude * now.omega).as_slice());
    }
    Ok(place)
}

/// The instant `t`: the tensor in the world, kg m², xx, yy, zz, xy, xz, yz; the rate of the spin along the
/// body's axes, rad/s²; and the share of each axis in the energy.
pub(crate) fn turned(t: f64, row: &Numbers) -> Result<usize, Why> {
    let (motion, _, moments) = motion()?;
    let now = motion.at(t)?;
    let world = inertia::turned(&rotation_matrix(&now.attitude), &Matrix3::from_diagonal(&moments));
    let rate = euler::angular_acceleration(&moments, &now.omega, &Vector3::zeros());
    let energy = observe::energy(&now.omega, &moments.component_mul(&now.omega));
    let [x, y, z] = std::array::from_fn(|axis| {
        let mut along = Vector3::zeros();
        along[axis] = now.omega[axis];
        observe::energy(&along, &moments.component_mul(&along)) / energy
    });
    let [xx, yy, zz] = [world.m11, world.m22, world.m33];
    Ok(row.fill(&[xx, yy, zz, world.m12, world.m13, world.m23, rate.x, rate.y, rate.z, x, y, z]))
}

#[cfg(test)]
mod tests {
    use crate::answer;
    use crate::tests::ALONE;
    use exchange::Numbers;
    use nalgebra::Vector3;
    use std::sync::PoisonError;

    #[test]
    fn the_tensor_in_the_world_turns_the_spin_there_into_the_momentum() {
        let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        let row = Numbers::empty();
        row.fill(&[0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.4]);
        assert_eq!(answer(0, &row), 17);
        let momentum = Vector3::from(row.take::<3>(7));
        let mut before = Vector3::zeros();
        for (i, t) in [1.3 - 1e-5, 1.3, 1.3 + 1e-5].into_iter().enumerate() {
            row.fill(&[t, t, 2.0]);
            assert_eq!(answer(9, &row), 12);
            let (omega, world) = (Vector3::from(row.take::<3>(0)), Vector3::from(row.take::<3>(3)));
            row.set(0, t);
            assert_eq!(answer(10, &row), 12);
            let [xx, yy, zz, xy, xz, yz] = row.take(0);
            let tensor = nalgebra::Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            assert!((tensor * world - momentum).amax() < 1e-14, "{}", tensor * world);
            let rate = Vector3::from(row.take::<3>(6));
            let shares: [f64; 3] = row.take(9);
            assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-14, "{shares:?}");
            if i == 0 {
                before = omega;
            } else if i == 2 {
                assert!(((omega - before) / 2e-5 - rate).amax() < 1e-4, "{rate}");
            }
        }
    }
}
