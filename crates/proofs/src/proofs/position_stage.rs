//! The position stage of an engine: its step conserves energy and momentum for any rate, its roots are real
//! and its divisor is not zero; and the work of an impulse.

use crate::number::{Fraction, Relations};
use crate::proof::{Residue, same};
use crate::symbols::{Matrix, Vector, diagonal, quaternion, symmetric, variables, vector};
use crate::tex::Scope;
use num_traits::One;
use tumbling::attitude::rotation_matrix;
use tumbling::dynamics::observe;
use tumbling::laws::{change_of_spin, conserving_rate, conserving_turn};

proofs! {
    "step" {
        "position-stage-keeps-energy": energy(0, 0),
            r"The turn of the position stage leaves the energy as it was, for every body, spin, time step, rate and weight for which its three roots are real and its divisor $d$ is not zero: with the spins before and after times $d$, $(I_1 v_1, I_2 v_2, I_3 v_3)\cdot v = (I_1 w_1, I_2 w_2, I_3 w_3)\cdot w$.";
            but "one moment larger in the energy": energy(1, 0),
            but "a root of another rate": energy(0, 1),
        "position-stage-keeps-momentum": momentum(0, 0),
            r"The turn of the position stage takes the momentum along the axes before it to that along the axes after it, for every body, spin, time step, rate and weight for which the three roots are real and the divisor is not zero: $d M' + c\times M' = d M - c\times M$. Of any two vectors and $s = d v + c\times v - d w + c\times w$ it is true that $d s + c\times s + \frac{c\cdot s}{d} c = R v - (d^2 + c\cdot c) w$, with the matrix of the turn whose half-angle tangents are $c$ over $d$, up to a factor: so in the world the momentum stays.";
            but "another weight about one axis": momentum(1, 0),
            but "a root of another rate": momentum(0, 1),
        "position-stage-spin-belongs-to-its-momentum": spin(change_of_spin),
            r"The change of the spin that the position stage adds in the world is that of the body's own spin, turned with it: up to a factor, $C = d (R v - (d^2 + c\cdot c) w)$.";
            but "the change left as the slip": spin(|(_, [_, slip])| slip.clone()),
        "position-stage-roots-are-real": real([51, 51]),
            r"Where the numbers that are added to the rate under the three roots come to at most the square of 0.51 without their signs, the rate is $X > \tfrac{9}{10}$ and each number under a root $X + u > \tfrac{4}{5}$; with such roots, and bends of at most 0.51, what the turn is divided by is $d > 2$. That a part of a step, a turn of at most half a radian, bounds them so is no part of it.";
            but "turns of up to two radians": real([200, 51]),
            but "bends of up to two": real([51, 200]),
        "energy-gained-is-work-done": work(1),
            r"An impulse of torque, in any direction of body or world, raises the energy by $A = \tfrac{1}{2} P\cdot (\omega + \omega')$, with the spins before and after it; taking the share $s$ of the spin away takes $D = (2 s - s^2) E$ of the energy.";
            but "the spin before it alone": work(0),
    }
}

/// A turn of a body, and the relations of its roots.
struct Turned {
    moments: Vector,
    omega: Vector,
    /// What the turn's numbers are to be divided by.
    below: Fraction,
    /// The change of the spin from the axes before to those after, times `below`.
    change: Vector,
    /// Times `below`.
    tangents: Vector,
    roots: Relations,
}

/// With one weight and the rate under one root off by these.
fn turned(uneven: i64, faster: i64) -> Result<Turned, Residue> {
    let moments = vector("I");
    // A spin in units that leave no quotient under the roots: every spin is one of these.
    let omega = Vector::from_fn(|i, _| {
        &moments[(i + 1) % 3] * &moments[(i + 2) % 3] * Fraction::variable(&format!("s{}", i + 1))
    });
    let coupling = [0, 1, 2].map(|i| (&moments[(i + 1) % 3] - &moments[(i + 2) % 3]) / moments[i].clone());
    let [h, rate, b] = variables(["h", "X", "b"]);
    let mut weights = [0, 1, 2].map(|i| Fraction::one() + &moments[i] * &b);
    weights[0] = &weights[0] + Fraction::from(uneven);
    let names = ["Q1", "Q2", "Q3"];
    let mut squares = Vec::new();
    let (below, [tangents, slip]) =
        conserving_turn(&coupling, &weights, omega.as_ref(), &h, &rate, |square| {
            let name = names[squares.len() % 3];
            let square = if squares.is_empty() { square + Fraction::from(faster) } else { square };
            squares.push((name, square.numerator().clone()));
            Fraction::variable(name)
        });
    let roots = Relations::new(squares)?;
    let change = Vector::from_fn(|i, _| &slip[i] / &weights[i]);
    let tangents = tangents.into();
    Ok(Turned { moments, omega, below, change, tangents, roots })
}

/// With one moment of the body whose energy is kept off by `added`.
fn energy(added: i64, faster: i64) -> Result<Scope, Residue> {
    let mut t = turned(0, faster)?;
    t.moments.z += Fraction::from(added);
    let before = t.omega.map(|x| x * &t.below);
    let after = &before + &t.change;
    let scope = Scope::default().with_each("I", &t.moments).with_each("w", &before).with_each("v", &after);
    Ok(scope.with("w", before).with("v", after).with("d", t.below).under(t.roots))
}

fn momentum(uneven: i64, faster: i64) -> Result<Vec<Scope>, Residue> {
    let t = turned(uneven, faster)?;
    let before = t.moments.component_mul(&t.omega.map(|x| x * &t.below));
    let after = &before + t.moments.component_mul(&t.change);
    let scope = Scope::default().with("M", before).with("M'", after).with("c", t.tangents);
    Ok(vec![scope.with("d", t.below).under(t.roots), between(&vector("v"), &vector("w")).0])
}

/// A turn by tangents, and how far it does not take one vector to the other.
fn between(after: &Vector, before: &Vector) -> (Scope, Vector) {
    let (c, d) = (vector("c"), Fraction::variable("d"));
    let scaled = |v: &Vector| v.map(|x| x * &d);
    let slip = scaled(after) + c.cross(after) - (scaled(before) - c.cross(before));
    let scope = Scope::default().with("R", rotation_matrix(&quaternion(d.clone(), &c))).with("c", c);
    (scope.with("d", d).with("v", after.clone()).with("w", before.clone()).with("s", slip.clone()), slip)
}

fn spin(change: impl Fn(&(Fraction, [[Fraction; 3]; 2])) -> [Fraction; 3]) -> Scope {
    let (scope, slip) = between(&vector("v"), &vector("w"));
    let turn = (Fraction::variable("d"), [vector("c").into(), slip.into()]);
    scope.with("C", Vector::from(change(&turn)))
}

/// The letters of these bounds.
const POSITIVE: [&str; 17] =
    ["x1", "x2", "x3", "x4", "p", "r1", "r2", "r3", "y1", "y2", "y3", "z1", "z2", "z3", "b1", "b2", "b3"];

/// With the longest turn and the largest bend in hundredths: each is reached where a share of it is all.
fn real([turn, bend]: [i64; 2]) -> Result<Vec<Scope>, Residue> {
    let (mut cases, known) = (Vec::new(), |name, x| Scope::default().with(name, x).positive(POSITIVE));
    let hundredths = |n: i64| Fraction::ratio(n, 100);
    let [x, y, z, rest] = variables(["x1", "x2", "x3", "x4"]);
    let (all, limit) = (&x + &y + &z + rest, hundredths(turn).pow(2));
    let rate_of = |added: [Fraction; 3]| conserving_rate(added, |n| Fraction::ratio(1, n.into()));
    let [a, b, c] = variables(["u1", "u2", "u3"]);
    let rate = rate_of([a.clone(), b.clone(), c.clone()]);
    same("the rate with two exchanged", &rate, &rate_of([b.clone(), a.clone(), c.clone()]))?;
    same("the rate with two others exchanged", &rate, &rate_of([a, c, b]))?;
    // So the first root stands for all three, and the other two may change places.
    for signs in [[1, 1, 1], [1, 1, -1], [1, -1, -1], [-1, 1, 1], [-1, 1, -1], [-1, -1, -1]] {
        let added = [0, 1, 2].map(|i| [&x, &y, &z][i] * &limit * Fraction::from(signs[i]) / &all);
        let rate = rate_of(added.clone());
        cases.push(known("X", rate).with("u", added[0].clone()));
    }
    // Only the product of the three bends counts, of either sign.
    for sign in [1, -1] {
        let coupling = vector("a");
        let bends = ["1", "2", "3"].map(|i| {
            let [part, other] = ["y", "z"].map(|name| Fraction::variable(&format!("{name}{i}")));
            hundredths(bend) * &part / (&part + other)
        });
        let omega = [2, 0, 1].map(|i| &bends[i] / &coupling[i]);
        let omega = [&omega[0] * Fraction::from(sign), omega[1].clone(), omega[2].clone()];
        let rate = Fraction::variable("p") + hundredths(90);
        let mut count = 0;
        let root = |_| {
            count += 1;
            hundredths(80) + Fraction::variable(&format!("r{count}"))
        };
        let (b, h) = (vector("b"), Fraction::one());
        let (below, _) = conserving_turn(coupling.as_ref(), b.as_ref(), &omega, &h, &rate, root);
        cases.push(known("d", below));
    }
    Ok(cases)
}

/// With a spin at the end that is the spin at the start plus this number of times its change.
fn work(counted: i64) -> Vec<Scope> {
    let s = Fraction::variable("s");
    // In axes of the world the inverse tensor is any symmetric matrix; in its own it is diagonal.
    let case = |inverse: Matrix| {
        let energy = |l: &Vector| observe::energy(&(&inverse * l), l);
        let (start, impulse) = (vector("L"), vector("P"));
        let (end, left) = (&start + &impulse, start.map(|x| x * (Fraction::one() - &s)));
        let (before, change) = (&inverse * &start, &inverse * &impulse);
        Scope::default()
            .with_all([("A", energy(&end) - energy(&start)), ("D", energy(&start) - energy(&left))])
            .with_all([("E", energy(&start)), ("s", s.clone())])
            .with("P", impulse)
            .with(r"\omega'", &before + change * Fraction::from(counted))
            .with(r"\omega", before)
    };
    [symmetric("J"), diagonal(&vector("J"))].map(case).into()
}
