//! Scenes: the cheapest way is taken, and it is right; whatever cannot be answered is refused.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use serde_json::Value;
use tumbling::exact::FreeMotion;
use tumbling::scene::{Answer, LetGo, Plan, Scene, Times, Toss, Wants, Way};
use tumbling::step::{Method, Torque};
use tumbling::{Body, Error, Inertia, Refusal};

const ALL: Wants =
    Wants { spin: true, attitude: true, energy: true, gap: true, flips: false, polhode: false };
const SPIN: Wants = Wants { spin: true, ..Wants::NOTHING };
const BOTH: Wants = Wants { spin: true, attitude: true, ..Wants::NOTHING };

fn one(toss: Toss, torques: Vec<Torque<f64>>, times: Times, wants: Wants, accuracy: f64) -> Scene {
    Scene::new(vec![toss], torques, times, wants, accuracy).unwrap()
}

fn states(plan: &Plan<'_>) -> Vec<Answer> {
    plan.states().collect::<Result<_, _>>().unwrap()
}

/// The larger of the attitudes' angle and the spins' difference as a share.
fn apart(a: &Answer, b: &Answer) -> f64 {
    let (w, v) = (a.spin.unwrap(), b.spin.unwrap());
    let turn = match (a.attitude, b.attitude) {
        (Some(p), Some(q)) => p.angle_to(&q),
        _ => 0.0,
    };
    ((w - v).norm() / w.norm().max(v.norm()).max(f64::MIN_POSITIVE)).max(turn)
}

fn agree(a: &Scene, b: &Scene) -> f64 {
    let (a, b) = (a.plan(0).unwrap(), b.plan(0).unwrap());
    states(&a).iter().zip(&states(&b)).map(|(a, b)| apart(a, b)).fold(0.0, f64::max)
}

fn of_body(error: Error) -> Error {
    match error.refusal() {
        Refusal::OfBody { source, .. } => (**source).clone(),
        _ => panic!("{error}"),
    }
}

#[test]
fn each_scene_is_answered_in_the_way_that_leaves_out_the_most() {
    let (ball, top, uneven) =
        (Vector3::new(2.0, 2.0, 2.0), Vector3::new(2.0, 2.0, 3.0), Vector3::new(1.0, 2.0, 2.5));
    let (oblique, along, still) =
        (Vector3::new(0.3, 1.0, 0.2), Vector3::new(0.0, 1.0, 0.0), Vector3::zeros());
    let attitude = Wants { attitude: true, ..Wants::NOTHING };
    let name = |moments, omega, wants| {
        let scene = one(Toss::spinning(moments, omega), vec![], Times::every(0.5, 5.0), wants, 1e-9);
        match scene.plan(0).unwrap().way() {
            Way::Nothing => "nothing",
            Way::Constant { .. } => "constant",
            Way::Rotation(_) => "rotation",
            Way::SymmetricTop(_) => "symmetric top",
            Way::EllipticSpin(_) => "elliptic spin",
            Way::Elliptic(_) => "elliptic",
            _ => "steps",
        }
    };
    for wants in [Wants::NOTHING, Wants { energy: true, flips: true, polhode: true, ..Wants::NOTHING }] {
        assert_eq!(name(uneven, oblique, wants), "nothing");
    }
    assert_eq!(name(ball, oblique, SPIN), "constant");
    assert_eq!(name(uneven, still, BOTH), "constant");
    assert_eq!(name(uneven, along, SPIN), "constant");
    assert_eq!(name(ball, oblique, attitude), "rotation");
    assert_eq!(name(uneven, along, BOTH), "rotation");
    assert_eq!(name(top, oblique, SPIN), "symmetric top");
    assert_eq!(name(top, oblique, BOTH), "symmetric top");
    assert_eq!(name(uneven, oblique, SPIN), "elliptic spin");
    assert_eq!(name(uneven, oblique, Wants { gap: true, ..Wants::NOTHING }), "elliptic spin");
    assert_eq!(name(top, oblique, Wants { gap: true, ..Wants::NOTHING }), "nothing");
    assert_eq!(name(uneven, oblique, attitude), "elliptic");
}

/// A tensor with products, a body that lies turned in the world: each way against the motion of the whole body.
#[test]
fn a_body_that_lies_turned_in_its_own_axes_and_in_the_world_is_answered_in_those() {
    let lies = UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9);
    for moments in [[1.0, 2.0, 2.5], [2.0, 2.0, 3.0]] {
        let tensor = Inertia::from_moments(moments[0], moments[1], moments[2]).unwrap();
        let tensor = tensor.turned(&UnitQuaternion::from_euler_angles(1.0, 0.2, -0.7)).unwrap();
        let m = tensor.matrix();
        let omega = Vector3::new(0.4, -1.1, 0.7);
        let toss = Toss {
            moments: m.diagonal(),
            products: Vector3::new(m[(0, 1)], m[(0, 2)], m[(1, 2)]),
            attitude: lies,
            with: LetGo::Spin(omega),
        };
        let body = Body::spinning(tensor, lies, &omega).unwrap();
        let exact = FreeMotion::of(&body).unwrap();
        let by_momentum = Toss { with: LetGo::Momentum(body.momentum_world()), ..toss };
        for toss in [toss, by_momentum] {
            let scene = one(toss, vec![], Times::every(0.7, 7.0), ALL, 1e-9);
            for state in states(&scene.plan(0).unwrap()) {
                let at = exact.at(state.time).unwrap();
                assert!((state.spin.unwrap() - at.omega).norm() < 1e-12);
                assert!(state.attitude.unwrap().angle_to(&at.attitude) < 1e-12);
                assert!((state.energy.unwrap() / body.energy() - 1.0).abs() < 1e-13);
                assert!((state.gap.unwrap() - tensor.angle_to_momentum(&at.omega).unwrap()).abs() < 1e-12);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Two moments equal, or apart by a hair; all three; the spin along an axis, or beside it by a hair; the hair moves the motion by less
    /// than what is asked.
    #[test]
    fn scenes_on_either_side_of_a_border_agree(
        a in 0.6..1.0_f64, rise in 1.1..1.9_f64, w in prop::array::uniform3(-2.0..2.0_f64), hair in 1e-14..1e-12_f64,
    ) {
        let c = a * rise;
        let times = || Times::every(0.9, 9.0);
        let omega = Vector3::from(w);
        let scene = |moments: [f64; 3], omega| one(Toss::spinning(moments.into(), omega), vec![], times(), BOTH, 1e-9);
        let far = 1e-9;
        prop_assert!(agree(&scene([a, a, c], omega), &scene([a, a * (1.0 + hair), c], omega)) < far);
        prop_assert!(agree(&scene([c, a, a], omega), &scene([c, a * (1.0 + hair), a], omega)) < far);
        let ball = [1.0, 1.0 + hair, 1.0 + 3.0 * hair];
        prop_assert!(agree(&scene([1.0; 3], omega), &scene(ball, omega)) < far);
        let (fast, beside) = (w[0] + 3.0_f64.copysign(w[0]), hair * w[1]);
        let along = Vector3::new(fast, 0.0, 0.0);
        // About the largest and the smallest axis a hair stays one.
        for moments in [[0.5, a, 1.05], [1.2, a, 0.9]] {
            prop_assert!(agree(&scene(moments, along), &scene(moments, along + Vector3::new(0.0, beside, beside))) < far);
        }
        // At rest, or nearly.
        let creeping = scene([a, 1.0, c], omega * 1e-13).plan(0).map(|plan| states(&plan)).unwrap();
        prop_assert!(creeping.iter().all(|state| state.attitude.unwrap().angle() < far));
    }

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
        let with = if momentum { LetGo::Momentum(start) } else { LetGo::Spin(start) };
        let products = Vector3::from(products.unwrap_or_default());
        let toss = Toss { moments, products, attitude: UnitQuaternion::identity(), with };
        let wants = Wants { flips: true, polhode: true, ..ALL };
        for times in [Times::every(times[0], times[1]), Times::Given(times.map(f64::abs).to_vec()), Times::every(0.5, 1.0)] {
            let Ok(scene) = Scene::new(vec![toss], vec![], times, wants, accuracy) else { continue };
            let Ok(plan) = scene.plan(0) else { continue };
            prop_assert!(plan.explain().lines().count() == 4);
            let _ = (plan.flips().map(|flips| flips.take(3).count()), plan.polhode());
            for state in plan.states().take(3) {
                let Ok(state) = state else { continue };
                prop_assert!(state.spin.unwrap().iter().all(|x| x.is_finite()));
            }
        }
    }

    /// A torque that fades meets the free motion.
    #[test]
    fn a_fading_torque_meets_the_free_motion(
        a in 0.6..1.0_f64, c in 1.1..1.5_f64, w in prop::array::uniform3(0.3..2.0_f64),
        torque in prop::array::uniform3(-1.0..1.0_f64), accuracy in prop::sample::select(vec![1e-3, 1e-6, 1e-9]),
    ) {
        let toss = Toss::spinning(Vector3::new(a, 1.05, c), w.into());
        let free = one(toss, vec![], Times::every(1.0, 5.0), BOTH, accuracy);
        for torque in [
            Torque::InBody(Vector3::from(torque) * (1e-3 * accuracy)),
            Torque::Aligning { arm: Vector3::from(torque) * (1e-3 * accuracy), field: Vector3::new(0.0, 0.0, -1.0) },
            Torque::Damping(Vector3::from(torque).abs() * (1e-3 * accuracy)),
        ] {
            let driven = one(toss, vec![torque], Times::every(1.0, 5.0), BOTH, accuracy);
            prop_assert!(agree(&free, &driven) < 2.0 * accuracy);
        }
    }
}

#[test]
fn a_torque_of_nothing_is_no_torque() {
    let toss = Toss::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 1.0, 0.2));
    let nothing = vec![
        Torque::InBody(Vector3::zeros()),
        Torque::gravity(Vector3::new(0.0, 0.0, 1.0), 0.0),
        Torque::Damping(Vector3::zeros()),
        Torque::Dissipation(0.0),
    ];
    let scene = one(toss, nothing, Times::every(1.0, 5.0), BOTH, 1e-9);
    assert!(matches!(scene.plan(0).unwrap().way(), Way::Elliptic(_)));
}

/// The table of 30 digits: a heavy top and a damped spin.
#[test]
fn driven_scenes_are_as_accurate_as_asked_against_the_truth() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/measure/data/truth.json");
    let table: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let number = |x: &Value| x.as_f64().or_else(|| x.as_str()?.parse().ok()).unwrap();
    let three = |x: &Value| Vector3::from_iterator(x.as_array().unwrap().iter().map(number));
    let mut seen = 0;
    for entry in table["stories"].as_array().unwrap() {
        let mut torques = Vec::new();
        if entry["weight"].as_f64().is_some_and(|weight| weight != 0.0) {
            torques.push(Torque::gravity(three(&entry["arm"]), number(&entry["weight"])));
        }
        if entry["damping"].is_array() && three(&entry["damping"]) != Vector3::zeros() {
            torques.push(Torque::Damping(three(&entry["damping"])));
        }
        let driven = !torques.is_empty();
        let moments = three(&entry["moments"]);
        let toss = Toss::spinning(moments, three(&entry["omega"]));
        let q: Vec<f64> = entry["attitude"].as_array().unwrap().iter().map(number).collect();
        let truth = UnitQuaternion::from_quaternion(Quaternion::new(q[0], q[1], q[2], q[3]));
        let spin = three(&entry["momentum"]).component_div(&moments);
        for accuracy in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10] {
            let times = Times::every(0.5, number(&entry["t"]));
            let scene = one(toss, torques.clone(), times, BOTH, accuracy);
            let plan = match scene.plan(0) {
                // A hundred flips leave less than ten digits of the attitude.
                Err(error) if !driven => {
                    let source = of_body(error);
                    assert!(
                        matches!(source.refusal(), Refusal::Unattainable { asked: 1e-10, .. }),
                        "{source}"
                    );
                    continue;
                }
                plan => plan.unwrap(),
            };
            let last = states(&plan).pop().unwrap();
            assert_eq!(last.time, number(&entry["t"]));
            let off =
                last.attitude.unwrap().angle_to(&truth).max((last.spin.unwrap() - spin).norm() / spin.norm());
            assert!(
                off < accuracy,
                "{}: {off:.1e} where {accuracy:e} was asked: {}",
                entry["name"],
                plan.explain()
            );
            seen += usize::from(driven);
        }
    }
    assert_eq!(seen, 10);
}

/// Coarse asks are for fixed steps, fine ones for the controlled pair, the faintest torques for the exact flow.
#[test]
fn the_method_follows_from_the_torque_and_the_accuracy() {
    let top = Toss::spinning(Vector3::new(1.0, 1.5, 0.75), Vector3::new(0.25, 0.5, 8.0));
    let way = |weight: f64, accuracy: f64, times: Times| {
        let torque = Torque::gravity(Vector3::new(0.125, 0.0, 0.5), weight);
        let scene = one(top, vec![torque], times, BOTH, accuracy);
        match scene.plan(0).unwrap().way() {
            Way::Stepper(driven) => driven.method().unwrap().info().name,
            Way::Controlled(_) => "controlled",
            Way::Flow(_) => "flow",
            _ => "other",
        }
    };
    assert_eq!(way(4.0, 1e-2, Times::every(1.0 / 60.0, 1.0)), "Moser-Veselov 8");
    assert_eq!(way(4.0, 1e-8, Times::every(1.0, 16.0)), "controlled");
    assert_eq!(way(1e-8, 1e-8, Times::every(16.0, 16.0)), "flow");
}

/// Damping ten thousand times faster than anything else, against its own law: `w = w0 exp(-c t / I)` about a principal axis.
#[test]
fn stiff_damping_takes_few_steps_and_is_right() {
    let moments = Vector3::new(1.0, 2.0, 2.5);
    let toss = Toss::spinning(moments, Vector3::new(0.0, 1.0, 0.0));
    let torque = Torque::Damping(Vector3::new(1e4, 2e4, 2e4));
    let scene = one(toss, vec![torque], Times::Given(vec![1e-4, 1.0]), BOTH, 1e-4);
    let plan = scene.plan(0).unwrap();
    let Way::Stiff(driven) = plan.way() else { panic!("{}", plan.explain()) };
    assert!(driven.steps() < 100_000, "{}", plan.explain());
    let states = states(&plan);
    assert!((states[0].spin.unwrap().y - (-1.0_f64).exp()).abs() < 1e-4);
    assert!(states[1].spin.unwrap().norm() < 1e-6);
    // An overdamped needle in a field creeps along it: theta' = -(m B / c) sin theta.
    let toss = Toss::spinning(moments, Vector3::zeros());
    let field = Torque::Aligning { arm: Vector3::x(), field: Vector3::new(0.0, 10.0, 0.0) };
    // tan(angle/2) falls as exp(-m B t / c), from a right angle; inertia changes that by I m B / c², 1e-5 and less.
    let angle = 2.0 * (-1.0_f64).exp().atan();
    for (c, end) in [(1e3, 100.0), (1e4, 1000.0)] {
        let drag = Torque::Damping(Vector3::new(c, c, c));
        let scene = one(toss, vec![field.clone(), drag], Times::Given(vec![end]), BOTH, 1e-3);
        let plan = scene.plan(0).unwrap();
        let Way::Stiff(driven) = plan.way() else { panic!("{}", plan.explain()) };
        assert_eq!(driven.method(), Some(Method::LinearisedImplicit), "{}", plan.explain());
        assert!(plan.explain().contains("which fast damping makes short"), "{}", plan.explain());
        let last = plan.states().last().unwrap().unwrap();
        let turned = last.attitude.unwrap() * Vector3::x();
        assert!((turned.angle(&Vector3::y()) - angle).abs() < 1e-3);
    }
}

/// Damping creeps for all of the run: the pair's steps are short, and still the fewest that are right. Or it fades within a hundredth of it,
/// and kicks are cheaper than the pair.
#[test]
fn of_the_ways_through_fast_damping_the_cheapest_that_is_right_is_taken() {
    let toss = Toss::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(3.0, 5.0, 2.0));
    let needle = Torque::Aligning { arm: Vector3::x(), field: Vector3::new(0.0, 10.0, 0.0) };
    let even = Torque::Damping(Vector3::new(1000.0, 1000.0, 1000.0));
    let (push, uneven) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(5000.0, 1000.0, 2000.0));
    let pushed = vec![Torque::InBody(push), Torque::Damping(uneven)];
    for (torques, times, by_pair) in [
        (vec![needle, even], vec![1e-3, 1e-2, 1.0, 10.0, 50.0, 100.0], true),
        (pushed.clone(), vec![1e-3, 1e-2, 0.1, 1.0, 3.0], false),
    ] {
        let to = |accuracy| {
            let times = Times::Given(times.clone());
            one(toss, torques.clone(), times, Wants { energy: true, ..BOTH }, accuracy)
        };
        let (scene, fine) = (to(1e-3), to(1e-9));
        let (plan, truth) = (scene.plan(0).unwrap(), fine.plan(0).unwrap());
        // To nine digits the pair is the only one that gets there: what it costs bounds the others.
        let Way::Controlled(_) = truth.way() else { panic!("{}", truth.explain()) };
        assert!(plan.cost().state <= truth.cost().state, "{}", plan.explain());
        let told = if by_pair {
            "steps that fast damping does not shorten"
        } else {
            "which fast damping makes short"
        };
        assert!(plan.explain().contains(told), "{}", plan.explain());
        let (mut fastest, mut richest) = (0.0_f64, 0.0_f64);
        for (state, right) in states(&plan).iter().zip(states(&truth)) {
            let (spin, energy) = (right.spin.unwrap(), right.energy.unwrap());
            (fastest, richest) = (fastest.max(spin.norm()), richest.max(energy));
            assert!((state.spin.unwrap() - spin).norm() < 1e-3 * fastest);
            assert!((state.energy.unwrap() - energy).abs() < 1e-3 * richest);
            assert!(state.attitude.unwrap().angle_to(&right.attitude.unwrap()) < 1e-3);
        }
    }
    // In the end the push holds the drag, about each axis: c w = torque, but for the gyroscopic 1e-6.
    let scene = one(toss, pushed, Times::Given(vec![3.0]), SPIN, 1e-3);
    let end = scene.plan(0).unwrap().states().last().unwrap().unwrap();
    assert!((end.spin.unwrap() - push.component_div(&uneven)).norm() < 1e-5);
}

/// Along x without products and along x with hardly any is not the same axis by its number: what cannot be told is refused.
#[test]
fn uneven_damping_of_a_body_with_products_is_refused_and_even_damping_is_not() {
    let moments = Vector3::new(3.0, 1.5, 2.5);
    let end = |products: Vector3<f64>, damping: Vector3<f64>| {
        let toss = Toss { products, ..Toss::spinning(moments, Vector3::x()) };
        let scene = one(toss, vec![Torque::Damping(damping)], Times::Given(vec![5.0]), SPIN, 1e-8);
        scene.plan(0).map(|plan| states(&plan).pop().unwrap().spin.unwrap())
    };
    let (none, hardly) = (Vector3::zeros(), Vector3::new(1e-12, 0.0, 0.0));
    let uneven = Vector3::new(0.5, 0.0, 0.0);
    assert!((end(none, uneven).unwrap().x - (-0.5_f64 * 5.0 / 3.0).exp()).abs() < 1e-8);
    let told = end(hardly, uneven).unwrap_err().to_string();
    assert!(
        told.contains("damping that differs from axis to axis is asked for, but it is told along"),
        "{told}"
    );
    let even = Vector3::new(0.5, 0.5, 0.5);
    assert!((end(none, even).unwrap() - end(hardly, even).unwrap()).norm() < 1e-8);
}

/// The same top, told along its principal axes and told in axes of its maker's: the arm, the push and the attitude go along.
#[test]
fn a_driven_body_told_in_other_axes_moves_the_same() {
    let moments = Vector3::new(1.0, 1.5, 0.75);
    let frame = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1);
    let rotation = frame.to_rotation_matrix();
    let tensor = rotation * nalgebra::Matrix3::from_diagonal(&moments) * rotation.transpose();
    let (omega, arm, push) =
        (Vector3::new(0.25, 0.5, 4.0), Vector3::new(0.125, 0.0, 0.5), Vector3::new(0.05, -0.1, 0.02));
    let attitude = UnitQuaternion::from_euler_angles(-0.2, 0.3, 0.5);
    let plain = Toss { attitude: attitude * frame, ..Toss::spinning(moments, omega) };
    let other = Toss {
        moments: tensor.diagonal(),
        products: Vector3::new(tensor[(0, 1)], tensor[(0, 2)], tensor[(1, 2)]),
        attitude,
        with: LetGo::Spin(frame * omega),
    };
    let answers = |toss, turn: UnitQuaternion<f64>| {
        let torques = vec![
            Torque::Aligning { arm: turn * arm, field: Vector3::new(0.0, 0.0, -2.0) },
            Torque::InBody(turn * push),
            Torque::InWorld(Vector3::new(0.1, 0.0, -0.05)),
        ];
        let scene = one(toss, torques, Times::every(0.5, 3.0), ALL, 1e-8);
        states(&scene.plan(0).unwrap())
    };
    for (a, b) in answers(plain, UnitQuaternion::identity()).iter().zip(&answers(other, frame)) {
        assert!((frame * a.spin.unwrap() - b.spin.unwrap()).norm() < 1e-7, "at {} s", a.time);
        assert!((a.attitude.unwrap() * frame.inverse()).angle_to(&b.attitude.unwrap()) < 1e-7);
        assert!((a.energy.unwrap() - b.energy.unwrap()).abs() < 1e-6);
        assert!((a.gap.unwrap() - b.gap.unwrap()).abs() < 1e-7);
    }
}

/// A push so weak that one step would do: two runs met at the one instant asked for, and both were wrong by three times what was asked.
#[test]
fn runs_are_compared_between_the_times_asked_for_too() {
    let (moments, omega) = (Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 3.0, 0.2));
    let field = Vector3::new(0.0, 0.0, -0.001_254_310_970_579_529_5);
    let torque = Torque::Aligning { arm: Vector3::new(0.125, 0.0, 0.5), field };
    let at = |accuracy| {
        let times = Times::Given(vec![7.907_675_008_433_149]);
        let scene = one(Toss::spinning(moments, omega), vec![torque.clone()], times, BOTH, accuracy);
        let plan = scene.plan(0).unwrap();
        if let Way::Flow(driven) | Way::Stepper(driven) | Way::Controlled(driven) = plan.way() {
            assert!(driven.seen() <= 0.5 * accuracy, "{}", plan.explain());
        }
        states(&plan)[0]
    };
    assert!(apart(&at(1e-2), &at(1e-9)) < 1e-2);
}

/// Where nothing that moves is asked for, a torque costs nothing either.
#[test]
fn a_driven_scene_that_asks_for_nothing_computes_nothing() {
    let damped = vec![Torque::Damping(Vector3::new(1.0, 2.0, 3.0))];
    let toss = Toss::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(3.0, 5.0, 2.0));
    let scene = one(toss, damped.clone(), Times::every(0.1, 100.0), Wants::NOTHING, 1e-9);
    let plan = scene.plan(0).unwrap();
    assert!(matches!(plan.way(), Way::Nothing) && plan.cost().once < 2000.0, "{}", plan.explain());
    // And the attitude, not asked for, refines no step.
    let cost =
        |wants| one(toss, damped.clone(), Times::every(0.1, 5.0), wants, 1e-7).plan(0).unwrap().cost().state;
    assert!(cost(SPIN) <= cost(BOTH));
}

/// Multiples of a step that no sum of doubles meets, and counts so large that a share of them is many.
#[test]
fn as_many_states_as_steps_fit_the_span_and_one() {
    for (step, span, count) in [
        (0.1, 0.3, 4),
        (0.1, 10.0, 101),
        (0.1, 0.299, 3),
        (1.0 / 3.0, 1e3, 3001),
        (1.0, 1e9 - 0.5, 1_000_000_000),
        (1.0, 1e10, 10_000_000_001),
        (1e-3, 1e12, 1_000_000_000_000_001),
    ] {
        let times = Times::every(step, span);
        assert_eq!(times.count(), count, "{step} {span}");
        assert!(times.nth(count - 1) <= span && times.nth(count) <= span);
    }
    assert_eq!(Times::every(0.1, 0.3).nth(3), 0.3);
}

/// A tensor with products is turned to its principal axes, and that rounds a thin body's least moment to the size of its largest: what is
/// lost there is not promised. And a momentum that is turned loses as much about the light axis.
#[test]
fn what_turning_to_the_principal_axes_rounds_is_not_promised() {
    let frame = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1);
    let rotation = frame.to_rotation_matrix();
    let moments = Vector3::new(1e-8, 1.0, 1.0 + 0.5e-8);
    let tensor = rotation * nalgebra::Matrix3::from_diagonal(&moments) * rotation.transpose();
    let products = Vector3::new(tensor[(0, 1)], tensor[(0, 2)], tensor[(1, 2)]);
    let l = frame * moments.component_mul(&Vector3::new(0.3, 0.2, 1.0));
    let along = frame * Vector3::new(1e-8, 0.0, 0.0);
    for toss in [
        Toss {
            moments: tensor.diagonal(),
            products,
            attitude: UnitQuaternion::identity(),
            with: LetGo::Momentum(l),
        },
        // Here the light moment itself is what is lost.
        Toss {
            moments: tensor.diagonal(),
            products,
            attitude: UnitQuaternion::identity(),
            with: LetGo::Momentum(along),
        },
        Toss {
            moments: Vector3::new(1e-8, 1.0, 1.0 + 0.5e-8),
            products: Vector3::zeros(),
            attitude: frame,
            with: LetGo::Momentum(l),
        },
    ] {
        let scene = |accuracy| one(toss, vec![], Times::Given(vec![0.0, 1.0]), BOTH, accuracy);
        let told = scene(1e-12).plan(0).map(|plan| plan.explain()).unwrap_err();
        let source = of_body(told);
        assert!(
            matches!(source.refusal(), Refusal::Unattainable { attainable, .. } if *attainable > 1e-9),
            "{source}"
        );
    }
}

/// The derivatives that the plan goes by, against the motion itself, started a little otherwise: what is accepted is had.
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
            let scene = one(Toss::spinning(moments, omega), vec![], times, BOTH, accuracy);
            let accepted = scene.plan(0).is_ok();
            assert!(!accepted || accuracy > 0.9 * roundings * worst, "{moments:?}: {accuracy:e} {worst:e}");
            refused += usize::from(!accepted);
        }
    }
    assert!(refused > 20, "{refused}");
}

/// The spin of a top goes round in the body at the rate (C - A) n / A.
#[test]
fn the_polhode_of_a_top_is_once_around_after_its_period() {
    let (moments, omega) = (Vector3::new(2.0, 2.0, 3.0), Vector3::new(0.4, 0.5, -1.0));
    let wants = Wants { polhode: true, ..Wants::NOTHING };
    let scene = one(Toss::spinning(moments, omega), vec![], Times::every(1.0, 1.0), wants, 1e-9);
    let period = scene.plan(0).unwrap().polhode().unwrap().period.unwrap();
    assert!((period - std::f64::consts::TAU / 0.5).abs() < 1e-12);
}

/// Two strong torques, no digit asked for to speak of, and a thousand seconds: the way there is longer than anybody waits.
#[test]
fn trials_end_after_so_many_steps_in_all() {
    let toss = Toss::spinning(Vector3::new(1.794, 1.112, 1.532), Vector3::new(0.368, -0.454, 0.189));
    let push = Torque::InWorld(Vector3::new(4.42, 4.05, -3.34));
    let (arm, field) = (Vector3::new(-2.64, 5.36, 2.48), Vector3::new(-8.12, -9.62, 3.27));
    let torques = vec![push, Torque::Aligning { arm, field }];
    let times = Times::Given(vec![0.0, 300.0, 1000.0]);
    let scene = one(toss, torques, times, Wants { energy: true, ..Wants::NOTHING }, 0.5);
    let source = of_body(scene.plan(0).map(drop).unwrap_err());
    let &Refusal::Disagreement { steps, .. } = source.refusal() else { panic!("{source}") };
    assert!(steps <= 3_000_000, "{source}");
}

/// A needle spins about its light axis, and its energy is in the others: the spin may be right to a share that the energy is not.
#[test]
fn the_energy_under_a_torque_is_as_right_as_asked() {
    let moments = Vector3::new(1e-4, 1.0, 1.000_05);
    let toss = Toss::spinning(moments, Vector3::new(10.0, 0.1, 0.0));
    let push = Vector3::new(0.0, 0.3, 0.0);
    for accuracy in [0.1, 0.01, 1e-3] {
        let wants = Wants { energy: true, ..SPIN };
        let scene = |accuracy| one(toss, vec![Torque::InBody(push)], Times::every(0.5, 5.0), wants, accuracy);
        let (rough, fine) = (scene(accuracy), scene(1e-7));
        let (a, b) = (states(&rough.plan(0).unwrap()), states(&fine.plan(0).unwrap()));
        let mut most = 0.0_f64;
        for (a, b) in a.iter().zip(&b) {
            most = most.max(b.energy.unwrap());
            let off = (a.energy.unwrap() - b.energy.unwrap()).abs() / most;
            assert!(off < accuracy, "{off:e} of {accuracy:e} at {}", a.time);
        }
    }
}

#[test]
fn refusals_are_plain_sentences() {
    let refused = |toss: Toss, torques, time, accuracy| {
        let scene = Scene::new(vec![toss], torques, Times::Given(vec![time]), ALL, accuracy);
        scene.and_then(|scene| scene.plan(0).map(drop)).unwrap_err().to_string()
    };
    let slow = Toss::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 5.0, 0.2));
    let fast =
        Toss::spinning(Vector3::new(1.37e299, 1.42e299, 1.06e299), Vector3::new(-4e299, -8e299, 2e298));
    assert_eq!(refused(slow, vec![], 1.0, 1.0), "the accuracy is 1.0: it must be below 1");
    let told = refused(fast, vec![], 1e9, 1e-9);
    assert!(told.starts_with("body 0: the angle turned up to the last time comes out as inf"), "{told}");
    let push = Torque::InBody(Vector3::new(0.1, 0.0, 0.0));
    let told = refused(slow, vec![push.clone()], 10.0, 1e-15);
    let share: f64 = told.rsplit(' ').next().unwrap().parse().unwrap();
    assert!((1e-14..1e-10).contains(&share), "{told}");
    // What is offered can be had.
    let scene = one(slow, vec![push], Times::Given(vec![10.0]), ALL, 1.1 * share);
    assert!(scene.plan(0).is_ok(), "{told}");
}

#[test]
fn what_cannot_be_answered_is_refused_and_says_why() {
    let toss = Toss::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 1.0, 0.2));
    let times = Times::every(1.0, 2.0);
    let new = |bodies: Vec<Toss>, times: &Times, accuracy: f64| {
        Scene::new(bodies, vec![], times.clone(), BOTH, accuracy)
    };
    assert!(matches!(
        new(vec![], &times, 1e-9).unwrap_err().refusal(),
        Refusal::TooFew { what: "bodies", count: 0, .. }
    ));
    let unsorted = Times::Given(vec![0.0, 2.0, 1.0]);
    assert!(matches!(
        new(vec![toss], &unsorted, 1e-9).unwrap_err().refusal(),
        Refusal::Order { small: 2.0, large: 1.0, .. }
    ));
    for bad in [Times::Given(vec![]), Times::Given(vec![-1.0]), Times::Given(vec![f64::NAN])] {
        assert!(new(vec![toss], &bad, 1e-9).is_err());
    }
    for (step, span) in [(0.0, 1.0), (1.0, -1.0), (f64::NAN, 1.0), (1.0, f64::INFINITY), (1e-300, 1e300)] {
        assert!(new(vec![toss], &Times::every(step, span), 1e-9).is_err());
    }
    for bad in [0.0, -1.0, 1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            new(vec![toss], &times, bad).unwrap_err().refusal(),
            Refusal::NotPositive { .. } | Refusal::NotFinite { .. } | Refusal::NotBelow { .. }
        ));
    }
    assert!(matches!(new(vec![toss], &times, 1e-17).unwrap_err().refusal(), Refusal::Unattainable { .. }));
    let source = |scene: &Scene| of_body(scene.plan(0).unwrap_err()).refusal().clone();
    let wants = Wants { flips: true, ..Wants::NOTHING };
    let drag = || vec![Torque::Damping(Vector3::new(1.0, 1.0, 1.0))];
    assert!(matches!(
        source(&one(toss, drag(), times.clone(), wants, 1e-9)),
        Refusal::Undefined { what: "the list of flips", .. }
    ));
    let still = Toss::spinning(toss.moments, Vector3::zeros());
    let gap = Wants { gap: true, ..Wants::NOTHING };
    assert!(matches!(source(&one(still, vec![], times.clone(), gap, 1e-9)), Refusal::Undefined { .. }));
    let long = Toss { attitude: UnitQuaternion::new_unchecked(Quaternion::new(2.0, 0.0, 0.0, 0.0)), ..toss };
    assert!(matches!(source(&one(long, vec![], times, BOTH, 1e-9)), Refusal::NotUnit { .. }));
    assert!(one(toss, vec![], Times::every(1.0, 2.0), BOTH, 1e-9).plan(7).is_err());
}

/// A year of a top, or a torque that no step could follow: refused at once, not tried for hours.
#[test]
fn a_driven_scene_that_would_take_for_ever_is_refused_at_once() {
    let toss = Toss::spinning(Vector3::new(1.0, 1.5, 0.75), Vector3::new(0.25, 0.5, 8.0));
    for (weight, end) in [(4.0, 3e7), (1e300, 10.0), (4.0, 1e300)] {
        let torque = Torque::gravity(Vector3::new(0.125, 0.0, 0.5), weight);
        let scene = one(toss, vec![torque], Times::every(end, end), BOTH, 1e-9);
        let source = of_body(scene.plan(0).map(drop).unwrap_err());
        assert!(matches!(source.refusal(), Refusal::Order { .. } | Refusal::OutOfRange { .. }), "{source}");
    }
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
            let scene = one(Toss::spinning(moments, omega), vec![], Times::Given(vec![end]), BOTH, accuracy);
            scene.plan(0).map(drop)
        };
        let source = of_body(plan(1e-12).map(drop).unwrap_err());
        let &Refusal::Unattainable { attainable, .. } = source.refusal() else { panic!("{source}") };
        assert!(attainable > 16.0 * f64::EPSILON * end, "{attainable:e}");
        assert!(attainable < 1e-1, "{attainable:e}");
        plan(1.001 * attainable).unwrap();
    }
}

#[test]
fn one_body_that_is_none_leaves_the_others_answered() {
    let good =
        |k: u32| Toss::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 1.0, 0.001 * f64::from(k)));
    let mut bodies: Vec<Toss> = (0..1000).map(good).collect();
    bodies[777].moments.z = 3.5;
    let scene = Scene::new(bodies, vec![], Times::every(1.0, 1.0), SPIN, 1e-9).unwrap();
    let (mut answered, mut refused) = (0, Vec::new());
    scene.run(|index, state| match state {
        Ok(_) => answered += 1,
        Err(error) => refused.push((index, error)),
    });
    assert_eq!(answered, 2 * 999);
    assert_eq!(refused.len(), 1);
    assert!(
        matches!(&refused[0], (777, error) if matches!(of_body(error.clone()).refusal(), Refusal::TriangleInequality { .. }))
    );
}

#[test]
fn a_span_of_zero_answers_the_start() {
    let toss = Toss::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 1.0, 0.2));
    for torques in [vec![], vec![Torque::InBody(Vector3::x())]] {
        let scene = one(toss, torques, Times::every(1.0, 0.0), ALL, 1e-9);
        let plan = scene.plan(0).unwrap();
        let [state] = states(&plan)[..] else { panic!() };
        assert_eq!(
            (state.time, state.spin, state.attitude),
            (0.0, Some(Vector3::new(0.1, 1.0, 0.2)), Some(toss.attitude))
        );
    }
}

/// Along the way the spin's components come as near to their bounds as the samples are close, and never pass them.
#[test]
fn the_polhode_bounds_the_spin_and_touches_its_bounds() {
    for (moments, omega) in [
        ([1.0, 2.0, 2.5], [0.3, 1.0, 0.2]),
        ([1.0, 2.0, 2.5], [0.02, 0.3, 2.0]),
        ([2.5, 1.0, 2.0], [0.1, 1.5, 0.2]),
        ([2.0, 2.0, 3.0], [0.4, 0.3, 1.0]),
    ] {
        let toss = Toss::spinning(moments.into(), omega.into());
        let wants = Wants { polhode: true, ..SPIN };
        let scene = one(toss, vec![], Times::every(0.01, 100.0), wants, 1e-9);
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
        let again = one(toss, vec![], Times::Given(vec![period]), SPIN, 1e-9);
        let back = states(&again.plan(0).unwrap())[0].spin.unwrap();
        assert!((back - Vector3::from(omega)).norm() < 1e-12);
    }
}

/// Each kind of plan says what it leaves out.
#[test]
fn a_plan_explains_itself_in_words() {
    let told = |moments: [f64; 3], omega: [f64; 3], torques, wants| {
        let toss = Toss::spinning(moments.into(), omega.into());
        one(toss, torques, Times::every(0.5, 5.0), wants, 1e-6).plan(0).unwrap().explain()
    };
    for (text, words) in [
        (told([1.0; 3], [1.0, 2.0, 3.0], vec![], SPIN), "all three moments are equal"),
        (told([1.0, 2.0, 2.5], [0.0, 1.0, 0.0], vec![], BOTH), "along a principal axis"),
        (told([2.0, 2.0, 2.5], [0.1, 1.0, 0.5], vec![], BOTH), "two moments are equal"),
        (told([1.0, 2.0, 2.5], [0.1, 1.0, 0.5], vec![], SPIN), "the attitude, which is not asked for"),
        (told([1.0, 2.0, 2.5], [0.1, 1.0, 0.5], vec![], BOTH), "no torque acts"),
        (
            told([1.0, 2.0, 2.5], [0.1, 1.0, 0.5], vec![Torque::InBody(Vector3::x())], BOTH),
            "since a torque acts",
        ),
        (told([1.0, 2.0, 2.5], [0.1, 1.0, 0.5], vec![], Wants::NOTHING), "nothing that moves is asked for"),
    ] {
        assert!(text.contains(words), "{text}");
        assert_eq!(text.lines().count(), 4, "{text}");
        assert!(
            text.lines()
                .zip(["chosen: ", "left out: ", "accuracy: ", "cost: "])
                .all(|(line, head)| line.starts_with(head))
        );
    }
}
