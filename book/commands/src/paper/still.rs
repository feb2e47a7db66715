//! The replacement for a widget on paper: a drawing of its contents, and a line with the place of the live
//! one.

use super::ink;
use super::tree::{Element, Node, parse};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use tumbling_site::{files, paths};

/// The replacement of one widget: a row of `book/paper/stills.toml`.
#[derive(Deserialize)]
struct Still {
    figure: String,
    live: String,
}

/// The replacement for a widget in this page; `shown` are the figures that the page has.
///
/// # Errors
/// A widget without a still, or a drawing that cannot be read.
pub(super) fn of(widget: &str, page: &str, shown: &BTreeSet<String>) -> Result<Vec<Node>, String> {
    let stills: BTreeMap<String, Still> = toml::from_str(include_str!("../../../paper/stills.toml"))
        .map_err(|e| format!("book/paper/stills.toml: {e}"))?;
    let still = stills.get(widget);
    let still = still.ok_or_else(|| format!("the widget `{widget}` has no still for paper"))?;
    let mut inside = Vec::new();
    let mut elsewhere = String::new();
    if let Some(own) = tumbling_figures::still(widget) {
        inside.push(framed(&own.map_err(|e| format!("the still of `{widget}`: {e}"))?)?);
    } else if shown.contains(&still.figure) {
        elsewhere = format!(" Its still is <a href=\"#fig-{}\">a figure of this chapter</a>.", still.figure);
    } else {
        inside.push(drawing(&still.figure, page)?);
    }
    let live = still.live.replacen('`', "<code>", 1).replacen('`', "</code>", 1);
    let words =
        format!("<p class=\"live-words\">On the screen, in {page}.html, you can {live}.{elsewhere}</p>");
    inside.extend(parse(&words)?);
    Ok(vec![Element::new("div", &[("class", "still"), ("id", &format!("live-{widget}"))], inside).into()])
}

/// A figure's drawing, with ids of its own: the figure itself may stand elsewhere in the book.
fn drawing(figure: &str, page: &str) -> Result<Node, String> {
    let svg = files::text(&paths::figures().join(format!("{figure}.svg")))?;
    let own = format!("{page}-{figure}-");
    let svg = svg.replace(&format!("\"{figure}-"), &format!("\"{own}"));
    framed(&svg.replace(&format!(" {figure}-desc\""), &format!(" {own}desc\"")))
}

fn framed(svg: &str) -> Result<Node, String> {
    match parse(svg.trim())?.pop() {
        Some(Node::Element(svg)) => {
            Ok(Element::new("figure", &[("class", "fig")], vec![ink::fixed(svg).into()]).into())
        }
        _ => Err("a still that is no drawing".into()),
    }
}
