//! Binds each number of a chapter to what computes it.

use super::chapter::{Chapter, Kind, Passage, Section};
use super::code::{Holds, Literal, Role};
use super::decimal::Decimal;
use super::facts::Fact;
use super::offence::Offence;
use super::token::{self, Number, Token, What};
use super::words::{self, Spelled};
use std::cell::Cell;
use std::collections::HashMap;

/// What the drawings say of themselves: title and description, by the figure's name.
pub(crate) type Drawings = HashMap<String, Drawing>;

/// The words of a drawing, read.
#[derive(Debug, Default)]
pub(crate) struct Drawing {
    tokens: Vec<Token>,
    quantities: Vec<Spelled>,
}

impl Drawing {
    /// Reads the words.
    pub(crate) fn new(words: &str) -> Self {
        let tokens = token::tokens(words, &[]);
        let quantities = words::spelled(words).0;
        Self { tokens, quantities }
    }
}

/// What there is besides the chapter.
#[derive(Debug, Default)]
pub(crate) struct Beside {
    pub(crate) facts: Vec<Fact>,
    pub(crate) drawings: Drawings,
}

/// How many numbers there are, by where they stand and by what holds them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    pub(crate) prose: usize,
    pub(crate) captions: usize,
    pub(crate) tables: usize,
    pub(crate) alts: usize,
    pub(crate) tex: usize,
    /// In the comments of the Rust blocks.
    pub(crate) comments: usize,
    pub(crate) by_assertion: usize,
    pub(crate) by_input: usize,
    pub(crate) by_fact: usize,
    pub(crate) by_drawing: usize,
    /// Ordinals before headings, held by their order.
    pub(crate) ordinals: usize,
    /// Quantities in words, bound like numbers.
    pub(crate) quantities: usize,
    /// Words that count, not bound.
    pub(crate) counting: usize,
    /// Indices, exponents and factors inside formulas, not bound here.
    pub(crate) structural: usize,
}

impl Counts {
    pub(crate) fn add(&mut self, other: &Self) {
        for (mine, others) in [
            (&mut self.prose, other.prose),
            (&mut self.captions, other.captions),
            (&mut self.tables, other.tables),
            (&mut self.alts, other.alts),
            (&mut self.tex, other.tex),
            (&mut self.comments, other.comments),
            (&mut self.by_assertion, other.by_assertion),
            (&mut self.by_input, other.by_input),
            (&mut self.by_fact, other.by_fact),
            (&mut self.by_drawing, other.by_drawing),
            (&mut self.ordinals, other.ordinals),
            (&mut self.quantities, other.quantities),
            (&mut self.counting, other.counting),
            (&mut self.structural, other.structural),
        ] {
            *mine += others;
        }
    }

    /// All numbers that must be bound.
    pub(crate) fn all(&self) -> usize {
        self.prose + self.captions + self.tables + self.alts + self.tex + self.comments
    }
}

/// A number of the text, where it stands in the chapter's bytes: to be altered, one digit at a time.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    pub(crate) kind: &'static str,
    /// The bytes of its digits.
    pub(crate) digits: Vec<usize>,
    /// A quantity in words: the bytes of it.
    pub(crate) words: Option<std::ops::Range<usize>>,
}

/// A literal of an assertion, where it stands in the chapter's bytes.
#[derive(Debug, Clone)]
pub(crate) struct Claim {
    pub(crate) role: Role,
    pub(crate) digits: Vec<usize>,
}

/// All that was found in a chapter.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    pub(crate) offences: Vec<Offence>,
    pub(crate) counts: Counts,
    pub(crate) places: Vec<Place>,
    pub(crate) claims: Vec<Claim>,
    /// Each number and what holds it: `file:line: number: holder`.
    pub(crate) held: Vec<String>,
}

/// Something in a section's code that numbers may be bound to.
struct Source {
    what: What,
    /// Whether the code prints it, so that its digits count.
    printed: bool,
    unit: Option<&'static str>,
    name: Option<String>,
    role: Role,
    /// Its line in the chapter's file.
    line: usize,
    /// Where the text says it first.
    said: Cell<Option<usize>>,
    /// Whether the text need not say it again: a cell of a row.
    in_row: bool,
}

impl Source {
    /// Whether this number of a text is this value.
    fn holds(&self, token: &Token) -> bool {
        if matches!(self.role, Role::Component | Role::Divisor) {
            return false;
        }
        let unit = match self.role {
            Role::Expected => self.unit == token.unit,
            // A name says which value is meant as well as its unit does.
            _ => self.unit == token.unit || (token.name.is_some() && token.unit.is_none()),
        };
        let same = match (&self.what, &token.what) {
            (What::One(a), What::One(b)) => self.same(a, b),
            (What::Fraction(a, c), What::Fraction(b, d)) => self.same(a, b) && self.same(c, d),
            (What::Tuple(a), What::Tuple(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| self.same(a, b))
            }
            _ => false,
        };
        let name = token.name.is_none() || token.name == self.name;
        unit && same && name
    }

    fn same(&self, mine: &Number, other: &Number) -> bool {
        if other.power && (other.value.is_zero() || other.printed.ends_with("e0")) {
            return false; // nothing times a power of ten, or the power nought: no way to write a number
        }
        if self.printed && !other.power { mine.printed == other.printed } else { mine.value == other.value }
    }
}

/// What the blocks of a section hold.
struct Pool {
    sources: Vec<Source>,
    /// Rows of tables that are asserted whole: text, line, and whether the text has it.
    rows: Vec<(String, usize, Cell<Option<usize>>)>,
}

impl Pool {
    fn new(chapter: &Chapter, section: &Section) -> Self {
        let mut pool = Self { sources: Vec::new(), rows: Vec::new() };
        for block in &section.blocks {
            for value in &block.code.values {
                let at = value.literals.first().map_or(0, |l| block.source(l.line, l.start));
                let line = chapter.line(at);
                let one = |n: Decimal| Number { printed: String::new(), value: n, power: false };
                let what = match &value.what {
                    Holds::One(n) => What::One(one(*n)),
                    Holds::Fraction(a, b) => What::Fraction(one(*a), one(*b)),
                    Holds::Tuple(all) => What::Tuple(all.iter().copied().map(one).collect()),
                    Holds::Text(text) => {
                        pool.printed(text, line);
                        continue;
                    }
                };
                pool.sources.push(Source {
                    what,
                    printed: false,
                    unit: value.unit,
                    name: value.name.clone(),
                    role: value.role,
                    line,
                    said: Cell::new(None),
                    in_row: false,
                });
            }
        }
        pool
    }

    fn printed(&mut self, text: &str, line: usize) {
        if text.starts_with('|') {
            self.rows.push((text.to_owned(), line, Cell::new(None)));
        }
        for token in token::tokens(text, &[]) {
            self.sources.push(Source {
                what: token.what,
                printed: true,
                unit: token.unit,
                name: None,
                role: Role::Expected,
                line,
                said: Cell::new(None),
                // A row is said by the table; its cells may be said besides.
                in_row: text.starts_with('|'),
            });
        }
    }

    /// Who holds this number, or all members of this list, one after the other in the code. Said at this
    /// byte of the chapter, if it is said to the reader of the text.
    fn holder(&self, tokens: &[&Token], said: Option<usize>) -> Option<&Source> {
        let ordered = |expected: bool| {
            self.sources
                .iter()
                .filter(move |s| (s.role == Role::Expected) == expected && s.role != Role::Component)
        };
        for expected in [true, false] {
            let sources: Vec<&Source> = ordered(expected).collect();
            let mut held = None;
            for run in sources.windows(tokens.len().max(1)) {
                if run.iter().zip(tokens).all(|(source, token)| source.holds(token)) {
                    held = run.first().copied();
                    for source in run.iter().filter(|s| s.said.get().is_none()) {
                        source.said.set(said);
                    }
                }
            }
            if held.is_some() {
                return held;
            }
        }
        None
    }

    /// The nearest thing to this number, in words.
    fn nearest(&self, token: &Token, text: &str) -> String {
        if self.sources.is_empty() {
            return "a Rust block in this section that computes it".into();
        }
        if let Some(name) = &token.name {
            let named: Vec<String> = self
                .sources
                .iter()
                .filter(|s| s.name.as_ref() == Some(name))
                .map(|s| format!("`{}`, as in line {}", shown(&s.what), s.line))
                .collect();
            return named
                .first()
                .cloned()
                .unwrap_or_else(|| format!("a `let {name} = ...` in the section's code"));
        }
        let own = &text[token.digits.clone()];
        let near = self
            .sources
            .iter()
            .filter(|s| s.role == Role::Expected || s.role == Role::Input)
            .map(|s| (strsim::normalized_damerau_levenshtein(own, &shown(&s.what)), s))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        match near {
            Some((_, s)) => {
                let unit = s.unit.map(|u| format!(" {u}")).unwrap_or_default();
                format!(
                    "a value of the section's code; nearest is `{}{unit}` in line {}",
                    shown(&s.what),
                    s.line
                )
            }
            None => "a value of the section's code, which has none".into(),
        }
    }

    /// Whether the code has this quantity, and no other unit for it.
    fn has(&self, word: &Spelled) -> bool {
        self.sources.iter().any(|s| match &s.what {
            What::One(n) if s.role == Role::Divisor => word.part && n.value.is_inverse_of(word.value),
            What::One(n) => n.value == word.value && (s.unit.is_none() || s.unit == word.unit),
            _ => false,
        })
    }
}

fn shown(what: &What) -> String {
    let one = |n: &Number| if n.printed.is_empty() { n.value.to_string() } else { n.printed.clone() };
    match what {
        What::One(n) => one(n),
        What::Fraction(a, b) => format!("{}/{}", one(a), one(b)),
        What::Tuple(all) => format!("({})", all.iter().map(one).collect::<Vec<_>>().join(", ")),
        What::Power => "a power".into(),
    }
}

/// Checks a chapter.
pub(crate) fn findings(chapter: &Chapter, beside: &Beside) -> Findings {
    let mut checker = Checker { chapter, beside, found: Findings::default(), ordinals: HashMap::new() };
    for section in &chapter.sections {
        checker.section(section);
    }
    checker.facts_are_told();
    checker.found.offences.sort();
    checker.found
}

struct Checker<'a> {
    chapter: &'a Chapter,
    beside: &'a Beside,
    found: Findings,
    ordinals: HashMap<u8, usize>,
}

impl Checker<'_> {
    fn offend(&mut self, at: usize, found: String, expected: String) {
        let line = self.chapter.line(at);
        self.found.offences.push(Offence { file: self.chapter.path.clone(), line, found, expected });
    }

    fn section(&mut self, section: &Section) {
        let pool = Pool::new(self.chapter, section);
        for passage in &section.passages {
            self.passage(passage, &pool);
        }
        for (row, line, said) in &pool.rows {
            if said.get().is_none() {
                self.unsaid(*line, row);
            }
        }
        for source in pool.sources.iter().filter(|s| s.printed && !s.in_row) {
            if source.said.get().is_none() {
                self.unsaid(source.line, &shown(&source.what));
            }
        }
        self.order(&pool);
        for block in &section.blocks {
            for &(line, why) in &block.code.hollow {
                let expected = "a computed value compared with what it must be".to_owned();
                self.offend(block.source(line, 0), why.to_owned(), expected);
            }
        }
        self.claims(section);
    }

    /// The text says first what the code asserts first. So numbers cannot trade places, nor rows of a table.
    fn order(&mut self, pool: &Pool) {
        let rows = pool.rows.iter().map(|(row, line, said)| (row.clone(), *line, said.get()));
        let values = pool.sources.iter().filter(|s| s.role == Role::Expected && !s.in_row);
        let values = values.map(|s| (shown(&s.what), s.line, s.said.get()));
        for said in [rows.collect::<Vec<_>>(), values.collect()] {
            let mut latest: Option<(String, usize, usize)> = None;
            for (what, line, at) in said {
                let Some(at) = at else { continue };
                match &latest {
                    Some((before, of, last)) if at < *last => {
                        let expected =
                            format!("it after `{before}`, as in the assertions of lines {of} and {line}");
                        self.offend(at, format!("`{what}`"), expected);
                    }
                    _ => latest = Some((what, line, at)),
                }
            }
        }
    }

    fn unsaid(&mut self, line: usize, what: &str) {
        self.found.offences.push(Offence {
            file: self.chapter.path.clone(),
            line,
            found: format!("`{what}`, asserted as printed"),
            expected: "the same in the text of the section".into(),
        });
    }

    fn passage(&mut self, passage: &Passage, pool: &Pool) {
        let tex: Vec<_> = passage.tex.iter().map(|t| t.at.clone()).collect();
        let mut tokens = token::tokens(&passage.text, &tex);
        self.found.counts.structural += tokens.iter().filter(|t| t.structural).count();
        tokens.retain(|t| !t.structural);
        if let Kind::Heading(level) = passage.kind {
            self.ordinal(passage, level, &mut tokens);
        }
        for token in &tokens {
            let formula = passage.tex.iter().find(|t| t.at.contains(&token.at.start));
            let kind = match (self.count(passage.kind, formula.is_some()), formula) {
                (_, Some(formula)) if formula.display => "display TeX",
                (kind, _) => kind,
            };
            let digits = token
                .digits
                .clone()
                .filter(|&i| passage.text.as_bytes().get(i).is_some_and(u8::is_ascii_digit))
                .map(|i| passage.source(i));
            self.found.places.push(Place { kind, digits: digits.collect(), words: None });
        }
        self.bind(passage, &tokens, pool);
        self.words(passage, pool);
    }

    fn count(&mut self, kind: Kind, in_tex: bool) -> &'static str {
        let counts = &mut self.found.counts;
        let (count, name) = match (kind, in_tex) {
            (_, true) => (&mut counts.tex, "TeX"),
            (Kind::Caption, _) => (&mut counts.captions, "caption"),
            (Kind::Row, _) => (&mut counts.tables, "table"),
            (Kind::Alt, _) => (&mut counts.alts, "alt text"),
            (Kind::Comment, _) => (&mut counts.comments, "comment"),
            (Kind::Prose | Kind::Heading(_), _) => (&mut counts.prose, "prose"),
        };
        *count += 1;
        name
    }

    /// `1. The first` and so on: the numbers before headings of one level count up from one.
    fn ordinal(&mut self, passage: &Passage, level: u8, tokens: &mut Vec<Token>) {
        let Some(first) = tokens.first() else { return };
        let What::One(n) = &first.what else { return };
        if first.at.start != 0 || !passage.text[first.at.end..].starts_with(". ") {
            return;
        }
        let number = n.value;
        let next = self.ordinals.entry(level).or_insert(0);
        *next += 1;
        let next = *next;
        self.found.counts.ordinals += 1;
        let digits = (first.digits.clone()).map(|i| passage.source(i)).collect();
        self.found.places.push(Place { kind: "heading", digits, words: None });
        if i128::try_from(next).is_ok_and(|n| Decimal::new(n, 0) != number) {
            let found = format!("the heading number {}", shown(&first.what));
            self.offend(passage.source(0), found, next.to_string());
        }
        tokens.remove(0);
    }

    fn bind(&mut self, passage: &Passage, tokens: &[Token], pool: &Pool) {
        if passage.kind == Kind::Row && !pool.rows.is_empty() && !tokens.is_empty() {
            return self.row(passage, tokens, pool);
        }
        let drawing = passage.figure.as_ref().and_then(|name| self.beside.drawings.get(name));
        let mut told = 0;
        let mut at = 0;
        while let Some(first) = tokens.get(at) {
            let list: Vec<&Token> = tokens[at..].iter().take_while(|t| t.list == first.list).collect();
            at += list.len();
            let shown = &passage.text[first.at.start..list.last().map_or(first.at.end, |t| t.at.end)];
            let place = passage.source(first.at.start);
            if list.iter().all(|t| self.is_fact(passage, t)) {
                self.found.counts.by_fact += list.len();
                self.hold(place, shown, "a fact");
                continue;
            }
            if passage.kind == Kind::Alt {
                // The words for the figure say what the drawing says of itself, in the same order.
                match drawing.and_then(|d| run_of(&d.tokens[told..], &list)) {
                    Some(end) => {
                        told += end;
                        self.found.counts.by_drawing += list.len();
                        self.hold(place, shown, "the drawing");
                    }
                    None => {
                        let name = passage.figure.as_deref().unwrap_or("?");
                        let expected =
                            format!("it in the description inside the drawing `{name}`, in this order");
                        self.offend(place, format!("`{shown}` in the words for a figure"), expected);
                    }
                }
                continue;
            }
            let said = matches!(passage.kind, Kind::Prose | Kind::Row | Kind::Heading(_)).then_some(place);
            match pool.holder(&list, said) {
                Some(source) if matches!(source.role, Role::Input | Role::Component) => {
                    self.found.counts.by_input += list.len();
                    self.hold(place, shown, &format!("the input in line {}", source.line));
                }
                Some(source) => {
                    self.found.counts.by_assertion += list.len();
                    self.hold(place, shown, &format!("the assertion in line {}", source.line));
                }
                None if drawing.is_some_and(|d| run_of(&d.tokens, &list).is_some()) => {
                    self.found.counts.by_drawing += list.len();
                    self.hold(place, shown, "the drawing");
                }
                None => {
                    let expected = pool.nearest(first, &passage.text);
                    let run = if list.len() > 1 { "these, one after the other: " } else { "" };
                    self.offend(place, format!("`{shown}`"), format!("{run}{expected}"));
                }
            }
        }
    }

    fn hold(&mut self, place: usize, shown: &str, holder: &str) {
        let (file, line) = (&self.chapter.path, self.chapter.line(place));
        self.found.held.push(format!("{file}:{line}: `{shown}`: {holder}"));
    }

    fn row(&mut self, passage: &Passage, tokens: &[Token], pool: &Pool) {
        let text = passage.text.trim();
        let mut held = None;
        for (_, line, said) in pool.rows.iter().filter(|(row, ..)| row == text) {
            said.set(said.get().or(Some(passage.source(0))));
            held = Some(line);
        }
        if let Some(line) = held {
            self.found.counts.by_assertion += tokens.len();
            self.hold(passage.source(0), text, &format!("the row in line {line}"));
            return;
        }
        let near = pool.rows.iter().max_by(|a, b| {
            let like = |row: &str| strsim::normalized_damerau_levenshtein(text, row);
            like(&a.0).total_cmp(&like(&b.0))
        });
        let near = near.map(|(row, line, _)| format!("`{row}`, as in line {line}")).unwrap_or_default();
        self.offend(passage.source(0), format!("the row `{text}`"), near);
    }

    /// Whether a fact's words surround this number.
    fn is_fact(&self, passage: &Passage, token: &Token) -> bool {
        let What::One(n) = &token.what else { return false };
        self.own_facts().filter(|f| f.number == n.printed).any(|fact| {
            passage.text.match_indices(&fact.text).any(|(at, words)| {
                words.match_indices(&fact.number).any(|(inner, _)| at + inner == token.digits.start)
            })
        })
    }

    fn own_facts(&self) -> impl Iterator<Item = &Fact> {
        self.beside.facts.iter().filter(|f| f.chapter == self.chapter.name)
    }

    fn facts_are_told(&mut self) {
        let told = |fact: &Fact| {
            let mut passages = self.chapter.sections.iter().flat_map(|s| &s.passages);
            passages.any(|p| p.text.contains(&fact.text))
        };
        let gone: Vec<String> = self.own_facts().filter(|f| !told(f)).map(|f| f.text.clone()).collect();
        for text in gone {
            self.offend(
                0,
                format!("no `{text}`"),
                "these words of the facts file, or no such fact there".into(),
            );
        }
    }

    fn words(&mut self, passage: &Passage, pool: &Pool) {
        let (found, counting) = words::spelled(&passage.text);
        self.found.counts.counting += counting;
        let drawing = passage.figure.as_ref().and_then(|name| self.beside.drawings.get(name));
        for word in found {
            self.found.counts.quantities += 1;
            let drawn = drawing.is_some_and(|d| {
                d.quantities.iter().any(|q| q.value == word.value && q.unit == word.unit)
                    || d.tokens.iter().any(|t| {
                        matches!(&t.what, What::One(n) if n.value == word.value) && t.unit == word.unit
                    })
            });
            let range = passage.source(word.at.start)..passage.source(word.at.end - 1) + 1;
            let shown = &passage.text[word.at.clone()];
            if !pool.has(&word) && !drawn {
                let expected = format!("{} as a value of the section's code", word.value);
                self.offend(range.start, format!("`{shown}`"), expected);
            }
            self.found.places.push(Place { kind: "words", digits: Vec::new(), words: Some(range) });
        }
    }

    /// Notes the literals of the assertions.
    fn claims(&mut self, section: &Section) {
        let mut seen: Vec<(usize, Literal)> = Vec::new();
        for (number, block) in section.blocks.iter().enumerate() {
            for value in &block.code.values {
                if !matches!(value.role, Role::Expected | Role::Compared | Role::Tolerance) {
                    continue;
                }
                for literal in &value.literals {
                    if seen.contains(&(number, *literal)) {
                        continue;
                    }
                    seen.push((number, *literal));
                    let (start, end) =
                        (block.source(literal.line, literal.start), block.source(literal.line, literal.end));
                    let is_digit =
                        |&i: &usize| self.chapter.text.as_bytes().get(i).is_some_and(u8::is_ascii_digit);
                    let suffix = |i: &usize| {
                        // The digits of a type's name are no value: `3_f64`.
                        let text = &self.chapter.text[start..*i];
                        text.starts_with('"') || !text.contains('_') || !text.contains('f')
                    };
                    let digits = (start..end).filter(is_digit).filter(suffix).collect();
                    self.found.claims.push(Claim { role: value.role, digits });
                }
            }
        }
    }
}

/// Where, after this run of numbers, the drawing's words go on; nothing if they do not have it.
fn run_of(drawn: &[Token], list: &[&Token]) -> Option<usize> {
    let same = |a: &Token, b: &Token| a.what == b.what && a.unit == b.unit;
    let runs = drawn.windows(list.len().max(1));
    let found = { runs }.position(|run| run.iter().zip(list).all(|(a, b)| same(a, b)))?;
    Some(found + list.len())
}
