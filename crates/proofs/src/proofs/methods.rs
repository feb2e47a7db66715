//! The order of every stepping method, proven for all free bodies, and the laws that it conserves, tested.
//!
//! The method's own step runs on power series whose coefficients are polynomials in the moments and in the
//! initial momentum. So its agreement with the motion through a power of the step is decided for all bodies
//! and motions at once, without theorems on order conditions. For the two highest orders of Moser and
//! Veselov, [`discrete`] decides it by the equation that the step solves. Two starts in numbers show that a
//! method agrees no further, and which laws it breaks; that it conserves the others from these starts is a
//! test ([`kept`] proves the reason). The numbers are chosen so that spin, momentum and attitude have
//! rational lengths.
//!
//! The weights of the longest splitting are decimals: [`shares`] proves that exact ones lie next to them.
//!
//! [`discrete`]: super::discrete
//! [`kept`]: super::kept
//! [`shares`]: super::shares

use crate::number::{Fraction, Polynomial, Relations};
use crate::proof::{Case, Cases, Kind, Mutant, Outcome, Proof, Residue, breaks};
use crate::proofs::order::{Number, components, constant, exact, start};
use crate::tex::Scope;
use nalgebra::{Quaternion, Vector3};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::ops::RangeInclusive;
use tumbling::attitude;
use tumbling::step::{Method, State, System};

macro_rules! methods {
    ($($name:literal $method:ident $order:literal [$e:literal $m:literal $d:literal $l:literal $b:literal],)*) => {
        pub(super) const PROOFS: &[Proof] = &[$({
            const SAID: &str = concat!(
                "One step of the method of this name from the attitude without a turn, in units of the first moment, agrees with the motion of every free body through the power $p = ", $order, "$ of the step, in every component of attitude and momentum; for two starts in exact fractions not through the next, so that its order is no higher. \
                For these two, the first power of the step at which the method changes the energy is $e = ", $e, "$, the momentum's length $m = ", $m, "$, the momentum in the world $d = ", $d, "$, the attitude's length $l = ", $l, "$, and that at which a step back does not lead to the start $b = ", $b, "$; 0 stands for none through two or four powers more than its order: a test of what is kept, a proof of what is not. \
                Weights that are no roots of whole numbers stand with 27 digits, and what they leave over has no coefficient above a quintillionth; exact ones lie next to them. \
                Up to order 6 the whole step runs on letters. Of the two orders above it, both of Moser and Veselov's step, the equation that the step solves runs on letters: that the motion obeys it is the proof moser-veselov-is-obeyed, and that it has one solution moser-veselov-has-one-solution.");
            Proof {
                name: $name,
                // Of higher orders the letters are in the proofs of their equation.
                kind: if $order > 6 { Kind::Numbers } else { Kind::Library },
                part: "step",
                statement: SAID,
                cases: || holds(Method::$method, 0).and_then(|()| laws(Method::$method)).cases(),
                mutants: &[
                    Mutant { change: "said to be one order better", check: || holds(Method::$method, 1) },
                    Mutant {
                        change: "said to keep the energy of another body too, and the momentum in the world",
                        check: || keeps_another(Method::$method),
                    },
                ],
            }
        },)*];

        /// The methods of these proofs.
        pub const TESTED: &[Method] = &[$(Method::$method,)*];
    };
}

methods! {
    "explicit-euler" ExplicitEuler 1 [2 2 2 2 2],
    "runge-kutta-4" RungeKutta4 4 [5 5 5 5 6],
    "dormand-prince-5" DormandPrince5 5 [6 6 6 6 6],
    "munthe-kaas-4" MuntheKaas4 4 [5 0 0 0 6],
    "buss" Buss 2 [3 0 0 0 4],
    "spiral" Spiral 2 [4 4 3 0 4],
    "implicit-midpoint" ImplicitMidpoint 2 [0 0 0 0 0],
    "gauss-4" Gauss4 4 [0 0 5 0 0],
    "gauss-6" Gauss6 6 [0 0 7 0 0],
    "three-rotations-2" RotationSplitting2 2 [3 0 0 0 0],
    "three-rotations-4" RotationSplitting4 4 [5 0 0 0 0],
    "three-rotations-6" RotationSplitting6 6 [7 0 0 0 0],
    "symmetric-top-splitting" SymmetricTop 2 [3 0 0 0 0],
    "moser-veselov-2" MoserVeselov2 2 [0 0 0 0 0],
    "moser-veselov-4" MoserVeselov4 4 [0 0 0 0 0],
    "moser-veselov-6" MoserVeselov6 6 [0 0 0 0 0],
    "moser-veselov-8" MoserVeselov8 8 [0 0 0 0 0],
    "moser-veselov-10" MoserVeselov10 10 [0 0 0 0 0],
    "constant-spin" ConstantSpin 0 [0 0 1 0 0],
    "semi-implicit-euler" SemiImplicitEuler 1 [2 2 2 0 2],
    "rescaled" Rescaled 1 [2 0 2 0 2],
    "rescaled-straight" RescaledLinearAttitude 1 [2 0 2 0 2],
    "one-newton" ImplicitOneNewton 1 [2 2 2 0 2],
    "linearised-implicit" LinearisedImplicit 1 [2 2 2 0 2],
    "mean-spin-runge-kutta-4" MeanSpinRungeKutta4 2 [5 5 3 0 6],
    "turned-runge-kutta-4" TurnedRungeKutta4 4 [5 5 5 0 6],
}

/// Every free body and motion, the first moment as the unit.
pub(super) fn any() -> (System<Number>, State<Number>) {
    let [j2, j3] = ["J2", "J3"].map(|name| constant(&(Fraction::one() / Fraction::variable(name))));
    (System::of_numbers(Vector3::new(Number::one(), j2, j3), Vec::new()), start())
}

/// Moments, spin with a length that is a fraction and momentum with one, and a unit attitude.
pub fn cases() -> [(System<Number>, State<Number>); 2] {
    let number = |n: i64, d: i64| constant(&Fraction::ratio(n, d));
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

/// The highest power of the step through which the laws of a method are followed: fewer where numbers grow
/// long.
fn last_power(method: Method) -> usize {
    let long = matches!(method, Method::Gauss4 | Method::Gauss6 | ROUNDED);
    method.info().order as usize + if long { 2 } else { 4 }
}

/// The method whose weights are decimals.
const ROUNDED: Method = Method::RotationSplitting6;

/// Whether all coefficients are at most 1e-18, the residue that the rounding of a weight to 27 digits can
/// leave.
fn tiny(x: &Fraction) -> bool {
    let most = BigRational::new(1.into(), 1_000_000_000_000_000_000_i64.into());
    x.as_polynomial().is_some_and(|p| p.terms().all(|(_, coefficient)| coefficient.abs() < most))
}

/// That these series agree in these powers.
pub(super) fn alike(
    claim: &str,
    method: Method,
    a: &[Number],
    b: &[Number],
    powers: RangeInclusive<usize>,
) -> Outcome {
    let roots = Relations::new(vec![("root(3)", Polynomial::from(3)), ("root(15)", Polynomial::from(15))])?;
    for (power, (a, b)) in powers.flat_map(|power| a.iter().zip(b).map(move |pair| (power, pair))) {
        let claim = format!("{claim}, power {power} of the step");
        let Some((x, y)) = a.coefficient(power).zip(b.coefficient(power)) else {
            return Err(Residue::Missing { claim });
        };
        let left = roots.reduce_fraction(&(x - y));
        if left.is_undefined() {
            return Err(Residue::Undefined { claim });
        }
        if !(left.is_zero() || method == ROUNDED && tiny(&left)) {
            return Err(Residue::NotZero { claim, left });
        }
    }
    Ok(())
}

pub(super) fn step(
    method: Method,
    system: &System<Number>,
    start: &State<Number>,
    h: &Number,
) -> Result<State<Number>, Residue> {
    method.step(system, start, h.clone()).map_err(|error| Residue::Missing { claim: error.to_string() })
}

/// The ends of a step and of the motion, through this power.
fn ends(method: Method, case: &(System<Number>, State<Number>), last: usize) -> Case<[Vec<Number>; 2]> {
    let (end, (system, start)) = (step(method, &case.0, &case.1, &Number::step(last))?, case);
    Ok([end, exact(start, last, |motion| system.rate(motion))].map(|state| components(&state)))
}

fn holds(method: Method, more: usize) -> Outcome {
    let order = method.info().order as usize + more;
    let agree = |[end, truth]: &[Vec<Number>; 2], powers| alike("the motion", method, end, truth, powers);
    for case in &cases() {
        let ends = ends(method, case, order + 1)?;
        agree(&ends, 0..=order)?;
        breaks("the next power does not agree", agree(&ends, order + 1..=order + 1))?;
    }
    // Above it whole steps on letters take too long.
    if order > 6 { Ok(()) } else { agree(&ends(method, &any(), order)?, 0..=order) }
}

/// What a method may keep: twice the energy, the square of the momentum, the momentum in the world times the
/// square of the length of the other motion's attitude, and that of its own.
fn quantities(system: &System<Number>, m: &State<Number>, other: &State<Number>) -> [Vec<Number>; 4] {
    let square = |m: &State<Number>| m.attitude.coords.dot(&m.attitude.coords);
    let world = attitude::rotation_matrix(&m.attitude) * &m.momentum;
    [
        vec![m.momentum.dot(&system.omega(&m.momentum))],
        vec![m.momentum.dot(&m.momentum)],
        world.iter().map(|x| x * square(other)).collect(),
        vec![square(m)],
    ]
}

/// The first power at which each law is broken, of the two starts: what one body keeps by chance the other
/// must break.
fn laws(method: Method) -> Result<Scope, Residue> {
    let (info, last) = (method.info(), last_power(method));
    let said = [info.energy, info.momentum, info.direction, info.unit, info.reversible];
    let mut broken = [0; 5];
    for (system, start) in &cases() {
        let h = Number::step(last);
        let end = step(method, system, start, &h)?;
        let back = components(&step(method, system, &end, &-h)?);
        let (before, after) = (quantities(system, start, &end), quantities(system, &end, start));
        let pairs = after.into_iter().chain([back]).zip(before.into_iter().chain([components(start)]));
        for (broken, (after, before)) in broken.iter_mut().zip(pairs) {
            for power in 1..if *broken > 0 { *broken } else { last + 1 } {
                match alike("a law", method, &after, &before, power..=power) {
                    Ok(()) => continue,
                    Err(Residue::NotZero { .. }) => *broken = power,
                    Err(residue) => return Err(residue),
                }
                break;
            }
        }
    }
    if broken.map(|power| power == 0) != said {
        return Err(Residue::Missing { claim: format!("{said:?} kept, broken at {broken:?}") });
    }
    let number = |n: usize| Fraction::from(n as i64);
    let scope = Scope::default().with("p", number(info.order as usize));
    Ok(["e", "m", "d", "l", "b"]
        .into_iter()
        .zip(broken)
        .fold(scope, |scope, (name, n)| scope.with(name, number(n))))
}

fn keeps_another(method: Method) -> Outcome {
    let [(system, start), (other, _)] = &cases();
    let end = step(method, system, start, &Number::step(last_power(method)))?;
    let (before, after) = (quantities(other, start, &end), quantities(other, &end, start));
    // A spin that stays in the body keeps any body's energy, but not the momentum in the world.
    [0, 2].into_iter().try_for_each(|k| {
        alike("a law of another body", method, &after[k], &before[k], 0..=last_power(method))
    })
}
