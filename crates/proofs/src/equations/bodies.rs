//! The meanings of the names in equations about a body's mass; they are the same in every equation of a kind.

use crate::number::Fraction;
use crate::symbols::{Matrix, Vector, diagonal, symmetric, variables, vector};
use crate::tex::{Scope, Value};
use num_traits::{One, Zero};
use tumbling::inertia::{omega_world, point_mass};
use tumbling::solid::{Cuboid, MassMoments, Shape, combined};

/// The names of a vector's components: `name_x`, `name_y`, `name_z`.
fn with_components(scope: Scope, stem: &str, v: &Vector) -> Scope {
    let axes = ["x", "y", "z"];
    axes.iter().zip(v).fold(scope, |scope, (axis, x)| scope.with(&format!("{stem}_{axis}"), x.clone()))
}

/// The names of a matrix's entries: `name_{xx}`, `name_{xy}` and so on.
fn with_entries(mut scope: Scope, stem: &str, m: &Matrix) -> Scope {
    let axes = ["x", "y", "z"];
    for (i, row) in axes.iter().enumerate() {
        for (j, column) in axes.iter().enumerate() {
            scope = scope.with(&format!("{stem}_{{{row}{column}}}"), m[(i, j)].clone());
        }
    }
    scope
}

/// Any body: three points with any masses at any places, which can have every tensor that a body can have.
/// Its momentum is the sum of `r x m (w x r)`, its energy that of `m (w x r)²/2`, and its tensor is the
/// library's.
pub(super) fn body() -> Scope {
    of_points(&["r", "s", "t"].map(vector))
}

/// A flat one, in the plane of the first two axes.
pub(super) fn flat() -> Scope {
    of_points(&["r", "s", "t"].map(vector).map(|r| Vector::new(r.x.clone(), r.y.clone(), Fraction::zero())))
}

fn of_points(places: &[Vector; 3]) -> Scope {
    let omega = vector("omega");
    let masses = variables(["m_r", "m_s", "m_t"]);
    let (mut tensor, mut momentum, mut energy) = (Matrix::zeros(), Vector::zeros(), Fraction::zero());
    let mut scope = Scope::default().positive(["m_r", "m_s", "m_t"]);
    for (m, r) in masses.iter().zip(places) {
        let velocity = omega.cross(r);
        tensor += point_mass(m, r);
        momentum += r.cross(&velocity).map(|x| x * m);
        energy += m * &velocity.dot(&velocity) / Fraction::from(2);
        let [x, y, z] = r.clone().into();
        scope = scope.with_piece([("m", m.clone()), ("x", x), ("y", y), ("z", z)]);
    }
    scope = with_components(scope, "L", &momentum);
    scope = with_components(scope, r"\omega", &omega);
    scope = with_entries(scope, "I", &tensor).with_each("I", &tensor.diagonal());
    scope
        .with("I", tensor)
        .with(r"\mathbf{L}", momentum)
        .with(r"\boldsymbol{\omega}", omega)
        .with("E", energy)
}

/// Any box, of edges a, b, c along x, y, z.
pub(super) fn the_box() -> Scope {
    let [m, a, b, c] = variables(["m", "a", "b", "c"]);
    let tensor = diagonal(&Cuboid::moments(&m, [&a, &b, &c]));
    with_entries(Scope::default(), "I", &tensor).with("m", m).with("a", a).with("b", b).with("c", c)
}

/// The momentum that the library's law takes to this spin, with the body lying along the axes.
fn momentum(moments: &Vector, omega: &Vector) -> Value {
    let inverse = diagonal(&moments.map(|x| Fraction::one() / x));
    let spin_of = |l: &Vector| omega_world(&Matrix::identity(), &inverse, l);
    // The law is linear: its columns are its results for the axes.
    let unit = |i: usize| Vector::from_fn(|j, _| if i == j { Fraction::one() } else { Fraction::zero() });
    Value::Solution(
        Matrix::from_columns(&[spin_of(&unit(0)), spin_of(&unit(1)), spin_of(&unit(2))]),
        omega.clone(),
    )
}

/// Any box with the spin of the example.
pub(super) fn the_box_spun() -> Scope {
    let [m, a, b, c] = variables(["m", "a", "b", "c"]);
    let omega = Vector::new(Fraction::one(), Fraction::one(), Fraction::zero());
    the_box().with(r"\mathbf{L}", momentum(&Cuboid::moments(&m, [&a, &b, &c]), &omega))
}

/// Any body along its principal axes, spun about none of the third.
pub(super) fn planar() -> Scope {
    let [x, y] = variables(["omega1", "omega2"]);
    let moments = vector("I");
    let scope = Scope::default().with("I_1", moments.x.clone()).with("I_2", moments.y.clone());
    let scope = scope.with(r"\omega_x", x.clone()).with(r"\omega_y", y.clone());
    scope.with(r"\mathbf{L}", momentum(&moments, &Vector::new(x, y, Fraction::zero())))
}

/// Any body along its principal axes, spun about one.
pub(super) fn axis(k: usize) -> Scope {
    let (moments, spin) = (vector("I"), Fraction::variable("omega"));
    let omega = Vector::from_fn(|i, _| if i == k { spin.clone() } else { Fraction::zero() });
    let scope = Scope::default().with(r"\mathbf{L}", momentum(&moments, &omega));
    scope.with("I_k", moments[k].clone()).with(r"\boldsymbol{\omega}", omega)
}

/// A single piece, moving: its momentum by the library's tensor.
pub(super) fn moving_piece() -> Scope {
    let (m, r, omega) = (Fraction::variable("m"), vector("r"), vector("omega"));
    let tensor = point_mass(&m, &r);
    let momentum = &tensor * &omega;
    let scope = with_components(Scope::default(), "L", &momentum).with(r"I_{\text{piece}}", tensor);
    let scope =
        ["x", "y", "z"].into_iter().zip(&r).fold(scope, |scope, (name, x)| scope.with(name, x.clone()));
    with_components(scope, r"\omega", &omega)
        .with("m", m)
        .with("r", Value::Root(r.dot(&r)))
        .with(r"\mathbf{r}", r)
        .with(r"\boldsymbol{\omega}", omega)
        .with(r"\mathbf{L}_{\text{piece}}", momentum)
}

/// A body of two parts, each any body with its centre anywhere.
pub(super) fn two_parts() -> Scope {
    let part = |n: usize| MassMoments {
        mass: Fraction::variable(&format!("m{n}")),
        centre: vector(["r", "s"][n]),
        inertia: symmetric(["J", "K"][n]),
    };
    let parts = [part(0), part(1)];
    let whole = combined(&parts, &Vector::zeros());
    let scope = with_entries(Scope::default(), "I", &whole.inertia);
    parts.into_iter().fold(scope, |scope, part| {
        let offset = part.centre - &whole.centre;
        scope.with_piece([
            ("m", part.mass),
            ("x", offset.x.clone()),
            ("y", offset.y.clone()),
            (r"I_{\text{own}}", part.inertia[(2, 2)].clone()),
        ])
    })
}

/// Twice the energy of any body.
pub(super) fn twice_the_energy() -> Scope {
    let body = body();
    let twice = body.meaning("E").cloned().and_then(|e| Value::Scalar(Fraction::from(2)).times(e).ok());
    twice.into_iter().fold(body, |scope, it| scope.with(Scope::IT, it))
}

/// The sum that some books call the product of inertia: the entry of the library's matrix with the opposite
/// sign.
pub(super) fn product_without_minus() -> Scope {
    let body = body();
    let minus = Value::Scalar(Fraction::from(-1));
    let product = body.meaning("I_{xy}").cloned().and_then(|entry| minus.times(entry).ok());
    product.into_iter().fold(body, |scope, it| scope.with(Scope::IT, it))
}
