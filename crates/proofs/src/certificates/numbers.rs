//! Numbers of the book that no fraction gives: each enclosed here by intervals, and by Coq from a formula.

use super::{Certificate, plain};
use crate::interval::{Interval, geometry, motion::FreeMotion};
use crate::{Rational, given};
use nalgebra::Vector3;
use std::fmt::Write as _;
use tumbling::dynamics::stability::rate_squared;
use tumbling::solid::{Cuboid, Shape};

/// A number, as both kernels have it.
struct Number {
    name: &'static str,
    words: &'static str,
    /// For Coq: what is named first, and the formula.
    named: &'static [&'static str],
    formula: &'static str,
    /// As the library's laws enclose it; and the number of decimals that the book prints.
    enclosed: fn() -> Interval,
    decimals: usize,
}

/// The constants of the closed form, as the book derives them, for the book that is tossed.
const TOSSED: &[&str] = &[
    "across := 17041 / 1000000",
    "middle := 39604 / 1000000",
    "circled := 55845 / 1000000",
    "spin := 4 * PI",
    "small := spin / 20",
    "p2 := across * (circled - across) * small ^ 2 + middle * (circled - middle) * spin ^ 2",
    "q2 := middle * (middle - across) * spin ^ 2 + circled * (circled - across) * small ^ 2",
    "m := (middle - across) * p2 / ((circled - middle) * q2)",
    "eta := sqrt ((circled - middle) * q2 / (across * middle * circled))",
    "start := atan (20 * sqrt (middle * (circled - middle) / (across * (circled - across))))",
];

const NUMBERS: &[Number] = &[
    Number {
        name: "gap_of_the_box",
        words: "Degrees between spin and momentum of a box with edges 2, 1 and 3 m, spun along (1, 1, 0).",
        named: &[],
        formula: "atan (3 / 23) * 180 / PI",
        enclosed: || angle_to_the_momentum(&Vector3::new(given!(1), given!(1), given!(0))),
        decimals: 1,
    },
    Number {
        name: "momentum_of_the_box",
        words: "Degrees between the first axis and the same momentum.",
        named: &[],
        formula: "atan (13 / 10) * 180 / PI",
        enclosed: || angle_to_the_momentum(&Vector3::new(given!(1), given!(0), given!(0))),
        decimals: 1,
    },
    Number {
        name: "growth_of_the_box",
        words: "The rate, per second, at which a push grows of the box that spins at 10 rad/s about its middle axis.",
        named: &[],
        formula: "10 * sqrt (3 / 13)",
        enclosed: growth,
        decimals: 2,
    },
    Number {
        name: "doubling_of_the_box",
        words: "The seconds in which it doubles.",
        named: &[],
        formula: "ln 2 / (10 * sqrt (3 / 13))",
        enclosed: || given!(Interval: 2).ln() / growth(),
        decimals: 2,
    },
    Number {
        name: "first_flip_of_the_book",
        words: "The seconds to the first flip of the tossed book, by Legendre's integral.",
        named: TOSSED,
        formula: "RInt (fun t => 1 / sqrt (1 - m * sin t ^ 2)) start PI / eta",
        enclosed: || tossed().map_or(Interval::ALL, |motion| motion.flip(0)),
        decimals: 2,
    },
    Number {
        name: "between_flips_of_the_book",
        words: "The seconds from one flip to the next.",
        named: TOSSED,
        formula: "RInt (fun t => 1 / sqrt (1 - m * sin t ^ 2)) 0 PI / eta",
        enclosed: || tossed().map_or(Interval::ALL, |motion| motion.between_flips()),
        decimals: 2,
    },
];

fn angle_to_the_momentum(from: &Vector3<Interval>) -> Interval {
    let edges: [Interval; 3] = [given!(2), given!(1), given!(3)];
    let omega = Vector3::new(given!(1), given!(1), given!(0));
    let momentum = Cuboid::moments(&given!(1), edges.each_ref()).component_mul(&omega);
    geometry::angle(&momentum, from).to_degrees()
}

fn growth() -> Interval {
    let [easy, middle, hard]: [Rational; 3] = [given!(5), given!(10), given!(13)];
    Interval::from(rate_squared(&given!(10), &middle, &easy, &hard)).sqrt()
}

fn tossed() -> Option<FreeMotion> {
    let edges: [Interval; 3] = [given!(0.129), given!(0.020), given!(0.198)];
    let moments = Cuboid::moments(&given!(0.340), edges.each_ref());
    let spin = Interval::PI * given!(4);
    let small = spin / given!(20);
    FreeMotion::new(&moments, &Vector3::new(spin, small, small))
}

/// The theorems: each number rounds to the digits that the intervals give, and not to the next ones.
pub(super) fn certificate() -> Certificate {
    let mut all = Certificate::new("numbers");
    all.text += "From Coquelicot Require Import Coquelicot.\n";
    for number in NUMBERS {
        let printed = format!("{:.*}", number.decimals, (number.enclosed)());
        let Ok(digits) = printed.replace('.', "").parse::<i64>() else {
            all.missing.push(format!("{}: {printed}", number.name));
            continue;
        };
        let below = 2 * 10_i64.pow(u32::try_from(number.decimals).unwrap_or(0));
        let named: String = number.named.iter().map(|named| format!("  let {named} in\n")).collect();
        let tactic = if number.named.is_empty() { "interval" } else { "integral" };
        let (name, formula) = (number.name, number.formula);
        let between = |n: i64| format!("{n} / {below} < {formula} < {} / {below}", n + 2);
        let _ = write!(all.text, "\n(** {} It rounds to {printed}. *)\n", plain(number.words));
        let (true_one, next) = (between(2 * digits - 1), between(2 * digits + 1));
        let _ = write!(
            all.text,
            "Theorem {name} :\n{named}  {true_one}.\nProof. cbv zeta. split; {tactic}. Qed.\n\n\
             (* With the last digit raised by one. *)\n\
             Theorem {name}_mutant_1 :\n{named}  ~ ({next}).\n\
             Proof. cbv zeta. intros [H _]. revert H. apply Rle_not_lt. {tactic}. Qed.\n"
        );
        all.proofs.push(name);
        all.theorems += 1;
        all.mutants += 1;
    }
    all
}
