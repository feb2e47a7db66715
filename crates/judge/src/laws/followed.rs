//! The laws of free motion, each compared with the rows as they come.

use crate::law::LawName;
use crate::laws::{Curve, FlipCount, Law, Point, Stretches, line};
use crate::read::{Floor, Pair, Row, in_world, ordered};
use crate::thresholds::*;
use nalgebra::Vector3;
use std::f64::consts::TAU;
use tumbling::Axis;
use tumbling::dynamics::{euler, observe};
use tumbling::exact::{FreeMotion, Regime};

/// Everything that is followed from row to row.
pub(crate) struct Laws {
    moments: Vector3<f64>,
    start: Start,
    pub exact: FreeMotion,
    middle: Option<usize>,
    /// The axis the spin circles, and the two others in right-handed order.
    circled: Option<[usize; 3]>,
    curves: [(LawName, Curve); 7],
    pub points: Stretches<Point>,
    /// How far the spin is ahead of the exact one, rad.
    lag: f64,
    flips: Flips,
    pub seen: Seen,
    floor: Floor,
}

/// What the laws are compared with: the first row, and what it has of each.
struct Start {
    row: Row,
    energy: f64,
    momentum: f64,
    /// The momentum in the world.
    direction: Option<Vector3<f64>>,
}

/// What is seen of the motion as a whole.
#[derive(Default)]
pub(crate) struct Seen {
    pub last: Row,
    /// Whether the spin has never left its first value by more than rounding.
    pub constant: bool,
    /// How far the exact spin ever is from its first value, relative to the first speed.
    pub moved: f64,
    /// The most spin of the exact motion along the middle axis, rad/s.
    flipping: f64,
    /// The whole angle turned, rad: the mean speed of each two rows times the time between them.
    pub turned: f64,
    /// How often the quaternion changes its sign.
    pub sign_changes: u64,
    /// The greatest speed, rad/s.
    speed: f64,
    /// The most that the digits of a spin count in its momentum, relative to both.
    counts: f64,
    /// How much the last step changed the spin, relative to the spin.
    change: f64,
    /// Steps since the first row; rows where a step has no one length.
    steps: f64,
}

struct Flips {
    /// Since when a flip is one, s from the first row.
    from: f64,
    count: FlipCount,
    last: Option<(f64, f64)>,
}

/// The time, s, up to which the spin along the middle axis is zero to rounding, where it starts at zero.
fn flips_from(moments: &Vector3<f64>, first: &Row, middle: Option<usize>) -> f64 {
    let Some(middle) = middle else { return 0.0 };
    let zero = ON_AXIS * f64::EPSILON * first.omega.amax();
    if first.omega[middle].abs() > zero {
        return 0.0;
    }
    let rate = euler::angular_acceleration(moments, &first.omega, &Vector3::zeros())[middle].abs();
    let from = 2.0 * zero / rate;
    if from.is_finite() { from } else { 0.0 }
}

/// The axis that the spin of a motion circles.
fn circled(motion: &FreeMotion, moments: &Vector3<f64>) -> Option<usize> {
    let [smallest, _, largest] = ordered(moments);
    match motion.regime() {
        Regime::Elliptic { about: axis, .. } | Regime::SymmetricTop { axis, .. } => {
            Some(if axis == Axis::Largest { largest } else { smallest })
        }
        Regime::Separatrix { .. } => Some(smallest),
        _ => None,
    }
}

impl Laws {
    /// From the first row.
    pub(crate) fn new(moments: &Vector3<f64>, first: &Row, floor: Floor) -> Result<Self, tumbling::Error> {
        let exact = FreeMotion::new((*moments).try_into()?, &first.omega)?;
        let middle = matches!(exact.regime(), Regime::Elliptic { .. } | Regime::Separatrix { .. })
            .then(|| ordered(moments)[1]);
        let circled = circled(&exact, moments);
        let angular = moments.component_mul(&first.omega);
        // A spin that starts in the plane of the other two axes does not flip there.
        let (from, count) = (flips_from(moments, first, middle), FlipCount::default());
        let flips = Flips { from, count, last: None };
        let start = Start {
            row: *first,
            energy: observe::energy(&first.omega, &angular),
            momentum: angular.norm(),
            direction: first.attitude.map(|q| in_world(&q, &angular)),
        };
        let seen = Seen { last: *first, constant: true, speed: first.omega.norm(), ..Seen::default() };
        Ok(Self {
            moments: *moments,
            start,
            exact,
            middle,
            circled: circled.map(|axis| [axis, (axis + 1) % 3, (axis + 2) % 3]),
            curves: LawName::ALL.map(|name| (name, Curve::new())),
            points: Stretches::new(POINTS),
            lag: 0.0,
            flips,
            seen,
            floor,
        })
    }

    fn put(&mut self, name: LawName, t: f64, error: f64) {
        if let Some((_, curve)) = self.curves.iter_mut().find(|curve| curve.0 == name && error.is_finite()) {
            curve.push(t, error);
        }
    }

    /// One more row, this number of steps after the last.
    pub(crate) fn push(&mut self, state: &Row, steps: f64) -> Result<(), tumbling::Error> {
        let t = state.t - self.start.row.t;
        self.seen.steps += steps;
        let angular = self.moments.component_mul(&state.omega);
        let (energy, momentum) = (observe::energy(&state.omega, &angular), angular.norm());
        self.put(LawName::Energy, t, (energy / self.start.energy).ln());
        self.put(LawName::Momentum, t, (momentum / self.start.momentum).ln());
        let [first, now] = [&self.start.row, state].map(|row| self.ratio(row));
        self.put(LawName::Separatrix, t, now / first - 1.0);
        let mut turned_away = None;
        if let Some(q) = state.attitude {
            self.put(LawName::Unit, t, q.norm() - 1.0);
            if let Some(first) = self.start.direction {
                let now = in_world(&q, &angular);
                let angle = first.cross(&now).norm().atan2(first.dot(&now));
                turned_away = Some(angle);
                self.put(LawName::Direction, t, angle);
            }
            let changes = self.seen.last.attitude.is_some_and(|last| last.coords.dot(&q.coords) < 0.0);
            self.seen.sign_changes += u64::from(changes);
        }
        let wanted = self.exact.omega(t)?;
        let moved = (wanted - self.start.row.omega).norm() / self.start.row.omega.norm();
        self.seen.flipping = self.seen.flipping.max(self.middle.map_or(0.0, |middle| wanted[middle].abs()));
        self.seen.moved = if moved > self.seen.moved { moved } else { self.seen.moved };
        let mean = (state.omega.norm() + self.seen.last.omega.norm()) / 2.0;
        self.seen.turned += mean * (state.t - self.seen.last.t).max(0.0);
        if let Some(axes) = self.circled {
            let lag = (self.phase(axes, &state.omega) - self.phase(axes, &wanted)) * self.sense(axes);
            let step = (lag - self.lag) / TAU;
            self.lag += (step - step.round()) * TAU;
            self.put(LawName::Phase, t, self.lag / TAU);
        }
        self.points.push(Point {
            time: t,
            energy: energy / self.start.energy - 1.0,
            momentum: momentum / self.start.momentum - 1.0,
            direction: turned_away,
            phase: self.circled.map(|_| self.lag / TAU),
            spin: state.omega,
            exact: wanted,
            spin_range: [state.omega; 2],
            exact_range: [wanted; 2],
        });
        self.seen.speed = self.seen.speed.max(state.omega.norm());
        // A spin that is off along the axis of the largest moment counts most.
        let counts = self.moments.max() * state.omega.norm() / momentum;
        self.seen.counts = self.seen.counts.max(counts);
        self.seen.constant &= (state.omega - self.start.row.omega).amax()
            <= CONSTANT * self.floor.size * self.start.row.omega.amax();
        self.flip(t, state);
        self.seen.last = *state;
        Ok(())
    }

    /// A row and the one a step before it.
    pub(crate) fn pair(&mut self, pair: &Pair) {
        let (from, to) = (pair.from.omega, pair.to.omega);
        let speed = from.norm().max(to.norm());
        let change = (to - from).norm() / speed;
        let changes = if change.is_finite() { change.max(self.seen.change) } else { self.seen.change };
        if let Some(off) = pair.inconsistency() {
            // A spin that changes leaves open which of its values turned the body; a turn has its rounding.
            let allowed = changes + TURN_ROUNDINGS * self.floor.size / (speed * pair.h);
            self.put(LawName::Consistency, pair.to.t - self.start.row.t, (off - allowed).max(0.0));
        }
        self.seen.change = if change.is_finite() { change } else { 0.0 };
    }

    /// Where the spin is on its way round the axis, rad, in the plane in which that way is a circle.
    fn phase(&self, [a, b, c]: [usize; 3], omega: &Vector3<f64>) -> f64 {
        let weight = |i: usize| (self.moments[i] * (self.moments[a] - self.moments[i]).abs()).sqrt();
        (weight(c) * omega[c]).atan2(weight(b) * omega[b])
    }

    /// Which way round: counter-clockwise about the largest moment's axis where the body spins forward.
    fn sense(&self, [a, b, _]: [usize; 3]) -> f64 {
        (self.moments[a] - self.moments[b]).signum() * self.start.row.omega[a].signum()
    }

    fn flip(&mut self, t: f64, state: &Row) {
        let Some(middle) = self.middle else { return };
        // What is zero to its digits has no sign.
        let zero = self.floor.size * self.start.row.omega.norm();
        let is_over = |x: f64, first: f64| x.abs() > zero && first.abs() > zero && x * first < 0.0;
        let over =
            self.circled.is_some_and(|[axis, ..]| is_over(state.omega[axis], self.start.row.omega[axis]));
        if over {
            self.flips.count.turned_over = self.flips.count.turned_over.or(Some(t));
        }
        let x = state.omega[middle];
        let flips = &mut self.flips;
        if x == 0.0 || t <= flips.from && flips.from > 0.0 {
            return;
        }
        if let Some((t0, x0)) = flips.last
            && (x0 < 0.0) != (x < 0.0)
        {
            let share = 1.0 / (1.0 + (x / x0).abs());
            let when = t0 * (1.0 - share) + t * share;
            flips.count.found += 1;
            flips.count.first = flips.count.first.or(Some(when));
            if flips.count.times.len() < FLIP_TIMES {
                flips.count.times.push(when);
            }
        }
        flips.last = Some((t, x));
    }

    pub(crate) fn flips(&self) -> Option<FlipCount> {
        self.middle?;
        let end = self.seen.last.t - self.start.row.t;
        let mut count = self.flips.count.clone();
        let exact = self.exact.flips(self.flips.from.min(end), end).ok()?;
        count.exact = exact.remaining();
        let exact: Vec<f64> = exact.take(FLIP_TIMES).collect();
        count.first_exact = exact.first().copied();
        let late = exact.iter().zip(&count.times).map(|(exact, found)| (*exact, found - exact));
        let (line, left) = line(late.clone());
        count.apart = late.clone().fold(0.0, |most: f64, (_, late)| most.max(late.abs()));
        let seen = count.apart > end / self.seen.steps.max(1.0);
        // If the counts differ much, flips of equal index do not correspond.
        let same = count.found.max(count.exact) <= 2 * late.len() as u64;
        let is_line = late.len() >= LATE_FLIPS && left.sqrt() < LATE_LEFT * count.apart;
        count.late = Some(line).filter(|_| seen && same && is_line);
        Some(count)
    }

    /// The number of periods of the exact spin in the time of the record.
    pub(crate) fn periods(&self) -> f64 {
        let end = self.seen.last.t - self.start.row.t;
        match self.exact.period() {
            Ok(Some(period)) if period > 0.0 => end / period,
            _ => 0.0,
        }
    }

    /// Whether the body turns so far that the rounding of that angle is a tenth of a radian, or more than any
    /// number holds: where in its motion it should be then, an `f64` does not determine.
    pub(crate) fn untraceable(&self) -> bool {
        let uncertain = f64::EPSILON * self.seen.turned;
        !uncertain.is_finite() || uncertain > UNTRACEABLE
    }

    /// Whether the first spin is along one axis of the body, to rounding.
    pub(crate) fn on_axis(&self) -> bool {
        let spin = self.start.row.omega.abs();
        // The largest component, not the length: that may be more than a number holds.
        (0..3).filter(|&i| spin[i] > ON_AXIS * self.floor.size * spin.amax()).count() <= 1
    }

    /// Whether every axis of the body is a principal one.
    pub(crate) fn has_equal_moments(&self) -> bool {
        let [smallest, _, largest] = ordered(&self.moments).map(|i| self.moments[i]);
        largest - smallest <= ON_AXIS * f64::EPSILON * largest
    }

    /// `2 E I2 / L²` in a row.
    fn ratio(&self, row: &Row) -> f64 {
        let angular = self.moments.component_mul(&row.omega);
        let (middle, momentum) = (self.moments[ordered(&self.moments)[1]], angular.norm());
        2.0 * observe::energy(&row.omega, &angular) / momentum * (middle / momentum)
    }

    /// It in the first row, and in the last.
    pub(crate) fn separatrix(&self) -> Option<[f64; 2]> {
        self.middle.map(|_| [&self.start.row, &self.seen.last].map(|row| self.ratio(row)))
    }

    /// By how much the digits of two rows alone may put a law off.
    fn explained(&self, name: LawName) -> f64 {
        LAW_DIGITS
            * match name {
                LawName::Energy => 2.0 * self.seen.counts * self.floor.size,
                LawName::Momentum => self.seen.counts * self.floor.size,
                LawName::Direction => self.seen.counts * self.floor.size + 2.0 * self.floor.attitude,
                LawName::Separatrix => 4.0 * self.seen.counts * self.floor.size,
                LawName::Unit => self.floor.attitude,
                LawName::Phase | LawName::Consistency => 0.0,
            }
    }

    /// The share of the motion's rate that the digits of the first spin leave open; all of it where they
    /// leave open which axis the spin circles.
    pub(crate) fn pace_left_open(&self) -> f64 {
        let omega = self.start.row.omega;
        let Ok(Some(period)) = self.exact.period() else {
            return f64::from(u8::from(matches!(self.exact.regime(), Regime::Separatrix { .. })));
        };
        let off = LAW_DIGITS * self.floor.size * omega.norm();
        let other = |off: Vector3<f64>| {
            let motion = FreeMotion::new(self.moments.try_into().ok()?, &(omega + off)).ok()?;
            let is_same = circled(&motion, &self.moments) == self.circled.map(|axes| axes[0]);
            Some((motion.period().ok()?.filter(|_| is_same)? / period - 1.0).abs())
        };
        (0..6).map(|i| other(Vector3::ith(i % 3, [off, -off][i / 3])).unwrap_or(1.0)).fold(0.0, f64::max)
    }

    /// Whether digits show which axis the spin circles; and whether it flips: not where that is so near to
    /// the end that an error of phase decides, nor from a start without a middle component to its digits.
    pub(crate) fn shows_flips(&self) -> [bool; 2] {
        let shown = self.pace_left_open() < PHASE;
        let end = self.seen.last.t - self.start.row.t;
        let flips = self.exact.flips(self.flips.from.min(end), (1.0 + PHASE) * end).ok();
        let first = flips.and_then(|mut flips| flips.next());
        let is_clear = first.is_none_or(|first| first < (1.0 - PHASE) * end);
        let zero = LAW_DIGITS * self.floor.size * self.start.row.omega.norm();
        let is_none = |middle: usize| self.flips.from == 0.0 && self.start.row.omega[middle].abs() <= zero;
        let is_open = self.middle.is_some_and(is_none) || self.seen.flipping <= zero;
        [shown, shown && is_clear && !is_open]
    }

    /// How each law was kept that there was something of.
    ///
    /// What is beyond its limit in `allowed`, and beyond what its digits explain, is never kept to rounding.
    pub(crate) fn kept(&self, allowed: impl Fn(LawName) -> Option<f64>) -> Vec<Law> {
        let end = self.seen.last.t - self.start.row.t;
        let turned = 1.0 + self.seen.speed * end;
        let turns = self.start.row.attitude.is_some();
        let seen = self.curves.iter().filter(|(name, curve)| match name {
            LawName::Direction | LawName::Unit => turns,
            LawName::Consistency => turns && curve.most() > 0.0,
            LawName::Phase => self.circled.is_some(),
            LawName::Separatrix => self.middle.is_some(),
            _ => true,
        });
        seen.map(|(name, curve)| {
            // Some roundings a step, besides those of the numbers; in a phase one for each radian too.
            // Digits that a file lacks are lacking in each row alone: the engine goes on with its own.
            let own = (f64::from(f32::EPSILON) / self.floor.size).min(1.0);
            let [once, each] = LAW_ROUNDINGS;
            let units = once + each * self.seen.steps * own;
            let rounding = self.floor.size
                * match name {
                    LawName::Phase => units * turned,
                    LawName::Direction | LawName::Separatrix => LAW_OF_TWO * units,
                    _ => units,
                };
            let of_ratio = matches!(name, LawName::Energy | LawName::Momentum);
            let plain = |x: f64| if of_ratio { x.exp_m1() } else { x };
            let last = plain(curve.last);
            let most = curve.range.map(|x| plain(x).abs()).into_iter().fold(0.0, f64::max);
            let explained = self.explained(*name);
            let broken = most > explained.max(allowed(*name).unwrap_or(ALLOWED));
            let growth = curve.growth(if broken { 0.0 } else { rounding.max(explained) }, of_ratio);
            Law { name: *name, growth, most, last }
        })
        .collect()
    }
}
