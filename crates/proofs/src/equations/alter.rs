//! What proofs of equations would miss: each proven equation altered in every way, one change at a time.

use super::{Equation, Expected, Ledger, Standing, standings};
use crate::tex::{Scope, Site, SiteKind, Statement, parse, parse_with_sites};

/// What became of the altered copies of a text's equations.
#[derive(Debug, Clone, Default)]
pub struct Alterations {
    /// How many were made.
    pub made: usize,
    /// How many were found false, or without meaning.
    pub noticed: usize,
    /// The others: each is proven to be true as well.
    pub still_true: Vec<StillTrue>,
}

/// An altered equation that is true, by the same proof as the one in the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StillTrue {
    /// The line of the equation in the text.
    pub line: usize,
    /// What was done.
    pub change: String,
    /// What came of it.
    pub tex: String,
    /// Whether each side is still worth what it was: written otherwise, it says the same. Otherwise it says
    /// something else that is also true.
    pub same_sides: bool,
}

/// Alters each proven equation of a text: every sign, index, power, number, sign of order and product
/// changed; every name doubled, repeated, left out and exchanged; every two names swapped.
#[must_use]
pub fn alterations(expected: &Expected, equations: &[Equation]) -> Alterations {
    let mut table = Alterations::default();
    let mut ledger = Ledger::new(expected);
    for equation in equations {
        if ledger.find_notation(equation).is_some() {
            continue;
        }
        let Ok(standings) = standings(equation, &mut ledger) else { continue };
        let laws: Vec<_> = standings.iter().map(|(_, standing)| standing.as_ref()).collect();
        if !laws.iter().any(|standing| matches!(standing, Some(Standing::Law(_)))) {
            continue;
        }
        let points = laws.iter().map(|standing| match standing {
            Some(Standing::Law(law)) => law.points(),
            _ => Vec::new(),
        });
        let points: Vec<_> = points.collect();
        for (change, tex) in altered(&equation.tex) {
            table.made += 1;
            match holds(&tex, &laws, &points, &standings) {
                Some(same_sides) => {
                    table.still_true.push(StillTrue { line: equation.line, change, tex, same_sides });
                }
                None => table.noticed += 1,
            }
        }
    }
    table
}

/// If an altered equation is proven too, for the same laws: whether its sides are worth what they were.
fn holds(
    tex: &str,
    laws: &[Option<&Standing>],
    points: &[Vec<Scope>],
    before: &[(Statement, Option<Standing>)],
) -> Option<bool> {
    let statements = parse(tex).ok().filter(|statements| statements.len() == laws.len())?;
    let mut same_sides = true;
    for (((statement, standing), points), (was, _)) in statements.iter().zip(laws).zip(points).zip(before) {
        match standing {
            Some(Standing::Law(law)) if law.fails_near(statement, points) => return None,
            Some(Standing::Law(law)) if law.prove(statement).is_ok() => {
                same_sides &= law.says_the_same(statement, was);
            }
            Some(Standing::Law(_)) => return None,
            _ if statement.text == was.text => {}
            _ => return None,
        }
    }
    Some(same_sides)
}

/// Every altered copy, with what was done.
fn altered(tex: &str) -> Vec<(String, String)> {
    let Ok((statements, sites)) = parse_with_sites(tex) else { return Vec::new() };
    let names: Vec<_> = sites.iter().filter(|site| site.kind == SiteKind::Name).collect();
    let mut copies = Vec::new();
    for statement in &statements {
        let end = statement.others.last().map_or(&statement.left, |(_, side)| side).range.end;
        for number in ["0", "7", r"\frac{1}{2}"] {
            let copy = format!("{} = {number} {}", &tex[..end], &tex[end..]);
            copies.push((format!("= {number} appended"), copy));
        }
    }
    for site in &sites {
        for (change, text) in changes(site, &tex[site.range.clone()], &names, tex) {
            copies.push((change, with(tex, &[(site, &text)])));
        }
    }
    for (i, first) in names.iter().enumerate() {
        for second in &names[i + 1..] {
            let (a, b) = (&tex[first.range.clone()], &tex[second.range.clone()]);
            if a != b {
                copies.push((format!("{a} and {b} swapped"), with(tex, &[(first, b), (second, a)])));
            }
        }
    }
    copies
}

/// The text with other parts at these sites, in order.
fn with(tex: &str, parts: &[(&Site, &str)]) -> String {
    let mut text = String::new();
    let mut at = 0;
    for (site, part) in parts {
        // Spaces, for a command ends where a letter follows.
        text += &format!("{} {part} ", &tex[at..site.range.start]);
        at = site.range.end;
    }
    text + &tex[at..]
}

/// What can be done to one site, and what then stands there.
fn changes(site: &Site, text: &str, names: &[&Site], tex: &str) -> Vec<(String, String)> {
    let to = |new: &str| (format!("{text} to {new}"), new.to_owned());
    match site.kind {
        SiteKind::Sign => vec![to(if text == "+" { "-" } else { "+" })],
        SiteKind::Operator => vec![to(if text == r"\times" { r"\cdot" } else { r"\times" })],
        SiteKind::Relation => match text {
            "<" => vec![to(">")],
            ">" => vec![to("<")],
            r"\le" | r"\leq" => vec![to(r"\ge"), to("<")],
            r"\ge" | r"\geq" => vec![to(r"\le"), to(">")],
            _ => vec![to("<"), to(">")],
        },
        SiteKind::Power => {
            let mut changes = vec![(format!("{text} left out"), String::new())];
            changes.extend(next_number(text).map(|next| to(&next)));
            changes
        }
        SiteKind::Number => next_number(text).map(|next| to(&next)).into_iter().collect(),
        SiteKind::Index => {
            other_indices(text).iter().map(|new| (format!("index {text} to {new}"), new.clone())).collect()
        }
        SiteKind::Name => {
            let mut changes = vec![
                (format!("{text} doubled"), format!("2 {text}")),
                (format!("{text} negated"), format!("(-1) {text}")),
                (format!("{text} repeated"), format!("{text} {text}")),
                (format!("{text} left out"), "1".to_owned()),
            ];
            changes.extend(
                text.strip_prefix(r"\dot").map(|bare| (format!("{text} without its dot"), bare.to_owned())),
            );
            let mut others: Vec<_> = names.iter().map(|other| &tex[other.range.clone()]).collect();
            others.sort_unstable();
            others.dedup();
            changes.extend(others.into_iter().filter(|other| *other != text).map(to));
            changes
        }
    }
}

/// The last digit raised by one, 9 to 0.
fn next_number(text: &str) -> Option<String> {
    let place = text.rfind(|c: char| c.is_ascii_digit())?;
    let digit = text[place..].chars().next()?.to_digit(10)?;
    Some(format!("{}{}{}", &text[..place], (digit + 1) % 10, &text[place + 1..]))
}

/// Each letter, digit or word of an index replaced by the others of its kind.
fn other_indices(text: &str) -> Vec<String> {
    const KINDS: [&[&str]; 4] = [&["x", "y", "z"], &["1", "2", "3"], &["a", "b"], &["body", "world"]];
    let words: Vec<&str> = if text.contains(r"\text") {
        vec![text.trim_start_matches('{').trim_start_matches(r"\text{").trim_end_matches('}')]
    } else {
        text.split("").filter(|c| !c.is_empty()).collect()
    };
    let mut found = Vec::new();
    let mut at = 0;
    for word in words {
        at += text[at..].find(word).unwrap_or(0);
        let kind = KINDS.iter().find(|kind| kind.contains(&word)).copied().unwrap_or_default();
        for other in kind.iter().filter(|other| **other != word) {
            found.push(format!("{}{other}{}", &text[..at], &text[at + word.len()..]));
        }
        at += word.len();
    }
    found
}
