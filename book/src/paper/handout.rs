//! A chapter as a handout: its story, figures, formulas, numbers and questions, without programs.

use super::pages::Paper;
use super::sheet::{self, Size};
use super::tree::{Element, Node, rewritten, xml};
use crate::site::goals;
use crate::site::places::escaped;

/// The handout of a chapter as HTML, set this closely.
///
/// # Errors
/// There is no such chapter.
pub(super) fn sheet(paper: &Paper, name: &str, size: Size, fit: usize) -> Result<String, String> {
    let page = sheet::chapter(paper, name)?;
    let number = page.number.as_deref().unwrap_or_default();
    let goals: String =
        goals::of(name)?.iter().map(|goal| format!("<li>{}</li>", escaped(&goal.goal))).collect();
    let body = format!(
        "<header><p>{}, chapter {number}</p>\n{}\n</header>\n<div class=\"goals\"><p>After this chapter you can</p>\
         <ul>{goals}</ul></div>\n<div class=\"columns\">\n{}\n</div>\n<footer><p>The book has the programs that check \
         these numbers, the exercises and the answers. Text and figures: {}, CC BY 4.0.</p></footer>",
        escaped(&paper.about.title),
        heading(&page.body),
        xml(&sheet::within(&story(&page.body), name)),
        escaped(&paper.about.authors.join(", ")),
    );
    let title = format!("{}: handout", page.title);
    sheet::document(
        paper,
        &title,
        &format!("handout fit-{fit}"),
        size,
        "@page { margin: 14mm 15mm 16mm; }",
        &body,
    )
}

fn heading(body: &[Node]) -> String {
    body.iter().find(|node| node.is("h1")).map_or(String::new(), |title| xml(std::slice::from_ref(title)))
}

/// The chapter up to its exercises, without programs, stills and links.
fn story(body: &[Node]) -> Vec<Node> {
    let id = |node: &Node| node.element().and_then(|element| element.get("id")) == Some("exercises");
    let end = body.iter().position(|node| node.is("h2") && id(node)).unwrap_or(body.len());
    rewritten(body[..end].to_vec(), &mut |element| on_sheet(element))
}

fn on_sheet(element: Element) -> Vec<Node> {
    // A still goes, the line that says where the live one is stays; the link in it has nowhere to lead.
    if element.has_class("still") {
        let words = |node: &Node| node.element().is_some_and(|element| element.has_class("live-words"));
        return element.children.into_iter().filter(words).collect();
    }
    let dropped = ["program", "to-end"].iter().any(|class| element.has_class(class));
    match element.name.as_str() {
        _ if dropped => Vec::new(),
        "h1" => Vec::new(),
        // The list of references stays in the book.
        "a" if element.get("href").is_some_and(|to| to.contains("references")) => {
            [vec![Node::Text("[".into())], element.children, vec![Node::Text("]".into())]].concat()
        }
        "a" => element.children,
        _ => vec![element.into()],
    }
}
