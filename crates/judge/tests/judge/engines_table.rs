//! The table of engines: each line is what its records show, and names the rule of the catalogue.

use std::path::PathBuf;
use tumbling::attitude::rotation_matrix;
use tumbling::exact::FreeMotion;
use tumbling_engines::{PHYSICS_ENGINES, Recorded, RecordedRow, table};
use tumbling_judge::{Confidence, Options, Rule, judge};

/// An engine's record of a story, from this folder or the one of the table.
fn text(engine: &str, story: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../engines/data");
    let name = format!("{engine}--{story}.csv");
    let read = |folder: PathBuf| std::fs::read_to_string(folder.join(&name));
    read(folder.join("table")).or_else(|_| read(folder)).unwrap_or_else(|why| panic!("{name}: {why}"))
}

/// The first step recorded that breaks a law by more than 1 in 100, or at which the first flip is missing.
fn first_broken(text: &str) -> Option<usize> {
    let text: &'static str = text.to_owned().leak();
    let run = Recorded { engine: "", story: "", text }.read().unwrap();
    let of = |row: &RecordedRow| {
        let momentum = run.moments.component_mul(&row.omega);
        (row.omega.dot(&momentum), rotation_matrix(&row.attitude) * momentum)
    };
    let (energy, momentum) = of(&run.rows[0]);
    let broken = run.rows.iter().find(|row| {
        let (e, l) = of(row);
        (e / energy - 1.0).abs() > 0.01 || (l - momentum).norm() > 0.01 * momentum.norm()
    });
    // The box has its middle axis along x.
    let motion = FreeMotion::new(run.moments.try_into().unwrap(), &run.rows[0].omega).unwrap();
    let flips = run.moments.y > run.moments.x && run.moments.x > run.moments.z;
    let never = flips && run.rows.iter().all(|row| row.omega.x > 0.0);
    let missed = never.then(|| (motion.next_flip(0.0).unwrap().unwrap() * 60.0).ceil() as usize);
    broken.map(|row| row.step).into_iter().chain(missed).min()
}

#[test]
fn the_table_says_what_the_records_show_and_what_the_judge_names() {
    let mut made = String::from("record\tengine\trule\tbox\tlargest\n");
    for line in table() {
        let texts = ["box-middle", "major"].map(|story| text(line.record, story));
        let diagnosis = judge(texts[0].as_bytes(), &Options::default()).unwrap().diagnosis.unwrap();
        // In single precision the spin's error may be rounding, where that of the attitude is a rule's own.
        let fits = matches!(diagnosis.confidence, Confidence::ToRounding | Confidence::SmallErrors);
        let named = fits && diagnosis.best.rule != Rule::EXACT;
        let rule = if named { diagnosis.best.rule.name() } else { "none known".into() };
        let [flips, largest] =
            texts.map(|text| first_broken(&text).map_or("-".into(), |step| step.to_string()));
        made += &format!("{}\t{}\t{rule}\t{flips}\t{largest}\n", line.record, line.name);
        // The catalogue's rule of the engine, as far as a free body shows it.
        for engine in PHYSICS_ENGINES.iter().filter(|engine| engine.record == Some(line.record)) {
            let all = std::iter::once(&diagnosis.best.rule).chain(&diagnosis.alike);
            let names = all.flat_map(Rule::engines).collect::<String>();
            assert!(names.contains(engine.name) && names.contains(engine.setting), "{engine:?}: {names}");
        }
    }
    let committed = include_str!("../../../engines/data/table.tsv");
    assert!(made == committed, "crates/engines/data/table.tsv should be:\n{made}");
    let mut records = PHYSICS_ENGINES.iter().filter_map(|engine| engine.record);
    assert!(records.all(|record| table().any(|line| line.record == record)));
}
