//! The colours of the page's themes for a drawing that is opened by itself: an address that ends with
//! `NAME.svg#NAME-navy` shows it as the page in navy does. `../../theme/reader.js` writes that end.

use std::collections::BTreeMap;

/// The themes that a reader chooses from.
const THEMES: [&str; 5] = ["light", "rust", "coal", "navy", "ayu"];

/// The colours that drawings ask for, or that those are mixed from.
const WANTED: [&str; 3] = ["--bg", "--fg", "--links"];

/// Of each theme, the colours that its page gives to drawings.
#[derive(Debug)]
pub(super) struct Palette(Vec<(&'static str, BTreeMap<String, String>)>);

impl Palette {
    /// From the style sheets that set them, the later over the earlier.
    ///
    /// # Errors
    /// A theme without a colour.
    pub(super) fn new(sheets: &[&str]) -> Result<Self, String> {
        let rules: Vec<_> = sheets.iter().flat_map(|sheet| rules(sheet)).collect();
        let mut themes = Vec::new();
        for theme in THEMES {
            let class = format!(".{theme}");
            let mut colours = BTreeMap::new();
            for (selectors, declarations) in &rules {
                if selectors.split(',').any(|one| [":root", class.as_str()].contains(&one.trim())) {
                    colours.extend(declarations.iter().cloned());
                }
            }
            if let Some(missing) = WANTED.iter().find(|name| !colours.contains_key(**name)) {
                return Err(format!("the style sheets have no {missing} for the theme `{theme}`"));
            }
            themes.push((theme, colours));
        }
        Ok(Self(themes))
    }

    /// A style and the places that its rules look for, to stand in a drawing of this name.
    pub(super) fn of(&self, name: &str) -> String {
        let mut style = String::new();
        let mut places = String::new();
        for (theme, colours) in &self.0 {
            let id = format!("{name}-{theme}");
            let list: String = colours.iter().map(|(name, value)| format!("{name}:{value};")).collect();
            style.push_str(&format!(
                "svg:root:has(#{id}:target){{{list}color:var(--fg);background:var(--bg)}}"
            ));
            places.push_str(&format!("<g id=\"{id}\"></g>"));
        }
        format!("<style>{style}</style>{places}")
    }
}

/// The rules of a style sheet that stand in no other, as selectors and the colours they set.
fn rules(sheet: &str) -> Vec<(String, Vec<(String, String)>)> {
    let mut sheet = sheet.to_owned();
    while let Some(start) = sheet.find("/*") {
        let end = sheet[start..].find("*/").map_or(sheet.len(), |end| start + end + 2);
        sheet.replace_range(start..end, "");
    }
    let mut found = Vec::new();
    let mut rest = sheet.as_str();
    while let Some((selectors, after)) = rest.split_once('{') {
        let end = closing(after);
        if !selectors.trim_start().starts_with('@') {
            let set = after[..end].split(';').filter_map(|line| line.split_once(':'));
            let set = set.map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned()));
            let colours = set.filter(|(name, _)| {
                WANTED.contains(&name.as_str())
                    || (name.starts_with("--fig-") && !name.ends_with("-font") && !name.ends_with("-symbols"))
            });
            found.push((selectors.trim().to_owned(), colours.collect()));
        }
        rest = after.get(end + 1..).unwrap_or_default();
    }
    found
}

/// Where the brace closes that was opened before this text.
fn closing(text: &str) -> usize {
    let mut depth = 1_usize;
    for (at, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHEET: &str = "/* a { } */ .light, html:not(.js) { --bg: white; --fg: black; --links: blue; --x: 1 }\n\
        .rust { --bg: tan; --fg: black; --links: blue } .coal, .navy, .ayu { --bg: black; --fg: white; --links: aqua; }\n\
        @media (x) { .navy { --bg: red; } }\n:root { --fig-paper: var(--bg); --fig-font: serif }";

    #[test]
    fn a_theme_takes_its_own_colours_and_the_later_ones() {
        let palette = Palette::new(&[SHEET, ".navy { --fig-omega: teal }"]).unwrap();
        let style = palette.of("axes");
        let navy = "svg:root:has(#axes-navy:target){--bg:black;--fg:white;--fig-omega:teal;--fig-paper:var(--bg);--links:aqua;color";
        assert!(style.contains(navy), "{style}");
        assert!(
            style.contains("(#axes-rust:target){--bg:tan;") && style.contains("<g id=\"axes-ayu\"></g>"),
            "{style}"
        );
        assert!(!style.contains("red") && !style.contains("serif") && !style.contains("--x"), "{style}");
    }

    #[test]
    fn a_theme_without_a_colour_is_a_fault() {
        let fault = Palette::new(&[&SHEET.replace("tan", "tan} .no{")]).unwrap_err();
        assert!(fault.contains("--fg") && fault.contains("`rust`"), "{fault}");
    }
}
