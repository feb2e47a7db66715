//! Reads the Rust code of a block for its phrases.

use super::certainty::{Certainty, laundering, prints_own_digits, weakest};
use super::digits;
use super::phrase::Phrase;
use super::spelled;
use proc_macro2::{LineColumn, Span, TokenStream, TokenTree};
use std::collections::HashMap;
use syn::parse::Parser as _;
use syn::punctuated::Punctuated;
use syn::visit::Visit;
use syn::{BinOp, Expr, ExprLit, Lit, Token};

/// The contents of a block, in its order.
#[derive(Debug, Default)]
pub(crate) struct Code {
    pub(crate) phrases: Vec<Phrase>,
    /// The expected strings of assertions of one word, or of several lines.
    pub(crate) answers: Vec<String>,
    /// Code that looks like evidence and is not: the line, from zero, the words, and what would be right.
    pub(crate) hollow: Vec<(usize, String, &'static str)>,
    pub(crate) comments: Vec<Comment>,
}

/// A literal in a block: its line, from zero, and its bytes there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Literal {
    pub(crate) line: usize,
    pub(crate) start: usize,
    pub(crate) end: usize,
}

/// A comment, by its lines.
#[derive(Debug)]
pub(crate) struct Comment {
    pub(crate) lines: Vec<Literal>,
    /// Whether it follows code on its line.
    pub(crate) note: bool,
    /// The values of the literals on a note's line.
    pub(crate) values: Vec<f64>,
}

/// Rust that could not be read: the line, from zero, and why.
#[derive(Debug, Clone)]
pub(crate) struct Fault {
    pub(crate) line: usize,
    pub(crate) what: String,
}

/// Reads a block of Rust.
///
/// # Errors
/// The line and the reason why it is not Rust.
pub(crate) fn read(text: &str) -> Result<Code, Fault> {
    shallow(text)?;
    let statements = syn::Block::parse_within.parse_str(text).map_err(|e| fault(&e))?;
    let tokens: TokenStream = text.parse().map_err(|e: proc_macro2::LexError| fault(&e.into()))?;
    let mut reader = Reader {
        lines: text.lines().collect(),
        code: Code::default(),
        fault: None,
        branches: 0,
        claimed: HashMap::new(),
    };
    for statement in &statements {
        reader.visit_stmt(statement);
    }
    if let Some(e) = reader.fault {
        return Err(fault(&e));
    }
    reader.code.hollow.extend(laundering(tokens.clone()).into_iter().map(|(at, what)| (at, what, EXACT)));
    let mut literals = Vec::new();
    reader.literals(tokens, &mut literals);
    let mut comments = comments(text, &literals);
    reader.notes(&mut comments, &literals);
    reader.code.comments = comments;
    Ok(reader.code)
}

/// Refuses what is nested so deeply that reading it could exhaust the stack.
fn shallow(text: &str) -> Result<(), Fault> {
    let (mut depth, mut signs) = (0_usize, 0_usize);
    for (line, written) in text.lines().enumerate() {
        for c in written.chars() {
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth = depth.saturating_sub(1),
                _ => {}
            }
            // Signs before an operand nest too.
            match c {
                '-' | '!' | '&' | '*' => signs += 1,
                c if c.is_alphanumeric() => signs = 0,
                _ => {}
            }
            if depth > DEEPEST || signs > DEEPEST {
                return Err(Fault { line, what: format!("Rust nested more than {DEEPEST} deep") });
            }
        }
    }
    Ok(())
}

/// How deep brackets may stand within one another.
const DEEPEST: usize = 64;

fn fault(error: &syn::Error) -> Fault {
    Fault {
        line: error.span().start().line.saturating_sub(1),
        what: format!("Rust that cannot be read: {error}"),
    }
}

/// The comments of a block: what begins with two slashes and stands in no string. Lines that follow
/// one another are one comment.
fn comments(text: &str, literals: &[Literal]) -> Vec<Comment> {
    let mut found: Vec<Comment> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let quoted = |at: usize| literals.iter().any(|l| l.line == number && (l.start..l.end).contains(&at));
        let Some((at, _)) = line.match_indices("//").find(|&(at, _)| !quoted(at)) else { continue };
        let start = at + line[at..].len() - line[at..].trim_start_matches(['/', '!']).len();
        let part = Literal { line: number, start, end: line.len() };
        let note = !line[..at].trim().is_empty();
        let goes_on = |c: &&mut Comment| !note && c.lines.last().is_some_and(|last| last.line + 1 == number);
        match found.last_mut().filter(goes_on) {
            Some(comment) => comment.lines.push(part),
            None => found.push(Comment { lines: vec![part], note, values: Vec::new() }),
        }
    }
    found
}

struct Reader<'a> {
    lines: Vec<&'a str>,
    code: Code,
    fault: Option<syn::Error>,
    /// The number of enclosing branches, which may never be executed.
    branches: usize,
    /// The lines of assertions, with their certainty.
    claimed: HashMap<usize, Certainty>,
}

impl<'a> Reader<'a> {
    /// The bytes of a one-line span.
    fn literal(&self, span: Span) -> Literal {
        let LineColumn { line, column } = span.start();
        let end = span.end();
        let line = line.saturating_sub(1);
        let byte = |column: usize| {
            let text = self.lines.get(line).copied().unwrap_or_default();
            text.char_indices().nth(column).map_or(text.len(), |(byte, _)| byte)
        };
        let last = if end.line == line + 1 { byte(end.column) } else { byte(usize::MAX) };
        Literal { line, start: byte(column), end: last }
    }

    fn written(&self, at: &Literal) -> &'a str {
        self.lines.get(at.line).and_then(|line| line.get(at.start..at.end)).unwrap_or_default()
    }

    /// All literals, without the doc comments, which the compiler treats as literals.
    fn literals(&self, tokens: TokenStream, into: &mut Vec<Literal>) {
        for token in tokens {
            match token {
                TokenTree::Group(group) => self.literals(group.stream(), into),
                TokenTree::Literal(literal) => {
                    let at = self.literal(literal.span());
                    if !self.written(&at).starts_with("//") {
                        into.push(at);
                    }
                }
                _ => {}
            }
        }
    }

    /// The phrases of the notes, divided by `;`. The numbers of each must be literals of its line, one after
    /// the other.
    fn notes(&mut self, comments: &mut [Comment], literals: &[Literal]) {
        for comment in comments.iter_mut().filter(|c| c.note) {
            let at = &comment.lines[0];
            let own: Vec<f64> =
                literals.iter().filter(|l| l.line == at.line).flat_map(|l| self.values(l)).collect();
            for phrase in self.written(at).split(';').map(str::trim) {
                let numbers = digits::plain(phrase);
                let said = |word: &spelled::Word| own.iter().any(|value| word.says(*value));
                let stand = |run: &[f64]| run.iter().zip(&numbers).all(|(own, said)| *own == said.value);
                if !numbers.is_empty() && !own.windows(numbers.len()).any(stand) {
                    let found = format!("`{phrase}` in a note");
                    self.code.hollow.push((at.line, found, "a literal of its line of code"));
                } else if !numbers.is_empty() || spelled::words(phrase).iter().any(said) {
                    let certainty = self.claimed.get(&at.line).copied().unwrap_or(Certainty::Given);
                    self.code.phrases.push(Phrase::new(phrase, false, at.line, certainty));
                }
            }
            comment.values = own;
        }
    }

    /// The values of a literal: a number with its sign, or the numbers of a string that is not a format
    /// pattern.
    fn values(&self, at: &Literal) -> Vec<f64> {
        let written = self.written(at);
        if written.starts_with('"') {
            let pattern = written.contains('{');
            return digits::plain(written).iter().filter(|_| !pattern).map(|n| n.value).collect();
        }
        let digits = written.replace('_', "");
        let digits = digits.trim_end_matches("f64").trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let before = self.lines[at.line][..at.start].strip_suffix('-');
        let minus = before.is_some_and(|b| !b.ends_with(|c: char| c.is_alphanumeric() || ")]".contains(c)));
        digits.parse().map(|v: f64| if minus { -v } else { v }).into_iter().collect()
    }

    /// One side of `assert_eq!`: the text must repeat its strings with a number or of several words.
    fn expected(&mut self, expr: &Expr, certainty: Certainty) {
        match expr {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => {
                let at = self.literal(text.span());
                let phrase = Phrase::new(&text.value(), true, at.line, certainty);
                // In lines of its own it is what a program prints.
                let says = phrase.text.contains(' ') && !text.value().contains('\n');
                if digits::plain(&phrase.text).is_empty() && !says {
                    self.code.answers.push(phrase.text);
                } else {
                    self.code.phrases.push(phrase);
                }
            }
            Expr::Array(array) => array.elems.iter().for_each(|e| self.expected(e, certainty)),
            Expr::Reference(inner) => self.expected(&inner.expr, certainty),
            _ => {}
        }
    }

    /// An assertion in this line that is no evidence.
    fn hollow(&mut self, line: usize, why: &str) {
        self.code.hollow.push((line, why.to_owned(), COMPUTED));
    }

    /// The comparisons of an `assert!`.
    fn claim(&mut self, expr: &Expr) {
        match expr {
            Expr::Binary(binary) => match binary.op {
                BinOp::And(_) | BinOp::Or(_) => {
                    self.claim(&binary.left);
                    self.claim(&binary.right);
                }
                BinOp::Lt(_) | BinOp::Le(_) => {
                    // Only a distance, `(x - 3.0 / 23.0).abs()`, fixes the value of a number.
                    let apart = matches!(&*binary.left, Expr::MethodCall(c) if c.method == "abs" || c.method == "norm");
                    if let (true, Expr::Lit(bound)) = (apart, &*binary.right)
                        && self.values(&self.literal(bound.lit.span())).iter().any(|bound| *bound > 1e-3)
                    {
                        let line = self.literal(bound.lit.span()).line;
                        self.hollow(line, "a tolerance of more than a thousandth");
                    }
                }
                _ => {}
            },
            Expr::Paren(inner) => self.claim(&inner.expr),
            other => self.visit_expr(other),
        }
    }
}

/// The requirement on an assertion.
const COMPUTED: &str = "a computed value compared with what it must be";
/// The permitted sources of exact numbers.
const EXACT: &str = "the proofs' own `enclosed`, `exactly` and `given!`, and no float that becomes exact";

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_expr_if(&mut self, branch: &'ast syn::ExprIf) {
        self.visit_expr(&branch.cond);
        self.branches += 1;
        self.visit_block(&branch.then_branch);
        if let Some((_, other)) = &branch.else_branch {
            self.visit_expr(other);
        }
        self.branches -= 1;
    }

    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        let name = mac.path.segments.last().map(|s| s.ident.to_string()).unwrap_or_default();
        let arguments = match Punctuated::<Expr, Token![,]>::parse_terminated.parse2(mac.tokens.clone()) {
            Ok(arguments) => arguments,
            Err(e) => {
                // Other macros have a grammar of their own, and contain nothing that a text may repeat.
                if name.starts_with("assert") {
                    self.fault.get_or_insert(e);
                }
                return;
            }
        };
        let line = mac.path.segments.first().map_or(0, |s| s.ident.span().start().line.saturating_sub(1));
        if name.starts_with("assert") && self.branches > 0 {
            self.hollow(line, "an assertion inside a branch, which may never be taken");
        }
        let weakest = weakest(arguments.iter().take(if name == "assert" { 1 } else { 2 }));
        // A comparison of literals alone states nothing.
        let certainty = if weakest == Certainty::Given { Certainty::Asserted } else { weakest };
        if name.starts_with("assert") {
            let end = mac.delimiter.span().close().end().line.saturating_sub(1);
            self.claimed.extend((line..=end).map(|line| (line, certainty)));
        }
        let mut rest = arguments.iter();
        match name.as_str() {
            "assert_eq" => {
                if weakest == Certainty::Given {
                    self.hollow(line, "an assertion of a literal about a literal");
                }
                if arguments.iter().take(2).any(prints_own_digits) {
                    self.hollow(line, "digits in the pattern of a format, which nothing computes");
                }
                rest.by_ref().take(2).for_each(|side| self.expected(side, certainty));
            }
            "assert" => rest.by_ref().take(1).for_each(|claim| self.claim(claim)),
            _ => {}
        }
        rest.for_each(|argument| self.visit_expr(argument));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_gives_what_it_asserts_and_what_its_notes_say() {
        let code =
            read("let x = [1.0, -2.0]; // (1, -2) rad/s; a half\nassert_eq!(format!(\"{x:.1}\"), \"7.4°\");");
        let found = code.unwrap().phrases.into_iter().map(|found| (found.text, found.asserted, found.line));
        assert_eq!(found.collect::<Vec<_>>(), [("7.4°".into(), true, 1), ("(1, -2) rad/s".into(), false, 0)]);
    }

    #[test]
    fn broken_rust_is_a_fault_with_its_line() {
        let fault = read("let a = 1;\nlet b = ;\n").unwrap_err();
        assert_eq!(fault.line, 1);
        assert!(read("assert!(1 < );").is_err());
        assert!(read("let s = \"open;").is_err());
    }
}
