//! The position stage in one file, as engines in Rust take it, has the bits of the library's.

mod double;
mod single;

use nalgebra::{Quaternion, Vector3};
use tumbling::step::PositionStage;

macro_rules! compared {
    ($name:ident, $real:ident, $file:ident, $of_bits:expr) => {
        #[test]
        fn $name() {
            let mut seed = 1_u64;
            let mut number = || {
                seed ^= seed << 13;
                seed ^= seed >> 7;
                seed ^= seed << 17;
                (seed >> 40) as $real / 16_777_216.0
            };
            let mut all = Vec::new();
            for round in 0..2_000 {
                let mut inverse = [0; 3].map(|_| number() + 0.0625);
                inverse[round % 3] =
                    if round % 7 == 0 { inverse[(round + 1) % 3] } else { inverse[round % 3] };
                inverse[round % 2] = if round % 11 == 0 { 0.0 } else { inverse[round % 2] };
                let frame =
                    if round % 2 == 0 { [1.0, 0.0, 0.0, 0.0] } else { [0; 4].map(|_| number() - 0.5) };
                let [w, x, y, z] = frame;
                let mut body = PositionStage::of_inverse(&Vector3::from(inverse)).unwrap();
                if round % 2 == 1 {
                    body = body.in_frame(Quaternion::new(w, x, y, z)).unwrap();
                }
                let one_file = $file::PositionStage::of_inverse(inverse, frame);
                let (mut q, mut w) =
                    ([0; 4].map(|_| number() + 0.0625), [0; 3].map(|_| 16.0 * number() - 8.0));
                for _ in 0..8 {
                    let size = number();
                    let h = size * size * size * size / 4.0 - 0.0078125;
                    let end = body.step(&Quaternion::new(q[0], q[1], q[2], q[3]), &Vector3::from(w), h);
                    let parts = one_file.step(&mut q, &mut w, h);
                    let [x, y, z, s] = end.attitude.coords.into();
                    assert_eq!((parts, q.map($of_bits)), (end.parts, [s, x, y, z].map($of_bits)), "{round}");
                    assert_eq!(w.map($of_bits), <[$real; 3]>::from(end.omega).map($of_bits), "{round}");
                }
                // At rest, about as slow as rounding, too fast for one part, and what cannot be stepped.
                w[0] *= [1.0, 0.0, $real::NAN, 50.0][if round % 17 < 4 { round % 17 } else { 0 }];
                w = if round % 5 == 0 { w.map(|x| x * $real::EPSILON) } else { w };
                all.push((body, one_file, q, w));
            }
            // Side by side, in the library and in the file, as each body alone.
            let alone = |k: usize| -> (PositionStage<$real>, Quaternion<$real>, Vector3<$real>) {
                let (body, _, [s, x, y, z], w) = all[k];
                (body, Quaternion::new(s, x, y, z), Vector3::from(w))
            };
            let mut together: Vec<_> = (0..2_000).map(|k| (alone(k), 1)).collect();
            PositionStage::step_all(
                &mut together[..],
                0..2_000,
                0.0625,
                |all, k| (&all[k].0.0, all[k].0.1, all[k].0.2),
                |all, k, end| all[k] = ((all[k].0.0, end.attitude, end.omega), end.parts),
            );
            let mut parts_seen = [false; 3];
            for (k, ((_, q, w), parts)) in together.iter().enumerate() {
                let (body, q_alone, w_alone) = alone(k);
                let end = body.step(&q_alone, &w_alone, 0.0625);
                assert_eq!((*parts, q.coords.map($of_bits)), (end.parts, end.attitude.coords.map($of_bits)));
                assert_eq!(w.map($of_bits), end.omega.map($of_bits));
                parts_seen[end.parts.min(2) as usize] = true;
            }
            assert_eq!(parts_seen, [true; 3]);
            let mut taken = [0; 2_000];
            $file::step_all(
                &mut all[..],
                0..2_000,
                0.0625,
                |all, k| (&all[k].1, all[k].2, all[k].3),
                |all, k, q, w, parts| (all[k].2, all[k].3, taken[k]) = (q, w, parts),
            );
            for (((_, _, q, w), taken), ((_, q_alone, w_alone), parts)) in
                all.iter().zip(taken).zip(&together)
            {
                assert_eq!(taken, *parts);
                let [x, y, z, s] = q_alone.coords.into();
                assert_eq!(q.map($of_bits), [s, x, y, z].map($of_bits));
                assert_eq!(w.map($of_bits), <[$real; 3]>::from(*w_alone).map($of_bits));
            }
        }
    };
}

compared!(in_single_precision, f32, single, f32::to_bits);
compared!(in_double_precision, f64, double, f64::to_bits);

#[test]
fn what_no_body_has_gives_a_constant_spin() {
    let bad: [([f64; 3], [f64; 4]); 5] = [
        ([1.0, 2.0, 3.0], [0.0; 4]),
        ([1.0, 2.0, 3.0], [1.0, f64::NAN, 0.0, 0.0]),
        ([1.0, 2.0, 3.0], [1.0, f64::INFINITY, 0.0, 0.0]),
        ([1e300, 1.0, 1e-300], [1.0, 0.0, 0.0, 0.0]),
        ([f64::NAN, 1.0, 2.0], [1.0, 0.0, 0.0, 0.0]),
    ];
    for (inverse, frame) in bad {
        let (mut q, mut w) = ([0.5, 0.5, -0.5, 0.5], [1.0, 4.0, -2.0]);
        assert_eq!(double::PositionStage::of_inverse(inverse, frame).step(&mut q, &mut w, 0.01), 1);
        assert_eq!(w, [1.0, 4.0, -2.0]);
    }
    let turned = |size: f64| {
        let (mut q, mut w) = ([0.5, 0.5, -0.5, 0.5], [1.0, 4.0, -2.0]);
        let frame = [1.0, -1.0, 1.0, 1.0].map(|x| x * size);
        double::PositionStage::of_inverse([3.0, 2.0, 1.5], frame).step(&mut q, &mut w, 0.01);
        (q, w)
    };
    let (small, large) = (2.0_f64.powi(-600), 2.0_f64.powi(600));
    assert!(turned(small) == turned(1.0) && turned(large) == turned(1.0));
}
