//! Four masses on two crossed rods, seen from a frame that turns steadily about the momentum, and how they
//! are pulled there.

use crate::{Why, motion};
use exchange::Numbers;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::dynamics::euler;
use tumbling::inertia::point_mass;
use tumbling::number::Analytic;

/// Masses, kg, and places, m: the heavy pair on z, the light one on x.
const MASSES: [(f64, [f64; 3]); 4] =
    [(1.0, [0.0, 0.0, 0.2]), (1.0, [0.0, 0.0, -0.2]), (0.5, [0.2, 0.0, 0.0]), (0.5, [-0.2, 0.0, 0.0])];

/// The moments about x, y and z, kg m².
pub(crate) fn moments() -> Vector3<f64> {
    MASSES.iter().map(|(mass, place)| point_mass(mass, &Vector3::from(*place)).diagonal()).sum()
}

/// The prepared motion of the rods at `t`, in a frame that turns about the momentum at `rate`, rad/s, and
/// agrees with the world at time 0. Of each mass: its place, m, the centrifugal force and the Coriolis force
/// on it, N. Then the twist by the centrifugal forces, N m, which is the right-hand side of Euler's equations
/// for a spin as the frame's; and the period of the spin in the body, s, NaN where it has none.
pub(crate) fn pulls([t, rate]: [f64; 2], row: &Numbers) -> Result<usize, Why> {
    let (motion, _, moments) = motion()?;
    let (start, now) = (motion.at(0.0)?, motion.at(t)?);
    let up = moments.component_mul(&start.omega).normalize();
    let (sin, cos) = Analytic::sin_cos(&(0.5 * rate * t));
    let frame = UnitQuaternion::new_unchecked(Quaternion::from_parts(cos, -sin * up));
    let turns = frame * (now.attitude * now.omega) - rate * up;
    let attitude = frame * now.attitude;
    let mut place = 0;
    for (mass, at) in MASSES {
        let at = attitude * Vector3::from(at);
        let out = mass * rate * rate * (at - up.dot(&at) * up);
        for vector in [at, out, -2.0 * mass * rate * up.cross(&turns.cross(&at))] {
            place = row.fill_from(place, vector.as_slice());
        }
    }
    let twist = attitude * euler::coupling(&moments, &(attitude.inverse() * (rate * up)));
    let place = row.fill_from(place, twist.as_slice());
    Ok(row.fill_from(place, &[motion.period()?.unwrap_or(f64::NAN)]))
}

#[cfg(test)]
mod tests {
    use super::MASSES;
    use crate::answer;
    use crate::tests::ALONE;
    use exchange::Numbers;
    use nalgebra::Vector3;
    use std::sync::PoisonError;

    /// The forces of the frame alone, with rods that only hold: their twist is the rate of the angular
    /// momentum there, however fast the frame turns.
    #[test]
    fn in_the_turning_frame_the_two_forces_twist_the_rods_as_newton_says() {
        let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        let row = Numbers::empty();
        assert_eq!(answer(12, &row), 3);
        let moments = row.take::<3>(0);
        for (got, right) in moments.into_iter().zip([0.08, 0.12, 0.04]) {
            assert!((got - right).abs() < 1e-16, "{moments:?}");
        }
        let [x, y, z] = moments;
        row.fill(&[9.0, 0.0, 0.0, 3.0, x, y, z, 2.0, 0.3, 0.7]);
        assert_eq!(answer(0, &row), 17);
        for rate in [2.0, 3.1] {
            let at = |t: f64| {
                row.fill(&[t, rate]);
                assert_eq!(answer(11, &row), 40);
                let of = |part: usize| {
                    std::array::from_fn::<_, 4, _>(|i| Vector3::from(row.take::<3>(9 * i + 3 * part)))
                };
                (of(0), of(1), of(2), Vector3::from(row.take::<3>(36)))
            };
            let twist = |places: &[Vector3<f64>; 4], forces: &[Vector3<f64>; 4]| -> Vector3<f64> {
                places.iter().zip(forces).map(|(r, f)| r.cross(f)).sum()
            };
            let (t, h) = (1.3, 1e-4);
            let (places, out, aside, coupling) = at(t);
            assert!((twist(&places, &out) - coupling).amax() < 1e-15, "{coupling}");
            let ([before, ..], [after, ..]) = ([at(t - h).0], [at(t + h).0]);
            let rate_of_momentum: Vector3<f64> = (0..4)
                .map(|i| MASSES[i].0 * places[i].cross(&(after[i] - 2.0 * places[i] + before[i])) / (h * h))
                .sum();
            let all = twist(&places, &out) + twist(&places, &aside);
            assert!((all - rate_of_momentum).amax() < 1e-6, "{all} {rate_of_momentum}");
            assert!(all.amax() > 0.01);
        }
    }
}
