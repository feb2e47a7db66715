//! Which expressions bring nothing computed into an assertion.

use super::digits;
use proc_macro2::TokenTree;
use syn::parse::Parser as _;
use syn::punctuated::Punctuated;
use syn::{Expr, ExprLit, Lit, Token};

/// Whether this function only holds what it is given.
pub(super) fn wraps(function: &Expr) -> bool {
    let Expr::Path(path) = function else { return false };
    let words: Vec<String> = path.path.segments.iter().map(|s| s.ident.to_string()).collect();
    ["String::from", "Vector3::new", "f64::from", "Some"].contains(&words.join("::").as_str())
}

/// Whether this is made of literals alone: itself, a collection of such, or a format of such.
pub(super) fn is_literal(expr: &Expr) -> bool {
    match expr {
        Expr::Lit(_) => true,
        Expr::Paren(inner) => is_literal(&inner.expr),
        Expr::Group(inner) => is_literal(&inner.expr),
        Expr::Unary(inner) => is_literal(&inner.expr),
        Expr::Reference(inner) => is_literal(&inner.expr),
        Expr::Cast(inner) => is_literal(&inner.expr),
        Expr::Binary(both) => is_literal(&both.left) && is_literal(&both.right),
        Expr::Array(array) => array.elems.iter().all(is_literal),
        Expr::Tuple(tuple) => tuple.elems.iter().all(is_literal),
        Expr::MethodCall(call) => is_literal(&call.receiver) && call.args.iter().all(is_literal),
        Expr::Call(call) => wraps(&call.func) && call.args.iter().all(is_literal),
        Expr::Macro(inner) if inner.mac.path.is_ident("format") => {
            let parse = Punctuated::<Expr, Token![,]>::parse_terminated;
            let Ok(arguments) = parse.parse2(inner.mac.tokens.clone()) else { return false };
            // `{name}` in the pattern is no literal; `{}` and `{:.1}` stand for arguments.
            let names = |text: &str| {
                text.replace("{{", "").split('{').skip(1).any(|p| p.starts_with(|c: char| c.is_alphabetic()))
            };
            arguments.iter().all(|a| match a {
                Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => !names(&text.value()),
                other => is_literal(other),
            })
        }
        _ => false,
    }
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
