//! Regression test: the committed atlas is what the methods do. That they are right, `tests/step` shows.

use tumbling_measure::atlas::{DRIVEN, Fate, Place, Precision, atlas, recorded, written};

fn places() -> Vec<Place> {
    atlas().unwrap()
}

fn fates<'a>(
    places: &'a [Place],
    chart: &'a str,
    runner: &'a str,
    precision: Precision,
) -> Vec<(&'a str, Fate)> {
    let here = |p: &&Place| p.chart == chart && p.runner == runner && p.precision == precision;
    places.iter().filter(here).map(|p| (p.case.as_str(), p.fate)).collect()
}

#[test]
fn the_committed_atlas_is_what_the_methods_do() {
    let places = places();
    let (now, then) = (written(&places), include_str!("../record/atlas.tsv"));
    let changed: Vec<_> = now.lines().zip(then.lines()).filter(|(a, b)| a != b).take(10).collect();
    assert!(
        now == then,
        "renew it with `cargo run --release -- atlas` and look at what changed: {changed:#?}"
    );

    // The figures take its rows.
    let rows = recorded().unwrap();
    assert_eq!(rows.len(), places.len());
    for (row, place) in rows.iter().zip(&places) {
        assert_eq!((row.chart, row.runner, row.precision), (place.chart, place.runner, place.precision));
        assert_eq!((row.case, row.fate), (place.case.as_str(), place.fate));
    }

    // Under torques the run within a tolerance is right, or refuses, in either precision.
    let adaptive = |p: &&Place| DRIVEN.contains(&p.chart) && p.runner == "adaptive";
    for place in places.iter().filter(adaptive) {
        assert!(matches!(place.fate, Fate::Right | Fate::Refused), "{place:?}");
    }

    // What does not hang on where a bound was drawn.
    assert!(places.iter().filter(|p| p.runner == "exact motion").all(|p| p.fate == Fate::Right));
    for precision in [Precision::Double, Precision::Single] {
        // Without the gyroscopic term nothing flips, however short the step.
        let never = fates(&places, "flipping", "no gyroscopic term", precision);
        assert!(never.iter().all(|(_, fate)| *fate == Fate::WrongFlips), "{never:?}");
        // Euler's method heats a steady spin at every step.
        let heated = fates(&places, "steady spin", "explicit Euler", precision);
        assert!(heated.iter().all(|(_, fate)| *fate == Fate::Gained), "{heated:?}");
        // Explicit methods reverse or blow up where damping is stiff; kicks by its own law do not.
        for (runner, survives) in
            [("explicit Euler", false), ("Runge-Kutta 4", false), ("Buss's augmented", true)]
        {
            let stiff = fates(&places, "damping", runner, precision);
            let (case, fate) = stiff.last().unwrap();
            assert_eq!(*case, "1000000");
            assert_eq!(*fate == Fate::Right, survives, "{runner}: {stiff:?}");
        }
    }
}
