//! The page template and the highlighter of the mdBook that is compiled in, with our edits.
//!
//! Both are written into `theme/`, from where mdBook reads them after the preprocessors have run, its own
//! program too.

use super::edits::Edits;
use super::palette::Palette;
use crate::files::write_changed;
use mdbook_html::theme::Theme;
use mdbook_preprocessor::config::HtmlConfig;
use std::fs;
use std::path::Path;

/// What stands exactly once in mdBook's template, and what takes its place.
const TEMPLATE: [(&str, &str); 11] = [
    // A base only where one was set: mdBook's default, `/`, would break the page for unknown addresses on
    // every disk and on most sites.
    (
        "<base href=\"{{ base_url }}\">\n",
        "{{#if (ne base_url \"/\")}}\n        <base href=\"{{ base_url }}\">\n        {{/if}}\n",
    ),
    // A skip link as the first stop of the keyboard.
    ("    <body>\n", "    <body>\n    <a class=\"skip\" href=\"#main\">Skip to the text</a>\n"),
    // Where the skip link leads.
    ("<main>", "<main id=\"main\" tabindex=\"-1\">"),
    // A name for the sidebar's checkbox.
    (
        "id=\"mdbook-sidebar-toggle-anchor\" class=\"hidden\"",
        "id=\"mdbook-sidebar-toggle-anchor\" class=\"hidden\" aria-label=\"Table of contents\"",
    ),
    // A name for the contents without scripts.
    (
        "<iframe class=\"sidebar-iframe-outer\"",
        "<iframe class=\"sidebar-iframe-outer\" title=\"Table of contents\"",
    ),
    // The menu bar is a landmark.
    (
        "<div id=\"mdbook-menu-bar\" class=\"menu-bar sticky\">",
        "<div id=\"mdbook-menu-bar\" class=\"menu-bar sticky\" role=\"banner\">",
    ),
    // The menu button is a button: a keyboard reaches no <label>. `reader.js` passes its click on to the
    // checkbox.
    (
        "<label id=\"mdbook-sidebar-toggle\" class=\"icon-button\" for=\"mdbook-sidebar-toggle-anchor\"",
        "<button id=\"mdbook-sidebar-toggle\" class=\"icon-button\" type=\"button\"",
    ),
    // The end of the menu button, and a label in its place without scripts.
    (
        "                        </label>\n",
        "                        </button>
                        <noscript>
                            <label id=\"sidebar-toggle-label\" class=\"icon-button\" \
                                   for=\"mdbook-sidebar-toggle-anchor\" title=\"Table of Contents\">
                                {{fa \"solid\" \"bars\"}}
                            </label>
                        </noscript>\n",
    ),
    // One h1 on a page, the chapter's.
    ("<h1 class=\"menu-title\">{{ book_title }}</h1>", "<div class=\"menu-title\">{{ book_title }}</div>"),
    // A button that opens all code.
    (
        "                    <div class=\"right-buttons\">\n",
        "                    <div class=\"right-buttons\">
                        <button id=\"code-toggle\" class=\"icon-button\" type=\"button\" hidden \
                                title=\"Show the code, or fold it away\" aria-label=\"Code\" aria-pressed=\"false\">
                            {{fa \"solid\" \"code\"}}
                        </button>\n",
    ),
    // The search field has a name, and its description is there.
    (
        "aria-describedby=\"searchresults-header\"",
        "aria-label=\"Search this book\" aria-describedby=\"mdbook-searchresults-header\"",
    ),
];

/// The languages of the book's programs, of the forty-odd that mdBook's highlighter knows: a page weighs a
/// hundred kilobytes less.
const LANGUAGES: [&str; 7] = ["bash", "ini", "json", "plaintext", "python", "rust", "shell"];

/// Writes the template and the highlighter into the folder of the theme.
///
/// # Errors
/// A file that cannot be written, or an edit that does not fit the mdBook that is compiled in.
pub(super) fn lay_out(theme: &Path) -> Result<(), String> {
    let [page, script] = originals(["index.hbs", "highlight.js"])?;
    write_changed(&theme.join("index.hbs"), template(&page)?.as_bytes())?;
    write_changed(&theme.join("highlight.js"), highlighter(&script)?.as_bytes())?;
    Ok(())
}

/// The colours of the pages' themes: mdBook's, and over them those of the folder of the theme, if it has any.
///
/// # Errors
/// A file that cannot be read.
pub(super) fn palette(theme: &Path) -> Result<Palette, String> {
    let [variables] = originals(["css/variables.css"])?;
    let ours = fs::read_to_string(theme.join("palette.css")).unwrap_or_default();
    Ok(Palette::new(&[&variables, &ours]))
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

/// mdBook's template with our edits.
fn template(original: &str) -> Result<String, String> {
    let mut edits = Edits::default();
    for (sought, replacement) in &TEMPLATE {
        let places: Vec<usize> = original.match_indices(sought).map(|(at, _)| at).collect();
        let [at] = places[..] else {
            return Err(format!("`{sought}` is in mdBook's index.hbs {} times, not once", places.len()));
        };
        edits.replace(at..at + sought.len(), (*replacement).to_owned());
    }
    Ok(edits.applied_to(original))
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

    /// A template with what each edit looks for.
    fn sought() -> String {
        TEMPLATE.iter().map(|(sought, _)| format!("{sought}~")).collect()
    }

    #[test]
    fn the_edits_fit_the_mdbook_that_is_compiled_in() {
        let folder = tempfile::TempDir::new().unwrap();
        lay_out(folder.path()).unwrap();
        let [page, script] = ["index.hbs", "highlight.js"].map(|name| folder.path().join(name));
        let page = fs::read_to_string(page).unwrap();
        for (sought, replacement) in &TEMPLATE {
            assert!(page.contains(replacement), "{sought}");
        }
        let script = fs::read_to_string(script).unwrap();
        assert!(script.contains("Highlight.js") && script.len() < 30_000, "{}", script.len());
    }

    #[test]
    fn each_edit_fails_by_what_it_seeks_where_its_place_is_gone_or_there_twice() {
        assert!(template(&sought()).is_ok());
        for (place, _) in &TEMPLATE {
            let gone = template(&sought().replacen(place, "", 1)).unwrap_err();
            assert!(gone.contains(place) && gone.ends_with("0 times, not once"), "{gone}");
            let twice = template(&format!("{}{place}", sought())).unwrap_err();
            assert!(twice.contains(place) && twice.ends_with("2 times, not once"), "{twice}");
        }
    }

    #[test]
    fn a_highlighter_without_its_licence_or_a_language_is_refused() {
        let languages = LANGUAGES.map(|name| format!("hljs.registerLanguage(\"{name}\",0);\n")).concat();
        let whole = format!("/* License: BSD-3-Clause */\nvar hljs;\n{languages}");
        let more = whole.replacen("hljs.reg", "hljs.registerLanguage(\"apache\",0);\nhljs.reg", 1);
        assert_eq!(highlighter(&more).as_ref(), Ok(&whole));
        assert!(highlighter(&languages).unwrap_err().contains("licence"));
        assert!(highlighter(&whole.replace("\"rust\"", "\"rost\"")).unwrap_err().contains("languages"));
    }
}
