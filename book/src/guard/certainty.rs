//! How certain a number is: by the calls that its assertion rests on, not by a label.
//!
//! `exactly(x)` and `enclosed(x)` of the proofs' crate give back what they are given and take exact numbers
//! or intervals alone; the compiler refuses a float. So an assertion whose values all stand in such calls is
//! one about those. Whatever else it rests on is computed in floats, and only asserted.

use super::hollow::wraps;
use proc_macro2::TokenTree;
use std::fmt;
use syn::parse::Parser as _;
use syn::punctuated::Punctuated;
use syn::visit::Visit;
use syn::{Expr, ExprLit, Lit, Token};

/// What holds a number, the weakest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Certainty {
    /// In the description that a drawing has of itself, and nowhere else.
    Drawn,
    /// Computed in floats.
    Asserted,
    /// A real number, in an interval whose ends round alike.
    Enclosed,
    /// Exact arithmetic.
    Exact,
    /// An input, or a bound that is chosen.
    Given,
    /// History, with its source.
    Fact,
}

impl Certainty {
    /// All of them, the most certain first.
    pub(crate) const ALL: [Self; 6] =
        [Self::Exact, Self::Enclosed, Self::Asserted, Self::Given, Self::Fact, Self::Drawn];

    /// Of several statements of the same words, what they are worth together.
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
        f.write_str(match self {
            Self::Drawn => "drawn",
            Self::Asserted => "asserted",
            Self::Enclosed => "enclosed",
            Self::Exact => "exact",
            Self::Given => "given",
            Self::Fact => "fact",
        })
    }
}

/// The names that an assertion's certainty is read by.
const OWN: [&str; 3] = ["enclosed", "exactly", "given"];

/// By these a float would become an exact number.
const LETS_FLOATS_IN: [&str; 7] =
    ["of_f64", "of_decimal", "of_literal", "from_float", "from_f64", "approximate_float", "parse"];

/// What this comparison rests on; literals alone are given.
pub(super) fn rests_on(expr: &Expr) -> Certainty {
    match expr {
        Expr::Lit(_) => Certainty::Given,
        Expr::Paren(inner) => rests_on(&inner.expr),
        Expr::Group(inner) => rests_on(&inner.expr),
        Expr::Reference(inner) => rests_on(&inner.expr),
        Expr::Unary(inner) => rests_on(&inner.expr),
        Expr::Binary(both) => rests_on(&both.left).min(rests_on(&both.right)),
        Expr::Array(array) => weakest(&array.elems),
        Expr::Tuple(tuple) => weakest(&tuple.elems),
        Expr::Struct(value) => {
            value.fields.iter().map(|f| rests_on(&f.expr)).min().unwrap_or(Certainty::Given)
        }
        Expr::Call(call) => match called(&call.func).as_deref() {
            Some("enclosed") => Certainty::Enclosed,
            Some("exactly") => Certainty::Exact,
            _ if wraps(&call.func) => weakest(&call.args),
            _ => Certainty::Asserted,
        },
        Expr::Macro(inner) if inner.mac.path.is_ident("given") => Certainty::Given,
        Expr::Macro(inner) if inner.mac.path.is_ident("format") => {
            let parse = Punctuated::<Expr, Token![,]>::parse_terminated;
            let Ok(arguments) = parse.parse2(inner.mac.tokens.clone()) else { return Certainty::Asserted };
            let pattern = match arguments.first() {
                Some(Expr::Lit(ExprLit { lit: Lit::Str(text), .. })) => text.value().replace("{{", ""),
                _ => return Certainty::Asserted,
            };
            // `{name}` brings a value that stands in no call.
            let named =
                pattern.split('{').skip(1).any(|p| p.starts_with(|c: char| c.is_alphabetic() || c == '_'));
            let rest: Vec<&Expr> = arguments.iter().skip(1).collect();
            if named || rest.is_empty() {
                return Certainty::Asserted;
            }
            rest.into_iter().map(rests_on).min().unwrap_or(Certainty::Asserted)
        }
        _ => Certainty::Asserted,
    }
}

fn weakest(all: &Punctuated<Expr, Token![,]>) -> Certainty {
    all.iter().map(rests_on).min().unwrap_or(Certainty::Given)
}

/// The name of a function that is called by its name alone.
fn called(function: &Expr) -> Option<String> {
    let Expr::Path(path) = function else { return None };
    path.path.get_ident().map(ToString::to_string)
}

/// What would let a block pass floats for exact numbers: the line, from zero, and what stands there.
pub(super) fn laundering(statements: &[syn::Stmt]) -> Vec<(usize, String)> {
    let mut watch = Watch::default();
    for statement in statements {
        watch.visit_stmt(statement);
    }
    watch.taken.extend(watch.floats.into_iter().filter(|_| watch.certain));
    watch.taken
}

#[derive(Default)]
struct Watch {
    /// Whether the block calls `enclosed` or `exactly`.
    certain: bool,
    taken: Vec<(usize, String)>,
    floats: Vec<(usize, String)>,
}

impl Watch {
    fn name(&mut self, ident: &syn::Ident) {
        if OWN.iter().any(|own| ident == own) {
            let line = ident.span().start().line.saturating_sub(1);
            self.taken.push((line, format!("another thing called `{ident}`")));
        }
    }

    fn use_of(&mut self, ident: &syn::Ident) {
        let line = ident.span().start().line.saturating_sub(1);
        if LETS_FLOATS_IN.iter().any(|way| ident == way) {
            self.floats.push((line, format!("`{ident}` beside exact numbers")));
        }
        self.certain |= ident == "enclosed" || ident == "exactly";
    }
}

impl<'ast> Visit<'ast> for Watch {
    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        self.name(&pattern.ident);
        syn::visit::visit_pat_ident(self, pattern);
    }
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.name(&item.sig.ident);
        syn::visit::visit_item_fn(self, item);
    }
    fn visit_item_macro(&mut self, item: &'ast syn::ItemMacro) {
        item.ident.iter().for_each(|ident| self.name(ident));
        self.visit_macro(&item.mac);
    }
    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        let own = matches!(&item.tree, syn::UseTree::Path(path) if path.ident == "tumbling_proofs");
        if !own {
            syn::visit::visit_item_use(self, item);
        }
    }
    fn visit_use_name(&mut self, name: &'ast syn::UseName) {
        self.name(&name.ident);
    }
    fn visit_use_rename(&mut self, name: &'ast syn::UseRename) {
        self.name(&name.rename);
    }
    fn visit_ident(&mut self, ident: &'ast syn::Ident) {
        self.use_of(ident);
    }
    fn visit_expr_cast(&mut self, cast: &'ast syn::ExprCast) {
        if let syn::Type::Path(path) = &*cast.ty
            && let Some(ident) = path.path.get_ident()
            && ident.to_string().starts_with(['i', 'u'])
        {
            let line = ident.span().start().line.saturating_sub(1);
            self.floats.push((line, "a cast to a whole number beside exact numbers".into()));
        }
        syn::visit::visit_expr_cast(self, cast);
    }
    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        fn each(tokens: proc_macro2::TokenStream, watch: &mut Watch) {
            for token in tokens {
                match token {
                    TokenTree::Group(group) => each(group.stream(), watch),
                    TokenTree::Ident(ident) => watch.use_of(&ident),
                    _ => {}
                }
            }
        }
        each(mac.tokens.clone(), self);
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
            "format!(\"{:.2} s\", t)",
            "format!(\"{t:.2} s\")",
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
        let found = |text: &str| {
            let statements = syn::Block::parse_within.parse_str(text).unwrap();
            laundering(&statements).len()
        };
        assert_eq!(found("use tumbling_proofs::{enclosed, exactly}; enclosed(x); let n = x as f64;"), 0);
        for wrong in [
            "fn exactly(x: f64) -> f64 { x }",
            "let enclosed = |x| x;",
            "macro_rules! given { () => {} }",
            "use other::exactly;",
            "use tumbling_proofs::Rational; use a::b as enclosed;",
            "assert_eq!(exactly(Rational::of_f64(x)), y);",
            "let n = x as i64; exactly(n);",
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
