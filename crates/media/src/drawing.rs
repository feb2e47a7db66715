//! A drawing, as read, and as an SVG that every program can show.

use crate::error::Error;
use crate::letters;
use resvg::usvg::{Tree, WriteOptions};

/// An SVG drawing with its text laid out, its title and its description.
#[derive(Debug)]
pub struct Drawing {
    pub(crate) tree: Tree,
    pub(crate) title: String,
    pub(crate) description: String,
}

/// Colour syntax that only a browser understands: in other programs such a colour is black or missing.
const BROWSERS_OWN: [&str; 3] = ["var(", "currentColor", "<style"];

impl Drawing {
    /// Reads an SVG document.
    ///
    /// # Errors
    /// Input that is not SVG, colours that depend on the page around the drawing, or characters that the
    /// fonts lack.
    pub fn read(svg: &str) -> Result<Self, Error> {
        if let Some(what) = BROWSERS_OWN.into_iter().find(|what| svg.contains(what)) {
            return Err(Error(format!("the drawing has `{what}`, which only a browser understands")));
        }
        let tree = Tree::from_str(svg, &letters::options()).map_err(|e| Error::new("the drawing", e))?;
        let lacking = letters::lacking(tree.root());
        if !lacking.is_empty() {
            return Err(Error(format!("the fonts of exported drawings have no letters for `{lacking}`")));
        }
        Ok(Self { tree, title: element(svg, "title"), description: element(svg, "desc") })
    }

    /// Its width and height, in pixels of CSS: 96 to the inch.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        [f64::from(self.tree.size().width()), f64::from(self.tree.size().height())]
    }

    /// The drawing as SVG with colours as attributes and letters as outlines, so that it needs neither a
    /// style sheet nor a font. Its width is this many pixels, or its own width by default.
    #[must_use]
    pub fn svg(&self, width: Option<u32>) -> String {
        let how = WriteOptions { coordinates_precision: 3, transforms_precision: 5, ..Default::default() };
        let whole = self.tree.to_string(&how);
        let inside = whole.split_once('>').map_or("", |(_, rest)| rest).trim_start();
        let [w, h] = self.size();
        let scale = width.map_or(1.0, |width| f64::from(width) / w);
        let (wide, high) = (w * scale, h * scale);
        let words =
            [("title", &self.title), ("desc", &self.description)].into_iter().filter(|of| !of.1.is_empty());
        let words: String = words.map(|(name, words)| format!("<{name}>{words}</{name}>\n")).collect();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{wide}\" height=\"{high}\" viewBox=\"0 0 {w} {h}\">\n{words}{}",
            inside.replace("    <defs/>\n", "").replace("    ", " ")
        )
    }
}

/// The content of the first element of this name, as it is written.
fn element(svg: &str, name: &str) -> String {
    let found = svg.split_once(&format!("<{name}")).and_then(|(_, rest)| {
        let (_, content) = rest.split_once('>')?;
        Some(content.split_once(&format!("</{name}>"))?.0.to_owned())
    });
    found.unwrap_or_default()
}

/// Text as it was before it was written into a document.
pub(crate) fn plain(text: &str) -> String {
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
}
