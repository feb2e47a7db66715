//! Your own shape: parts placed and turned, and a body from a triangle mesh, and which spin will flip.
//!
//! `cargo run --example your_own_shape`

use nalgebra::{UnitQuaternion, Vector3};
use tumbling::dynamics::stability::{Stability, of_spin};
use tumbling::solid::{Compound, Cuboid, Cylinder, MassProperties, Mesh, Solid};
use tumbling::{Axis, Error};

fn main() -> Result<(), Error> {
    // A mallet: a wooden handle along z, and a heavier head laid across its end.
    let handle = Cylinder::new(0.015, 0.3)?.with_density(650.0)?;
    let head = Cuboid::new(0.12, 0.06, 0.06)?.with_density(1100.0)?;
    let tilted = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), 0.1);
    let mallet =
        Compound::new().at(handle, &Vector3::zeros()).at(head.turned(tilted)?, &Vector3::new(0.0, 0.0, 0.18));
    report("a mallet of two parts", &mallet.properties()?)?;

    // A wedge from a triangle at two heights and eight triangles around, counter-clockwise seen from outside.
    let corners = |z| [[0.0, 0.0, z], [0.3, 0.0, z], [0.0, 0.2, z]].map(Vector3::from);
    let vertices = [corners(0.0), corners(0.1)].concat();
    let faces = [[0, 2, 1], [3, 4, 5], [0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];
    report("a wedge of eight triangles", &Mesh::new(&vertices, &faces)?.with_mass(0.5)?)?;

    // What cannot be is refused, with the reason.
    if let Err(error) = Mesh::new(&vertices, &faces[1..]) {
        println!("\nThe wedge without its first face: {error}.");
    }
    Ok(())
}

fn report(what: &str, body: &MassProperties) -> Result<(), Error> {
    let axes = body.inertia().principal();
    println!("\n{what}: {:.3} kg, centre {:.4?}", body.mass(), body.centre().as_slice());
    for axis in Axis::ALL {
        let fate = match of_spin(axes.try_into()?, axis, 1.0)? {
            Stability::Growth { rate } => format!("a push grows, {rate:.3} per radian turned"),
            Stability::Libration { rate } => format!("a push circles, {rate:.3} rounds per turn"),
            _ => "a push drifts".to_string(),
        };
        println!("  {:.3e} kg m² about {:+.3?}: {fate}", axes.moment(axis), axes.axis(axis).as_slice());
    }
    Ok(())
}
