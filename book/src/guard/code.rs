//! Reads the Rust of a block: which values it asserts, and which it starts from.

use super::decimal::Decimal;
use proc_macro2::{LineColumn, Span, TokenStream, TokenTree};
use std::collections::HashMap;
use syn::parse::Parser as _;
use syn::punctuated::Punctuated;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprLit, Lit, Pat, Token, UnOp};
use tumbling::dynamics::stability::of_spin;
use tumbling::solid::{Ball, Capsule, Cuboid, Cylinder, Solid as _, ThinPlate};
use tumbling::step::Engine;
use tumbling::{Inertia, PrincipalMoments};

/// What a block says in numbers, in its order.
#[derive(Debug, Default)]
pub(crate) struct Code {
    pub(crate) values: Vec<Value>,
    /// Assertions that would hold whatever the library does: the line, from zero, and why.
    pub(crate) hollow: Vec<(usize, &'static str)>,
    /// Its comments: for each line of each, the line, from zero, and its bytes there.
    pub(crate) comments: Vec<Vec<Literal>>,
}

/// Something that a text may be bound to.
#[derive(Debug, Clone)]
pub(crate) struct Value {
    pub(crate) what: Holds,
    pub(crate) role: Role,
    /// The unit that the code gives it, by the function it goes to or the name it gets.
    pub(crate) unit: Option<&'static str>,
    /// The name of the `let` that holds it and nothing else.
    pub(crate) name: Option<String>,
    /// The literals that make it.
    pub(crate) literals: Vec<Literal>,
}

/// A literal in a block: its line, from zero, and its bytes there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Literal {
    pub(crate) line: usize,
    pub(crate) start: usize,
    pub(crate) end: usize,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Holds {
    One(Decimal),
    Fraction(Decimal, Decimal),
    Tuple(Vec<Decimal>),
    Text(String),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    /// One side of `assert_eq!`, by itself or a member of the array or tuple that is.
    Expected,
    /// A part of what an assertion compares with.
    Compared,
    /// A bound that could be another: the right-hand side of `<`, and the left where it is no distance.
    Tolerance,
    /// What the code starts from.
    Input,
    /// A component of an [`Input`](Role::Input) vector, which only words may mean by itself.
    Component,
    /// What something is divided by, which only a fraction in words may mean: `a twentieth`.
    Divisor,
}

/// Rust that could not be read: the line, from zero, and why.
#[derive(Debug, Clone)]
pub(crate) struct Fault {
    pub(crate) line: usize,
    pub(crate) what: String,
}

/// Reads a block.
///
/// # Errors
/// Where and why it is no Rust.
pub(crate) fn read(text: &str) -> Result<Code, Fault> {
    shallow(text)?;
    let statements = syn::Block::parse_within.parse_str(text).map_err(|e| fault(&e))?;
    let mut reader = Reader {
        lines: text.lines().collect(),
        code: Code::default(),
        parameters: HashMap::new(),
        fault: None,
        perhaps: 0,
    };
    for statement in &statements {
        reader.visit_stmt(statement);
    }
    match reader.fault {
        Some(e) => Err(fault(&e)),
        None => {
            let tokens: TokenStream = text.parse().map_err(|e: proc_macro2::LexError| fault(&e.into()))?;
            let mut literals = Vec::new();
            reader.literals(tokens, &mut literals);
            reader.code.comments = comments(text, &literals);
            Ok(reader.code)
        }
    }
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
            // Signs before an operand nest as well.
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
fn comments(text: &str, literals: &[Literal]) -> Vec<Vec<Literal>> {
    let mut found: Vec<Vec<Literal>> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let quoted = |at: usize| literals.iter().any(|l| l.line == number && (l.start..l.end).contains(&at));
        let Some((at, _)) = line.match_indices("//").find(|&(at, _)| !quoted(at)) else { continue };
        let start = at + line[at..].len() - line[at..].trim_start_matches(['/', '!']).len();
        let part = Literal { line: number, start, end: line.len() };
        let goes_on = line[..at].trim().is_empty();
        match found.last_mut().filter(|c| goes_on && c.last().is_some_and(|last| last.line + 1 == number)) {
            Some(comment) => comment.push(part),
            None => found.push(vec![part]),
        }
    }
    found
}

struct Reader<'a> {
    lines: Vec<&'a str>,
    code: Code,
    /// The parameters' names of the closures and functions of the block.
    parameters: HashMap<String, Vec<String>>,
    fault: Option<syn::Error>,
    /// How many branches surround this, which may never be taken.
    perhaps: usize,
}

/// The unit of a quantity by the name the code gives it.
fn unit_by_name(name: &str) -> Option<&'static str> {
    Some(match name {
        "degrees" | "angle" => "°",
        "seconds" | "step" => "s",
        "omega" | "spin" => "rad/s",
        "momentum" | "l" => "kg m²/s",
        "torque" => "N m",
        "moments" => "kg m²",
        "mass" | "m" => "kg",
        "a" | "b" | "c" => "m",
        _ => return None,
    })
}

/// The name of a function of the library with these arguments, in its last two words where it belongs to a type. Where there is no
/// such function any more, this does not compile.
macro_rules! function {
    ($type:ident::$name:ident: $arguments:ty) => {{
        let _: $arguments = $type::$name;
        concat!(stringify!($type), "::", stringify!($name))
    }};
    (.$name:ident of $type:ident: $arguments:ty) => {{
        let _: $arguments = $type::$name;
        stringify!($name)
    }};
    ($name:ident: $arguments:ty) => {{
        let _: $arguments = $name;
        stringify!($name)
    }};
}

/// A run of the engines of the pitfalls: body, step, number of steps.
const RUN: &str = function!(.run of Engine: fn(_, &_, f64, usize) -> _);

const MOMENTS: &str = function!(PrincipalMoments::new: fn(f64, f64, f64) -> _);

/// The units of the library's functions' arguments, as far as chapters give them literals: of one argument, or of all.
const ARGUMENTS: &[(&str, Option<usize>, &str)] = &[
    (function!(Ball::new: fn(f64) -> _), None, "m"),
    (function!(Capsule::new: fn(f64, f64) -> _), None, "m"),
    (function!(Cuboid::new: fn(f64, f64, f64) -> _), None, "m"),
    (function!(Cylinder::new: fn(f64, f64) -> _), None, "m"),
    (function!(ThinPlate::new: fn(f64, f64) -> _), None, "m"),
    (function!(.with_mass of Cuboid: fn(&_, f64) -> _), Some(0), "kg"),
    (function!(Inertia::from_moments: fn(f64, f64, f64) -> _), None, "kg m²"),
    (MOMENTS, None, "kg m²"),
    (function!(of_spin: fn(_, _, f64) -> _), Some(2), "rad/s"),
    (RUN, Some(1), "s"),
    (RUN, Some(2), "steps"),
];

/// The unit of an argument, counted from zero, of a function of the library.
fn unit_of_argument(function: &str, argument: usize) -> Option<&'static str> {
    let known = |of: &&(&str, Option<usize>, &str)| of.0 == function && of.1.is_none_or(|at| at == argument);
    ARGUMENTS.iter().find(known).map(|of| of.2)
}

impl Reader<'_> {
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

    /// All literals, but not the doc comments that the compiler takes for such.
    fn literals(&self, tokens: TokenStream, into: &mut Vec<Literal>) {
        for token in tokens {
            match token {
                TokenTree::Group(group) => self.literals(group.stream(), into),
                TokenTree::Literal(literal) => {
                    let at = self.literal(literal.span());
                    let written = self.lines.get(at.line).and_then(|line| line.get(at.start..at.end));
                    if !written.is_some_and(|text| text.starts_with("//")) {
                        into.push(at);
                    }
                }
                _ => {}
            }
        }
    }

    fn push(&mut self, what: Holds, role: Role, unit: Option<&'static str>, literals: Vec<Literal>) {
        self.code.values.push(Value { what, role, unit, name: None, literals });
    }

    /// A number, perhaps with a sign.
    fn number(&self, expr: &Expr) -> Option<(Decimal, Literal)> {
        match expr {
            Expr::Lit(ExprLit { lit: Lit::Int(n), .. }) => {
                Some((Decimal::read(n.base10_digits())?, self.literal(n.span())))
            }
            Expr::Lit(ExprLit { lit: Lit::Float(x), .. }) => {
                Some((Decimal::read(x.base10_digits())?, self.literal(x.span())))
            }
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
                self.number(&unary.expr).map(|(n, at)| (n.negated(), at))
            }
            Expr::Paren(inner) => self.number(&inner.expr),
            Expr::Group(inner) => self.number(&inner.expr),
            _ => None,
        }
    }

    /// The numbers of `(1.0, 2.0)`, `[1.0, 2.0]`, `Vector3::new(1.0, 2.0, 3.0)` or principal moments, if it is all numbers.
    fn numbers(&self, expr: &Expr) -> Option<Vec<(Decimal, Literal)>> {
        let members = match expr {
            Expr::Tuple(tuple) => &tuple.elems,
            Expr::Array(array) => &array.elems,
            Expr::Call(call) if ["Vector3::new", MOMENTS].contains(&path(&call.func)?.as_str()) => &call.args,
            Expr::Try(inner) => return self.numbers(&inner.expr),
            Expr::Reference(inner) => return self.numbers(&inner.expr),
            _ => return None,
        };
        (members.len() > 1).then_some(())?;
        members.iter().map(|member| self.number(member)).collect()
    }

    /// One side of `assert_eq!`: whether it is made of literals and nothing else.
    fn expected(&mut self, expr: &Expr) -> bool {
        if let Some((n, at)) = self.number(expr) {
            self.push(Holds::One(n), Role::Expected, None, vec![at]);
            return true;
        }
        if let Some(numbers) = self.numbers(expr) {
            let vector = matches!(expr, Expr::Call(_));
            let (numbers, at): (Vec<_>, Vec<_>) = numbers.into_iter().unzip();
            self.push(Holds::Tuple(numbers.clone()), Role::Expected, None, at.clone());
            if !vector {
                for (n, at) in numbers.into_iter().zip(at) {
                    self.push(Holds::One(n), Role::Expected, None, vec![at]);
                }
            }
            return true;
        }
        match expr {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => {
                let at = self.literal(text.span());
                self.push(Holds::Text(text.value()), Role::Expected, None, vec![at]);
                true
            }
            Expr::Array(array) if array.elems.iter().all(|e| matches!(e, Expr::Lit(_))) => {
                array.elems.iter().all(|e| self.expected(e))
            }
            Expr::Reference(inner) => self.expected(&inner.expr),
            _ => false,
        }
    }

    /// The numbers in an expression that an assertion compares with another.
    fn compared(&mut self, expr: &Expr, role: Role) {
        struct Operands<'r, 'a>(&'r mut Reader<'a>, Role);
        impl<'ast> Visit<'ast> for Operands<'_, '_> {
            fn visit_expr(&mut self, expr: &'ast Expr) {
                let Self(reader, role) = self;
                if let Expr::Binary(binary) = expr
                    && let Some(value) = reader.fraction(binary)
                {
                    return reader.push(value.0, *role, None, value.1);
                }
                if let Some((n, at)) = reader.number(expr) {
                    reader.push(Holds::One(n), *role, None, vec![at]);
                    return;
                }
                match expr {
                    // What a function is given is no part of the comparison, only what it answers.
                    Expr::Call(_) | Expr::Index(_) => reader.visit_expr(expr),
                    Expr::MethodCall(call) => {
                        reader.arguments(&call.method.to_string(), &call.args);
                        self.visit_expr(&call.receiver);
                    }
                    _ => visit::visit_expr(self, expr),
                }
            }
            fn visit_macro(&mut self, mac: &'ast syn::Macro) {
                self.0.visit_macro(mac);
            }
        }
        Operands(self, role).visit_expr(expr);
    }

    fn fraction(&self, binary: &syn::ExprBinary) -> Option<(Holds, Vec<Literal>)> {
        let BinOp::Div(_) = binary.op else { return None };
        let (over, a) = self.number(&binary.left)?;
        let (under, b) = self.number(&binary.right)?;
        Some((Holds::Fraction(over, under), vec![a, b]))
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
                    // Only how far two numbers are apart, `(x - 3.0 / 23.0).abs()`, pins one of them.
                    let apart = matches!(&*binary.left, Expr::MethodCall(c) if c.method == "abs" || c.method == "norm");
                    let role = if apart { Role::Compared } else { Role::Tolerance };
                    if let (true, Some((bound, at))) = (apart, self.number(&binary.right))
                        && !bound.is_within_a_thousandth()
                    {
                        self.code.hollow.push((at.line, "a tolerance of more than a thousandth"));
                    }
                    self.compared(&binary.left, role);
                    self.compared(&binary.right, Role::Tolerance);
                }
                _ => {
                    self.compared(&binary.left, Role::Compared);
                    self.compared(&binary.right, Role::Compared);
                }
            },
            Expr::Paren(inner) => self.claim(&inner.expr),
            other => self.visit_expr(other),
        }
    }

    /// A value that the code starts from.
    fn input(&mut self, expr: &Expr, unit: Option<&'static str>, name: Option<&str>) -> bool {
        if let Some((n, at)) = self.number(expr) {
            self.push(Holds::One(n), Role::Input, unit, vec![at]);
        } else if let Some(numbers) = self.numbers(expr) {
            let (numbers, at): (Vec<_>, Vec<_>) = numbers.into_iter().unzip();
            for (n, at) in numbers.iter().zip(&at) {
                self.push(Holds::One(*n), Role::Component, None, vec![*at]);
            }
            self.push(Holds::Tuple(numbers), Role::Input, unit, at);
        } else {
            return false;
        }
        if let Some(value) = self.code.values.last_mut() {
            value.name = name.map(str::to_owned);
        }
        true
    }

    fn arguments(&mut self, function: &str, arguments: &Punctuated<Expr, Token![,]>) {
        let own = self.parameters.get(function).cloned().unwrap_or_default();
        for (i, argument) in arguments.iter().enumerate() {
            let unit = unit_of_argument(function, i).or_else(|| unit_by_name(own.get(i)?));
            if !self.input(argument, unit, None) {
                self.visit_expr(argument);
            }
        }
    }
}

/// Whether this is made of literals alone: itself, a collection of such, or a format of such.
fn is_literal(expr: &Expr) -> bool {
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
        Expr::Call(call) => {
            let wraps = ["String::from", "Vector3::new", "f64::from", "Some"];
            path(&call.func).is_some_and(|f| wraps.contains(&f.as_str())) && call.args.iter().all(is_literal)
        }
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

/// The last two words of a path: `Vector3::new`, or the only one.
fn path(expr: &Expr) -> Option<String> {
    let Expr::Path(path) = expr else { return None };
    let words: Vec<String> = path.path.segments.iter().map(|s| s.ident.to_string()).collect();
    let last_two = words.len().saturating_sub(2);
    Some(words[last_two..].join("::"))
}

fn name(pattern: &Pat) -> Option<String> {
    match pattern {
        Pat::Ident(ident) => Some(ident.ident.to_string()),
        Pat::Type(typed) => name(&typed.pat),
        _ => None,
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_local(&mut self, local: &'ast syn::Local) {
        let Some(init) = &local.init else { return };
        let expr = &*init.expr;
        if let (Some(name), Expr::Closure(closure)) = (name(&local.pat), expr) {
            let names = closure.inputs.iter().map(|p| self::name(p).unwrap_or_default()).collect();
            self.parameters.insert(name, names);
        }
        // `let (a, b) = (2.0, 1.0)` and `let [a, b] = [2.0, 1.0]` name each member.
        let names: Vec<_> = match &local.pat {
            Pat::Tuple(tuple) => tuple.elems.iter().map(name).collect(),
            Pat::Slice(slice) => slice.elems.iter().map(name).collect(),
            _ => Vec::new(),
        };
        let members = match expr {
            Expr::Tuple(tuple) => Some(&tuple.elems),
            Expr::Array(array) => Some(&array.elems),
            _ => None,
        };
        if let Some(members) = members.filter(|m| m.len() == names.len()) {
            for (member, name) in members.iter().zip(&names) {
                let unit = name.as_deref().and_then(unit_by_name);
                if !self.input(member, unit, name.as_deref()) {
                    self.visit_expr(member);
                }
            }
            return;
        }
        let name = name(&local.pat);
        let unit = name.as_deref().and_then(unit_by_name);
        if !self.input(expr, unit, name.as_deref()) {
            self.visit_expr(expr);
        }
        if let Some((_, diverge)) = &init.diverge {
            self.visit_expr(diverge);
        }
    }

    fn visit_expr_call(&mut self, call: &'ast syn::ExprCall) {
        let function = path(&call.func).unwrap_or_default();
        self.visit_expr(&call.func);
        self.arguments(&function, &call.args);
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        let method = call.method.to_string();
        let unit = (method == "to_radians").then_some("°");
        if !self.input(&call.receiver, unit, None) {
            self.visit_expr(&call.receiver);
        }
        self.arguments(&method, &call.args);
        // A run of so many steps of so many seconds lasts their product.
        if method == RUN
            && let (Some(dt), Some(steps)) = (call.args.get(1), call.args.get(2))
            && let (Some((dt, a)), Some((steps, b))) = (self.number(dt), self.number(steps))
            && let Some(lasts) = dt.times(steps)
        {
            self.push(Holds::One(lasts), Role::Input, Some("s"), vec![a, b]);
        }
    }

    fn visit_expr_binary(&mut self, binary: &'ast syn::ExprBinary) {
        match self.fraction(binary) {
            Some((what, at)) => self.push(what, Role::Input, None, at),
            None => {
                self.visit_expr(&binary.left);
                match (&binary.op, self.number(&binary.right)) {
                    (BinOp::Div(_), Some((n, at))) => self.push(Holds::One(n), Role::Divisor, None, vec![at]),
                    _ => self.visit_expr(&binary.right),
                }
            }
        }
    }

    fn visit_expr_if(&mut self, branch: &'ast syn::ExprIf) {
        self.visit_expr(&branch.cond);
        self.perhaps += 1;
        self.visit_block(&branch.then_branch);
        if let Some((_, other)) = &branch.else_branch {
            self.visit_expr(other);
        }
        self.perhaps -= 1;
    }

    fn visit_expr_index(&mut self, index: &'ast syn::ExprIndex) {
        self.visit_expr(&index.expr); // which member is meant is no quantity
    }

    fn visit_expr(&mut self, expr: &'ast Expr) {
        if !self.input(expr, None, None) {
            visit::visit_expr(self, expr);
        }
    }

    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        let name = mac.path.segments.last().map(|s| s.ident.to_string()).unwrap_or_default();
        let parse = Punctuated::<Expr, Token![,]>::parse_terminated;
        let arguments = match parse.parse2(mac.tokens.clone()) {
            Ok(arguments) => arguments,
            Err(e) => {
                // Other macros have a grammar of their own, and say nothing that a text may repeat.
                if name.starts_with("assert") {
                    self.fault.get_or_insert(e);
                }
                return;
            }
        };
        if name.starts_with("assert") {
            let line = mac.path.segments.first().map_or(0, |s| s.ident.span().start().line.saturating_sub(1));
            if self.perhaps > 0 {
                self.code.hollow.push((line, "an assertion inside a branch, which may never be taken"));
            }
            if name == "assert_eq" && arguments.iter().take(2).all(is_literal) {
                self.code.hollow.push((line, "an assertion of a literal about a literal"));
            }
        }
        let mut arguments = arguments.iter();
        match name.as_str() {
            "assert_eq" => {
                let sides: Vec<&Expr> = arguments.by_ref().take(2).collect();
                for (i, side) in sides.iter().enumerate() {
                    if self.expected(side) {
                        continue;
                    }
                    // Arithmetic beside another side that is no literal is what that is compared with.
                    let arithmetic = matches!(side, Expr::Binary(_)) && i > 0;
                    if arithmetic { self.compared(side, Role::Compared) } else { self.visit_expr(side) }
                }
            }
            "assert" => {
                if let Some(claim) = arguments.next() {
                    self.claim(claim);
                }
            }
            _ => {}
        }
        for rest in arguments {
            self.visit_expr(rest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_gives_its_assertions_and_its_inputs() {
        let code =
            read("let omega = Vector3::new(1.0, -2.0, 0.0);\nassert_eq!(format!(\"{:.1}\", x), \"7.4°\");")
                .unwrap();
        let roles: Vec<_> = code.values.iter().map(|v| (v.what.clone(), v.role)).collect();
        let n = |text| Decimal::read(text).unwrap();
        assert!(roles.contains(&(Holds::Tuple(vec![n("1"), n("-2"), n("0")]), Role::Input)));
        assert!(roles.contains(&(Holds::Text("7.4°".into()), Role::Expected)));
        let vector = code.values.iter().find(|v| matches!(v.what, Holds::Tuple(_))).unwrap();
        assert_eq!((vector.unit, vector.name.as_deref()), (Some("rad/s"), Some("omega")));
    }

    #[test]
    fn a_run_lasts_its_steps_times_their_length() {
        let code = read("let end = engine.run(&start, 0.001, 2050)?[2050];").unwrap();
        let seconds = Decimal::read("2.05").unwrap();
        assert!(code.values.iter().any(|v| v.what == Holds::One(seconds) && v.unit == Some("s")));
    }

    #[test]
    fn broken_rust_is_a_fault_with_its_line() {
        let fault = read("let a = 1;\nlet b = ;\n").unwrap_err();
        assert_eq!(fault.line, 1);
        assert!(read("assert!(1 < );").is_err());
        assert!(read("let s = \"open;").is_err());
    }
}
