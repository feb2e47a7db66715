//! The scenes in Rapier.

#[path = "driver.rs"]
mod driver;

use driver::{Body, Engine, H, Seen};
use rapier3d::prelude::*;

struct Rapier {
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
}

fn vector([x, y, z]: [f32; 3]) -> Vector {
    Vector::new(x, y, z)
}

fn built(body: &Body) -> RigidBodyBuilder {
    let [w, x, y, z] = body.start.attitude;
    RigidBodyBuilder::dynamic()
        .additional_mass_properties(MassProperties::new(Vector::ZERO, body.mass, vector(body.moments)))
        .translation(vector(body.start.position))
        .rotation(Rotation::from_xyzw(x, y, z, w).to_scaled_axis())
        .linvel(vector(body.start.velocity))
        .angvel(vector(body.start.spin))
        .can_sleep(false)
}

fn world(gravity: f32) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::new(0.0, -gravity, 0.0);
    world.integration_parameters.dt = H;
    world
}

/// A slab with its upper side at `y = 0`.
fn floor(world: &mut PhysicsWorld) {
    let slab = ColliderBuilder::cuboid(50.0, 1.0, 50.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.insert_collider(slab.friction(1.0), None);
}

impl Engine for Rapier {
    const NAME: &'static str = "Rapier 0.36.1 (rapier3d)";

    fn bodies(bodies: &[Body], axle: Option<[f32; 3]>) -> Self {
        let mut world = world(0.0);
        let handles: Vec<_> = bodies.iter().map(|body| world.insert_body(built(body))).collect();
        if let Some(at) = axle {
            let joint = RevoluteJointBuilder::new(Vector::Z)
                .local_anchor1(vector(at) - vector(bodies[0].start.position))
                .local_anchor2(vector(at) - vector(bodies[1].start.position));
            world.insert_impulse_joint(handles[0], handles[1], joint);
        }
        Self { world, bodies: handles }
    }

    fn top(body: Body, tip: [f32; 3], ball: f32) -> Self {
        let mut world = world(9.81);
        floor(&mut world);
        let top = world.insert_body(built(&body));
        let ball = ColliderBuilder::ball(ball).translation(vector(tip)).density(0.0).friction(1.0);
        world.insert_collider(ball, Some(top));
        Self { world, bodies: vec![top] }
    }

    fn stack(count: usize, [x, y, z]: [f32; 3]) -> Self {
        let mut world = world(9.81);
        floor(&mut world);
        let bodies = (0..count)
            .map(|i| {
                let at = Vector::new(0.0, y * (1.0 + 2.0 * i as f32), 0.0);
                let body = world.insert_body(RigidBodyBuilder::dynamic().translation(at).can_sleep(false));
                world.insert_collider(ColliderBuilder::cuboid(x, y, z), Some(body));
                body
            })
            .collect();
        Self { world, bodies }
    }

    fn step(&mut self) {
        self.world.step();
    }

    fn see(&self, body: usize) -> Seen {
        let body = &self.world.bodies[self.bodies[body]];
        let (q, w, p, v) = (*body.rotation(), body.angvel(), body.translation(), body.linvel());
        Seen {
            attitude: [q.w, q.x, q.y, q.z],
            spin: [w.x, w.y, w.z],
            position: [p.x, p.y, p.z],
            velocity: [v.x, v.y, v.z],
        }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    driver::run::<Rapier>()
}
