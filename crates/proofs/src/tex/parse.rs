//! From tokens to trees. Everything that cannot be read is refused, with its place.

mod factors;
mod names;

use super::error::TexError;
use super::token::{Kind, Token, tokens};
use super::tree::{Node, Relation, Side, Statement};

/// The maximum depth of brackets, so that no text can exhaust the stack.
const DEEPEST: usize = 32;

/// Reads one piece of maths: equations, inequalities and bare expressions, one or several, with commas,
/// `\qquad` or the rows of an `aligned` between them, a mark of the sentence at the end.
///
/// Juxtaposition is a product and binds tighter than `\cdot` and `\times`. So does `/`, which applies only to
/// the next factor; no factor may follow that. Ambiguous TeX is refused: several `\times` in a row, `a/b c`,
/// `x^12`.
///
/// # Errors
/// The part that cannot be read, and its place.
pub fn parse(tex: &str) -> Result<Vec<Statement>, TexError> {
    let tokens = tokens(tex)?;
    Parser { tokens, next: 0, end: tex.len(), depth: 0 }.document()
}

struct Parser<'a> {
    tokens: Vec<Token<'a>>,
    next: usize,
    end: usize,
    depth: usize,
}

impl<'a> Parser<'a> {
    fn peek(&self) -> Option<Token<'a>> {
        self.tokens.get(self.next).copied()
    }

    fn peek_text(&self) -> &'a str {
        self.peek().map_or("", |token| token.text)
    }

    fn at(&self) -> usize {
        self.peek().map_or(self.end, |token| token.at)
    }

    fn error<T>(&self, expected: &'static str) -> Result<T, TexError> {
        Err(TexError::new(self.at(), expected))
    }

    fn take(&mut self, text: &str) -> bool {
        let found = self.peek().is_some_and(|token| token.text == text);
        self.next += usize::from(found);
        found
    }

    fn need(&mut self, text: &str, expected: &'static str) -> Result<(), TexError> {
        if self.take(text) { Ok(()) } else { self.error(expected) }
    }

    /// The parts from one to the next, without spaces.
    fn written(&self, from: usize) -> String {
        self.tokens[from..self.next].iter().map(|token| token.text).collect()
    }

    fn deeper<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T, TexError>) -> Result<T, TexError> {
        if self.depth == DEEPEST {
            return self.error("no bracket this deep");
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    fn document(&mut self) -> Result<Vec<Statement>, TexError> {
        let aligned = self.take(r"\begin{aligned}");
        let mut statements = Vec::new();
        loop {
            statements.push(self.statement(aligned)?);
            let comma = self.take(",");
            if aligned && self.take(r"\\") {
                continue;
            }
            if !aligned && self.take(r"\qquad") {
                if self.peek().is_some_and(|token| token.kind == Kind::Text) {
                    self.next += 1; // A remark.
                    break;
                }
                continue;
            }
            let over = self.peek().is_none() || (aligned && self.peek_text() == r"\end{aligned}");
            if !comma || over {
                break;
            }
        }
        for mark in [".", ",", ";"] {
            if self.take(mark) {
                break;
            }
        }
        if aligned {
            self.need(r"\end{aligned}", "the end of the rows")?;
        }
        for mark in [".", ",", ";"] {
            if self.take(mark) {
                break;
            }
        }
        match self.peek() {
            None => Ok(statements),
            Some(_) => self.error("an operator, a factor or the end"),
        }
    }

    fn statement(&mut self, aligned: bool) -> Result<Statement, TexError> {
        let left = self.side()?;
        let mut others = Vec::new();
        let mut text = left.text.clone();
        loop {
            if aligned {
                self.take("&");
            }
            let sign = self.peek_text();
            let relation = match sign {
                "=" => Relation::Equal,
                "<" => Relation::Less,
                ">" => Relation::Greater,
                r"\le" | r"\leq" => Relation::AtMost,
                r"\ge" | r"\geq" => Relation::AtLeast,
                _ => break,
            };
            self.next += 1;
            if aligned {
                self.take("&");
            }
            let side = self.side()?;
            // A space, for a command ends where a letter follows.
            text = format!("{text}{sign} {}", side.text);
            others.push((relation, side));
        }
        Ok(Statement { left, others, text })
    }

    fn side(&mut self) -> Result<Side, TexError> {
        let from = self.next;
        let tree = self.sum()?;
        Ok(Side { tree, text: self.written(from) })
    }

    fn sum(&mut self) -> Result<Node, TexError> {
        let mut sum: Option<Node> = None;
        loop {
            let plus = self.take("+");
            let minus = !plus && self.take("-");
            if let (Some(sum), false) = (&sum, plus || minus) {
                return Ok(sum.clone());
            }
            let term = self.product()?;
            sum = Some(match (sum, minus) {
                (None, false) => term,
                (None, true) => Node::Negative(Box::new(term)),
                (Some(sum), false) => Node::Sum(Box::new(sum), Box::new(term)),
                (Some(sum), true) => Node::Difference(Box::new(sum), Box::new(term)),
            });
        }
    }

    fn product(&mut self) -> Result<Node, TexError> {
        let mut product = self.term()?;
        let mut crossed = false;
        loop {
            let cross = self.peek_text() == r"\times";
            if crossed && (cross || self.peek_text() == r"\cdot") {
                return self.error("brackets that say which product comes first");
            }
            if !cross && self.peek_text() != r"\cdot" {
                return Ok(product);
            }
            self.next += 1;
            let term = self.term()?;
            let make = if cross { Node::Cross } else { Node::Dot };
            product = make(Box::new(product), Box::new(term));
            crossed = cross;
        }
    }

    /// Factors side by side, perhaps over one more.
    fn term(&mut self) -> Result<Node, TexError> {
        let mut term = self.power()?;
        loop {
            if self.take("/") {
                let divisor = self.power()?;
                term = Node::Quotient(Box::new(term), Box::new(divisor));
                if self.starts_factor() {
                    return self.error("brackets that say what is under the bar");
                }
            } else if self.starts_factor() {
                let factor = self.power()?;
                term = Node::Product(Box::new(term), Box::new(factor));
            } else {
                return Ok(term);
            }
        }
    }

    fn starts_factor(&self) -> bool {
        let Some(token) = self.peek() else { return false };
        match token.kind {
            Kind::Number | Kind::Letter | Kind::Text => true,
            Kind::Command => {
                !matches!(token.text, r"\cdot" | r"\times" | r"\le" | r"\leq" | r"\ge" | r"\geq" | r"\qquad")
            }
            Kind::Fence => token.text == r"\begin{pmatrix}",
            Kind::Mark => token.text == "(",
        }
    }
}
