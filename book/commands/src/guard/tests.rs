//! The guard on small chapters, and on the book itself.

use super::*;

/// What the guard objects to in a chapter with this text, a block with this code in its section, and
/// these facts and drawings.
fn offences_beside(text: &str, code: &str, beside: &Beside) -> Vec<String> {
    let text = if code.is_empty() { text.to_owned() } else { format!("{text}\n\n```rust\n{code}\n```\n") };
    let chapter = Reader::default().chapter("x", "x.md", &text).unwrap();
    holding::findings(&chapter, beside).offences.iter().map(ToString::to_string).collect()
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
    let nearest = "x.md:1: found `7.5°`, expected words that the section's code asserts or notes; nearest is `7.4°` in line 4";
    objects("The gap is 7.5°.", ANGLE, nearest);
    for wrong in ["7.40°", "17.4°", "-7.4°", "−7.4°", "7.4 s", "7.4", "7.4°C", "7.4°/s", "27.4°", "0.7.4°"]
    {
        objects(&format!("The gap is {wrong}. 7.4°."), ANGLE, "x.md:1: found `");
    }
    objects("The gap is 8 m.", "", "expected a Rust block in this section");
}

#[test]
fn what_is_asserted_must_be_said() {
    objects("The gap is small.", ANGLE, "x.md:4: found `7.4°`, asserted, expected the same");
    objects("Text.", "// 7.4°\nassert_eq!(format!(\"{x:.1}°\"), \"7.4°\");", "asserted");
    holds("No number, no need.", "assert_eq!(name.to_string(), \"flat\");");
    for said in ["it does not flip", "it never returns", "no ring closes", "the larger one wins"] {
        let denied = format!("assert_eq!(fate, \"{said}\");");
        holds(&format!("Spun so, {said}."), &denied);
        // Anywhere in the section, in a figure's words too.
        holds(&format!("7.4°\n\n![{said}](../../figures/box.svg)"), &format!("{denied}\n{ANGLE}"));
        let turned = said.replace("not ", "").replace("never ", "").replace("no ", "").replace("larger", "");
        objects(&turned, &denied, &format!("x.md:4: found `{said}`, asserted, expected the same"));
    }
}

#[test]
fn a_number_is_held_within_its_section_only() {
    let text = format!("# A\n\n7.4°\n\n```rust\n{ANGLE}\n```\n\n## B\n\nAgain 7.4°.\n");
    objects(&text, "", "x.md:11: found `7.4°`, expected a Rust block");
}

#[test]
fn an_input_is_held_by_the_note_of_its_line_and_the_note_by_the_literals() {
    let code = "let stick = Cylinder::new(0.01, 1.0)?.with_mass(0.2)?; // 0.2 kg; 1 m";
    holds("A stick of 0.2 kg, 1 m long.", code);
    for wrong in ["0.2 m", "0.20001 kg", "0.2 kg m²", "0.01 m", "20.2 kg", "0.2 kg/s", "0.2 kg²"] {
        objects(&format!("A stick of {wrong}."), code, "x.md:1: found `");
    }
    holds("Turned by 30°.", "let angle = 30_f64.to_radians(); // 30°");
    holds("A tangent of 3/23.", "assert!((gap.tan() - 3.0 / 23.0).abs() < 1e-16); // 3/23");
    for (line, note) in [
        ("let m = 0.2;", "0.3 kg"),
        ("let m = -0.2;", "0.2 kg"),
        ("let v = [1.0, 2.0, 3.0];", "(1, 3)"),
        ("let m = b - 0.2;", "-0.2 kg"),
        ("let x = f64::from(y);", "64 bits"),
    ] {
        objects("Text.", &format!("{line} // {note}"), "in a note, expected a literal of its line of code");
    }
    objects("It is 2 m.", "// 2 m\nlet m = 2.0;", "x.md:4: found `2 m`");
    holds("It grows.", "let rate = 1.0; // the box's growth, 1/s");
}

#[test]
fn minus_signs_of_both_kinds_are_one_and_none_is_another() {
    let code = "assert_eq!(format!(\"{:.3} kg m²\", x), \"-0.125 kg m²\");";
    holds("A product of −0.125 kg m².", code);
    holds("A product of -0.125 kg m².", code);
    objects("A product of 0.125 kg m².", code, "found `0.125 kg`");
    // After a letter or a digit it is a hyphen.
    let [chapter, text, source, certainty] =
        ["x", "Soyuz T-13", "flight records", "certain"].map(String::from);
    let facts = vec![facts::Fact { chapter, text, source, certainty }];
    let beside = Beside { facts, ..Beside::default() };
    assert_eq!(offences_beside("With Soyuz T-13 up.", "", &beside), [""; 0]);
    let gone = offences_beside("With Soyuz T-14 up.", "", &beside).join("\n");
    assert!(gone.contains("found `14 up`") && gone.contains("found no `Soyuz T-13`"), "{gone}");
}

#[test]
fn powers_of_ten_are_held_as_the_code_writes_them() {
    let code = "let slant = 1e-12; // 1e-12\nassert_eq!(format!(\"{:.0e} rad\", x), \"3e-13 rad\");";
    holds("off by $10^{-12}$, gap $3 \\times 10^{-13}$ rad", code);
    holds("off by 1e−12, gap 3e-13 rad", code);
    let wrong = "10^{-11} 20^{-12} 210^{-12} 2\\times10^{-12} 0\\times10^{-12} 1\\times11^{-12} 10^{12}";
    for text in wrong.split(' ') {
        assert!(!offences(&format!("${text}$, then 3e-13 rad"), code).is_empty(), "{text}");
    }
}

#[test]
fn phrases_hold_tuples_and_lists_whole_and_in_their_order() {
    let code = "let omega = Vector3::new(1.0, 1.0, 0.0); // (1, 1, 0)\nassert_eq!(p, \"(0.833, 1.083, 0)\");";
    holds("$\\boldsymbol{\\omega} = (1, 1, 0)$. It gives $(0.833,\\; 1.083,\\; 0)$", code);
    for wrong in ["(1, 0, 0)", "(1, 1, 1)", "(1, 1)", "(-1, 1, 0)", "(1, 1, 0, 0)"] {
        let text = format!("$\\boldsymbol{{\\omega}} = {wrong}$. It gives $(0.833, 1.083, 0)$");
        objects(&text, code, "x.md:1: found `");
    }
    objects("$(1.083, 0.833, 0)$", code, "found `1.083`");
    let two = "assert_eq!(a, \"0.833 and 1.083 kg m²\");";
    holds("They are 0.833 and\n1.083 kg m².", two);
    objects("They are 1.083 and 0.833 kg m².", two, "found `1.083 and`");
}

#[test]
fn numbers_of_formulas_are_values_where_they_say_one() {
    let code = "let [a, b] = [2.0, 1.0]; // a = 2, b = 1";
    holds("$a = 2$, $b = 1$", code);
    objects("$a = 1$, $b = 2$", code, "found `1`");
    objects("$c = 2$", code, "found `2`");
    objects("$2.5\\,\\omega$ and $7$", "", "found `2.5");
    objects("$7$", "", "found `7`");
    let text = "$I_1 = \\tfrac{1}{12} m (b^2 + c^2)$, $\\lambda^2 < 0$, $\\omega_{12}$ and $(I_{xx}\\cdot 1, 0\\cdot x)$";
    holds(text, "");
}

#[test]
fn a_row_of_a_table_is_held_whole() {
    let table = |row: &str| format!("| a | b |\n|---|---|\n{row}\n");
    let code = "assert_eq!(t, [\"| 15° | 47.0° |\", \"| 30° | 66.6° |\"]);";
    holds(&table("| 15° | 47.0° |\n| 30° | 66.6° |"), code);
    objects(&table("| 15° | 66.6° |\n| 30° | 47.0° |"), code, "found `| 15° | 66.6° |`");
    objects(&table("| 15° | 47.0° |"), code, "found `| 30° | 66.6° |`, asserted");
    objects(&table("| 16° | 47.0° |"), "let a = 1.5;", "found `16°`");
}

#[test]
fn percent_and_ranges_are_parts_of_phrases() {
    holds("From 59 % to 116 %.", "assert_eq!(e, [\"59 %\", \"116 %\"]);");
    objects("From 59 to 116 %.", "assert_eq!(e, [\"59 %\", \"116 %\"]);", "found `59 to`");
    holds("In 2–3 s.", "let [step, most] = [2.0, 3.0]; // 2–3 s");
    objects("In 2–4 s.", "let [step, most] = [2.0, 3.0]; // 2–3 s", "found `4 s`");
}

#[test]
fn names_code_links_units_and_indices_are_no_numbers() {
    let text = "See [Ash91](references.md#ash91), `x = 12`, [here](a12.md), E177, 1/(kg m²), 1/s, $I_1 \\le I_{23}$ and $x^2$.";
    holds(text, "");
}

#[test]
fn comments_are_read_like_prose_and_strings_are_no_comments() {
    objects("Text.", "// 3 of them\nlet a = 3.0;", "x.md:4: found `3 of`");
    holds("Text.", "let n = 2.0; // 2 of them\nlet s = \"// 5\";\n// And 2 of them.");
}

#[test]
fn headings_are_numbered_in_order() {
    holds("## 1. One\n\n## 2. Two\n", "");
    objects("## 1. One\n\n## 3. Two\n", "", "x.md:3: found the heading number 3, expected 2");
}

#[test]
fn a_number_word_is_held_by_a_phrase_or_listed() {
    let found = |text: &str, code: &str| {
        let beside = Beside { words: HashMap::from([("x".to_owned(), Vec::new())]), ..Beside::default() };
        offences_beside(text, code, &beside).join("\n")
    };
    for (text, code, other) in [
        ("Off by a twentieth.", "let omega = (middle + easy) / 20.0; // a twentieth", "tenth"),
        ("At ten radians a second.", "let omega = 10.0; // ten radians a second", "eleven radians"),
        ("At forty-five degrees.", "let degrees = 45.0; // forty-five degrees", "forty-six degrees"),
        ("It is twice as far.", "let far = 2.0 * near; // twice as far", "thrice as far"),
    ] {
        assert_eq!(found(text, code), "");
        let (_, note) = code.split_once("// ").unwrap();
        let wrong = found(&text.to_lowercase().replace(note, other), code);
        assert!(wrong.contains("x.md:1: found `"), "{other}: {wrong}");
        let without = found(text, code.split_once(" //").unwrap().0);
        assert!(without.contains("x.md:1: found `"), "{text}: {without}");
    }
    assert!(found("A twentieth.", "let omega = easy / 30.0; // a twentieth").contains("found `twentieth`"));
}

#[test]
fn words_that_count_stand_in_the_list_with_what_they_count_and_as_often() {
    let list = ["three axes", "two of", "third line", "half a", "first"].map(str::to_owned).to_vec();
    let beside = Beside { words: HashMap::from([("x".to_owned(), list)]), ..Beside::default() };
    let text = "Three axes, and two of\nthem in the third line. In a second, half a turn. First, `a`.";
    assert_eq!(offences_beside(text, "", &beside), [""; 0]);
    for (from, to, found) in [
        ("Three axes", "Four axes", "x.md:1: found `four axes`, expected digits"),
        ("Three axes", "The axes", "x.md:1: found no `three axes`"),
        ("third line", "second line", "x.md:2: found `second line`"),
        ("half a", "third of a", "x.md:2: found `third of`"),
        ("First, `a`", "First, three axes", "x.md:2: found `three axes`"),
    ] {
        let all = offences_beside(&text.replace(from, to), "", &beside).join("\n");
        assert!(all.contains(found), "{to}: {all}");
    }
}

#[test]
fn the_words_for_a_figure_say_what_the_drawing_says() {
    let drawings = HashMap::from([("box".into(), "A box, edges of 2 m, 1 m and 3 m; a gap of 7.4°.".into())]);
    let beside = Beside { drawings, ..Beside::default() };
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
    assert!(fault("```java\n```\n").starts_with("x.md:1: a block in `java`"));
    let unread = fault("Hm.\n\n```rust\nlet a = 1;\nlet = ;\n```\n");
    assert!(unread.starts_with("x.md:5: Rust that cannot be read"), "{unread}");
    assert!(fault("```rust,ignore\nlet a = 1;\n```\n").contains("marked `ignore`"));
}

#[test]
fn what_cannot_be_shown_or_read_is_told_with_its_file_and_line() {
    for broken in
        ["Text.\n\n$\\frac{1$\n", "$$\\nosuchcommand$$\n", "```\nx\n```\n", "```rust\nlet = ;\n```\n"]
    {
        let mut faults = preprocess::unreadable("a.md", broken);
        faults.extend(Reader::default().chapter("a", "a.md", broken).err());
        assert!(!faults.is_empty() && faults.iter().all(|fault| fault.starts_with("a.md:")), "{faults:?}");
    }
}

#[test]
fn every_number_of_the_book_is_held() {
    let report = check().unwrap();
    let all: Vec<String> = report.offences.iter().map(ToString::to_string).collect();
    assert_eq!(all, [""; 0]);
    assert!(report.held.len() > 1000, "{report}");
}

/// What the book claims of itself: a sample of the digits, signs and number words of each chapter, each
/// altered alone, and each noticed.
#[test]
fn an_altered_digit_sign_or_number_word_is_noticed_in_every_chapter() {
    let book = Book::read().unwrap();
    let mut reader = Reader::default();
    let mut made = 0;
    for chapter in &book.chapters {
        let places = holding::findings(chapter, &book.beside).places;
        for place in places.iter().step_by(1 + places.len() / 12) {
            let (before, own) = (&chapter.text[..place.start], &chapter.text[place.clone()]);
            let altered = format!("{before}{}{}", another(own), &chapter.text[place.end..]);
            let noticed = match reader.chapter(&chapter.name, &chapter.path, &altered) {
                Ok(altered) => !holding::findings(&altered, &book.beside).offences.is_empty(),
                Err(_) => true,
            };
            assert!(noticed, "{}:{}: `{own}`", chapter.path, chapter.line(place.start));
            made += 1;
        }
    }
    assert!(made > 500, "{made}");
}

/// Another number for these words: without the minus, with another first digit, or with another word.
fn another(own: &str) -> String {
    if let Some(positive) = own.strip_prefix(['-', '\u{2212}']) {
        return positive.to_owned();
    }
    if let Some(at) = own.find(|c: char| c.is_ascii_digit()) {
        let digit = (own.as_bytes()[at] - b'0' + 1) % 10;
        return format!("{}{digit}{}", &own[..at], &own[at + 1..]);
    }
    let lower = own.to_lowercase();
    let pairs = "one two, half third, third second, twice thrice, tenfold twofold, once twice, eleven twelve";
    let mut pairs = pairs.split(", ").filter_map(|pair| pair.split_once(' '));
    let known = pairs.find(|(word, _)| lower.contains(word));
    known.map_or_else(|| "eleven".to_owned(), |(word, other)| lower.replacen(word, other, 1))
}

#[test]
fn numbers_of_one_kind_cannot_trade_places() {
    let code = "assert_eq!(format!(\"{x:.0}°\"), \"45°\");\nassert_eq!(format!(\"{y:.1}°\"), \"52.4°\");";
    holds("The spin at 45°. The momentum at 52.4°.", code);
    objects("The spin at 52.4°. The momentum at 45°.", code, "found `52.4°`, expected it after `45°`");
    let counts = "assert_eq!((a, b), (63, 42)); // 63 multiplications; 42 additions";
    holds("It takes 63 multiplications, then 42 additions.", counts);
    objects("It takes 42 multiplications, then 63 additions.", counts, "found `42 multiplications`");
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
    let loose = "assert!((x - 3.0 / 23.0).abs() < 0.01);";
    objects("It is 3/23.", loose, "a tolerance of more than a thousandth");
    holds("It is 3/23.", "assert!((x - 3.0 / 23.0).abs() < 1e-3); // 3/23");
    objects("It is 7.4°.", "assert_eq!(format!(\"7.{x}°\"), \"7.4°\");", "digits in the pattern of a format");
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
    let mut book = Book::read().unwrap();
    book.chapters.retain(|chapter| chapter.name != "two-arrows");
    let offences = book.report().unwrap().offences;
    assert!(offences[0].to_string().contains("no `two-arrows`"), "{offences:?}");
    let named = Reader::default().chapter("references", "references.md", "Of 5 m.").unwrap();
    assert_eq!(holding::findings(&named, &Beside::default()).offences.len(), 1);
}
