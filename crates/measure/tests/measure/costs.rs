//! The record of counted instructions, held to what the library does today.
//! That the counts themselves are those of today is checked by the example `scene_costs --check`, which needs
//! valgrind and fails without it.

#[path = "../../examples/counted_scenes/mod.rs"]
mod counted_scenes;

use counted_scenes::scenes;
use tumbling_measure::costs::{Cost, of, recorded};
use tumbling_scenes::Strategy;

fn cost(scene: &str) -> Cost {
    of(&recorded().unwrap().rows, scene).unwrap().clone()
}

/// The record's rows are the scenes of today, and each is answered by the strategy that its name says.
#[test]
fn the_record_is_of_the_strategies_that_are_chosen_today() {
    let expected = |name: &str| match name {
        "energy and flips alone" => Strategy::Nothing,
        "ball; spin alone" | "principal spin; spin alone" => Strategy::Constant,
        "ball" | "principal spin" => Strategy::Rotation,
        "two equal moments" | "two equal moments; spin alone" => Strategy::SymmetricTop,
        "three moments; spin alone" => Strategy::EllipticSpin,
        "three moments" => Strategy::Elliptic,
        "three moments and a weight; to 1e-2" | "three moments and a weight; to 1e-8" => Strategy::Adaptive,
        other => panic!("{other}"),
    };
    let scenes = scenes().unwrap();
    assert_eq!(scenes.len(), 11);
    for (name, scene) in &scenes {
        let plan = scene.plan(0).unwrap();
        assert_eq!(plan.strategy(), expected(name), "{name}: {}", plan.explain());
    }
}

/// What a plan says that it costs is what was counted, to a quarter; of a driven body, where it is a guess,
/// to a half.
#[test]
fn a_plan_expects_what_was_counted() {
    for (name, scene) in scenes().unwrap() {
        let (cost, counted) = (scene.plan(0).unwrap().cost(), cost(name));
        let room = if name.contains("weight") { 0.5 } else { 0.25 };
        for (expected, counted) in [(cost.state, counted.state), (cost.once, counted.plan)] {
            assert!(
                (expected / counted - 1.0).abs() < room,
                "{name}: {expected} expected, {counted} counted"
            );
        }
    }
}
