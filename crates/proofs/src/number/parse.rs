//! Reads what the fractions print: plain text such as `1/12 m (b^2 + c^2)`.

use super::fraction::Fraction;
use super::rational::Rational;
use super::symbol::Symbol;
use std::fmt;
use std::str::FromStr;

/// No deeper brackets are read, so that no text can exhaust the stack.
const DEEPEST: usize = 64;

/// No higher powers are read, so that no short text can ask for a long time.
const HIGHEST: u32 = 64;

/// Text that is not a fraction of polynomials: where, and what could have stood there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParseError {
    /// The place, in bytes from the start.
    pub at: usize,
    /// What could have stood there.
    pub expected: &'static str,
}

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected {} at byte {}", self.expected, self.at)
    }
}

impl std::error::Error for ParseError {}

/// Numbers, names, `+ - * / ^`, brackets; factors side by side are multiplied, and a division takes only
/// the next factor below: `a / b c` is `(a / b) c`, as it prints.
///
/// ```
/// use tumbling_proofs::Fraction;
/// let box_moment: Fraction = "1/12 m (b^2 + c^2)".parse()?;
/// assert_eq!(box_moment.to_string(), "1/12 b^2 m + 1/12 c^2 m");
/// assert_eq!("x / (x y)".parse(), "1 / y".parse::<Fraction>());
/// let error = "2 +".parse::<Fraction>().unwrap_err();
/// assert_eq!(error.to_string(), "expected a number, a name or a bracket at byte 3");
/// # Ok::<(), tumbling_proofs::ParseError>(())
/// ```
impl FromStr for Fraction {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        let mut reader = Reader { text, at: 0, depth: 0 };
        let sum = reader.sum()?;
        match reader.peek() {
            None => Ok(sum),
            Some(_) => Err(reader.error("an operator, a factor or the end")),
        }
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
}

impl<'a> Reader<'a> {
    fn error(&self, expected: &'static str) -> ParseError {
        ParseError { at: self.at, expected }
    }

    /// The next character that is not a space.
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    /// The longest run of characters that pass.
    fn run(&mut self, pass: impl Fn(char) -> bool) -> &'a str {
        let rest = &self.text[self.at..];
        let run = &rest[..rest.find(|c| !pass(c)).unwrap_or(rest.len())];
        self.at += run.len();
        run
    }

    fn sum(&mut self) -> Result<Fraction, ParseError> {
        let mut sum = Fraction::from(0);
        let mut negative = self.take('-');
        loop {
            let term = self.product()?;
            sum = if negative { sum - term } else { sum + term };
            negative = self.take('-');
            if !negative && !self.take('+') {
                return Ok(sum);
            }
        }
    }

    fn product(&mut self) -> Result<Fraction, ParseError> {
        let mut product = self.power()?;
        loop {
            product = match self.peek() {
                Some('/') => {
                    self.take('/');
                    product / self.power()?
                }
                Some('*') => {
                    self.take('*');
                    product * self.power()?
                }
                Some(c) if c == '(' || c.is_ascii_alphanumeric() => product * self.power()?,
                _ => return Ok(product),
            };
        }
    }

    fn power(&mut self) -> Result<Fraction, ParseError> {
        let base = self.factor()?;
        if !self.take('^') {
            return Ok(base);
        }
        self.peek();
        let start = self.at;
        let exponent = self.run(|c| c.is_ascii_digit()).parse().ok().filter(|n| *n <= HIGHEST);
        let error = ParseError { at: start, expected: "a whole power from 0 to 64" };
        exponent.map(|n| base.pow(n)).ok_or(error)
    }

    fn factor(&mut self) -> Result<Fraction, ParseError> {
        match self.peek() {
            Some('(') if self.depth == DEEPEST => Err(self.error("no bracket this deep")),
            Some('(') => {
                self.take('(');
                self.depth += 1;
                let sum = self.sum()?;
                self.depth -= 1;
                if self.take(')') { Ok(sum) } else { Err(self.error("a closing bracket")) }
            }
            Some(c) if c.is_ascii_digit() => {
                let number = Rational::of_decimal(self.run(|c| c.is_ascii_digit() || c == '.'));
                number.map(Fraction::from).ok_or_else(|| self.error("a number"))
            }
            Some(c) if c.is_ascii_alphabetic() => {
                Ok(Symbol::new(self.run(|c| c.is_ascii_alphanumeric() || c == '_')).into())
            }
            _ => Err(self.error("a number, a name or a bracket")),
        }
    }
}
