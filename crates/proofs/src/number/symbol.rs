//! The name of a variable, and how it is written in TeX.

use super::tex::Tex;
use std::fmt;
use std::sync::Arc;

/// The name of a variable. Two symbols are the same exactly when their names are.
///
/// Names are plain: a stem of letters and, if any, an index: `x`, `I1`, `omega2`, `I_xy`, `sn`. That is
/// how they print; in TeX the index goes below, Greek letters become Greek and other words upright.
/// An index of digits is written without a dash: `I_1` is another way to say `I1`.
///
/// ```
/// use tumbling_proofs::{Symbol, Tex};
/// assert_eq!(Symbol::new("I_1"), Symbol::new("I1"));
/// assert_eq!(Symbol::with_index("omega", "2"), Symbol::new("omega2"));
/// assert_eq!(Symbol::new("omega2").parts(), ("omega", "2"));
/// assert_eq!(Symbol::new("I1").to_string(), "I1");
/// assert_eq!(Symbol::new("I1").tex(), "I_{1}");
/// assert_eq!(Symbol::new("omega2").tex(), r"\omega_{2}");
/// assert_eq!(Symbol::new("I_xy").tex(), "I_{xy}");
/// assert_eq!(Symbol::new("sn").tex(), r"\operatorname{sn}");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(Arc<str>);

impl Symbol {
    /// The symbol of this name.
    #[must_use]
    pub fn new(name: &str) -> Self {
        match name.split_once('_') {
            Some((stem, index)) => Self::with_index(stem, index),
            None => Self(name.into()),
        }
    }

    /// The symbol with this stem and this index, which may be empty: the inverse of [`parts`](Self::parts).
    #[must_use]
    pub fn with_index(stem: &str, index: &str) -> Self {
        let digit = |c: char| c.is_ascii_digit();
        let apart = !index.is_empty() && (!index.chars().all(digit) || stem.ends_with(digit));
        Self(format!("{stem}{}{index}", if apart { "_" } else { "" }).into())
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.0
    }

    /// The stem and the index, which is what follows the first `_`, or the digits at the end.
    #[must_use]
    pub fn parts(&self) -> (&str, &str) {
        let name = self.name();
        match name.split_once('_') {
            Some((stem, index)) => (stem, index),
            None => name.split_at(name.trim_end_matches(|c: char| c.is_ascii_digit()).len()),
        }
    }
}

impl From<&str> for Symbol {
    fn from(name: &str) -> Self {
        Self::new(name)
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

const GREEK: [&str; 23] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu",
    "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega",
];

impl Tex for Symbol {
    fn tex(&self) -> String {
        let (stem, index) = self.parts();
        let stem = if GREEK.contains(&stem) {
            format!(r"\{stem}")
        } else if stem.chars().count() > 1 {
            format!(r"\operatorname{{{stem}}}")
        } else {
            stem.to_owned()
        };
        if index.is_empty() { stem } else { format!("{stem}_{{{index}}}") }
    }
}
