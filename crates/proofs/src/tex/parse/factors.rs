//! What stands side by side: numbers, names, brackets, fractions, and their powers.

use super::{Parser, TexError};
use crate::number::Rational;
use crate::tex::token::Kind;
use crate::tex::tree::Node;

/// No higher powers are read, so that no short text can ask for a long time.
const HIGHEST: i32 = 16;

const FUNCTIONS: [&str; 3] = [r"\sin", r"\cos", r"\tan"];

const FRACTIONS: [&str; 3] = [r"\frac", r"\tfrac", r"\dfrac"];

impl Parser<'_> {
    pub(super) fn power(&mut self) -> Result<Node, TexError> {
        let base = self.factor()?;
        if !self.take("^") {
            return Ok(base);
        }
        let braces = self.take("{");
        let token = self.peek();
        let result = match token.map(|t| (t.text, t.kind)) {
            Some((r"\mathsf", _)) => {
                self.next += 1;
                let inner = self.take("{");
                self.need("T", "the T of a transpose")?;
                if inner {
                    self.need("}", "a closing brace")?;
                }
                Node::Transpose(Box::new(base))
            }
            Some((r"\top" | "T", _)) => {
                self.next += 1;
                Node::Transpose(Box::new(base))
            }
            Some(("-", _)) if braces => {
                self.next += 1;
                Node::Power(Box::new(base), -self.exponent(braces)?)
            }
            Some((_, Kind::Number)) => Node::Power(Box::new(base), self.exponent(braces)?),
            _ => return self.error("a whole power or the T of a transpose"),
        };
        if braces {
            self.need("}", "a closing brace")?;
        }
        if matches!(self.peek_text(), "^" | "_") {
            return self.error("brackets, not a second exponent or an index after one");
        }
        Ok(result)
    }

    fn exponent(&mut self, braces: bool) -> Result<i32, TexError> {
        let text = self.peek_text();
        let value = text.parse().ok().filter(|n| *n <= HIGHEST && (braces || text.len() == 1));
        let Some(value) = value else {
            return self.error("a whole power from 0 to 16, in braces unless one digit");
        };
        self.next += 1;
        Ok(value)
    }

    fn factor(&mut self) -> Result<Node, TexError> {
        let expected = "a number, a name or a bracket";
        let Some(token) = self.peek() else { return self.error(expected) };
        match (token.kind, token.text) {
            (Kind::Number, text) => {
                let Some(value) = Rational::of_decimal(text) else { return self.error("a number") };
                self.next += 1;
                Ok(Node::Number(value))
            }
            (Kind::Mark, "(") => self.deeper(Self::bracket),
            (Kind::Fence, r"\begin{pmatrix}") => self.deeper(Self::matrix),
            (Kind::Command, text) if FRACTIONS.contains(&text) => {
                self.next += 1;
                let above = self.deeper(Self::group)?;
                let below = self.deeper(Self::group)?;
                Ok(Node::Quotient(Box::new(above), Box::new(below)))
            }
            (Kind::Command, r"\sqrt") => {
                self.next += 1;
                Ok(Node::Root(Box::new(self.deeper(Self::group)?)))
            }
            (Kind::Command, r"\sum") => {
                self.next += 1;
                Ok(Node::Total(Box::new(self.deeper(Self::term)?)))
            }
            (Kind::Command, text) if FUNCTIONS.contains(&text) => self.function(),
            (Kind::Command, r"\operatorname") => self.operator(),
            (Kind::Letter | Kind::Text | Kind::Command, _) => Ok(Node::Name(self.name()?)),
            _ => self.error(expected),
        }
    }

    fn group(&mut self) -> Result<Node, TexError> {
        self.need("{", "an opening brace")?;
        let inner = self.sum()?;
        self.need("}", "a closing brace")?;
        Ok(inner)
    }

    fn bracket(&mut self) -> Result<Node, TexError> {
        self.need("(", "an opening bracket")?;
        let mut parts = vec![self.sum()?];
        while self.take(",") {
            parts.push(self.sum()?);
        }
        self.need(")", "a comma or a closing bracket")?;
        Ok(if parts.len() == 1 { parts.swap_remove(0) } else { Node::Tuple(parts) })
    }

    fn matrix(&mut self) -> Result<Node, TexError> {
        self.need(r"\begin{pmatrix}", "a matrix")?;
        let mut rows = Vec::new();
        loop {
            let mut row = vec![self.sum()?];
            while self.take("&") {
                row.push(self.sum()?);
            }
            rows.push(row);
            if self.take(r"\end{pmatrix}") {
                return Ok(Node::Matrix(rows));
            }
            self.need(r"\\", "the next entry, the next row or the end of the matrix")?;
        }
    }
}
