//! A flip in the terminal: the spin about each of the book's axes while it flies, a line for each instant.
//!
//! `cargo run --example flip`

use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;
use tumbling::exact::time_between_flips;
use tumbling::step::Engine;
use tumbling::{Axis, Body, body::named::NamedBody};

fn main() -> Result<(), tumbling::Error> {
    let book = NamedBody::Book.properties()?.inertia();
    let axes = book.principal();
    // Two turns a second about the middle axis, and a twentieth of that about the others.
    let along = Vector3::new(0.05, 1.0, 0.05) * (2.0 * TAU);
    let start = Body::spinning(book, UnitQuaternion::identity(), &(axes.frame() * along))?;

    let (h, every) = (0.001, 50);
    let flight = Engine::Turned.run(&start, h, 3000)?;
    println!("  t      spin about the middle axis: - ...... 0 ...... +     energy       |L|");
    for (i, body) in flight.iter().enumerate().step_by(every) {
        let middle = body.omega_body().dot(&axes.axis(Axis::Middle)) / along.norm();
        let column = usize::try_from((20.0 * (middle + 1.0)).round() as i64).unwrap_or(0);
        println!(
            "{:.2} s  |{:>width$}{:rest$}|  {:.6} J  {:.6}",
            h * i as f64,
            "o",
            "",
            body.energy(),
            body.momentum_world().norm(),
            width = column + 1,
            rest = 40_usize.saturating_sub(column),
        );
    }
    let beat = time_between_flips(axes.try_into()?, &along)?.unwrap_or(f64::INFINITY);
    println!("Theory: a flip every {beat:.3} s.");
    Ok(())
}
