//! A scene of many bodies is answered as each of them would be alone, to the bit.

use nalgebra::{UnitQuaternion, Vector3};
use std::ops::ControlFlow;

use tumbling::step::Torque;
use tumbling_scenes::{Answer, Error, InitialState, Outputs, Scene, Start, Strategy, Times, batch};

type Answers = (Vec<(usize, Answer)>, Vec<(usize, Error)>);

fn in_blocks(scene: &Scene) -> Answers {
    let (mut states, mut wrong): Answers = Default::default();
    batch::run(
        scene,
        |block| {
            (block.states().map(|(body, state)| (body, *state)).collect::<Vec<_>>(), block.wrong.to_vec())
        },
        |(some, others)| {
            states.extend(some);
            wrong.extend(others);
            ControlFlow::Continue(())
        },
    );
    // Blocks go by time; one by one they go by body.
    states.sort_by_key(|(body, _)| *body);
    (states, wrong)
}

fn one_by_one(scene: &Scene) -> Answers {
    let (mut states, mut wrong): Answers = Default::default();
    scene.run(|body, state| match state {
        Ok(state) => states.push((body, state)),
        Err(error) => wrong.push((body, error)),
    });
    (states, wrong)
}

fn bits(state: &Answer) -> Vec<Option<u64>> {
    let q = state.attitude.map(|q| [q.w, q.i, q.j, q.k]);
    let spin = (0..3).map(|i| state.spin.map(|w| w[i]));
    let turn = (0..4).map(|i| q.map(|q| q[i]));
    let all = [Some(state.time), state.energy, state.angle_to_momentum];
    all.into_iter().chain(spin).chain(turn).map(|x| x.map(f64::to_bits)).collect()
}

/// The answers of a batch, which are those of each body alone, to the bit.
fn alike(scene: &Scene) -> Answers {
    let (batched, alone) = (in_blocks(scene), one_by_one(scene));
    assert_eq!((&batched.1, batched.0.len()), (&alone.1, alone.0.len()), "{:?}", scene.outputs());
    for ((body, one), (other, two)) in batched.0.iter().zip(&alone.0) {
        assert_eq!((body, bits(one)), (other, bits(two)), "{:?} at {} s", scene.outputs(), two.time);
    }
    batched
}

/// Balls, coins, spins about an axis, both kinds of circulation, a flipping body, one at rest; turned, tilted
/// in its box, slow and fast.
fn mixed(bodies: usize) -> Vec<InitialState> {
    let kinds: [([f64; 3], [f64; 3]); 8] = [
        ([2.0, 2.0, 2.0], [0.3, -1.0, 0.7]),
        ([1.0, 2.0, 2.5], [0.0, 0.0, 0.0]),
        ([1.0, 2.0, 2.5], [0.0, -3.0, 0.0]),
        ([2.0, 2.0, 3.0], [0.4, 0.5, -1.0]),
        ([1.0, 2.0, 2.5], [0.2, 0.3, 1.1]),
        ([1.0, 2.0, 2.5], [1.3, 0.2, -0.1]),
        ([1.0, 2.0, 2.5], [0.01, 1.0, 0.02]),
        ([0.7, 2.0, 2.5], [0.1, -1.0, 0.3]),
    ];
    let body = |k: usize| {
        let turn = k as f64;
        let (moments, omega) = kinds[k % kinds.len()];
        let with = Vector3::from(omega) * (1.0 + 0.37 * (k % 5) as f64);
        let attitude = UnitQuaternion::from_euler_angles(0.3 * turn, -0.1 * turn, turn);
        let moments = Vector3::from(moments);
        match k % 3 {
            0 => InitialState::spinning(moments, with),
            1 => InitialState { attitude, ..InitialState::spinning(moments, with) },
            // Not along its principal axes, and let go with a momentum.
            _ => {
                let products = Vector3::new(0.0625, -0.03125, 0.0625);
                InitialState { products, attitude, start: Start::Momentum(2.0 * with), moments }
            }
        }
    };
    (0..bodies).map(body).collect()
}

#[test]
fn a_batch_answers_as_each_body_alone_whatever_is_requested() {
    let mut tried = 0;
    for requested in 1_u8..16 {
        let on = |bit: u8| requested & bit != 0;
        let outputs = Outputs {
            spin: on(1),
            attitude: on(2),
            energy: on(4),
            angle_to_momentum: on(8),
            ..Outputs::NOTHING
        };
        // A body at rest has no angle to the momentum: it goes wrong, and alone.
        let scene = Scene::new(mixed(300), vec![], Times::every(0.3, 10.0), outputs, 1e-9).unwrap();
        let (states, wrong) = alike(&scene);
        assert_eq!(wrong.is_empty(), !outputs.angle_to_momentum);
        tried += states.len();
    }
    assert!(tried > 100_000, "{tried}");
}

#[test]
fn of_a_few_bodies_and_of_none_that_moves_the_same_is_true() {
    let outputs = Outputs { spin: true, attitude: true, ..Outputs::NOTHING };
    for bodies in [1, 2, 3, 4, 5, 256, 257] {
        let times = Times::Given(vec![0.0, 0.0, 1e-9, 7.0]);
        let scene = Scene::new(mixed(bodies), vec![], times, outputs, 1e-9).unwrap();
        assert_eq!(alike(&scene).0.len(), 4 * bodies);
    }
}

/// More than a block of them, some that no body is, under a gradient, a weight, damping and a thruster.
#[test]
fn a_crowd_of_driven_bodies_is_answered_as_each_alone() {
    let mut bodies = mixed(300);
    bodies[123].moments = Vector3::new(1.0, 1.0, 3.0);
    let torques = vec![
        Torque::gravity_gradient(&Vector3::x(), &Vector3::new(0.0, 0.0, 0.5)),
        Torque::gravity(&Vector3::new(0.125, 0.0, 0.5), 2.0),
        Torque::Damping(Vector3::new(0.125, 0.125, 0.125)),
        Torque::during(0.5, 1.0, Torque::InBody(Vector3::new(0.5, -1.0, 0.25))),
    ];
    let outputs = Outputs { spin: true, attitude: true, ..Outputs::NOTHING };
    let scene = Scene::new(bodies, torques, Times::every(0.1, 2.0), outputs, 1e-6).unwrap();
    assert_eq!(scene.plan(0).unwrap().strategy(), Strategy::Adaptive);
    let (states, wrong) = alike(&scene);
    assert_eq!((states.len(), wrong.len()), (299 * 21, 1));
}

#[test]
fn who_breaks_off_is_given_no_more() {
    let outputs = Outputs { spin: true, ..Outputs::NOTHING };
    let scene = Scene::new(mixed(10), vec![], Times::every(1.0, 1e9), outputs, 1e-3).unwrap();
    let mut blocks = 0;
    batch::run(
        &scene,
        |_| (),
        |()| {
            blocks += 1;
            if blocks < 5 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        },
    );
    assert_eq!(blocks, 5);
}
