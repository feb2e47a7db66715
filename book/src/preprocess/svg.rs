//! A drawing, as its own document and as a part of a page.

/// A drawing that may stand in a page: it is one `<svg>` and its ids cannot clash with another's.
#[derive(Debug)]
pub(super) struct Drawing {
    text: String,
}

impl Drawing {
    /// Takes the text of `figures/NAME.svg`.
    ///
    /// # Errors
    /// Why it cannot stand in a page.
    pub(super) fn new(name: &str, text: String) -> Result<Self, String> {
        let fault = |what: String| Err(format!("figures/{name}.svg {what}"));
        if !text.starts_with("<svg") || !text.trim_end().ends_with("</svg>") {
            return fault("must begin with `<svg` and end with `</svg>`: no header, one drawing".into());
        }
        for id in ids(&text) {
            // On one page, and all on the print page, the ids of all drawings meet.
            if !id.starts_with(name) {
                return fault(format!("has the id `{id}`, which does not begin with the figure's name"));
            }
        }
        for outside in ["<script", "<image", "<foreignObject", "http://", "https://"] {
            let mut rest = text.as_str();
            while let Some(at) = rest.find(outside) {
                let names_a_format =
                    rest[..at].ends_with("xmlns=\"") || rest[..at].ends_with("xmlns:xlink=\"");
                if !names_a_format {
                    return fault(format!("contains `{outside}`: a drawing loads nothing and runs nothing"));
                }
                rest = &rest[at + outside.len()..];
            }
        }
        if !text.contains(&format!(" aria-labelledby=\"{name}-title {name}-desc\"")) {
            return fault("is not labelled by its own title and description".into());
        }
        Ok(Self { text })
    }

    /// The drawing as a document of its own, with this put at its end: as large as the window it is opened
    /// in, in its middle.
    pub(super) fn alone(&self, added: &str) -> String {
        let start = self.start_tag();
        let mut sized = start.to_owned();
        for side in [" width=\"", " height=\""] {
            if let Some(at) = sized.find(side)
                && let Some(end) = sized[at + side.len()..].find('"')
            {
                sized.replace_range(at..=at + side.len() + end, "");
            }
        }
        let sized = sized.replacen("<svg", "<svg width=\"100%\" height=\"100%\"", 1);
        let text = self.text.replacen(start, &sized, 1);
        let end = text.rfind("</svg>").unwrap_or(text.len());
        format!("{}{added}{}", &text[..end], &text[end..])
    }

    /// The drawing as a part of a page.
    pub(super) fn inline(&self) -> String {
        // No blank line and no carriage return: the first would end a block of HTML in Markdown.
        let lines: Vec<&str> = self.text.lines().filter(|line| !line.trim().is_empty()).collect();
        lines.join("\n")
    }

    fn start_tag(&self) -> &str {
        self.text.split('>').next().unwrap_or_default()
    }
}

/// The values of all `id` attributes.
fn ids(svg: &str) -> impl Iterator<Item = &str> {
    svg.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next())
}
