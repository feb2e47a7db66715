//! The tensor lives in the body: turn it to the world, and get the spin back from the momentum.
//!
//! `cargo run --example body_to_world`

use nalgebra::{UnitQuaternion, Vector3};
use tumbling::{Body, body::named::NamedBody};

fn main() -> Result<(), tumbling::Error> {
    let inertia = NamedBody::TheBox.properties()?.inertia();
    let inverse = inertia.inverse()?; // once, in the body frame
    println!("moments in the body: {:.3?}", inertia.matrix().diagonal().as_slice());
    println!("their inverses:      {:.3?}", inverse.diagonal().as_slice());
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
