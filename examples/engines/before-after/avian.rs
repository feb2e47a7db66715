//! The scenes in Avian, without a window or assets.

#[path = "driver.rs"]
mod driver;

use avian3d::prelude::*;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use driver::{Body, Engine, Seen};
use std::time::Duration;

struct Avian {
    app: App,
    bodies: Vec<Entity>,
}

fn app(gravity: f32) -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, TransformPlugin, PhysicsPlugins::default()));
    app.insert_resource(Gravity(Vec3::NEG_Y * gravity));
    app.insert_resource(SubstepCount(4));
    app.insert_resource(Time::<Fixed>::from_hz(60.0));
    app.insert_resource(TimeUpdateStrategy::FixedTimesteps(1));
    app.finish();
    app.cleanup();
    // The first frame takes no time.
    app.insert_resource(TimeUpdateStrategy::ManualDuration(Duration::ZERO));
    app.update();
    app.insert_resource(TimeUpdateStrategy::FixedTimesteps(1));
    app
}

fn built(body: &Body) -> impl Bundle + use<> {
    let [w, x, y, z] = body.start.attitude;
    (
        RigidBody::Dynamic,
        Mass(body.mass),
        AngularInertia::new(body.moments.into()),
        CenterOfMass(Vec3::ZERO),
        NoAutoMass,
        NoAutoAngularInertia,
        NoAutoCenterOfMass,
        Transform::from_translation(body.start.position.into()).with_rotation(Quat::from_xyzw(x, y, z, w)),
        LinearVelocity(body.start.velocity.into()),
        AngularVelocity(body.start.spin.into()),
        SleepingDisabled,
    )
}

fn floor(app: &mut App) {
    let slab = Collider::cuboid(100.0, 2.0, 100.0);
    app.world_mut().spawn((RigidBody::Static, slab, Transform::from_xyz(0.0, -1.0, 0.0), Friction::new(1.0)));
}

impl Engine for Avian {
    const NAME: &'static str = "Avian 0.7.0 (avian3d)";

    fn bodies(bodies: &[Body], axle: Option<[f32; 3]>) -> Self {
        let mut app = app(0.0);
        let entities: Vec<_> = bodies.iter().map(|body| app.world_mut().spawn(built(body)).id()).collect();
        if let Some(at) = axle {
            let from = |body: &Body| Vec3::from(at) - Vec3::from(body.start.position);
            let hinge = RevoluteJoint::new(entities[0], entities[1])
                .with_hinge_axis(Vec3::Z)
                .with_local_anchor1(from(&bodies[0]))
                .with_local_anchor2(from(&bodies[1]));
            app.world_mut().spawn(hinge);
        }
        Self { app, bodies: entities }
    }

    fn top(body: Body, tip: [f32; 3], ball: f32) -> Self {
        let mut app = app(9.81);
        floor(&mut app);
        let top = app.world_mut().spawn(built(&body)).id();
        let ball = (Collider::sphere(ball), Transform::from_translation(tip.into()), Friction::new(1.0));
        app.world_mut().spawn((ball, ChildOf(top)));
        Self { app, bodies: vec![top] }
    }

    fn stack(count: usize, [x, y, z]: [f32; 3]) -> Self {
        let mut app = app(9.81);
        floor(&mut app);
        let bodies = (0..count)
            .map(|i| {
                let at = Transform::from_xyz(0.0, y * (1.0 + 2.0 * i as f32), 0.0);
                let shape = Collider::cuboid(2.0 * x, 2.0 * y, 2.0 * z);
                app.world_mut().spawn((RigidBody::Dynamic, shape, at, SleepingDisabled)).id()
            })
            .collect();
        Self { app, bodies }
    }

    fn step(&mut self) {
        self.app.update();
    }

    fn see(&self, body: usize) -> Seen {
        let body = self.app.world().entity(self.bodies[body]);
        let (Some(q), Some(w), Some(p), Some(v)) = (
            body.get::<Rotation>(),
            body.get::<AngularVelocity>(),
            body.get::<Position>(),
            body.get::<LinearVelocity>(),
        ) else {
            return Seen::default();
        };
        Seen {
            attitude: [q.0.w, q.0.x, q.0.y, q.0.z],
            spin: w.0.to_array(),
            position: p.0.to_array(),
            velocity: v.0.to_array(),
        }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    driver::run::<Avian>()
}
