//! Bodies of one kind of motion, in blocks as wide as there are lanes.

use super::Answer;
use crate::attitude::product;
use crate::exact::elementary::Kernel;
use crate::exact::elliptic::Angle;
use crate::exact::{FreeMotion, Instant};
use crate::inertia::Frame;
use crate::number::{DoubleDouble, Gather, Rounding, splat};
use alloc::vec::Vec;
use core::mem::replace;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// The number of times for which a block is computed in one go: a power of two.
const SPAN: usize = 16;

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

    // In short loops, so that a processor works on several instants at once: it sees only some hundred
    // instructions ahead. Each loop takes two steps, the second of them for the instant before. Closures as
    // large as this work are not inlined, and so not compiled for the vectors of a caller that has them.
    #[inline(always)]
    pub(super) fn each<W: Answer>(
        &self,
        times: &[f64],
        starts: &[Instant],
        put: &mut impl FnMut(usize, usize, W),
    ) {
        let Some((mut reduced, phase)) = self.spins.first().map(at_zero) else { return };
        // Not zero, where the start would be the answer.
        let (zero, mut at) = (T::zero(), [1.0; SPAN]);
        let (mut phases, mut sines) = ([phase; SPAN], [(zero, zero); SPAN]);
        let (mut omegas, mut turns) = ([[zero; 3]; SPAN], [[zero; 4]; SPAN]);
        let nearest = times.iter().fold(f64::INFINITY, |least, t| least.min(t.abs()));
        let blocks = self.bodies.chunks_exact(T::WIDTH.max(1));
        for (n, ((bodies, &clock), spin)) in blocks.zip(&self.clocks).zip(&self.spins).enumerate() {
            let attitude = self.attitudes.get(n).filter(|_| W::ATTITUDE);
            for (span, times) in times.chunks(SPAN).enumerate() {
                at.iter_mut().zip(times).for_each(|(at, &t)| *at = t);
                for (here, before) in steps(times.len()) {
                    phases[before] = spin.phase(&replace(&mut reduced, spin.reduced(clock * at[here])));
                }
                for (here, _) in steps(times.len() - 1) {
                    omegas[here] = spin.omega(&phases[here]).into();
                }
                if let Some(attitude) = attitude {
                    let mut angle = Angle::of_turns(DoubleDouble::new(zero, zero));
                    for (here, before) in steps(times.len()) {
                        let next = spin.drift(attitude, &phases[here], clock * at[here]);
                        sines[before] = replace(&mut angle, next).sin_cos();
                    }
                    let mut parts = [zero; 4];
                    for (here, before) in steps(times.len()) {
                        let next = spin.parts(attitude, &phases[here], sines[here]);
                        turns[before] = spin.turn_of(replace(&mut parts, next)).coords.into();
                    }
                }
                self.mounted(n, &mut omegas[..times.len()], &mut turns[..times.len()]);
                if T::any((clock * nearest).abs().lt(splat(f64::from_bits(1)))) {
                    for (k, &t) in times.iter().enumerate() {
                        start(clock * t, &mut omegas[k], bodies, starts, |of| of.omega.into());
                        start(clock * t, &mut turns[k], bodies, starts, |of| of.attitude.coords.into());
                    }
                }
                for k in 0..times.len() {
                    for (lane, &body) in bodies.iter().enumerate().filter(|(_, body)| **body != NOBODY) {
                        let ([x, y, z], [i, j, l, w]) = (&omegas[k % SPAN], &turns[k % SPAN]);
                        let omega = Vector3::new(x.lane(lane), y.lane(lane), z.lane(lane));
                        let turn = Quaternion::new(w.lane(lane), i.lane(lane), j.lane(lane), l.lane(lane));
                        let attitude = UnitQuaternion::new_unchecked(turn);
                        put(span * SPAN + k, body, W::of(Instant { omega, attitude }));
                    }
                }
            }
        }
    }

    /// Takes spins and turns along the principal axes of block `n` to the body's axes and the world's.
    #[inline(always)]
    fn mounted(&self, n: usize, omegas: &mut [[T; 3]], turns: &mut [[T; 4]]) {
        let frame = self.of_last(n, &self.frames);
        if let Some(frame) = &frame {
            for omega in omegas {
                *omega = frame.in_body((*omega).into()).into();
            }
        }
        if let Some(world) = self.of_last(n, &self.worlds) {
            for turn in turns {
                let turned = product(&world, &Quaternion::from_vector((*turn).into()));
                *turn = frame.unwrap_or(Frame::BODY).attitude_of_body(turned).coords.into();
            }
        }
    }
}

/// The places of this number of instants and of the instant before each, and once more, for that before.
// An instant before the first is computed too, of whatever numbers, and not used.
#[inline(always)]
fn steps(count: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=count).map(|k| (k % SPAN, (k + SPAN - 1) % SPAN))
}

/// Values of the types for the first block, which the loop replaces before they are used.
#[inline(never)]
fn at_zero<T: Rounding, K: Kernel<T>>(spin: &K) -> (K::Reduced, K::Phase) {
    let reduced = spin.reduced(T::zero());
    (reduced, spin.phase(&reduced))
}

/// The start itself, in the lanes where the time is zero.
#[cold]
#[inline(never)]
fn start<T: Rounding, const N: usize>(
    time: T,
    parts: &mut [T; N],
    bodies: &[usize],
    starts: &[Instant],
    of: impl Fn(&Instant) -> [f64; N],
) {
    let start = |lane: usize| starts.get(*bodies.get(lane)?).filter(|_| time.lane(lane) == 0.0).map(&of);
    for (k, part) in parts.iter_mut().enumerate() {
        *part = T::from_lanes(|lane| start(lane).map_or(part.lane(lane), |start| start[k]));
    }
}
