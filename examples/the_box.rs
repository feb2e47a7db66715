//! The book's worked example: the box, its three moments, and the angle between spin and momentum.
//!
//! `cargo run --example the_box`

use nalgebra::Vector3;
use tumbling::solid::{Cuboid, Solid};

fn main() -> Result<(), tumbling::Error> {
    let (a, b, c) = (2.0, 1.0, 3.0);
    let inertia = Cuboid::new(a, b, c)?.with_mass(1.0)?.inertia();
    let moments = inertia.matrix().diagonal();
    println!("A box of {a} x {b} x {c} m and 1 kg resists turning");
    for (edge, moment) in ["x", "y", "z"].iter().zip(&moments) {
        println!("  about {edge}: {moment:.3} kg m²");
    }
    println!("\n{:<24}{:<26}angle", "spin, rad/s", "momentum, kg m²/s");
    for omega in [[1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1e-12, 0.0]] {
        let omega = Vector3::from(omega);
        let l = inertia.momentum(&omega);
        let angle = inertia.angle_to_momentum(&omega)?.to_degrees();
        let spin = format!("({}, {:?}, {})", omega.x, omega.y, omega.z);
        let momentum = format!("({:.3}, {:.3}, {:.3})", l.x, l.y, l.z);
        let angle =
            if angle > 0.0 && angle < 1e-3 { format!("{angle:.3e}°") } else { format!("{angle:.1}°") };
        println!("{spin:<24}{momentum:<26}{angle}");
    }
    Ok(())
}
