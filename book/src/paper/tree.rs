//! The HTML of a page as a tree, and a tree as XHTML.
//!
//! Reads what mdBook writes: every element closed, apart from those that never have content.

/// An element, or the text between two.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Node {
    Element(Element),
    /// As written, with its character references.
    Text(String),
}

#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Element {
    pub(super) name: String,
    /// Names and values, the values as written.
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

    /// Its text, with character references.
    pub(super) fn text(&self) -> String {
        text(&self.children)
    }
}

impl From<Element> for Node {
    fn from(element: Element) -> Self {
        Self::Element(element)
    }
}

/// The text of these nodes, with character references.
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
/// An element that is not closed where it should be, or a tag that does not end.
pub(super) fn parse(html: &str) -> Result<Vec<Node>, String> {
    let mut open = vec![Element::default()];
    let mut rest = html;
    while let Some(at) = rest.find('<') {
        push_text(&mut open, &rest[..at]);
        rest = &rest[at..];
        if let Some(comment) = rest.strip_prefix("<!") {
            let close = if comment.starts_with("--") { "-->" } else { ">" };
            rest = comment.split_once(close).ok_or("a comment that does not end")?.1;
        } else if let Some(tag) = rest.strip_prefix("</") {
            let (name, after) = tag.split_once('>').ok_or("a tag that does not end")?;
            close(&mut open, name.trim())?;
            rest = after;
        } else {
            let (element, closed, after) = opening(&rest[1..])?;
            rest = after;
            let raw = element.name == "script" && !closed;
            let empty = closed || EMPTY.contains(&element.name.as_str());
            open.push(element);
            if raw {
                rest = rest.find("</script>").map(|end| &rest[end..]).ok_or("a script that does not end")?;
            }
            if empty {
                let name = open.last().map(|element| element.name.clone()).unwrap_or_default();
                close(&mut open, &name)?;
            }
        }
    }
    push_text(&mut open, rest);
    match (open.pop(), open.as_slice()) {
        (Some(root), []) => Ok(root.children),
        (Some(left), _) => Err(format!("<{}> is not closed", left.name)),
        (None, _) => Err("more elements are closed than opened".into()),
    }
}

fn push_text(open: &mut [Element], text: &str) {
    if let (Some(parent), false) = (open.last_mut(), text.is_empty()) {
        parent.children.push(Node::Text(text.to_owned()));
    }
}

fn close(open: &mut Vec<Element>, name: &str) -> Result<(), String> {
    match (open.pop(), open.last_mut()) {
        (Some(element), Some(parent)) if element.name == name => {
            parent.children.push(element.into());
            Ok(())
        }
        (Some(element), _) => Err(format!("</{name}> closes <{}>", element.name)),
        (None, _) => Err(format!("</{name}> closes nothing")),
    }
}

/// The element that a tag opens, whether the tag closes it too, and what follows.
fn opening(tag: &str) -> Result<(Element, bool, &str), String> {
    let end = |c: char| c.is_whitespace() || c == '>' || c == '/';
    let at = tag.find(end).ok_or("a tag that does not end")?;
    let mut element = Element::new(&tag[..at], &[], Vec::new());
    let mut rest = tag[at..].trim_start();
    loop {
        if let Some(after) = rest.strip_prefix("/>") {
            return Ok((element, true, after));
        }
        if let Some(after) = rest.strip_prefix('>') {
            return Ok((element, false, after));
        }
        let at = rest.find(|c: char| end(c) || c == '=').filter(|at| *at > 0);
        let at = at.ok_or_else(|| format!("<{}> has an attribute that cannot be read", element.name))?;
        let name = &rest[..at];
        rest = rest[at..].trim_start();
        let mut value = "";
        if let Some(after) = rest.strip_prefix('=') {
            let quote = after.chars().next().filter(|c| "\"'".contains(*c));
            let quote = quote.ok_or_else(|| format!("{name} of <{}> has no quotes", element.name))?;
            (value, rest) = after[1..].split_once(quote).ok_or("a value that does not end")?;
            rest = rest.trim_start();
        }
        element.attributes.push((name.to_owned(), value.replace('<', "&lt;")));
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
        Node::Text(text) => out.push_str(text),
        Node::Element(element) => {
            out.push('<');
            out.push_str(&element.name);
            for (name, value) in &element.attributes {
                out.push_str(&format!(" {name}=\"{}\"", value.replace('"', "&quot;")));
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
        let html = "a <b class='x y' hidden>1 &lt; 2<br></b><!-- no --><svg><path d=\"M0\" /></svg><script>if (a < b) {}</script>";
        let nodes = parse(html).unwrap();
        assert_eq!(
            xml(&nodes),
            "a <b class=\"x y\" hidden=\"\">1 &lt; 2<br/></b><svg><path d=\"M0\"></path></svg><script></script>"
        );
        assert_eq!(text(&nodes), "a 1 &lt; 2");
        let mut names = Vec::new();
        each(&nodes, &mut |element| names.push(element.name.as_str()));
        assert_eq!(names, ["b", "br", "svg", "path", "script"]);
        let bare = rewritten(nodes, &mut |e| if e.name == "b" { e.children } else { Vec::new() });
        assert_eq!(xml(&bare), "a 1 &lt; 2");
    }

    #[test]
    fn what_is_not_closed_is_refused() {
        for (html, what) in [
            ("<b>", "<b> is not closed"),
            ("<b></i>", "</i> closes <b>"),
            ("</b>", "closes"),
            ("<b", "does not end"),
            ("<b a=1>", "no quotes"),
            ("<!-- ", "does not end"),
        ] {
            assert!(parse(html).unwrap_err().contains(what), "{html}: {:?}", parse(html));
        }
    }
}
