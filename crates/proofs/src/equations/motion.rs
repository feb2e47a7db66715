//! The meanings of the names where the book treats motion.

use crate::number::{Derivation, Fraction};
use crate::proofs::conserved;
use crate::symbols::{
    Matrix, Vector, diagonal, inverse as invert, inverse_diagonal, momentum, ordered_moments, pure,
    quaternion, symmetric, turning, variables, vector,
};
use crate::tex::{Scope, Value};
use num_traits::{One, Zero};
use tumbling::attitude::{product, rate, rotation_matrix};
use tumbling::dynamics::euler::{angular_acceleration, coupling, tensor_times_acceleration};
use tumbling::dynamics::stability::rate_squared;
use tumbling::inertia::{omega_world, point_mass, turned};
use tumbling::laws::momentum_rate;
use tumbling::step::Engine;

/// The world's tensor.
pub(super) mod world_tensor {
    use super::*;

    pub(in super::super) const CASES: &[fn() -> Scope] = &[of_a_body, of_a_point];

    fn turning() -> (Scope, Matrix) {
        let (q, unit) = crate::symbols::attitude();
        let rotation = rotation_matrix(&q);
        (Scope::default().under(unit).with("R", rotation.clone()), rotation)
    }

    fn of_a_body() -> Scope {
        let (scope, rotation) = turning();
        let tensor = symmetric("I");
        scope.with(r"I_{\text{world}}", turned(&rotation, &tensor)).with(r"I_{\text{body}}", tensor)
    }

    /// A point at `r` in the body is at `R r` in the world.
    fn of_a_point() -> Scope {
        let (scope, rotation) = turning();
        let (m, r) = (Fraction::variable("m"), vector("r"));
        let world = point_mass(&m, &(rotation * &r));
        scope.with(r"I_{\text{world}}", world).with(r"I_{\text{body}}", point_mass(&m, &r))
    }
}

/// The world's inverse and spin, for a body with its axes along the principal ones.
pub(super) fn world_inverse() -> Scope {
    let (q, unit) = crate::symbols::attitude();
    let (rotation, moments, momentum) = (rotation_matrix(&q), vector("I"), vector("L"));
    let tensor = diagonal(&moments);
    let omega = omega_world(&rotation, &inverse_diagonal(&moments), &momentum);
    let reduced = |m: Matrix| m.map(|x| unit.reduce_fraction(&x));
    Scope::default()
        .with("R", rotation.clone())
        .with(r"I_{\text{world}}", reduced(turned(&rotation, &tensor)))
        .with(r"I_{\text{body}}", tensor)
        .with(r"\mathbf{L}", momentum)
        .with(r"\boldsymbol{\omega}", omega.map(|x| unit.reduce_fraction(&x)))
        .under(unit)
}

/// Rates of spin and momentum in the body.
pub(crate) mod rates {
    use super::*;

    /// By each of the library's three forms, in turn.
    pub(in super::super) const ALL: &[fn() -> Scope] = &[along_principal_axes, by_momentum, by_spin];

    fn along_principal_axes() -> Scope {
        pushed(&vector("tau"), angular_acceleration)
    }

    /// Without torque.
    pub(in super::super) fn free() -> Scope {
        pushed(&Vector::zeros(), angular_acceleration)
    }

    /// Along principal axes, with the acceleration by this law.
    pub(crate) fn pushed(torque: &Vector, law: impl Fn(&Vector, &Vector, &Vector) -> Vector) -> Scope {
        let (moments, omega) = (vector("I"), vector("omega"));
        let (tensor, inverse) = (diagonal(&moments), inverse_diagonal(&moments));
        let acceleration = law(&moments, &omega, torque);
        let momentum_rate = momentum_rate(&inverse, &(&tensor * &omega), torque);
        let scope = Scope::default().with_each("I", &moments).with_each(r"\omega", &omega);
        let scope = scope.with_each(r"\dot{\omega}", &acceleration).with_each(r"\tau", torque);
        named(scope, [tensor, inverse], omega, torque, [acceleration, momentum_rate])
    }

    fn by_momentum() -> Scope {
        by_momentum_and(momentum_rate)
    }

    /// Any axes: the spin follows from the momentum, whose rate is by this law.
    pub(crate) fn by_momentum_and(law: impl Fn(&Matrix, &Vector, &Vector) -> Vector) -> Scope {
        let (inverse, momentum, torque) = (symmetric("J"), vector("L"), vector("tau"));
        let rate = law(&inverse, &momentum, &torque);
        let omega = &inverse * &momentum;
        let rates = [&inverse * &rate, rate];
        named(Scope::default(), [invert(&inverse), inverse], omega, &torque, rates)
            .with(r"\mathbf{L}", momentum)
    }

    /// Any axes: the momentum follows from the spin.
    pub(crate) fn by_spin() -> Scope {
        with_spin(vector("omega"))
    }

    /// Without spin.
    pub(in super::super) fn at_rest() -> Scope {
        with_spin(Vector::zeros())
    }

    fn with_spin(omega: Vector) -> Scope {
        let (tensor, torque) = (symmetric("I"), vector("tau"));
        let rate = tensor_times_acceleration(&tensor, &omega, &torque);
        let inverse = invert(&tensor);
        let rates = [&inverse * &rate, rate];
        named(Scope::default(), [tensor, inverse], omega, &torque, rates)
    }

    fn named(
        scope: Scope,
        [tensor, inverse]: [Matrix; 2],
        omega: Vector,
        torque: &Vector,
        [acceleration, momentum_rate]: [Vector; 2],
    ) -> Scope {
        scope
            .with(r"\mathbf{L}", &tensor * &omega)
            .with("I", tensor)
            .with("J", inverse)
            .with(r"\boldsymbol{\omega}", omega)
            .with(r"\boldsymbol{\tau}", torque.clone())
            .with(r"\dot{\boldsymbol{\omega}}", acceleration)
            .with(r"\dot{\mathbf{L}}", momentum_rate)
    }
}

/// A small wobble about an axis.
pub(super) fn wobble() -> Scope {
    let [omega, about, first, second] = variables(["omega", "I", "I_a", "I_b"]);
    let square = rate_squared(&omega, &about, &first, &second);
    Scope::default()
        .with(r"\lambda", Value::Root(square))
        .with(r"\omega", omega)
        .with("I", about)
        .with_all([("I_a", first), ("I_b", second)])
}

/// A wobble about an axis by the place of its moment and of the others in the order of size.
fn wobble_of([about, first, second]: [usize; 3]) -> Scope {
    let (moments, omega) = (ordered_moments(), Fraction::variable("omega"));
    let square = rate_squared(&omega, &moments[about], &moments[first], &moments[second]);
    Scope::default().with(r"\lambda", Value::Root(square)).positive(["omega", "I1", "a", "b"])
}

/// Where it neither oscillates nor grows: the limit between both.
pub(super) fn equal_moments() -> Scope {
    let [omega, moment, other] = variables(["omega", "I", "J"]);
    Scope::default().with(r"\lambda", Value::Root(rate_squared(&omega, &moment, &moment, &other)))
}

/// About the ends.
pub(super) mod swings {
    use super::*;
    pub(in super::super) const BOTH: &[fn() -> Scope] = &[|| wobble_of([0, 1, 2]), || wobble_of([2, 0, 1])];
}

/// About the middle, the others in either order.
pub(super) mod grows {
    use super::*;
    pub(in super::super) const BOTH: &[fn() -> Scope] = &[|| wobble_of([1, 0, 2]), || wobble_of([1, 2, 0])];
}

/// Pitfall 1: the rate of the vector that the wrong engine stores.
pub(super) fn frozen() -> Scope {
    let (tensor, omega) = (symmetric("I"), vector("omega"));
    let attitude = quaternion(Fraction::one(), &Vector::zeros());
    let (_, rate) = Engine::Frozen.rate(&tensor, &invert(&tensor), &attitude, &omega);
    Scope::default()
        .with(r"I_{\text{body}}", tensor)
        .with(r"\boldsymbol{\omega}", omega)
        .with(r"\dot{\boldsymbol{\omega}}", rate)
}

/// Pitfall 2: the spin that the wrong engine computes, with the mean of the three moments.
pub(super) fn momentum_for_spin() -> Scope {
    let (moments, momentum) = (vector("I"), vector("L"));
    let (q, _) = crate::symbols::attitude();
    let (tensor, inverse) = (diagonal(&moments), inverse_diagonal(&moments));
    let omega = Engine::MomentumForSpin.omega_world(&rotation_matrix(&q), &tensor, &inverse, &momentum);
    Scope::default()
        .with(r"\bar{I}", moments.sum() / Fraction::from(3))
        .with(r"\mathbf{L}", momentum)
        .with(r"\boldsymbol{\omega}", omega)
}

/// A tensor with its axes turned about the third.
pub(super) fn turned_axes() -> Scope {
    let [sin, cos] = variables(["sin", "cos"]);
    let mut axes = Matrix::identity();
    (axes[(0, 0)], axes[(1, 1)]) = (cos.clone(), cos.clone());
    (axes[(0, 1)], axes[(1, 0)]) = (sin.clone(), -sin.clone());
    let tensor = symmetric("I");
    Scope::default()
        .with("I'_{xy}", turned(&axes, &tensor)[(0, 1)].clone())
        .with_all([("I_{xx}", tensor[(0, 0)].clone()), ("I_{yy}", tensor[(1, 1)].clone())])
        .with_all([("I_{xy}", tensor[(0, 1)].clone()), (r"\sin(\phi)", sin), (r"\cos(\phi)", cos)])
}

/// Moments `a` and `b`, the tangent of the spin's angle and that of the gap: in the plane of the two axes
/// |L x w| has one component, and over w.L it is that tangent.
fn gap_at(slope: &Fraction) -> [Fraction; 3] {
    let [a, excess] = variables(["a", "d"]);
    let b = &a + &excess;
    let moments = Vector::new(a.clone(), b.clone(), Fraction::one());
    let omega = Vector::new(Fraction::one(), slope.clone(), Fraction::zero());
    let tangent = -coupling(&moments, &omega).z.clone() / omega.dot(&(diagonal(&moments) * &omega));
    [a, b, tangent]
}

/// The gap for any direction of the spin between two axes.
pub(crate) fn slant() -> Scope {
    let slope = Fraction::variable("t");
    let [a, b, tangent] = gap_at(&slope);
    let scope = Scope::default().positive(["a", "d", "t"]).with_all([("a", a), ("b", b)]);
    scope.with_all([(r"\tan(\theta)", slope), (r"\tan(\text{gap})", tangent)])
}

/// The direction between two axes with the largest gap, and this gap; the moments are `a` and `b`, with `b`
/// the larger.
pub(super) fn summit() -> Scope {
    let [a, b, tangent] = gap_at(&Fraction::variable("t"));
    // Its derivative vanishes where c0 + c2 t² does.
    let powers = tangent.derivative(&"t".into()).numerator().in_powers_of(&"t".into());
    let square = match &powers[..] {
        [c0, c1, c2] if c1.is_zero() => -Fraction::from(c0.clone()) / Fraction::from(c2.clone()),
        _ => Fraction::ratio(1, 0),
    };
    // tan² there, t only by its square; sin² = tan² / (1 + tan²).
    let squared = tangent.pow(2);
    let at_summit = |p: &crate::number::Polynomial| {
        let powers = p.in_powers_of(&"t".into());
        let even = powers.iter().step_by(2).rev();
        let odd_vanish = powers.iter().skip(1).step_by(2).all(Zero::is_zero);
        let sum = even.fold(Fraction::zero(), |sum, c| sum * &square + Fraction::from(c.clone()));
        if odd_vanish { sum } else { Fraction::ratio(1, 0) }
    };
    let tan2 = at_summit(squared.numerator()) / at_summit(squared.denominator());
    let sin2 = &tan2 / &(Fraction::one() + &tan2);
    Scope::default()
        .with_all([("a", a), ("b", b)])
        .with(r"\tan(\theta)", Value::Root(square))
        .with(r"\sin(\text{gap})", Value::Root(sin2))
        .positive(["a", "d"])
}

/// Attitude.
pub(super) fn attitude() -> Scope {
    let (q, unit) = crate::symbols::attitude();
    let (omega, v) = (vector("omega"), vector("v"));
    let rate = rate(&q, &omega);
    let rotation = rotation_matrix(&q);
    let back = quaternion(q.coords.w.clone(), &-q.coords.xyz());
    let carried = product(&product(&q, &pure(&v)), &back).coords.xyz();
    Scope::default()
        .with("q", q)
        .with(r"\dot{q}", rate)
        .with(r"\boldsymbol{\omega}_{\text{body}}", omega)
        .with("R", rotation)
        .with(r"\mathbf{v}_{\text{world}}", carried)
        .with(r"\mathbf{v}_{\text{body}}", v)
        .under(unit)
}

/// The velocity of a place fixed in a turning body, in the body's axes.
pub(super) fn carried_round() -> Scope {
    let (q, unit) = crate::symbols::attitude();
    let (r, omega) = (vector("r"), vector("omega"));
    let time = turning(&rate(&q, &omega));
    let rotation = rotation_matrix(&q);
    let velocity = rotation.transpose() * (&rotation * &r).map(|x| time.of(&x));
    Scope::default()
        .with(r"\mathbf{r}", r)
        .with(r"\boldsymbol{\omega}", omega)
        .with(r"\mathbf{v}", velocity.map(|x| unit.reduce_fraction(&x)))
        .under(unit)
}

/// The slope of the momentum divided by the slope of the spin.
pub(super) fn slopes() -> Scope {
    let [a, b, slope] = variables(["a", "b", "t"]);
    let inverse = inverse_diagonal(&Vector::new(a.clone(), b.clone(), Fraction::one()));
    let momentum = Vector::new(Fraction::one(), slope.clone(), Fraction::zero());
    let spin = omega_world(&Matrix::identity(), &inverse, &momentum);
    let it = slope / (&spin.y / &spin.x);
    Scope::default().with("a", a).with("b", b).with(Scope::IT, it)
}

/// The right-hand side of Euler's equations without torque.
pub(super) fn gyroscopic() -> Scope {
    let (tensor, omega) = (symmetric("I"), vector("omega"));
    let it = tensor_times_acceleration(&tensor, &omega, &Vector::zeros());
    Scope::default().with("I", tensor).with(r"\boldsymbol{\omega}", omega).with(Scope::IT, it)
}

/// The rate of the energy, with a torque, for without one it is zero.
pub(super) fn power() -> Scope {
    conserved::power(&momentum_rate, &angular_acceleration).swap_remove(1)
}

/// Moments in order.
pub(crate) fn in_order() -> Scope {
    let [a, b] = variables(["a", "b"]);
    let moments = ordered_moments();
    Scope::default().with("a", a).with("b", b).with_each("I", &moments)
}

/// An arrow at rest in the world, seen from a frame with any spin.
pub(super) fn seen_from_the_body() -> Scope {
    let (inverse, arrow) = (crate::symbols::symmetric("J"), vector("L"));
    let rate = tumbling::laws::momentum_rate(&inverse, &arrow, &Vector::zeros());
    let omega = inverse * &arrow;
    Scope::default()
        .with(r"\mathbf{v}", arrow)
        .with(r"\dot{\mathbf{v}}", rate)
        .with(r"\boldsymbol{\omega}", omega)
}

/// Two small components near a spin that stays, and the second rate of the first.
pub(super) fn linearised() -> Scope {
    let [spin, about, first, second] = variables(["omega", "I", "I_a", "I_b"]);
    let small = variables(["omega_a", "omega_b"]);
    let moments = Vector::new(about.clone(), first.clone(), second.clone());
    let omega = Vector::new(spin.clone(), small[0].clone(), small[1].clone());
    let rate = angular_acceleration(&moments, &omega, &Vector::zeros());
    // To first order the large component does not change.
    let time = Derivation::new([("omega_a", rate.y.clone()), ("omega_b", rate.z.clone())]);
    let again = time.of(&rate.y);
    let [a, b] = small;
    wobble()
        .with_all([(r"\omega_a", a), (r"\omega_b", b), (r"\dot{\omega}_a", rate.y.clone())])
        .with_all([(r"\dot{\omega}_b", rate.z.clone()), (r"\ddot{\omega}_a", again)])
}

/// The conserved quantities, in the components of the spin along principal axes.
pub(super) fn conserved() -> Scope {
    let (moments, omega) = (vector("I"), vector("omega"));
    let momentum = momentum(&moments, &omega);
    let energy = tumbling::dynamics::observe::energy(&omega, &momentum);
    let scope = Scope::default().with("E", energy).with("L", Value::Root(momentum.dot(&momentum)));
    scope.with_each("I", &moments).with_each(r"\omega", &omega)
}
