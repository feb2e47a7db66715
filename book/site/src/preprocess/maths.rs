//! TeX between dollar signs, into MathML.

use super::edits::Edits;
use super::{Piece, Source, blanks};
use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use pulldown_cmark::{Event, Tag, TagEnd};
use std::ops::Range;

/// The converter.
pub(super) struct Maths(LatexToMathML);

impl Maths {
    pub(super) fn new() -> Self {
        // `new` fails only on macros that do not parse, and there are none: the default is the same.
        Self(LatexToMathML::new(MathCoreConfig::default()).unwrap_or_default())
    }

    /// MathML for this TeX, written so that Markdown passes it on untouched.
    ///
    /// # Errors
    /// A fault in the TeX.
    pub(super) fn shown(&self, tex: &str, display: MathDisplay) -> Result<String, String> {
        let shown = |tex: &str| -> Result<String, String> {
            let shown = self.0.convert_with_local_state(tex, display).map_err(|e| e.error_message())?;
            // Around a bracket with its own size, browsers leave as much space as around a relation.
            Ok(guarded(&shown.mathml.replace("<mo minsize=", "<mo lspace=\"0\" rspace=\"0\" minsize=")))
        };
        if display == MathDisplay::Inline {
            return shown(tex);
        }
        // Spans, for a `<div>` would end the paragraph it stands in. Where the window is narrower than the
        // formula, its parts come one below the other; what is still wider scrolls, the page itself never.
        let mut html = String::new();
        for part in parts(tex, r"\qquad") {
            html.push_str("<span class=\"math-part\">");
            for (at, line) in parts(part, r"\allowbreak").into_iter().enumerate() {
                // A sign that begins a line stands between two sides all the same.
                html.push_str(&shown(&if at == 0 { line.to_owned() } else { format!("{{}}{line}") })?);
            }
            html.push_str("</span>");
        }
        Ok(format!("<span class=\"math-display\">{html}</span>"))
    }

    /// Replaces all maths of a chapter; returns what was wrong.
    pub(super) fn replace(
        &self,
        source: &Source<'_>,
        pieces: &[Piece<'_>],
        edits: &mut Edits,
    ) -> Vec<String> {
        let mut faults = Vec::new();
        let mut in_image = false;
        for (event, range) in pieces {
            let (tex, display) = match event {
                Event::InlineMath(tex) => (tex, MathDisplay::Inline),
                Event::DisplayMath(tex) => (tex, MathDisplay::Block),
                Event::Start(Tag::Image { .. }) => {
                    in_image = true;
                    continue;
                }
                Event::End(TagEnd::Image) => {
                    in_image = false;
                    continue;
                }
                _ => continue,
            };
            if in_image {
                let what = format!("the description of an image is plain text, but holds `${tex}$`");
                faults.push(source.fault(range.start, what));
                continue;
            }
            match self.shown(tex, display) {
                Ok(math) if display == MathDisplay::Inline => {
                    let (range, before, after) = with_its_marks(source.text, range);
                    let shown = format!("<span class=\"math-inline\">{before}{math}{after}</span>");
                    edits.replace(range, if before.len() + after.len() > 0 { shown } else { math });
                }
                Ok(math) => edits.replace(range.clone(), math),
                Err(reason) => {
                    let what = format!("TeX that cannot be shown: `{}`: {reason}", tex.trim());
                    faults.push(source.fault(range.start, what));
                }
            }
        }
        faults
    }
}

/// The TeX between these commands, where they stand in no group and no environment.
fn parts<'a>(tex: &'a str, command: &str) -> Vec<&'a str> {
    let (mut found, mut start, mut depth) = (Vec::new(), 0, 0_usize);
    for (at, c) in tex.char_indices() {
        let rest = &tex[at..];
        match c {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            _ if rest.starts_with("\\begin") || rest.starts_with("\\left") => depth += 1,
            _ if rest.starts_with("\\end") || rest.starts_with("\\right") => depth = depth.saturating_sub(1),
            _ if depth == 0 && rest.starts_with(command) => {
                found.push(&tex[start..at]);
                start = at + command.len();
            }
            _ => {}
        }
    }
    found.push(&tex[start..]);
    found
}

/// The range of inline maths together with the marks that cling to it: an opening parenthesis before,
/// a comma, a hyphen or a unit after. Browsers may break the line at either side of a formula, and would
/// leave a comma to begin the next.
fn with_its_marks<'a>(text: &'a str, range: &Range<usize>) -> (Range<usize>, &'a str, &'a str) {
    let (head, tail) = (&text[..range.start], &text[range.end..]);
    // `](` opens the target of a link, `![` an image: no marks of ours.
    let opens = head.ends_with('(') && !head.ends_with("](") && !head.ends_with("\\(");
    let unit = blanks::unit_behind(tail);
    let other = |c| !".,;:!?)-–’".contains(c);
    let marks = tail[unit..].find(other).map_or(tail.len(), |at| unit + at);
    let marks =
        if tail[..marks].ends_with('!') && tail[marks..].starts_with('[') { marks - 1 } else { marks };
    let start = range.start - usize::from(opens);
    (start..range.end + marks, &text[start..range.start], &tail[..marks])
}

/// Hides every mark that Markdown might take for its own (`_`, `*`, `|`, a line break ...) in the text
/// between tags. Tags and character references are passed on whole by Markdown itself.
fn guarded(mathml: &str) -> String {
    use std::fmt::Write as _;
    let mut out = String::with_capacity(mathml.len() * 2);
    let mut rest = mathml;
    while let Some(c) = rest.chars().next() {
        let end = match c {
            '<' => rest.find('>'),
            '&' => rest.find(';'),
            _ => None,
        };
        if let Some(end) = end {
            out.push_str(&rest[..=end]);
            rest = &rest[end + 1..];
            continue;
        }
        match c {
            '\n' | '\r' => out.push(' '),
            c if c.is_ascii_punctuation() => {
                let _ = write!(out, "&#{};", u32::from(c));
            }
            c => out.push(c),
        }
        rest = &rest[c.len_utf8()..];
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_display_is_cut_where_it_may_wrap_and_nowhere_within_a_group() {
        assert_eq!(parts(r"a, \qquad b \qquad c", r"\qquad"), ["a, ", " b ", " c"]);
        let whole =
            [r"\begin{aligned} a \qquad b \end{aligned}", r"\text{a \qquad b}", r"\left( a \qquad b \right)"];
        for tex in whole {
            assert_eq!(parts(tex, r"\qquad"), [tex]);
        }
        let shown = Maths::new().shown(r"a \allowbreak = b, \qquad c", MathDisplay::Block).unwrap();
        assert_eq!([shown.matches("math-part").count(), shown.matches("<math").count()], [2, 3], "{shown}");
    }
}
