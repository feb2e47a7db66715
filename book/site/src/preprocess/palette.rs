//! The colours of the page's themes for a drawing that is opened by itself: an address that ends with
//! `NAME.svg#NAME-navy` shows it as the page in navy does. `../../../theme/reader.js` writes that end.

/// The themes that a reader chooses from.
const THEMES: [&str; 5] = ["light", "rust", "coal", "navy", "ayu"];

/// Of the pages' style sheets, the rules of the colours that drawings ask for, or that those are mixed from.
#[derive(Debug)]
pub(super) struct Palette(String);

impl Palette {
    /// From the style sheets that set them, the later over the earlier.
    pub(super) fn new(sheets: &[&str]) -> Self {
        let wanted = |line: &&str| {
            let colours = ["--fig-", "--bg:", "--fg:", "--links:"];
            !line.starts_with("--") || colours.iter().any(|colour| line.starts_with(colour))
        };
        let lines = sheets.iter().flat_map(|sheet| sheet.lines()).map(str::trim);
        Self(lines.filter(wanted).filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n"))
    }

    /// A style, and the elements that its rules refer to, to be inserted into a drawing with this name.
    pub(super) fn of(&self, name: &str) -> String {
        let mut style = self.0.replace(":root", "svg:root:has(g:target)");
        let mut places = String::new();
        for theme in THEMES {
            let page = format!("svg:root:has(#{name}-{theme}:target)");
            style = style.replace(&format!(".{theme}"), &page);
            places.push_str(&format!("<g id=\"{name}-{theme}\"></g>"));
        }
        let ground = "svg:root:has(g:target){color:var(--fg);background:var(--bg)}";
        format!("<style>{style}\n{ground}</style>{places}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_theme_has_the_colours_of_its_page_by_its_own_address() {
        let sheet = ".light, .rust {\n  --bg: tan;\n  --x: 1;\n}\n:root {\n  --fig-paper: var(--bg);\n}";
        let style = Palette::new(&[sheet, ".navy { --fig-omega: teal }"]).of("axes");
        for rule in [
            "svg:root:has(#axes-light:target), svg:root:has(#axes-rust:target) {\n--bg: tan;\n}",
            "svg:root:has(g:target) {\n--fig-paper: var(--bg);\n}",
            "svg:root:has(#axes-navy:target) { --fig-omega: teal }",
            "<g id=\"axes-ayu\"></g>",
        ] {
            assert!(style.contains(rule), "{rule}: {style}");
        }
        assert!(!style.contains("--x"), "{style}");
    }
}
