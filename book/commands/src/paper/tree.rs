//! The HTML of a page as a tree, and a tree as XHTML.
//!
//! Reads what mdBook writes: every element closed, apart from those that never have content.

use html5ever::tokenizer::states::RawKind;
use html5ever::tokenizer::{
    BufferQueue, TagKind, Token, TokenSink, TokenSinkResult, Tokenizer, TokenizerOpts,
};
use std::cell::RefCell;
use tumbling_site::places::escaped;

/// An element, or the text between two.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Node {
    Element(Element),
    Text(String),
}

#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) attributes: Vec<(String, String)>,
    pub(super) children: Vec<Node>,
}

/// Elements without content, which HTML leaves open.
const EMPTY: [&str; 13] =
    ["area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"];

impl Element {
    pub(super) fn new(name: &str, attributes: &[(&str, &str)], children: Vec<Node>) -> Self {
        let attributes = attributes.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned()));
        Self { name: name.to_owned(), attributes: attributes.collect(), children }
    }

    pub(super) fn get(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(of, _)| of == name).map(|(_, value)| value.as_str())
    }

    pub(super) fn set(&mut self, name: &str, value: &str) {
        self.attributes.retain(|(of, _)| of != name);
        self.attributes.push((name.to_owned(), value.to_owned()));
    }

    pub(super) fn has_class(&self, class: &str) -> bool {
        self.get("class").is_some_and(|all| all.split_whitespace().any(|one| one == class))
    }

    pub(super) fn text(&self) -> String {
        text(&self.children)
    }
}

impl Node {
    pub(super) fn element(&self) -> Option<&Element> {
        match self {
            Self::Element(element) => Some(element),
            Self::Text(_) => None,
        }
    }

    /// Whether it is an element of this name.
    pub(super) fn is(&self, name: &str) -> bool {
        self.element().is_some_and(|element| element.name == name)
    }
}

impl From<Element> for Node {
    fn from(element: Element) -> Self {
        Self::Element(element)
    }
}

/// The text of these nodes.
pub(super) fn text(nodes: &[Node]) -> String {
    let parts = nodes.iter().map(|node| match node {
        Node::Element(element) => element.text(),
        Node::Text(text) => text.clone(),
    });
    parts.collect()
}

/// Reads HTML.
///
/// # Errors
/// An element that is not closed where it should be.
pub(super) fn parse(html: &str) -> Result<Vec<Node>, String> {
    let reading = Reading { open: RefCell::new(vec![Element::default()]), wrong: RefCell::default() };
    let tokenizer = Tokenizer::new(reading, TokenizerOpts::default());
    let input = BufferQueue::default();
    input.push_back(html.into());
    let _ = tokenizer.feed(&input); // it stops early for no tag of ours
    tokenizer.end();
    let Reading { open, wrong } = tokenizer.sink;
    match (wrong.into_inner(), open.into_inner().as_mut_slice()) {
        (Some(wrong), _) => Err(wrong),
        (None, [root]) => Ok(std::mem::take(&mut root.children)),
        (None, left) => {
            Err(left.last().map_or_else(String::new, |left| format!("<{}> is not closed", left.name)))
        }
    }
}

/// The elements that are open, from the outermost, and the first thing that is wrong.
struct Reading {
    open: RefCell<Vec<Element>>,
    wrong: RefCell<Option<String>>,
}

impl Reading {
    fn put(&self, node: Node) {
        if let Some(parent) = self.open.borrow_mut().last_mut() {
            parent.children.push(node);
        }
    }

    fn close(&self, name: &str) {
        let element = self.open.borrow_mut().pop_if(|element| element.name == name);
        match element {
            Some(element) => self.put(element.into()),
            None => drop(self.wrong.borrow_mut().get_or_insert(format!("</{name}> closes another element"))),
        }
    }
}

impl TokenSink for Reading {
    type Handle = ();

    fn process_token(&self, token: Token, _line: u64) -> TokenSinkResult<()> {
        match token {
            Token::CharacterTokens(text) => self.put(Node::Text(text.to_string())),
            Token::TagToken(tag) if tag.kind == TagKind::EndTag => self.close(&tag.name),
            Token::TagToken(tag) => {
                let attributes = tag.attrs.iter().map(|it| (it.name.local.to_string(), it.value.to_string()));
                let name = tag.name.to_string();
                let element = Element { name, attributes: attributes.collect(), children: Vec::new() };
                self.open.borrow_mut().push(element);
                if tag.self_closing || EMPTY.contains(&&*tag.name) {
                    self.close(&tag.name);
                } else if *tag.name == *"script" {
                    return TokenSinkResult::RawData(RawKind::ScriptData);
                }
            }
            _ => {}
        }
        TokenSinkResult::Continue
    }
}

/// The nodes as XHTML.
pub(super) fn xml(nodes: &[Node]) -> String {
    let mut out = String::new();
    for node in nodes {
        write(node, &mut out);
    }
    out
}

fn write(node: &Node, out: &mut String) {
    match node {
        Node::Text(text) => out.push_str(&escaped(text)),
        Node::Element(element) => {
            out.push('<');
            out.push_str(&element.name);
            for (name, value) in &element.attributes {
                out.push_str(&format!(" {name}=\"{}\"", escaped(value)));
            }
            // As HTML too, only these may be closed by their own tag; elements of SVG and MathML may all be.
            if element.children.is_empty() && EMPTY.contains(&element.name.as_str()) {
                out.push_str("/>");
                return;
            }
            out.push('>');
            element.children.iter().for_each(|child| write(child, out));
            out.push_str(&format!("</{}>", element.name));
        }
    }
}

/// Puts what `change` returns in place of each element, its children first.
pub(super) fn rewritten(nodes: Vec<Node>, change: &mut dyn FnMut(Element) -> Vec<Node>) -> Vec<Node> {
    let mut out = Vec::with_capacity(nodes.len());
    for node in nodes {
        match node {
            Node::Element(mut element) => {
                element.children = rewritten(element.children, change);
                out.extend(change(element));
            }
            text @ Node::Text(_) => out.push(text),
        }
    }
    out
}

/// Calls `see` with each element, those outside first.
pub(super) fn each<'a>(nodes: &'a [Node], see: &mut dyn FnMut(&'a Element)) {
    for node in nodes {
        if let Node::Element(element) = node {
            see(element);
            each(&element.children, see);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn html_comes_back_as_xhtml() {
        let html = "a <b class='x y' title=\"&quot;\" hidden>1 &lt; 2<br></b><!-- no --><svg><path d=\"M0\" /></svg><script>a < b</script>";
        let nodes = parse(html).unwrap();
        assert_eq!(
            xml(&nodes),
            "a <b class=\"x y\" title=\"&quot;\" hidden=\"\">1 &lt; 2<br/></b><svg><path d=\"M0\"></path></svg><script>a &lt; b</script>"
        );
        assert_eq!(text(&nodes), "a 1 < 2a < b");
        let mut names = Vec::new();
        each(&nodes, &mut |element| names.push(element.name.as_str()));
        assert_eq!(names, ["b", "br", "svg", "path", "script"]);
        let bare = rewritten(nodes, &mut |e| if e.name == "b" { e.children } else { Vec::new() });
        assert_eq!(xml(&bare), "a 1 &lt; 2");
    }

    #[test]
    fn what_is_not_closed_is_refused() {
        for (html, what) in
            [("<b>", "<b> is not closed"), ("<b></i>", "</i> closes another"), ("</b>", "closes another")]
        {
            assert!(parse(html).unwrap_err().contains(what), "{html}: {:?}", parse(html));
        }
    }
}
