//! The judge of engines on a page: a record comes in by pieces, a verdict goes out as text.

use exchange::{Numbers, Text};
use nalgebra::Vector3;
use std::io::BufRead;
use tumbling_judge::{Options, judge};

/// The verdict, or why there is none.
pub static VERDICT: Text = Text::empty();

/// Judges a record.
///
/// The row contains: whether the three moments that follow are to be used (above zero: yes); the moments, kg
/// m²; the limit on the violation of a law; and for each law of
/// [`LawName::ALL`](tumbling_judge::LawName::ALL), in that order, a limit of its own (not above zero: none).
///
/// The text is then the verdict as a JSON object, and the answer is 1. For a record that cannot be judged,
/// the text says why, and the answer is 0.
pub fn judged(record: impl BufRead, row: &Numbers) -> usize {
    let [given, a, b, c, threshold] = row.take(0);
    let inertia = (given > 0.0).then(|| Vector3::new(a, b, c));
    let thresholds = row.take(5).map(|most: f64| (most > 0.0).then_some(most));
    let (text, count) = match judge(record, &Options { inertia, threshold, thresholds }) {
        Ok(verdict) => (serde_json::to_string(&verdict).unwrap_or_default(), 1),
        Err(why) => (why.to_string(), 0),
    };
    VERDICT.say(text);
    count
}

/// A record that is in the page's memory, requested in pieces.
#[cfg(target_arch = "wasm32")]
mod record {
    use exchange::{Numbers, Piece};
    use std::io::{BufReader, Read, Result};

    static PIECE: Piece = Piece::empty();

    #[expect(unsafe_code, reason = "what the page lends must be declared so; calling it is safe")]
    #[link(wasm_import_module = "page")]
    unsafe extern "C" {
        /// Writes the record's next bytes, at most this many, to this address; returns their number, which is
        /// 0 at the end.
        safe fn more(address: usize, room: usize) -> usize;
    }

    struct Record;

    impl Read for Record {
        fn read(&mut self, room: &mut [u8]) -> Result<usize> {
            let wanted = room.len().min(Piece::ROOM);
            let got = more(PIECE.address(), wanted).min(wanted);
            PIECE.copy_to(&mut room[..got]);
            Ok(got)
        }
    }

    pub(super) fn answer(_what: u32, row: &Numbers) -> usize {
        super::judged(BufReader::with_capacity(Piece::ROOM, Record), row)
    }
}

exchange::page!(record::answer, VERDICT, much);
