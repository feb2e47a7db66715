//! The nearest moments that a body can have, for those whose digits were rounded.

use super::ascending;
use crate::error::{Error, Refusal};
use nalgebra::Vector3;

/// The moments nearest to `moments`, in any order, that a body can have: none below zero, none above the sum
/// of the other two.
///
/// Possible moments form a cone whose edges are the rods, (0, 1, 1) and its like, and whose faces are the
/// flat bodies. What lies outside is projected onto the flat bodies; if that leaves a moment below zero, onto
/// the rods; and if they are all on the far side, onto zero.
///
/// They also give the nearest tensor in the Frobenius norm, with the principal axes of the one given: no two
/// symmetric matrices are nearer than their sorted eigenvalues are [HW53](crate::references).
pub(super) fn possible(moments: &Vector3<f64>) -> Vector3<f64> {
    let order = ascending(moments);
    let [a, b, c] = order.map(|i| moments[i]);
    let excess = (c - b) - a;
    let sorted = if excess <= 0.0 {
        [a, b, c]
    } else if a + excess / 3.0 > 0.0 {
        let (a, b) = (a + excess / 3.0, b + excess / 3.0);
        [a, b, a + b]
    } else {
        let rod = (0.5 * b + 0.5 * c).max(0.0);
        [0.0, rod, rod]
    };
    let mut nearest = Vector3::zeros();
    for (place, moment) in order.into_iter().zip(sorted) {
        nearest[place] = moment;
    }
    nearest
}

/// `moved` if it is within the tolerance.
pub(super) fn near_enough(moved: f64, tolerance: f64) -> Result<f64, Error> {
    if moved <= tolerance { Ok(moved) } else { Err(Refusal::TooFar { moved, tolerance }.into()) }
}

#[cfg(test)]
mod tests {
    use super::possible;
    use nalgebra::Vector3;
    use proptest::prelude::*;

    proptest! {
        /// The nearest point `p` of a cone is the one in it with `(x - p) . p = 0` and `(x - p) . r <= 0`
        /// along each edge `r`.
        #[test]
        fn the_nearest_moments_meet_the_conditions_of_a_projection_onto_the_cone_of_bodies(
            x in prop::array::uniform3(-2.0..3.0_f64),
        ) {
            let x = Vector3::from(x);
            let p = possible(&x);
            let off = x - p;
            prop_assert!((0..3).all(|i| p[i] >= 0.0 && p[i] <= (p[(i + 1) % 3] + p[(i + 2) % 3]) * (1.0 + 1e-15)));
            prop_assert!(off.dot(&p).abs() <= 1e-14, "{x:?} {p:?}: {:e}", off.dot(&p));
            for axis in 0..3 {
                prop_assert!(off[(axis + 1) % 3] + off[(axis + 2) % 3] <= 1e-14, "{x:?} {p:?}");
            }
        }
    }

    #[test]
    fn each_way_out_of_the_cone_leads_to_the_nearest_flat_body_or_rod() {
        // Excess 0.3: a third of it on each moment. A negative moment: the rod with the mean of the other
        // two.
        let flat = possible(&Vector3::new(1.0, 3.3, 2.0));
        assert!((flat - Vector3::new(1.1, 3.2, 2.1)).amax() < 1e-15, "{flat:?}");
        assert_eq!(possible(&Vector3::new(1.0, -0.25, 1.25)), Vector3::new(1.125, 0.0, 1.125));
        assert_eq!(possible(&Vector3::new(-1.0, -0.25, -2.0)), Vector3::zeros());
    }
}
