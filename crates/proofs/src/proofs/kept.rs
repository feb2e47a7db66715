//! Why methods conserve what they conserve, for all bodies and steps of any size: the algebra of their
//! equations, which are written here a second time.
//!
//! The steps of Munthe-Kaas, Buss, the midpoint rule, Moser and Veselov, and every splitting are turns, which
//! conserve the momentum. The angle of a turn of a splitting depends on a momentum component that the turn
//! does not change, so a splitting with symmetric coefficients is reversible. The midpoint rule is a turn by
//! Cayley's formula with the step times the inverse moments over two as `g`; Moser and Veselov's is one, up
//! to the factor `1 + |c|²`, with `a/I_i + b`. Since `a` and `b` depend only on energy and `|L|`, both
//! methods conserve the energy; since the opposite sign of `c` exchanges the two momenta, both are
//! reversible. Gauss's methods conserve every quadratic quantity whose rate is zero at every state: energy,
//! `|L|²` and the attitude's length; the stages in reverse order are those of the step back. The rules of
//! engines conserve the lengths by which they divide, or a momentum that they do not change.

use crate::number::{Fraction, Relations};
use crate::proof::{Case, same};
use crate::proofs::order::Number;
use crate::symbols::{Matrix, variables, vector};
use crate::tex::Scope;
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::attitude::{product, rotation_matrix};
use tumbling::laws::rests_of_gauss;

proofs! {
    "step" {
        [Again] "a-turn-keeps-the-momentum": turned(|r| r.transpose()),
            r"A step that turns the attitude by any unit quaternion, and the momentum in body axes by its inverse, keeps the square of the attitude's length, $l' = l$, that of the momentum's, $M'\cdot M' = M\cdot M$, and the momentum in the world, $R' M' = R M$.";
            but "the momentum turned by the turn itself": turned(Clone::clone),
        [Again] "a-turn-about-an-axis-is-undone": undone(2),
            r"A turn about the third axis leaves the momentum along it alone, $m' = m$, and the turn by the opposite angle undoes it, $P = (1, (0, 0, 0))$.";
            but "the momentum along another axis": undone(1),
        [Again] "cayley-turn-keeps-energy": cayley(&Fraction::one()),
            r"With $c = (g_1 M_1, g_2 M_2, g_3 M_3)$ the turn by half-angle tangents takes $B = M + c\times M$ to $A = M - c\times M$, up to a factor: $R B = (1 + c\cdot c) A$. Both have the same length, $A\cdot A = B\cdot B$, and the same energy, $g_1 A_1^2 + g_2 A_2^2 + g_3 A_3^2 = g_1 B_1^2 + g_2 B_2^2 + g_3 B_3^2$.";
            but "a cross product half as long": cayley(&Fraction::ratio(1, 2)),
        [Again] "gauss-keeps-squares": squares(&Fraction::one()),
            r"In the library's collocations of two and of three stages, each stage sees half of the whole change and a rest, by coefficients that are antisymmetric. So the change of a square is twice the sum $S$ of each stage's change times its value, $e^2 - y^2 = 2 S$; and each stage is as far from the end with the other sign of that rest as it is from the start.";
            but "the weights of the stages' mean a third too large": squares(&Fraction::ratio(4, 3)),
    }
}

fn quaternion([w, x, y, z]: [Fraction; 4]) -> Quaternion<Fraction> {
    Quaternion::new(w, x, y, z)
}

fn turned(back: impl Fn(&Matrix) -> Matrix) -> Scope {
    let names = ["t0", "t1", "t2", "t3"];
    let (q, t) = (quaternion(variables(["w", "x", "y", "z"])), quaternion(variables(names)));
    let (before, end) = (vector("L"), product(&q, &t));
    let [length, other] = [&q, &end].map(|q| q.coords.dot(&q.coords));
    let scope = Scope::default().with_all([("l", length), ("l'", other)]).with("R", rotation_matrix(&q));
    let scope = scope.with("R'", rotation_matrix(&end)).with("M'", back(&rotation_matrix(&t)) * &before);
    scope.with("M", before).under(Relations::unit_quaternion(names))
}

fn undone(axis: usize) -> Scope {
    let ([c, s], o) = (variables(["c", "s"]), Fraction::zero());
    let turn = |s: Fraction| quaternion([c.clone(), o.clone(), o.clone(), s]);
    let (turn, back) = (turn(s.clone()), turn(-s));
    let (before, after) = (vector("L"), rotation_matrix(&back) * vector("L"));
    let scope = Scope::default().with("m", before[axis].clone()).with("m'", after[axis].clone());
    scope.with("P", product(&turn, &back)).under(Relations::circle("c", "s"))
}

fn cayley(share: &Fraction) -> Scope {
    let (g, mean) = (vector("g"), vector("M"));
    let c = g.component_mul(&mean);
    let across = c.cross(&mean) * share.clone();
    let (before, after) = (&mean + &across, &mean - &across);
    let turn = quaternion([Fraction::one(), c.x.clone(), c.y.clone(), c.z.clone()]);
    let scope = Scope::default().with_each("A", &after).with_each("B", &before).with_each("g", &g);
    let scope = scope.with_each("M", &mean).with("M", mean).with("A", after).with("B", before);
    scope.with("c", c).with("R", rotation_matrix(&turn).transpose())
}

fn squares(mean: &Fraction) -> Case<Vec<Scope>> {
    let (two, three) = rests_of_gauss();
    Ok(vec![collocated(&two, mean)?, collocated(&three, mean)?])
}

/// With the library's rests of the coefficients, over the weights.
fn collocated<const N: usize>(off: &[[Number; N]; N], mean: &Fraction) -> Case {
    let (start, changes) = (Fraction::variable("y"), vector("k"));
    let total = changes.iter().take(N).fold(Fraction::zero(), |sum, k| sum + k);
    let (half, end) = (&total * Fraction::ratio(1, 2) * mean, &start + &total);
    let mut sum = Fraction::zero();
    for (row, change) in off.iter().zip(&changes) {
        let known = |x: &Number| x.coefficient(0).unwrap_or(Fraction::ratio(1, 0));
        let rest = row.iter().zip(&changes).fold(Fraction::zero(), |sum, (x, k)| sum + known(x) * k);
        let stage = &start + &half + &rest;
        same("a stage of the step back", &(&end - &half + rest), &stage)?;
        sum += stage * change;
    }
    Ok(Scope::default().with_all([("S", sum), ("y", start), ("e", end)]))
}
