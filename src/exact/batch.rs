//! Many free motions at once, bodies of the same kind of motion side by side.

use super::circulating::{Elliptic, Going, Lingering, LingeringTurn, Waving, WavingTurn};
use super::elementary::{Precession, Turn, Turns, Wobbles};
use super::{FreeMotion, Instant, Law, klein, real_first};
use crate::error::{Error, finite};
use crate::number::{Lane, gathered};
use alloc::vec::Vec;
use core::mem::size_of;
use nalgebra::{UnitQuaternion, Vector3};

/// Many bodies in free motion, prepared to be asked together: as many side by side as the number type has
/// [lanes](Lane).
///
/// Every answer is to the bit that of [`FreeMotion::at`], whatever other bodies there are and in whichever order: bodies are
/// sorted by their kind of motion, the same functions run on several numbers at once, and what is left over
/// of a kind is filled up with copies. A body on the separatrix itself, or whose spin is beyond 1e±180 rad/s, is asked
/// alone.
///
/// A batch of some hundred bodies fits a processor's second cache; of many more make several.
///
/// ```
/// use tumbling::{PrincipalMoments, exact::{Batch, FreeMotion}};
/// let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
/// let motions = [[0.0, 0.0, 5.0], [1.0, 2.0, 3.0], [0.0, 10.0, 0.001]]
///     .into_iter()
///     .map(|omega| FreeMotion::new(moments, &omega.into()))
///     .collect::<Result<Vec<_>, _>>()?;
/// // One lane here; several with a type that has them.
/// let batch = Batch::<f64>::new(&motions);
/// let times = [1.0, 1e6];
/// batch.each(&times, |time, body, instant| {
///     assert_eq!(Ok(instant), motions[body].at(times[time]));
/// })?;
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Batch<T> {
    kinds: Kinds<T>,
}

/// The spins alone of many bodies in free motion: what attitudes need is left out, from the memory and from the work.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::PrincipalMoments;
/// use tumbling::exact::{Batch, FreeMotion, Spins};
/// let motion = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 3.0)?, &Vector3::new(1.0, 2.0, 3.0))?;
/// let (spins, both) = (Spins::<f64>::new(&[motion; 100]), Batch::<f64>::new(&[motion; 100]));
/// assert!(spins.bytes() < both.bytes());
/// spins.each(&[0.5], |_, _, omega| assert_eq!(Ok(omega), motion.omega(0.5)))?;
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Spins<T> {
    kinds: Kinds<T>,
}

impl<T: Lane> Batch<T> {
    /// Of these motions.
    #[must_use]
    pub fn new(motions: &[FreeMotion]) -> Self {
        Self { kinds: Kinds::new(motions, true) }
    }

    /// How many bodies.
    #[must_use]
    pub fn len(&self) -> usize {
        self.kinds.starts.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The memory it holds, bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.kinds.bytes()
    }

    /// Spin and attitude of every body at each of `times`: `put` gets the index of the time, that of the body, and the
    /// answer, in no particular order.
    ///
    /// # Errors
    /// A time that is not finite, before any answer is put.
    pub fn each(&self, times: &[f64], mut put: impl FnMut(usize, usize, Instant)) -> Result<(), Error> {
        for &t in times {
            finite("the time", t)?;
        }
        let first = |body| self.kinds.first(body);
        self.kinds.waving.instants(times, &first, &mut put);
        self.kinds.lingering.instants(times, &first, &mut put);
        self.kinds.tops.instants(times, &first, &mut put);
        self.kinds.steady.instants(times, &first, &mut put);
        for (body, motion) in &self.kinds.alone {
            for (k, &t) in times.iter().enumerate() {
                put(k, *body, motion.at(t)?);
            }
        }
        Ok(())
    }
}

impl<T: Lane> Spins<T> {
    /// Of these motions.
    #[must_use]
    pub fn new(motions: &[FreeMotion]) -> Self {
        Self { kinds: Kinds::new(motions, false) }
    }

    /// How many bodies.
    #[must_use]
    pub fn len(&self) -> usize {
        self.kinds.starts.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The memory it holds, bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.kinds.bytes()
    }

    /// The spin of every body at each of `times`: `put` gets the index of the time, that of the body, and the spin in
    /// body axes, rad/s, in no particular order.
    ///
    /// # Errors
    /// A time that is not finite, before any answer is put.
    pub fn each(&self, times: &[f64], mut put: impl FnMut(usize, usize, Vector3<f64>)) -> Result<(), Error> {
        for &t in times {
            finite("the time", t)?;
        }
        let first = |body| self.kinds.first(body).omega;
        self.kinds.waving.spins(times, &first, &mut put);
        self.kinds.lingering.spins(times, &first, &mut put);
        self.kinds.tops.spins(times, &first, &mut put);
        self.kinds.steady.spins(times, &first, &mut put);
        for (body, motion) in &self.kinds.alone {
            for (k, &t) in times.iter().enumerate() {
                put(k, *body, motion.omega(t)?);
            }
        }
        Ok(())
    }
}

/// Bodies sorted by their kind of motion.
#[derive(Debug, Clone)]
struct Kinds<T> {
    waving: Group<T, Waving<T>, WavingTurn<T>>,
    lingering: Group<T, Lingering<T>, LingeringTurn<T>>,
    tops: Group<T, Wobbles<T>, Turns<T>>,
    steady: Group<T, Still<T>, Turns<T>>,
    alone: Vec<(usize, FreeMotion)>,
    /// As they were given.
    starts: Vec<Vector3<f64>>,
    /// Empty if all are the identity, or not asked for.
    attitudes: Vec<UnitQuaternion<f64>>,
}

/// What runs through the same functions side by side.
trait Abreast<T, Turn> {
    fn omega(&self, time: T) -> [T; 3];
    /// Spin and turn since the start, real part first.
    fn at(&self, turn: &Turn, time: T) -> ([T; 3], [T; 4]);
}

/// Spins that do not change.
#[derive(Debug, Clone, PartialEq)]
struct Still<T> {
    omega: [T; 3],
}

macro_rules! abreast {
    ($Spins:ident, $Turns:ident) => {
        impl<T: Lane> Abreast<T, $Turns<T>> for $Spins<T> {
            #[inline(always)]
            fn omega(&self, time: T) -> [T; 3] {
                $Spins::omega(self, time)
            }
            #[inline(always)]
            fn at(&self, turn: &$Turns<T>, time: T) -> ([T; 3], [T; 4]) {
                $Spins::at(self, turn, time)
            }
        }
    };
}
abreast!(Waving, WavingTurn);
abreast!(Lingering, LingeringTurn);

impl<T: Lane> Abreast<T, Turns<T>> for Wobbles<T> {
    #[inline(always)]
    fn omega(&self, time: T) -> [T; 3] {
        Wobbles::omega(self, time)
    }
    #[inline(always)]
    fn at(&self, turn: &Turns<T>, time: T) -> ([T; 3], [T; 4]) {
        (Wobbles::omega(self, time), self.turn(turn, time))
    }
}

impl<T: Lane> Abreast<T, Turns<T>> for Still<T> {
    #[inline(always)]
    fn omega(&self, _: T) -> [T; 3] {
        self.omega
    }
    #[inline(always)]
    fn at(&self, turn: &Turns<T>, time: T) -> ([T; 3], [T; 4]) {
        (self.omega, turn.at(time))
    }
}

/// How principal axes sit in the bodies, and the bodies in the world.
#[derive(Debug, Clone)]
struct Mounts<T> {
    frame: [T; 4],
    world: [T; 4],
    back: [T; 4],
}

impl<T: Lane> Mounts<T> {
    fn gathered(from: &[&FreeMotion]) -> Self {
        let of = |which: fn(&super::Mount) -> UnitQuaternion<f64>| {
            let part = |motion: &&FreeMotion, n: usize| {
                let mount = motion.mount.as_ref();
                real_first(&mount.map_or_else(UnitQuaternion::identity, which))[n]
            };
            [0, 1, 2, 3].map(|n| gathered(from, |motion| part(motion, n)))
        };
        Self {
            frame: of(|mount| mount.frame),
            world: of(|mount| mount.world),
            back: of(|mount| mount.frame.inverse()),
        }
    }
}

/// Bodies of one kind, in blocks as wide as there are lanes.
#[derive(Debug, Clone)]
struct Group<T, Spin, Turn> {
    /// Which body is in each lane of each block.
    bodies: Vec<usize>,
    /// What takes seconds to scaled time.
    clocks: Vec<T>,
    spins: Vec<Spin>,
    /// Empty if only spins are asked for.
    turns: Vec<Turn>,
    /// Empty if none is needed, otherwise for the last of the blocks: bodies without one come first.
    mounts: Vec<Mounts<T>>,
}

impl<T: Lane, Spin: Abreast<T, Turn>, Turn> Group<T, Spin, Turn> {
    /// Of the bodies for which `of` has something. `whole` if attitudes are wanted.
    fn new<'a, L>(
        motions: &'a [FreeMotion],
        whole: bool,
        of: impl Fn(&'a FreeMotion) -> Option<L>,
        gather: impl Fn(&[L]) -> (Spin, Turn),
    ) -> Self {
        let mut group = Self {
            bodies: Vec::new(),
            clocks: Vec::new(),
            spins: Vec::new(),
            turns: Vec::new(),
            mounts: Vec::new(),
        };
        let turned = |motion: &FreeMotion| match &motion.mount {
            None => false,
            Some(mount) => whole || mount.frame != UnitQuaternion::identity(),
        };
        for mounted in [false, true] {
            let of_these = |(body, motion): (usize, &'a FreeMotion)| {
                if turned(motion) == mounted { of(motion).map(|law| (body, motion, law)) } else { None }
            };
            let mut these = motions.iter().enumerate().filter_map(of_these).peekable();
            while these.peek().is_some() {
                let (mut block, mut laws) = (Vec::new(), Vec::new());
                for (body, motion, law) in these.by_ref().take(T::WIDTH) {
                    group.bodies.push(body);
                    block.push(motion);
                    laws.push(law);
                }
                let filler = group.bodies.len().next_multiple_of(T::WIDTH.max(1));
                group.bodies.resize(filler, NOBODY);
                group.clocks.push(gathered(&block, |motion| motion.clock));
                let (spin, turn) = gather(&laws);
                group.spins.push(spin);
                if whole {
                    group.turns.push(turn);
                }
                if mounted {
                    group.mounts.push(Mounts::gathered(&block));
                }
            }
        }
        group.bodies.shrink_to_fit();
        group.clocks.shrink_to_fit();
        group.spins.shrink_to_fit();
        group.turns.shrink_to_fit();
        group.mounts.shrink_to_fit();
        group
    }

    fn bytes(&self) -> usize {
        self.bodies.len() * size_of::<usize>()
            + self.clocks.len() * size_of::<T>()
            + self.spins.len() * size_of::<Spin>()
            + self.turns.len() * size_of::<Turn>()
            + self.mounts.len() * size_of::<Mounts<T>>()
    }

    /// The mounts of a block, if it has any.
    #[inline(always)]
    fn mounts(&self, block: usize) -> Option<&Mounts<T>> {
        let without = self.spins.len() - self.mounts.len();
        block.checked_sub(without).and_then(|n| self.mounts.get(n))
    }

    fn spins(
        &self,
        times: &[f64],
        first: &impl Fn(usize) -> Vector3<f64>,
        put: &mut impl FnMut(usize, usize, Vector3<f64>),
    ) {
        let blocks = self.bodies.chunks_exact(T::WIDTH.max(1));
        for (n, ((bodies, &clock), spin)) in blocks.zip(&self.clocks).zip(&self.spins).enumerate() {
            let mounts = self.mounts(n);
            for (k, &t) in times.iter().enumerate() {
                let time = clock * t;
                let mut omega = spin.omega(time);
                if let Some(mounts) = mounts {
                    omega = klein::rotated(mounts.frame, omega);
                }
                let standing = T::any(stands(time));
                for (lane, &body) in bodies.iter().enumerate().filter(|(_, body)| **body != NOBODY) {
                    if standing && time.lane(lane) == 0.0 {
                        put(k, body, first(body));
                        continue;
                    }
                    put(k, body, Vector3::from(omega.map(|x| x.lane(lane))));
                }
            }
        }
    }

    fn instants(
        &self,
        times: &[f64],
        first: &impl Fn(usize) -> Instant,
        put: &mut impl FnMut(usize, usize, Instant),
    ) {
        let blocks = self.bodies.chunks_exact(T::WIDTH.max(1));
        let parts = blocks.zip(&self.clocks).zip(&self.spins).zip(&self.turns);
        for (n, (((bodies, &clock), spin), turn)) in parts.enumerate() {
            let mounts = self.mounts(n);
            for (k, &t) in times.iter().enumerate() {
                let time = clock * t;
                let (mut omega, mut attitude) = spin.at(turn, time);
                if let Some(mounts) = mounts {
                    omega = klein::rotated(mounts.frame, omega);
                    let whole = klein::product(klein::product(mounts.world, attitude), mounts.back);
                    attitude = klein::unit(whole);
                }
                let standing = T::any(stands(time));
                for (lane, &body) in bodies.iter().enumerate().filter(|(_, body)| **body != NOBODY) {
                    if standing && time.lane(lane) == 0.0 {
                        put(k, body, first(body));
                        continue;
                    }
                    let omega = Vector3::from(omega.map(|x| x.lane(lane)));
                    let attitude = klein::quaternion(attitude.map(|x| x.lane(lane)));
                    put(k, body, Instant { omega, attitude: UnitQuaternion::new_unchecked(attitude) });
                }
            }
        }
    }
}

/// In the lanes that are only copies.
const NOBODY: usize = usize::MAX;

/// Where no time has passed at all: there the start itself is the answer.
#[inline(always)]
fn stands<T: Lane>(time: T) -> T::Mask {
    time.abs().lt(T::splat(f64::from_bits(1)))
}

impl<T: Lane> Kinds<T> {
    fn new(motions: &[FreeMotion], whole: bool) -> Self {
        fn elliptic(motion: &FreeMotion) -> Option<&Elliptic> {
            if let Law::Elliptic(elliptic) = &motion.law { Some(elliptic) } else { None }
        }
        let waving = |motion| match elliptic(motion).map(Elliptic::going) {
            Some(Going::Waving(elliptic)) => Some(elliptic),
            _ => None,
        };
        let lingering = |motion| match elliptic(motion).map(Elliptic::going) {
            Some(Going::Lingering(elliptic)) => Some(elliptic),
            _ => None,
        };
        let top = |motion: &FreeMotion| match motion.law {
            Law::Symmetric(top) => Some(top),
            _ => None,
        };
        let steady = |motion: &FreeMotion| match motion.law {
            Law::AtRest => Some((motion.start, None)),
            Law::Steady(turn) => Some((motion.start, Some(turn))),
            _ => None,
        };
        let alone = |(body, motion): (usize, &FreeMotion)| match elliptic(motion).map(Elliptic::going) {
            Some(Going::Alone) => Some((body, *motion)),
            _ => None,
        };
        let identity = UnitQuaternion::identity();
        let mut attitudes = Vec::new();
        if whole && motions.iter().any(|motion| motion.first().attitude != identity) {
            attitudes.extend(motions.iter().map(|motion| motion.first().attitude));
        }
        Self {
            waving: Group::new(motions, whole, waving, Waving::gathered),
            lingering: Group::new(motions, whole, lingering, Lingering::gathered),
            tops: Group::new(motions, whole, top, |tops: &[Precession]| {
                (Wobbles::gathered(tops, |top| top), Turns::gathered(tops, |top| Some(top.about_momentum())))
            }),
            steady: Group::new(motions, whole, steady, |steady: &[(Vector3<f64>, Option<Turn>)]| {
                let omega = [0, 1, 2].map(|n| gathered(steady, |(omega, _)| omega[n]));
                (Still { omega }, Turns::gathered(steady, |(_, turn)| *turn))
            }),
            alone: motions.iter().enumerate().filter_map(alone).collect(),
            starts: motions.iter().map(|motion| motion.first().omega).collect(),
            attitudes,
        }
    }

    fn bytes(&self) -> usize {
        self.waving.bytes()
            + self.lingering.bytes()
            + self.tops.bytes()
            + self.steady.bytes()
            + self.alone.len() * size_of::<(usize, FreeMotion)>()
            + self.starts.len() * size_of::<Vector3<f64>>()
            + self.attitudes.len() * size_of::<UnitQuaternion<f64>>()
    }

    fn first(&self, body: usize) -> Instant {
        Instant {
            omega: self.starts.get(body).copied().unwrap_or_default(),
            attitude: self.attitudes.get(body).copied().unwrap_or_else(UnitQuaternion::identity),
        }
    }
}
