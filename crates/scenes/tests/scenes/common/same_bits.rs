//! One hash of the answers of many scenes, which must be the same wherever `f64` follows IEEE 754: the tests
//! compute it, and `.ci/same-bits` elsewhere.

use super::library::{Hash, Random};
use nalgebra::{UnitQuaternion, Vector3};
use std::ops::ControlFlow;
use tumbling::step::Torque;
use tumbling::{Body, Inertia, PrincipalMoments};
use tumbling_scenes::{Answer, InitialState, Outputs, Scene, Times, batch};

/// The hash of `rounds` rounds of scenes, free and driven.
#[must_use]
pub fn hash(rounds: u32) -> Hash {
    let (mut hash, mut random) = (Hash::default(), Random(41));
    for _ in 0..rounds {
        free(&mut hash, &mut random);
        driven(&mut hash, &mut random);
    }
    hash
}

const OUTPUTS: Outputs =
    Outputs { spin: true, attitude: true, energy: true, angle_to_momentum: true, ..Outputs::NOTHING };

fn answer(hash: &mut Hash, answer: &Answer) {
    hash.all(&answer.spin.unwrap_or_default());
    hash.all(&answer.attitude.unwrap_or_default().coords);
    hash.put(answer.energy.unwrap_or(f64::NAN));
    hash.put(answer.angle_to_momentum.unwrap_or(f64::NAN));
}

/// Bodies side by side, some of them in axes other than the principal ones, and what is conserved of each.
fn free(hash: &mut Hash, random: &mut Random) {
    let bodies: Vec<InitialState> = (0..7)
        .map(|n| {
            let (moments, omega) = random.motion();
            let frame = UnitQuaternion::new_unchecked(random.attitude());
            let turned =
                Inertia::from(moments).turned(frame).and_then(|tensor| Body::spinning(tensor, frame, &omega));
            match turned {
                Ok(body) if n < 2 => body.into(),
                _ => InitialState::spinning(moments.vector(), omega),
            }
        })
        .collect();
    let accuracy = [1e-3, 1e-6, 1e-10][(random.bits() % 3) as usize];
    let outputs = Outputs { flips: true, ..OUTPUTS };
    let times = Times::every(2.0 + random.signed(), 20.0);
    hash.answer(Scene::new(bodies, vec![], times, outputs, accuracy), |hash, scene| {
        let work = |block: &batch::Block<'_>| block.answers.to_vec();
        batch::run(&scene, work, |answers| {
            answers.iter().for_each(|slot| hash.answer(slot.as_ref().ok_or(()), answer));
            ControlFlow::Continue(())
        });
        for body in 0..scene.bodies().len() {
            hash.answer(scene.plan(body), |hash, plan| {
                hash.answer(plan.flips(), |hash, flips| flips.take(3).for_each(|time| hash.put(time)));
            });
        }
    });
}

/// A body under torques, planned by trial runs.
fn driven(hash: &mut Hash, random: &mut Random) {
    let sides = random.vector().map(|x| 1.5 + x);
    let moments = PrincipalMoments::new(sides.y + sides.z, sides.x + sides.z, sides.x + sides.y);
    hash.answer(moments, |hash, moments| {
        let weak = 0.1 * random.signed();
        let torques = match random.bits() % 3 {
            0 => vec![Torque::gravity(&random.vector(), weak)],
            1 => vec![Torque::InWorld(random.vector() * weak), Torque::Damping(Vector3::repeat(weak.abs()))],
            _ => vec![Torque::InBody(random.vector() * weak), Torque::Dissipation(0.01)],
        };
        let accuracy = [1e-2, 1e-4, 1e-6, 1e-8][(random.bits() % 4) as usize];
        let body = InitialState::spinning(moments.vector(), random.vector() * 2.0);
        let times = Times::every(0.25, 4.0);
        hash.answer(Scene::new([body], torques, times, OUTPUTS, accuracy), |hash, scene| {
            scene.run(|_, found| hash.answer(found.as_ref(), answer));
        });
    });
}
