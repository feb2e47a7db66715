//! The cost of the exact motion relative to a step of the plain Runge-Kutta method, as ratios within one run.
//!
//! ```text
//! cargo bench -p tumbling-measure --bench exact
//! valgrind --tool=callgrind --toggle-collect='*counted_here*' target/release/deps/exact-... count NAME
//! ```
//!
//! The first prints ratios of times; the second runs one piece of work 1000 times inside a function whose
//! instructions are counted. Under `cargo test` it does nothing but make sure that it runs.

mod ratios;

use nalgebra::{Quaternion, Vector3};
use ratios::Work;
use std::hint::black_box;
use tumbling::exact::FreeMotion;
use tumbling::step::rk4;
use tumbling::{PrincipalMoments, attitude, dynamics::euler};

fn works() -> Vec<Work> {
    let moments = Vector3::new(0.8333, 1.0833, 0.4167);
    let none = Vector3::zeros();
    type Motion = (Quaternion<f64>, Vector3<f64>);
    let law = move |(q, omega): &Motion| {
        (attitude::rate(q, omega), euler::angular_acceleration(&moments, omega, &none))
    };
    let plus = |(q, omega): &Motion, rate: &Motion, h: f64| (q + rate.0 * h, omega + rate.1 * h);
    let mut state = (Quaternion::identity(), Vector3::new(1.0, 1.0, 0.3));
    let mut plain = [1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.3];
    let ratios = black_box([
        (moments.y - moments.z) / moments.x,
        (moments.z - moments.x) / moments.y,
        (moments.x - moments.y) / moments.z,
    ]);
    let mut works: Vec<Work> = vec![
        ("plain rk4 step of (q, w)", Box::new(move |_| plain_step(black_box(&mut plain), &ratios, 1e-6))),
        (
            "the library's generic rk4 step",
            Box::new(move |_| state = rk4(black_box(&state), black_box(1e-6), law, plus)),
        ),
    ];
    // Well inside, and close to the separatrix, where hyperbolic functions take over.
    for (where_, omega) in
        [("generic", Vector3::new(0.3, 0.4, 1.0)), ("flipping", Vector3::new(1.0, 1e-3, 1e-3))]
    {
        let moments = black_box(moments);
        let body = PrincipalMoments::try_from(moments).expect("a body");
        let motion = FreeMotion::new(body, &omega).expect("a body");
        let times: Vec<f64> = (0..1024).map(|k| f64::from(k * 37 % 1024) * 0.117).collect();
        let name = |what: &str| -> &'static str { Box::leak(format!("{what}, {where_}").into_boxed_str()) };
        let far: Vec<f64> = times.iter().map(|t| 1e10 + t).collect();
        let short: Vec<f64> = times.iter().map(|t| 0.002 * t).collect();
        let mut add = |what: &str, times: &[f64], work: fn(&FreeMotion, f64)| {
            let times = times.to_vec();
            works.push((name(what), Box::new(move |k| work(&motion, black_box(times[k as usize % 1024])))));
        };
        for (at, times) in [("", &times), (" at 1e9 periods", &far)] {
            add(&format!("w{at}"), times, |motion, t| drop(black_box(motion.omega(t))));
            add(&format!("w and q{at}"), times, |motion, t| drop(black_box(motion.at(t))));
        }
        for (at, times) in [("", &times), (", short spans", &short)] {
            let transition = |motion: &FreeMotion, t| drop(black_box(motion.state_transition(t)));
            add(&format!("state transition{at}"), times, transition);
            let by_tensor = |motion: &FreeMotion, t| drop(black_box(motion.sensitivities(t)));
            add(&format!("derivatives by the tensor{at}"), times, by_tensor);
        }
        works.push((
            name("preparing"),
            Box::new(move |_| drop(black_box(FreeMotion::new(black_box(body), black_box(&omega))))),
        ));
    }
    works
}

/// The cheapest step: seven numbers, no divisions, no renormalisation.
fn plain_step(y: &mut [f64; 7], ratios: &[f64; 3], h: f64) {
    let rate = |y: &[f64; 7]| {
        let [a, b, c, d, x, v, z] = *y;
        [
            0.5 * (-b * x - c * v - d * z),
            0.5 * (a * x + c * z - d * v),
            0.5 * (a * v - b * z + d * x),
            0.5 * (a * z + b * v - c * x),
            ratios[0] * v * z,
            ratios[1] * z * x,
            ratios[2] * x * v,
        ]
    };
    let plus = |k: &[f64; 7], h: f64| -> [f64; 7] { std::array::from_fn(|i| y[i] + h * k[i]) };
    let k1 = rate(y);
    let k2 = rate(&plus(&k1, 0.5 * h));
    let k3 = rate(&plus(&k2, 0.5 * h));
    let k4 = rate(&plus(&k3, h));
    *y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
}

fn main() {
    ratios::run(works(), "steps");
}
