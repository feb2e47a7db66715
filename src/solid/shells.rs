//! Checks whether a list of triangles is a closed surface with an inside and an outside, splits it into
//! shells, and checks whether their orientation and nesting bound a solid.
//!
//! The winding number of a point is how many times the shells together enclose it, cavities counted negative:
//! the solid angles of all faces at it, over a full sphere. In a solid it is 1, elsewhere 0. It is constant
//! along a shell that no other shell crosses, so one point at each shell is enough. The solid angle of a
//! triangle: [OS83](crate::references).

use super::mesh::triple;
use crate::error::{Error, Refusal};
use crate::number::Extended;
use crate::number::functions::atan2;
use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::f64::consts::TAU;
use nalgebra::Vector3;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
use num_traits::Zero;

/// How far from a face to look, in its heights: far enough that a slim face's own solid angle is clear of
/// rounding, near enough to stay next to it. In a solid a point anywhere has winding number 0 or 1, so none
/// is refused for this choice.
const BESIDE: f64 = 1.0 / 1024.0;

/// The largest error of a product of unit vectors.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The largest number of pairs of a shell and a face that are checked, which takes some seconds.
const MOST_VIEWS: usize = 30_000_000;

/// Checks that the winding number just inside and just outside each shell is 0 or 1. `shell` is the shell of
/// each face, and each is closed.
pub(super) fn check(
    vertices: &[Vector3<Extended>],
    faces: &[[usize; 3]],
    shell: &[usize],
) -> Result<(), Error> {
    let shells = Shell::all(vertices, faces, shell);
    if shells.len() < 2 {
        // One alone is right if its volume is positive, which is checked anyway.
        return Ok(());
    }
    let bounds: Vec<_> = shells.iter().map(Shell::bounds).collect();
    // Counted before the first is taken, so that too many are refused at once.
    let (mut views, mut looks) = (0, Vec::new());
    for own in &shells {
        for point in [-BESIDE, BESIDE].map(|side| own.next_to(vertices, side)) {
            let near = point.nearest();
            let around = shells.iter().zip(&bounds).filter(|(_, bounds)| !outside(&near, bounds));
            let around: Vec<_> = around.map(|x| x.0).filter(|other| other.may_enclose(&point)).collect();
            views += around.iter().map(|other| other.faces.len()).sum::<usize>();
            Refusal::TooManyShells { shells: shells.len(), most: MOST_VIEWS }.when(views > MOST_VIEWS)?;
            looks.push((own, point, around));
        }
    }
    for (own, point, around) in looks {
        let (mut winding, mut doubt) = (0.0, 0.0);
        for face in around.iter().flat_map(|other| &other.faces) {
            let angle = solid_angle(face.map(|v| point.sight(&vertices[v])));
            winding += angle.map_or(0.0, |angle| angle / (2.0 * TAU));
            doubt += if angle.is_none() { 0.5 } else { 0.0 };
        }
        // Refused only if neither 0 nor 1 whichever side rounding put the point on.
        if winding + doubt < -0.5 || winding - doubt > 1.5 {
            return Err(Refusal::MisplacedShell {
                face: own.first,
                volume: own.volume(vertices).nearest(),
                winding: winding.round(),
            }
            .into());
        }
    }
    Ok(())
}

struct Shell {
    /// The number of its first face in the whole mesh.
    first: usize,
    faces: Vec<[usize; 3]>,
    /// The face next to which to look: the highest, since the slimmer the less clear.
    best: [usize; 3],
    low: Vector3<Extended>,
    high: Vector3<Extended>,
}

/// A place near a vertex, kept as the step from it: far from the origin the sum would lose the step.
struct Point {
    start: Vector3<Extended>,
    step: Vector3<Extended>,
}

impl Shell {
    fn all(vertices: &[Vector3<Extended>], faces: &[[usize; 3]], shell: &[usize]) -> Vec<Self> {
        let mut shells: Vec<Self> = Vec::new();
        let mut heights = Vec::new();
        for (first, (face, &number)) in faces.iter().zip(shell).enumerate() {
            let height = steepness(vertices, face).1;
            if number == shells.len() {
                let start = vertices[face[0]];
                shells.push(Self { first, faces: Vec::new(), best: *face, low: start, high: start });
                heights.push(height);
            }
            let own = &mut shells[number];
            own.faces.push(*face);
            if (height - heights[number]).is_positive() {
                (heights[number], own.best) = (height, *face);
            }
            for &v in face {
                own.low = own.low.zip_map(&vertices[v], |a, b| if (a - b).is_positive() { b } else { a });
                own.high = own.high.zip_map(&vertices[v], |a, b| if (b - a).is_positive() { b } else { a });
            }
        }
        shells
    }

    /// The middle of its best face, moved off it by `side` of its height: outwards if that is positive.
    fn next_to(&self, vertices: &[Vector3<Extended>], side: f64) -> Point {
        let [a, b, c] = self.best.map(|v| vertices[v]);
        let (up, _) = steepness(vertices, &self.best);
        let middle = ((b - a) + (c - a)).map(|x| x / Extended::from(3.0));
        Point { start: a, step: middle + up * Extended::from(side) }
    }

    /// False if the point lies outside its bounding box, where its winding number is 0.
    fn may_enclose(&self, point: &Point) -> bool {
        let above = (self.low - point.start) - point.step;
        let below = point.step - (self.high - point.start);
        !above.iter().chain(&below).any(|x| x.is_positive())
    }

    /// The corners of its bounding box, which are coordinates of vertices.
    fn bounds(&self) -> [Vector3<f64>; 2] {
        [self.low, self.high].map(|corner| corner.map(Extended::nearest))
    }

    fn volume(&self, vertices: &[Vector3<Extended>]) -> Extended {
        let start = vertices[self.best[0]];
        let mut six_volumes = Extended::zero();
        for face in &self.faces {
            let [a, b, c] = face.map(|v| vertices[v]);
            six_volumes += triple(&(a - start), &(b - a), &(c - a));
        }
        six_volumes / Extended::from(6.0)
    }
}

/// Whether a point is surely outside a box: its coordinates may be off by their rounding. Much faster than
/// [`Shell::may_enclose`], which decides.
fn outside([near, size]: &[Vector3<f64>; 2], [low, high]: &[Vector3<f64>; 2]) -> bool {
    (0..3).any(|i| {
        let room = ROUNDING * size[i];
        near[i] + room < low[i] || near[i] - room > high[i]
    })
}

impl Point {
    /// Where it is, and the sum of the sizes that were added, to rounding.
    fn nearest(&self) -> [Vector3<f64>; 2] {
        let [start, step] = [self.start, self.step].map(|v| v.map(Extended::nearest));
        [start + step, start.abs() + step.abs()]
    }

    /// The direction in which a vertex is seen, if it is not here.
    fn sight(&self, vertex: &Vector3<Extended>) -> Option<Vector3<f64>> {
        let away = (vertex - self.start) - self.step;
        let size = largest(&away);
        (!size.is_zero()).then(|| away.map(|x| (x / size).nearest()).normalize())
    }
}

/// A vector off the face, outwards, about as long as the face is high above its longest edge, and that
/// length, both to a factor of two. Zero for a face without area.
fn steepness(vertices: &[Vector3<Extended>], face: &[usize; 3]) -> (Vector3<Extended>, Extended) {
    let [a, b, c] = face.map(|v| vertices[v]);
    let edges = [b - a, c - b, a - c];
    let longest =
        edges.iter().map(largest).fold(Extended::zero(), |x, y| if (y - x).is_positive() { y } else { x });
    if longest.is_zero() {
        return (Vector3::zeros(), Extended::zero());
    }
    let up = (b - a).cross(&(c - a)).map(|x| x / longest);
    (up, largest(&up))
}

pub(super) fn largest(v: &Vector3<Extended>) -> Extended {
    v.fold(Extended::zero(), |a, b| if (b.abs() - a).is_positive() { b.abs() } else { a })
}

/// The solid angle of a triangle, positive seen from behind, given the unit vectors to its corners; none if
/// the point is on it to rounding, where it is half a sphere either way.
fn solid_angle(corners: [Option<Vector3<f64>>; 3]) -> Option<f64> {
    let [Some(a), Some(b), Some(c)] = corners else {
        return None;
    };
    let (sine, cosine) = (triple(&a, &b, &c), 1.0 + a.dot(&b) + b.dot(&c) + c.dot(&a));
    let on_it = sine.abs() <= ROUNDING && cosine <= ROUNDING;
    (!on_it).then(|| 2.0 * atan2(sine, cosine))
}

/// An edge of a face, its two vertices in rising order, and whether the face runs it that way.
struct Side {
    edge: [usize; 2],
    face: usize,
    rising: bool,
}

/// The shell of each face, numbered from 0 in the order of their first faces; each shell is closed.
///
/// Checks that every face has three different vertices below `count` and is listed once, and that along every
/// edge equally many faces run in both directions. In a simple surface that is one face in each direction;
/// where parts touch along an edge it is two, and the parts still have an inside. Faces that touch only there
/// are different shells wherever each of them closes without the other.
pub(super) fn of_faces(faces: &[[usize; 3]], count: usize) -> Result<Vec<usize>, Error> {
    let mut listed = BTreeMap::new();
    let mut sides = Vec::with_capacity(3 * faces.len());
    for (face, &vertices) in faces.iter().enumerate() {
        let [a, b, c] = vertices;
        let distinct = a != b && b != c && c != a;
        let bad = !distinct || vertices.iter().any(|&v| v >= count);
        Refusal::BadFace { face, vertices, count }.when(bad)?;
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
    Refusal::OpenMesh { edge: [low, high], faces }.when(faces % 2 == 1)?;
    let edge = if 2 * rising > faces { [low, high] } else { [high, low] };
    Refusal::FlippedFace { edge }.when(2 * rising != faces)
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
