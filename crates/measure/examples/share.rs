//! The share of the machine that a batch of free bodies takes: how long a result takes, next to how long its
//! arithmetic alone and the writing of it alone would take. Renews `crates/measure/record/share.csv`.
//!
//! ```sh
//! cargo run --release -p tumbling-measure --example share
//! ```

#[path = "../../scenes/src/lanes.rs"]
mod lanes;

use lanes::Lanes;
use multiversion::multiversion;
use nalgebra::Vector3;
use std::hint::black_box;
use tumbling::PrincipalMoments;
use tumbling::exact::{Batch, FreeMotion, Instant};
use tumbling::laws::Lane;
use tumbling_measure::AnyError;
use tumbling_measure::costs::{Share, shares};

/// Four bodies at once, as scenes take them where the processor fuses products.
type Four = Lanes<4, true>;

/// As many bodies and instants as scenes take at once.
const BODIES: usize = 256;
const INSTANTS: usize = 16;
const RESULTS: usize = BODIES * INSTANTS;

/// Multiplications a result, which are more than its sums: counted in the compiled loops of the series in the
/// nome, each once.
const PRODUCTS: [usize; 2] = [48, 128];

fn main() -> Result<(), AnyError> {
    let moments = PrincipalMoments::new(0.8333, 1.0833, 0.4167)?;
    let start = |k: usize| Vector3::new(0.3, 0.4, 1.0 + 0.001 * k as f64);
    let motions = (0..BODIES).map(|k| FreeMotion::new(moments, &start(k))).collect::<Result<Vec<_>, _>>()?;
    let rows = vec![
        measured("spin alone", PRODUCTS[0], &Batch::new(&motions), spins, Vector3::zeros()),
        measured("spin and attitude", PRODUCTS[1], &Batch::new(&motions), instants, motions[0].at(0.0)?),
    ];
    for row in &rows {
        println!("{row:.1?}: {:.2}", row.of_the_machine());
    }
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/record/share.csv");
    Ok(std::fs::write(file, shares(rows).write()?)?)
}

/// The three in turns, since the machine may do other work: the least of many.
fn measured<A: Copy>(
    answer: &str,
    products: usize,
    batch: &Batch<Four, A>,
    answered: fn(&Batch<Four, A>, &[f64], &mut [A]),
    some: A,
) -> Share {
    let mut room = vec![some; RESULTS];
    let times: Vec<f64> = (0..INSTANTS).map(|k| 0.117 + 0.37 * k as f64).collect();
    let mut numbers = [Four::from_lanes(|k| 1.0 + k as f64); 12];
    let rounds = RESULTS * products / (Four::WIDTH * numbers.len() / 2);
    let mut least = [f64::INFINITY; 3];
    for _ in 0..4000 {
        let mut time = |kind: usize, work: &mut dyn FnMut()| {
            let start = std::time::Instant::now();
            work();
            least[kind] = least[kind].min(start.elapsed().as_secs_f64() * 1e9 / RESULTS as f64);
        };
        time(0, &mut || answered(black_box(batch), black_box(&times), black_box(&mut room)));
        time(1, &mut || arithmetic(black_box(&mut numbers), black_box([1.0, 1e-9]), black_box(rounds)));
        time(2, &mut || black_box(&mut room).fill(black_box(some)));
    }
    let [result, arithmetic, writing] = least;
    Share { answer: answer.to_owned(), result, arithmetic, writing }
}

macro_rules! answered {
    ($name:ident, $A:ty) => {
        #[multiversion(targets("x86_64+avx2+fma"))]
        fn $name(batch: &Batch<Four, $A>, times: &[f64], room: &mut [$A]) {
            let put = |time, body, answer| {
                if let Some(place) = room.get_mut(time * BODIES + body) {
                    *place = answer;
                }
            };
            assert_eq!(batch.each(times, put), Ok(()));
        }
    };
}
answered!(spins, Vector3<f64>);
answered!(instants, Instant);

/// Products and sums as independent as the processor can work on at once, in registers.
#[multiversion(targets("x86_64+avx2+fma"))]
fn arithmetic(numbers: &mut [Four; 12], [factor, term]: [f64; 2], rounds: usize) {
    let [mut a, mut b, mut c, mut d, mut e, mut f, mut g, mut h, mut i, mut j, mut k, mut l] = *numbers;
    let (x, y) = (Four::from_lanes(|_| factor), Four::from_lanes(|_| term));
    for _ in 0..rounds {
        (a, b, c, d, e, f) = (a * x, b + y, c * x, d + y, e * x, f + y);
        (g, h, i, j, k, l) = (g * x, h + y, i * x, j + y, k * x, l + y);
    }
    *numbers = [a, b, c, d, e, f, g, h, i, j, k, l];
}
