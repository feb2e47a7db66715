//! TeX source cut into its smallest parts; spacing is left out.

use super::error::TexError;

/// What kind of part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Digits, perhaps with a point among them.
    Number,
    /// A single letter.
    Letter,
    /// A backslash and a name.
    Command,
    /// `\text{...}`, whole.
    Text,
    /// `\begin{...}` or `\end{...}`, whole.
    Fence,
    /// Anything else: a bracket, a sign, `\\`.
    Mark,
}

/// A part of the source and where it starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Token<'a> {
    pub(crate) kind: Kind,
    pub(crate) text: &'a str,
    pub(crate) at: usize,
}

const SPACING: [&str; 11] =
    [r"\,", r"\;", r"\:", r"\!", r"\ ", r"\quad", r"\left", r"\right", r"\bigl", r"\bigr", r"\allowbreak"];

const MARKS: &str = "+-=<>/()[]{},.;&_^'|";

/// The parts of `tex`.
pub(crate) fn tokens(tex: &str) -> Result<Vec<Token<'_>>, TexError> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(next) = tex[at..].chars().next() {
        let rest = &tex[at..];
        let (kind, length) = match next {
            c if c.is_ascii_whitespace() || c == '~' => {
                at += 1;
                continue;
            }
            '\\' => {
                let length = command_length(rest);
                match &rest[..length] {
                    text if SPACING.contains(&text) => {
                        at += length;
                        continue;
                    }
                    r"\text" => (Kind::Text, group_end(rest, length, at)?),
                    r"\begin" | r"\end" => (Kind::Fence, group_end(rest, length, at)?),
                    r"\\" => (Kind::Mark, length),
                    "\\" => return Err(TexError::new(at, "a command after the backslash")),
                    _ => (Kind::Command, length),
                }
            }
            c if c.is_ascii_digit() => (Kind::Number, number_length(rest)),
            c if c.is_ascii_alphabetic() => (Kind::Letter, 1),
            c if MARKS.contains(c) => (Kind::Mark, 1),
            _ => return Err(TexError::new(at, "a character of plain TeX")),
        };
        tokens.push(Token { kind, text: &rest[..length], at });
        at += length;
    }
    Ok(tokens)
}

/// A backslash with the letters after it, or with the one sign after it.
fn command_length(rest: &str) -> usize {
    let letters = rest[1..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len() - 1);
    match letters {
        0 => 1 + rest[1..].chars().next().map_or(0, char::len_utf8),
        n => 1 + n,
    }
}

/// Digits, and a point only with digits after it: another one ends the sentence.
fn number_length(rest: &str) -> usize {
    let digits = |at: usize| rest[at..].find(|c: char| !c.is_ascii_digit()).map_or(rest.len(), |n| at + n);
    let whole = digits(0);
    let decimals = rest[whole..].strip_prefix('.').map_or(whole, |_| digits(whole + 1));
    if decimals > whole + 1 { decimals } else { whole }
}

/// The end of the group in braces after a command, which holds no other braces.
fn group_end(rest: &str, command: usize, at: usize) -> Result<usize, TexError> {
    if !rest[command..].starts_with('{') {
        return Err(TexError::new(at + command, "an opening brace"));
    }
    let end = rest[command..].find('}').map(|n| command + n + 1);
    end.ok_or_else(|| TexError::new(at + rest.len(), "a closing brace"))
}
