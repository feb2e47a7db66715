//! A page on paper, and the form of a fold on it.

use super::tree::{Element, Node};

/// A page of the book.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Page {
    /// The name of its file without the ending; links lead to `NAME.html`.
    pub(super) name: String,
    pub(super) title: String,
    /// The number of a chapter.
    pub(super) number: Option<String>,
    pub(super) body: Vec<Node>,
}

/// A fold as it is when open, under its own words.
pub(super) fn opened(fold: Element, class: &str) -> Node {
    let mut children = fold.children;
    for child in &mut children {
        if let Node::Element(summary) = child
            && summary.name == "summary"
        {
            *summary = Element::new("p", &[("class", "summary")], std::mem::take(&mut summary.children));
        }
    }
    Element::new("div", &[("class", class)], children).into()
}
