//! Triangles from the text or bytes of an STL or OBJ file.

use crate::error::Error;
use crate::files::Files;
use nalgebra::Vector3;
use std::collections::{BTreeSet, HashMap};
use std::path::Path;

/// Vertices in the file's own unit, and faces by their numbers.
pub(crate) type Triangles = (Vec<Vector3<f64>>, Vec<[usize; 3]>);

/// The triangles of a file, as listed: those of an STL have three vertices each.
pub(crate) fn read(path: &Path, files: &Files<'_>) -> Result<Triangles, Error> {
    let bytes = &*files.mesh(path)?;
    let found = match path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).as_deref() {
        Some("stl") => stl(bytes),
        // Without the mark of UTF-8 that some programs write first.
        Some("obj") => obj(&String::from_utf8_lossy(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes))),
        _ => Err(Error::new("a mesh is read from a file that ends in .stl or .obj")),
    };
    found.map_err(|error| error.in_file(path))
}

/// Merges vertices at the same place, since some programs write a vertex once for each face: faces then refer
/// to the first of them.
pub(crate) fn weld(vertices: &[Vector3<f64>], faces: &mut [[usize; 3]]) {
    let mut known = HashMap::new();
    // Zero has two signs and one place.
    let places = vertices.iter().map(|p| p.map(|x| (x + 0.0).to_bits()));
    let first: Vec<usize> = places.enumerate().map(|(i, p)| *known.entry(p).or_insert(i)).collect();
    faces.iter_mut().flatten().for_each(|i| *i = first.get(*i).copied().unwrap_or(*i));
}

fn stl(bytes: &[u8]) -> Result<Triangles, Error> {
    const HEADER: usize = 84;
    const EACH: usize = 50;
    let count = bytes.get(80..HEADER).and_then(|four| four.try_into().ok()).map_or(0, u32::from_le_bytes);
    let wanted = usize::try_from(count).ok().and_then(|count| count.checked_mul(EACH)?.checked_add(HEADER));
    if bytes.len() > HEADER && wanted == Some(bytes.len()) {
        let number = |four: &[u8]| f64::from(f32::from_le_bytes(four.try_into().unwrap_or_default()));
        let corner = |twelve: &[u8]| Vector3::from_fn(|i, _| number(&twelve[4 * i..4 * i + 4]));
        let triangle = |each: &[u8]| [12, 24, 36].map(|at| corner(&each[at..at + 12]));
        return Ok(loose(bytes[HEADER..].chunks_exact(EACH).flat_map(triangle).collect()));
    }
    // Some programs write all words in capitals.
    let text = String::from_utf8_lossy(bytes).to_lowercase();
    let corner = |(at, line): (usize, &str)| Some(vertex(line.trim_start().strip_prefix("vertex")?, at));
    let corners: Vec<_> = text.lines().enumerate().filter_map(corner).collect::<Result<_, _>>()?;
    // The header of a binary file may begin so too.
    if corners.is_empty() || !text.trim_start().starts_with("solid") {
        let why = format!(
            "it has neither `solid` and vertices in text nor {EACH} bytes for each of {count} triangles"
        );
        return Err(Error::new(why));
    }
    if corners.len() % 3 != 0 {
        return Err(Error::new(format!("{} vertices are not three for each triangle", corners.len())));
    }
    Ok(loose(corners))
}

/// Triangles of three vertices each.
fn loose(corners: Vec<Vector3<f64>>) -> Triangles {
    let faces = (0..corners.len() / 3).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    (corners, faces)
}

fn vertex(words: &str, line: usize) -> Result<Vector3<f64>, Error> {
    let numbers: Option<Vec<f64>> = words.split_whitespace().take(3).map(|word| word.parse().ok()).collect();
    let place: Option<[f64; 3]> = numbers.and_then(|three| three.try_into().ok());
    let why = || Error { line: Some(line + 1), ..Error::new("3 numbers like 0.5 are expected for a vertex") };
    place.map(Vector3::from).ok_or_else(why)
}

fn obj(text: &str) -> Result<Triangles, Error> {
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for (number, line) in text.lines().enumerate() {
        // Some programs write a comment after a face.
        let line = line.split('#').next().unwrap_or_default().trim();
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        if word == "v" {
            vertices.push(vertex(rest, number)?);
        } else if word == "f" {
            let why = "a face names three or more vertices from 1";
            let wrong = || Error { line: Some(number + 1), ..Error::new(why) };
            let index = |word: &str| -> Option<usize> {
                let index: isize = word.split('/').next()?.parse().ok()?;
                // A number below zero counts back from the last vertex.
                let from_first = || usize::try_from(index - 1).ok();
                if index < 0 { vertices.len().checked_add_signed(index) } else { from_first() }
            };
            let around = rest.split_whitespace().map(index).collect::<Option<Vec<_>>>().ok_or_else(wrong)?;
            if around.len() < 3 {
                return Err(wrong());
            }
            faces.extend(around[1..].windows(2).map(|pair| [around[0], pair[0], pair[1]]));
        }
    }
    // Vertices that no face names are not of the surface.
    let named: BTreeSet<_> = faces.iter().flatten().copied().filter(|i| *i < vertices.len()).collect();
    let named: Vec<_> = named.into_iter().collect();
    faces.iter_mut().flatten().for_each(|i| *i = named.binary_search(i).unwrap_or(*i));
    Ok((named.into_iter().map(|i| vertices[i]).collect(), faces))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tumbling::solid::{Mesh, Solid};

    const CORNERS: [[f32; 3]; 4] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [-0.0, 0.0, 6.0]];
    const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]];

    #[test]
    fn a_corner_of_a_cube_has_its_volume_in_every_kind_of_file() {
        let mut binary = b"solid".repeat(16);
        binary.extend(4_u32.to_le_bytes());
        let mut text = String::from("solid corner\n");
        for face in FACES {
            binary.extend([0; 12]);
            for corner in face.map(|i| CORNERS[i]) {
                binary.extend(corner.iter().flat_map(|x| x.to_le_bytes()));
                text += &format!("vertex {} {} {}\n", corner[0], corner[1], corner[2]);
            }
            binary.extend([0; 2]);
        }
        let lines = CORNERS.map(|[x, y, z]| format!("v {x} {y} {z}\n")).concat();
        let named = FACES.map(|[a, b, c]| format!("f {}/1 {} -{}\n", a + 1, b + 1, 4 - c)).concat();
        for found in [stl(&binary), stl(text.as_bytes()), obj(&(lines + &named))] {
            let (vertices, mut faces) = found.unwrap();
            weld(&vertices, &mut faces);
            assert_eq!(Mesh::new(&vertices, &faces).unwrap().measure().unwrap(), 16.0);
        }
        assert_eq!(obj("v 1 2 3\nf 1 2 # 3\n").unwrap_err().line, Some(2));
        // A vertex that no face names is left out.
        let named = (vec![Vector3::new(1.0, 2.0, 3.0)], vec![[0; 3]]);
        assert_eq!(obj("v nan 0 0\nv 1 2 3\nf 2 2 2 # front\n").unwrap(), named);
        assert!(stl(b"PK").is_err());
        assert!(stl(&binary[..200]).unwrap_err().why.ends_with("50 bytes for each of 4 triangles"));
        assert_eq!(stl(text.to_uppercase().as_bytes()).unwrap(), stl(text.as_bytes()).unwrap());
        // A triangle of two corners is not left out, and a tab is as good as a space.
        let short = text.replacen("vertex 0 0 0\n", "", 1);
        assert!(stl(short.as_bytes()).unwrap_err().why.starts_with("11 vertices are not three"));
        assert_eq!(obj("v\t1 2 3\nf\t1 2\n").unwrap_err().line, Some(2));
    }
}
