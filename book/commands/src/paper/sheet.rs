//! Pages of the book as one HTML document to be printed, with all that it needs inside.

use super::mend;
use super::page::Page;
use super::pages::{Paper, contents};
use super::tree::{Element, Node, xml};
use base64::prelude::{BASE64_STANDARD, Engine as _};
use std::fmt::Write as _;
use tumbling_site::places::escaped;
use tumbling_site::{files, paths};

/// The size of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub(crate) enum Size {
    #[default]
    A4,
    Letter,
}

/// The whole book: title page, contents, every page.
///
/// # Errors
/// A font that cannot be read.
pub(super) fn book(
    paper: &Paper,
    size: Size,
    numbers: &dyn Fn(&str) -> Option<usize>,
) -> Result<String, String> {
    let mut body = super::title::page(paper);
    body.push_str(&listed(paper, numbers));
    let mut rules = String::new();
    for page in &paper.pages {
        // The name of the chapter at the head of its pages.
        let _ = write!(
            rules,
            "@page {0} {{ @top-left {{ content: \"{1}\"; }} }}\n#{0}--page {{ page: {0}; }}\n",
            page.name,
            page.title.replace('"', "")
        );
        let number =
            page.number.iter().map(|number| format!("<p class=\"chapter-number\">Chapter {number}</p>\n"));
        let number: String = number.collect();
        let _ = write!(
            body,
            "<section id=\"{}--page\" class=\"chapter\">\n{number}{}\n</section>\n",
            page.name,
            xml(&within(&page.body, &page.name))
        );
    }
    document(paper, [&paper.about.language, &paper.about.title], "book", size, &rules, &body)
}

fn listed(paper: &Paper, numbers: &dyn Fn(&str) -> Option<usize>) -> String {
    let contents = contents(paper, |page| page.number.is_some(), &|page, section, words| {
        let place = format!("{page}--{}", section.unwrap_or("page"));
        let number = numbers(&place).map_or(String::new(), |number| number.to_string());
        format!("<a href=\"#{place}\"><span>{words}</span><span class=\"at-page\">{number}</span></a>")
    });
    format!(
        "<nav class=\"contents\" aria-label=\"Contents\">\n<h1>Contents</h1>\n<ol>\n{contents}</ol>\n</nav>\n"
    )
}

/// The nodes of a page with names and links that hold within one document. Drawings have names of their own.
pub(super) fn within(nodes: &[Node], page: &str) -> Vec<Node> {
    let mut out = nodes.to_vec();
    for node in &mut out {
        let Node::Element(element) = node else { continue };
        printable(element);
        if element.name == "svg" {
            continue;
        }
        if let Some(id) = element.get("id").map(|id| format!("{page}--{id}")) {
            element.set("id", &id);
        }
        if let Some(target) = element.get("href").filter(|target| !target.starts_with("http")) {
            let (file, place) = target.split_once(".html#").unwrap_or((target, "page"));
            let target = format!("#{}--{place}", file.trim_end_matches(".html"));
            element.set("href", &target);
        }
        element.children = within(&element.children, page);
    }
    out
}

/// Chromium gives the words of a drawing or formula to those who do not see it where it is an image with a
/// label; a `<figure>` around it would be a second image, without words.
fn printable(element: &mut Element) {
    match element.name.as_str() {
        "figure" | "figcaption" => {
            let class = std::mem::replace(&mut element.name, "div".into());
            element.set("class", &class);
        }
        "math" => {
            let words = element.get("alttext").unwrap_or_default().to_owned();
            element.set("role", "img");
            element.set("aria-label", &format!("{}{words}", mend::FORMULA));
        }
        // An empty cell, or one of blanks, would be no cell of the tagged table.
        "td" | "th" if element.children.is_empty() => element.children.push(Node::Text("–".into())),
        _ => {}
    }
}

/// The fonts of the book as rules of a style sheet, with all their letters inside.
///
/// # Errors
/// A font that cannot be read.
pub(crate) fn fonts() -> Result<String, String> {
    let of = |(family, style, weights, file): (&str, &str, &str, &str)| {
        let font = files::bytes(&paths::book().join(format!("theme/fonts/{file}.woff2")))?;
        Ok(format!(
            "@font-face {{ font-family: \"{family}\"; font-style: {style}; font-weight: {weights}; \
             src: url(\"data:font/woff2;base64,{}\") format(\"woff2\"); }}\n",
            BASE64_STANDARD.encode(font)
        ))
    };
    let all = [
        ("Literata", "normal", "200 900", "literata"),
        ("Literata", "italic", "200 900", "literata-italic"),
        ("Tumbling Math", "normal", "200 900", "tumbling-math"),
        ("Tumbling Sans", "normal", "200 500", "tumbling-sans"),
        ("Tumbling Sans", "normal", "501 900", "tumbling-sans-semibold"),
        ("Tumbling Mono", "normal", "200 900", "tumbling-mono"),
    ];
    all.into_iter().map(of).collect()
}

/// A document in a language, with a title, of this class of sheets, see `book/paper/print.css`.
///
/// # Errors
/// A font that cannot be read.
pub(super) fn document(
    paper: &Paper,
    [language, title]: [&str; 2],
    class: &str,
    size: Size,
    rules: &str,
    body: &str,
) -> Result<String, String> {
    let fonts = fonts()?;
    let paper_size = if size == Size::A4 { "A4" } else { "letter" };
    Ok(format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n<title>{}</title>\n<meta name=\"author\" \
         content=\"{}\">\n<style>\n{}\n@page {{ size: {paper_size}; }}\n{rules}{fonts}</style>\n</head>\n<body class=\"{class}\">\n\
         <main>\n{body}\n</main>\n</body>\n</html>\n",
        escaped(title),
        escaped(&paper.about.authors.join(", ")),
        include_str!("../../../paper/print.css"),
    ))
}

/// The next element after the one with this id, among these nodes.
pub(super) fn after<'a>(nodes: &'a [Node], id: &str) -> Option<&'a Element> {
    let mut elements = nodes.iter().filter_map(Node::element);
    elements.by_ref().find(|element| element.get("id") == Some(id))?;
    elements.next()
}

/// The page of this name among those with a number.
///
/// # Errors
/// No such page; the error names the existing ones.
pub(super) fn chapter<'a>(paper: &'a Paper, name: &str) -> Result<&'a Page, String> {
    let numbered = || paper.chapters();
    numbered().find(|page| page.name == name).ok_or_else(|| {
        let names: Vec<&str> = numbered().map(|page| page.name.as_str()).collect();
        format!("there is no chapter `{name}`; the chapters are {}", names.join(", "))
    })
}
