//! Bodies of any shape, by the faces of their surfaces.

use super::canvas::Canvas;
use super::pen::{Fill, Pen};
use super::point::P;
use super::space::View;
use crate::ink::Ink;
use nalgebra::{Matrix3, Vector3};
use std::collections::HashMap;
use tumbling_bodies::Surface;

/// Two faces with an angle below this between them look like one bent face.
const BENT: f64 = 0.85; // the cosine of 32°

/// The opacity of the colour of the marked half.
const MARK: f64 = 0.62;

/// The half of a body on one side of its centre of mass, along an axis of the body, and its colour.
pub(crate) type Marked<'a> = Option<(&'a Vector3<f64>, Ink)>;

/// Draws surfaces turned by `rotation`, the farther ones first. One half has a colour of its own, so that a
/// reader sees the body turn over.
pub(crate) fn solid(
    canvas: &Canvas,
    view: &View,
    surfaces: &[Surface],
    rotation: &Matrix3<f64>,
    marked: Marked<'_>,
) {
    let depth = |piece: &Surface| (rotation * middle(&piece.vertices)).dot(&view.toward());
    let mut pieces: Vec<Surface> = surfaces.iter().flat_map(pieces).collect();
    pieces.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
    pieces.iter().for_each(|piece| convex(canvas, view, piece, rotation, marked));
}

/// A convex surface unchanged; other surfaces face by face.
fn pieces(surface: &Surface) -> Vec<Surface> {
    let alone = |face: &Vec<usize>| Surface {
        vertices: face.iter().map(|&i| surface.vertices[i]).collect(),
        faces: vec![(0..face.len()).collect()],
        convex: false,
    };
    if surface.convex { vec![surface.clone()] } else { surface.faces.iter().map(alone).collect() }
}

fn middle(points: &[Vector3<f64>]) -> Vector3<f64> {
    points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64
}

/// The outward normal, of length 1; zero for a line or a point.
fn normal(surface: &Surface, face: &[usize]) -> Vector3<f64> {
    let p = |i: usize| surface.vertices[face[i]];
    let fan = (1..face.len().saturating_sub(1)).map(|i| (p(i) - p(0)).cross(&(p(i + 1) - p(0))));
    fan.sum::<Vector3<f64>>().try_normalize(0.0).unwrap_or_default()
}

/// Where a ray from the centre of mass leaves these surfaces for the last time, m; zero if it hits none.
pub(crate) fn exit(surfaces: &[Surface], ray: &Vector3<f64>) -> f64 {
    let faces = surfaces.iter().flat_map(|surface| surface.faces.iter().map(move |face| (surface, face)));
    let hits = faces.filter(|(_, face)| face.len() > 2).filter_map(|(surface, face)| {
        let (out, p) = (normal(surface, face), |i: usize| surface.vertices[face[i % face.len()]]);
        let at = p(0).dot(&out) / ray.dot(&out);
        let side = |i: usize| p(i + 1) - p(i);
        let inside = |i| side(i).cross(&(ray * at - p(i))).dot(&out) >= -1e-9 * side(i).norm_squared();
        (at.is_finite() && (0..face.len()).all(inside)).then_some(at)
    });
    hits.fold(0.0, f64::max)
}

fn faces_viewer(view: &View, normal: &Vector3<f64>) -> bool {
    normal.dot(&view.toward()) > 1e-9
}

/// The part of a face on this side of the centre of mass.
fn cut(surface: &Surface, face: usize, along: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let corners: Vec<_> = surface.faces[face].iter().map(|&i| surface.vertices[i]).collect();
    // A corner on the cut belongs to both halves, on whichever side rounding puts it.
    let near = 1e-9 * corners.iter().map(|p| p.amax()).fold(0.0, f64::max);
    let sides = corners.iter().zip(corners.iter().cycle().skip(1)).flat_map(|(a, b)| {
        let (p, q) = (a.dot(along), b.dot(along));
        [(p >= -near).then_some(*a), (p * q < 0.0).then(|| a + (b - a) * (p / (p - q)))]
    });
    sides.flatten().collect()
}

/// Draws a convex surface, or one face of another surface if it faces the viewer.
fn convex(canvas: &Canvas, view: &View, surface: &Surface, rotation: &Matrix3<f64>, marked: Marked<'_>) {
    let normals: Vec<_> = surface.faces.iter().map(|face| normal(surface, face)).collect();
    if !surface.convex && !faces_viewer(view, &(rotation * normals[0])) {
        return;
    }
    let edge = if surface.convex { Pen::new(Ink::Text, 1.2) } else { Pen::new(Ink::Text, 0.5).opacity(0.5) };
    let place = |p: Vector3<f64>| view.at(&(rotation * p));
    let places: Vec<P> = surface.vertices.iter().map(|&p| place(p)).collect();
    let half = |along: &Vector3<f64>| -> Vec<P> {
        (0..surface.faces.len()).flat_map(|face| cut(surface, face, along)).map(place).collect()
    };
    if surface.faces.iter().all(|face| face.len() < 3) {
        for face in &surface.faces {
            match face[..] {
                [a, b] => canvas.line(places[a], places[b], Pen::new(Ink::Text, 1.6)),
                [a] => canvas.disc(places[a], 4.0, Fill::new(Ink::Text), None),
                _ => {}
            }
        }
        if let Some((along, ink)) = marked {
            half(along).into_iter().for_each(|p| canvas.disc(p, 4.0, Fill::new(ink), None));
        }
        return;
    }
    let outline = hull(&places);
    canvas.area(&outline, Fill::new(Ink::Surface), None);
    if let Some((along, ink)) = marked {
        // Both halves are convex, so the nearer one hides the part of the other that it covers.
        let mut halves = [(*along, Some(ink)), (-along, None)];
        let near = |half: &(Vector3<f64>, _)| (rotation * half.0).dot(&view.toward());
        halves.sort_by(|a, b| near(a).total_cmp(&near(b)));
        for (along, ink) in halves {
            let half = hull(&half(&along));
            canvas.area(&half, Fill::new(Ink::Surface), None);
            ink.into_iter().for_each(|ink| canvas.area(&half, Fill::new(ink).opacity(MARK), None));
        }
    }
    canvas.area(&outline, Fill::new(Ink::Text).opacity(0.05), Some(edge));
    let bent = bent_faces(surface, &normals);
    // Light from above the viewer's left shoulder.
    let light = Vector3::new(0.1, -0.3, 1.0).normalize();
    for (number, face) in surface.faces.iter().enumerate() {
        let out = rotation * normals[number];
        if bent[number] || !faces_viewer(view, &out) {
            continue;
        }
        let corners: Vec<P> = face.iter().map(|&i| places[i]).collect();
        let shade = 0.13 * (0.5 - 0.5 * out.dot(&light));
        canvas.area(&corners, Fill::new(Ink::Text).opacity(shade), Some(edge));
    }
}

/// Which faces continue into a neighbour without a visible edge.
fn bent_faces(surface: &Surface, normals: &[Vector3<f64>]) -> Vec<bool> {
    let mut sides: HashMap<[usize; 2], Vec<usize>> = HashMap::new();
    for (number, face) in surface.faces.iter().enumerate() {
        for (i, &from) in face.iter().enumerate() {
            let to = face[(i + 1) % face.len()];
            sides.entry([from.min(to), from.max(to)]).or_default().push(number);
        }
    }
    let mut bent = vec![false; normals.len()];
    for faces in sides.values() {
        if let [a, b] = faces[..]
            && normals[a].dot(&normals[b]) > BENT
        {
            (bent[a], bent[b]) = (true, true);
        }
    }
    bent
}

/// The corners of the convex hull of the points, by Andrew's monotone chains.
pub(crate) fn hull(points: &[P]) -> Vec<P> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let left = |a: P, b: P, c: P| (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0) <= 0.0;
    let chain = |points: &mut dyn Iterator<Item = P>| {
        let mut chain: Vec<P> = Vec::new();
        for p in points {
            while chain.len() > 1 && left(chain[chain.len() - 2], chain[chain.len() - 1], p) {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut whole = chain(&mut sorted.iter().copied());
    whole.extend(chain(&mut sorted.iter().rev().copied()));
    whole
}
