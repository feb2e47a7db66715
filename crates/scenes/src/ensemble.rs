//! Many bodies in free motion: prepared once, then answered at any instants, as many at once as the processor
//! has lanes and threads.
//!
//! Bodies are kept in [tiles](TILE), and a tile's bodies sorted by their kind of motion, so that those next
//! to each other run through the same functions side by side. Answers come in [chunks](Chunk) of one tile at
//! some instants, in the order in which bodies and times were given: the memory needed grows with the bodies,
//! not with the times.
//!
//! An answer has the bits of [`InitialState::motion`]: neighbours, their number, lanes and threads change
//! nothing.
//!
//! With the feature `threads`, off by default, the tiles are shared out over the threads of
//! [rayon](https://docs.rs/rayon)'s pool.
//!
//! ```
//! use nalgebra::Vector3;
//! use tumbling_scenes::InitialState;
//! use tumbling_scenes::ensemble::Ensemble;
//!
//! // A thousand boxes, one of them with moments that no body has.
//! let body = |k: usize| {
//!     let moments = if k == 500 { Vector3::new(1.0, 1.0, 3.0) } else { Vector3::new(1.0, 1.5, 2.0) };
//!     InitialState::spinning(moments, Vector3::new(0.1, 1.0 + 0.001 * k as f64, 0.2))
//! };
//! let ensemble = Ensemble::instants(1000, body, |_| {});
//! assert_eq!(ensemble.refused()[0].body, 500);
//! assert!(ensemble.refused()[0].error.to_string().contains("1 + 1 >= 3"));
//! let mut sum = 0.0;
//! ensemble.in_order(&[0.5, 1.0], |_| {}, |chunk| {
//!     for (time, body, instant) in chunk.states() {
//!         if body == 999 {
//!             sum += instant.omega.norm() * (1.0 + time as f64);
//!         }
//!     }
//! })?;
//! assert!(sum > 3.0);
//! # Ok::<(), tumbling_scenes::Error>(())
//! ```

mod four_lanes;
mod solver;

pub use four_lanes::FourLanes;
pub use solver::Solver;

use crate::error::{Error, finite};
use crate::initial_state::InitialState;

use nalgebra::Vector3;
#[cfg(feature = "threads")]
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use tumbling::exact::Batch;

/// The number of bodies that are sorted, worked on and put out together.
pub const TILE: usize = 256;

/// The number of instants that a tile is answered at before its answers are put out: they fit the processor's
/// second cache with it.
pub const INSTANTS: usize = 16;

/// A body that was refused.
#[derive(Debug, Clone, PartialEq)]
pub struct Refused {
    /// Its number, from 0.
    pub body: usize,
    /// What is wrong with it.
    pub error: Error,
}

/// How far the work is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// The number of bodies prepared, or of states answered.
    pub done: usize,
    /// The number of all of them.
    pub of: usize,
}

/// Answers of one tile at some of the times.
#[derive(Debug, Clone, PartialEq)]
pub struct Chunk<'a, S> {
    /// The indices of the bodies, from 0.
    pub bodies: Range<usize>,
    /// The indices of the times, from 0.
    pub times: Range<usize>,
    /// All bodies at the first of the times, then all at the next. A body that was refused has NaN
    /// throughout.
    pub answers: &'a [S],
}

impl<S: Copy> Chunk<'_, S> {
    /// Each answer with the index of its time and that of its body.
    pub fn states(&self) -> impl Iterator<Item = (usize, usize, S)> + '_ {
        let bodies = self.bodies.len().max(1);
        let place = move |(n, &state): (usize, &S)| {
            (self.times.start + n / bodies, self.bodies.start + n % bodies, state)
        };
        self.answers.iter().enumerate().map(place)
    }
}

/// Bodies prepared for a [`Solver`].
#[derive(Debug, Clone)]
pub struct Ensemble<W> {
    tiles: Vec<Tile<W>>,
    bodies: usize,
    refused: Vec<Refused>,
}

#[derive(Debug, Clone)]
struct Tile<W> {
    first: usize,
    bodies: usize,
    /// Where the bodies of the solver are in the tile, empty if none was refused.
    places: Vec<usize>,
    solver: W,
}

impl Ensemble<Batch<FourLanes>> {
    /// Prepares bodies for spin and attitude: as many as `bodies`, the one of index `k` being `body(k)`; a
    /// [`Body`](tumbling::Body) converts by `into`. `tell` is called with the progress; `|_| {}` ignores it.
    pub fn instants(
        bodies: usize,
        body: impl Fn(usize) -> InitialState + Sync,
        tell: impl Fn(Progress) + Sync,
    ) -> Self {
        Self::prepare(bodies, body, tell)
    }
}

impl Ensemble<Batch<FourLanes, Vector3<f64>>> {
    /// As [`instants`](Self::instants), for their spin alone, which takes about half the memory and the time.
    pub fn spins(
        bodies: usize,
        body: impl Fn(usize) -> InitialState + Sync,
        tell: impl Fn(Progress) + Sync,
    ) -> Self {
        Self::prepare(bodies, body, tell)
    }
}

impl<W: Solver> Ensemble<W> {
    /// As [`instants`](Ensemble::instants), for any solver, in any lanes.
    pub fn prepare(
        bodies: usize,
        body: impl Fn(usize) -> InitialState + Sync,
        tell: impl Fn(Progress) + Sync,
    ) -> Self {
        let done = AtomicUsize::new(0);
        let tile = |n: usize| {
            let (tile, refused) = Tile::new(n * TILE..bodies.min((n + 1) * TILE), &body);
            tell(Progress { done: done.fetch_add(tile.bodies, Ordering::Relaxed) + tile.bodies, of: bodies });
            (tile, refused)
        };
        let count = bodies.div_ceil(TILE);
        #[cfg(feature = "threads")]
        let made: Vec<_> = (0..count).into_par_iter().map(tile).collect();
        #[cfg(not(feature = "threads"))]
        let made: Vec<_> = (0..count).map(tile).collect();
        let (tiles, refused): (Vec<_>, Vec<_>) = made.into_iter().unzip();
        Self { tiles, bodies, refused: refused.into_iter().flatten().collect() }
    }

    /// The number of bodies given, refused ones included.
    #[must_use]
    pub fn len(&self) -> usize {
        self.bodies
    }

    /// Whether none was given.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bodies == 0
    }

    /// The bodies that were refused, in order.
    #[must_use]
    pub fn refused(&self) -> &[Refused] {
        &self.refused
    }

    /// Answers every body at each of `times` (s, in any order) and puts the answers out as they come: with
    /// the feature `threads` from several threads at once, tiles in no particular order.
    ///
    /// # Errors
    /// A time that is not finite, before any answer is put out.
    pub fn each(
        &self,
        times: &[f64],
        tell: impl Fn(Progress) + Sync,
        put: impl Fn(Chunk<'_, W::Answer>) + Sync,
    ) -> Result<(), Error> {
        check(times)?;
        let of = self.bodies.saturating_mul(times.len());
        let done = AtomicUsize::new(0);
        let work = |room: &mut Vec<W::Answer>, tile: &Tile<W>| {
            for (n, span) in times.chunks(INSTANTS).enumerate() {
                put(tile.answer(span, n * INSTANTS, room)?);
            }
            let more = tile.bodies * times.len();
            tell(Progress { done: done.fetch_add(more, Ordering::Relaxed) + more, of });
            Ok(())
        };
        #[cfg(feature = "threads")]
        return self.tiles.par_iter().try_for_each_init(Vec::new, work);
        #[cfg(not(feature = "threads"))]
        {
            let mut room = Vec::new();
            self.tiles.iter().try_for_each(|tile| work(&mut room, tile))
        }
    }

    /// The same on this thread alone and in order: all bodies at the first [`INSTANTS`] times, tile by tile,
    /// then at the next.
    ///
    /// # Errors
    /// A time that is not finite, before any answer is put out.
    pub fn in_order(
        &self,
        times: &[f64],
        mut tell: impl FnMut(Progress),
        mut put: impl FnMut(Chunk<'_, W::Answer>),
    ) -> Result<(), Error> {
        check(times)?;
        let mut progress = Progress { done: 0, of: self.bodies.saturating_mul(times.len()) };
        let mut room = Vec::new();
        for (n, span) in times.chunks(INSTANTS).enumerate() {
            for tile in &self.tiles {
                put(tile.answer(span, n * INSTANTS, &mut room)?);
                progress.done += tile.bodies * span.len();
                tell(progress);
            }
        }
        Ok(())
    }
}

fn check(times: &[f64]) -> Result<(), Error> {
    times.iter().try_for_each(|&time| finite("the time", time).map(drop))
}

impl<W: Solver> Tile<W> {
    fn new(range: Range<usize>, body: &impl Fn(usize) -> InitialState) -> (Self, Vec<Refused>) {
        let (mut motions, mut places, mut refused) = (Vec::new(), Vec::new(), Vec::new());
        for number in range.clone() {
            match body(number).motion() {
                Ok(motion) => {
                    motions.push(motion);
                    places.push(number - range.start);
                }
                Err(error) => refused.push(Refused { body: number, error }),
            }
        }
        if refused.is_empty() {
            places = Vec::new();
        }
        (Self { first: range.start, bodies: range.len(), places, solver: W::of(&motions) }, refused)
    }

    /// Some of the times, the first of which has this number.
    fn answer<'a>(
        &self,
        times: &[f64],
        number: usize,
        room: &'a mut Vec<W::Answer>,
    ) -> Result<Chunk<'a, W::Answer>, Error> {
        let bodies = self.bodies;
        let whole = self.places.is_empty();
        if !whole || room.len() != bodies * times.len() {
            room.clear();
            room.resize(bodies * times.len(), W::REFUSED);
        }
        self.solver.each(times, |time, body, state| {
            let place = if whole { Some(body) } else { self.places.get(body).copied() };
            if let Some(slot) = place.and_then(|place| room.get_mut(time * bodies + place)) {
                *slot = state;
            }
        })?;
        Ok(Chunk {
            bodies: self.first..self.first + bodies,
            times: number..number + times.len(),
            answers: room,
        })
    }
}
