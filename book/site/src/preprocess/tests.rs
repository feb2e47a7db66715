//! The preprocessor on small chapters, and on the book itself.

use super::*;
use mdbook_preprocessor::book::Chapter;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A repository with this drawing as `figures/arrows.svg`, and nothing else.
fn with_drawing(svg: &str) -> TempDir {
    let repository = TempDir::new().unwrap();
    for folder in ["book/chapters", "book/widgets/page", "book/widgets/built", "figures"] {
        fs::create_dir_all(repository.path().join(folder)).unwrap();
    }
    fs::write(repository.path().join("figures/arrows.svg"), svg).unwrap();
    let widgets = repository.path().join("book/widgets");
    for (file, text) in [
        ("page/dial.html", "<p>A dial.</p>\n\n<div class=\"live-stage\"></div>\n"),
        ("page/dial.js", "dial"),
        ("page/live.js", "live"),
        ("built/dial.wasm", "foo"),
    ] {
        fs::write(widgets.join(file), text).unwrap();
    }
    repository
}

const ARROWS: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 10\" role=\"img\" \
    aria-labelledby=\"arrows-title arrows-desc\">\n\
    <title id=\"arrows-title\">Two arrows</title>\r\n\n<desc id=\"arrows-desc\">One left.</desc>\n\
    <path d=\"M0 0\" stroke=\"var(--fig-omega, #0072b2)\"/>\n</svg>\n";

fn shown(text: &str) -> std::result::Result<String, String> {
    let repository = with_drawing(ARROWS);
    let folders = Folders {
        chapters: repository.path().join("book/chapters"),
        figures: repository.path().join("figures"),
        widgets: repository.path().join("book/widgets"),
    };
    let source = Source { file: "book/chapters/x.md", text };
    chapter_as_shown(&source, &maths::Maths::new(), &folders, &mut Seen::default())
        .map_err(|faults| faults.join("\n"))
}

#[test]
fn inline_and_display_maths_become_mathml() {
    let out = shown("Let $I$ be.\n\n$$\n\\mathbf{L} = I\\,\\boldsymbol{\\omega}\n$$\n").unwrap();
    assert!(out.starts_with("Let <math><mi>I</mi></math> be."), "{out}");
    assert!(out.contains("<span class=\"math-display\"><span class=\"math-part\"><math display=\"block\">"));
    assert!(!out.contains('$'), "{out}");
}

#[test]
fn what_markdown_could_take_for_its_own_is_hidden() {
    let out = shown("$a_1 * b_2 * c' | d$ and\n\n$$\nx +\ny \\text{a\\_b*c*}\n$$\n").unwrap();
    let between_tags: String = out.split('<').filter_map(|tag| tag.split_once('>')).map(|t| t.1).collect();
    let bare: Vec<char> = between_tags.chars().filter(|c| "_*|`~[]\\".contains(*c)).collect();
    assert!(bare.is_empty(), "{bare:?} in {between_tags}");
    // The formula is one line: Markdown ends a block of HTML at a blank one.
    assert!(out.lines().any(|line| line.starts_with("<span") && line.ends_with("</span>")), "{out}");
}

#[test]
fn code_and_escaped_dollars_stay_as_written() {
    for text in [
        "`$x$` and ``$$y$$``\n",
        "```sh\necho \"$x$\" # $$y$$\n```\n",
        "~~~text\n$5 and $6 and $\\frac{$\n~~~\n",
        "A price of \\$5, or \\$6.\n",
        "\\$\\$ no formula \\$\\$\n",
        "<!-- $x$ -->\n",
    ] {
        assert_eq!(shown(text).unwrap(), text);
    }
}

#[test]
fn a_formula_keeps_the_marks_that_cling_to_it() {
    let out = shown("If ($x$), then $y$-axis; [a $z$](b.md) and $w$![](c.png) $2$ kg m, or\n").unwrap();
    let x = "<span class=\"math-inline\">(<math><mi>x</mi></math>),</span> then";
    let y = "<span class=\"math-inline\"><math><mi>y</mi></math>-</span>axis";
    let z = "[a <math><mi>z</mi></math>](b.md)";
    let w = "<math><mi>w</mi></math>![](c.png)";
    let unit = "<math><mn>2</mn></math> kg m,</span> or";
    for expected in [x, y, z, w, unit] {
        assert!(out.contains(expected), "{expected} in {out}");
    }
}

#[test]
fn maths_works_in_headings_lists_quotes_tables_and_footnotes() {
    let text =
        "# The $I$\n\n- one $a$\n\n> $$b$$\n\n| $c$ | d |\n|---|---|\n| $e$ | $f$ |\n\nx[^1]\n\n[^1]: $g$\n";
    let out = shown(text).unwrap();
    assert_eq!(out.matches("<math").count(), 7, "{out}");
    assert!(out.contains("# The <math>") && out.contains("> <span class=\"math-display\">"), "{out}");
    assert!(out.contains("| <math><mi>e</mi></math> |"), "{out}");
}

#[test]
fn tex_that_cannot_be_shown_names_its_file_its_line_and_itself() {
    let faults = shown("# A\n\nFine: $x$.\nBroken: $\\frac{1}$ and $\\nosuch$.\n").unwrap_err();
    let lines: Vec<&str> = faults.lines().collect();
    assert_eq!(lines.len(), 2, "{faults}");
    assert!(lines[0].starts_with("book/chapters/x.md:4: ") && lines[0].contains("`\\frac{1}`"), "{faults}");
    assert!(lines[1].starts_with("book/chapters/x.md:4: ") && lines[1].contains("`\\nosuch`"), "{faults}");
}

#[test]
fn lines_are_counted_with_windows_line_ends_too() {
    let faults = shown("# A\r\n\r\ntext\r\n\r\n$$\r\n\\nosuch\r\n$$\r\n").unwrap_err();
    assert!(faults.starts_with("book/chapters/x.md:5: "), "{faults}");
    let out = shown("$$\r\nx\r\n$$\r\n").unwrap();
    let part = "<span class=\"math-part\"><math display=\"block\"><mi>x</mi></math></span>";
    assert_eq!(out, format!("<span class=\"math-display\">{part}</span>\r\n"));
}

#[test]
fn a_dollar_that_is_neither_maths_nor_escaped_is_a_fault() {
    for text in ["It costs $5.\n", "a\n\n$$\nx\n\ny\n$$\n", "spaces $ x $ here\n", "\\$5 or $6\n"] {
        let faults = shown(text).unwrap_err();
        assert!(faults.contains("dollar sign"), "{text:?}: {faults}");
    }
    assert!(shown("a\n\nb $5\n").unwrap_err().starts_with("book/chapters/x.md:3: "));
}

#[test]
fn code_without_a_language_is_a_fault() {
    for text in ["a\n\n```\nlet x;\n```\n", "a\n\n    indented\n"] {
        let faults = shown(text).unwrap_err();
        assert!(faults.starts_with("book/chapters/x.md:3: code of no language"), "{faults}");
    }
    assert!(shown("```rust,standalone_crate\nfn main() {}\n```\n").is_ok());
}

#[test]
fn a_figure_becomes_its_drawing_with_its_caption() {
    let text = "Before.\n\n![Two arrows.](../../figures/arrows.svg)\n\n*The spin $\\omega$, **in blue**.*\n\nAfter *this*.\n";
    let out = shown(text).unwrap();
    for expected in [
        "Before.\n\n<figure class=\"fig\" id=\"fig-arrows\">",
        "href=\"figures/arrows.svg\"",
        "<figcaption>\n\nThe spin <span class=\"math-inline\"><math><mi>ω</mi></math>,</span> **in blue**.\n\n</figcaption>\n</figure>\n\n",
        "After *this*.",
    ] {
        assert!(out.contains(expected), "{expected}\nin\n{out}");
    }
    let html = &out[out.find("<figure").unwrap()..out.find("<figcaption").unwrap()];
    assert!(html.lines().all(|line| !line.trim().is_empty()), "a blank line would end the HTML: {html}");
    assert!(!html.contains('\r'), "{html:?}");
}

#[test]
fn a_paragraph_that_only_begins_with_emphasis_is_no_caption() {
    let image = "![Two arrows.](../../figures/arrows.svg)\n\n";
    for text in ["*Not* a caption.\n", "*One* and *two*\n", "Plain.\n", ""] {
        let out = shown(&format!("{image}{text}")).unwrap();
        assert!(out.contains("</figure>") && !out.contains("<figcaption>"), "{out}");
        assert!(out.ends_with(text), "{out}");
    }
}

#[test]
fn a_figure_that_is_wrong_says_how() {
    let wrong = |text: &str| shown(text).unwrap_err();
    let missing = wrong("a\n\n![What.](../../figures/none.svg)\n");
    assert!(missing.starts_with("book/chapters/x.md:3: cannot read "), "{missing}");
    assert!(wrong("![](../../figures/arrows.svg)\n").contains("words"));
    assert!(wrong("See ![A](../../figures/arrows.svg) here.\n").contains("paragraph of its own"));
    assert!(wrong("- ![A](../../figures/arrows.svg)\n").contains("paragraph of its own"));
    assert!(wrong("> ![A](../../figures/arrows.svg)\n").contains("paragraph of its own"));
    assert!(wrong("![The $I$](../../figures/arrows.svg)\n").contains("plain text"));
    let twice = wrong("![A](../../figures/arrows.svg)\n\n![A](../../figures/arrows.svg)\n");
    assert!(twice.contains("shown already in book/chapters/x.md"), "{twice}");
}

#[test]
fn other_images_and_links_stay_and_a_citation_stands_in_brackets() {
    let text = "![A](picture.png) and [the figure](#fig-arrows), [svg](../../figures/arrows.svg)\n";
    assert_eq!(shown(text).unwrap(), text);
    let cited = shown("In *a* [LL76](references.md#ll76), of [all](references.md).\n").unwrap();
    assert_eq!(cited, "In *a* \\[[LL76](references.md#ll76)\\], of [all](references.md).\n");
}

#[test]
fn a_widget_becomes_a_place_in_the_page() {
    let out = shown("a\n\n{{#widget dial}}\n\nb\n").unwrap();
    let html = "<div class=\"live\" id=\"live-dial\" data-live=\"dial\" data-modules=\"dial\" data-from=\"widgets/\">\n<p>A dial.</p>\n\
                <div class=\"live-stage\"></div>\n</div>\n<script src=\"widgets/live.js\" defer></script>\n\n";
    assert_eq!(out, format!("a\n\n{html}\nb\n"));
    let twice = shown("{{#widget dial}}\n\n{{#widget dial}}\n").unwrap();
    assert!(twice.matches("id=\"live-dial\"").count() == 1 && twice.contains("<template>\n<div"), "{twice}");
    let code = "```text\n{{#widget dial}}\n```\n";
    assert_eq!(shown(code).unwrap(), code);
}

#[test]
fn a_widget_that_is_wrong_says_how() {
    let wrong = |text: &str| shown(text).unwrap_err();
    let missing = wrong("a\n\n{{#widget none}}\n");
    assert!(missing.starts_with("book/chapters/x.md:3: there is no widget `none`"), "{missing}");
    for text in [
        "See {{#widget dial}} here.\n",
        "- {{#widget dial}}\n",
        "> {{#widget dial}}\n",
        "{{#widget ../dial}}\n",
    ] {
        assert!(wrong(text).contains("paragraph of its own"), "{text}");
    }
}

#[test]
fn a_widget_lays_out_its_script_its_parts_and_the_modules_that_it_asks_and_nothing_else() {
    let repository = with_drawing(ARROWS);
    let root = repository.path().join("book");
    let widgets = root.join("widgets");
    for (file, text) in [
        ("page/steps.html", "<div class=\"live-stage\"></div>\n"),
        ("page/steps.js", "steps"),
        ("page/steps.path.js", "its path"),
        ("page/steps.errors.js", "its errors"),
        ("page/steps-two.js", "another's"),
        ("page/tumble.js", "another's"),
        ("page/steps.notes.txt", "no script"),
        ("built/steps.wasm", "foo"),
    ] {
        fs::write(widgets.join(file), text).unwrap();
    }
    let copies = root.join("chapters/widgets");
    fs::create_dir_all(&copies).unwrap();
    fs::write(copies.join("old.js"), "of an earlier book").unwrap();
    let run = || Preprocess::Pages.run(&context(&root), book_of(&[("x.md", "{{#widget steps}}\n")]));
    // Steps ask the tumble's module for the exact motion: without it there is no book.
    let missing = run().unwrap_err().to_string();
    assert!(missing.contains("cannot read") && missing.contains("built/tumble.wasm"), "{missing}");
    fs::write(widgets.join("built/tumble.wasm"), "foob").unwrap();
    run().unwrap();
    let laid = fs::read_dir(&copies).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let all = ["live.js", "steps.errors.js", "steps.js", "steps.path.js", "steps.wasm.js", "tumble.wasm.js"];
    assert_eq!(laid.collect::<BTreeSet<_>>(), BTreeSet::from(all.map(str::to_owned)));
    let text = |file: &str| fs::read_to_string(copies.join(file)).unwrap();
    let scripts = ["live.js", "steps.js", "steps.path.js", "steps.errors.js"].map(text);
    assert_eq!(scripts, ["live", "steps", "its path", "its errors"]);
    assert_eq!(text("steps.wasm.js"), "tumblingLive.carry(\"steps\", \"eNpLy88HAAKCAUU=\");\n");
    assert_eq!(text("tumble.wasm.js"), "tumblingLive.carry(\"tumble\", \"eNpLy89PAgAEKQGn\");\n");
}

#[test]
fn a_widget_that_does_not_exist_stops_the_book_and_lays_nothing_out() {
    let repository = with_drawing(ARROWS);
    let root = repository.path().join("book");
    let book = book_of(&[("x.md", "{{#widget dial}}\n"), ("y.md", "\n\n{{#widget dail}}\n")]);
    let fault = Preprocess::Pages.run(&context(&root), book).unwrap_err().to_string();
    assert!(fault.contains("book/chapters/y.md:3: there is no widget `dail`"), "{fault}");
    assert!(fault.contains("page/dail.html"), "{fault}");
    assert!(!root.join("chapters/widgets").exists());
    // One with a place in the page and no script, or no module, is none either.
    for gone in ["page/dial.js", "built/dial.wasm"] {
        let repository = with_drawing(ARROWS);
        let root = repository.path().join("book");
        fs::remove_file(root.join("widgets").join(gone)).unwrap();
        let book = book_of(&[("x.md", "{{#widget dial}}\n")]);
        let fault = Preprocess::Pages.run(&context(&root), book).unwrap_err().to_string();
        assert!(fault.contains("cannot read") && fault.contains(gone), "{fault}");
    }
}

/// A book of these chapters.
fn book_of(chapters: &[(&str, &str)]) -> Book {
    let chapter = |(path, text): &(&str, &str)| Chapter::new(path, (*text).to_owned(), *path, Vec::new());
    Book::new_with_items(chapters.iter().map(chapter).map(BookItem::Chapter).collect())
}

fn context(root: &Path) -> PreprocessorContext {
    let mut config = mdbook_preprocessor::config::Config::default();
    config.book.src = "chapters".into();
    PreprocessorContext::new(root.to_owned(), config, "html".into())
}

#[test]
fn drawings_that_are_shown_are_laid_beside_the_chapters_and_no_others() {
    let repository = with_drawing(ARROWS);
    let root = repository.path().join("book");
    let copies = root.join("chapters/figures");
    fs::create_dir_all(&copies).unwrap();
    fs::write(copies.join("old.svg"), "<svg></svg>").unwrap();
    let book = book_of(&[("x.md", "![A](../../figures/arrows.svg)\n")]);
    Preprocess::Pages.run(&context(&root), book).unwrap();
    let copy = fs::read_to_string(copies.join("arrows.svg")).unwrap();
    // Opened large it fills the window.
    assert!(copy.starts_with("<svg width=\"100%\" height=\"100%\" "), "{copy}");
    let [rest, whole] = [&copy, ARROWS].map(|text| text.split_once('>').unwrap().1);
    let (drawn, themes) = rest.split_once("<style>").unwrap();
    assert_eq!(format!("{drawn}</svg>"), whole.trim_end());
    assert!(themes.contains("#arrows-navy:target") && themes.trim_end().ends_with("</g></svg>"), "{themes}");
    assert!(!copies.join("old.svg").exists());
}

#[test]
fn the_faults_of_all_chapters_are_told_at_once() {
    let repository = with_drawing(ARROWS);
    let book = book_of(&[("x.md", "$\\nosuch$"), ("y.md", "fine"), ("z.md", "$\\other$")]);
    let faults = Preprocess::Pages.run(&context(&repository.path().join("book")), book).unwrap_err();
    let faults = faults.to_string();
    assert!(faults.contains("x.md:1") && faults.contains("z.md:1"), "{faults}");
}

#[test]
fn the_protocol_takes_a_book_and_gives_it_back_changed() {
    let repository = with_drawing(ARROWS);
    let sent = (context(&repository.path().join("book")), book_of(&[("x.md", "The $I$.")]));
    let mut answer = Vec::new();
    protocol::answer(serde_json::to_vec(&sent).unwrap().as_slice(), &mut answer).unwrap();
    let book: Book = serde_json::from_slice(&answer).unwrap();
    let chapters: Vec<&Chapter> = book.chapters().collect();
    assert!(chapters[0].content.contains("<math>"), "{}", chapters[0].content);
    // What mdBook itself reads after that.
    assert!(repository.path().join("book/theme/highlight.js").is_file());
    assert!(supports("html") && !supports("markdown"));
    assert!(protocol::answer("no JSON".as_bytes(), Vec::new()).is_err());
}

#[test]
fn each_page_ends_with_its_neighbours_and_what_they_are_about() {
    let repository = with_drawing(ARROWS);
    let root = repository.path().join("book");
    fs::create_dir_all(&root).unwrap();
    let sentences = "x = 'First.'\ny = 'Then & there.'\nz = 'Last.'\n";
    fs::write(root.join("pages.toml"), sentences).unwrap();
    let three = [("x.md", "one"), ("y.md", "two"), ("z.md", "three")];
    let book = Preprocess::Pages.run(&context(&root), book_of(&three)).unwrap();
    let pages: Vec<&str> = book.chapters().map(|chapter| chapter.content.as_str()).collect();
    let next = "<a href=\"y.html\">y.md</a> Then &amp; there.";
    assert!(!pages[0].contains("Before") && pages[0].contains(next), "{}", pages[0]);
    assert!(pages[1].contains("x.html") && pages[1].contains("z.html"), "{}", pages[1]);
    assert!(pages[2].contains("y.html") && !pages[2].contains("Next"));

    fs::write(root.join("pages.toml"), sentences.replace("y =", "w =")).unwrap();
    let faults = Preprocess::Pages.run(&context(&root), book_of(&three)).unwrap_err().to_string();
    assert!(faults.contains("no sentence for `y`") && faults.contains("`w`, which is no page"), "{faults}");
}
