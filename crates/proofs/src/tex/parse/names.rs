//! Names, with all that belongs to them.

use super::{Parser, TexError};
use crate::tex::token::Kind;
use crate::tex::tree::Node;

const GREEK: &str = r"\alpha \beta \gamma \delta \epsilon \zeta \eta \theta \iota \kappa \lambda \mu \nu \xi \pi \rho \sigma \tau \upsilon \phi \chi \psi \omega \Omega";

/// What is set over or around a name.
const DRESSES: [&str; 5] = [r"\mathbf", r"\boldsymbol", r"\bar", r"\dot", r"\ddot"];

impl Parser<'_> {
    /// A function of a name is a name of its own.
    pub(super) fn function(&mut self) -> Result<Node, TexError> {
        let function = self.peek_text();
        self.next += 1;
        let bracket = self.take("(");
        let argument = self.name()?;
        if bracket {
            self.need(")", "a closing bracket: only functions of a name are read")?;
        }
        Ok(Node::Name(format!("{function}({argument})")))
    }

    /// A function by its name in upright letters, with primes, of a name or by itself.
    pub(super) fn operator(&mut self) -> Result<Node, TexError> {
        self.next += 1;
        self.need("{", "the letters of a function")?;
        let from = self.next;
        while self.peek().is_some_and(|token| token.kind == Kind::Letter) {
            self.next += 1;
        }
        let mut function = format!(r"\operatorname{{{}}}", self.written(from));
        self.need("}", "the letters of a function")?;
        while self.take("'") {
            function += "'";
        }
        if self.take("(") {
            function = format!("{function}({})", self.name()?);
            self.need(")", "a closing bracket: only functions of a name are read")?;
        }
        Ok(Node::Name(function))
    }

    /// A name with dress, index and primes, written in one way.
    pub(super) fn name(&mut self) -> Result<String, TexError> {
        let mut name = self.deeper(Self::bare_name)?;
        while self.take("'") {
            name += "'";
        }
        if self.take("_") {
            let index = self.index()?;
            name = if index.chars().count() == 1 {
                format!("{name}_{index}")
            } else {
                format!("{name}_{{{index}}}")
            };
        }
        Ok(name)
    }

    fn bare_name(&mut self) -> Result<String, TexError> {
        let Some(token) = self.peek() else { return self.error("a name") };
        let readable = match token.kind {
            Kind::Letter | Kind::Text => true,
            Kind::Command => {
                GREEK.split(' ').any(|letter| letter == token.text) || DRESSES.contains(&token.text)
            }
            _ => false,
        };
        if !readable {
            return self.error("a name, or a command that the book's equations use");
        }
        self.next += 1;
        if !DRESSES.contains(&token.text) {
            return Ok(token.text.to_owned());
        }
        let braces = self.take("{");
        let inner = self.deeper(if braces { Self::name } else { Self::bare_name })?;
        if braces {
            self.need("}", "a closing brace")?;
        }
        Ok(format!("{}{{{inner}}}", token.text))
    }

    fn index(&mut self) -> Result<String, TexError> {
        let braces = self.take("{");
        let from = self.next;
        while let Some(token) = self.peek() {
            match token.kind {
                Kind::Number if !braces && token.text.len() > 1 => {
                    return self.error("braces around the index");
                }
                Kind::Number | Kind::Letter | Kind::Text => self.next += 1,
                _ => break,
            }
            if !braces {
                break;
            }
        }
        let index = self.written(from);
        if index.is_empty() {
            return self.error("an index of letters, digits or text");
        }
        if braces {
            self.need("}", "a closing brace")?;
        }
        Ok(index)
    }
}
