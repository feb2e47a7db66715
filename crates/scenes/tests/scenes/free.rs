//! Scenes of free bodies: the cheapest way is taken, and it is right.

use crate::common::{ALL, BOTH, SPIN, one, states};
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::exact::FreeMotion;
use tumbling::step::Torque;
use tumbling::{Body, Inertia};
use tumbling_scenes::{Error, InitialState, Outputs, Scene, Start, Strategy, Times};

#[test]
fn each_scene_is_answered_in_the_way_that_leaves_out_the_most() {
    let (ball, top, uneven) =
        (Vector3::new(2.0, 2.0, 2.0), Vector3::new(2.0, 2.0, 3.0), Vector3::new(1.0, 2.0, 2.5));
    let (oblique, along, still) =
        (Vector3::new(0.3, 1.0, 0.2), Vector3::new(0.0, 1.0, 0.0), Vector3::zeros());
    let attitude = Outputs { attitude: true, ..Outputs::NOTHING };
    let name = |moments, omega, outputs| {
        let scene =
            one(InitialState::spinning(moments, omega), vec![], Times::every(0.5, 5.0), outputs, 1e-9);
        scene.plan(0).unwrap().strategy()
    };
    for outputs in
        [Outputs::NOTHING, Outputs { energy: true, flips: true, polhode: true, ..Outputs::NOTHING }]
    {
        assert_eq!(name(uneven, oblique, outputs), Strategy::Nothing);
    }
    assert_eq!(name(ball, oblique, SPIN), Strategy::Constant);
    assert_eq!(name(uneven, still, BOTH), Strategy::Constant);
    assert_eq!(name(uneven, along, SPIN), Strategy::Constant);
    assert_eq!(name(ball, oblique, attitude), Strategy::Rotation);
    assert_eq!(name(uneven, along, BOTH), Strategy::Rotation);
    assert_eq!(name(top, oblique, SPIN), Strategy::SymmetricTop);
    assert_eq!(name(top, oblique, BOTH), Strategy::SymmetricTop);
    assert_eq!(name(uneven, oblique, SPIN), Strategy::EllipticSpin);
    assert_eq!(
        name(uneven, oblique, Outputs { angle_to_momentum: true, ..Outputs::NOTHING }),
        Strategy::EllipticSpin
    );
    assert_eq!(
        name(top, oblique, Outputs { angle_to_momentum: true, ..Outputs::NOTHING }),
        Strategy::Nothing
    );
    assert_eq!(name(uneven, oblique, attitude), Strategy::Elliptic);
}

/// A tensor with products, a body that lies turned in the world: each way against the motion of the whole
/// body.
#[test]
fn a_body_that_lies_turned_in_its_own_axes_and_in_the_world_is_answered_in_those() {
    let lies = UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9);
    for moments in [[1.0, 2.0, 2.5], [2.0, 2.0, 3.0]] {
        let tensor = Inertia::from_moments(moments[0], moments[1], moments[2]).unwrap();
        let tensor = tensor.turned(UnitQuaternion::from_euler_angles(1.0, 0.2, -0.7)).unwrap();
        let omega = Vector3::new(0.4, -1.1, 0.7);
        let body = Body::spinning(tensor, lies, &omega).unwrap();
        let exact = FreeMotion::of(&body).unwrap();
        let by_momentum = InitialState::from(body);
        let by_spin = InitialState { start: Start::Spin(omega), ..by_momentum };
        for state in [by_momentum, by_spin] {
            let scene = one(state, vec![], Times::every(0.7, 7.0), ALL, 1e-9);
            for state in states(&scene.plan(0).unwrap()) {
                let at = exact.at(state.time).unwrap();
                assert!((state.spin.unwrap() - at.omega).norm() < 1e-12);
                assert!(state.attitude.unwrap().angle_to(&at.attitude) < 1e-12);
                assert!((state.energy.unwrap() / body.energy() - 1.0).abs() < 1e-13);
                assert!(
                    (state.angle_to_momentum.unwrap() - tensor.angle_to_momentum(&at.omega).unwrap()).abs()
                        < 1e-12
                );
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Whatever the numbers: an answer or a refusal.
    #[test]
    fn no_numbers_break_a_scene(
        moments in prop::array::uniform3(any::<f64>()), w in prop::array::uniform3(any::<f64>()),
        likely in prop::array::uniform3(0.5..1.0_f64), flip in any::<bool>(), momentum in any::<bool>(),
        products in prop::option::of(prop::array::uniform3(any::<f64>())),
        times in prop::array::uniform2(any::<f64>()), accuracy in prop_oneof![any::<f64>(), Just(1e-6)],
    ) {
        let moments = Vector3::from(if flip { likely } else { moments });
        let start = Vector3::from(w);
        let start = if momentum { Start::Momentum(start) } else { Start::Spin(start) };
        let products = Vector3::from(products.unwrap_or_default());
        let body = InitialState { moments, products, attitude: UnitQuaternion::identity(), start };
        let outputs = Outputs { flips: true, polhode: true, ..ALL };
        for times in [Times::every(times[0], times[1]), Times::Given(times.map(f64::abs).to_vec()), Times::every(0.5, 1.0)] {
            let Ok(scene) = Scene::new(vec![body], vec![], times, outputs, accuracy) else { continue };
            let Ok(plan) = scene.plan(0) else { continue };
            prop_assert!(plan.explain().lines().count() == 4);
            let _ = (plan.flips().map(|flips| flips.take(3).count()), plan.polhode());
            for state in plan.states().take(3) {
                let Ok(state) = state else { continue };
                prop_assert!(state.spin.unwrap().iter().all(|x| x.is_finite()));
            }
        }
    }
}

/// The squares of such a spin are zero in `f64`. Of a million million states, the last is computed alone.
#[test]
fn the_last_state_of_a_body_that_turns_very_slowly_is_answered_at_once() {
    let body = InitialState::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(1.0, 2.0, 1.0) * 1e-163);
    let scene = one(body, vec![], Times::every(1e152, 1e164), BOTH, 1e-9);
    assert_eq!(scene.plan(0).unwrap().states().last().unwrap().unwrap().time, 1e164);
}

/// A tensor with products is turned to its principal axes, and that rounds a thin body's least moment to the
/// size of its largest: what is lost there is not promised. And a momentum that is turned loses as much about
/// the light axis.
#[test]
fn what_turning_to_the_principal_axes_rounds_is_not_promised() {
    let frame = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1);
    let rotation = frame.to_rotation_matrix();
    let moments = Vector3::new(1e-8, 1.0, 1.0 + 0.5e-8);
    let tensor = rotation * nalgebra::Matrix3::from_diagonal(&moments) * rotation.transpose();
    let products = Vector3::new(tensor[(0, 1)], tensor[(0, 2)], tensor[(1, 2)]);
    let given = InitialState { products, ..InitialState::spinning(tensor.diagonal(), Vector3::zeros()) };
    let turned = InitialState { attitude: frame, ..InitialState::spinning(moments, Vector3::zeros()) };
    let l = frame * moments.component_mul(&Vector3::new(0.3, 0.2, 1.0));
    // Along the needle the light moment itself is what is lost. No torque brings it back.
    let torques = [vec![], vec![Torque::InBody(Vector3::x() * 1e-300)]];
    let bodies = [(given, l), (given, frame * Vector3::new(1e-8, 0.0, 0.0)), (turned, l)];
    for ((body, momentum), torques) in bodies.iter().flat_map(|body| torques.iter().map(move |t| (body, t))) {
        let body = InitialState { start: Start::Momentum(*momentum), ..*body };
        let scene = |accuracy| one(body, torques.clone(), Times::Given(vec![0.0, 1.0]), BOTH, accuracy);
        let error = scene(1e-12).plan(0).map(|plan| plan.explain()).unwrap_err().to_string();
        let attainable = error.rsplit(": ").next().unwrap().parse().unwrap();
        assert!(attainable > 1e-9, "{error}");
        scene(attainable).plan(0).unwrap();
    }
}

/// The derivatives that the plan goes by, against the motion itself, started a little otherwise: what is
/// accepted is had.
#[test]
fn an_accuracy_is_refused_where_the_start_does_not_determine_it() {
    let roundings = 16.0 * f64::EPSILON;
    let mut refused = 0;
    for (moments, omega, end) in [
        ([1.0, 2.0, 2.5], [0.01, 1.0, 0.02], 300.0),
        ([1.0, 2.0, 2.5], [1e-4, 1.0, 1e-4], 100.0),
        ([1e-5, 1.0, 1.000_005], [3.0, 0.5, 0.1], 50.0),
        ([1.0, 1.0001, 1.9], [0.3, 0.2, 0.1], 1000.0),
        ([0.0012, 0.01638, 0.01748], [0.01, 10.0, 0.01], 60.0),
    ] {
        let (moments, omega) = (Vector3::from(moments), Vector3::from(omega));
        let motion = |omega: &Vector3<f64>| FreeMotion::new(moments.try_into().unwrap(), omega).unwrap();
        let one_of = motion(&omega);
        let flip = one_of.flips(0.0, end).unwrap().next_back();
        let mut worst = 1.0_f64;
        for time in flip.into_iter().chain([end]) {
            for j in 0..3 {
                let mut pushed = omega;
                let share = 1e-10;
                pushed[j] *= 1.0 + share;
                let (a, b) = (one_of.at(time).unwrap(), motion(&pushed).at(time).unwrap());
                let off = ((a.omega - b.omega).norm() / omega.norm()).max(a.attitude.angle_to(&b.attitude));
                worst = worst.max(off / share);
            }
        }
        for k in 0..30 {
            let accuracy = 1e-2 * 0.4_f64.powi(k);
            let times = Times::Given(vec![end]);
            let scene = one(InitialState::spinning(moments, omega), vec![], times, BOTH, accuracy);
            let accepted = scene.plan(0).is_ok();
            assert!(!accepted || accuracy > 0.9 * roundings * worst, "{moments:?}: {accuracy:e} {worst:e}");
            refused += usize::from(!accepted);
        }
    }
    assert!(refused > 20, "{refused}");
}

/// A million radians leave ten digits of a rotation, and fewer of a flip.
#[test]
fn an_accuracy_below_rounding_is_refused_with_what_can_be_had() {
    let (uneven, ball) = (Vector3::new(1.0, 2.0, 2.5), Vector3::new(1.0, 1.0, 1.0));
    let flip = Vector3::new(1e-4, 1.0, 0.0);
    for (moments, omega, end) in
        [(ball, Vector3::new(0.0, 1.0, 1.0), 1e6), (uneven, flip, 1e3), (uneven, flip, 1e6)]
    {
        let plan = |accuracy: f64| {
            let scene =
                one(InitialState::spinning(moments, omega), vec![], Times::Given(vec![end]), BOTH, accuracy);
            scene.plan(0).map(drop)
        };
        let Err(Error::Body { source, .. }) = plan(1e-12) else { panic!("{moments} {end}") };
        let Error::Unattainable { attainable, .. } = *source else { panic!("{source}") };
        assert!(attainable > 16.0 * f64::EPSILON * end, "{attainable:e}");
        assert!(attainable < 1e-1, "{attainable:e}");
        plan(1.001 * attainable).unwrap();
    }
}

/// Along the way the spin's components come as near to their bounds as the samples are close, and never pass
/// them.
#[test]
fn the_polhode_bounds_the_spin_and_touches_its_bounds() {
    for (moments, omega) in [
        ([1.0, 2.0, 2.5], [0.3, 1.0, 0.2]),
        ([1.0, 2.0, 2.5], [0.02, 0.3, 2.0]),
        ([2.5, 1.0, 2.0], [0.1, 1.5, 0.2]),
        ([2.0, 2.0, 3.0], [0.4, 0.3, 1.0]),
    ] {
        let body = InitialState::spinning(moments.into(), omega.into());
        let outputs = Outputs { polhode: true, ..SPIN };
        let scene = one(body, vec![], Times::every(0.01, 100.0), outputs, 1e-9);
        let plan = scene.plan(0).unwrap();
        let polhode = plan.polhode().unwrap();
        let (mut least, mut greatest) = (Vector3::repeat(f64::INFINITY), Vector3::zeros());
        for state in plan.states() {
            let size = state.unwrap().spin.unwrap().abs();
            (least, greatest) = (least.inf(&size), greatest.sup(&size));
        }
        assert!((polhode.greatest - greatest).amax() < 1e-3 && (polhode.greatest - greatest).min() > -1e-12);
        assert!((polhode.least - least).amax() < 2e-2 && (polhode.least - least).max() < 1e-12);
        let period = polhode.period.unwrap();
        let again = one(body, vec![], Times::Given(vec![period]), SPIN, 1e-9);
        let back = states(&again.plan(0).unwrap())[0].spin.unwrap();
        assert!((back - Vector3::from(omega)).norm() < 1e-12);
    }
}
