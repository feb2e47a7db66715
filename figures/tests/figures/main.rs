//! Tests of figures and films by theme, as one program, since each one more is linked on its own:
//! `cargo test -p tumbling-figures --test figures film` runs a part.

mod drawings;
mod exported;
mod film;
mod of_body;

use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The book's figures, drawn once.
static DRAWN: LazyLock<BTreeMap<&str, String>> = LazyLock::new(|| {
    let drawn = |figure: &tumbling_figures::Figure| (figure.name, figure.draw().expect(figure.name));
    tumbling_figures::registry().iter().map(drawn).collect()
});
