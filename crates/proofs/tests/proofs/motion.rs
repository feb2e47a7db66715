//! The enclosed motion against 40 digits, and boxes of moments, spins and times.

use nalgebra::Vector3;
use proptest::prelude::*;
use serde_json::Value;
use tumbling::PrincipalMoments;
use tumbling_proofs::interval::motion::FreeMotion;
use tumbling_proofs::{Interval, Rational, given};

fn point(x: f64) -> Interval {
    Rational::of_f64(x).into()
}

fn texts(value: &Value) -> impl Iterator<Item = &str> {
    value.as_array().unwrap().iter().map(|x| x.as_str().unwrap())
}

/// The floats that a table's inputs are.
fn inputs(value: &Value) -> Vec<Interval> {
    texts(value).map(|text| point(text.parse().unwrap())).collect()
}

/// The numbers of a table, with half a unit of their last digit on either side.
fn truths(value: &Value, sign: i64) -> Vec<[Rational; 2]> {
    let both = |text: &str| {
        let number = Rational::of_decimal(&text.replace('+', "")).unwrap() * Rational::from(sign);
        let (mantissa, power) = text.split_once('E').unwrap_or((text, "0"));
        let decimals = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
        let power: i32 = power.parse().unwrap();
        let half = Rational::of_decimal(&format!("5e{}", power - decimals as i32 - 1)).unwrap();
        [number.clone() - half.clone(), number + half]
    };
    texts(value).map(both).collect()
}

fn meets(x: Interval, [low, high]: &[Rational; 2]) -> bool {
    let (below, above) = (Rational::of_f64(x.low()), Rational::of_f64(x.high()));
    below <= *high && above >= *low
}

fn widest<'a>(x: impl IntoIterator<Item = &'a Interval>) -> f64 {
    x.into_iter().map(|x| x.width()).fold(0.0, f64::max)
}

/// Every asymmetric motion of a table at every time; how many instants there are, and the widest spin (for
/// its size) and attitude in roundings times what a rounding of the inputs makes of them.
fn contained(table: &str) -> (usize, [f64; 2]) {
    let file: Value = serde_json::from_str(table).unwrap();
    let (mut instants, mut worst) = (0, [0.0_f64; 2]);
    for case in file["cases"].as_array().unwrap() {
        let [moments, omega] = ["inertia", "w0"].map(|field| Vector3::from_vec(inputs(&case[field])));
        let Ok(motion) = FreeMotion::new(&moments, &omega) else {
            assert!(case["kind"] != "gen", "{}", case["name"]);
            continue;
        };
        for (k, t) in inputs(&case["t"]).into_iter().enumerate() {
            let name = format!("{} at {t}", case["name"]);
            let (spin, turn) = motion.at(t);
            let spins = truths(&case["w"][k], 1);
            assert!(spin.iter().zip(&spins).all(|(x, truth)| meets(*x, truth)), "{name}: {spin:?}");
            let turns = [1, -1].map(|sign| truths(&case["q"][k], sign));
            let ours = [turn.coords.w, turn.coords.x, turn.coords.y, turn.coords.z];
            let same = |turn: &[[Rational; 2]]| ours.iter().zip(turn).all(|(x, truth)| meets(*x, truth));
            assert!(turns.iter().any(|turn| same(turn)), "{name}: {turn:?}");
            let size = spin.iter().map(|x| x.abs().high()).fold(0.0, f64::max);
            for (i, (column, width)) in
                [("kappa_w", widest(spin.iter()) / size), ("kappa_q", widest(&ours))].into_iter().enumerate()
            {
                let kappa =
                    case[column].as_array().map_or(1.0, |all| all[k].as_str().unwrap().parse().unwrap());
                worst[i] = worst[i].max(width / (f64::max(kappa, 1.0) * f64::EPSILON / 2.0));
            }
            instants += 1;
        }
    }
    (instants, worst)
}

#[test]
fn the_enclosures_contain_40_digits_and_are_narrow() {
    let tables = [
        include_str!("../../../../tests/data/free-motion.json"),
        include_str!("../../../../tests/data/sweep.json"),
        include_str!("../../../../tests/data/late.json"),
    ];
    let found = tables.map(contained);
    assert!(found[0].0 > 100 && found[1].0 > 300 && found[2].0 == 24, "{found:?}");
    assert!(found.iter().all(|(_, widths)| widths[0] < 6e4 && widths[1] < 4e3), "{found:?}");
}

/// A body, a spin and a time, without symmetry.
fn tumble() -> impl Strategy<Value = ([f64; 3], [f64; 3], f64)> {
    let moments = (1.0..1.6_f64, 1.7..2.2_f64, 2.3..2.6_f64, 0..3_usize).prop_map(|(a, b, c, turn)| {
        let mut moments = [a, b, c];
        moments.rotate_left(turn);
        moments
    });
    (moments, prop::array::uniform3(-4.0..4.0_f64), -9.0..9.0_f64)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 400, ..ProptestConfig::default() })]

    /// The library's float answer for numbers in a box, which is off by less than 1e-12 here.
    #[test]
    fn what_lies_in_the_box_moves_in_the_enclosure(
        (moments, omega, t) in tumble(), size in 0..5_i32, shares in prop::array::uniform7(0.0..1.0_f64),
    ) {
        let size = 10_f64.powi(-2 * size - 2);
        let inputs = [&moments[..], &omega[..], &[t]].concat();
        let wide = |x: &f64| point(*x).hull(point(x + size));
        let boxes: Vec<_> = inputs.iter().map(wide).collect();
        let inside: Vec<_> = inputs.iter().zip(shares).map(|(x, share)| (x + share * size).min(x + size)).collect();
        let [moments, omega] = [0, 3].map(|k| Vector3::from_column_slice(&boxes[k..k + 3]));
        let Ok(enclosed) = FreeMotion::new(&moments, &omega) else { return Ok(()) };
        let moments = PrincipalMoments::new(inside[0], inside[1], inside[2]).unwrap();
        let motion = tumbling::exact::FreeMotion::new(moments, &Vector3::from_column_slice(&inside[3..6])).unwrap();
        let at = motion.at(inside[6]).unwrap();
        let (spin, turn) = enclosed.at(boxes[6]);
        let near = |x: &Interval, y: f64| x.low() - 1e-12 <= y && y <= x.high() + 1e-12;
        prop_assert!(spin.iter().zip(&at.omega).all(|(x, y)| near(x, *y)), "{spin:?} {}", at.omega);
        let same = |sign: f64| turn.coords.iter().zip(&at.attitude.coords).all(|(x, y)| near(x, sign * y));
        prop_assert!(same(1.0) || same(-1.0), "{turn:?} {}", at.attitude);
        let momentum = enclosed.momentum(boxes[6]);
        prop_assert!((0..3).all(|k| near(&momentum[k], moments[k] * at.omega[k])));
        let flips = (0..).map(|number| enclosed.flip(number)).zip(motion.flips(0.0, 1e3).unwrap()).take(3);
        prop_assert!(flips.into_iter().all(|(seen, flip)| seen.low() - 1e-9 <= flip && flip <= seen.high() + 1e-9));
    }
}

#[test]
fn a_time_that_is_open_by_flips_leaves_the_spin_open_but_not_beyond_what_it_can_be() {
    let moments = Vector3::new(given!(1), given!(2), given!(3));
    let motion = FreeMotion::new(&moments, &Vector3::new(given!(1), given!(1), given!(2))).unwrap();
    let any = given!(Interval: 0).hull(given!(100));
    let (spin, _) = motion.at(any);
    // Twice the energy is 15, so that no component is above the root of 15.
    assert!(spin.iter().all(|x| x.abs().high() < 4.0), "{spin:?}");
    let open = motion.at(given!(Interval: 0).hull(given!(1e30))).0;
    assert!(open.iter().all(|x| x.width() == f64::INFINITY));
}
