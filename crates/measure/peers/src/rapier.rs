//! A body alone in a Rapier world: the whole engine with default settings and its gyroscopic term on.

use nalgebra::{Quaternion, Vector3};
use rapier3d_f64::prelude::*;
use tumbling::step::State;
use tumbling_measure::contestant::{About, Contestant, Group, Knob, Setting, step_of};
use tumbling_measure::errors::{Ended, Observed, Outcome};
use tumbling_measure::story::Story;

pub struct Rapier;

impl Contestant for Rapier {
    fn about(&self) -> About {
        About { name: "Rapier, whole engine", group: Group::Peer, knob: Knob::Steps }
    }

    fn takes(&self, story: &Story) -> bool {
        story.is_free()
    }

    fn run(&self, story: &Story, setting: Setting, mut observer: Observed<'_, '_>) -> Result<Ended, Outcome> {
        let steps = setting.steps()?;
        let moments = *story.system.moments();
        let spin = story.system.omega(&story.start.momentum);
        let mut world = PhysicsWorld::default();
        world.gravity = Vector::ZERO;
        world.integration_parameters.dt = step_of(story, steps);
        let principal = AngVector::new(moments.x, moments.y, moments.z);
        let body = RigidBodyBuilder::dynamic()
            .additional_mass_properties(MassProperties::new(Vector::ZERO, 1.0, principal))
            .angvel(AngVector::new(spin.x, spin.y, spin.z))
            .linear_damping(0.0)
            .angular_damping(0.0)
            .can_sleep(false)
            .gyroscopic_forces_enabled(true)
            .build();
        let handle = world.bodies.insert(body);
        let state = |world: &PhysicsWorld| {
            let body = &world.bodies[handle];
            let (q, w) = (body.rotation(), body.angvel());
            let attitude = Quaternion::new(q.w, q.x, q.y, q.z);
            let omega = tumbling::attitude::rotation_matrix(&attitude).tr_mul(&Vector3::new(w.x, w.y, w.z));
            State { attitude, momentum: moments.component_mul(&omega) }
        };
        for k in 1..=steps {
            world.step();
            if let Some(observer) = observer.as_deref_mut() {
                observer.observe(story.end * (k as f64 / steps as f64), &state(&world));
            }
        }
        Ok(Ended { motion: state(&world), steps, seconds: None })
    }
}
