//! The numbers that Coq encloses from formulas, by this crate's own intervals: the digits of both are those
//! of the book.

use nalgebra::Vector3;
use tumbling::dynamics::stability::rate_squared;
use tumbling::solid::{Cuboid, Shape};
use tumbling_proofs::interval::{Interval, geometry, motion::FreeMotion};
use tumbling_proofs::{Rational, given};

fn angle_to_the_momentum(from: &Vector3<Interval>) -> Interval {
    let edges: [Interval; 3] = [given!(2), given!(1), given!(3)];
    let omega = Vector3::new(given!(1), given!(1), given!(0));
    let momentum = Cuboid::moments(&given!(1), edges.each_ref()).component_mul(&omega);
    geometry::angle(&momentum, from).to_degrees()
}

fn tossed() -> FreeMotion {
    let edges: [Interval; 3] = [given!(0.129), given!(0.020), given!(0.198)];
    let moments = Cuboid::moments(&given!(0.340), edges.each_ref());
    let spin = Interval::PI * given!(4);
    let small = spin / given!(20);
    FreeMotion::new(&moments, &Vector3::new(spin, small, small)).unwrap()
}

#[test]
fn coq_and_the_intervals_give_the_digits_of_the_book() {
    let theorems = include_str!("../../coq/numbers.v");
    let [easy, middle, hard]: [Rational; 3] = [given!(5), given!(10), given!(13)];
    let growth = Interval::from(rate_squared(&given!(10), &middle, &easy, &hard)).sqrt();
    let numbers = [
        ("gap_of_the_box", angle_to_the_momentum(&Vector3::new(given!(1), given!(1), given!(0))), 1),
        ("momentum_of_the_box", angle_to_the_momentum(&Vector3::new(given!(1), given!(0), given!(0))), 1),
        ("growth_of_the_box", growth, 2),
        ("doubling_of_the_box", given!(Interval: 2).ln() / growth, 2),
        ("first_flip_of_the_book", tossed().flip(0), 2),
        ("between_flips_of_the_book", tossed().between_flips(), 2),
    ];
    assert_eq!(theorems.matches("It rounds to").count(), numbers.len());
    for (name, number, decimals) in numbers {
        let stated = format!("It rounds to {number:.decimals$}. *)\nTheorem {name} :");
        assert!(theorems.contains(&stated), "{stated}");
        // The bounds of the theorem are half a last digit from these.
        let digits: i64 = format!("{number:.decimals$}").replace('.', "").parse().unwrap();
        let below = 2 * 10_i64.pow(decimals as u32);
        let theorem =
            theorems.split(&format!("Theorem {name} :")).nth(1).unwrap().split("Qed.").next().unwrap();
        assert!(theorem.contains(&format!("{} / {below} <", 2 * digits - 1)), "{theorem}");
        assert!(theorem.contains(&format!("< {} / {below}", 2 * digits + 1)), "{theorem}");
    }
}
