//! The modules of `src/` use each other as DESIGN.md states, and in no other way.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

type Arrows = BTreeMap<String, BTreeSet<String>>;

fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// The lines `module -> module module ...` of DESIGN.md.
fn drawn() -> Arrows {
    let design = fs::read_to_string(root().join("DESIGN.md")).unwrap();
    let arrow = |line: &str| {
        let (from, to) = line.strip_prefix("    ")?.split_once("->")?;
        let single = !from.trim().contains(char::is_whitespace);
        single.then(|| (from.trim().to_owned(), to.split_whitespace().map(str::to_owned).collect()))
    };
    design.lines().filter_map(arrow).collect()
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with("target") {
            sources(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
}

/// Every module that a text names after `crate::`, alone or in a group. Comments and unit tests do not count.
fn named(text: &str) -> BTreeSet<String> {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let code =
        text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n");
    let word = |text: &str| -> String {
        text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
    };
    let mut modules = BTreeSet::new();
    for rest in code.split("crate::").skip(1) {
        let Some(group) = rest.strip_prefix('{') else {
            modules.insert(word(rest));
            continue;
        };
        let mut depth = 1;
        modules.insert(word(group));
        for (at, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 1 => {
                    modules.insert(word(&group[at + 1..]));
                }
                _ => {}
            }
            if depth == 0 {
                break;
            }
        }
    }
    modules.remove("");
    modules
}

/// The modules that each module uses in the sources.
fn built() -> Arrows {
    let src = root().join("src");
    let mut files = Vec::new();
    sources(&src, &mut files);
    let mut arrows = Arrows::new();
    for file in files.into_iter().filter(|file| !file.ends_with("tests.rs")) {
        let inside = file.strip_prefix(&src).unwrap();
        let module = inside.iter().next().unwrap().to_str().unwrap().trim_end_matches(".rs").to_owned();
        if matches!(module.as_str(), "lib" | "references") {
            continue;
        }
        let mut used = named(&fs::read_to_string(&file).unwrap());
        used.remove(&module);
        arrows.entry(module).or_default().extend(used);
    }
    arrows
}

#[test]
fn the_modules_of_the_library_use_each_other_as_the_design_draws_it() {
    assert_eq!(built(), drawn());
}

#[test]
fn no_arrow_runs_back_and_the_exact_motion_and_the_steppers_do_not_know_each_other() {
    let arrows = drawn();
    let order: Vec<&String> = {
        // A module follows in the order once all modules that it uses are there.
        let mut standing: Vec<&String> = Vec::new();
        while standing.len() < arrows.len() {
            let next = arrows.iter().find(|(module, used)| {
                !standing.contains(module) && used.iter().all(|other| standing.contains(&other))
            });
            let Some((module, _)) = next else { panic!("a circle among {arrows:?} beyond {standing:?}") };
            standing.push(module);
        }
        standing
    };
    assert!(order.len() > 5);
    assert!(!arrows["exact"].contains("step") && !arrows["step"].contains("exact"));
}

/// The formulas that a text cites by this letter, as `(C7)` or `(C7, C9)`.
fn formulas(letter: char, text: &str) -> BTreeSet<u32> {
    let groups = text.split('(').skip(1).filter_map(|rest| Some(rest.split_once(')')?.0));
    let parts = groups.flat_map(|group| group.split([',', ' ']));
    parts.filter_map(|part| part.strip_prefix(letter)?.parse().ok()).collect()
}

/// The formulas that a chapter numbers, each once: `**(C7)**`.
fn numbered(letter: char, chapter: &str) -> Vec<u32> {
    let parts = chapter.split("**(").skip(1).filter_map(|rest| rest.split_once(")**"));
    parts.filter_map(|(number, _)| number.strip_prefix(letter)?.parse().ok()).collect()
}

/// Checks that the code cites each formula that the chapter numbers, more than `least` of them, and no other.
fn cites(letter: char, files: &[PathBuf], chapter: &str, least: usize) {
    let text = |file: &PathBuf| fs::read_to_string(file).unwrap();
    let cited: BTreeSet<u32> = files.iter().flat_map(|file| formulas(letter, &text(file))).collect();
    let chapter = text(&root().join("book/chapters").join(chapter));
    let all = numbered(letter, &chapter);
    assert!(all.len() > least && all.iter().copied().eq(1..=all.len() as u32), "{all:?}");
    assert_eq!(cited, all.iter().copied().collect());
    // And the chapter itself cites no formula that it does not have.
    assert!(formulas(letter, &chapter).is_subset(&cited));
}

#[test]
fn the_closed_forms_cite_each_formula_of_their_chapters_and_no_other() {
    let [mut free, mut top] = [vec![root().join("src/dynamics/invariants.rs")], Vec::new()];
    sources(&root().join("src/exact"), &mut free);
    cites('C', &free, "closed-form.md", 40);
    sources(&root().join("src/exact/top"), &mut top);
    cites('T', &top, "top-closed-form.md", 20);
    // One changed number, on either side, is noticed.
    assert_ne!(formulas('C', "(C6) and (C8)"), formulas('C', "(C6) and (C7)"));
    assert_eq!(numbered('C', "**(C2)** by (C1)"), [2]);
}

/// Constants chosen from measured errors, which the tests of the motion and of its derivatives bound, or from
/// the range of `f64`. All other named constants of the closed form are recomputed in a test.
const CHOSEN: [&str; 15] = [
    "COUNTABLE",
    "FAR",
    "LAST",
    "LAST_APART",
    "NEAR_RETURN",
    "NEEDLE",
    "NOBODY",
    "NOME_RATIO",
    "ONE_PRODUCT",
    "REST",
    "ROOM_TO_TURN",
    "SHORT",
    "SLOW",
    "SMALL_MODULUS",
    "SPAN",
];

#[test]
fn every_named_number_of_the_closed_form_is_recomputed_in_a_test() {
    let mut files = Vec::new();
    sources(&root().join("src/exact"), &mut files);
    let texts: Vec<String> = files.iter().map(|file| fs::read_to_string(file).unwrap()).collect();
    let parts =
        texts.iter().zip(&files).map(|(text, file)| match text.split_once("#[cfg(test)]\nmod tests {") {
            _ if file.ends_with("tests.rs") => ("", text.as_str()),
            Some(parts) => parts,
            None => (text.as_str(), ""),
        });
    let (code, tests): (Vec<&str>, Vec<&str>) = parts.unzip();
    let name = |line: &str| {
        let line = line.trim_start().trim_start_matches("pub(crate) ").trim_start_matches("pub(super) ");
        let (name, kind) = line.strip_prefix("const ")?.split_once(": ")?;
        let number = ["f64", "i32", "usize", "["].iter().any(|own| kind.starts_with(own));
        (number && !name.contains(' ')).then(|| name.to_owned())
    };
    let names: BTreeSet<String> = code.iter().flat_map(|text| text.lines().filter_map(name)).collect();
    let missing: Vec<_> = names
        .iter()
        .filter(|name| !CHOSEN.contains(&name.as_str()))
        .filter(|name| !tests.iter().any(|text| text.contains(name.as_str())))
        .collect();
    assert!(names.len() > 20 && CHOSEN.iter().all(|name| names.contains(*name)), "{names:?}");
    assert_eq!(missing, [""; 0]);
}

/// A file that no `mod` names is never compiled, and its tests never run.
#[test]
fn every_file_is_a_module_or_a_program_of_its_own() {
    let mut paths = Vec::new();
    for folder in ["src", "tests", "crates"] {
        sources(&root().join(folder), &mut paths);
    }
    let text: String = paths.iter().map(|path| fs::read_to_string(path).unwrap()).collect();
    let modules: BTreeSet<&str> = text
        .lines()
        .filter_map(|line| {
            line.trim_start().trim_start_matches("pub ").split_once("mod ")?.1.split(';').next()
        })
        .collect();
    for path in paths {
        let stem = path.file_stem().unwrap().to_str().unwrap();
        let folder = path.parent().unwrap().file_name().unwrap().to_str().unwrap();
        let alone = ["tests", "examples", "benches", "bin"].contains(&folder);
        let known = ["lib", "main", "mod", "build"].contains(&stem) || modules.contains(stem);
        assert!(alone || known, "{}", path.display());
    }
}
