//! The meanings of the names where the book treats steps through time.

use crate::number::{Fraction, Relations, Series};
use crate::proofs::methods::cases;
use crate::symbols::{Matrix, Vector, diagonal, inverse_diagonal, symmetric, variables, vector};
use crate::tex::Scope;
use nalgebra::{Quaternion, Vector3};
use num_traits::Zero;
use tumbling::{attitude::rotation_matrix, step::Method};
use tumbling::{dynamics::euler, dynamics::observe, laws::momentum_rate};

fn times(v: &Vector, factor: &Fraction) -> Vector {
    v.map(|x| x * factor)
}

/// One explicit step of the momentum.
pub(super) mod explicit {
    use super::*;

    pub(in super::super) const CASES: &[fn() -> Scope] =
        &[of_any_body, || by_the_method(Method::ExplicitEuler), || by_the_method(Method::SemiImplicitEuler)];

    fn of_any_body() -> Scope {
        let (inverse, momentum, h) = (symmetric("J"), vector("L"), Fraction::variable("h"));
        let rate = momentum_rate(&inverse, &momentum, &Vector::zeros());
        named(&inverse * &momentum, &momentum + times(&rate, &h), momentum, h)
    }

    /// A body in numbers, the step in letters.
    fn by_the_method(method: Method) -> Scope {
        let [(system, start), _] = cases();
        let h = Fraction::variable("h");
        let written = |v: &Vector3<Series<Fraction>>| {
            v.map(|x| {
                let power = |n: u32| Some(x.coefficient(n as usize)? * h.pow(n));
                (0..=3).fold(Fraction::zero(), |sum, n| sum + power(n).unwrap_or(Fraction::ratio(1, 0)))
            })
        };
        let end = method.step(&system, &start, Series::step(3));
        let end = end.map_or(Vector::repeat(Fraction::ratio(1, 0)), |end| written(&end.momentum));
        named(written(&system.omega(&start.momentum)), end, written(&start.momentum), h.clone())
    }

    fn named(omega: Vector, end: Vector, momentum: Vector, h: Fraction) -> Scope {
        Scope::default()
            .with(r"\mathbf{L}", momentum)
            .with(r"\mathbf{L}'", end)
            .with(r"\boldsymbol{\omega}", omega)
            .with("h", h)
    }
}

/// A turn of the body about one of its axes, at constant momentum in the world; `j` and `k` are the next two
/// axes.
pub(super) mod turn {
    use super::*;

    pub(in super::super) const ALL: &[fn() -> Scope] = &[|| about(0), || about(1), || about(2)];

    fn about(axis: usize) -> Scope {
        let [cosine, sine] = variables(["c", "s"]);
        let half = Vector::from_fn(|i, _| if i == axis { sine.clone() } else { Fraction::zero() });
        let [x, y, z]: [Fraction; 3] = half.into();
        let rotation = rotation_matrix(&Quaternion::new(cosine.clone(), x, y, z));
        let momentum = vector("L");
        let end = rotation.transpose() * &momentum;
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        Scope::default()
            .with_all([("L_j", momentum[j].clone()), ("L_k", momentum[k].clone())])
            .with_all([("L'_j", end[j].clone()), ("L'_k", end[k].clone())])
            .with(r"\cos(a)", cosine.pow(2) - sine.pow(2))
            .with(r"\sin(a)", Fraction::from(2) * cosine * sine)
            .under(Relations::circle("c", "s"))
    }
}

/// The angle of that turn.
pub(super) fn angle() -> Scope {
    let (moments, momentum, h) = (vector("I"), vector("L"), Fraction::variable("h"));
    let omega = tumbling::inertia::omega_world(&Matrix::identity(), &inverse_diagonal(&moments), &momentum);
    Scope::default()
        .with_all([("h", h.clone()), ("L_i", momentum.x.clone()), ("I_i", moments.x.clone())])
        .with(Scope::IT, h * &omega.x)
}

/// A step with the rate at the mean of start and end, and a torque that is constant during the step; start
/// and end are written by their mean.
pub(super) fn midpoint() -> Scope {
    let (moments, mean, torque) = (vector("I"), vector("M"), vector("tau"));
    let (inverse, h) = (inverse_diagonal(&moments), Fraction::variable("h"));
    let half = times(&momentum_rate(&inverse, &mean, &torque), &(&h / &Fraction::from(2)));
    let (start, end) = (&mean - &half, &mean + &half);
    let energy = |momentum: &Vector| observe::energy(&(&inverse * momentum), momentum);
    Scope::default()
        .with_all([("E", energy(&start)), ("E'", energy(&end))])
        .with(r"\mathbf{L}", start)
        .with(r"\mathbf{L}'", end)
        .with(r"\mathbf{M}", mean)
        .with(r"\boldsymbol{\tau}", torque)
        .with("J", inverse)
        .with("h", h)
}

/// Moser and Veselov's step: `c` is the axis times the tangent of half the angle of the step's turn.
pub(super) fn discrete() -> Scope {
    let (q, unit) = crate::symbols::attitude();
    let w = q.coords.w.clone();
    let tangents = q.coords.xyz().map(|x| x / &w);
    let (tensor, h) = (diagonal(&vector("K")), Fraction::variable("h"));
    let carried = &tensor * &tangents;
    // 1 + |c|^2 is 1/w^2.
    let factor = Fraction::from(2) * w.pow(2) / &h;
    let start = times(&(&carried + tangents.cross(&carried)), &factor);
    let end = rotation_matrix(&q).transpose() * &start;
    Scope::default()
        .with(r"\mathbf{c}", tangents)
        .with("K", tensor)
        .with("h", h)
        .with(r"\mathbf{L}", start)
        .with(r"\mathbf{L}'", end)
        .under(unit)
}

/// The matrix of the one Newton step of implicit Euler: the tensor minus the step times the derivative of the
/// gyroscopic term.
pub(super) fn newton() -> Scope {
    let (moments, omega, change) = (vector("I"), vector("omega"), vector("delta"));
    let h = Fraction::variable("h");
    let gyroscopic = euler::coupling(&moments, &omega);
    let slope = Matrix::from_fn(|i, j| gyroscopic[i].derivative(&format!("omega{}", j + 1).as_str().into()));
    let tensor = diagonal(&moments);
    let matrix = &tensor - slope.map(|x| x * &h);
    Scope::default()
        .with("A", matrix)
        .with("I", tensor)
        .with("h", h)
        .with(r"\boldsymbol{\omega}", omega)
        .with(r"\boldsymbol{\delta}", change)
}
