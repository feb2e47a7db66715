//! The tensor itself: what it is for one point, and how it moves with the point it is taken about.

use crate::number::Fraction;
use crate::symbols::{Matrix, Vector, variables, vector};
use crate::tex::Scope;
use tumbling::inertia::point_mass;
use tumbling::solid::{MassMoments, combined};

proofs! {
    "inertia" {
        "point-mass": point(point_mass),
            r"The tensor of a point, applied to a spin, is its angular momentum: $I\omega = m r\times (\omega\times r)$, for every point and spin.";
            but "the products without their minus": point(|m, r| Matrix::from_fn(|i, j| sign(i == j) * point_mass(m, r)[(i, j)].clone())),
        "every-body-obeys-the-triangle-inequality": triangle(point_mass),
            r"For one point and every direction, with the trace $s$, $\tfrac{1}{2} s n\cdot n - n\cdot (I n) = m (n\cdot r)^2$, which is never below zero. Tensors of points add, so that no body of points has a moment above the sum of the others; the sum is no part of this check.";
            but "the products without their minus": triangle(|m, r| Matrix::from_fn(|i, j| sign(i == j) * point_mass(m, r)[(i, j)].clone())),
        "parallel-axes": parallel_axes(1),
            r"The tensor of any three points, about a point away from their centre, is that about the centre and that of one point with all their mass: $A n = I n + m s\times (n\times s)$.";
            but "subtracted, not added": parallel_axes(-1),
        "parts-of-a-body": parts(combined),
            r"Three points put together in steps, counted from any point, make the same body as at once, $C = c$ and $A n = B n$; two turn as one with their reduced mass, $T n = \frac{u v}{u + v} s\times (n\times s)$; a part alone stays what it is, $I n = m n$.";
            but "the parts' tensors added without their distances": {
                parts(|parts, reference| {
                    let sum = parts.iter().fold(Matrix::zeros(), |sum, part| sum + &part.inertia);
                    MassMoments { inertia: sum, ..combined(parts, reference) }
                })
            },
    }
}

fn sign(plus: bool) -> Fraction {
    Fraction::from(if plus { 1 } else { -1 })
}

fn point(law: impl Fn(&Fraction, &Vector) -> Matrix) -> Scope {
    let (m, r, w) = (Fraction::variable("m"), vector("r"), vector("omega"));
    Scope::default().with("I", law(&m, &r)).with("m", m).with("r", r).with(r"\omega", w)
}

fn triangle(law: impl Fn(&Fraction, &Vector) -> Matrix) -> Scope {
    let (m, r, n) = (Fraction::variable("m"), vector("r"), vector("n"));
    let tensor = law(&m, &r);
    Scope::default().with("s", tensor.trace()).with("I", tensor).with("m", m).with("r", r).with("n", n)
}

/// Three points: mass, first and second moments of theirs can be anything, and no more than those count.
fn points() -> Vec<MassMoments<Fraction>> {
    let point = |name: &str| MassMoments {
        mass: Fraction::variable(&format!("m_{name}")),
        centre: vector(name),
        inertia: Matrix::zeros(),
    };
    ["r", "s", "t"].map(point).into()
}

fn parallel_axes(factor: i64) -> Scope {
    let (points, away) = (points(), vector("d"));
    let body = combined(&points, &Vector::zeros());
    let from = |position: &Vector| position - &away;
    let about = points.iter().fold(Matrix::zeros(), |sum, p| sum + point_mass(&p.mass, &from(&p.centre)));
    let scope = Scope::default().with("A", about).with("I", body.inertia).with("n", vector("n"));
    scope.with("s", from(&body.centre)).with("m", body.mass * Fraction::from(factor))
}

fn parts(law: impl Fn(&[MassMoments<Fraction>], &Vector) -> MassMoments<Fraction>) -> Scope {
    let all = points();
    let together = law(&all, &vector("d"));
    let pair = law(&all[1..], &Vector::zeros());
    let (dumbbell, in_steps) = (pair.inertia.clone(), law(&[pair, all[0].clone()], &Vector::zeros()));
    let [m] = variables(["m"]);
    let alone = MassMoments {
        mass: m.clone(),
        centre: vector("r"),
        inertia: Matrix::from_diagonal_element(m.clone()),
    };
    let scope = Scope::default().with("I", law(&[alone], &vector("d")).inertia).with("m", m);
    let scope = scope.with("C", together.centre).with("c", in_steps.centre).with("T", dumbbell);
    let scope = scope.with("A", together.inertia).with("B", in_steps.inertia).with("n", vector("n"));
    let (one, other) = (&all[1], &all[2]);
    scope
        .with_all([("u", one.mass.clone()), ("v", other.mass.clone())])
        .with("s", &one.centre - &other.centre)
}
