use super::pages::Paper;
use super::{epub, handout, problems, sheet, tree};
use crate::paper::sheet::Size;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

static PAPER: LazyLock<Paper> = LazyLock::new(|| Paper::read().unwrap());

/// The files of the publication that are XML, as text.
fn documents() -> BTreeMap<String, String> {
    let entries = epub::entries(&PAPER).unwrap().into_iter();
    let texts = entries.filter(|entry| entry.name.ends_with("html") || entry.name.ends_with("svg"));
    texts.map(|entry| (entry.name, String::from_utf8(entry.content).unwrap())).collect()
}

#[test]
fn every_page_of_the_epub_is_well_formed_and_its_links_lead_somewhere() {
    let texts = documents();
    let mut ids: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    let mut links = Vec::new();
    let files: BTreeSet<_> = epub::entries(&PAPER).unwrap().into_iter().map(|entry| entry.name).collect();
    for (name, text) in &texts {
        let read = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
        let document = roxmltree::Document::parse_with_options(text, read);
        let document = document.unwrap_or_else(|e| panic!("{name}: {e}"));
        for node in document.descendants() {
            if let Some(id) = node.attribute("id") {
                assert!(ids.entry(name).or_default().insert(id.to_owned()), "{name} has {id} twice");
            }
            links.extend(node.attribute("href").map(|target| (name, target.to_owned())));
            if let Some(picture) = node.attribute("src") {
                assert!(files.contains(picture), "{name}: {picture}");
            }
        }
        for unwanted in ["var(", "currentColor", "{{#", "<script", "JavaScript"] {
            assert!(!text.contains(unwanted), "{name} has {unwanted}");
        }
    }
    let mut inside = 0;
    for (from, target) in links.iter().filter(|(_, target)| !target.starts_with("http")) {
        let (file, place) = target.split_once('#').unwrap_or((target, ""));
        let file = if file.is_empty() { from.as_str() } else { file };
        assert!(file == "style.css" || texts.contains_key(file), "{from}: {target}");
        assert!(place.is_empty() || ids[file].contains(place), "{from}: {target}");
        inside += 1;
    }
    assert!(inside > 500, "{inside} links");
}

#[test]
fn every_figure_formula_question_and_exercise_of_the_book_is_on_paper() {
    let texts = documents();
    for figure in tumbling_figures::registry() {
        let page = &texts[&format!("{}.xhtml", figure.chapter)];
        assert!(page.contains(&format!("id=\"fig-{}\"", figure.name)), "{}", figure.name);
        assert!(page.contains(&format!("id=\"{}-desc\"", figure.name)), "{}", figure.name);
    }
    for exercise in tumbling_exercises::all().unwrap() {
        let (chapter, _) = exercise.place();
        let place = format!("{chapter}-{}", exercise.name);
        assert!(texts["solutions.xhtml"].contains(&format!("<h3 id=\"{place}\">")), "{place}");
        assert!(texts[&format!("{chapter}.xhtml")].contains(&format!("solutions.xhtml#{place}")), "{place}");
    }
    let all = texts.values().map(String::as_str).collect::<String>();
    let asked = all.matches("class=\"question\"").count();
    assert!(asked >= 25 && all.matches("-answer\" class=\"asked\"").count() == asked, "{asked}");
    assert_eq!(all.matches("<math ").count(), all.matches("alttext=").count());
    assert!(all.contains("alttext=\"sin(gap) = (b − a)/(b + a).\""), "a formula in words");
}

#[test]
fn the_manifest_lists_every_file_once_and_says_what_is_in_it() {
    let entries = epub::entries(&PAPER).unwrap();
    let names: BTreeSet<&str> = entries.iter().map(|entry| entry.name.as_str()).collect();
    assert_eq!(names.len(), entries.len());
    let file = epub::file(&PAPER).unwrap();
    assert_eq!(&file[30..58], b"mimetypeapplication/epub+zip", "the first file, stored as it is");
    let mut zip = zip::ZipArchive::new(std::io::Cursor::new(file)).unwrap();
    assert_eq!(zip.len(), entries.len() + 3);
    let package = std::io::read_to_string(zip.by_name("EPUB/package.opf").unwrap()).unwrap();
    let package = roxmltree::Document::parse(&package).unwrap();
    let items: Vec<_> = package
        .descendants()
        .filter(|node| node.has_tag_name(("http://www.idpf.org/2007/opf", "item")))
        .collect();
    assert_eq!(items.len(), entries.len());
    for item in items {
        let name = item.attribute("href").unwrap();
        let entry = entries.iter().find(|entry| entry.name == name).unwrap();
        if name.ends_with(".xhtml") {
            let text = std::str::from_utf8(&entry.content).unwrap();
            let said = item.attribute("properties").unwrap_or_default();
            for (property, element) in [("mathml", "<math "), ("svg", "<svg ")] {
                assert_eq!(said.contains(property), text.contains(element), "{name}: {property}");
            }
        }
    }
}

#[test]
fn the_whole_book_in_one_document_has_its_links_within() {
    let html = sheet::book(&PAPER, Size::A4, &|_| None).unwrap();
    let (_, body) = html.split_once("<body class").unwrap();
    let nodes = tree::parse(&format!("<body class{}", body.trim_end().trim_end_matches("</html>"))).unwrap();
    let (mut ids, mut links) = (BTreeSet::new(), Vec::new());
    tree::each(&nodes, &mut |element| {
        if let Some(id) = element.get("id") {
            assert!(ids.insert(id.to_owned()), "{id} twice");
        }
        links.extend(element.get("href").filter(|target| !target.starts_with("http")).map(str::to_owned));
    });
    for target in links {
        assert!(target.strip_prefix('#').is_some_and(|id| ids.contains(id)), "{target}");
    }
}

#[test]
fn every_chapter_has_a_handout_and_the_first_ten_have_six_problems_or_more() {
    for page in PAPER.chapters() {
        let handout = handout::sheet(&PAPER, &page.name, Size::A4, [0, 0]).unwrap();
        let (_, text) = handout.split_once("<body class").unwrap();
        let translated = page.name.ends_with("-de");
        let can = if translated { "Nach diesem Kapitel kannst du" } else { "After this chapter you can" };
        let screen = ["assert_eq", "Press Play", "moving picture", "On the screen", "class=\"question\""];
        assert!(text.contains(can) && screen.iter().all(|words| !text.contains(words)), "{}", page.name);
        assert!(!text.contains(":</p>\n\n<h2") && !text.contains('\u{1}'), "{}", page.name);
        let twice = text.split("([").skip(1).any(|cited| cited.starts_with(char::is_uppercase));
        assert!(!twice && !text.contains("class=\"line\""), "{}", page.name);
        assert!(page.name != "coin" || (text.contains("[Fey85]") && text.contains("Surely You")));
        let count = |answers: bool| {
            let sheet = problems::sheet(&PAPER, &page.name, Size::A4, [0, 0], answers).unwrap();
            sheet.matches("<li class=\"problem\"").count()
        };
        assert_eq!(count(false), count(true), "{}", page.name);
        let by_hand = page.number.as_ref().is_some_and(|number| number.parse::<u32>().unwrap() <= 10);
        assert!(count(false) >= if by_hand { 6 } else { 1 }, "{}: {}", page.name, count(false));
    }
    let german = |answers| problems::sheet(&PAPER, "toss-a-book-de", Size::A4, [0, 0], answers).unwrap();
    let words = ["<html lang=\"de\">", "Kanten von 24, 12 und 7\u{a0}cm"];
    assert!(words.iter().all(|words| german(false).contains(words)));
    assert!(german(true).contains("nach 2,80\u{a0}s") && german(true).contains("Wirf ein Buch: Antworten"));
    // The story is whole without its question.
    let story = handout::sheet(&PAPER, "toss-a-book", Size::A4, [0, 3]).unwrap();
    assert_eq!(story.matches("class=\"line\"").count(), 9);
    assert!(story.contains("stays fixed in the room, for no torque acts on it"));
    assert!(story.contains("It first flips after 0.64\u{a0}s, or") && story.contains("every 1.08\u{a0}s"));
    assert!(problems::sheet(&PAPER, "nosuch", Size::A4, [0, 0], false).unwrap_err().contains("two-arrows, "));
}
