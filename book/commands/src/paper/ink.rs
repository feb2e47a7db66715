//! Drawings in fixed colours, for places without a style sheet.

use super::tree::{Element, Node, rewritten};

/// The colour that replaces the colour of the text.
const TEXT: &str = "#1f2328";

/// The drawing with each `var(--name,value)` replaced by its value, and the text's colour replaced by ours.
pub(super) fn fixed(drawing: Element) -> Element {
    let mut fixed = drawing;
    recolour(&mut fixed);
    fixed.children = rewritten(std::mem::take(&mut fixed.children), &mut |mut element| {
        // The colours of a drawing that is opened by itself.
        if element.name == "style" {
            return Vec::new();
        }
        recolour(&mut element);
        vec![Node::Element(element)]
    });
    fixed
}

fn recolour(element: &mut Element) {
    for (name, value) in &mut element.attributes {
        // HTML has it in small letters, and reads it as meant; XHTML does not.
        if name == "viewbox" {
            *name = "viewBox".into();
        }
        if value.contains("var(") || value.contains("currentColor") {
            *value = resolved(value).replace("currentColor", TEXT);
        }
    }
}

/// The text with the value given in each `var()` in its place; nothing where there is none.
fn resolved(style: &str) -> String {
    let Some((before, after)) = style.split_once("var(") else { return style.to_owned() };
    let mut depth = 1_usize;
    let end = after.find(|c| {
        depth = match c {
            '(' => depth + 1,
            ')' => depth - 1,
            _ => depth,
        };
        depth == 0
    });
    let (inside, rest) = end.map_or((after, ""), |end| (&after[..end], &after[end + 1..]));
    let value = inside.split_once(',').map_or("", |(_, value)| value.trim());
    format!("{before}{}{}", resolved(value), resolved(rest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::tree::{parse, xml};

    #[test]
    fn a_drawing_has_its_own_colours() {
        let svg = "<svg viewbox=\"0 0 1 1\" style=\"font-family:var(--f,system-ui,serif);min-width:0\"><style>svg:root{--f:x}</style>\
                   <path style=\"fill:var(--a,var(--b, #123456));stroke:currentColor\"></path></svg>";
        let Some(Node::Element(svg)) = parse(svg).unwrap().pop() else { panic!("no drawing") };
        let plain = "<svg viewBox=\"0 0 1 1\" style=\"font-family:system-ui,serif;min-width:0\">\
                     <path style=\"fill:#123456;stroke:#1f2328\"></path></svg>";
        assert_eq!(xml(&[fixed(svg).into()]), plain);
    }
}
