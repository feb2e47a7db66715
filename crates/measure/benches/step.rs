//! What one step costs, in steps of the engines' plainest rule that keeps `|L|`: explicit, then the
//! momentum's length restored. Ratios within one run.
//!
//! ```text
//! cargo bench -p tumbling-measure --bench step
//! valgrind --tool=callgrind --toggle-collect='*counted_here*' target/release/deps/step-... count NAME
//! ```
//!
//! The first prints ratios of times; the second runs one piece of work 1000 times inside a function whose
//! instructions are counted. Under `cargo test` it does nothing but make sure that it runs.

mod ratios;

use nalgebra::{Quaternion, Vector3};
use ratios::Work;
use std::hint::black_box;
use tumbling::PrincipalMoments;
use tumbling::step::{Method, State, System, fixed_rate};

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
    for &method in Method::ALL.iter().filter(|method| method.info().conserved.unit) {
        add(
            method.info().name,
            Box::new(move |system, motion, h| method.step(system, motion, h).expect("a step")),
        );
    }
    works
}

fn main() {
    ratios::run(works(), "of the rule");
}
