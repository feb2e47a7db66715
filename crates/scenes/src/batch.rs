//! Many bodies of a scene: planned one by one, answered side by side.
//!
//! Bodies whose motion is known in closed form are answered in lanes, where at least three of them are
//! together; bodies whose outputs are constant, or that are driven by a torque, are answered one at a time.
//! The answers come in blocks of up to 256 bodies at up to 16 times, so the memory needed does not grow
//! with the number of times nor, beyond some blocks, with the number of bodies. With the feature `threads`
//! up to 32 blocks of free bodies are computed at once; of driven ones one block, whose bodies are planned
//! and answered on any thread.
//!
//! Driven bodies have no lanes. A step by Taylor series already consists of rows of four numbers, which the
//! compiler turns into vector instructions. A version with four bodies in lanes, each with its own step
//! length and the same bits as alone, was slower than one body at a time in a build for any x86-64, and
//! faster only with `-C target-cpu=native`; that did not justify the code.
//!
//! An answer has the same bits as that of [`Scene::run`].
//!
//! ```
//! use nalgebra::Vector3;
//! use std::ops::ControlFlow;
//! use tumbling_scenes::{InitialState, Outputs, Scene, Times, batch};
//!
//! // A thousand boxes, one of them with moments that no body has.
//! let box_of = |k: usize| {
//!     let moments = if k == 500 { Vector3::new(1.0, 1.0, 3.0) } else { Vector3::new(1.0, 1.5, 2.0) };
//!     InitialState::spinning(moments, Vector3::new(0.1, 1.0 + 0.001 * k as f64, 0.2))
//! };
//! let outputs = Outputs { spin: true, attitude: true, ..Outputs::NOTHING };
//! let scene = Scene::new((0..1000).map(box_of), vec![], Times::every(0.5, 60.0), outputs, 1e-9)?;
//!
//! // The work on a block is done on any thread, its result is taken on this one.
//! let (mut states, mut wrong) = (0, Vec::new());
//! batch::run(
//!     &scene,
//!     |block| (block.states().count(), block.wrong.to_vec()),
//!     |(some, others)| {
//!         states += some;
//!         wrong.extend(others);
//!         ControlFlow::Continue(())
//!     },
//! );
//! assert_eq!(states, 999 * 121);
//! assert_eq!(wrong.len(), 1);
//! assert!(wrong[0].1.to_string().starts_with("body 500: "));
//! # Ok::<(), tumbling_scenes::Error>(())
//! ```

use crate::error::Error;
use crate::lanes::Lanes;
use crate::plan::Plan;
use crate::scene::Scene;
use crate::states::{Answer, States};
#[cfg(target_arch = "x86_64")]
use multiversion::{multiversion, target::match_target};
use nalgebra::{UnitQuaternion, Vector3};
#[cfg(feature = "threads")]
use rayon::prelude::*;
use std::ops::{ControlFlow, Range};
use tumbling::exact::{Batch, FreeMotion, Instant};

/// The number of bodies that are sorted, worked on and put out together.
const TILE: usize = 256;

/// The number of instants for which a tile is answered before its answers are output: tile and answers
/// together fit the second-level cache.
const INSTANTS: u64 = 16;

/// The number of tiles in work at once, on any number of threads, so that the order is always the same.
const AT_ONCE: usize = 32;

/// With fewer bodies than this, lanes are not worth their cost.
const WORTH: usize = 3;

/// Some bodies of a scene at some of its times.
#[derive(Debug, Clone, PartialEq)]
pub struct Block<'a> {
    /// The numbers of the bodies.
    pub bodies: Range<usize>,
    /// The numbers of the times.
    pub times: Range<u64>,
    /// All bodies at the first of these times, then all at the next; `None` for a body that has no answer, or
    /// none any more.
    pub answers: &'a [Option<Answer>],
    /// The bodies whose answers end in this block: their numbers in the scene and the errors.
    pub wrong: &'a [(usize, Error)],
}

impl Block<'_> {
    /// Each state with the number of its body: all bodies at the first of the times, then all at the next.
    pub fn states(&self) -> impl Iterator<Item = (usize, &Answer)> {
        let (first, count) = (self.bodies.start, self.bodies.len().max(1));
        let place = move |(n, state): (usize, &'_ Option<Answer>)| state.as_ref().map(|_| first + n % count);
        self.answers.iter().enumerate().filter_map(move |slot| Some((place(slot)?, slot.1.as_ref()?)))
    }
}

/// Answers a whole scene. `work` is called with one block after the other, or, with the feature `threads`,
/// with several blocks at once on as many threads. `take` is called with each result, on this thread and
/// always in the same order: of the first 32 blocks of bodies (of driven bodies, of the first block) the
/// first times, then their next times, to the last; then the next bodies. A block whose bodies have all
/// failed is not continued. `take` may stop the run.
pub fn run<R: Send>(
    scene: &Scene,
    work: impl Fn(&Block<'_>) -> R + Sync,
    mut take: impl FnMut(R) -> ControlFlow<()>,
) {
    let bodies = scene.bodies().len();
    let times = scene.times().count();
    // A driven body is some kilobytes of series, and the bodies of one tile are enough for all threads.
    let some = if scene.torques().is_empty() { TILE * AT_ONCE } else { TILE };
    for first in (0..bodies).step_by(some) {
        let tiles: Vec<usize> = (first..bodies.min(first + some)).step_by(TILE).collect();
        let plans =
            |tile: usize| together((tile..bodies.min(tile + TILE)).collect(), |_, body| scene.plan(body));
        let planned = together(tiles, |_, tile| (tile, plans(tile)));
        let mut active =
            together(planned.iter().collect(), |_, (tile, plans)| ActiveTile::new(scene, *tile, plans));
        let mut from = 0;
        while from < times {
            let to = times.min(from + INSTANTS);
            let block = |room: &mut _, tile: &mut ActiveTile<'_>| work(&tile.block(from..to, room));
            for done in together(active.iter_mut().collect(), block) {
                if take(done).is_break() {
                    return;
                }
            }
            active.retain(|tile| tile.failed.iter().any(|failed| !failed));
            from = to;
        }
    }
}

/// Where the answers of a block are written: one block after the other in the same place, so that it stays in
/// the cache.
type Room = Vec<Option<Answer>>;

/// Each of them done, in order, with some room: on all threads with the feature `threads`.
fn together<A: Send, B: Send>(all: Vec<A>, each: impl Fn(&mut Room, A) -> B + Sync + Send) -> Vec<B> {
    #[cfg(feature = "threads")]
    return all.into_par_iter().map_init(Room::new, each).collect();
    #[cfg(not(feature = "threads"))]
    all.into_iter().scan(Room::new(), |room, one| Some(each(room, one))).collect()
}

/// The bodies of a tile, while they are answered.
struct ActiveTile<'p> {
    scene: &'p Scene,
    first: usize,
    plans: &'p [Result<Plan<'p>, Error>],
    /// The bodies answered in lanes.
    lanes: Answers,
    /// The places in the tile of the bodies in the lanes, in their order there.
    places: Vec<usize>,
    /// The others that have a plan.
    alone: Vec<(usize, States<'p>)>,
    wrong: Vec<(usize, Error)>,
    /// The bodies that have no answer any more.
    failed: Vec<bool>,
}

/// Called with the number of a time, the number of a body, its spin and its attitude.
type Put<'a> = dyn FnMut(usize, usize, Vector3<f64>, Option<UnitQuaternion<f64>>) + 'a;

/// Answers bodies at some times.
type Answers = Box<dyn Fn(&[f64], &mut Put<'_>) -> Result<(), tumbling::Error> + Send>;

/// Free motions in the best number of lanes for this processor, with attitudes or only spins. The bits do not
/// depend on it: the compiler does not fuse a product and a sum by itself.
#[cfg_attr(target_arch = "x86_64", multiversion(targets("x86_64+avx2+fma")))]
pub fn side_by_side(motions: &[FreeMotion], attitudes: bool) -> Answers {
    // A macro, since a closure is compiled for the vectors of the function that it stands in.
    macro_rules! in_lanes {
        ($T:ty) => {
            if attitudes {
                let batch = Batch::<$T>::new(motions);
                Box::new(move |times, put| {
                    batch.each(times, |time, body, at: Instant| put(time, body, at.omega, Some(at.attitude)))
                })
            } else {
                let batch = Batch::<$T, Vector3<f64>>::new(motions);
                Box::new(move |times, put| batch.each(times, |time, body, spin| put(time, body, spin, None)))
            }
        };
    }
    #[cfg(target_arch = "x86_64")]
    match_target! {
        "x86_64+avx2+fma" => in_lanes!(Lanes<4, true>),
        _ => in_lanes!(Lanes<4, false>),
    }
    #[cfg(not(target_arch = "x86_64"))]
    in_lanes!(Lanes<4, { cfg!(target_arch = "aarch64") }>)
}

impl<'p> ActiveTile<'p> {
    fn new(scene: &'p Scene, first: usize, plans: &'p [Result<Plan<'p>, Error>]) -> Self {
        let (mut motions, mut places, mut alone, mut wrong) = (vec![], vec![], vec![], vec![]);
        let lanes = plans.iter().flatten().filter_map(Plan::moving).count() >= WORTH;
        for (place, plan) in plans.iter().enumerate() {
            match plan {
                Ok(plan) => match plan.moving().filter(|_| lanes) {
                    Some(motion) => {
                        motions.push(*motion);
                        places.push(place);
                    }
                    None => alone.push((place, plan.states())),
                },
                Err(error) => wrong.push((first + place, error.clone())),
            }
        }
        let lanes = side_by_side(&motions, scene.outputs().attitude);
        let failed = plans.iter().map(Result::is_err).collect();
        Self { scene, first, plans, lanes, places, alone, wrong, failed }
    }

    fn block<'a>(&'a mut self, times: Range<u64>, room: &'a mut Room) -> Block<'a> {
        let Self { scene, first, plans, lanes, places, alone, wrong, failed } = self;
        let (first, bodies) = (*first, plans.len());
        // Errors are reported once.
        if times.start > 0 {
            wrong.clear();
        }
        let at: Vec<f64> = times.clone().map(|n| scene.times().nth(n)).collect();
        room.clear();
        room.resize(bodies * at.len(), None);
        let mut put = |time: usize, place: usize, state: Result<Answer, Error>| match state {
            Ok(state) if !failed[place] => room[time * bodies + place] = Some(state),
            Err(source) if !failed[place] => {
                failed[place] = true;
                wrong.push((first + place, Error::Body { index: first + place, source: Box::new(source) }));
            }
            _ => {}
        };
        let answered = lanes(&at, &mut |time, body, omega, attitude| {
            let place = places[body];
            if let Ok(plan) = &plans[place] {
                put(time, place, plan.state(at[time], omega, attitude));
            }
        });
        // The times of a scene are finite; if one were not, no body in lanes would have an answer.
        if let Err(error) = answered {
            places.iter().for_each(|&place| put(0, place, Err(error.clone().into())));
        }
        let next = |_: &mut Room, (place, states): &mut (usize, States<'_>)| {
            (*place, states.by_ref().take(at.len()).collect::<Vec<_>>())
        };
        for (place, states) in together(alone.iter_mut().collect(), next) {
            for (time, state) in states.into_iter().enumerate() {
                put(time, place, state);
            }
        }
        wrong.sort_by_key(|(body, _)| *body);
        Block { bodies: first..first + bodies, times, answers: room, wrong }
    }
}
