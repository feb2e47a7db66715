use super::{Drawing, ink_of};
use crate::draw::{Canvas, Cuboid, Fill, Ink, Label, P, Pen, View};
use crate::motion;
use nalgebra::{Matrix3, Vector3};
use tumbling::body::named;
use tumbling::{Axis, Inertia};

/// The push, rad; the spin is a turn a second.
const PUSH: f64 = 0.02;

/// How many turns are drawn after the throw.
const TURNS: usize = 4;

/// A toss: about which axis of the book, and which of its arrows is watched to count the turns.
struct Toss {
    words: &'static str,
    axis: Axis,
    about: usize,
    watched: usize,
}

const TOSSES: [Toss; 3] = [
    Toss { words: "about the spine", axis: Axis::Smallest, about: 2, watched: 1 },
    Toss { words: "through the covers", axis: Axis::Largest, about: 1, watched: 2 },
    Toss { words: "across the cover, end over end", axis: Axis::Middle, about: 0, watched: 2 },
];

/// The book, or another flat box, upright at the identity: its width along x, its thickness along y, its
/// height along z.
pub(crate) fn draw_book(canvas: &Canvas, view: &View, edges: &Vector3<f64>, rotation: Matrix3<f64>) {
    let solid = Cuboid { rotation, half: edges * 0.5 };
    let edge = Pen::new(Ink::Text, 1.2);
    for (axis, sign) in [(0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0), (2, -1.0), (2, 1.0)] {
        if !solid.faces(view, axis, sign) {
            continue;
        }
        let corners = solid.face(axis, sign).map(|p| view.at(&p));
        canvas.area(&corners, Fill::new(Ink::Paper), None);
        match (axis, sign > 0.0) {
            // The front cover, with its title.
            (1, false) => {
                canvas.area(&corners, Fill::new(Ink::Text).opacity(0.78), Some(edge));
                let title = [(-0.6, 0.3), (0.7, 0.3), (0.7, 0.66), (-0.6, 0.66)];
                let title = title.map(|(x, z)| view.at(&solid.point(x, -1.0, z)));
                canvas.area(&title, Fill::new(Ink::Paper), None);
            }
            // The back cover, plain.
            (1, true) => canvas.area(&corners, Fill::new(Ink::Surface), Some(edge)),
            // The spine.
            (0, false) => canvas.area(&corners, Fill::new(Ink::Text).opacity(0.5), Some(edge)),
            // The edges of the pages.
            _ => canvas.area(&corners, Fill::new(Ink::Paper), Some(edge)),
        }
    }
}

/// The book's attitudes at the throw and after each turn.
fn after_each_turn(inertia: Inertia, toss: &Toss) -> Result<Vec<Matrix3<f64>>, Box<dyn std::error::Error>> {
    let run = motion::free(&motion::tossed(inertia, toss.about, PUSH)?, 0.001, 1500 * TURNS)?;
    motion::after_each_turn(run.iter().map(|(_, body)| Ok(body.rotation())), toss.about, toss.watched, TURNS)
}

/// Whether the front cover is turned to the reader.
fn shows_front(view: &View, rotation: &Matrix3<f64>) -> bool {
    rotation.column(1).dot(&view.toward()) < 0.0
}

pub(super) fn draw() -> Drawing {
    let inertia = named::NamedBody::Book.properties()?.inertia();
    let edges = Vector3::from(named::BOOK.sizes);
    let canvas = Canvas::sized(500, 470);
    let mut said = Vec::new();
    for (row, toss) in TOSSES.iter().enumerate() {
        let top = 24.0 + 138.0 * row as f64;
        canvas.label((14.0, top), &Label::new(toss.words).ink(ink_of(toss.axis)).bold());
        let mut sides = Vec::new();
        for (turn, rotation) in after_each_turn(inertia, toss)?.into_iter().enumerate() {
            let centre: P = (58.0 + 96.0 * turn as f64, top + 66.0);
            let view = View::new(centre, 430.0, -90.0 + 22.0, 18.0);
            draw_book(&canvas, &view, &edges, rotation);
            sides.push(if shows_front(&view, &rotation) { "front" } else { "back" });
        }
        said.push(format!("{}: {}", toss.words, sides.join(", ")));
    }
    for turn in 0..=TURNS {
        canvas.label((58.0 + 96.0 * turn as f64, 434.0), &Label::new(turn.to_string()).middle());
    }
    canvas.label((250.0, 460.0), &Label::new("turns since the throw").middle());
    canvas.described(format!(
        "Three tosses of a book, each with a slip of {PUSH} rad to the side, drawn at the throw and after each of {TURNS} turns. The \
         cover that is seen: {}. In the first two tosses the book looks the same each time; in the third it has turned over.",
        said.join("; ")
    ))
}
