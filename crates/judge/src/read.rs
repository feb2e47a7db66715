//! What a record says: its rows, its comments, and how its numbers are meant.

mod clock;
mod columns;
mod comment;
mod fit;
mod grid;
mod known;
mod pace;
mod reading;
mod rounding;
mod rows;
mod state;

pub(crate) use clock::Clock;
pub use columns::Kind;
pub(crate) use columns::{Columns, Separator, TimeColumn};
pub(crate) use comment::Header;
pub(crate) use fit::{least, normal, slopes};
pub(crate) use grid::Grid;
pub use known::Note;
pub(crate) use known::{Known, Said};
pub(crate) use pace::{by_how_much, is_limited, rounded, times_the_turn, to_four_places};
pub use reading::FileMistake;
pub(crate) use reading::{Reading, law};
pub(crate) use rounding::{Floor, last_place, of_attitudes, rounding, significant, significant_bits};
pub(crate) use rows::{Exact, Printed, Raw, Rows, Source};
pub(crate) use state::{Pair, Row, angle_between, in_world, median, middle_and_most, ordered, spin};
