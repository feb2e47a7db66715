//! Why the faces of a mesh do not bound a solid.

use super::{Margin, Subject};
use core::fmt;

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum MeshRefusal {
    BadFace {
        face: usize,
        vertices: [usize; 3],
        count: usize,
    },
    OpenMesh {
        edge: [usize; 2],
        faces: usize,
    },
    /// The edge's two vertices, in the direction that both faces take.
    FlippedFace {
        edge: [usize; 2],
    },
    RepeatedFace {
        face: usize,
        before: usize,
        vertices: [usize; 3],
    },
    NoVolume {
        volume: f64,
        tolerance: f64,
    },
    /// `winding`: how many times the shells together enclose a point next to this one.
    /// More shells in one another than can be looked at.
    TooManyShells {
        shells: usize,
        most: usize,
    },
    MisplacedShell {
        face: usize,
        volume: f64,
        winding: f64,
    },
}

impl MeshRefusal {
    pub(super) fn subject(&self) -> Subject {
        match self {
            Self::BadFace { .. } | Self::FlippedFace { .. } | Self::RepeatedFace { .. } => Subject::Face,
            Self::OpenMesh { .. } => Subject::MeshEdge,
            Self::NoVolume { .. } => Subject::Volume,
            Self::MisplacedShell { .. } | Self::TooManyShells { .. } => Subject::Shell,
        }
    }
}

impl fmt::Display for MeshRefusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BadFace { face, vertices: [a, b, c], count } => write!(
                f,
                "face {face} is ({a}, {b}, {c}): it must name three different vertices below {count}"
            ),
            Self::OpenMesh { edge: [a, b], faces } => write!(
                f,
                "the edge from vertex {a} to vertex {b} belongs to {faces} face(s): in a closed surface it is 2, \
                 or 4 where parts touch"
            ),
            Self::FlippedFace { edge: [a, b] } => {
                write!(f, "two faces run from vertex {a} to vertex {b}: one of them is turned inside out")
            }
            Self::NoVolume { volume, tolerance } => write!(
                f,
                "the volume comes out as {volume:?}, not above zero by more than rounding ({}): the solid \
                 is flat, or its faces do not run counter-clockwise seen from outside",
                Margin(*tolerance)
            ),
            Self::RepeatedFace { face, before, vertices: [a, b, c] } => {
                write!(f, "face {face}, ({a}, {b}, {c}), is face {before} again: each must be listed once")
            }
            Self::TooManyShells { shells, most } => write!(
                f,
                "{shells} shells of which so many lie in one another that to see how would take more than the {most}                  views of a face that are taken"
            ),
            Self::MisplacedShell { face, volume, winding } => write!(
                f,
                "the shell that face {face} belongs to, of volume {volume:?}, is turned or placed wrongly: next to it \
                 the shells enclose a point {winding} times, and it must be 0 (outside the solid) or 1 (inside); a \
                 shell of negative volume is a cavity and must lie in the solid"
            ),
        }
    }
}
