//! The fonts of exported drawings.

use resvg::usvg::fontdb::Database;
use resvg::usvg::{Group, Node, Options};
use std::sync::{Arc, LazyLock};

/// The family of running text, upright, in two weights.
pub const SANS: &str = "Tumbling Sans";

/// The family of symbols, italic, in two weights.
pub const SYMBOLS: &str = "Tumbling Symbols";

const FILES: [&[u8]; 4] = [
    include_bytes!("../fonts/tumbling-sans.otf"),
    include_bytes!("../fonts/tumbling-sans-semibold.otf"),
    include_bytes!("../fonts/tumbling-symbols.ttf"),
    include_bytes!("../fonts/tumbling-symbols-bold.ttf"),
];

/// These fonts and no others, so that every machine draws the same letters.
static FONTS: LazyLock<Arc<Database>> = LazyLock::new(|| {
    let mut fonts = Database::new();
    FILES.iter().for_each(|file| fonts.load_font_data(file.to_vec()));
    Arc::new(fonts)
});

/// How drawings are read.
pub(crate) fn options() -> Options<'static> {
    Options { fontdb: Arc::clone(&FONTS), font_family: SANS.into(), ..Options::default() }
}

/// The letters of all text in a group that no font has.
pub(crate) fn lacking(group: &Group) -> String {
    let of = |node: &Node| match node {
        Node::Group(group) => lacking(group),
        Node::Text(text) => {
            let glyphs = text.layouted().iter().flat_map(|span| &span.positioned_glyphs);
            glyphs.filter(|glyph| glyph.id.0 == 0).map(|glyph| glyph.text.as_str()).collect()
        }
        Node::Path(_) | Node::Image(_) => String::new(),
    };
    group.children().iter().map(of).collect()
}
