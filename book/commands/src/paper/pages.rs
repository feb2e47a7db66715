//! The pages of the book as they stand on paper.
//!
//! They come from the pages that `cargo run` builds, so that text, numbers and formulas are the same. Widgets
//! become stills; answers, hints and solutions move to pages of their own at the end, with links both ways.

use super::ends::Ends;
use super::ink;
use super::page::{Page, opened};
use super::still;
use super::tree::{Element, Node, each, parse, rewritten};
use mdbook_driver::MDBook;
use mdbook_preprocessor::book::BookItem;
use std::collections::{BTreeMap, BTreeSet};
use tumbling_site::language::Language;
use tumbling_site::places::escaped;
use tumbling_site::preprocess::Preprocess;
use tumbling_site::{build, files, goals, paths};

/// The book's metadata.
#[derive(Debug, Clone)]
pub(super) struct About {
    pub(super) title: String,
    pub(super) description: String,
    pub(super) authors: Vec<String>,
    pub(super) language: String,
}

/// The whole book.
#[derive(Debug, Clone)]
pub(super) struct Paper {
    pub(super) about: About,
    pub(super) pages: Vec<Page>,
    /// Chapters in other languages, which only handouts show.
    pub(super) translated: Vec<Page>,
}

impl Paper {
    /// Builds the pages, and reads them.
    ///
    /// # Errors
    /// A fault in the book, or a link that leads nowhere.
    pub(super) fn read() -> Result<Self, String> {
        let folder = tempfile::TempDir::new().map_err(|e| format!("no folder for the pages: {e}"))?;
        let built = build::rendered(Some(folder.path()), Preprocess::Pages)?;
        let book = MDBook::load(paths::book()).map_err(|e| e.to_string())?;
        let config = &book.config.book;
        let about = About {
            title: config.title.clone().unwrap_or_default(),
            description: config.description.clone().unwrap_or_default(),
            authors: config.authors.clone(),
            language: config.language.clone().unwrap_or_else(|| "en".into()),
        };
        let mut ends = Ends::default();
        let (mut pages, mut translated) = (Vec::new(), Vec::new());
        for item in book.iter() {
            let BookItem::Chapter(chapter) = item else { continue };
            let Some(path) = &chapter.path else { continue };
            let name = path.with_extension("").to_string_lossy().into_owned();
            let html = files::text(&built.join(format!("{name}.html")))?;
            let body = body(&html, &name).map_err(|what| format!("{name}.html: {what}"))?;
            let number = chapter.number.as_ref().map(|n| n.to_string().trim_end_matches('.').to_owned());
            // A page below another one, or without goals, is not a chapter and has no handout.
            let number = number.filter(|number| !number.contains('.') && goals::of(&name).is_ok());
            let title = chapter.name.clone();
            match Language::of(&name)? {
                None => pages.push(Page { body: ends.take(&name, &title, body), name, title, number }),
                Some((_, original)) => {
                    let original = pages.iter().find(|page: &&Page| page.name == original);
                    let number = original.and_then(|page| page.number.clone());
                    let body = Ends::default().take(&name, &title, body);
                    translated.push(Page { body, name, title, number });
                }
            }
        }
        pages.extend(ends.pages());
        linked(&mut pages, &translated)?;
        Ok(Self { about, pages, translated })
    }
}

impl Paper {
    /// The pages with a handout: those with a number, and their translations.
    pub(super) fn chapters(&self) -> impl Iterator<Item = &Page> {
        self.pages.iter().chain(&self.translated).filter(|page| page.number.is_some())
    }
}

/// The contents of a page in a form for paper.
fn body(html: &str, page: &str) -> Result<Vec<Node>, String> {
    let (_, main) = html.split_once("<main id=\"main\" tabindex=\"-1\">").ok_or("has no <main>")?;
    let (main, _) = main.split_once("</main>").ok_or("its <main> does not end")?;
    let nodes = parse(main)?;
    let mut shown = BTreeSet::new();
    each(&nodes, &mut |element| {
        shown.extend(element.get("id").and_then(|id| id.strip_prefix("fig-")).map(str::to_owned));
    });
    let mut wrong = None;
    let plain = rewritten(nodes, &mut |element| match on_paper(element, page, &shown) {
        Ok(nodes) => nodes,
        Err(what) => {
            wrong = Some(what);
            Vec::new()
        }
    });
    wrong.map_or(Ok(plain), Err)
}

/// The replacement for an element on paper.
fn on_paper(mut element: Element, page: &str, shown: &BTreeSet<String>) -> Result<Vec<Node>, String> {
    let class = |class: &str| element.has_class(class);
    Ok(match element.name.as_str() {
        "script" | "button" => Vec::new(),
        _ if element.get("hidden").is_some() => Vec::new(),
        _ if ["boring", "turning", "fig-large", "screen"].into_iter().any(class) => Vec::new(),
        "a" if class("header") => element.children,
        "div" if class("fig-frame") || element.get("lang").is_some() => element.children,
        "div" if class("live") => still::of(element.get("data-live").unwrap_or_default(), page, shown)?,
        "details" if class("program") => vec![opened(element, "program")],
        "svg" => vec![ink::fixed(element).into()],
        "mfrac" | "mtable" => styled(element),
        "math" => {
            let words = math_words(&element);
            element.set("xmlns", "http://www.w3.org/1998/Math/MathML");
            element.set("alttext", words.trim());
            vec![element.into()]
        }
        _ => vec![element.into()],
    })
}

/// A part of a formula, with the style that MathML 3, which EPUB takes, does not know there around it.
fn styled(mut element: Element) -> Vec<Node> {
    // A table has the first itself; around it, it would count for nothing.
    let unknown =
        if element.name == "mtable" { &["scriptlevel"][..] } else { &["displaystyle", "scriptlevel"] };
    let (style, own) = element.attributes.into_iter().partition(|(name, _)| unknown.contains(&name.as_str()));
    element.attributes = own;
    let style = Element { name: "mstyle".into(), attributes: style, children: Vec::new() };
    let plain = style.attributes.is_empty();
    vec![if plain { element } else { Element { children: vec![element.into()], ..style } }.into()]
}

/// A formula in one line of text.
fn math_words(element: &Element) -> String {
    let parts: Vec<(&str, String)> = element
        .children
        .iter()
        .map(|child| match child {
            Node::Element(child) => (child.name.as_str(), math_words(child)),
            Node::Text(text) => ("", text.clone()),
        })
        .collect();
    let [first, second, third] = [0, 1, 2].map(|at| parts.get(at).map_or("", |(_, words)| words.as_str()));
    let all = || parts.iter().map(|(_, words)| words.as_str()).collect::<String>();
    match element.name.as_str() {
        "msub" => format!("{first}_{second}"),
        "msup" => format!("{first}^{second}"),
        "msubsup" => format!("{first}_{second}^{third}"),
        "mfrac" => format!("({first})/({second})"),
        "msqrt" => format!("√({})", all()),
        "mtr" => format!("{}; ", parts.iter().map(|(_, words)| words.as_str()).collect::<Vec<_>>().join(" ")),
        "mspace" => " ".into(),
        "mo" if "=<>≤≥+−".contains(&*all()) => format!(" {} ", all()),
        _ => all(),
    }
}

/// Gives every link the form `PAGE.html#PLACE`, and takes away those that lead out of the book to where
/// paper cannot follow.
///
/// # Errors
/// A link that leads to nothing in the book.
fn linked(pages: &mut [Page], translated: &[Page]) -> Result<(), String> {
    let mut places: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for page in pages.iter() {
        let of = places.entry(page.name.clone()).or_default();
        each(&page.body, &mut |element| of.extend(element.get("id").map(str::to_owned)));
    }
    let mut lost = Vec::new();
    for page in pages {
        let name = page.name.clone();
        let body = std::mem::take(&mut page.body);
        page.body = rewritten(body, &mut |mut element| {
            let target = element.get("href").filter(|_| element.name == "a").map(str::to_owned);
            let Some(target) = target.filter(|target| !target.starts_with("http")) else {
                return vec![element.into()];
            };
            let (file, place) = target.split_once('#').unwrap_or((&target, ""));
            let file = if file.is_empty() { &name } else { file.strip_suffix(".html").unwrap_or(file) };
            let known = places.get(file);
            if file.contains('/') || translated.iter().any(|page| page.name == file) {
                return element.children;
            }
            if known.is_none_or(|known| !place.is_empty() && !known.contains(place)) {
                lost.push(format!("{name}.html leads to {target}, which is not there"));
            }
            let place = if place.is_empty() { String::new() } else { format!("#{place}") };
            element.set("href", &format!("{file}.html{place}"));
            vec![element.into()]
        });
    }
    if lost.is_empty() { Ok(()) } else { Err(lost.join("\n")) }
}

/// The items of the contents: each page, and the sections of those that are `open`; `line` makes each of the
/// names of page and section, and its words.
pub(super) fn contents(
    paper: &Paper,
    open: fn(&Page) -> bool,
    line: &dyn Fn(&str, Option<&str>, &str) -> String,
) -> String {
    let listed = |page: &Page| {
        let number = page.number.as_ref().map_or(String::new(), |number| format!("{number}. "));
        let title = line(&page.name, None, &escaped(&format!("{number}{}", page.title)));
        let mut sections = String::new();
        each(&page.body, &mut |element| {
            if let ("h2", Some(id)) = (element.name.as_str(), element.get("id")) {
                sections += &format!("<li>{}</li>\n", line(&page.name, Some(id), &escaped(&element.text())));
            }
        });
        let open = open(page) && !sections.is_empty();
        let sections = if open { format!("\n<ol>\n{sections}</ol>\n") } else { String::new() };
        format!("<li>{title}{sections}</li>\n")
    };
    paper.pages.iter().map(listed).collect()
}
