//! Finds the meaning of a file's numbers: distinguishes mistakes in the file from mistakes of the engine.
//!
//! The spin determines the turn from one row to the next. If they disagree, but would agree if the numbers
//! were read another way, the mistake is in the file.

use crate::read::pace::{by_how_much, in_whole_numbers, to_four_places};
use crate::read::{Kind, Pair, Raw, Row, angle_between, median};
use crate::thresholds::*;
use nalgebra::{Quaternion, Vector3};
use std::f64::consts::{PI, TAU};
use tumbling::{attitude, dynamics::euler};

/// The words of each mistake without a number: what is wrong, and what to do.
macro_rules! mistakes {
    ($($(#[$meta:meta])* $name:ident: $words:literal;)+) => {
        /// A mistake in a file: its numbers do not have the meaning that its names give.
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[non_exhaustive]
        pub enum FileMistake {
            $($(#[$meta])* $name,)+
            /// The times are too short by this factor (below one: too long), or the spins too small by it:
            /// from row to row, attitude and spin both change this factor times as much as they say.
            Times(f64),
            /// One component of the spin has the wrong sign: 0, 1 or 2.
            MirroredComponent(usize),
        }

        impl FileMistake {
            /// What is wrong, and what to do.
            #[must_use]
            pub fn words(self) -> String {
                match self {
                    $(Self::$name => $words.into(),)+
                    Self::Times(times) => wrong_times(times),
                    Self::MirroredComponent(i) => {
                        let axis = ["x", "y", "z"][i.min(2)];
                        format!("the {axis} component of the spin has the wrong sign (left-handed axes?)")
                    }
                }
            }
        }
    };
}

mistakes! {
    /// What is named in body axes is in the world's, or the other way round.
    Frame: "the vector is not in the axes that its names give: world axes instead of body axes, or the reverse. In a file, name the \
         columns `wxw,wyw,wzw` for world axes, `wx,wy,wz` for body axes; in a program, set the frame";
    /// The attitude is x, y, z, w; of attitudes alone this cannot be distinguished from
    /// [`ScalarFirst`](Self::ScalarFirst).
    Order: "the quaternion is x, y, z, w under the names w, x, y, z: put the names in the order of the numbers";
    /// The attitude is w, x, y, z under the names x, y, z, w.
    ScalarFirst: "the quaternion is w, x, y, z under the names x, y, z, w: put the names in the order of the numbers";
    /// The attitude takes the world to the body.
    Inverse: "the attitude is the inverse one, world to body: write its conjugate, (w, -x, -y, -z)";
    /// What is named a spin is the momentum.
    Momentum: "the columns named as a spin hold the momentum: in a file, name them `lx,ly,lz` in body axes, `lxw,lyw,lzw` in world axes";
    /// Spins are in degrees a second.
    Degrees: "the spin is in degrees a second: write radians, or name the unit in a file, as in `wx [deg/s]`";
    /// Spins are in revolutions a minute.
    RevolutionsPerMinute: "the spin is in revolutions a minute: write radians a second";
    /// Spins are in revolutions a second.
    Revolutions: "the spin is in revolutions a second: write radians a second";
    /// Time is in milliseconds.
    Milliseconds: "the time is in milliseconds: write seconds";
    /// Time is in microseconds.
    Microseconds: "the time is in microseconds: write seconds";
    /// Time is in nanoseconds.
    Nanoseconds: "the time is in nanoseconds: write seconds";
    /// Time is in minutes.
    Minutes: "the time is in minutes: write seconds";
    /// The spin follows the left-hand rule, the attitude (if there is one) the right-hand rule.
    LeftHandedSpin: "the spin follows the left-hand rule (left-handed axes): write it with the opposite sign";
    /// All of it is mirrored along an axis.
    LeftHanded: "the axes are left-handed: one component of attitude and spin is mirrored. Give that component the opposite \
         sign in both";
}

fn wrong_times(times: f64) -> String {
    let (size, [way, small]) = by_how_much(times);
    let times = to_four_places(times);
    format!(
        "the times are {size} times too {way}: from row to row the attitude turns, and the spin changes, {times} times as far \
         as they say. Look for missing rows, a step taken more than once, or another step than the one given (spins written \
         {size} times too {small} would look the same)"
    )
}

/// Units of spins, in rad/s, and of time, in s, that are taken for these.
const SPINS: [(FileMistake, f64); 3] = [
    (FileMistake::Degrees, PI / 180.0),
    (FileMistake::RevolutionsPerMinute, PI / 30.0),
    (FileMistake::Revolutions, TAU),
];
const TIMES: [(FileMistake, f64); 4] = [
    (FileMistake::Milliseconds, 1e-3),
    (FileMistake::Microseconds, 1e-6),
    (FileMistake::Nanoseconds, 1e-9),
    (FileMistake::Minutes, 60.0),
];

/// A row, the one after it, and the step between them as the file has it.
pub(super) type Step = (Raw, Raw, f64);

/// A way to read the numbers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Reading {
    kind: Kind,
    order: Order,
    inverse: bool,
    frame: bool,
    /// A momentum under the names of a spin.
    momentum: bool,
    hand: Hand,
    /// What a spin is to be multiplied by, and a time.
    spin: f64,
    pub(super) time: f64,
}

/// Where the scalar of a quaternion stands.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
enum Order {
    #[default]
    AsNamed,
    Last,
    First,
}

#[derive(Debug, Clone, Copy, PartialEq, Default)]
enum Hand {
    #[default]
    Right,
    Left,
    One(usize),
}

impl Reading {
    /// As the names say.
    pub(crate) fn plain(kind: Kind) -> Self {
        Self { kind, spin: 1.0, time: 1.0, ..Self::default() }
    }

    /// The mistakes that it assumes.
    pub(crate) fn mistakes(&self) -> Vec<FileMistake> {
        let orders = [(Order::Last, FileMistake::Order), (Order::First, FileMistake::ScalarFirst)];
        let mut all: Vec<_> = orders.iter().filter(|of| of.0 == self.order).map(|of| of.1).collect();
        let mirrored = self.inverse && self.hand == Hand::Left;
        all.extend((self.inverse && !mirrored).then_some(FileMistake::Inverse));
        all.extend(match self.hand {
            Hand::Right => None,
            Hand::Left if mirrored => Some(FileMistake::LeftHanded),
            Hand::Left => Some(FileMistake::LeftHandedSpin),
            Hand::One(i) => Some(FileMistake::MirroredComponent(i)),
        });
        all.extend(self.frame.then_some(FileMistake::Frame));
        all.extend(self.momentum.then_some(FileMistake::Momentum));
        all.extend(SPINS.iter().filter(|unit| unit.1 == self.spin).map(|unit| unit.0));
        let unit = TIMES.iter().find(|unit| unit.1 == self.time).map(|unit| unit.0);
        all.extend(unit.or((self.time != 1.0).then_some(FileMistake::Times(self.time))));
        all
    }

    /// A row, read so.
    pub(crate) fn state(&self, raw: &Raw, moments: &Vector3<f64>) -> Row {
        let attitude = raw.attitude.map(|q| {
            let q = match self.order {
                Order::AsNamed => q,
                Order::Last => Quaternion::new(q.k, q.w, q.i, q.j),
                Order::First => Quaternion::new(q.i, q.j, q.k, q.w),
            };
            if self.inverse { q.conjugate() } else { q }
        });
        let mut vector = raw.vector * if self.hand == Hand::Left { -self.spin } else { self.spin };
        if let Hand::One(i) = self.hand {
            vector[i] = -vector[i];
        }
        let momentum = self.kind.is_momentum() || self.momentum;
        let omega =
            Raw { attitude, vector, ..*raw }.omega(self.kind.in_world() != self.frame, momentum, moments);
        Row { line: raw.line, t: raw.t * self.time, attitude, omega, ahead: None }
    }

    /// The way of reading under which `pairs` (rows, and the step as the file has it) are consistent, if the
    /// plain one is not.
    pub(crate) fn of(kind: Kind, free: bool, pairs: &[Step], moments: &Vector3<f64>) -> Self {
        let plain = Self::plain(kind);
        let with_attitude = pairs.first().is_some_and(|pair| pair.0.attitude.is_some());
        if with_attitude { plain.by_turns(free, pairs, moments) } else { plain.by_law(pairs, moments) }
    }

    /// For attitudes alone Euler's equations determine the order and the sense: three successive rows give
    /// two turns, whose difference is the gyroscopic change.
    pub(crate) fn of_attitudes(triples: &[([Raw; 3], f64)], moments: &Vector3<f64>) -> Self {
        let plain = Self::plain(Kind::Attitude);
        let alike = |reading: &Self| {
            let pairs = triples.iter().filter_map(|&(triple, h)| {
                let [a, b, c] = triple.map(|raw| reading.state(&raw, moments));
                let spin = |from: Row, to: Row| Some(Pair { from, to, h }.turn()? / h);
                let (first, second) = (spin(a, b)?, spin(b, c)?);
                Some(Pair { from: Row { omega: first, ..a }, to: Row { omega: second, ..b }, h })
            });
            law(&pairs.collect::<Vec<_>>(), moments).0
        };
        if alike(&plain) > LAW_AGREES {
            return plain;
        }
        let orders = [Order::AsNamed, Order::Last, Order::First];
        let others = [false, true].into_iter().flat_map(|inverse| orders.map(|order| (order, inverse)));
        let best = others
            .skip(1)
            .map(|(order, inverse)| Self { order, inverse, ..plain })
            .map(|way| (way, alike(&way)))
            // Which end the scalar is at shows a mirror image of the motion, which is a motion too: the
            // commoner one is named.
            .reduce(|best, way| if way.1 > best.1 + LAW_BETTER { way } else { best });
        best.filter(|way| way.1 > LAW_DECIDES).map_or(plain, |way| way.0)
    }

    pub(super) fn pairs(&self, all: &[Step], moments: &Vector3<f64>) -> Vec<Pair> {
        let state = |raw| self.state(raw, moments);
        all.iter().map(|(from, to, h)| Pair { from: state(from), to: state(to), h: h * self.time }).collect()
    }

    fn by_turns(self, free: bool, pairs: &[Step], moments: &Vector3<f64>) -> Self {
        let off = |reading: &Self| middle(&reading.pairs(pairs, moments));
        let plain = off(&self);
        if plain < TURNS_AGREE || plain.is_infinite() && self.leads_to_the_ends(pairs, moments) {
            return self;
        }
        if let Some(paced) = self.paced(pairs, moments).filter(|_| free) {
            return paced;
        }
        let mut ways = Vec::new();
        for order in [Order::AsNamed, Order::Last, Order::First] {
            for (inverse, frame) in [(false, false), (false, true), (true, false), (true, true)] {
                for hand in [Hand::Right, Hand::Left, Hand::One(0), Hand::One(1), Hand::One(2)] {
                    let turned = Self { order, inverse, frame, hand, ..self };
                    let way = turned.scaled(pairs, moments);
                    ways.push((way, off(&way)));
                    if hand == Hand::Right && matches!(self.kind, Kind::SpinBody | Kind::SpinWorld) {
                        let way = Self { momentum: true, ..turned };
                        ways.push((way, off(&way)));
                    }
                }
            }
        }
        let least = ways.iter().map(|way| way.1).fold(f64::INFINITY, f64::min);
        if least > TURNS_AGREE || least > NEARER_READING * plain {
            return self;
        }
        // Some ways turn alike: the fewest mistakes, and the law, decide between them.
        // How far the turns are from the spins weighs too, but less: what is left of a right reading is the
        // step's own error, and of a wrong one, of a spin about one axis, it may by chance be less.
        let worth = |(way, off): &(Self, f64)| {
            let weight = |mistake: FileMistake| match mistake {
                FileMistake::MirroredComponent(_) => RARE_MISTAKE[1],
                // The rarer of two that may look alike.
                FileMistake::ScalarFirst | FileMistake::Momentum => RARE_MISTAKE[0],
                _ => 1.0,
            };
            let mistakes: f64 = way.mistakes().into_iter().map(weight).sum();
            let (alike, _) = law(&way.pairs(pairs, moments), moments);
            mistakes - LAW_WEIGHT * alike + TURNS_WEIGHT * (off / least.max(TURNS_EQUAL)).max(1.0).log10()
        };
        let near = ways.iter().filter(|way| way.1 <= TURNS_AGREE && way.1 <= NEARER_READING * plain);
        let best = near.min_by(|a, b| worth(a).total_cmp(&worth(b))).map_or(self, |way| way.0);
        let asides = self.pairs(pairs, moments).into_iter().map(|pair| pair.aside(self.kind.in_world()));
        let off_side = middle(&asides.collect::<Vec<_>>());
        let on_other_side = off_side < TURNS_AGREE
            && (off_side < NEARER_READING * off(&best) || self.goes_by_law_unlike(&best, pairs, moments));
        // A turn about the spin's own axis is no momentum's, however far it goes.
        let across = median(&mut self.pairs(pairs, moments).iter().filter_map(Pair::across));
        let is_own = best.momentum && across < off(&best);
        if free && on_other_side || is_own { self } else { best }
    }

    /// Whether the spins lead to the attitudes, where turns are too long to be compared with them.
    fn leads_to_the_ends(self, pairs: &[Step], moments: &Vector3<f64>) -> bool {
        let all = self.pairs(pairs, moments);
        let mut off = all.iter().filter_map(|Pair { from, to, h }| {
            let turn = attitude::turn(&((from.omega + to.omega) * (h / 2.0)));
            Some(angle_between(&attitude::product(&from.attitude?, &turn), &to.attitude?))
        });
        median(&mut off) < TURNS_AGREE
    }

    /// With the units that make turns and spins alike in size.
    fn scaled(self, pairs: &[Step], moments: &Vector3<f64>) -> Self {
        let ratio = median(&mut self.pairs(pairs, moments).iter().filter_map(|pair| {
            let speed = pair.from.omega.norm();
            if speed > 0.0 { Some(pair.turn()?.norm() / pair.h / speed) } else { None }
        }));
        self.with_units(ratio)
    }

    pub(super) fn with_units(self, ratio: f64) -> Self {
        let off = |(spin, time): &(f64, f64)| (ratio / (spin * time) - 1.0).abs();
        // Six times too long is not far from revolutions for radians.
        let apart = UNIT_APART.min((ratio / in_whole_numbers(ratio) - 1.0).abs());
        let near = |units: &(f64, f64)| off(units) < apart;
        let [spins, times] = [SPINS.iter(), TIMES.iter()].map(|units| units.map(|unit| unit.1));
        let one = spins.clone().map(|spin| (spin, 1.0)).chain(times.clone().map(|time| (1.0, time)));
        // Spin and time may each be in a unit of its own: turns determine their product alone.
        let both = spins.flat_map(|spin| times.clone().map(move |time| (spin, time)));
        // Degrees a minute are nearly radians a second.
        let both = both.filter(|(spin, time)| (spin * time - 1.0).abs() > PACE_APART);
        let nearest = || both.min_by(|a, b| off(a).total_cmp(&off(b))).filter(near);
        let found = std::iter::once((1.0, 1.0)).chain(one).find(near).or_else(nearest);
        found.map_or(self, |(spin, time)| Self { spin, time, ..self })
    }

    /// Without an attitude, Euler's equations alone decide: a spin in another unit changes too fast or too
    /// slowly, and one of the other hand in reverse.
    fn by_law(self, pairs: &[Step], moments: &Vector3<f64>) -> Self {
        let (alike, size) = law(&self.pairs(pairs, moments), moments);
        if alike.abs() < LAW_DECIDES {
            return self;
        }
        let hand = if alike < 0.0 { Hand::Left } else { Hand::Right };
        let way = Self { hand, ..self }.with_units(size.abs());
        // Two units have many products, and a wrong term may be near one: theirs is met to a step's error.
        let turn = median(&mut way.pairs(pairs, moments).iter().map(|pair| pair.from.omega.norm() * pair.h));
        let off = (size.abs() / (way.spin * way.time) - 1.0).abs();
        let both = way.spin != 1.0 && way.time != 1.0 && off > FRACTION_NEAR + turn * turn;
        if both { Self { hand, ..self } } else { way }
    }
}

/// The median difference between the turns and the spins.
fn middle(pairs: &[Pair]) -> f64 {
    median(&mut pairs.iter().filter_map(Pair::inconsistency))
}

/// How much the change of the spin is like the gyroscopic one (the cosine between the two), and how large
/// beside it.
pub(crate) fn law(pairs: &[Pair], moments: &Vector3<f64>) -> (f64, f64) {
    alike(&mut pairs.iter().map(|pair| {
        let mean = (pair.from.omega + pair.to.omega) / 2.0;
        let law = euler::angular_acceleration(moments, &mean, &Vector3::zeros());
        ((pair.to.omega - pair.from.omega) / pair.h, law)
    }))
}

/// The cosine between vectors that are found and those wanted, all together, and how large they are in these.
pub(super) fn alike(vectors: &mut dyn Iterator<Item = (Vector3<f64>, Vector3<f64>)>) -> (f64, f64) {
    let (mut found, mut wanted, mut both) = (0.0, 0.0, 0.0);
    for (seen, own) in vectors {
        found += seen.norm_squared();
        wanted += own.norm_squared();
        both += seen.dot(&own);
    }
    let sizes = (found * wanted).sqrt();
    if sizes > 0.0 && sizes.is_finite() { (both / sizes, both / wanted) } else { (0.0, 1.0) }
}
