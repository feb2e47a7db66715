//! The laws that each chapter states, in its order, and its maths that states nothing: `equations.toml`.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::OnceLock;
use tumbling_proofs::equations::laws::{ALL, Law};
use tumbling_proofs::equations::{Exemption, Expected};
use tumbling_site::{files, paths};

/// The entries of `equations.toml` for a piece of maths.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    chapter: String,
    tex: String,
    why: String,
    proof: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Lists {
    laws: BTreeMap<String, String>,
    exempt: Vec<Line>,
    notation: Vec<Line>,
}

/// The entries for a chapter.
fn own(lines: &'static [Line], chapter: &str) -> &'static [Exemption] {
    let of = lines.iter().filter(|line| line.chapter == chapter);
    of.map(|line| Exemption { tex: &line.tex, reason: &line.why, proof: line.proof.as_deref() })
        .collect::<Vec<_>>()
        .leak()
}

/// The laws of these names.
fn named(names: &str) -> Result<&'static [Law], String> {
    let named = |name: &str| {
        let known = ALL.iter().find(|(own, _)| *own == name).map(|(_, law)| *law);
        known.ok_or_else(|| format!("book/equations.toml: there is no law `{name}`"))
    };
    Ok(names.split_whitespace().map(named).collect::<Result<Vec<_>, _>>()?.leak())
}

/// What each chapter that has laws must state.
///
/// # Errors
/// `equations.toml` cannot be read, at which line and why.
pub(super) fn all() -> Result<&'static [(&'static str, Expected)], String> {
    static ALL: OnceLock<Result<Vec<(&str, Expected)>, String>> = OnceLock::new();
    let all = ALL.get_or_init(|| {
        let text = files::text(&paths::book().join("equations.toml"))?;
        let Lists { laws, exempt, notation } = &*Box::leak(Box::new(read(&text)?));
        let of = |(name, laws): (&'static String, &'static String)| {
            let (laws, exemptions, notation) = (named(laws)?, own(exempt, name), own(notation, name));
            Ok((name.as_str(), Expected { laws, exemptions, notation }))
        };
        laws.iter().map(of).collect()
    });
    all.as_deref().map_err(String::clone)
}

/// The laws and exemptions that a chapter must have.
///
/// # Errors
/// Those of [`all`].
pub(super) fn of(chapter: &str) -> Result<Expected, String> {
    Ok(all()?.iter().find(|known| known.0 == chapter).map_or(Expected::NOTHING, |known| known.1))
}

fn read(text: &str) -> Result<Lists, String> {
    toml::from_str(text).map_err(|e| format!("book/equations.toml: {e}"))
}

#[cfg(test)]
mod tests {
    use super::{named, read};

    #[test]
    fn a_broken_list_of_equations_is_named_with_its_line_and_what_is_wrong() {
        let right = "[laws]\na = \"WOBBLE\"\n[[exempt]]\nchapter = \"a\"\ntex = 'x'\nwhy = 'y'\n[[notation]]\nchapter = \"a\"\ntex = 'z'\nwhy = 'y'\n";
        assert!(read(right).is_ok());
        for (from, to, at) in [("why", "whi", 6), ("'z'", "'z", 9), ("[not", "[nut", 7), ("tex", "", 5)] {
            let wrong = read(&right.replacen(from, to, 1)).err().unwrap_or_default();
            let says = format!("book/equations.toml: TOML parse error at line {at},");
            assert!(wrong.contains(&says), "{wrong}");
        }
    }
    #[test]
    fn laws_stand_in_their_order_and_one_that_there_is_not_is_named() {
        let lefts = |names| named(names).map(|laws| laws.iter().map(|law| law.left).collect::<Vec<_>>());
        assert_eq!(lefts("ENERGY\nWOBBLE ENERGY"), Ok(vec!["E", r"\lambda^2", "E"]));
        assert!(lefts("ENERGY WABBLE").unwrap_err().contains("no law `WABBLE`"));
    }
}
