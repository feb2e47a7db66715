//! Reads what the fractions print, and sympy: plain text such as `1/12 m (b^2 + c^2)`. Numbers, names, `+ - *
//! / ^`, brackets; factors side by side are multiplied, and a division takes only the next factor below: `a /
//! b c` is `(a / b) c`, as it prints.

use tumbling_proofs::{Fraction, Rational, Symbol};

/// The fraction that a text is.
pub fn read(text: &str) -> Fraction {
    let mut reader = Reader { text, at: 0 };
    let sum = reader.sum().unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(reader.peek(), None, "{text}");
    sum
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Reader<'a> {
    fn error(&self, expected: &str) -> String {
        format!("expected {expected} at byte {} of {}", self.at, self.text)
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

    fn sum(&mut self) -> Result<Fraction, String> {
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

    fn product(&mut self) -> Result<Fraction, String> {
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

    fn power(&mut self) -> Result<Fraction, String> {
        let base = self.factor()?;
        if !self.take('^') {
            return Ok(base);
        }
        self.peek();
        let exponent = self.run(|c| c.is_ascii_digit()).parse();
        exponent.map(|n| base.pow(n)).map_err(|_| self.error("a whole power"))
    }

    fn factor(&mut self) -> Result<Fraction, String> {
        match self.peek() {
            Some('(') => {
                self.take('(');
                let sum = self.sum()?;
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
