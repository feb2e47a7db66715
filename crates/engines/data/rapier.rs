//! `rapier I1 I2 I3 w1 w2 w3 t1 t2 t3 COUNT`: prints COUNT steps of a free body in Rapier, or of one under a
//! torque constant in the world; as `record.py` wants them. Built with rapier3d-f64 0.36.1 for its only
//! dependency.

use rapier3d_f64::prelude::*;

fn main() {
    let args: Vec<f64> = std::env::args().skip(1).map(|x| x.parse().expect("a number")).collect();
    let vector = |i: usize| Vector::new(args[i], args[i + 1], args[i + 2]);
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    world.integration_parameters.dt = 1.0 / 60.0;
    let mass = MassProperties::new(Vector::ZERO, 1.0, vector(0));
    let body = RigidBodyBuilder::dynamic()
        .additional_mass_properties(mass)
        .angvel(vector(3))
        .can_sleep(false);
    let handle = world.insert_body(body);
    world.bodies[handle].add_torque(vector(6), true);
    for _ in 0..=args[9] as usize {
        let body = &world.bodies[handle];
        let (q, w) = (*body.rotation(), body.rotation().inverse() * body.angvel());
        println!("{:?},{:?},{:?},{:?},{:?},{:?},{:?}", q.w, q.x, q.y, q.z, w.x, w.y, w.z);
        world.step();
    }
}
