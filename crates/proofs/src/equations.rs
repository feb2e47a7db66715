//! The equations of the book, each proven to be what the library's own functions do.
//!
//! [`read_chapter`] takes the pieces of maths of a chapter. Whatever states something must be a law of
//! [`laws`], and is then proven as it stands there, in TeX, against the library; or one of the
//! [`exemptions`], each with its reason; or give nothing but values, which are numbers and not laws. A law or
//! exemption that no longer stands in its chapter is a fault too. A bare expression is a name alone, or a law
//! whose worth the sentence around it states, or on the list of [`notation`]. What cannot be read is a fault.
//!
//! ```
//! use tumbling_proofs::equations::{Equation, read_chapter};
//! let tex = r"\mathbf{L} = (I_1\,\omega_x,\; I_2\,\omega_y),".to_owned();
//! let found = read_chapter("two-arrows", &[Equation { line: 13, tex, display: true }]);
//! assert_eq!(found.proven.len(), 1);
//! let tex = r"\mathbf{L} = (I_2\,\omega_x,\; I_1\,\omega_y),".to_owned();
//! let found = read_chapter("two-arrows", &[Equation { line: 13, tex, display: true }]);
//! assert!(found.faults[0].problem.contains("leaves"));
//! ```

mod alter;
mod bodies;
mod laws;
mod motion;

pub use alter::{Alterations, StillTrue, alterations};
pub use laws::{Exemption, Law, exemptions, laws, notation};

use crate::tex::{Node, Statement, parse};
use std::fmt;

/// A piece of maths of a chapter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equation {
    /// Its line in the chapter.
    pub line: usize,
    /// What stands between the dollar signs.
    pub tex: String,
    /// Whether it stands on its own.
    pub display: bool,
}

/// What is wrong with an equation of a chapter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Its line in the chapter; `None` for what is missing from it.
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
    /// Its line in the chapter.
    pub line: usize,
    /// As it stands there, without spaces.
    pub tex: String,
    /// What it was proven to be; or the reason why it need not be.
    pub why: &'static str,
}

/// What was found in a chapter.
#[derive(Debug, Clone, Default)]
pub struct Chapter {
    /// Equations proven.
    pub proven: Vec<Settled>,
    /// Equations exempt.
    pub exempt: Vec<Settled>,
    /// Bare expressions that name something, other than by a name alone.
    pub notation: Vec<Settled>,
    /// Equations that give nothing but values.
    pub values: Vec<Settled>,
    /// What is wrong.
    pub faults: Vec<Fault>,
}

/// What a statement of a chapter is to be taken for.
enum Standing {
    Law(&'static Law),
    Exempt(&'static Exemption),
    /// A name alone, or a number.
    Name,
    Values,
}

/// What has been found of the laws and exemptions of a chapter.
struct Ledger {
    laws: Vec<&'static Law>,
    exemptions: Vec<&'static Exemption>,
    notation: Vec<&'static Exemption>,
}

impl Ledger {
    fn new(chapter: &str) -> Self {
        let laws = laws().iter().filter(|law| law.chapter == chapter).collect();
        let exemptions = exemptions().iter().filter(|exemption| exemption.chapter == chapter).collect();
        let notation = notation().iter().filter(|notation| notation.chapter == chapter).collect();
        Self { laws, exemptions, notation }
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

/// Reads, settles and counts the equations of a chapter, by the name of its file without the ending.
#[must_use]
pub fn read_chapter(name: &str, equations: &[Equation]) -> Chapter {
    let mut chapter = Chapter::default();
    let mut ledger = Ledger::new(name);
    for equation in equations {
        if let Some(notation) = ledger.find_notation(equation) {
            let tex = equation.tex.replace(' ', "");
            chapter.notation.push(Settled { line: equation.line, tex, why: notation.reason });
            continue;
        }
        let standings = match standings(equation, &mut ledger) {
            Ok(standings) => standings,
            Err(fault) => {
                chapter.faults.push(fault);
                continue;
            }
        };
        for (statement, standing) in standings {
            let settled = |why| Settled { line: equation.line, tex: statement.text.clone(), why };
            match standing {
                Some(Standing::Exempt(exemption)) => chapter.exempt.push(settled(exemption.reason)),
                Some(Standing::Values) => chapter.values.push(settled("only values")),
                Some(Standing::Law(law)) => match law.prove(&statement) {
                    Ok(()) => chapter.proven.push(settled(law.says)),
                    Err(problem) => chapter.faults.push(equation.fault(problem)),
                },
                Some(Standing::Name) => {}
                None if statement.others.is_empty() => {
                    let problem = "more than a name, and neither a law nor notation expected here".to_owned();
                    chapter.faults.push(equation.fault(problem));
                }
                None => {
                    let problem =
                        format!("no law for a left side `{}` is expected here", statement.left.text);
                    chapter.faults.push(equation.fault(problem));
                }
            }
        }
    }
    chapter.faults.extend(missing(&ledger));
    chapter
}

/// What was to be in the chapter and is not.
fn missing(ledger: &Ledger) -> Vec<Fault> {
    let fault = |tex: &str, problem: String| Fault { line: None, tex: tex.to_owned(), problem };
    let laws = ledger.laws.iter().map(|law| fault(law.left, format!("this law is not found: {}", law.says)));
    let exemptions = ledger.exemptions.iter().chain(&ledger.notation);
    let exemptions = exemptions.map(|e| fault(e.tex, "exempt, but no longer in the chapter".to_owned()));
    laws.chain(exemptions).collect()
}

/// What is wrong with the equations of a chapter; nothing, if all are in order.
#[must_use]
pub fn check_chapter(name: &str, equations: &[Equation]) -> Vec<Fault> {
    read_chapter(name, equations).faults
}

/// Chapters that the laws or exemptions name and that are not among these.
#[must_use]
pub fn missing_chapters(names: &[&str]) -> Vec<&'static str> {
    let laws = laws().iter().map(|law| law.chapter);
    let mut missing: Vec<_> =
        laws.chain(exemptions().iter().chain(notation()).map(|exemption| exemption.chapter)).collect();
    missing.retain(|chapter| !names.contains(chapter));
    missing.sort_unstable();
    missing.dedup();
    missing
}
