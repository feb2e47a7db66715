//! Why methods keep what they keep, for all bodies and steps of any size: the algebra of their equations,
//! which are written here a second time.
//!
//! Those of Munthe-Kaas, Buss, the midpoint, Moser and Veselov, and every splitting, make turns, which keep
//! the momentum. The angle of a splitting's turn rests on the momentum that it leaves alone: so shares that
//! are the same backwards make it reversible. The midpoint rule is a turn by Cayley's formula with the step
//! times the inverse moments over two for `g`, and Moser and Veselov's, up to the factor `1 + |c|²`, with
//! `a/I_i + b`: as `a` and `b` depend on energy and `|L|` alone, both keep the energy, and as the other sign
//! of `c` exchanges the two momenta, both are reversible. In Gauss's methods what is square and has no rate
//! at any state stays: energy, `|L|²` and the attitude's length; the stages in reverse order are those of the
//! step back. The rules of engines keep the lengths that they divide by, or a momentum that they do not
//! change.

use crate::number::{Fraction, Relations};
use crate::proof::{Outcome, same, same_entries_under, same_under};
use crate::symbols::{Matrix, Vector, variables, vector};
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::attitude::{product, rotation_matrix};

proofs! {
    "step" {
        "a-turn-keeps-the-momentum": turned(|r| r.transpose()),
            "A step that turns the attitude by any unit quaternion, and the momentum in body axes by its inverse, keeps the attitude's length, the momentum's and the momentum in the world.";
            but "the momentum turned by the turn itself": turned(Clone::clone),
        "a-turn-about-an-axis-is-undone": undone(2),
            "A turn about the third axis leaves the momentum along it alone, and the turn by the opposite angle undoes it.";
            but "the momentum along another axis": undone(1),
        "cayley-turn-keeps-energy": cayley(&Fraction::one()),
            "With c = (g1 M1, g2 M2, g3 M3), the turn by half-angle tangents c takes M + c x M to M - c x M, and both have the same length and the same sum of g_i L_i².";
            but "a cross product half as long": cayley(&Fraction::ratio(1, 2)),
        "gauss-keeps-squares": squares(&Fraction::one()),
            "In a collocation with the coefficients b_j (1/2 + off_ij), off antisymmetric, of two or three stages, the change of a square is twice the sum of each stage's change times its value, \
            and each stage is as far from the end with the other sign of off as it is from the start.";
            but "the weights of the stages' mean a third too large": squares(&Fraction::ratio(4, 3)),
    }
}

fn quaternion([w, x, y, z]: [Fraction; 4]) -> Quaternion<Fraction> {
    Quaternion::new(w, x, y, z)
}

fn turned(back: impl Fn(&Matrix) -> Matrix) -> Outcome {
    let names = ["t0", "t1", "t2", "t3"];
    let (q, t) = (quaternion(variables(["w", "x", "y", "z"])), quaternion(variables(names)));
    let unit = Relations::unit_quaternion(names);
    let (before, after) = (vector("L"), back(&rotation_matrix(&t)) * vector("L"));
    let end = product(&q, &t);
    same_under(&unit, "the attitude's length", &end.coords.dot(&end.coords), &q.coords.dot(&q.coords))?;
    same_under(&unit, "the momentum's length", &after.dot(&after), &before.dot(&before))?;
    let world = [rotation_matrix(&end) * after, rotation_matrix(&q) * before];
    same_entries_under(&unit, "the momentum in the world", &world[0], &world[1])
}

fn undone(axis: usize) -> Outcome {
    let ([c, s], o) = (variables(["c", "s"]), Fraction::zero());
    let unit = Relations::circle("c", "s");
    let turn = |s: Fraction| quaternion([c.clone(), o.clone(), o.clone(), s]);
    let (turn, back) = (turn(s.clone()), turn(-s));
    let (before, after) = (vector("L"), rotation_matrix(&back) * vector("L"));
    same_under(&unit, "the momentum along the axis", &after[axis], &before[axis])?;
    let none = quaternion([Fraction::one(), o.clone(), o.clone(), o]);
    same_entries_under(&unit, "both turns", &product(&turn, &back).coords, &none.coords)
}

fn cayley(share: &Fraction) -> Outcome {
    let (g, mean) = (vector("g"), vector("M"));
    let c = g.component_mul(&mean);
    let across = c.cross(&mean) * share.clone();
    let (before, after) = (&mean + &across, &mean - &across);
    let turn = quaternion([Fraction::one(), c.x.clone(), c.y.clone(), c.z.clone()]);
    let scaled = &after * (Fraction::one() + c.dot(&c));
    let none = Relations::none();
    same_entries_under(&none, "the turn", &(rotation_matrix(&turn).transpose() * &before), &scaled)?;
    same("the length", &after.dot(&after), &before.dot(&before))?;
    let energy = |l: &Vector| g.component_mul(l).dot(l);
    same("the energy", &energy(&after), &energy(&before))
}

fn squares(mean: &Fraction) -> Outcome {
    let [p, q, r, start] = variables(["p", "q", "r", "y"]);
    let changes = vector("k");
    let end = &start + changes.sum();
    let [np, nq, nr] = [&p, &q, &r].map(|x| -x.clone());
    let none = Fraction::zero;
    let off = Matrix::new(none(), np, nq, p, none(), nr, q, r, none());
    let half = changes.sum() * Fraction::ratio(1, 2) * mean;
    let off = &off * &changes;
    let stages = off.map(|x| &start + &half + x);
    let (gained, work) = (&end * &end - &start * &start, changes.dot(&stages) * Fraction::from(2));
    same("the change of the square", &gained, &work)?;
    let back = off.map(|x| &end - &half + x);
    same_entries_under(&Relations::none(), "the stages of the step back", &back, &stages)
}
