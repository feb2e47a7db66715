//! `rapier I1 I2 I3 w1 w2 w3 COUNT [t1 t2 t3]`: prints COUNT steps of a body in Rapier as CSV.
//! Built with rapier3d-f64 0.36.1 as its only dependency. The torque, if there is one, is constant in the world.

use rapier3d_f64::prelude::*;

fn main() {
    let args: Vec<f64> = std::env::args().skip(1).map(|x| x.parse().expect("a number")).collect();
    let vector = |i: usize| Vector::new(args[i], args[i + 1], args[i + 2]);
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    world.integration_parameters.dt = 1.0 / 60.0;
    let mass = MassProperties::new(Vector::ZERO, 1.0, vector(0));
    let body = RigidBodyBuilder::dynamic().additional_mass_properties(mass).angvel(vector(3)).can_sleep(false);
    let handle = world.insert_body(body);
    for step in 0..=args[6] as usize {
        let body = &world.bodies[handle];
        let (q, w) = (*body.rotation(), body.rotation().inverse() * body.angvel());
        let t = step as f64 / 60.0;
        println!("{t:?},{:?},{:?},{:?},{:?},{:?},{:?},{:?}", q.w, q.x, q.y, q.z, w.x, w.y, w.z);
        if args.len() > 7 {
            let body = &mut world.bodies[handle];
            body.reset_torques(true);
            body.add_torque(vector(7), true);
        }
        world.step();
    }
}
