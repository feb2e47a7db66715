//! The title page, and the picture on the cover.

use super::ink;
use super::pages::Paper;
use super::tree::{Node, parse, xml};
use tumbling_site::places::escaped;
use tumbling_site::{files, paths};

/// The cover: a drawing of the book, as a file of its own.
///
/// # Errors
/// A drawing that cannot be read.
pub(super) fn cover(paper: &Paper) -> Result<String, String> {
    let file = paths::figures().join("cover.svg");
    let Some(Node::Element(svg)) = parse(files::text(&file)?.trim())?.pop() else {
        return Err(format!("{} is no drawing", file.display()));
    };
    let mut drawing = ink::fixed(svg);
    for (name, value) in [("x", "60"), ("y", "420"), ("width", "480"), ("height", "400")] {
        drawing.set(name, value);
    }
    Ok(format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 900\">\n\
         <rect width=\"600\" height=\"900\" fill=\"#fffdf9\"/>\n<text x=\"60\" y=\"170\" font-size=\"84\" \
         font-family=\"Georgia,serif\" fill=\"#23211d\">{}</text>\n<text x=\"60\" y=\"230\" font-size=\"30\" \
         font-family=\"Georgia,serif\" fill=\"#23211d\">Why a tossed book flips</text>\n{}\n</svg>\n",
        escaped(&paper.about.title),
        xml(&[drawing.into()])
    ))
}

/// The title page: title, subject, authors and licence.
pub(super) fn page(paper: &Paper) -> String {
    let about = &paper.about;
    format!(
        "<section class=\"title-page\">\n<h1>{}</h1>\n<p class=\"subject\">{}</p>\n<p>{}</p>\n<p class=\"licence\">Text and figures: \
         <a href=\"https://creativecommons.org/licenses/by/4.0/\">CC BY 4.0</a>. Code: MIT or Apache 2.0, at your choice.</p>\n\
         <p class=\"licence\">Each number was computed by the library <code>tumbling</code> and is checked by its tests; where a page moves \
         on the screen, a still stands here.</p>\n</section>",
        escaped(&about.title),
        escaped(&about.description),
        escaped(&about.authors.join(", ")),
    )
}
