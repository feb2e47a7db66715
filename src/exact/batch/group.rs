//! Bodies of one kind of motion, in blocks as wide as there are lanes.

use super::Answer;
use crate::exact::kernel::Kernel;
use crate::exact::mount::{Mount, in_body, in_world};
use crate::exact::{FreeMotion, Instant};
use crate::inertia::Frame;
use crate::number::{Gather, Lane, splat};
use alloc::vec::Vec;
use core::mem::size_of;
use nalgebra::{Quaternion, UnitQuaternion};

/// In the lanes that are only copies.
const NOBODY: usize = usize::MAX;

/// Bodies of one kind: those without a mount first, then those that are turned in the world alone, then those
/// whose principal axes are turned in the body too.
#[derive(Debug, Clone)]
pub(super) struct Group<T, K, A> {
    /// Which body is in each lane of each block.
    bodies: Vec<usize>,
    /// What takes seconds to scaled time.
    clocks: Vec<T>,
    spins: Vec<K>,
    /// Empty if only spins are requested.
    attitudes: Vec<A>,
    /// For the last of the blocks.
    worlds: Vec<Quaternion<T>>,
    /// For the last of these, and conjugated: from body axes to principal ones.
    frames: Vec<Quaternion<T>>,
}

/// How a body's principal axes are mounted, as far as that matters.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Mounted {
    Not,
    InWorld,
    InBody,
}

impl Mounted {
    /// Where only spins are requested the world does not matter.
    fn of(mount: Option<&Mount>, attitudes: bool) -> Self {
        match mount {
            Some(mount) if mount.frame != Frame::SAME => Self::InBody,
            Some(_) if attitudes => Self::InWorld,
            _ => Self::Not,
        }
    }
}

impl<T: Lane, K: Kernel<T, Attitude = A>, A> Group<T, K, A> {
    /// Of the bodies for which `of` has constants.
    pub(super) fn new<'a, K1: 'a, A1: 'a>(
        motions: &'a [FreeMotion],
        attitudes: bool,
        of: impl Fn(&'a FreeMotion) -> Option<(&'a K1, &'a A1)>,
    ) -> Self
    where
        K: Gather<One = K1>,
        A: Gather<One = A1>,
    {
        let mut group = Self {
            bodies: Vec::new(),
            clocks: Vec::new(),
            spins: Vec::new(),
            attitudes: Vec::new(),
            worlds: Vec::new(),
            frames: Vec::new(),
        };
        for mounted in [Mounted::Not, Mounted::InWorld, Mounted::InBody] {
            let here = |motion: &FreeMotion| Mounted::of(motion.mount.as_ref(), attitudes) == mounted;
            let mut these = motions
                .iter()
                .enumerate()
                .filter(|(_, motion)| here(motion))
                .filter_map(|(body, motion)| Some((body, motion, of(motion)?)))
                .peekable();
            while these.peek().is_some() {
                let block: Vec<_> = these.by_ref().take(T::WIDTH).collect();
                group.bodies.extend(block.iter().map(|(body, ..)| *body));
                let full = group.bodies.len().next_multiple_of(T::WIDTH.max(1));
                group.bodies.resize(full, NOBODY);
                group.clocks.push(T::gather(&block, |(_, motion, _)| &motion.clock));
                group.spins.push(K::gather(&block, |(.., (spin, _))| *spin));
                if attitudes {
                    group.attitudes.push(A::gather(&block, |(.., (_, attitude))| *attitude));
                }
                let mounts: Vec<&Mount> =
                    block.iter().filter_map(|(_, motion, _)| motion.mount.as_ref()).collect();
                if attitudes && mounted != Mounted::Not {
                    group.worlds.push(quaternions(&mounts, |mount| *mount.world));
                }
                if mounted == Mounted::InBody {
                    group
                        .frames
                        .push(quaternions(&mounts, |mount| mount.frame.to_body().conjugate().into_inner()));
                }
            }
        }
        group.shrink();
        group
    }

    fn shrink(&mut self) {
        self.bodies.shrink_to_fit();
        self.clocks.shrink_to_fit();
        self.spins.shrink_to_fit();
        self.attitudes.shrink_to_fit();
        self.worlds.shrink_to_fit();
        self.frames.shrink_to_fit();
    }

    pub(super) fn bytes(&self) -> usize {
        self.bodies.len() * size_of::<usize>()
            + self.clocks.len() * size_of::<T>()
            + self.spins.len() * size_of::<K>()
            + self.attitudes.len() * size_of::<A>()
            + (self.worlds.len() + self.frames.len()) * size_of::<Quaternion<T>>()
    }

    /// What belongs to block `n` of those to whose last blocks it belongs.
    #[inline(always)]
    fn of_last<'a>(&self, n: usize, parts: &'a [Quaternion<T>]) -> Option<&'a Quaternion<T>> {
        n.checked_sub(self.spins.len() - parts.len()).and_then(|n| parts.get(n))
    }

    pub(super) fn each<W: Answer>(
        &self,
        times: &[f64],
        first: &impl Fn(usize) -> W,
        put: &mut impl FnMut(usize, usize, W),
    ) {
        let blocks = self.bodies.chunks_exact(T::WIDTH.max(1));
        for (n, ((bodies, &clock), spin)) in blocks.zip(&self.clocks).zip(&self.spins).enumerate() {
            let attitude = if W::ATTITUDE { self.attitudes.get(n) } else { None };
            let (world, frame) = (self.of_last(n, &self.worlds), self.of_last(n, &self.frames));
            for (k, &t) in times.iter().enumerate() {
                let time = clock * t;
                let phase = spin.phase(time);
                let omega = in_body(frame, spin.omega(&phase));
                let turn = attitude.map(|attitude| {
                    let turn = spin.turn(attitude, &phase, time);
                    world.map_or(turn, |world| in_world(world, frame, turn))
                });
                each_lane(bodies, time, |lane, body, starts| {
                    let here = || {
                        let turn = turn
                            .map_or(Quaternion::identity(), |turn| turn.coords.map(|x| x.lane(lane)).into());
                        let omega = omega.map(|x| x.lane(lane));
                        W::of(Instant { omega, attitude: UnitQuaternion::new_unchecked(turn) })
                    };
                    put(k, body, if starts { first(body) } else { here() });
                });
            }
        }
    }
}

/// Calls `put` for each lane with a body: with the lane, the body, and whether no time has passed for it at
/// all, where the start itself is the answer.
#[inline(always)]
fn each_lane<T: Lane>(bodies: &[usize], time: T, mut put: impl FnMut(usize, usize, bool)) {
    let any_starts = T::any(time.abs().lt(splat::<T>(f64::from_bits(1))));
    for (lane, &body) in bodies.iter().enumerate().filter(|(_, body)| **body != NOBODY) {
        put(lane, body, any_starts && time.lane(lane) == 0.0);
    }
}

fn quaternions<T: Lane>(mounts: &[&Mount], of: impl Fn(&Mount) -> Quaternion<f64>) -> Quaternion<T> {
    let coords: Vec<[f64; 4]> = mounts.iter().map(|mount| of(mount).coords.into()).collect();
    let [x, y, z, w] = Gather::gather(&coords, |coords| coords);
    Quaternion::new(w, x, y, z)
}
