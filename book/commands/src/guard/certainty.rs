//! How certain a number is. The calls in its assertion show this, not a label.
//!
//! `exactly(x)` and `enclosed(x)` of the proofs' crate return their argument. They accept only exact numbers
//! and only intervals; the compiler refuses a float. So an assertion whose values are all in such calls is
//! about exact numbers or intervals. Any other assertion is about floats, and counts only as asserted.

use super::digits;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::fmt;
use syn::parse::Parser as _;
use syn::punctuated::Punctuated;
use syn::{Expr, ExprLit, ExprMacro, Lit, Token};

/// The kind of evidence for a number, weakest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Certainty {
    /// Only in the description inside a drawing.
    Drawn,
    /// Computed in floats.
    Asserted,
    /// A real number in an interval whose ends round to the same digits.
    Enclosed,
    /// Exact arithmetic.
    Exact,
    /// An input, or a chosen bound.
    Given,
    /// History, with its source.
    Fact,
}

impl Certainty {
    /// The certainty of several statements of the same words together.
    pub(crate) fn with(self, other: Self) -> Self {
        let sure = |c: Self| matches!(c, Self::Exact | Self::Enclosed);
        match (sure(self), sure(other)) {
            (false, true) => other,
            (true, false) => self,
            _ => self.max(other),
        }
    }
}

impl fmt::Display for Certainty {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&format!("{self:?}").to_lowercase())
    }
}

/// The names of the calls that show an assertion's certainty.
const OWN: [&str; 3] = ["enclosed", "exactly", "given"];

/// With these a float could become an exact number.
const LETS_FLOATS_IN: &str =
    "of_f64 of_decimal of_literal from_float from_f64 approximate_float parse to_i64 to_int_unchecked";

/// The certainty of a comparison; literals alone are given.
pub(super) fn rests_on(expr: &Expr) -> Certainty {
    // The result of a method or a cast of an exact number is not exact.
    let given = |all: Certainty| if all == Certainty::Given { all } else { Certainty::Asserted };
    match expr {
        Expr::Lit(_) => Certainty::Given,
        Expr::Paren(inner) => rests_on(&inner.expr),
        Expr::Group(inner) => rests_on(&inner.expr),
        Expr::Reference(inner) => rests_on(&inner.expr),
        Expr::Unary(inner) => rests_on(&inner.expr),
        Expr::Binary(both) => weakest([&*both.left, &both.right]),
        Expr::Array(array) => weakest(&array.elems),
        Expr::Tuple(tuple) => weakest(&tuple.elems),
        Expr::Struct(value) => weakest(value.fields.iter().map(|field| &field.expr)),
        Expr::Cast(inner) => given(rests_on(&inner.expr)),
        Expr::MethodCall(call) => given(weakest(call.args.iter().chain([&*call.receiver]))),
        Expr::Call(call) => match called(&call.func).as_str() {
            "enclosed" => Certainty::Enclosed,
            "exactly" => Certainty::Exact,
            "String::from" | "Vector3::new" | "f64::from" | "Some" => weakest(&call.args),
            _ => Certainty::Asserted,
        },
        Expr::Macro(inner) if inner.mac.path.is_ident("given") => Certainty::Given,
        Expr::Macro(inner) if inner.mac.path.is_ident("format") => formatted(inner),
        _ => Certainty::Asserted,
    }
}

pub(super) fn weakest<'a>(all: impl IntoIterator<Item = &'a Expr>) -> Certainty {
    all.into_iter().map(rests_on).min().unwrap_or(Certainty::Given)
}

/// The certainty of the arguments of a `format!`; a `{name}` in the pattern is a value without such a call.
fn formatted(format: &ExprMacro) -> Certainty {
    let parse = Punctuated::<Expr, Token![,]>::parse_terminated;
    let arguments = parse.parse2(format.mac.tokens.clone()).unwrap_or_default();
    let Some(Expr::Lit(ExprLit { lit: Lit::Str(pattern), .. })) = arguments.first() else {
        return Certainty::Asserted;
    };
    let names = |piece: &str| piece.starts_with(|c: char| c.is_alphabetic() || c == '_');
    if pattern.value().replace("{{", "").split('{').skip(1).any(names) {
        return Certainty::Asserted;
    }
    weakest(&arguments)
}

/// The path of a function that is called by it.
fn called(function: &Expr) -> String {
    let Expr::Path(path) = function else { return String::new() };
    let words = path.path.segments.iter().map(|segment| segment.ident.to_string());
    words.collect::<Vec<_>>().join("::")
}

/// Whether the pattern of this format has digits of its own, which nothing computes.
pub(super) fn prints_own_digits(expr: &Expr) -> bool {
    let Expr::Macro(inner) = expr else { return false };
    if inner.mac.path.is_ident("given") {
        return false; // a number, and no pattern
    }
    let Some(TokenTree::Literal(pattern)) = inner.mac.tokens.clone().into_iter().next() else { return false };
    let pattern = pattern.to_string().replace("{{", "").replace("}}", "");
    let outside = pattern.split('}').map(|piece| piece.split('{').next().unwrap_or_default());
    outside.map(digits::plain).any(|found| !found.is_empty())
}

/// Names with which a block could pass floats for exact numbers: the line, from zero, and the name.
pub(super) fn laundering(block: TokenStream) -> Vec<(usize, String)> {
    let mut found = Laundering::default();
    found.look(block);
    found.taken.extend(found.floats.into_iter().filter(|_| found.certain));
    found.taken
}

#[derive(Default)]
struct Laundering {
    /// Whether the block calls `enclosed` or `exactly`.
    certain: bool,
    taken: Vec<(usize, String)>,
    floats: Vec<(usize, String)>,
}

impl Laundering {
    fn look(&mut self, tokens: TokenStream) {
        let mut tokens = tokens.into_iter().peekable();
        let mut before = String::new();
        while let Some(token) = tokens.next() {
            let word = match token {
                TokenTree::Group(group) => {
                    self.look(group.stream());
                    String::new()
                }
                other => other.to_string(),
            };
            // Imports from the proofs' crate may have these names.
            if before == "use" && word == "tumbling_proofs" {
                tokens.by_ref().find(|token| token.to_string() == ";");
            }
            let next = tokens.peek();
            let line = || next.map_or(0, |token| token.span().start().line.saturating_sub(1));
            if OWN.contains(&word.as_str()) {
                let called = match next {
                    Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Parenthesis,
                    Some(TokenTree::Punct(mark)) => word == "given" && mark.as_char() == '!',
                    _ => false,
                };
                if !called || before == "fn" {
                    self.taken.push((line(), format!("another thing called `{word}`")));
                }
                self.certain |= word != "given";
            } else if LETS_FLOATS_IN.split(' ').any(|name| name == word) {
                self.floats.push((line(), format!("`{word}` beside exact numbers")));
            } else if before == "as" && word.starts_with(['i', 'u']) {
                self.floats.push((line(), "a cast to a whole number beside exact numbers".into()));
            }
            before = word;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Certainty {
        rests_on(&syn::parse_str(text).unwrap())
    }

    #[test]
    fn an_assertion_is_worth_its_weakest_value() {
        assert_eq!(of("format!(\"{:.2} s\", enclosed(t))"), Certainty::Enclosed);
        assert_eq!(of("format!(\"{:.2} s\", exactly(t))"), Certainty::Exact);
        assert_eq!(of("format!(\"{:.2}, {:.2}\", exactly(t), enclosed(u))"), Certainty::Enclosed);
        assert_eq!(of("exactly(a) < given!(3)"), Certainty::Exact);
        for weak in [
            "format!(\"{t:.2} {:.2}\", exactly(u))",
            "format!(\"{:.2} {:.2}\", t, exactly(u))",
            "printed(enclosed(t))",
            "other::enclosed(t)",
            "exactly(a) < b",
        ] {
            assert_eq!(of(weak), Certainty::Asserted, "{weak}");
        }
    }

    #[test]
    fn a_block_cannot_call_something_else_exact_nor_let_floats_in() {
        let found = |text: &str| laundering(text.parse().unwrap()).len();
        assert_eq!(found("use tumbling_proofs::{enclosed, exactly}; enclosed(x); let n = x as f64;"), 0);
        for wrong in [
            "fn exactly(x: f64) -> f64 { x }",
            "let enclosed = |x| x;",
            "macro_rules! given { () => {} }",
            "use other::exactly;",
            "use tumbling_proofs::Rational; use a::b as enclosed;",
            "assert_eq!(exactly(Rational::of_f64(x)), y);",
            "let n = Rational::of_f64(x); assert_eq!(exactly(n), y);",
            "let n = x as i64; exactly(n);",
            "let n = Rational::from(x.to_i64()?); assert_eq!(exactly(n), y);",
            "let n: Fraction = text.parse()?; assert_eq!(exactly(n), y);",
        ] {
            assert_eq!(found(wrong), 1, "{wrong}");
        }
        assert_eq!(found("let n = Rational::of_f64(x);"), 0);
    }

    #[test]
    fn what_is_certain_counts_beside_what_is_only_computed() {
        assert_eq!(Certainty::Asserted.with(Certainty::Enclosed), Certainty::Enclosed);
        assert_eq!(Certainty::Exact.with(Certainty::Asserted), Certainty::Exact);
        assert_eq!(Certainty::Given.with(Certainty::Enclosed), Certainty::Enclosed);
        assert_eq!(Certainty::Enclosed.with(Certainty::Exact), Certainty::Exact);
    }
}
