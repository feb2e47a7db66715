//! Every stepping method's order and the laws it keeps, tested: its own step, run on power series with exact
//! fractions from two starts.
//!
//! A method that falls short of its order, or breaks a law, for these two bodies does so. That another has its
//! order and its laws for these is a test, as in floats but without rounding; it says nothing of other bodies.
//! The numbers are chosen so that spin, momentum and attitude have lengths without a root.

use crate::number::{Fraction, Rational, Series};
use crate::proof::{Mutant, Outcome, Proof, Residue, breaks, same};
use crate::proofs::order::exact;
use nalgebra::{Quaternion, Vector3};
use num_traits::Zero;
use tumbling::attitude;
use tumbling::step::{Method, State, System};

type Number = Series<Rational>;

/// The methods whose constants are no fractions, and are given with 27 digits. What is left over of a law
/// that they keep has 18 zeros behind the point; what is left over of one that they break has not.
const ROUNDED: &[Method] = &[Method::Gauss4, Method::Gauss6, Method::RotationSplitting6];

/// How many powers beyond its order a law is followed.
const BEYOND: usize = 4;

/// Fewer where constants have many digits, which make long fractions.
const BEYOND_ROUNDED: usize = 2;

macro_rules! methods {
    ($($name:literal $method:ident,)*) => {
        pub(super) const PROOFS: &[Proof] = &[$(Proof {
            name: $name,
            part: "step",
            statement: concat!(
                "A test on two starts, in exact fractions: one step of ", stringify!($method), " agrees with the motion of a free \
                 body through the power of the step that is said to be its order, in every component of attitude and momentum, and \
                 not through the next; and of energy, momentum, its direction in the world, the attitude's length and \
                 reversibility it keeps, through two to four powers more, those that it is said to keep, and no other. Constants \
                 that are no fractions stand with 27 digits, and what they leave over is below 1e-18. So the order is no higher \
                 and the other laws are broken; of other starts nothing is proven."
            ),
            check: || holds(Method::$method, 0),
            mutants: &[
                Mutant { change: "said to be one order better", check: || holds(Method::$method, 1) },
                Mutant {
                    change: "said to keep the energy of another body too, and the momentum in the world",
                    check: || keeps_another(Method::$method),
                },
            ],
        },)*];

        /// The methods that are tested.
        #[cfg(test)]
        const TESTED: &[Method] = &[$(Method::$method,)*];
    };
}

methods! {
    "explicit-euler" ExplicitEuler,
    "runge-kutta-4" RungeKutta4,
    "dormand-prince-5" DormandPrince5,
    "munthe-kaas-4" MuntheKaas4,
    "buss" Buss,
    "spiral" Spiral,
    "implicit-midpoint" ImplicitMidpoint,
    "gauss-4" Gauss4,
    "gauss-6" Gauss6,
    "three-rotations-2" RotationSplitting2,
    "three-rotations-4" RotationSplitting4,
    "three-rotations-6" RotationSplitting6,
    "symmetric-top-splitting" SymmetricTop,
    "moser-veselov-2" MoserVeselov2,
    "moser-veselov-4" MoserVeselov4,
    "moser-veselov-6" MoserVeselov6,
    "moser-veselov-8" MoserVeselov8,
    "moser-veselov-10" MoserVeselov10,
    "constant-spin" ConstantSpin,
    "semi-implicit-euler" SemiImplicitEuler,
    "rescaled" Rescaled,
    "rescaled-straight" RescaledLinearAttitude,
    "one-newton" ImplicitOneNewton,
    "linearised-implicit" LinearisedImplicit,
    "mean-spin-runge-kutta-4" MeanSpinRungeKutta4,
    "turned-runge-kutta-4" TurnedRungeKutta4,
}

fn number(n: i64, d: i64) -> Number {
    Series::constant(Rational::new(n, d))
}

/// Moments, spin with a length that is a fraction and momentum with one, and a unit attitude.
fn cases() -> [(System<Number>, State<Number>); 2] {
    let vector = |x: [i64; 3], d: i64| Vector3::from(x.map(|n| number(n, d)));
    let case = |moments: Vector3<Number>, omega: Vector3<Number>, q: [i64; 4], length: i64| {
        let momentum = moments.component_mul(&omega);
        let [w, x, y, z] = q.map(|n| number(n, length));
        let motion = State { attitude: Quaternion::new(w, x, y, z), momentum };
        (System::of_numbers(moments, Vec::new()), motion)
    };
    [
        // |w| = 7 and |L| = 11; |w| = 3/2 and |L| = 9/2.
        case(vector([2, 4, 3], 2), vector([2, 3, 6], 1), [1, 3, 1, 5], 6),
        case(vector([8, 4, 7], 2), vector([1, -2, 2], 2), [4, -2, 2, 1], 5),
    ]
}

/// What may be left over of a law that holds: nothing, or what rounded constants leave.
fn slack(method: Method) -> Rational {
    let billionth = || Rational::new(1, 1_000_000_000);
    if ROUNDED.contains(&method) { billionth() * billionth() } else { Rational::zero() }
}

fn same_series(
    claim: &str,
    a: &Number,
    b: &Number,
    powers: std::ops::RangeInclusive<usize>,
    slack: &Rational,
) -> Outcome {
    for power in powers {
        let claim = format!("{claim}, power {power} of the step");
        match a.coefficient(power).zip(b.coefficient(power)) {
            Some((x, y)) if near(&x, &y, slack) => {}
            Some((x, y)) => same(&claim, &Fraction::from(x), &Fraction::from(y))?,
            None => return Err(Residue::Missing { claim }),
        }
    }
    Ok(())
}

fn beyond(method: Method) -> usize {
    if ROUNDED.contains(&method) { BEYOND_ROUNDED } else { BEYOND }
}

fn near(x: &Rational, y: &Rational, slack: &Rational) -> bool {
    let off = x.clone() - y.clone();
    !slack.is_zero() && off.clone() * off < slack.clone() * slack.clone()
}

fn step(
    method: Method,
    system: &System<Number>,
    start: &State<Number>,
    h: &Number,
) -> Result<State<Number>, Residue> {
    method.step(system, start, h.clone()).map_err(|error| Residue::Missing { claim: error.to_string() })
}

fn holds(method: Method, more: usize) -> Outcome {
    let order = method.info().order as usize + more;
    for (system, start) in &cases() {
        let h = Number::step(order + 1);
        let end = step(method, system, start, &h)?;
        let truth = exact(start, order + 1, |motion| system.rate(motion));
        let all =
            |m: &State<Number>| m.attitude.coords.iter().chain(&m.momentum).cloned().collect::<Vec<_>>();
        let agree = |powers: std::ops::RangeInclusive<usize>| {
            all(&end)
                .iter()
                .zip(all(&truth))
                .try_for_each(|(a, b)| same_series("the motion", a, &b, powers.clone(), &slack(method)))
        };
        agree(0..=order)?;
        breaks("the next power does not agree", agree(order + 1..=order + 1))?;
    }
    laws(method)
}

/// Twice the energy of a motion.
fn energy(system: &System<Number>, motion: &State<Number>) -> Number {
    motion.momentum.dot(&system.omega(&motion.momentum))
}

fn laws(method: Method) -> Outcome {
    let keeps = method.info().conserved;
    let order = method.info().order as usize + beyond(method);
    let said = [keeps.energy, keeps.momentum, keeps.direction, keeps.unit, keeps.reversible];
    // What one body keeps by chance the other must break.
    let mut kept = [true; 5];
    for (system, start) in &cases() {
        let h = Number::step(order);
        let end = step(method, system, start, &h)?;
        let back = step(method, system, &end, &-h)?;
        let square = |m: &State<Number>| m.attitude.coords.dot(&m.attitude.coords);
        let world = |m: &State<Number>| attitude::rotation_matrix(&m.attitude) * &m.momentum;
        let stretched = world(start).map(|x| x * square(&end));
        let alike = |claim: &str, a: &[Number], b: &[Number]| {
            a.iter().zip(b).try_for_each(|(a, b)| same_series(claim, a, b, 0..=order, &slack(method)))
        };
        let all =
            |m: &State<Number>| m.attitude.coords.iter().chain(&m.momentum).cloned().collect::<Vec<_>>();
        let found = [
            alike("the energy", &[energy(system, &end)], &[energy(system, start)]),
            alike("the momentum", &[end.momentum.dot(&end.momentum)], &[start.momentum.dot(&start.momentum)]),
            alike("the momentum in the world", world(&end).as_slice(), stretched.as_slice()),
            alike("the attitude's length", &[square(&end)], &[square(start)]),
            alike("the way back", &all(&back), &all(start)),
        ];
        for (k, found) in found.into_iter().enumerate() {
            kept[k] &= found.is_ok();
            if said[k] {
                found?;
            }
        }
    }
    let names = ["energy", "momentum", "direction", "length", "way back"];
    match (0..5).find(|&k| kept[k] && !said[k]) {
        Some(k) => Err(Residue::Missing { claim: format!("{} said to be broken is kept", names[k]) }),
        None => Ok(()),
    }
}

fn keeps_another(method: Method) -> Outcome {
    let order = method.info().order as usize + beyond(method);
    let [(system, start), (other, _)] = &cases();
    let end = step(method, system, start, &Number::step(order))?;
    same_series(
        "the energy of another body",
        &energy(other, &end),
        &energy(other, start),
        0..=order,
        &slack(method),
    )?;
    // A spin that stays in the body keeps any body's energy.
    let world = |m: &State<Number>| attitude::rotation_matrix(&m.attitude) * &m.momentum;
    let square = end.attitude.coords.dot(&end.attitude.coords);
    let stretched = world(start).map(|x| x * square.clone());
    let ended = world(&end);
    ended
        .iter()
        .zip(&stretched)
        .try_for_each(|(a, b)| same_series("the momentum in the world", a, b, 0..=order, &slack(method)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::One;
    use tumbling::number::Analytic;

    #[test]
    fn every_method_is_tested() {
        let missing: Vec<_> = Method::ALL.iter().filter(|method| !TESTED.contains(method)).collect();
        assert!(missing.is_empty(), "{missing:?}");
    }

    #[test]
    fn spiral_loses_an_order_in_the_attitude_alone() {
        for (system, start) in &cases() {
            let end = step(Method::Spiral, system, start, &Number::step(4)).unwrap();
            let truth = exact(start, 4, |motion| system.rate(motion));
            let agree = |a: &[Number], b: &[Number], power: usize| {
                a.iter().zip(b).all(|(a, b)| a.coefficient(power) == b.coefficient(power))
            };
            let spin = |power| agree(end.momentum.as_slice(), truth.momentum.as_slice(), power);
            let attitude =
                |power| agree(end.attitude.coords.as_slice(), truth.attitude.coords.as_slice(), power);
            assert_eq!([1, 2, 3, 4].map(spin), [true, true, true, false]);
            assert_eq!([1, 2, 3].map(attitude), [true, true, false]);
        }
    }

    #[test]
    fn the_starts_have_lengths_without_a_root() {
        for (system, start) in &cases() {
            let omega = system.omega(&start.momentum);
            for square in [omega.dot(&omega), start.momentum.dot(&start.momentum)] {
                assert_eq!(square.sqrt() * square.sqrt(), square);
            }
            assert_eq!(start.attitude.coords.dot(&start.attitude.coords), Number::one());
            assert!(!start.momentum.iter().any(Zero::is_zero));
        }
    }
}
