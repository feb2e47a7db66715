//! What each thing left out saves: the record of counted instructions, held to what the library does today.
//! That the counts themselves are those of today is checked by `measure scenes --check`, which needs valgrind
//! and fails without it.

use tumbling_measure::saving;
use tumbling_measure::savings::{CRATES, GENERAL, MORE, PLAN, STATE, differences, renewed, scenes, value};
use tumbling_scenes::Strategy;

fn count(row: &str, what: &str) -> f64 {
    value(&saving::recorded().unwrap().rows, "executed", row, what)
        .unwrap_or_else(|| panic!("no count of {row}"))
}

#[test]
fn whatever_is_left_out_makes_a_state_cheaper() {
    let cheaper = |less: &str, more: &str, share: f64| {
        let (less_count, more_count) = (count(less, STATE), count(more, STATE));
        assert!(less_count < share * more_count, "{less}: {less_count}, {more}: {more_count}");
    };
    // No motion; no functions; sines for elliptic functions; no attitude; no torque.
    cheaper("energy and flips alone", GENERAL, 0.2);
    cheaper("ball; spin alone", GENERAL, 0.2);
    cheaper("principal spin; spin alone", GENERAL, 0.2);
    cheaper("ball", GENERAL, 0.4);
    cheaper("principal spin", GENERAL, 0.4);
    // Its sines are now those that lanes share, the same to the last bit, and take a tenth more than the C
    // library's did.
    cheaper("two equal moments", GENERAL, 0.85);
    cheaper("two equal moments; spin alone", "three moments; spin alone", 0.7);
    cheaper("two equal moments; spin alone", "two equal moments", 0.6);
    cheaper("three moments; spin alone", GENERAL, 0.7);
    // Few digits; and no torque, of what is done once: a state under a torque is a value of a series.
    cheaper("three moments and a weight; to 1e-2", "three moments and a weight; to 1e-8", 0.8);
    assert!(count(GENERAL, PLAN) < 0.2 * count("three moments and a weight; to 1e-2", PLAN));
    // The same for what is done once.
    for elementary in ["ball", "principal spin", "two equal moments", "two equal moments; spin alone"] {
        assert!(count(elementary, PLAN) < 0.2 * count(GENERAL, PLAN), "{elementary}");
    }
}

/// The record's rows are the scenes of today, and each is answered by the strategy that its name says.
#[test]
fn the_record_is_of_the_strategies_that_are_chosen_today() {
    let expected = |name: &str, strategy: &Strategy| match name {
        "energy and flips alone" => matches!(strategy, Strategy::Nothing),
        "ball; spin alone" | "principal spin; spin alone" => matches!(strategy, Strategy::Constant { .. }),
        "ball" | "principal spin" => matches!(strategy, Strategy::Rotation { .. }),
        "two equal moments" | "two equal moments; spin alone" => {
            matches!(strategy, Strategy::SymmetricTop(_))
        }
        "three moments; spin alone" => matches!(strategy, Strategy::EllipticSpin(_)),
        "three moments" => matches!(strategy, Strategy::Elliptic(_)),
        "three moments and a weight; to 1e-2" | "three moments and a weight; to 1e-8" => {
            matches!(strategy, Strategy::Adaptive(_))
        }
        other => panic!("{other}"),
    };
    let scenes = scenes().unwrap();
    assert_eq!(scenes.len(), 11);
    for one in &scenes {
        let plan = one.scene.plan(0).unwrap();
        assert!(expected(one.name, plan.strategy()), "{}: {}", one.name, plan.explain());
    }
}

/// What a plan says that it costs is what was counted, to a quarter; of a driven body, where it is a guess,
/// to a half.
#[test]
fn a_plan_expects_what_was_counted() {
    for one in scenes().unwrap() {
        let cost = one.scene.plan(0).unwrap().cost();
        let driven = one.name.contains("weight");
        let room = if driven { 0.5 } else { 0.25 };
        for (expected, what) in [(cost.state, STATE), (cost.once, PLAN)] {
            let counted = count(one.name, what);
            assert!(
                (expected / counted - 1.0).abs() < room,
                "{}, {what}: {expected} expected, {counted} counted",
                one.name
            );
        }
    }
}

/// The library is the smallest build, and reading files is what brings a parser.
#[test]
fn each_part_of_the_workspace_brings_its_own_crates_and_the_library_few() {
    let rows = saving::recorded().unwrap().rows;
    let of = |row: &str, what: &str| value(&rows, "compiled", row, what).unwrap();
    // Its two dependencies and theirs: 15, and libm for the roots and products that round alike everywhere.
    assert!(of("the library", CRATES) <= 16.0);
    assert!(of("scenes", MORE) <= 1.0 + f64::EPSILON);
    assert!(of("scenes from files", MORE) > of("scenes", MORE));
    assert!(of("the book", CRATES) > 5.0 * of("the library", CRATES));
    assert!(of("the peers (in no default build)", MORE) > 50.0);
}

#[test]
fn a_count_that_has_changed_is_told_and_other_tables_stay() {
    let old = saving::recorded().unwrap();
    assert!(differences(&old.rows, &old.rows).is_empty());
    let mut changed = old.rows.clone();
    let counted = changed.iter_mut().find(|row| row.row == GENERAL && row.what == STATE).unwrap();
    counted.value *= 1.5;
    let found = differences(&old.rows, &changed);
    assert_eq!(found.len(), 1);
    assert!(found[0].starts_with("three moments, instructions for a state: "), "{found:?}");
    let executed: Vec<_> = old.rows.iter().filter(|row| row.table == "executed").cloned().collect();
    let rows = old.rows.clone();
    assert_eq!(renewed(old, executed).rows, rows);
}
