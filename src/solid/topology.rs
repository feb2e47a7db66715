//! Whether a list of triangles is a closed surface with one side in and one side out, and of which shells.

use crate::error::{Error, Refusal};
use alloc::collections::BTreeMap;
use alloc::vec::Vec;

/// An edge of a face, its two vertices in rising order, and whether the face runs it that way.
struct Side {
    edge: [usize; 2],
    face: usize,
    rising: bool,
}

/// The shell of each face, numbered from 0 in the order of their first faces; each shell is closed.
///
/// That every face names three different vertices below `count` and is listed once, and along every edge as
/// many faces run one way as the other. In a plain surface that is one each way; two each way is where parts
/// touch along an edge, which still have an inside. Faces that touch only there are different shells
/// wherever each of them closes without the other.
pub(super) fn shells(faces: &[[usize; 3]], count: usize) -> Result<Vec<usize>, Error> {
    let mut listed = BTreeMap::new();
    let mut sides = Vec::with_capacity(3 * faces.len());
    for (face, &vertices) in faces.iter().enumerate() {
        let [a, b, c] = vertices;
        let distinct = a != b && b != c && c != a;
        if !distinct || vertices.iter().any(|&v| v >= count) {
            return Err(Refusal::BadFace { face, vertices, count }.into());
        }
        // One of the three orders that turn alike stands for the face.
        let turns = [[a, b, c], [b, c, a], [c, a, b]];
        let first = turns.into_iter().min().unwrap_or(vertices);
        if let Some(before) = listed.insert(first, face) {
            return Err(Refusal::RepeatedFace { face, before, vertices }.into());
        }
        for [from, to] in [[a, b], [b, c], [c, a]] {
            sides.push(Side { edge: [from.min(to), from.max(to)], face, rising: from < to });
        }
    }
    // Sorted, so that the same mesh always gives the same answer.
    sides.sort_by_key(|side| (side.edge, side.face));
    let edges = || sides.chunk_by(|a, b| a.edge == b.edge);
    let mut joined = Joined((0..faces.len()).collect());
    for around in edges() {
        balanced(around)?;
        if let [one, other] = around {
            joined.join(one.face, other.face);
        }
    }
    for around in edges().filter(|around| around.len() > 2) {
        // Those that close here without the others stay apart; the rest are one.
        let parts: Vec<_> = around.iter().map(|side| (joined.root(side.face), side.rising)).collect();
        let mut surplus = BTreeMap::new();
        for &(part, rising) in &parts {
            *surplus.entry(part).or_insert(0_i64) += if rising { 1 } else { -1 };
        }
        let mut open = parts.iter().map(|p| p.0).filter(|part| surplus.get(part) != Some(&0));
        if let Some(start) = open.next() {
            open.for_each(|part| joined.join(start, part));
        }
    }
    let mut numbers = BTreeMap::new();
    Ok((0..faces.len())
        .map(|face| {
            let next = numbers.len();
            *numbers.entry(joined.root(face)).or_insert(next)
        })
        .collect())
}

/// That as many faces run the edge one way as the other.
fn balanced(around: &[Side]) -> Result<(), Error> {
    let faces = around.len();
    let rising = around.iter().filter(|side| side.rising).count();
    let Some(&Side { edge: [low, high], .. }) = around.first() else {
        return Ok(());
    };
    if faces % 2 == 1 {
        return Err(Refusal::OpenMesh { edge: [low, high], faces }.into());
    }
    if 2 * rising == faces {
        return Ok(());
    }
    let edge = if 2 * rising > faces { [low, high] } else { [high, low] };
    Err(Refusal::FlippedFace { edge }.into())
}

/// Which faces belong together: each names another of its part, or itself.
struct Joined(Vec<usize>);

impl Joined {
    fn root(&mut self, mut face: usize) -> usize {
        while self.0[face] != face {
            self.0[face] = self.0[self.0[face]];
            face = self.0[face];
        }
        face
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
    }
}
