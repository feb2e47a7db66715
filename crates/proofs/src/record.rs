//! The claims that a check makes, one after the other, with both sides as they were computed.

use crate::number::expression::{is_recording, recording};
use crate::number::{Fraction, Relations};
use crate::residue::Outcome;
use num_traits::Zero;
use std::cell::RefCell;

/// What is asserted.
#[derive(Debug, Clone)]
pub(crate) enum Assertion {
    /// Both sides are equal wherever the relations hold.
    Equal(Relations),
    /// The left side is above the right wherever all variables are above zero.
    Above,
}

/// One claim, and whether it holds.
#[derive(Debug, Clone)]
pub(crate) struct Claim {
    pub(crate) words: String,
    pub(crate) kind: Assertion,
    pub(crate) left: Fraction,
    pub(crate) right: Fraction,
    pub(crate) holds: bool,
}

/// What a check did.
#[derive(Debug, Clone)]
pub(crate) enum Entry {
    Claimed(Claim),
    /// The claims since the entry before this one were expected to fail; whether they did.
    Broken(bool),
}

thread_local! {
    static ENTRIES: RefCell<Vec<Entry>> = const { RefCell::new(Vec::new()) };
}

/// Records an entry, if entries are recorded.
pub(crate) fn record(entry: impl FnOnce() -> Entry) {
    if is_recording() {
        ENTRIES.with_borrow_mut(|entries| entries.push(entry()));
    }
}

/// Records that two sides are equal wherever the relations hold.
pub(crate) fn equal(words: &str, left: &Fraction, right: &Fraction, relations: &Relations, holds: bool) {
    record(|| {
        let (left, right, words) = (left.clone(), right.clone(), words.to_owned());
        Entry::Claimed(Claim { words, kind: Assertion::Equal(relations.clone()), left, right, holds })
    });
}

/// Records that a number is above zero.
pub(crate) fn above_zero(words: &str, x: &Fraction, holds: bool) {
    record(|| {
        let (left, right, words) = (x.clone(), Fraction::zero(), words.to_owned());
        Entry::Claimed(Claim { words, kind: Assertion::Above, left, right, holds })
    });
}

/// Runs a check; returns its outcome and what it did.
pub(crate) fn recorded(check: fn() -> Outcome) -> (Outcome, Vec<Entry>) {
    let before = ENTRIES.take();
    let outcome = recording(true, check);
    (outcome, ENTRIES.replace(before))
}
