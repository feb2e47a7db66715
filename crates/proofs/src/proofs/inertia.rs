//! The tensor itself: what it is for one point, and how it moves with the point it is taken about.

use crate::number::Fraction;
use crate::proof::{Outcome, same_entries};
use crate::symbols::{Matrix, Vector, scalar, variables, vector};
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
            "The tensor of any three points, about a point away from their centre, is that about the centre plus that of one point with all their mass.";
            but "subtracted, not added": parallel_axes(-1),
        "parts-of-a-body": parts(combined),
            "Three points put together in steps, counted from any point, make the same body as at once; two turn as one with their reduced mass; a part alone stays what it is.";
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

fn parallel_axes(factor: i64) -> Outcome {
    let (points, away) = (points(), vector("d"));
    let body = combined(&points, &Vector::zeros());
    let from = |position: &Vector| position - &away;
    let about = points.iter().fold(Matrix::zeros(), |sum, p| sum + point_mass(&p.mass, &from(&p.centre)));
    let shift = point_mass(&body.mass, &from(&body.centre)).map(|x| x * Fraction::from(factor));
    same_entries("the tensor about d", &about, &(body.inertia + shift))
}

fn parts(law: impl Fn(&[MassMoments<Fraction>], &Vector) -> MassMoments<Fraction>) -> Outcome {
    let all = points();
    let together = law(&all, &vector("d"));
    let pair = law(&all[1..], &Vector::zeros());
    let in_steps = law(&[pair, all[0].clone()], &Vector::zeros());
    same_entries("centre", &together.centre, &in_steps.centre)?;
    same_entries("inertia", &together.inertia, &in_steps.inertia)?;
    // Two points turn about their centre as one with their reduced mass at their distance.
    let (light, heavy) = (&all[1], &all[2]);
    let reduced = &light.mass * &heavy.mass / (&light.mass + &heavy.mass);
    let dumbbell = law(&all[1..], &Vector::zeros()).inertia;
    same_entries("two points", &dumbbell, &point_mass(&reduced, &(&light.centre - &heavy.centre)))?;
    // And one part alone stays what it is.
    let [m] = variables(["m"]);
    let alone = MassMoments { mass: m.clone(), centre: vector("r"), inertia: scalar(&m) };
    same_entries("one part alone", &law(&[alone], &vector("d")).inertia, &scalar(&m))
}
