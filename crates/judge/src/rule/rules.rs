//! Rules that may have made a record: a base, and what is altered of it.

use crate::read::state::Pair;
use crate::rule::engine_step::{Limits, PhysicsEngine};
use crate::rule::engines::PHYSICS_ENGINES;
use crate::thresholds::{BEYOND, MORE_PARTS, PARTS};
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude;
use tumbling::step::Method;

/// A rule, as a diagnosis names it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rule {
    /// What makes the step.
    pub base: Base,
    /// What is altered of it.
    pub alteration: Option<Alteration>,
}

/// What makes a step.
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
    /// The spin in the world by the body's tensor as it stood at the identity.
    FrozenTensor(Steps),
    /// The same by the tensor as it stood at this attitude, the record's first.
    FrozenAt(Quaternion<f64>, Steps),
    /// The momentum, divided by this one number, turns the body.
    MomentumForSpin(f64),
    /// The spin stepped so, and the attitude straight by the new one: `q + h/2 q w`, its length set to 1 or
    /// not; in this number of parts. (By the old spin it is [`Method::ExplicitEuler`].)
    Straight(Spin, u32),
}

/// What is altered of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Alteration {
    /// The body has other moments than the record says.
    OtherMoments(Vector3<f64>),
    /// The spin is lessened by this factor in each step: after the rule, or before.
    Damped(f64, When),
    /// There is no spin beyond this, rad/s.
    Capped(f64),
}

/// How a plain engine steps the spin where it steps the attitude straight.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spin {
    /// Not at all: no gyroscopic term.
    Kept,
    /// By the gyroscopic term at the start of the step.
    Explicit,
}

/// Of what order the frozen tensor's spin is stepped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Steps {
    /// Straight ahead.
    First,
    /// By Runge and Kutta.
    Fourth,
}

/// Whether a spin is damped before or after the rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum When {
    /// Before.
    Before,
    /// After, and before the turn.
    After,
}

impl Rule {
    /// The motion itself.
    pub const EXACT: Self = Self::plain(Base::Exact);

    /// A base as it is.
    #[must_use]
    pub const fn plain(base: Base) -> Self {
        Self { base, alteration: None }
    }

    /// The method that it is, and in how many parts it cuts a step, if it is one and no more than limited.
    #[must_use]
    pub const fn method(&self) -> Option<(Method, u32)> {
        match (self.base, self.alteration) {
            (Base::Method(method, parts), None) => Some((method, parts)),
            (Base::Engine(engine), None) => Some((engine.method, engine.parts)),
            _ => None,
        }
    }
}

impl Base {
    /// In how many parts it cuts a step.
    pub(crate) const fn parts(&self) -> u32 {
        match self {
            Self::Method(_, parts) | Self::PositionStage(parts) | Self::Straight(_, parts) => *parts,
            Self::Engine(engine) => engine.parts,
            _ => 1,
        }
    }

    /// The same rule in one part.
    pub(crate) const fn in_one_part(self) -> Self {
        match self {
            Self::Method(method, _) => Self::Method(method, 1),
            Self::PositionStage(_) => Self::PositionStage(1),
            Self::Straight(spin, _) => Self::Straight(spin, 1),
            other => other,
        }
    }

    /// The exact motion, and the rules that engines go by.
    pub(crate) fn all() -> Vec<Self> {
        let mut all = vec![Self::Exact];
        for engine in PHYSICS_ENGINES {
            let base = Self::Method(engine.method, engine.parts);
            if !all.contains(&base) {
                all.push(base);
            }
        }
        all
    }

    /// With this alteration.
    pub(crate) const fn but(self, alteration: Alteration) -> Rule {
        Rule { base: self, alteration: Some(alteration) }
    }
}

/// Plain rules, in the order in which they are preferred where several explain a record alike.
pub(crate) fn plain(free: bool, pairs: &[Pair]) -> Vec<Rule> {
    let mut all = Vec::new();
    if free {
        all.push(Base::Exact);
    }
    all.extend(Base::all().into_iter().filter(|base| *base != Base::Exact));
    for &engine in PHYSICS_ENGINES.iter().filter(|engine| engine.limits != Limits::NONE) {
        all.push(Base::Engine(engine));
        // Bullet's greatest spin is a setting, and may have been raised.
        if let (Some(usual), Some(most)) = (engine.limits.component, greatest(pairs))
            && most > usual * (1.0 + BEYOND)
        {
            let limits = Limits { component: Some(most), ..engine.limits };
            all.push(Base::Engine(PhysicsEngine { limits, record: None, ..engine }));
        }
    }
    for &method in Method::ALL {
        let base = Base::Method(method, 1);
        if !all.contains(&base) {
            all.push(base);
        }
    }
    if free {
        all.extend([
            Base::PositionStage(1),
            Base::Straight(Spin::Kept, 1),
            Base::Straight(Spin::Explicit, 1),
        ]);
    }
    all.extend([Base::FrozenTensor(Steps::First), Base::FrozenTensor(Steps::Fourth)]);
    all.into_iter().map(Rule::plain).collect()
}

/// Rules in parts of a row, as of an engine whose rows are not written at every step; those of the header's
/// number first.
pub(crate) fn in_parts(per_row: Option<u32>, all: bool) -> Vec<Rule> {
    let named = per_row.filter(|parts| *parts > 1);
    let mut found = Vec::new();
    let mut add = |base: Base| {
        if !found.contains(&base) {
            found.push(base);
        }
    };
    if let Some(parts) = named {
        for engine in PHYSICS_ENGINES {
            add(Base::Method(engine.method, parts.saturating_mul(engine.parts)));
        }
        Method::ALL.iter().for_each(|&method| add(Base::Method(method, parts)));
        add(Base::PositionStage(parts));
        add(Base::Straight(Spin::Explicit, parts));
        add(Base::Straight(Spin::Kept, parts));
    }
    let more = |order: u32| if order <= 4 { &MORE_PARTS[..] } else { &[] };
    let few = if all { &PARTS[..] } else { &PARTS[..3] };
    for &method in Method::ALL {
        let more = if all { more(method.info().order) } else { &[] };
        few.iter().chain(more).for_each(|&parts| add(Base::Method(method, parts)));
    }
    few.iter().for_each(|&parts| add(Base::PositionStage(parts)));
    for &parts in few.iter().chain(if all { &MORE_PARTS[..] } else { &[] }) {
        add(Base::Straight(Spin::Explicit, parts));
        add(Base::Straight(Spin::Kept, parts));
    }
    found.into_iter().map(Rule::plain).collect()
}

/// Every rule in this number of parts; none for one part, in which all are tried anyway.
pub(crate) fn of_parts(parts: u32) -> Vec<Rule> {
    if parts == 1 {
        return Vec::new();
    }
    let methods = Method::ALL.iter().map(|&method| Base::Method(method, parts));
    let straight = [Spin::Explicit, Spin::Kept].map(|spin| Base::Straight(spin, parts));
    methods.chain([Base::PositionStage(parts)]).chain(straight).map(Rule::plain).collect()
}

/// The tensor frozen as it stood at the record's first attitude, where that is another than the identity.
pub(crate) fn frozen_at(pairs: &[Pair]) -> Vec<Rule> {
    let first = pairs.first().and_then(|pair| pair.from.attitude);
    let first = first.map(|q| q / q.norm()).filter(|q| q.imag().norm() > 0.0 && q.norm().is_finite());
    let both = |q| [Steps::First, Steps::Fourth].map(|steps| Rule::plain(Base::FrozenAt(q, steps)));
    first.map_or(Vec::new(), |q| both(q).to_vec())
}

/// The most spin along an axis of the world after any step.
fn greatest(pairs: &[Pair]) -> Option<f64> {
    let along = |pair: &Pair| Some((attitude::rotation_matrix(&pair.from.attitude?) * pair.to.omega).amax());
    pairs.iter().filter_map(along).reduce(f64::max)
}
