//! How an error grows with time, in numbers and in words.

use crate::common::{MOMENTS, exact};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling_judge::{Growth, Law, LawName, Options, Row, Verdict, judge_in_memory};

const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);

/// A record of the exact motion, its attitude and spin altered at each time.
fn a_record(
    rows: u32,
    alter: impl Fn(f64, Quaternion<f64>, Vector3<f64>) -> (Option<Quaternion<f64>>, Vector3<f64>),
) -> Verdict {
    let rows = exact(SPIN, 0.01, rows - 1).into_iter().map(|(time, q, spin)| {
        let (attitude, spin) = alter(time, q, spin);
        Row { time, attitude: attitude.map(|q| [q.w, q.i, q.j, q.k]), spin: spin.into() }
    });
    judge_in_memory(MOMENTS.into(), rows, &Options::default()).unwrap()
}

fn law(verdict: &Verdict, name: LawName) -> Growth {
    verdict.laws.iter().find(|law| law.name == name).unwrap().growth
}

/// How the error of the energy grows where the energy has changed at each time by a factor, of this natural
/// logarithm.
fn of_energy(rows: u32, logarithm: fn(f64) -> f64) -> Growth {
    let verdict = a_record(rows, |t, _, spin| (None, spin * (0.5 * logarithm(t)).exp()));
    law(&verdict, LawName::Energy)
}

/// How the error of the momentum's direction grows where it has turned in the world by an angle at each time.
fn of_direction(rows: u32, angle: fn(f64) -> f64) -> Growth {
    let (_, start, spin) = exact(SPIN, 0.01, 0)[0];
    let momentum = UnitQuaternion::from_quaternion(start) * MOMENTS.component_mul(&spin);
    let across = momentum.cross(&Vector3::x()).normalize();
    let turned = |t: f64| UnitQuaternion::from_scaled_axis(across * angle(t)).into_inner();
    law(&a_record(rows, |t, q, spin| (Some(turned(t) * q), spin)), LawName::Direction)
}

#[test]
fn each_way_to_grow_is_distinguished_from_the_others_whatever_the_length() {
    let near = |x: f64, wanted: f64| (x / wanted - 1.0).abs() < 1e-6;
    for rows in [300, 3000] {
        assert_eq!(of_energy(rows, |t| 1e-14 * t.sin()), Growth::Rounding);
        assert_eq!(of_energy(rows, |t| 1e-3 * (9.0 * t).sin()), Growth::Bounded);
        let walk = of_energy(rows, |t| 1e-5 * t.sqrt());
        assert!(matches!(walk, Growth::RandomWalk { rate } if near(rate, 1e-5)), "{walk:?}");
        let linear = of_energy(rows, |t| -1e-5 * t);
        assert!(matches!(linear, Growth::Linear { rate } if near(rate, -1e-5)), "{linear:?}");
        let exponential = of_energy(rows, |t| -0.1 * t);
        assert!(matches!(exponential, Growth::Exponential { rate } if near(rate, -0.1)), "{exponential:?}");
        let power = of_direction(rows, |t| 1e-5 * t * t);
        assert!(matches!(power, Growth::Power { power } if near(power, 2.0)), "{power:?}");
    }
    // Measured from the first row, it is an exponential less 1, which a fit from a sixteenth of the time on
    // takes to grow faster by a thousandth.
    let rises = of_direction(3000, |t| 1e-13 * t.exp());
    assert!(matches!(rises, Growth::Exponential { rate } if (rate - 1.001).abs() < 1e-3), "{rises:?}");
}

fn said(name: LawName, growth: Growth) -> String {
    Law { name, growth, most: 1.0, last: 1.0 }.plain()
}

#[test]
fn a_rate_is_given_as_what_a_second_makes_of_it() {
    // e^1.58 = 4.855, e^0.02 = 1.0202, ln 10 / 100 = 0.02303.
    let exponential = |rate| said(LawName::Energy, Growth::Exponential { rate });
    assert_eq!(exponential(-1.58), "exponential: shrinks by a factor of 4.85 a second");
    assert_eq!(exponential(1.58), "exponential: grows by a factor of 4.85 a second");
    assert_eq!(exponential(0.02), "exponential: grows by 2.02 % a second");
    assert_eq!(exponential(-0.02), "exponential: shrinks by 1.98 % a second");
    assert_eq!(exponential(100.0), "exponential: grows tenfold every 0.0230 s");
    assert_eq!(exponential(f64::INFINITY), "exponential: beyond counting");
    let linear = |name, rate| said(name, Growth::Linear { rate });
    assert_eq!(linear(LawName::Momentum, -1.5e-7), "linear: falls by 1.50 · 10⁻⁷ of itself a second");
    assert_eq!(linear(LawName::Momentum, 0.012345), "linear: grows by 0.0123 of itself a second");
    assert_eq!(linear(LawName::Momentum, 0.0), "linear: grows by 0 of itself a second");
    assert_eq!(linear(LawName::Phase, -1.58), "linear: falls behind by 1.58 periods a second");
    assert_eq!(linear(LawName::Direction, 0.5), "linear: turns away by 0.500 rad a second");
    assert_eq!(
        said(LawName::Direction, Growth::RandomWalk { rate: 2e12 }),
        "random walk: 2.00 · 10¹² rad in a second, tenfold in a hundred"
    );
    assert_eq!(
        said(LawName::Energy, Growth::Power { power: 2.04 }),
        "faster than linear: as time to the power 2.0"
    );
    assert_eq!(said(LawName::Unit, Growth::Bounded), "bounded");
}
