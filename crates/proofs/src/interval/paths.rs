//! All paths through a computation with undecided comparisons.
//!
//! Where the numbers of a box leave open how a comparison comes out, or which integer is the nearest, the
//! computation takes one answer, and is run again with the others, until no open question is left. A result
//! for a number in the box is among those of the paths.

use std::cell::RefCell;

/// The answers given on this path, each with how many there are; and how many were asked for.
#[derive(Debug, Default)]
struct Path {
    taken: Vec<[usize; 2]>,
    asked: usize,
}

thread_local! {
    static PATH: RefCell<Path> = RefCell::default();
}

/// One of this many answers.
pub(super) fn choose(of: usize) -> usize {
    if of < 2 {
        return 0;
    }
    PATH.with_borrow_mut(|path| {
        let n = path.asked;
        path.asked += 1;
        if n == path.taken.len() {
            path.taken.push([0, of]);
        }
        path.taken[n][0]
    })
}

/// What comes out on every path, if they are not too many.
pub fn every_path<R>(run: impl Fn() -> R) -> Option<Vec<R>> {
    const MOST: usize = 1 << 16;
    let around = PATH.take();
    let mut found = Vec::new();
    let mut open = Some(());
    while open.is_some() && found.len() < MOST {
        found.push(run());
        open = PATH.with_borrow_mut(|path| {
            path.asked = 0;
            while path.taken.last().is_some_and(|[answer, of]| answer + 1 == *of) {
                path.taken.pop();
            }
            path.taken.last_mut().map(|[answer, _]| *answer += 1)
        });
    }
    PATH.set(around);
    open.is_none().then_some(found)
}
