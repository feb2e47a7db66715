//! The highlighter of the mdBook that is compiled in, for the languages of the book alone, and the colours of
//! its themes.
//!
//! The highlighter is written into `theme/`, from where mdBook reads it after the preprocessors have run, its
//! own program too. The page's template, `theme/index.hbs`, is mdBook's with changes; a test names them.

use super::palette::Palette;
use crate::site::files::write_changed;
use mdbook_html::theme::Theme;
use mdbook_preprocessor::config::HtmlConfig;
use std::fs;
use std::path::Path;

/// The languages of the book's programs, of the forty-odd that mdBook's highlighter knows: a page weighs a
/// hundred kilobytes less.
const LANGUAGES: [&str; 7] = ["bash", "ini", "json", "plaintext", "python", "rust", "shell"];

/// Writes the highlighter into the folder of the theme.
///
/// # Errors
/// A file that cannot be written, or a highlighter that is not the one that this knows.
pub(super) fn lay_out(theme: &Path) -> Result<(), String> {
    let [script] = originals(["highlight.js"])?;
    write_changed(&theme.join("highlight.js"), highlighter(&script)?.as_bytes())?;
    Ok(())
}

/// The colours of the pages' themes: mdBook's, and over them those of the folder of the theme, if it has any.
///
/// # Errors
/// A file that cannot be read, or a theme without a colour.
pub(super) fn palette(theme: &Path) -> Result<Palette, String> {
    let [variables] = originals(["css/variables.css"])?;
    let ours = fs::read_to_string(theme.join("palette.css")).unwrap_or_default();
    Palette::new(&[&variables, &ours])
}

/// Files of mdBook's own theme.
fn originals<const N: usize>(names: [&str; N]) -> Result<[String; N], String> {
    let cannot = |e: &dyn std::fmt::Display| format!("cannot take the theme from mdBook: {e}");
    let copy = tempfile::TempDir::new().map_err(|e| cannot(&e))?;
    let config = HtmlConfig::default();
    let folder = config.theme_dir(copy.path());
    Theme::copy_theme(&config, copy.path()).map_err(|e| cannot(&e))?;
    let mut texts = names.map(str::to_owned);
    for text in &mut texts {
        *text = fs::read_to_string(folder.join(&*text)).map_err(|e| cannot(&e))?;
    }
    Ok(texts)
}

/// mdBook's highlighter: its licence, its core and our languages.
fn highlighter(original: &str) -> Result<String, String> {
    let mut languages = Vec::new();
    let mut out = String::new();
    for line in original.lines() {
        match line.strip_prefix("hljs.registerLanguage(\"").and_then(|rest| rest.split('"').next()) {
            Some(other) if !LANGUAGES.contains(&other) => continue,
            Some(language) => languages.push(language),
            None => {}
        }
        out.push_str(line);
        out.push('\n');
    }
    if languages != LANGUAGES {
        return Err(format!("mdBook's highlight.js has {languages:?} of the languages {LANGUAGES:?}"));
    }
    if !out.contains("License: BSD-3-Clause") {
        return Err("mdBook's highlight.js does not begin with its licence".into());
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What each line says of which the template has another version, in the order of the lines.
    const CHANGED: [&str; 12] = [
        "<meta name=\"description\"",             // the chapter's name first
        "id=\"mdbook-sidebar-toggle-anchor\"",    // a name for it
        "<iframe class=\"sidebar-iframe-outer\"", // a name for it
        "<div id=\"mdbook-menu-bar\"",            // a landmark
        "<label id=\"mdbook-sidebar-toggle\"",    // a button: a keyboard reaches no label
        "</label>",
        "<h1 class=\"menu-title\">",         // one h1 on a page, the chapter's
        "</div>",                            // the end of the menu bar
        "<div id=\"mdbook-search-wrapper\"", // a landmark
        "id=\"mdbook-searchbar\"",           // a name, and a description that is there
        "<div id=\"mdbook-searchresults-header\"", // announced
        "<main>",                            // where the skip link leads
    ];

    #[test]
    fn the_template_is_that_of_the_mdbook_compiled_in_with_the_changes_that_stand_here() {
        let [theirs] = originals(["index.hbs"]).unwrap();
        let ours = include_str!("../../theme/index.hbs");
        // Line by line: what is not the next of our lines that they have, has changed.
        let mut rest = ours.lines();
        let mut changed = Vec::new();
        for line in theirs.lines() {
            let mut ahead = rest.clone();
            match ahead.by_ref().take(9).position(|own| own == line) {
                Some(_) => {
                    let skipped = rest.clone().position(|own| own == line).unwrap_or(0);
                    rest.nth(skipped);
                }
                None => changed.push(line.trim()),
            }
        }
        assert_eq!(changed.len(), CHANGED.len(), "{changed:#?}");
        for (line, part) in changed.iter().zip(CHANGED) {
            assert!(line.contains(part), "{line} is not the line with {part}");
        }
        assert_eq!(rest.next(), None, "all of ours is read");
        for there in [
            "{{#if (ne base_url \"/\")}}",
            "<a class=\"skip\" href=\"#main\">",
            "<main id=\"main\"",
            "id=\"code-toggle\"",
            "role=\"status\"",
        ] {
            assert!(ours.contains(there), "{there}");
        }
    }

    #[test]
    fn the_highlighter_is_that_of_the_mdbook_compiled_in_for_our_languages() {
        let folder = tempfile::TempDir::new().unwrap();
        lay_out(folder.path()).unwrap();
        let script = fs::read_to_string(folder.path().join("highlight.js")).unwrap();
        assert!(script.contains("Highlight.js") && script.len() < 30_000, "{}", script.len());
    }

    #[test]
    fn a_highlighter_without_its_licence_or_a_language_is_refused() {
        let languages =
            LANGUAGES.map(|language| format!("hljs.registerLanguage(\"{language}\",0);\n")).concat();
        let whole = format!("/* License: BSD-3-Clause */\nvar hljs;\n{languages}");
        let more = whole.replacen("hljs.reg", "hljs.registerLanguage(\"apache\",0);\nhljs.reg", 1);
        assert_eq!(highlighter(&more).as_ref(), Ok(&whole));
        assert!(highlighter(&languages).unwrap_err().contains("licence"));
        assert!(highlighter(&whole.replace("\"rust\"", "\"rost\"")).unwrap_err().contains("languages"));
    }
}
