//! Numbers side by side have the bits of each alone.

use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::exact::{Batch, FreeMotion, Instant};
use tumbling::laws::Lane;
use tumbling_scenes::tested::{Lanes, side_by_side};

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        proptest::num::f64::ANY.prop_filter("a number", |x| !x.is_nan()),
        -1e3..1e3_f64,
        Just(-0.0),
        Just(0.5),
        Just(-1.5)
    ]
}

proptest! {
    // Independent: the same operation on each number alone.
    #[test]
    fn every_operation_rounds_in_every_lane_as_it_does_alone(
        a in proptest::array::uniform8(any_number()), b in proptest::array::uniform8(any_number()),
    ) {
        rounds_as_alone::<Lanes<4, false>>(&a, &b);
        rounds_as_alone::<Lanes<4, true>>(&a, &b);
    }
}

fn rounds_as_alone<T: Lane>(a: &[f64; 8], b: &[f64; 8]) {
    let (x, y) = (T::from_lanes(|k| a[k]), T::from_lanes(|k| b[k]));
    let same = |found: T, alone: fn(f64, f64) -> f64| {
        let both = |k: usize| [found.lane(k), alone(a[k], b[k])];
        let equal = |[x, y]: [f64; 2]| x.to_bits() == y.to_bits() || (x.is_nan() && y.is_nan());
        assert!((0..T::WIDTH).all(|k| equal(both(k))), "{found:?} of {a:?} and {b:?}");
    };
    same(x + y, |a, b| a + b);
    same(x - y, |a, b| a - b);
    same(x * y, |a, b| a * b);
    same(x / y, |a, b| a / b);
    same(-x, |a, _| -a);
    same(x.abs().sqrt(), |a, _| a.abs().sqrt());
    same(x.round_ties_even(), |a, _| a.round_ties_even());
    same(x.sign(), |a, _| 1_f64.copysign(a));
    same(T::select(x.lt(y), x, y), |a, b| if a < b { a } else { b });
    let left = |a: f64, b: f64| a.mul_add(b, -(a * b));
    // Where the product leaves the range nothing is promised.
    if (0..T::WIDTH).all(|k| !left(a[k], b[k]).is_nan()) {
        same(x.two_product_error(y, x * y), left);
    }
}

/// Motions of every kind: with their axes in every order, spun both ways, at every size, half of them
/// starting turned.
fn every_kind() -> Vec<FreeMotion> {
    let kinds: [([f64; 3], [f64; 3]); 12] = [
        ([2.0, 2.0, 2.0], [0.3, -1.0, 0.7]),
        ([1.0, 2.0, 2.5], [0.0, 0.0, 0.0]),
        ([1.0, 2.0, 2.5], [0.0, -3.0, 0.0]),
        ([2.0, 2.0, 3.0], [0.4, 0.5, -1.0]),
        ([2.0, 2.0, 1.0], [0.4, 0.5, 1.0]),
        ([1.0, 2.0, 2.5], [0.2, 0.3, 1.1]),
        ([1.0, 2.0, 2.5], [1.3, 0.2, -0.1]),
        ([1.0, 2.0, 2.5], [0.01, 1.0, 0.02]),
        ([1.0, 2.0, 2.5], [0.02, -1.0, 1e-3]),
        ([1.0, 2.0, 2.5], [1e-90, 1.0, 2e-90]),
        ([1.0, 2.0, 2.5], [1e-9, 1e-9, 1.0]),
        // 6 (6-4) w3² = 3 (4-3) w1² exactly.
        ([3.0, 4.0, 6.0], [2.0, 1.0, 1.0]),
    ];
    let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let mut all = Vec::new();
    for (moments, omega) in kinds {
        for (n, order) in orders.into_iter().enumerate() {
            for scale in [1.0, -1.0, 1e-150, 1e150, 1e-200] {
                let [moments, omega] = [moments, omega].map(|v| Vector3::from(order.map(|i| v[i])));
                let motion = FreeMotion::new(moments.try_into().unwrap(), &(omega * scale)).unwrap();
                let attitude = UnitQuaternion::from_euler_angles(0.3 * n as f64, -1.0, 2.0);
                all.push(if n % 2 == 0 { motion } else { motion.with_attitude(attitude).unwrap() });
            }
        }
    }
    all
}

#[test]
fn bodies_of_every_kind_and_size_answer_in_lanes_as_each_does_alone_to_the_bit() {
    let all = every_kind();
    let kinds = all.iter().map(|motion| std::mem::discriminant(&motion.regime()));
    assert_eq!(kinds.collect::<std::collections::HashSet<_>>().len(), 5, "a kind is missing");
    // The signs of zeros too.
    let spin_bits = |w: &Vector3<f64>| [w.x, w.y, w.z].map(f64::to_bits);
    let bits = |at: &Instant| (spin_bits(&at.omega), <[f64; 4]>::from(at.attitude.coords).map(f64::to_bits));
    for speed in [1.0, 1e-150, 1e150] {
        let times = [0.0, 1e-300, 0.37, -2.0, 11.0, 1e3, -1e9, 1e17, 1e300]
            .map(|t: f64| (t / speed).clamp(-1e305, 1e305));
        // More than are computed in one go.
        let times = [times, times.map(|t| 0.7 * t)].concat();
        let mut seen = 0;
        let mut alone = |time: usize, body: usize, found: &Instant| {
            seen += 1;
            let there = all[body].at(times[time]).unwrap();
            assert_eq!(bits(found), bits(&there), "{body} at {:e}", times[time]);
        };
        Batch::<f64>::new(&all).each(&times, |time, body, at: Instant| alone(time, body, &at)).unwrap();
        let put = |time, body, at: Instant| alone(time, body, &at);
        Batch::<Lanes<4, false>>::new(&all).each(&times, put).unwrap();
        // In the lanes and the version for this processor's vectors.
        let put = &mut |time, body, omega, attitude: Option<_>| {
            alone(time, body, &Instant { omega, attitude: attitude.unwrap() });
        };
        side_by_side(&all, true)(&times, put).unwrap();
        let put = &mut |time: usize, body: usize, spin, _| {
            assert_eq!(spin_bits(&spin), spin_bits(&all[body].omega(times[time]).unwrap()));
        };
        side_by_side(&all, false)(&times, put).unwrap();
        assert_eq!(seen, 3 * all.len() * times.len());
    }
}
