//! The cost of one step, relative to the simplest rule of engines that keeps `|L|`: an explicit step, then
//! the momentum's length restored. Ratios within one run.
//!
//! ```text
//! cargo bench -p tumbling-measure --bench step
//! valgrind --tool=callgrind --toggle-collect='*counted_here*' target/release/deps/step-... count NAME
//! ```
//!
//! The first prints ratios of times; the second runs one piece of work 1000 times inside a function whose
//! instructions are counted. Under `cargo test` it does nothing but make sure that it runs.

mod plain;
mod ratios;

use nalgebra::{Quaternion, Vector3};
use plain::{Number, Plain};
use ratios::Work;
use std::hint::black_box;
use tumbling::PrincipalMoments;
use tumbling::step::{Method, PositionStage, State, System, fixed_rate};

type Step = dyn Fn(&System<f64>, &State<f64>, f64) -> State<f64>;

const H: f64 = 1.0 / 60.0;

fn works() -> Vec<Work> {
    let system = System::free(PrincipalMoments::new(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0).expect("a body"))
        .expect("a body");
    let vector = system.momentum(&Vector3::new(10.0, 0.1, 0.1));
    let start = State { attitude: Quaternion::identity(), momentum: vector };
    let mut works: Vec<Work> = Vec::new();
    let mut add = |name, step: Box<Step>| {
        let (system, start, mut motion) = (system.clone(), start, start);
        works.push((
            name,
            Box::new(move |k| {
                // Not all of them last.
                if k % 512 == 0 {
                    motion = start;
                }
                motion = step(black_box(&system), black_box(&motion), black_box(H));
            }),
        ));
    };
    let rule = Method::Rescaled;
    add("the rule", Box::new(move |system, motion, h| rule.step(system, motion, h).expect("a step")));
    add("fixed_rate", Box::new(|system, motion, h| fixed_rate(system, motion, h).expect("a step")));
    for &method in Method::ALL.iter().filter(|method| method.info().unit) {
        add(
            method.info().name,
            Box::new(move |system, motion, h| method.step(system, motion, h).expect("a step")),
        );
    }
    in_an_engine::<f64>(&mut works, ["bare rule, f64", "position stage, f64", "position stage, f64, frame"]);
    in_an_engine::<f32>(&mut works, ["bare rule, f32", "position stage, f32", "position stage, f32, frame"]);
    works
}

/// The rule as an engine writes it, and its replacement; both have attitude and spin in world axes.
fn in_an_engine<T: Number>(works: &mut Vec<Work>, [rule, stage, framed]: [&'static str; 3]) {
    let number = |x: f32| <T as From<f32>>::from(x);
    let h = number(1.0 / 60.0);
    let moments = Vector3::new(10.0, 13.0, 5.0).map(|x: f32| number(x / 12.0));
    let inverse = moments.map(|x| T::one() / x);
    let attitude = Quaternion::new(T::one(), T::zero(), T::zero(), T::zero());
    let start = Plain { attitude, omega: Vector3::new(10.0, 0.1, 0.1).map(number) };
    let mut now = start;
    works.push((
        rule,
        Box::new(move |k| {
            now = if k % 512 == 0 { start } else { now };
            now = plain::step(black_box(&moments), black_box(&inverse), black_box(&now), black_box(h));
        }),
    ));
    let body = PositionStage::new(&moments).expect("a body");
    let turned = Quaternion::new(number(0.6), number(0.0), number(0.8), number(0.0));
    for (name, body) in [(stage, body), (framed, body.in_frame(turned).expect("a frame"))] {
        let mut now = start;
        works.push((
            name,
            Box::new(move |k| {
                now = if k % 512 == 0 { start } else { now };
                let end =
                    black_box(&body).step(black_box(&now.attitude), black_box(&now.omega), black_box(h));
                now = Plain { attitude: end.attitude, omega: end.omega };
            }),
        ));
    }
}

fn main() {
    ratios::run(works(), "of the rule");
}
