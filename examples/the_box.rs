//! The book's worked example: the box, its three moments, the angle between spin and momentum; and its
//! tensor, which lives in the body, turned to the world.
//!
//! `cargo run --example the_box`

use nalgebra::{UnitQuaternion, Vector3};
use tumbling::Body;
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
    println!("\nturned about z   world Ixx   Iyy     Ixy       spin of L = (1, 0, 0)");
    for degrees in [0.0, 22.5, 45.0, 67.5, 90.0_f64] {
        let attitude = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), degrees.to_radians());
        let world = inertia.turned(attitude)?.matrix();
        let omega = Body::new(inertia, attitude, &Vector3::x())?.omega_world();
        println!(
            "{degrees:>12.1}°   {:.3}       {:.3}   {:+.3}    ({:+.3}, {:+.3}, {:+.3})",
            world.m11, world.m22, world.m12, omega.x, omega.y, omega.z
        );
    }
    Ok(())
}
