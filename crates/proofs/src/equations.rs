//! Equations in TeX, each proven of what its names mean: what functions of the library give, the sums of its
//! closed form too, or, of that form's constants, formulas that are written here a second time.
//!
//! [`read`] takes the pieces of maths of a text, and the [laws](Law) that it is [`Expected`] to state.
//! Whatever states something must be one of these laws, and is then proven as it stands there, in TeX; or one
//! of the exemptions, each with its reason, which are compared as text alone; or give nothing but values,
//! which are numbers and not laws. A law or exemption that is not found is a fault too. A bare expression is
//! a name alone, or a law whose worth the sentence around it states, or notation. What cannot be read is a
//! fault.
//!
//! ```
//! use tumbling_proofs::equations::laws;
//! assert_eq!(laws::PLANAR_MOMENTUM.holds(r"\mathbf{L} = (I_1\,\omega_x,\; I_2\,\omega_y)"), Ok(()));
//! let wrong = laws::PLANAR_MOMENTUM.holds(r"\mathbf{L} = (I_2\,\omega_x,\; I_1\,\omega_y)");
//! assert!(wrong.unwrap_err().contains("leaves"));
//! ```

mod bodies;
mod closed;
mod heavy;
pub mod laws;
mod motion;
mod steps;
mod tops;

pub(crate) use closed::{of_motion, variation};
pub use laws::{Exemption, Law};
pub(crate) use motion::{in_order, rates, slant};

use crate::tex::{Node, Statement, parse};
use std::fmt;

/// A piece of maths of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equation {
    /// Its line in the text.
    pub line: usize,
    /// What stands between the dollar signs.
    pub tex: String,
    /// Whether it stands on its own.
    pub display: bool,
}

/// What is wrong with an equation of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Its line in the text; `None` for what is missing from it.
    pub line: Option<usize>,
    /// As it stands there, or should.
    pub tex: String,
    /// What is wrong.
    pub problem: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        write!(f, "`{}`: {}", self.tex, self.problem)
    }
}

impl std::error::Error for Fault {}

/// An equation that is in order, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Settled {
    /// Its line in the text.
    pub line: usize,
    /// As it stands there, without spaces.
    pub tex: String,
    /// What it was proven to be; or the reason why it need not be.
    pub why: &'static str,
    /// Whether it was proven to be a formula that is written here a second time.
    pub again: bool,
}

/// What a text is to state: each law and exemption as often as it stands there.
#[derive(Debug, Clone, Copy)]
pub struct Expected {
    /// Laws; those with one left side in the order of the text.
    pub laws: &'static [Law],
    /// Statements that claim nothing about the library, or of which a proof holds what the reason says.
    pub exemptions: &'static [Exemption],
    /// Bare expressions, inline, that name a thing and say nothing about it.
    pub notation: &'static [Exemption],
}

impl Expected {
    /// No law at all.
    pub const NOTHING: Self = Self { laws: &[], exemptions: &[], notation: &[] };
}

/// What was found in a text.
#[derive(Debug, Clone, Default)]
pub struct Found {
    /// Equations proven as they stand there.
    pub proven: Vec<Settled>,
    /// Equations compared as text, of which a proof shows a part: what the reason says.
    pub apart: Vec<Settled>,
    /// Equations exempt.
    pub exempt: Vec<Settled>,
    /// Bare expressions that name something, other than by a name alone.
    pub notation: Vec<Settled>,
    /// Equations that give nothing but values.
    pub values: Vec<Settled>,
    /// What is wrong.
    pub faults: Vec<Fault>,
}

/// What a statement is to be taken for.
enum Standing {
    Law(&'static Law),
    Exempt(&'static Exemption),
    /// A name alone, or a number.
    Name,
    Values,
}

/// The laws and exemptions that are not found yet.
struct Ledger {
    laws: Vec<&'static Law>,
    exemptions: Vec<&'static Exemption>,
    notation: Vec<&'static Exemption>,
}

impl Ledger {
    fn new(expected: &Expected) -> Self {
        let Expected { laws, exemptions, notation } = expected;
        Self {
            laws: laws.iter().collect(),
            exemptions: exemptions.iter().collect(),
            notation: notation.iter().collect(),
        }
    }

    /// A piece of maths in a line that is notation as a whole, whether it can be read or not.
    fn find_notation(&mut self, equation: &Equation) -> Option<&'static Exemption> {
        let place = self.notation.iter().position(|n| !equation.display && same_tex(n.tex, &equation.tex))?;
        Some(self.notation.remove(place))
    }

    /// Of what is not yet found, the first that this can be.
    fn find(&mut self, statement: &Statement) -> Option<Standing> {
        if let Some(place) = self.exemptions.iter().position(|e| same_tex(e.tex, &statement.text)) {
            return Some(Standing::Exempt(self.exemptions.remove(place)));
        }
        let bare = statement.others.is_empty();
        if !bare && statement.gives_values() {
            return Some(Standing::Values);
        }
        let same = |law: &&Law| law.bare == bare && same_tex(law.left, &statement.left.text);
        if let Some(place) = self.laws.iter().position(same) {
            return Some(Standing::Law(self.laws.remove(place)));
        }
        let tree = &statement.left.tree;
        (bare && (matches!(tree, Node::Name(_)) || tree.is_numeric())).then_some(Standing::Name)
    }
}

fn same_tex(a: &str, b: &str) -> bool {
    let bare = |tex: &str| tex.replace(' ', "");
    bare(a) == bare(b)
}

/// Whether it is a number written with a power of ten, which may be too large or small to be worked out here.
fn is_power_of_ten(tex: &str) -> bool {
    let tex = tex.replace(' ', "");
    let (factor, power) = tex.rsplit_once(r"\times").unwrap_or(("1", &tex));
    let exponent = power.strip_prefix("10^{").and_then(|rest| rest.strip_suffix('}'));
    let exponent = exponent.map(|n| n.strip_prefix('-').unwrap_or(n));
    let digits = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    let (whole, decimals) = factor.split_once('.').unwrap_or((factor, "0"));
    exponent.is_some_and(digits) && digits(whole) && digits(decimals)
}

/// The statements of one piece of maths with what each is to be taken for.
fn standings(equation: &Equation, ledger: &mut Ledger) -> Result<Vec<(Statement, Option<Standing>)>, Fault> {
    let statements = match parse(&equation.tex) {
        Ok(statements) => statements,
        Err(_) if is_power_of_ten(&equation.tex) => return Ok(Vec::new()),
        Err(error) => return Err(equation.fault(error.to_string())),
    };
    let found = |statement: Statement| {
        let standing = ledger.find(&statement);
        (statement, standing)
    };
    Ok(statements.into_iter().map(found).collect())
}

impl Equation {
    fn fault(&self, problem: String) -> Fault {
        let words: Vec<_> = self.tex.split_whitespace().collect();
        Fault { line: Some(self.line), tex: words.join(" "), problem }
    }
}

/// Reads, settles and counts the equations of a text.
#[must_use]
pub fn read(expected: &Expected, equations: &[Equation]) -> Found {
    let mut found = Found::default();
    let mut ledger = Ledger::new(expected);
    for equation in equations {
        if let Some(notation) = ledger.find_notation(equation) {
            let tex = equation.tex.replace(' ', "");
            found.notation.push(Settled { line: equation.line, tex, why: notation.reason, again: false });
            continue;
        }
        match standings(equation, &mut ledger) {
            Ok(standings) => {
                for (statement, standing) in standings {
                    found.take(equation, &statement, standing);
                }
            }
            Err(fault) => found.faults.push(fault),
        }
    }
    found.faults.extend(missing(&ledger));
    found
}

impl Found {
    /// Settles one statement of an equation.
    fn take(&mut self, equation: &Equation, statement: &Statement, standing: Option<Standing>) {
        let settled = |why| Settled { line: equation.line, tex: statement.text.clone(), why, again: false };
        let problem = match standing {
            Some(Standing::Exempt(exemption)) => match (exemption.prove(), exemption.proof) {
                (Ok(()), Some(_)) => return self.apart.push(settled(exemption.reason)),
                (Ok(()), None) => return self.exempt.push(settled(exemption.reason)),
                (Err(problem), _) => problem,
            },
            Some(Standing::Values) => return self.values.push(settled("only values")),
            Some(Standing::Law(law)) => match law.prove(statement) {
                Ok(()) => return self.proven.push(Settled { again: law.again, ..settled(law.says) }),
                Err(problem) => problem,
            },
            Some(Standing::Name) => return,
            None if statement.others.is_empty() => {
                "more than a name, and neither a law nor notation expected here".to_owned()
            }
            None => format!("no law for a left side `{}` is expected here", statement.left.text),
        };
        self.faults.push(equation.fault(problem));
    }
}

/// What was expected and is not there.
fn missing(ledger: &Ledger) -> Vec<Fault> {
    let fault = |tex: &str, problem: String| Fault { line: None, tex: tex.to_owned(), problem };
    let laws = ledger.laws.iter().map(|law| fault(law.left, format!("this law is not found: {}", law.says)));
    let exemptions = ledger.exemptions.iter().chain(&ledger.notation);
    let exemptions = exemptions.map(|e| fault(e.tex, "exempt, but no longer there".to_owned()));
    laws.chain(exemptions).collect()
}
