//! The guard on small chapters, and on the book itself.

use super::*;

/// What the guard objects to in a chapter with this text, a block with this code in its section, and
/// these facts and drawings.
fn offences_beside(text: &str, code: &str, beside: &Beside) -> Vec<String> {
    let text = if code.is_empty() { text.to_owned() } else { format!("{text}\n\n```rust\n{code}\n```\n") };
    let chapter = Reader::default().chapter("x", "x.md", &text).unwrap();
    numbers::findings(&chapter, beside).offences.iter().map(ToString::to_string).collect()
}

fn offences(text: &str, code: &str) -> Vec<String> {
    offences_beside(text, code, &Beside::default())
}

#[track_caller]
fn holds(text: &str, code: &str) {
    assert_eq!(offences(text, code), [""; 0], "{text} / {code}");
}

#[track_caller]
fn objects(text: &str, code: &str, to: &str) {
    let all = offences(text, code).join("\n");
    assert!(all.contains(to), "{text} / {code}: {all}");
}

const ANGLE: &str = "assert_eq!(format!(\"{:.1}°\", x), \"7.4°\");";

#[test]
fn a_number_is_held_by_the_assertion_that_prints_it_and_by_no_other_digits_or_unit() {
    holds("The gap is 7.4°.", ANGLE);
    objects(
        "The gap is 7.5°.",
        ANGLE,
        "x.md:1: found `7.5°`, expected a value of the section's code; nearest is `7.4 °` in line 4",
    );
    objects("The gap is 7.40°.", ANGLE, "found `7.40°`");
    objects("The gap is 7.4 s.", ANGLE, "found `7.4 s`");
    objects("The gap is 7.4.", ANGLE, "found `7.4`");
    objects("The gap is 8 m.", "", "expected a Rust block in this section");
}

#[test]
fn what_is_asserted_as_printed_must_be_said() {
    objects("The gap is small.", ANGLE, "x.md:4: found `7.4`, asserted as printed");
}

#[test]
fn a_number_is_held_within_its_section_only() {
    let text = format!("# A\n\n7.4°\n\n```rust\n{ANGLE}\n```\n\n## B\n\nAgain 7.4°.\n");
    objects(&text, "", "x.md:11: found `7.4°`, expected a Rust block");
}

#[test]
fn an_input_is_held_exactly_and_with_the_unit_its_function_takes() {
    let code = "let stick = Cylinder::new(0.01, 1.0)?.with_mass(0.2)?;";
    holds("A stick of 0.2 kg, 1 m long.", code);
    objects("A stick of 0.2 m.", code, "found `0.2 m`");
    objects("A stick of 0.20001 kg.", code, "found `0.20001 kg`");
    holds("Turned by 30°.", "let angle = 30_f64.to_radians();");
    holds("After 2.05 s.", "let end = engine.run(&start, 0.001, 2050)?;");
    objects("After 2.06 s.", "let end = engine.run(&start, 0.001, 2050)?;", "found `2.06 s`");
}

#[test]
fn minus_signs_of_both_kinds_are_one_and_none_is_another() {
    let code = "assert_eq!(format!(\"{:.3} kg m²\", x), \"-0.125 kg m²\");";
    holds("A product of −0.125 kg m².", code);
    holds("A product of -0.125 kg m².", code);
    objects("A product of 0.125 kg m².", code, "found `0.125 kg m²`");
    // After a letter or a digit it is a hyphen.
    let facts = vec![facts::Fact {
        chapter: "x".into(),
        text: "Soyuz T-13".into(),
        number: "13".into(),
        source: "flight records".into(),
        certainty: "certain".into(),
    }];
    let beside = Beside { facts, drawings: Drawings::new() };
    assert_eq!(offences_beside("With Soyuz T-13 up.", "", &beside), [""; 0]);
    let gone = offences_beside("With Soyuz T-14 up.", "", &beside).join("\n");
    assert!(gone.contains("found `14`") && gone.contains("found no `Soyuz T-13`"), "{gone}");
}

#[test]
fn powers_of_ten_are_held_by_their_value() {
    let code = "let slant = 1e-12;\nassert_eq!(format!(\"{:.4e}\", x), \"3.0000e-13\");";
    for text in [
        "off by $10^{-12}$, gap $3 \\times 10^{-13}$",
        "off by 1e-12, gap 3 × 10⁻¹³",
        "off by 1e−12, gap 3.0000e-13",
    ] {
        holds(text, code);
    }
    for text in [
        "$10^{-11}$",
        "$20^{-12}$",
        "$2 \\times 10^{-12}$",
        "$0 \\times 10^{-12}$",
        "$1 \\times 11^{-12}$",
        "10⁻¹³",
    ] {
        assert!(offences(&format!("{text}, then 3.0000e-13"), code).len() == 1, "{text}");
    }
}

#[test]
fn fractions_are_held_as_they_are_written() {
    let code = "assert!((gap.tan() - 3.0 / 23.0).abs() < 1e-16);";
    holds("Its tangent is 3/23.", code);
    objects("Its tangent is 3/13.", code, "found `3/13`");
    objects("Its tangent is 6/46.", code, "found `6/46`");
}

#[test]
fn tuples_and_lists_are_held_whole_and_in_their_order() {
    let code = "let omega = Vector3::new(1.0, 1.0, 0.0);\nassert_eq!(p, \"(0.833, 1.083, 0)\");";
    holds("$\\boldsymbol{\\omega} = (1, 1, 0)$ gives $(0.833,\\; 1.083,\\; 0)$", code);
    objects(
        "$\\boldsymbol{\\omega} = (1, 0, 0)$ gives $(0.833, 1.083, 0)$",
        code,
        "expected `(1, 1, 0)`, as in line 4",
    );
    objects("$(1.083, 0.833, 0)$", code, "found `(1.083, 0.833, 0)`");
    let two = "assert_eq!(a, \"0.833 kg m²\");\nassert_eq!(b, \"1.083 kg m²\");";
    holds("They are 0.833 and 1.083 kg m².", two);
    objects(
        "They are 1.083 and 0.833 kg m².",
        two,
        "found `1.083 and 0.833 kg m²`, expected these, one after the other",
    );
}

#[test]
fn a_formula_symbol_equals_number_is_held_by_the_let_of_that_name() {
    let code = "let [a, b] = [2.0, 1.0];\nlet m = 3.0;";
    holds("$a = 2$, $b = 1$, $m = 3$", code);
    objects("$a = 1$", code, "found `1`, expected `2`, as in line 4");
    objects("$c = 1$", code, "a `let c = ...`");
}

#[test]
fn a_row_of_a_table_is_held_whole() {
    let table = |row: &str| format!("| a | b |\n|---|---|\n{row}\n");
    let code = "assert_eq!(t, [\"| 15° | 47.0° |\", \"| 30° | 66.6° |\"]);";
    holds(&table("| 15° | 47.0° |\n| 30° | 66.6° |"), code);
    objects(&table("| 15° | 66.6° |\n| 30° | 47.0° |"), code, "found the row `| 15° | 66.6° |`");
    objects(&table("| 15° | 47.0° |"), code, "found `| 30° | 66.6° |`, asserted as printed");
    objects(&table("| 16° | 47.0° |"), "let a = 1.5;", "found `16°`");
}

#[test]
fn groups_of_digits_ranges_and_percent_are_read() {
    holds("After 20\u{2009}000 steps.", "let n = 20_000;");
    objects("After 20\u{2009}001 steps.", "let n = 20_000;", "20\u{2009}001");
    holds("From 59 % to 116 %.", "assert_eq!(e, [\"59 %\", \"116 %\"]);");
    holds("In 2–3 s.", "let step = 2.0;\nlet seconds = 3.0;");
    objects("In 2–4 s.", "let step = 2.0;\nlet seconds = 3.0;", "found `2–4 s`");
}

#[test]
fn names_code_links_units_and_indices_are_no_numbers() {
    holds(
        "See [Ash91](references.md#ash91), `x = 12`, [here](a12.md), E177, 1/(kg m²), 1/s, $I_1 \\le I_{23}$ and $x^2$.",
        "",
    );
}

#[test]
fn comments_are_read_like_prose_and_strings_are_no_comments() {
    objects("Text.", "let a = 2.0; // 3 of them", "x.md:4: found `3`");
    holds("Text.", "let n = 2.0; // 2 of them\nlet s = \"// 5\";");
}

#[test]
fn headings_are_numbered_in_order() {
    holds("## 1. One\n\n## 2. Two\n", "");
    objects("## 1. One\n\n## 3. Two\n", "", "x.md:3: found the heading number 3, expected 2");
}

#[test]
fn quantities_in_words_are_held_and_counting_is_free() {
    holds("Three axes, two spins, a half turn.", "let a = 1.5;");
    holds("Off by a twentieth.", "let omega = (middle + easy) / 20.0;");
    objects("Off by a tenth.", "let omega = (middle + easy) / 20.0;", "found `tenth`");
    holds("At ten radians a second.", "let omega = 10.0;");
    objects("At eleven radians a second.", "let omega = 10.0;", "found `eleven`");
    holds("The moments are as one to four.", "assert_eq!(b, 4.0 * a);");
    objects("The moments are as one to five.", "assert_eq!(b, 4.0 * a);", "found `one to five`");
    objects("It is twice the energy.", "let a = 3.0;", "found `twice`");
    holds("At forty-five degrees.", "let degrees = 45.0;");
    for wrong in ["fifty degrees", "thirty-two seconds", "two metres", "three kilograms", "ninety per cent"] {
        objects(&format!("It is {wrong}."), "let a = 45.0;", "found `");
    }
}

#[test]
fn the_words_for_a_figure_say_what_the_drawing_says() {
    let mut drawings = Drawings::new();
    drawings.insert("box".into(), Drawing::new("A box, edges of 2 m, 1 m and 3 m; a gap of 7.4°."));
    let beside = Beside { facts: Vec::new(), drawings };
    let figure = |alt: &str, caption: &str| format!("![{alt}](../../figures/box.svg)\n\n*{caption}*\n");
    let wrong = |alt: &str, caption: &str| offences_beside(&figure(alt, caption), "", &beside).join("\n");
    assert_eq!(wrong("The gap is 7.4°.", "A gap of 7.4°."), "");
    assert!(wrong("The gap is 7.5°.", "").contains("in the words for a figure"));
    assert!(wrong("First 7.4°, then 1 m.", "").contains("found `1 m`"), "order");
    assert!(wrong("A box.", "A gap of 7.5°.").contains("x.md:3: found `7.5°`"));
}

#[test]
fn what_cannot_be_read_is_a_fault_with_file_and_line() {
    let fault = |text: &str| Reader::default().chapter("x", "x.md", text).unwrap_err();
    assert!(fault("Hm.\n\n```\nlet a = 1;\n```\n").starts_with("x.md:3: code of no language"));
    assert!(fault("Hm.\n\n    let a = 1;\n").contains("code of no language"));
    assert!(fault("```java\n```\n").starts_with("x.md:1: a block in `java`"));
    assert!(
        fault("Hm.\n\n```rust\nlet a = 1;\nlet = ;\n```\n").starts_with("x.md:5: Rust that cannot be read")
    );
    assert!(fault("```rust,ignore\nlet a = 1;\n```\n").contains("marked `ignore`"));
}

/// A folder with these files.
fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

#[test]
fn a_folder_that_is_no_book_is_bad_input() {
    assert!(check(Path::new("/no/such/folder")).unwrap_err().contains("there is no folder"));
    assert!(check(folder(&[]).path()).unwrap_err().contains("SUMMARY.md"));
    assert!(check(folder(&[("SUMMARY.md", "nothing")]).path()).unwrap_err().contains("lists no chapter"));
    let summary = ("SUMMARY.md", "- [A](a.md)\n");
    assert!(check(folder(&[summary]).path()).unwrap_err().contains("a.md"));
    for broken in
        ["Text.\n\n$\\frac{1$\n", "$$\\nosuchcommand$$\n", "```\nx\n```\n", "```rust\nlet = ;\n```\n"]
    {
        let folder = folder(&[summary, ("a.md", broken)]);
        let wrong = check(folder.path()).unwrap_err();
        assert!(wrong.contains("a.md:"), "{broken}: {wrong}");
        assert!(!wrong.contains("book/chapters"), "{wrong}");
    }
    let folder = folder(&[summary, ("a.md", "No more than 5 m.\n")]);
    assert_eq!(check(folder.path()).unwrap().offences.len(), 1);
}

#[test]
fn every_number_of_the_book_is_held() {
    let report = check(&paths::chapters()).unwrap();
    let all: Vec<String> = report.offences.iter().map(ToString::to_string).collect();
    assert_eq!(all, [""; 0]);
    let c = &report.counts;
    assert_eq!(c.all(), c.by_assertion + c.by_input + c.by_fact + c.by_drawing);
    assert!(c.all() > 100, "{report}");
}

#[test]
fn every_digit_of_the_book_altered_is_noticed() {
    let tallies = alterations(&paths::chapters()).unwrap();
    for tally in &tallies {
        assert_eq!(tally.text.killed, tally.text.made, "{}", tally.survivors.join("\n"));
    }
    assert!(tallies.iter().map(|t| t.text.made).sum::<usize>() > 1000);
}

#[test]
fn numbers_of_one_kind_cannot_trade_places() {
    let code = "assert_eq!(format!(\"{x:.0}°\"), \"45°\");\nassert_eq!(format!(\"{y:.1}°\"), \"52.4°\");";
    holds("The spin at 45°. The momentum at 52.4°.", code);
    objects("The spin at 52.4°. The momentum at 45°.", code, "found `52.4`, expected it after `45`");
    let counts = "assert_eq!((a, b), (63, 42));";
    holds("It takes 63 multiplications, then 42 additions.", counts);
    objects("It takes 42 multiplications, then 63 additions.", counts, "expected it after `63`");
    let table = "| a | b |\n|---|---|\n| 30° | 66.6° |\n| 15° | 47.0° |\n";
    let rows = "assert_eq!(t, [\"| 15° | 47.0° |\", \"| 30° | 66.6° |\"]);";
    objects(table, rows, "expected it after `| 15° | 47.0° |`");
    objects("Text.", "// 45° and 52.4°\nassert_eq!(format!(\"{x:.0}°\"), \"45°\");", "asserted as printed");
}

#[test]
fn a_unit_that_the_code_does_not_print_is_an_offence() {
    let bare = "assert_eq!(format!(\"{:.3}\", x), \"0.833\");";
    for unit in ["kg m²", "kg m³", "m³", "kg", "N", "cm", "°", "per second"] {
        objects(&format!("It is 0.833 {unit}."), bare, "found `0.833");
    }
    let code = "assert_eq!(format!(\"{:.3} kg m²\", x), \"0.833 kg m²\");";
    holds("It is 0.833 kg m².", code);
    for wrong in ["", " kg", " kg m", " kg m³", " kg m²/s", " kg m²/m", " kg m⁴"] {
        assert!(!offences(&format!("It is 0.833{wrong}."), code).is_empty(), "{wrong}");
    }
}

#[test]
fn an_assertion_that_cannot_fail_is_an_offence() {
    for hollow in [
        "assert_eq!(\"7.4°\", \"7.4°\");",
        "assert_eq!(format!(\"{:.1}°\", 7.4), \"7.4°\");",
        "assert_eq!(\"7.4°\".to_string(), \"7.4°\");",
    ] {
        objects("It is 7.4°.", hollow, "a literal about a literal");
    }
    objects("It is 7.4°.", &format!("if wide {{ {ANGLE} }}"), "inside a branch");
    objects(
        "It is 3/23.",
        "assert!((x - 3.0 / 23.0).abs() < 0.01);",
        "a tolerance of more than a thousandth",
    );
    holds("It is 3/23.", "assert!((x - 3.0 / 23.0).abs() < 1e-3);");
}

#[test]
fn deep_nesting_html_and_titles_with_numbers_are_refused() {
    let fault = |text: &str| Reader::default().chapter("x", "x.md", text).unwrap_err();
    let deep = format!("```rust\nlet a = {}1{};\n```\n", "(".repeat(20_000), ")".repeat(20_000));
    assert!(fault(&deep).starts_with("x.md:2: Rust nested"));
    assert!(fault(&format!("```rust\nlet a = {}1;\n```\n", "- ".repeat(20_000))).contains("Rust nested"));
    assert!(fault("Hm.\n\n<p>7.5 m</p>\n").starts_with("x.md:3: HTML"));
    assert!(fault("See <b title='7'>it</b>.\n").contains("HTML"));
    assert!(fault("See [it](a.md \"7.5 m\").\n").contains("a title"));
}

#[test]
fn a_chapter_with_laws_that_the_summary_drops_is_an_offence() {
    let folder = folder(&[("SUMMARY.md", "- [A](a.md)\n"), ("a.md", "Hm.\n"), ("two-arrows.md", "Hm.\n")]);
    let offences = check(folder.path()).unwrap().offences;
    assert!(offences[0].to_string().contains("no `two-arrows`"), "{offences:?}");
    let named = Reader::default().chapter("references", "references.md", "Of 5 m.").unwrap();
    assert_eq!(numbers::findings(&named, &Beside::default()).offences.len(), 1);
}
