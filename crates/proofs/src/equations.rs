//! Equations in TeX, each proven for the meanings of its names. These are results of the library's functions,
//! the sums of its closed form among them; or formulas that are written here a second time, and have a
//! meaning only if the library's laws hold for them; or, of a lemma, mathematics alone.
//!
//! [`read`] receives the pieces of maths of a text, and the [laws](Law) that the text is [`Expected`] to
//! state. Every statement must be one of three. It is one of these laws, and is then proven from its TeX. Or
//! it is one of the exemptions, each with its reason, which are compared only as text. Or it only assigns
//! values, which are numbers and not laws. A law or exemption that is missing is also a fault. A bare
//! expression is a name alone, or a law whose value the sentence around it states, or notation. TeX that
//! cannot be read is a fault.
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

use crate::proof::Kind;
use crate::tex::{Node, Statement, parse};
use std::fmt;

/// A piece of maths of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equation {
    /// Its line in the text.
    pub line: usize,
    /// The TeX between the dollar signs.
    pub tex: String,
    /// Whether it is displayed.
    pub display: bool,
}

/// What is wrong with an equation of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Its line in the text; `None` for what is missing from it.
    pub line: Option<usize>,
    /// The TeX in the text, or the TeX that is missing.
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

/// An equation without fault, and the reason.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Settled {
    /// Its line in the text.
    pub line: usize,
    /// The TeX in the text, without spaces.
    pub tex: String,
    /// What it was proven to be; or the reason why it needs no proof.
    pub why: &'static str,
    /// The kind of the proof, of it or of a part of it.
    pub kind: Option<Kind>,
}

/// The laws and exemptions that a text must state, each as often as the text must have it.
#[derive(Debug, Clone, Copy)]
pub struct Expected {
    /// Laws; those with the same left side in the order of the text.
    pub laws: &'static [Law],
    /// Statements that claim nothing about the library, or for which a proof shows what the reason says.
    pub exemptions: &'static [Exemption],
    /// Bare expressions, inline, that name something and state nothing about it.
    pub notation: &'static [Exemption],
}

impl Expected {
    /// No law at all.
    pub const NOTHING: Self = Self { laws: &[], exemptions: &[], notation: &[] };
}

/// The findings in a text.
#[derive(Debug, Clone, Default)]
pub struct Found {
    /// Equations proven from their TeX.
    pub proven: Vec<Settled>,
    /// Equations compared as text; a proof shows a part of them, which the reason names.
    pub apart: Vec<Settled>,
    /// Equations exempt.
    pub exempt: Vec<Settled>,
    /// Bare expressions that name something, other than by a name alone.
    pub notation: Vec<Settled>,
    /// Equations that only assign values.
    pub values: Vec<Settled>,
    /// The faults.
    pub faults: Vec<Fault>,
}

/// The kind of a statement.
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

/// Whether it is a number with a power of ten, which may be too large or too small to be computed here.
fn is_power_of_ten(tex: &str) -> bool {
    let tex = tex.replace(' ', "");
    let (factor, power) = tex.rsplit_once(r"\times").unwrap_or(("1", &tex));
    let exponent = power.strip_prefix("10^{").and_then(|rest| rest.strip_suffix('}'));
    let exponent = exponent.map(|n| n.strip_prefix('-').unwrap_or(n));
    let digits = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    let (whole, decimals) = factor.split_once('.').unwrap_or((factor, "0"));
    exponent.is_some_and(digits) && digits(whole) && digits(decimals)
}

/// The statements of one piece of maths, each with its kind.
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
            found.notation.push(Settled { line: equation.line, tex, why: notation.reason, kind: None });
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
        let settled = |why| Settled { line: equation.line, tex: statement.text.clone(), why, kind: None };
        let problem = match standing {
            Some(Standing::Exempt(exemption)) => match exemption.prove() {
                Ok(None) => return self.exempt.push(settled(exemption.reason)),
                Ok(kind) => return self.apart.push(Settled { kind, ..settled(exemption.reason) }),
                Err(problem) => problem,
            },
            Some(Standing::Values) => return self.values.push(settled("only values")),
            Some(Standing::Law(law)) => match law.prove(statement) {
                Ok(()) => return self.proven.push(Settled { kind: Some(law.kind), ..settled(law.says) }),
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

/// The expected statements that are missing.
fn missing(ledger: &Ledger) -> Vec<Fault> {
    let fault = |tex: &str, problem: String| Fault { line: None, tex: tex.to_owned(), problem };
    let laws = ledger.laws.iter().map(|law| fault(law.left, format!("this law is not found: {}", law.says)));
    let exemptions = ledger.exemptions.iter().chain(&ledger.notation);
    let exemptions = exemptions.map(|e| fault(e.tex, "exempt, but no longer there".to_owned()));
    laws.chain(exemptions).collect()
}
