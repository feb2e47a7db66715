//! The laws of free motion, each held against the rows as they come.

use crate::curve::{Curve, Growth};
use crate::points::{Point, Points};
use crate::state::{Pair, Row};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};
use tumbling::exact::{FreeMotion, Regime};
use tumbling::{Axis, attitude, dynamics::observe};

/// What is held against the record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum LawName {
    /// The kinetic energy, as its ratio to the first one.
    Energy,
    /// The length of the angular momentum, as its ratio to the first one.
    Momentum,
    /// Where the angular momentum points in the world, rad from the first one.
    Direction,
    /// The length of the attitude quaternion, from 1.
    Unit,
    /// `2 E I2 / L²`, from the first one; at 1 is the separatrix, beyond which a stable spin flips.
    Separatrix,
    /// How far the spin is ahead of the exact one on its closed curve in body axes, in times round it.
    Phase,
    /// The turn from row to row against the spin, beside the spin, less what this step and the last changed the spin.
    Consistency,
}

impl LawName {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Energy,
        Self::Momentum,
        Self::Direction,
        Self::Unit,
        Self::Separatrix,
        Self::Phase,
        Self::Consistency,
    ];

    /// In plain words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Energy => "energy",
            Self::Momentum => "|L|",
            Self::Direction => "direction of L",
            Self::Unit => "quaternion's length",
            Self::Separatrix => "2 E I2 / L^2",
            Self::Phase => "phase",
            Self::Consistency => "turn against spin",
        }
    }

    /// A name for programs.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Energy => "energy",
            Self::Momentum => "momentum",
            Self::Direction => "direction",
            Self::Unit => "unit",
            Self::Separatrix => "separatrix",
            Self::Phase => "phase",
            Self::Consistency => "consistency",
        }
    }

    /// Whether an engine fails by it: the exact motion keeps it for ever.
    #[must_use]
    pub const fn is_conserved(self) -> bool {
        !matches!(self, Self::Phase | Self::Consistency)
    }
}

/// How a law was kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// Which.
    pub name: LawName,
    /// How its error grew.
    pub growth: Growth,
    /// The greatest error.
    pub most: f64,
    /// The last error, with its sign.
    pub last: f64,
}

/// Flips counted, in the record and in the exact motion.
#[derive(Debug, Clone, PartialEq)]
pub struct FlipCount {
    /// In the record: changes of sign of the spin along the middle axis.
    pub found: u64,
    /// In the exact motion, in the same time.
    pub exact: u64,
    /// The time of the first in the record, s from its start.
    pub first: Option<f64>,
    /// The time of the first of the exact motion, s from the start.
    pub first_exact: Option<f64>,
    /// The greatest difference in time between flips of the same number, s.
    pub apart: f64,
    /// The times of the first 512 in the record, s from its start.
    pub times: Vec<f64>,
    /// When the spin along the axis that it circles first changes sign, s from the start. In the exact motion it never does.
    pub turned_over: Option<f64>,
}

/// Everything that is followed from row to row.
pub(crate) struct Laws {
    moments: Vector3<f64>,
    first: Row,
    pub exact: FreeMotion,
    energy: f64,
    momentum: f64,
    direction: Option<Vector3<f64>>,
    middle: Option<usize>,
    /// The axis the spin circles, and the two others in right-handed order.
    circled: Option<[usize; 3]>,
    curves: [(LawName, Curve); 7],
    pub points: Points,
    lag: f64,
    flips: Flips,
    speed: f64,
    /// How much the last step changed the spin, beside the spin.
    change: f64,
    /// Steps since the first row; rows where a step has no one length.
    steps: f64,
    pub last: Row,
    /// Whether the spin has ever left its first value by more than rounding.
    pub constant: bool,
    /// How far the exact spin ever is from its first value, beside the first speed.
    pub moved: f64,
    /// The whole angle turned, rad: the mean speed of each two rows times the time between them.
    pub turned: f64,
    floor: f64,
    pub sign_changes: u64,
}

/// Of how many flips the times are kept.
const FLIPS_TOLD: usize = 512;

struct Flips {
    exact: Box<dyn Iterator<Item = f64>>,
    count: FlipCount,
    last: Option<(f64, f64)>,
}

impl Laws {
    /// From the first row; `floor` is the rounding of the numbers, beside 1.
    pub(crate) fn new(
        moments: &Vector3<f64>,
        first: &Row,
        direction: Option<Vector3<f64>>,
        floor: f64,
    ) -> Result<Self, tumbling::Error> {
        let exact = FreeMotion::new((*moments).try_into()?, &first.omega)?;
        let middle = matches!(exact.regime(), Regime::Elliptic { .. } | Regime::Separatrix { .. })
            .then(|| ordered(moments)[1]);
        let circled = match exact.regime() {
            Regime::Elliptic { about: Axis::Largest, .. } => Some(ordered(moments)[2]),
            Regime::Elliptic { .. } | Regime::Separatrix { .. } => Some(ordered(moments)[0]),
            Regime::SymmetricTop { axis, .. } => Some(axis),
            _ => None,
        };
        let angular = moments.component_mul(&first.omega);
        let flips = exact.flips(0.0, 1e9).or_else(|_| exact.flips(0.0, 1e3));
        let exact_flips: Box<dyn Iterator<Item = f64>> = match flips {
            Ok(flips) => Box::new(flips),
            Err(_) => Box::new(std::iter::empty()),
        };
        Ok(Self {
            moments: *moments,
            first: *first,
            exact,
            energy: observe::energy(&first.omega, &angular),
            momentum: angular.norm(),
            direction: direction.or_else(|| first.attitude.map(|q| turned(&q, &angular))),
            middle,
            circled: circled.map(|axis| [axis, (axis + 1) % 3, (axis + 2) % 3]),
            curves: LawName::ALL.map(|name| (name, Curve::new())),
            points: Points::new(),
            lag: 0.0,
            flips: Flips {
                exact: exact_flips,
                count: FlipCount {
                    found: 0,
                    exact: 0,
                    first: None,
                    times: Vec::new(),
                    first_exact: None,
                    apart: 0.0,
                    turned_over: None,
                },
                last: None,
            },
            speed: first.omega.norm(),
            change: 0.0,
            steps: 0.0,
            last: *first,
            constant: true,
            moved: 0.0,
            turned: 0.0,
            floor,
            sign_changes: 0,
        })
    }

    fn put(&mut self, name: LawName, t: f64, error: f64) {
        if error.is_finite()
            && let Some((_, curve)) = self.curves.iter_mut().find(|curve| curve.0 == name)
        {
            curve.push(t, error);
        }
    }

    /// One more row, so many steps after the last.
    pub(crate) fn push(&mut self, state: &Row, steps: f64) -> Result<(), tumbling::Error> {
        let t = state.t - self.first.t;
        self.steps += steps;
        let angular = self.moments.component_mul(&state.omega);
        let (energy, momentum) = (observe::energy(&state.omega, &angular), angular.norm());
        self.put(LawName::Energy, t, (energy / self.energy).ln());
        self.put(LawName::Momentum, t, (momentum / self.momentum).ln());
        let middle = ordered(&self.moments)[1];
        let separatrix =
            |energy: f64, momentum: f64| 2.0 * energy / momentum * (self.moments[middle] / momentum);
        let error = separatrix(energy, momentum) - separatrix(self.energy, self.momentum);
        self.put(LawName::Separatrix, t, error);
        let mut turned_away = None;
        if let Some(q) = state.attitude {
            self.put(LawName::Unit, t, q.norm() - 1.0);
            if let Some(first) = self.direction {
                let now = turned(&q, &angular);
                let angle = first.cross(&now).norm().atan2(first.dot(&now));
                turned_away = Some(angle);
                self.put(LawName::Direction, t, angle);
            }
            if self.last.attitude.is_some_and(|last| last.coords.dot(&q.coords) < 0.0) {
                self.sign_changes += 1;
            }
        }
        let wanted = self.exact.omega(t)?;
        let moved = (wanted - self.first.omega).norm() / self.first.omega.norm();
        self.moved = if moved > self.moved { moved } else { self.moved };
        let mean = (state.omega.norm() + self.last.omega.norm()) / 2.0;
        self.turned += mean * (state.t - self.last.t).max(0.0);
        if let Some(axes) = self.circled {
            let lag = (self.phase(axes, &state.omega) - self.phase(axes, &wanted)) * self.sense(axes);
            let step = (lag - self.lag) / TAU;
            self.lag += (step - step.round()) * TAU;
            self.put(LawName::Phase, t, self.lag / TAU);
        }
        self.points.push(&Point {
            time: t,
            energy: energy / self.energy - 1.0,
            momentum: momentum / self.momentum - 1.0,
            direction: turned_away,
            phase: self.circled.map(|_| self.lag / TAU),
            spin: state.omega,
            exact: wanted,
            spin_range: [state.omega; 2],
            exact_range: [wanted; 2],
        });
        let speed = state.omega.norm();
        self.speed = self.speed.max(speed);
        self.constant &=
            (state.omega - self.first.omega).amax() <= 64.0 * self.floor * self.first.omega.amax();
        self.flip(t, state);
        self.last = *state;
        Ok(())
    }

    /// A row and the one a step before it.
    pub(crate) fn pair(&mut self, pair: &Pair) {
        let (from, to) = (pair.from.omega, pair.to.omega);
        let speed = from.norm().max(to.norm());
        let change = (to - from).norm() / speed;
        let changes = if change.is_finite() { change.max(self.change) } else { self.change };
        if let Some(off) = pair.inconsistency() {
            // A spin that changes in a step leaves open which of its values turned the body; a turn has its rounding.
            let allowed = changes + 8.0 * self.floor / (speed * pair.h);
            self.put(LawName::Consistency, pair.to.t - self.first.t, (off - allowed).max(0.0));
        }
        self.change = if change.is_finite() { change } else { 0.0 };
    }

    /// Where the spin is on its way round the axis, rad: the angle in the plane in which that way is a circle.
    fn phase(&self, [a, b, c]: [usize; 3], omega: &Vector3<f64>) -> f64 {
        let weight = |i: usize| (self.moments[i] * (self.moments[a] - self.moments[i]).abs()).sqrt();
        (weight(c) * omega[c]).atan2(weight(b) * omega[b])
    }

    /// Which way round the spin goes: counter-clockwise about the largest moment's axis where it spins forward.
    fn sense(&self, [a, b, _]: [usize; 3]) -> f64 {
        (self.moments[a] - self.moments[b]).signum() * self.first.omega[a].signum()
    }

    fn flip(&mut self, t: f64, state: &Row) {
        let Some(middle) = self.middle else { return };
        let over = self.circled.is_some_and(|[axis, ..]| state.omega[axis] * self.first.omega[axis] < 0.0);
        if over {
            self.flips.count.turned_over = self.flips.count.turned_over.or(Some(t));
        }
        let x = state.omega[middle];
        let flips = &mut self.flips;
        if x == 0.0 {
            return;
        }
        if let Some((t0, x0)) = flips.last
            && (x0 < 0.0) != (x < 0.0)
        {
            let share = 1.0 / (1.0 + (x / x0).abs());
            let when = t0 * (1.0 - share) + t * share;
            flips.count.found += 1;
            flips.count.first = flips.count.first.or(Some(when));
            if flips.count.times.len() < FLIPS_TOLD {
                flips.count.times.push(when);
            }
            if let Some(exact) = flips.exact.next() {
                flips.count.apart = flips.count.apart.max((when - exact).abs());
            }
        }
        flips.last = Some((t, x));
    }

    pub(crate) fn flips(&self) -> Option<FlipCount> {
        self.middle?;
        let end = self.last.t - self.first.t;
        let mut count = self.flips.count.clone();
        let exact = self.exact.flips(0.0, end).ok()?;
        count.exact = exact.remaining();
        count.first_exact = exact.into_iter().next();
        Some(count)
    }

    /// How many ways round the exact spin goes in the time of the record.
    pub(crate) fn ways_round(&self) -> f64 {
        let end = self.last.t - self.first.t;
        match self.exact.period() {
            Ok(Some(period)) if period > 0.0 => end / period,
            _ => 0.0,
        }
    }

    /// Whether the body turns so far in the time of the record that the rounding of that angle alone is a tenth of a radian, or more than any
    /// number holds: where in its motion the body should be then, an `f64` does not tell.
    pub(crate) fn untraceable(&self) -> bool {
        let uncertain = f64::EPSILON * self.turned;
        !uncertain.is_finite() || uncertain > 0.1
    }

    /// Whether the first spin is along one axis of the body, to rounding.
    pub(crate) fn on_axis(&self) -> bool {
        let spin = self.first.omega.abs();
        // The largest component, not the length: that may be more than a number holds.
        (0..3).filter(|&i| spin[i] > 8.0 * self.floor * spin.amax()).count() <= 1
    }

    /// The first, and the last, `2 E I2 / L²`.
    pub(crate) fn separatrix(&self) -> Option<[f64; 2]> {
        let middle = self.moments[ordered(&self.moments)[1]];
        let at = |state: &Row| {
            let angular = self.moments.component_mul(&state.omega);
            2.0 * observe::energy(&state.omega, &angular) * middle / angular.norm_squared()
        };
        self.middle.map(|_| [at(&self.first), at(&self.last)])
    }

    /// How each law was kept that there was something of.
    ///
    /// What is beyond its limit in `allowed` is never kept to rounding.
    pub(crate) fn kept(&self, allowed: impl Fn(LawName) -> Option<f64>) -> Vec<Law> {
        let end = self.last.t - self.first.t;
        let turned = 1.0 + self.speed * end;
        self.curves
            .iter()
            .filter(|(name, curve)| {
                let seen = curve.most() > 0.0 || *name != LawName::Consistency;
                seen && match name {
                    LawName::Direction | LawName::Unit | LawName::Consistency => {
                        self.first.attitude.is_some()
                    }
                    LawName::Phase => self.circled.is_some(),
                    LawName::Separatrix => self.middle.is_some(),
                    _ => true,
                }
            })
            .map(|(name, curve)| {
                // Some rounding units a step beside the rounding of the numbers themselves; of a time, of all that turns in it.
                // Digits that a file lacks are lacking in each row alone: the engine steps on with its own, of single precision or better.
                let own = (f64::from(f32::EPSILON) / self.floor).min(1.0);
                let units = 32.0 + 4.0 * self.steps * own;
                let rounding = self.floor
                    * match name {
                        LawName::Phase => units * turned,
                        LawName::Direction | LawName::Separatrix => 2.0 * units,
                        _ => units,
                    };
                let of_ratio = matches!(name, LawName::Energy | LawName::Momentum);
                let plain = |x: f64| if of_ratio { x.exp_m1() } else { x };
                let last = plain(curve.last());
                let most = curve.range().map(|x| plain(x).abs()).into_iter().fold(0.0, f64::max);
                let broken = most > allowed(*name).unwrap_or(0.01);
                let growth = curve.growth(if broken { 0.0 } else { rounding }, of_ratio);
                Law { name: *name, growth, most, last }
            })
            .collect()
    }
}

/// The indices of the moments, smallest first.
pub(crate) fn ordered(moments: &Vector3<f64>) -> [usize; 3] {
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    order
}

pub(crate) fn turned(q: &nalgebra::Quaternion<f64>, vector: &Vector3<f64>) -> Vector3<f64> {
    attitude::rotation_matrix(q) * vector
}

/// The angle between two attitudes, rad, whichever sign their quaternions have and however long they are.
pub(crate) fn angle_between(a: &nalgebra::Quaternion<f64>, b: &nalgebra::Quaternion<f64>) -> f64 {
    let between = attitude::product(&a.conjugate(), b);
    (2.0 * between.imag().norm().atan2(between.w.abs())).min(PI)
}

/// As a unit quaternion, which it is but for rounding.
pub(crate) fn unit(q: &nalgebra::Quaternion<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::new_normalize(*q)
}
