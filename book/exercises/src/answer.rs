//! Whether a reader's file may count as an answer, by its text alone.

use crate::exercise::{BEGIN, END, Exercise};
use std::collections::BTreeSet;

/// Why this text of `stubs/NAME.md` is no answer to the exercise, whatever its run says; nothing if it may be
/// one.
///
/// Outside of the marks it has to be the exercise's own, but for the blanks that lines begin and end with.
/// Between them nothing may keep the check from running, or put another value under a name that the check
/// reads.
#[must_use]
pub fn fault(exercise: &Exercise, text: &str) -> Option<String> {
    let name = &exercise.name;
    let found = |what: String| {
        Some(format!(
            "book/exercises/stubs/{name}.md{what}\nOnly what stands between the marks is yours. This brings the file \
             back, without your answer:\n    cargo run -- exercises reset {name}"
        ))
    };
    let stub = exercise.stub();
    let (own, yours) = (lines(&stub), lines(text));
    let (Some((own_begin, own_end)), Some((begin, end))) = (marks(&own), marks(&yours)) else {
        return found(format!(" has not both marks, `{BEGIN}` and `{END}`, once each and in this order."));
    };
    let above = differing(&own[..=own_begin], &yours[..=begin]).map(|at| (at, at));
    let below = differing(&own[own_end..], &yours[end..]).map(|at| (own_end + at, end + at));
    if let Some((own_at, at)) = above.or(below) {
        let shown = |line: Option<&&str>| line.map_or("nothing".into(), |line| format!("`{line}`"));
        return found(format!(
            ":{}: {} stands where the exercise has {}.",
            at + 1,
            shown(yours.get(at)),
            shown(own.get(own_at))
        ));
    }
    if let Some(at) = yours[begin..end].iter().position(|line| line.starts_with("```")) {
        return found(format!(":{}: ``` ends the block before its check.", begin + at + 1));
    }
    let place = yours[begin + 1..end].join("\n");
    // A place that is moved in is inside of a function, whose own `return` and names are its affair.
    let inside = stub.lines().nth(own_begin).is_some_and(|mark| mark.starts_with(' '));
    let (above, below) = (own[..own_begin].join("\n"), own[own_end..].join("\n"));
    let what = skipped(&place, inside).or_else(|| {
        let checked: BTreeSet<&str> = words(&below).into_iter().map(|(_, word)| word).collect();
        let mut hidden = bound(&place).into_iter().filter(|_| !inside);
        let hidden = hidden.find(|name| checked.contains(name) && bound(&above).contains(name))?;
        Some(format!("`let {hidden}` hides the `{hidden}` that the check reads: take another name"))
    })?;
    Some(format!("book/exercises/stubs/{name}.md: {what}."))
}

/// The lines without the blanks around them, and without empty ones at the end.
fn lines(text: &str) -> Vec<&str> {
    text.trim_end().lines().map(str::trim).collect()
}

/// Where the two marks are, if each is there once.
fn marks(lines: &[&str]) -> Option<(usize, usize)> {
    let only = |mark: &str| {
        let mut all = lines.iter().enumerate().filter(|(_, line)| **line == mark);
        all.next().filter(|_| all.next().is_none()).map(|(at, _)| at)
    };
    only(BEGIN).zip(only(END)).filter(|(begin, end)| begin < end)
}

/// The first line that differs, of either.
fn differing(own: &[&str], yours: &[&str]) -> Option<usize> {
    (0..own.len().max(yours.len())).find(|&at| own.get(at) != yours.get(at))
}

/// What would end the program before its check.
fn skipped(place: &str, inside: bool) -> Option<String> {
    let words = words(place);
    let word = words.iter().find(|(_, word)| *word == "process" || (*word == "return" && !inside))?.1;
    Some(format!("`{word}` would end the program before its check"))
}

/// The words of code and how many braces are open around each, without comments and strings.
fn words(code: &str) -> Vec<(i32, &str)> {
    let (mut words, mut depth, mut rest) = (Vec::new(), 0, code);
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if first == '"' {
            let mut escaped = false;
            let end = rest.char_indices().skip(1).find(|(_, c)| {
                let ends = *c == '"' && !escaped;
                escaped = *c == '\\' && !escaped;
                ends
            });
            end.map_or(rest.len(), |(at, _)| at + 1)
        } else if is_word(first) {
            let length = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
            words.push((depth, &rest[..length]));
            length
        } else {
            depth += i32::from(first == '{') - i32::from(first == '}');
            // The signs that end what a `let` names.
            if matches!(first, '=' | ';' | ':') {
                words.push((depth, &rest[..1]));
            }
            first.len_utf8()
        };
        rest = &rest[length..];
    }
    words
}

/// The names that `let` gives outside of all braces.
fn bound(code: &str) -> Vec<&str> {
    let (mut names, mut in_pattern) = (Vec::new(), false);
    for (depth, word) in words(code) {
        match word {
            "let" if depth == 0 => in_pattern = true,
            "=" | ";" | ":" => in_pattern = false,
            name if in_pattern => names.push(name),
            _ => {}
        }
    }
    names
}
