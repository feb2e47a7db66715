//! The position stage of an engine: its step keeps energy and momentum whatever its pace, so that the energy
//! that a body gains is the work done between the steps.

use crate::number::{Fraction, Relations};
use crate::proof::{Mutant, Outcome, Proof, Residue, same, same_vectors, same_vectors_under, vanishes};
use crate::symbols::{Vector, diagonal, scalar, symmetric, variables, vector};
use nalgebra::Quaternion;
use num_traits::One;
use tumbling::attitude::rotation_matrix;
use tumbling::dynamics::observe;
use tumbling::step::{change_of_spin, conserving_turn};

pub(super) const PROOFS: &[Proof] = &[
    Proof {
        name: "position-stage-keeps-energy",
        part: "step",
        statement: "The turn of the position stage leaves the energy as it was, for every body, spin, time step, pace and weight b.",
        check: || Claim::TRUE.energy(),
        mutants: &[
            Mutant {
                change: "one moment larger in the energy",
                check: || Claim { added: 1, ..Claim::TRUE }.energy(),
            },
            Mutant {
                change: "a root of another pace",
                check: || Claim { faster: 1, ..Claim::TRUE }.energy(),
            },
        ],
    },
    Proof {
        name: "position-stage-keeps-momentum",
        part: "step",
        statement: "The turn of the position stage takes the momentum along the axes before it to that along the axes after it: in the \
                    world the momentum stays, for every body, spin, time step, pace and weight b.",
        check: || Claim::TRUE.momentum(),
        mutants: &[
            Mutant {
                change: "another weight about one axis",
                check: || Claim { uneven: 1, ..Claim::TRUE }.momentum(),
            },
            Mutant {
                change: "a root of another pace",
                check: || Claim { faster: 1, ..Claim::TRUE }.momentum(),
            },
        ],
    },
    Proof {
        name: "position-stage-spin-belongs-to-its-momentum",
        part: "step",
        statement: "The change of the spin that the position stage adds in the world is that of the body's own spin, turned with it.",
        check: || spin(change_of_spin),
        mutants: &[Mutant {
            change: "the change left as the slip",
            check: || spin(|(_, [_, slip])| slip.clone()),
        }],
    },
    Proof {
        name: "energy-gained-is-work-done",
        part: "step",
        statement: "An impulse of torque P, in any direction of body or world, raises the energy by P . (w + w')/2, w and w' being the \
                    spins before and after it; half of a constant torque's impulse before the position stage and half after it, by \
                    the sum of the two; taking the share s of the spin away takes the share 2 s - s² of the energy. The position \
                    stage adds nothing to it.",
        check: || work(|p, before, after| p.dot(&(before + after)) / Fraction::from(2)),
        mutants: &[
            Mutant { change: "with the spin before alone", check: || work(|p, before, _| p.dot(before)) },
            Mutant { change: "with the spin after alone", check: || work(|p, _, after| p.dot(after)) },
        ],
    },
];

/// What is claimed of the turn; each number is zero in the claim that is proven.
#[derive(Clone, Copy)]
struct Claim {
    /// To the third moment of the body whose energy is kept.
    added: i64,
    /// To the pace under the first root.
    faster: i64,
    /// To the weight about the first axis.
    uneven: i64,
}

/// A turn of a body, and what is true of its roots.
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

impl Claim {
    const TRUE: Self = Self { added: 0, faster: 0, uneven: 0 };

    fn turned(self) -> Result<Turned, Residue> {
        let moments = vector("I");
        // A spin in units that leave no quotient under the roots: every spin is one of these.
        let omega = Vector::from_fn(|i, _| {
            &moments[(i + 1) % 3] * &moments[(i + 2) % 3] * Fraction::variable(&format!("s{}", i + 1))
        });
        let coupling =
            [0, 1, 2].map(|i| (&moments[(i + 1) % 3] - &moments[(i + 2) % 3]) / moments[i].clone());
        let [h, pace, b] = variables(["h", "X", "b"]);
        let mut weights = [0, 1, 2].map(|i| Fraction::one() + &moments[i] * &b);
        weights[0] = &weights[0] + Fraction::from(self.uneven);
        let names = ["Q1", "Q2", "Q3"];
        let mut squares = Vec::new();
        let (below, [tangents, slip]) =
            conserving_turn(&coupling, &weights, omega.as_ref(), &h, &pace, |square| {
                let name = names[squares.len() % 3];
                let square = if squares.is_empty() { square + Fraction::from(self.faster) } else { square };
                squares.push((name.into(), square.numerator().clone()));
                Fraction::variable(name)
            });
        let Ok(roots) = Relations::new(squares) else {
            return Err(Residue::Missing { claim: "roots of what holds no root".to_owned() });
        };
        let change = Vector::from_fn(|i, _| &slip[i] / &weights[i]);
        let tangents = tangents.into();
        Ok(Turned { moments, omega, below, change, tangents, roots })
    }

    fn energy(self) -> Outcome {
        let t = self.turned()?;
        let mut moments = t.moments;
        moments.z = &moments.z + Fraction::from(self.added);
        let momentum = |w: &Vector| moments.component_mul(w);
        let after = t.omega.map(|x| x * &t.below) + &t.change;
        // The difference of two squares: energy after less energy before, times the square of `below`.
        let gained = observe::energy(&t.change, &momentum(&(after + t.omega.map(|x| x * &t.below))));
        vanishes("the energy gained", &gained, &t.roots)
    }

    fn momentum(self) -> Outcome {
        let t = self.turned()?;
        let before = t.moments.component_mul(&t.omega.map(|x| x * &t.below));
        let after = &before + t.moments.component_mul(&t.change);
        // A turn by the tangents c takes y, along the axes after it, to x with (1 - c x) x = (1 + c x) y.
        let scaled = |v: &Vector| v.map(|x| x * &t.below);
        let (after, before) =
            (scaled(&after) + t.tangents.cross(&after), scaled(&before) - t.tangents.cross(&before));
        same_vectors_under(&t.roots, "the momentum", &after, &before)
    }
}

fn spin(change: impl Fn(&(Fraction, [[Fraction; 3]; 2])) -> [Fraction; 3]) -> Outcome {
    let (c, before, after) = (vector("c"), vector("w"), vector("v"));
    let below = Fraction::variable("d");
    let scaled = |v: &Vector| v.map(|x| x * &below);
    let slip = (scaled(&after) + c.cross(&after)) - (scaled(&before) - c.cross(&before));
    let stretched = &below * &below + c.dot(&c);
    let [x, y, z] = c.clone().into();
    let turned = rotation_matrix(&Quaternion::new(below.clone(), x, y, z)) * &after;
    let expected = scaled(&(turned - scalar(&stretched) * &before));
    let turn = (below, [c.into(), slip.into()]);
    same_vectors("the change of the spin", &Vector::from(change(&turn)), &expected)
}

fn work(of_impulse: impl Fn(&Vector, &Vector, &Vector) -> Fraction) -> Outcome {
    // In axes of the world the inverse tensor is any symmetric matrix; in its own it is diagonal.
    for inverse in [symmetric("J"), diagonal(&vector("J"))] {
        let energy = |l: &Vector| observe::energy(&(&inverse * l), l);
        let (start, first, turned, second) = (vector("L"), vector("P"), vector("M"), vector("R"));
        let kicked = &start + &first;
        let gained = energy(&kicked) - energy(&start);
        let done = of_impulse(&first, &(&inverse * &start), &(&inverse * &kicked));
        same("an impulse", &gained, &done)?;
        // After the position stage momentum and attitude are others, the energy is the same.
        let end = &turned + &second;
        let all = gained + energy(&end) - energy(&turned);
        let done = done + of_impulse(&second, &(&inverse * &turned), &(&inverse * &end));
        same("two halves", &all, &done)?;
        let s = Fraction::variable("s");
        let left = start.map(|x| x * (Fraction::one() - &s));
        let share = (Fraction::from(2) - &s) * &s;
        same("damping", &(energy(&start) - energy(&left)), &(energy(&start) * share))?;
    }
    Ok(())
}
