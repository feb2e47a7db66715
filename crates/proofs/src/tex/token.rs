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

impl Token<'_> {
    pub(crate) fn end(&self) -> usize {
        self.at + self.text.len()
    }
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
    let digits =
        |from: usize| rest[from..].find(|c: char| !c.is_ascii_digit()).map_or(rest.len(), |n| from + n);
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

const RELATIONS: [&str; 30] = [
    "=",
    "<",
    ">",
    r"\le",
    r"\leq",
    r"\ge",
    r"\geq",
    r"\ne",
    r"\neq",
    r"\not",
    r"\approx",
    r"\propto",
    r"\to",
    r"\mapsto",
    r"\equiv",
    r"\cong",
    r"\parallel",
    r"\perp",
    r"\gg",
    r"\ll",
    r"\sim",
    r"\simeq",
    r"\doteq",
    r"\in",
    r"\implies",
    r"\iff",
    r"\Rightarrow",
    r"\rightarrow",
    r"\lt",
    r"\gt",
];

/// Whether a piece of maths states something, having an equals sign, an inequality or another relation in it;
/// a lone symbol or number does not.
///
/// ```
/// use tumbling_proofs::tex::states_something;
/// assert!(states_something(r"I_1 \le I_2"));
/// assert!(!states_something(r"\boldsymbol{\omega}"));
/// ```
#[must_use]
pub fn states_something(tex: &str) -> bool {
    match tokens(tex) {
        Ok(tokens) => tokens.iter().any(|token| RELATIONS.contains(&token.text)),
        // What cannot be cut up is to be looked at, not passed over.
        Err(_) => RELATIONS.iter().any(|sign| tex.contains(sign)),
    }
}
