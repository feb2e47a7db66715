//! Rules that may have made a record: a base, and an alteration of it.

use crate::law::LawName;
use crate::read::Pair;
use crate::thresholds::*;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::attitude::rotation_matrix;
use tumbling::step::Method;
use tumbling_engines::{Limits, PHYSICS_ENGINES, PhysicsEngine};

/// A rule, as a diagnosis names it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rule {
    /// The method of the step.
    pub base: Base,
    /// The alteration, if any.
    pub alteration: Option<Alteration>,
}

/// The method of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Base {
    /// The motion itself.
    Exact,
    /// A method of the library, with this number of parts a step.
    Method(Method, u32),
    /// The library's [`PositionStage`](tumbling::step::PositionStage), with this number of parts a step.
    PositionStage(u32),
    /// A physics engine's rule, and what the engine adds to it for a fast body.
    Engine(PhysicsEngine),
    /// The spin in the world by the body's tensor as it stood at this attitude.
    FrozenTensor(Quaternion<f64>, Steps),
    /// The momentum, divided by this one number, turns the body.
    MomentumForSpin(f64),
    /// The spin by this method, and the attitude straight by the new one: `q + h/2 q w`, its length set to 1
    /// or not; in this number of parts. (By the old spin it is [`Method::ExplicitEuler`].)
    Straight(Method, u32),
}

/// An alteration of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Alteration {
    /// The body has other moments than the record says, about axes turned so from the record's.
    OtherMoments(Vector3<f64>, UnitQuaternion<f64>),
    /// The spin is multiplied by this factor in each step.
    Damped {
        /// What is left of the spin.
        factor: f64,
        /// What that is a second, 1/s.
        rate: f64,
        /// Where in the step.
        when: When,
        /// The number of such steps from row to row, equal shares of the parts.
        steps: u32,
        /// What the gyroscopic term is multiplied by besides.
        term: f64,
    },
    /// The gyroscopic term is multiplied by this number.
    Term(f64),
    /// The gyroscopic term, or the times: spins alone do not distinguish these.
    TermOrTimes(f64),
    /// The times are too short by this factor (below one: too long): in a step, spin and attitude both change
    /// by as much as the motion does in this factor times the step.
    Times(f64),
    /// The spin is the rule's, and the attitude does not turn by it.
    Turned(Turn),
    /// The spin is limited to this, rad/s.
    Capped(f64),
}

/// How the attitude turns, if not by its rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    /// By the spin before the step.
    Old,
    /// By the spin of the row after: each spin stands a row late.
    Late,
    /// By the spin of the row before: each spin stands a row early.
    Early,
    /// On the other side: by a spin in body axes as if it were in the world's.
    BodyInWorld,
    /// On the other side: by a spin in world axes as if it were in the body's.
    WorldInBody,
    /// Once more by the old spin, before the rule does.
    TwiceBefore,
    /// Once more by the new spin, after the rule has.
    TwiceAfter,
    /// By the new spin in the world, in place of the turn that this spin belongs to.
    Own,
    /// Otherwise.
    Otherwise,
}

impl Turn {
    /// The turns on the wrong side, repeated, or by the wrong spin, in the order of trial.
    pub(crate) const OTHERS: [Self; 5] =
        [Self::BodyInWorld, Self::WorldInBody, Self::TwiceBefore, Self::TwiceAfter, Self::Own];

    /// Whether spin and attitude of a row belong to different times, of a rule that may be right.
    pub(crate) const fn is_of_rows(self) -> bool {
        matches!(self, Self::Old | Self::Late | Self::Early | Self::Otherwise)
    }
}

/// The method that steps the spin with a frozen tensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Steps {
    /// Explicit Euler.
    First,
    /// By Runge and Kutta, as [`Engine::Frozen`](tumbling::step::Engine) is.
    Fourth,
}

/// Where in a step the spin is damped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum When {
    /// Before the gyroscopic term.
    Before,
    /// Together with it: by a share of the spin before the step.
    Beside,
    /// After it, and before the turn.
    After,
    /// After the turn.
    Turned,
    /// The record does not show where; as after the turn.
    Open,
}

impl Rule {
    /// The motion itself.
    pub const EXACT: Self = Self::plain(Base::Exact);

    /// A base as it is.
    #[must_use]
    pub const fn plain(base: Base) -> Self {
        Self { base, alteration: None }
    }

    /// Its method and its number of parts per step, if it is a plain method or an engine's.
    #[must_use]
    pub const fn method(&self) -> Option<(Method, u32)> {
        match (self.base, self.alteration) {
            (Base::Method(method, parts), None) => Some((method, parts)),
            (Base::Engine(engine), None) => Some((engine.method, engine.parts)),
            _ => None,
        }
    }

    /// Whether it keeps a law, whatever the step.
    pub(crate) fn keeps(&self, law: LawName) -> bool {
        let [energy, momentum, direction] = match (self.base, self.alteration) {
            (Base::Method(method, _), None) => {
                let kept = method.info();
                [kept.energy, kept.momentum, kept.direction]
            }
            (Base::Exact | Base::PositionStage(_), None) => [true; 3],
            _ => [false; 3],
        };
        match law {
            LawName::Energy => energy,
            LawName::Momentum => momentum,
            LawName::Direction => direction,
            LawName::Separatrix => energy && momentum,
            _ => false,
        }
    }

    /// The rule without the numbers that are fitted to a record.
    pub(crate) fn neutral(&self) -> Vec<Self> {
        let with = |alteration| Self { alteration: Some(alteration), ..*self };
        match self.alteration {
            Some(Alteration::Damped { factor, rate, when, steps, term }) => {
                let undamped = with(Alteration::Damped { factor: 1.0, rate: 0.0, when, steps, term });
                let whole = with(Alteration::Damped { factor, rate, when, steps, term: 1.0 });
                [undamped].into_iter().chain((term != 1.0).then_some(whole)).collect()
            }
            Some(Alteration::Term(_) | Alteration::TermOrTimes(_)) => {
                [0.0, 1.0].map(|times| with(Alteration::Term(times))).to_vec()
            }
            // Of the spin alone.
            Some(Alteration::Turned(Turn::Otherwise)) => vec![Self { base: Base::Exact, ..*self }],
            Some(_) => vec![Self::plain(self.base)],
            None => vec![Self::EXACT],
        }
    }

    /// Whether it does not converge to the motion of the body with shorter steps.
    pub(crate) const fn is_wrong(&self) -> bool {
        let base = match self.base {
            Base::Exact | Base::PositionStage(_) => false,
            // A limit on the turn of a step is out of reach of shorter ones.
            Base::Engine(own) => own.limits.component.is_some() || matches!(own.method, Method::ConstantSpin),
            Base::Method(..) | Base::Straight(..) => self.base.is_still(),
            _ => true,
        };
        let altered = match self.alteration {
            Some(Alteration::Turned(turn)) => !turn.is_of_rows(),
            other => other.is_some(),
        };
        base || altered
    }

    pub(crate) const fn is_damped(&self) -> bool {
        matches!(self.alteration, Some(Alteration::Damped { .. }))
    }

    /// Whether it does not determine the attitude.
    pub(crate) const fn is_of_spin(&self) -> bool {
        matches!(
            self.alteration,
            Some(Alteration::Term(_) | Alteration::TermOrTimes(_) | Alteration::Turned(Turn::Otherwise))
        )
    }

    /// As it is in a record with spins, or without: there none stands a row late or early.
    pub(crate) fn written(mut self, spins: bool) -> Self {
        self.alteration =
            self.alteration.filter(|x| spins || !matches!(x, Alteration::Turned(Turn::Late | Turn::Early)));
        self
    }

    /// Of a body whose moments are this many times as large.
    pub(crate) fn times(mut self, unit: f64) -> Self {
        if let Some(Alteration::OtherMoments(moments, _)) = &mut self.alteration {
            *moments *= unit;
        }
        if let Base::MomentumForSpin(mass) = &mut self.base {
            *mass *= unit;
        }
        self
    }
}

impl Base {
    /// The number of parts of its step.
    pub(crate) const fn parts(&self) -> u32 {
        match self {
            Self::Method(_, parts) | Self::PositionStage(parts) | Self::Straight(_, parts) => *parts,
            Self::Engine(engine) => engine.parts,
            _ => 1,
        }
    }

    /// Whether it has no gyroscopic term.
    pub(crate) const fn is_still(&self) -> bool {
        matches!(self, Self::Method(Method::ConstantSpin, _) | Self::Straight(Method::ConstantSpin, _))
    }

    /// The method that steps its spin, and its number of parts.
    pub(crate) const fn spin(&self) -> Option<(Method, u32)> {
        match *self {
            Self::Method(Method::ExplicitEuler, parts) => Some((Method::SemiImplicitEuler, parts)),
            Self::Method(Method::RescaledLinearAttitude, parts) => Some((Method::Rescaled, parts)),
            Self::Method(method, parts) | Self::Straight(method, parts) => Some((method, parts)),
            _ => None,
        }
    }

    /// This rule with this number of parts a step.
    pub(crate) const fn in_parts(self, parts: u32) -> Self {
        match self {
            Self::Method(method, _) => Self::Method(method, parts),
            Self::PositionStage(_) => Self::PositionStage(parts),
            Self::Straight(method, _) => Self::Straight(method, parts),
            other => other,
        }
    }

    /// Every rule whose step can be divided into parts.
    pub(crate) fn every() -> impl Iterator<Item = Self> {
        let methods = Method::ALL.iter().map(|&method| Self::Method(method, 1));
        let straight = [Method::SemiImplicitEuler, Method::ConstantSpin].map(|x| Self::Straight(x, 1));
        methods.chain([Self::PositionStage(1)]).chain(straight)
    }

    /// The exact motion, the rules that engines use, and those recommended to engines.
    pub(crate) fn all() -> Vec<Self> {
        let mut all = vec![Self::Exact];
        for engine in PHYSICS_ENGINES {
            let base = if engine.limits.straight { Self::Straight } else { Self::Method };
            all.push(base(engine.method, engine.parts));
        }
        let others = [Method::RungeKutta4, Method::ImplicitMidpoint, Method::RotationSplitting2];
        all.extend(others.map(|method| Self::Method(method, 1)));
        distinct(all)
    }

    /// With this alteration.
    pub(crate) const fn but(self, alteration: Alteration) -> Rule {
        Rule { base: self, alteration: Some(alteration) }
    }
}

/// Plain rules, in the order of preference if several fit a record equally well.
pub(crate) fn plain(free: bool, pairs: &[Pair]) -> Vec<Rule> {
    let possible = |base: &Base| free || matches!(base, Base::Method(..));
    let mut all: Vec<Base> = Base::all().into_iter().filter(possible).collect();
    let plain = [Limits::NONE, Limits::STRAIGHT];
    let limited = PHYSICS_ENGINES.iter().filter(|engine| !plain.contains(&engine.limits));
    // The most spin along an axis of the world after any step.
    let along = |pair: &Pair| Some((rotation_matrix(&pair.from.attitude?) * pair.to.omega).amax());
    let most = pairs.iter().filter_map(along).fold(0.0, f64::max);
    for &engine in limited {
        all.push(Base::Engine(engine));
        // Bullet's greatest spin is a setting, and may have been raised.
        if engine.limits.component.is_some_and(|usual| most > usual * (1.0 + BEYOND)) {
            let limits = Limits { component: Some(most), ..engine.limits };
            all.push(Base::Engine(PhysicsEngine { limits, record: None, ..engine }));
        }
    }
    all.extend(Method::ALL.iter().map(|&method| Base::Method(method, 1)));
    all.extend(free.then_some(Base::PositionStage(1)));
    all.extend(frozen(pairs));
    distinct(all).into_iter().map(Rule::plain).collect()
}

/// Rules with several steps per row, for an engine that does not write every step; those with the header's
/// number first.
pub(crate) fn in_parts(per_row: Option<u32>, all: bool) -> Vec<Rule> {
    let mut found = Vec::new();
    if let Some(parts) = per_row.filter(|parts| *parts > 1) {
        let of = |engine: &PhysicsEngine| Base::Method(engine.method, parts.saturating_mul(engine.parts));
        found.extend(PHYSICS_ENGINES.iter().map(of));
        found.extend(Base::every().map(|base| base.in_parts(parts)));
    }
    for base in Base::every() {
        let more = match base {
            Base::Method(method, _) => method.info().order <= 4,
            other => matches!(other, Base::Straight(..)),
        };
        let few = if all { &PARTS[..] } else { &PARTS[..3] };
        let more = if all && more { &MORE_PARTS[..] } else { &[] };
        found.extend(few.iter().chain(more).map(|&parts| base.in_parts(parts)));
    }
    distinct(found).into_iter().map(Rule::plain).collect()
}

/// Each of them once.
pub(crate) fn distinct(all: Vec<Base>) -> Vec<Base> {
    let is_first = |(i, base): &(usize, Base)| !all[..*i].contains(base);
    all.iter().copied().enumerate().filter(is_first).map(|(_, base)| base).collect()
}

/// Every rule in this number of parts; none for one part, in which all are tried anyway.
pub(crate) fn of_parts(parts: u32) -> Vec<Rule> {
    let all = Base::every().filter(|_| parts != 1);
    all.map(|base| Rule::plain(base.in_parts(parts))).collect()
}

/// The tensor frozen as it stood at the identity, and at the record's first attitude where that is another.
pub(crate) fn frozen(pairs: &[Pair]) -> Vec<Base> {
    let first = pairs.first().and_then(|pair| pair.from.attitude).map(|q| q / q.norm());
    let other = first.filter(|q| q.imag().norm() > 0.0 && q.norm().is_finite());
    let frozen = |first| [Steps::First, Steps::Fourth].map(|steps| Base::FrozenTensor(first, steps));
    [Quaternion::identity()].into_iter().chain(other).flat_map(frozen).collect()
}
