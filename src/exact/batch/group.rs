//! Bodies of one kind of motion, in blocks as wide as there are lanes.

use super::Answer;
use crate::attitude::product;
use crate::exact::elementary::Kernel;
use crate::exact::{FreeMotion, Instant};
use crate::inertia::Frame;
use crate::number::{Gather, Rounding, splat};
use alloc::vec::Vec;
use nalgebra::{Quaternion, UnitQuaternion};

/// Marks the lanes that are only copies.
const NOBODY: usize = usize::MAX;

/// Bodies of one kind: first the bodies without a mount, then the bodies turned only in the world, then the
/// bodies whose principal axes are turned in the body too.
#[derive(Debug, Clone)]
pub(super) struct Group<T, K, A> {
    /// Which body is in each lane of each block.
    bodies: Vec<usize>,
    /// The factor from seconds to scaled time.
    clocks: Vec<T>,
    spins: Vec<K>,
    /// Empty if only spins are requested.
    attitudes: Vec<A>,
    /// For the last of the blocks.
    worlds: Vec<Quaternion<T>>,
    /// For the last of these.
    frames: Vec<Frame<T>>,
}

impl<T: Rounding, K: Kernel<T, Attitude = A>, A> Group<T, K, A> {
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
        // Where only spins are requested the attitude at the start does not matter.
        let turns = |motion: &FreeMotion| match &motion.mount {
            Some(mount) if !mount.frame.is_body() => 2,
            Some(_) if attitudes => 1,
            _ => 0,
        };
        for turned in 0..3 {
            let these: Vec<_> = motions
                .iter()
                .enumerate()
                .filter(|(_, motion)| turns(motion) == turned)
                .filter_map(|(body, motion)| Some((body, motion, of(motion)?)))
                .collect();
            for block in these.chunks(T::WIDTH.max(1)) {
                group.bodies.extend(block.iter().map(|(body, ..)| *body));
                let full = group.bodies.len().next_multiple_of(T::WIDTH.max(1));
                group.bodies.resize(full, NOBODY);
                group.clocks.push(T::gather(block, |(_, motion, _)| &motion.clock));
                group.spins.push(K::gather(block, |(.., (spin, _))| *spin));
                if attitudes {
                    group.attitudes.push(A::gather(block, |(.., (_, attitude))| *attitude));
                }
                let mounts: Vec<_> =
                    block.iter().filter_map(|(_, motion, _)| motion.mount.as_ref()).collect();
                if attitudes && turned > 0 {
                    group.worlds.push(Quaternion::gather(&mounts, |mount| mount.world.quaternion()));
                }
                if turned == 2 {
                    group.frames.push(Frame::of_lanes(mounts.iter().map(|mount| &mount.frame)));
                }
            }
        }
        group
    }

    /// What belongs to block `n` of those to whose last blocks it belongs.
    #[inline(always)]
    fn of_last<P: Copy>(&self, n: usize, parts: &[P]) -> Option<P> {
        n.checked_sub(self.spins.len() - parts.len()).and_then(|n| parts.get(n)).copied()
    }

    #[inline(always)]
    pub(super) fn each<W: Answer>(
        &self,
        times: &[f64],
        first: &impl Fn(usize) -> W,
        put: &mut impl FnMut(usize, usize, W),
    ) {
        let blocks = self.bodies.chunks_exact(T::WIDTH.max(1));
        for (n, ((bodies, &clock), spin)) in blocks.zip(&self.clocks).zip(&self.spins).enumerate() {
            let attitude = if W::ATTITUDE { self.attitudes.get(n) } else { None };
            let world = self.of_last(n, &self.worlds);
            let frame = self.of_last(n, &self.frames).unwrap_or(Frame::BODY);
            for (k, &t) in times.iter().enumerate() {
                let time = clock * t;
                let phase = spin.phase(time);
                let omega = frame.in_body(spin.omega(&phase));
                // Closures as large as this work are not inlined, and so not compiled for the vectors of a
                // caller that has them.
                let mut turn = Quaternion::new(T::one(), T::zero(), T::zero(), T::zero());
                if let Some(attitude) = attitude {
                    turn = spin.turn(attitude, &phase, time);
                    if let Some(world) = world {
                        turn = frame.attitude_of_body(product(&world, &turn));
                    }
                }
                // At time zero the start itself is the answer.
                let any_starts = T::any(time.abs().lt(splat::<T>(f64::from_bits(1))));
                for (lane, &body) in bodies.iter().enumerate() {
                    let starts = any_starts && time.lane(lane) == 0.0;
                    let attitude = UnitQuaternion::new_unchecked(turn.coords.map(|x| x.lane(lane)).into());
                    let here = Instant { omega: omega.map(|x| x.lane(lane)), attitude };
                    if body != NOBODY {
                        put(k, body, if starts { first(body) } else { W::of(here) });
                    }
                }
            }
        }
    }
}
