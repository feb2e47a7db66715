//! The fast sums against the recurrence itself.

use super::*;
use crate::attitude::product;
use crate::inertia::PrincipalMoments;
use crate::step::system::System;
use crate::step::torque::Torque;

/// The recurrences of Euler's equations `I w' = I w x w + a x g + T`, with `g' = g x w` for gravity in body
/// axes, and of `q' = q w / 2`. Coefficient `n + 1` is the sum of all products of coefficients whose powers
/// add up to `n`, divided by `n + 1`.
#[test]
fn the_fast_sums_are_those_of_the_recurrence() {
    let (moments, arm) = (Vector3::new(1.0, 1.7, 2.4), Vector3::new(0.1, -0.2, 0.4));
    let (thrust, weight) = (Vector3::new(0.3, 0.1, -0.2), Vector3::new(0.0, 0.0, -1.5));
    let torques = vec![Torque::InBody(thrust), Torque::Aligning { arm, field: weight }];
    let system = System::with(PrincipalMoments::try_from(moments).unwrap(), torques).unwrap();
    let law = Law::of(&system, 1.0).unwrap();
    let start = Quaternion::new(0.5, -0.1, 0.7, 0.2).normalize();
    let spin = Vector3::new(0.5, 2.0, -0.4);
    let mut fast = Series::<LENGTH>::new(&law, false);
    fast.begin(&law, &Now::default(), &start, spin.into());
    fast.extend_to(MOST, &law);

    let (mut q, mut w, mut g) = (vec![start], vec![spin], vec![rotate_inverse(&start, &weight)]);
    for n in 0..MOST {
        let inverse = 1.0 / (n + 1) as f64;
        let sum =
            |term: &dyn Fn(usize, usize) -> Vector3<f64>| (0..=n).map(|k| term(k, n - k)).sum::<Vector3<_>>();
        let turn = (0..=n).fold(Quaternion::new(0.0, 0.0, 0.0, 0.0), |sum, k| {
            sum + product(&q[k], &Quaternion::from_parts(0.0, w[n - k]))
        });
        let torque = arm.cross(&g[n]) + if n == 0 { thrust } else { Vector3::zeros() };
        let gyroscopic = sum(&|j, k| moments.component_mul(&w[j]).cross(&w[k]));
        let turned = sum(&|j, k| g[j].cross(&w[k]));
        q.push(turn * (0.5 * inverse));
        w.push((gyroscopic + torque).component_div(&moments) * inverse);
        g.push(turned * inverse);
    }
    for n in 0..=MOST {
        let [attitude, spin] = [fast.attitude.up[n], fast.spin.up[n]];
        let off = Vector3::new(spin[0], spin[1], spin[2]) - w[n];
        assert!(off.norm() < 1e-13 * w[n].norm(), "{n}: {off}");
        let [w, x, z, less_y] = attitude;
        let off = Quaternion::new(w, x, -less_y, z) - q[n];
        assert!(off.norm() < 1e-13 * q[n].norm(), "{n}: {off}");
    }
}
