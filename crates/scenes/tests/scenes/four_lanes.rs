//! Four numbers side by side, against each alone.

use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::exact::{Batch, FreeMotion, Instant};
use tumbling::number::Lane;
use tumbling_scenes::four_lanes::FourLanes;

fn four(x: [f64; 4]) -> FourLanes {
    FourLanes::from_lanes(|k| x[k])
}

fn bits(x: FourLanes) -> [u64; 4] {
    [0, 1, 2, 3].map(|k| x.lane(k).to_bits())
}

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
        a in proptest::array::uniform4(any_number()), b in proptest::array::uniform4(any_number()),
    ) {
        let (x, y) = (four(a), four(b));
        let alone = |f: fn(f64, f64) -> f64| [0, 1, 2, 3].map(|k| f(a[k], b[k]).to_bits());
        let same = |found: FourLanes, expected: [u64; 4]| {
            let nan = |bits: u64| f64::from_bits(bits).is_nan();
            bits(found).iter().zip(&expected).all(|(f, e)| f == e || (nan(*f) && nan(*e)))
        };
        prop_assert!(same(x + y, alone(|a, b| a + b)));
        prop_assert!(same(x - y, alone(|a, b| a - b)));
        prop_assert!(same(x * y, alone(|a, b| a * b)));
        prop_assert!(same(x / y, alone(|a, b| a / b)));
        prop_assert!(same(-x, alone(|a, _| -a)));
        prop_assert!(same(x.abs().sqrt(), alone(|a, _| a.abs().sqrt())));
        prop_assert!(same(x.round_ties_even(), alone(|a, _| a.round_ties_even())));
        prop_assert!(same(x.sign(), alone(|a, _| 1_f64.copysign(a))));
        let lesser = alone(|a, b| if a < b { a } else { b });
        prop_assert!(same(FourLanes::select(x.lt(y), x, y), lesser));
        let (left, product) = (alone(|a, b| a.mul_add(b, -(a * b))), x * y);
        prop_assert!(same(x.two_product_error(y, product), left) || left.iter().any(|x| f64::from_bits(*x).is_nan()));
    }
}
/// In every order of its axes, both ways round, at every size, some of them turned.
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
        let mut seen = 0;
        let mut alone = |time: usize, body: usize, found: &Instant| {
            seen += 1;
            assert_eq!(bits(found), bits(&all[body].at(times[time]).unwrap()), "{body} at {:e}", times[time]);
        };
        Batch::<FourLanes>::new(&all).each(&times, |time, body, at: Instant| alone(time, body, &at)).unwrap();
        Batch::<f64>::new(&all).each(&times, |time, body, at: Instant| alone(time, body, &at)).unwrap();
        assert_eq!(seen, 2 * all.len() * times.len());
        let spins = Batch::<FourLanes, Vector3<f64>>::new(&all).each(&times, |time, body, spin| {
            assert_eq!(spin_bits(&spin), spin_bits(&all[body].omega(times[time]).unwrap()));
        });
        spins.unwrap();
    }
}
