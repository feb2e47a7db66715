//! What is known of a record besides its rows: what it says, and what its first rows show.

use crate::read::{
    Clock, Floor, Grid, Kind, Pair, Raw, Reading, Row, angle_between, median, of_attitudes, rounding, spin,
};
use crate::thresholds::*;
use nalgebra::Vector3;

/// What a record says of itself.
#[derive(Default, Clone)]
pub(crate) struct Said {
    pub engine: Option<String>,
    pub kind: Kind,
    /// The step that it names, s.
    pub step: Option<f64>,
    /// Constant in the world, N m.
    pub torque: Option<Vector3<f64>>,
    /// Principal moments, kg m².
    pub moments: Option<Vector3<f64>>,
    pub notes: Vec<Note>,
    /// The names of the columns that are not read.
    pub ignored: Vec<String>,
}

/// What it says, and how its numbers are meant.
#[derive(Clone)]
pub(crate) struct Known {
    pub said: Said,
    /// The moments judged, kg m².
    pub moments: Vector3<f64>,
    pub grid: Option<Grid>,
    pub reading: Reading,
    pub clock: Clock,
    /// The rounding of the spins.
    pub floor: Floor,
}

/// At which line an attitude turns too far for its direction to be known, and by how much, rad.
pub(crate) type Stopped = Option<(usize, f64)>;

impl Known {
    /// From the first rows, whose times are put to the grid that they are rounded from.
    pub(crate) fn of(probe: &mut [Raw], mut said: Said, moments: Vector3<f64>) -> Self {
        let mut grid = Grid::of(probe, said.step);
        let is_open = grid.is_some_and(|grid| grid.step.is_infinite());
        if let Some(grid) = grid.as_mut().filter(|_| !is_open) {
            said.notes.push(Note::EvenSteps(grid.named, grid.step));
            probe.iter_mut().for_each(|raw| grid.put(raw));
        }
        let clock = Clock::of(probe);
        let mut reading = match said.kind {
            Kind::Attitude => Reading::of_attitudes(&clock.triples(probe), &moments),
            kind => Reading::of(kind, said.torque.is_none(), &clock.pairs(probe), &moments),
        };
        // Of times that are rounded so, no factor is known.
        if is_open && TIMES_OF_ROUNDING.contains(&reading.time) {
            reading.time = 1.0;
        }
        let (clock, note) = clock.read(reading.time, said.step);
        said.notes.extend(note);
        let of_numbers = rounding(probe, said.kind.in_world());
        let of_grid = grid.as_ref().map_or(0.0, |grid| grid.floor(probe, &reading, &moments));
        let floor = Floor {
            size: of_numbers.max(of_grid),
            attitude: of_attitudes(probe),
            few: of_numbers.max(of_grid) > FEW_DIGITS * f64::from(f32::EPSILON),
            single: of_numbers == f64::from(f32::EPSILON),
        };
        Self { said, moments, grid, reading, clock, floor }
    }

    /// Of attitudes alone that are read otherwise, as they are named.
    pub(crate) fn plainly(&self) -> Option<Self> {
        let reading = Reading::plain(Kind::Attitude);
        (!self.has_spin() && self.reading != reading).then(|| Self { reading, ..self.clone() })
    }

    pub(crate) fn has_spin(&self) -> bool {
        self.said.kind != Kind::Attitude
    }

    /// A row with its spin, which of attitudes alone the next one gives: none where that is missing. Where
    /// the attitude turns too far for it, the line up to which it does, and by how much, rad.
    pub(crate) fn row(&self, raw: &Raw, waiting: &mut Option<Row>) -> Result<Option<Row>, (usize, f64)> {
        let state = self.reading.state(raw, &self.moments);
        if self.has_spin() {
            return Ok(Some(state));
        }
        let Some(from) = waiting.replace(state) else { return Ok(None) };
        let (h, times) = self.clock.between(from.t, state.t);
        let pair = Pair { from, to: state, h };
        let ahead = state.attitude.filter(|_| times == 1.0).map(|q| (state.line, q));
        match spin(&self.moments, &pair) {
            None if times == 1.0 => Err((state.line, pair.turn().map_or(f64::NAN, |turn| turn.norm()))),
            found => Ok(found.map(|omega| Row { omega, ahead, ..from })),
        }
    }

    /// The first rows as motions, up to where one turns too far. A rounding of attitudes alone is so much
    /// more relative to the turn that makes a spin.
    pub(crate) fn understood(&mut self, probe: &[Raw], waiting: &mut Option<Row>) -> (Vec<Row>, Stopped) {
        let mut states = Vec::new();
        let mut push = |raw| {
            states.extend(self.row(raw, waiting)?);
            Ok(())
        };
        let stopped = probe.iter().try_for_each(&mut push).err();
        let turn = median(&mut states.iter().filter_map(|state| {
            let (_, ahead) = state.ahead?;
            let moves = state.omega != Vector3::zeros();
            Some(angle_between(&state.attitude?, &ahead)).filter(|turn| moves && *turn > 0.0)
        }));
        if !self.has_spin() && turn.is_finite() && turn > 0.0 {
            self.floor.size *= SPIN_FROM_TURN / turn.min(1.0);
        }
        (states, stopped)
    }
}

/// What was made of a file besides its rows. A note is no failure: the derive is there for its sentence.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Note {
    /// A comment seems to name a number, and none is read from it: its line, and what it speaks of.
    #[error("line {0} mentions `{1}`, but no number was read from it")]
    Unread(usize, &'static str),
    /// The record is of this story of the kit.
    #[error("the record is of the kit's story {0}")]
    Story(String),
    /// The body is at rest before this line: the rows before it are left out.
    #[error("the body is at rest before line {0}, and is judged from there")]
    Rest(usize),
    /// Rows repeat the row before them, under other times: how many, and the line of the first.
    #[error("rows that repeat the row before them: {0}, first in line {1}")]
    Again(u64, usize),
    /// Rounded moments that no body has are taken for those of a flat body.
    #[error(
        "the largest moment is printed as {printed}, {missing:.1e} more than the sum of the others, which is \
         impossible, but within its rounding; a flat body of {}, {}, {} kg m2 is judged",
        .moments.x, .moments.y, .moments.z
    )]
    Flat {
        /// The largest, as printed, kg m².
        printed: f64,
        /// How much more it is than the others together, kg m².
        missing: f64,
        /// The moments judged, kg m².
        moments: Vector3<f64>,
    },
    /// The header names a step of which each row is a whole number: the step, s, and that number.
    #[error("the header gives a step of {0:.9} s: rows are {1} such steps apart")]
    StepsPerRow(f64, u32),
    /// The header names a step of which the time from row to row is no whole number: both, s.
    #[error(
        "the header gives a step of {0:.9} s, but the rows are {1:.9} s apart, which is not a whole number of \
         such steps: it is not used"
    )]
    OtherStep(f64, f64),
    /// Times of few digits are taken for multiples of one step: whether the record names it, and the step as
    /// the file counts.
    #[error(
        "the times have few digits, and are read as multiples of the step {}, {:.9} s in the file's time",
        if *.0 { "in the header" } else { "that is their mean" }, .1
    )]
    EvenSteps(bool, f64),
}
