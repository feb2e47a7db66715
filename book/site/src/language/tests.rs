use super::*;

fn german() -> String {
    files::text(&paths::book().join("words.de.toml")).unwrap()
}

/// The faults of the German book if the first words are replaced by the second.
fn faults(said: &str, altered: &str) -> String {
    assert!(german().contains(said), "{said}");
    let language = Language::parse("de", &german().replacen(said, altered, 1));
    language.and_then(|german| german.page("toss-a-book")).unwrap_err()
}

#[test]
fn a_number_a_sign_a_unit_a_number_word_or_a_link_that_is_altered_is_noticed() {
    for (said, altered) in [
        ("*0,64 s*", "*0,65 s*"),
        ("es alle 1,08 s", "es alle −1,08 s"),
        ("Taschenbuch von 129 × 198 × 20", "Taschenbuch von 129 × 189 + 20"),
        ("20 mm und 0,340", "20 cm und 0,340"),
        ("0,340 kg", "0.340 kg"),
        (" in rad/s", " in rad"),
        ("hat drei Achsen", "hat vier Achsen"),
        ("etwa eine Sekunde", "etwa zehn Sekunden"),
        ("zwei Umdrehungen pro Sekunde", "zwei Umdrehungen pro Minute"),
        ("Versehen ein Zwanzigstel", "Versehen ein Zehntel"),
        ("*Quer zum Griff, in der Ebene der Saiten*", "*Den Griff entlang*"),
        ("Beim dritten ist es umgeklappt", "Beim zweiten ist es umgeklappt"),
        ("mit 0,02 rad Abweichung", "mit 0,2 rad Abweichung"),
        ("](../../figures/three-tosses.svg)\"\n\"*", "](../../figures/coin.svg)\"\n\"*"),
    ] {
        let wrong = faults(said, altered);
        let noticed = [" where the original has ", "other links"].iter().any(|words| wrong.contains(words));
        let line = 1 + german().split(said).next().unwrap().matches('\n').count();
        assert!(noticed && wrong.contains(&format!("words.de.toml:{line}: `")), "{said}: {wrong}");
    }
}

#[test]
fn a_page_that_has_fallen_behind_says_where() {
    assert!(faults("\"A brick\" =", "\"The brick\" =").contains("`The brick`: problems.md says it no more"));
    let wrong = faults("\"A book has three axes.", "\"The book has three axes.");
    assert!(wrong.contains("`A book has three axes. One runs along"), "{wrong}");
    assert!(wrong.ends_with("it is in book/chapters/toss-a-book.md:6"), "{wrong}");
    assert!(wrong.contains("toss-a-book.md says it no more"), "{wrong}");
    let page = Language::read("de").unwrap().page("toss-a-book").unwrap();
    assert!(page.contains("## Wie schnell es geschieht {#how-fast-it-happens}\n\n> **Predict.** Du"));
    assert!(page.contains("> *0,64 s*: Ein kleiner") && page.contains("\"0.64 s\""));
}

#[test]
fn a_label_is_known_as_a_whole_or_by_its_parts() {
    let german = Language::read("de").unwrap();
    let english = "<text>the book, 1 turn/s, a slip of 1.50 %</text><style>spin</style>";
    let said = "<text>das Buch, 1 Umdrehung/s, Abweichung 1,50 %</text><style>spin</style>";
    assert_eq!(german.markup(english), (said.to_owned(), Vec::new()));
    let (said, wrong) = german.markup("<p aria-label=\"Again\">t = 2.5 s</p><p>spinning</p>");
    assert_eq!(said, "<p aria-label=\"Noch einmal\">t = 2,5 s</p><p>spinning</p>");
    let summary = files::text(&paths::chapters().join("SUMMARY.md")).unwrap();
    let titles = summary.lines().filter(|line| !line.contains("-de.md"));
    for title in titles.filter_map(|line| line.split(['[', ']']).nth(1)) {
        assert!(german.words.contains_key(title), "{title}");
    }
    assert_eq!(Language::read("fr").unwrap_err(), "there is no book/words.fr.toml");
    assert!(wrong.len() == 1 && wrong[0].contains("`spinning` is not known"), "{wrong:?}");
}
