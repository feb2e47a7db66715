//! What stands on paper for a widget: a drawing of what it shows, and a line that says where the live one is.

use super::ink;
use super::tree::{Element, Node, parse};
use crate::site::{files, paths};
use std::collections::BTreeSet;

/// A widget and what is to be seen on paper in its place.
struct Still {
    widget: &'static str,
    /// The name of a figure, for a widget without a still of its own. If its page shows it, a link leads
    /// there; otherwise it stands here.
    figure: &'static str,
    /// What the reader can do with the live one, after "On the screen you can".
    live: &'static str,
}

const STILLS: [Still; 14] = [
    Still {
        widget: "toss",
        figure: "three-tosses",
        live: "toss the book about each of its axes, and watch it",
    },
    Still { widget: "tosses", figure: "three-tosses", live: "set the error of the hand, and toss" },
    Still { widget: "two-arrows", figure: "two-arrows", live: "turn the spin yourself, for six bodies" },
    Still { widget: "your-box", figure: "box-arrows", live: "choose the edges and the spin of the box" },
    Still {
        widget: "your-body",
        figure: "polhodes",
        live: "describe a body of your own; the command `cargo run -- report FILE.toml` does the same",
    },
    Still { widget: "top", figure: "a-top", live: "set the spin, the lean and the push of the top" },
    Still { widget: "turning", figure: "turning-tensor", live: "turn the box and read its tensor" },
    Still { widget: "pitfalls", figure: "engines-paths", live: "watch the four engines side by side" },
    Still {
        widget: "tumble",
        figure: "three-spins",
        live: "choose a body and a push, and watch it turn over",
    },
    Still {
        widget: "trading",
        figure: "three-spins",
        live: "choose the spin, and watch the components exchange energy",
    },
    Still { widget: "coin", figure: "coin", live: "let the plate wobble, and count its turns" },
    Still { widget: "why", figure: "polhodes", live: "let the rods go, and watch what pulls at them" },
    Still { widget: "steps", figure: "four-steps", live: "choose a method and the length of a step" },
    Still {
        widget: "judge",
        figure: "judged-grades",
        live: "drop a record of your engine; the command `cargo run -p tumbling-judge -- FILE.csv` does the same",
    },
];

/// What stands in this page for a widget; `shown` are the figures that the page has.
///
/// # Errors
/// A widget without a still, or a drawing that cannot be read.
pub(super) fn of(widget: &str, page: &str, shown: &BTreeSet<String>) -> Result<Vec<Node>, String> {
    let still = STILLS.iter().find(|still| still.widget == widget);
    let still = still.ok_or_else(|| format!("the widget `{widget}` has no still for paper"))?;
    let mut inside = Vec::new();
    let mut elsewhere = String::new();
    if let Some(own) = tumbling_figures::still(widget) {
        inside.push(framed(&own.map_err(|e| format!("the still of `{widget}`: {e}"))?)?);
    } else if shown.contains(still.figure) {
        elsewhere = format!(" Its still is <a href=\"#fig-{}\">a figure of this chapter</a>.", still.figure);
    } else {
        inside.push(drawing(still.figure, page)?);
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
