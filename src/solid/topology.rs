//! Whether a list of triangles is a closed surface with one side in and one side out.

use crate::error::Error;
use std::collections::HashMap;

/// That every face names three different vertices below `count`, and along every edge as many faces run one
/// way as the other. In a plain surface that is one each way; two each way is where two parts of a surface
/// touch along an edge, which still has an inside.
pub(super) fn check(faces: &[[usize; 3]], count: usize) -> Result<(), Error> {
    let mut runs: HashMap<[usize; 2], usize> = HashMap::with_capacity(3 * faces.len());
    for (face, &vertices) in faces.iter().enumerate() {
        let [a, b, c] = vertices;
        let distinct = a != b && b != c && c != a;
        if !distinct || vertices.iter().any(|&v| v >= count) {
            return Err(Error::BadFace { face, vertices, count });
        }
        for edge in [[a, b], [b, c], [c, a]] {
            *runs.entry(edge).or_insert(0) += 1;
        }
    }
    let run = |a: usize, b: usize| runs.get(&[a, b]).copied().unwrap_or(0);
    // Face by face, not in the order of the map, so that the same mesh always gives the same answer.
    for &[a, b, c] in faces {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let (there, back) = (run(from, to), run(to, from));
            if there == back {
                continue;
            }
            if (there + back) % 2 == 1 {
                return Err(Error::OpenMesh { edge: [from, to], faces: there + back });
            }
            let edge = if there > back { [from, to] } else { [to, from] };
            return Err(Error::FlippedFace { edge });
        }
    }
    Ok(())
}
