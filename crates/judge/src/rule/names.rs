//! The names of rules, and the engines that use them.

use crate::read::{by_how_much, to_four_places};
use crate::rule::{Alteration, Base, Rule, Turn, When};
use crate::thresholds::*;
use tumbling::step::Method;
use tumbling_engines::{Limits, PHYSICS_ENGINES, PhysicsEngine};

/// A number with five significant digits, as people write it.
pub(crate) fn significant(x: f64) -> String {
    // Rounded before it is measured: 0.999999 is 1.0000.
    let short = format!("{x:.4e}");
    let size = short.rsplit('e').next().and_then(|size| size.parse::<i32>().ok()).unwrap_or_default();
    if x == 0.0 || !x.is_finite() {
        return x.to_string();
    }
    if !(-4..9).contains(&size) {
        return short;
    }
    let decimals = (4 - size).max(0) as usize;
    format!("{x:.decimals$}")
}

/// A number with all its digits, with a power of ten where it is very small or large.
pub(crate) fn readable(x: f64) -> String {
    if x == 0.0 || (1e-5..1e15).contains(&x.abs()) { x.to_string() } else { format!("{x:e}") }
}

fn in_parts(name: &str, parts: u32) -> String {
    if parts == 1 { name.into() } else { format!("{name}, {parts} parts a step") }
}

impl Base {
    /// Its name.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Exact => "the exact motion".into(),
            Self::Method(method, parts) => in_parts(method.info().name, *parts),
            Self::PositionStage(parts) => in_parts("the position stage of the crate tumbling", *parts),
            Self::Engine(PhysicsEngine { method, parts, name, limits: own, .. }) => {
                let rule = Self::Method(*method, *parts).name();
                format!("{rule}, with the limits of {name} ({})", limits(own))
            }
            Self::FrozenTensor(..) => "a tensor frozen in the world".into(),
            Self::MomentumForSpin(mass) => {
                format!("momentum taken for spin (divided by {})", significant(*mass))
            }
            Self::Straight(Method::ConstantSpin, parts) => {
                in_parts("no gyroscopic term, linear update of the attitude (q + h/2 q w)", *parts)
            }
            Self::Straight(_, parts) => in_parts(
                "explicit gyroscopic step (w + h w'), linear update of the attitude by the new spin (q + h/2 q w)",
                *parts,
            ),
        }
    }
}

impl Alteration {
    /// What it is called.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::OtherMoments(moments, axes) => {
                let [x, y, z] = moments.map(significant).into();
                let degrees = axes.angle().to_degrees();
                let about = format!(" about axes turned by {degrees:.1} degrees from the record's");
                format!("other moments ({x}, {y}, {z}){}", if degrees < 0.05 { "" } else { &about })
            }
            Self::Damped { factor, rate, when, term, .. } => {
                let (lost, rate) = (1.0 - factor, readable(*rate));
                let when = match when {
                    When::Before => ", before the gyroscopic term",
                    When::Beside => ", with the gyroscopic term (both of the spin before the step)",
                    When::After => ", after the gyroscopic term",
                    When::Turned => ", after the turn",
                    When::Open => "",
                };
                let term =
                    if *term == 1.0 { String::new() } else { format!(", {}", Self::Term(*term).name()) };
                format!("damping left on ({rate}/s: {lost:.3e} of the spin each step{when}){term}")
            }
            Self::Term(times) => match TERMS.iter().find(|term| (term.0 - times).abs() < NEAR_A_TERM[0]) {
                Some((_, words)) => (*words).into(),
                None => format!("{} times the gyroscopic term", significant(*times)),
            },
            Self::TermOrTimes(times) => {
                format!("either {}, or {}", Self::Term(*times).name(), Self::Times(*times).name())
            }
            Self::Times(times) => {
                let (size, [way, _]) = by_how_much(*times);
                format!("times that are {size} times too {way}")
            }
            Self::Turned(turn) => match turn {
                Turn::Old => "the attitude turned by the old spin (or each spin written a row early)",
                Turn::Late => "each spin written a row late",
                Turn::Early => "each spin written a row early",
                Turn::BodyInWorld => "the attitude turned on the wrong side (dq * q by a spin in body axes)",
                Turn::WorldInBody => "the attitude turned on the wrong side (q * dq by a spin in world axes)",
                Turn::TwiceBefore | Turn::TwiceAfter => "the attitude turned twice a step",
                Turn::Own => "the attitude turned by the new spin in the world, not by its own turn",
                Turn::Otherwise => "the spin alone (not the attitude) by this rule",
            }
            .into(),
            Self::Capped(most) => format!("a cap on the spin ({} rad/s)", significant(*most)),
        }
    }
}

/// Multiples of the gyroscopic term that are common mistakes.
pub(crate) const TERMS: [(f64, &str); 3] = [
    (0.5, "half of the gyroscopic term"),
    (-1.0, "the gyroscopic term with the wrong sign"),
    (2.0, "twice the gyroscopic term"),
];

impl Rule {
    /// What it is called.
    #[must_use]
    pub fn name(&self) -> String {
        match &self.alteration {
            Some(Alteration::Times(times)) if self.base.is_still() => {
                let times = to_four_places(*times);
                format!("the attitude turned {times} times as far as the spin says, {}", self.base.name())
            }
            Some(alteration) => format!("{}, {}", alteration.name(), self.base.name()),
            None => self.base.name(),
        }
    }

    /// Physics engines known to use it, with their settings, and with the number of their steps per row where
    /// that is not one.
    #[must_use]
    pub fn engines(&self) -> Vec<String> {
        PHYSICS_ENGINES.iter().filter_map(|engine| Some(named(engine, self.steps_of(engine)?))).collect()
    }

    /// The number of the engine's steps in one step of this rule, if the engine uses this rule.
    pub(crate) fn steps_of(&self, engine: &PhysicsEngine) -> Option<u32> {
        let has = |method| engine.method == method;
        match (self.base, self.alteration) {
            (Base::Straight(method, parts), None) => (engine.limits.straight && has(method)).then_some(parts),
            (Base::Method(..), None) if engine.limits.straight => None,
            // However many parts, the spin is the same.
            (Base::Method(Method::ConstantSpin, _), None) => has(Method::ConstantSpin).then_some(1),
            (Base::Method(method, parts), None) => {
                (has(method) && parts % engine.parts == 0).then_some(parts / engine.parts)
            }
            (Base::Engine(this), None) => {
                let is_same = has(this.method) && (engine.parts, engine.limits) == (this.parts, this.limits);
                is_same.then_some(1)
            }
            _ => None,
        }
    }
}

/// An engine, and its steps per row.
type Steps = (&'static PhysicsEngine, u32);

/// The engines that the record names and that use one of these rules.
pub(crate) fn engines<'a>(header: &str, rules: impl Iterator<Item = &'a Rule> + Clone) -> Vec<Steps> {
    let words = header.split(|c: char| !c.is_alphanumeric());
    let called = |engine: &&PhysicsEngine| words.clone().any(|word| engine.is_called(word));
    let fitting = |engine| Some((engine, rules.clone().find_map(|rule: &Rule| rule.steps_of(engine))?));
    PHYSICS_ENGINES.iter().filter(called).filter_map(fitting).collect()
}

/// The rules named first: the best, and those with the same steps that an engine uses; the rule of the
/// record's own engine is the first of all.
pub(crate) fn first_named(best: &Rule, alike: &[Rule], own: Option<&PhysicsEngine>) -> Vec<Rule> {
    let known = alike.iter().filter(|rule| !rule.engines().is_empty());
    let mut rules: Vec<Rule> = std::iter::once(best).chain(known).copied().collect();
    rules.sort_by_key(|rule| own.is_some_and(|own| rule.steps_of(own).is_none()));
    rules.truncate(RULES_NAMED);
    rules
}

/// The engines named: the record's own, or those that use the rules named first; both, if there are several
/// such rules.
pub(crate) fn engine_names(own: &[Steps], leading: &[Rule]) -> Vec<String> {
    let mut names: Vec<String> = own.iter().map(|&(engine, steps)| named(engine, steps)).collect();
    if names.is_empty() || leading.len() > 1 {
        for name in leading.iter().flat_map(Rule::engines) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
    }
    names
}

/// The settings to use in these engines, or, without any, in those that use these rules.
pub(crate) fn settings(own: &[Steps], rules: &[Rule]) -> Vec<String> {
    let goes = |engine: &PhysicsEngine| rules.iter().any(|rule| rule.steps_of(engine).is_some());
    let is_own = |engine: &PhysicsEngine| own.iter().any(|(other, _)| *other == engine);
    let named = |engine: &&PhysicsEngine| if own.is_empty() { goes(engine) } else { is_own(engine) };
    let of = |engine: &PhysicsEngine| engine.remedy.map(|remedy| format!("{}: {remedy}", engine.name));
    PHYSICS_ENGINES.iter().filter(named).filter_map(of).collect()
}

/// An engine with its version and setting, and its steps per row where they are several.
pub(crate) fn named(engine: &PhysicsEngine, steps: u32) -> String {
    let version = engine.version.map_or(String::new(), |version| format!(" {version}"));
    let steps = if steps == 1 { String::new() } else { format!(", {steps} steps per row") };
    format!("{}{version}, {}{steps}", engine.name, engine.setting)
}

fn limits(limits: &Limits) -> String {
    let [turn, spin] = [limits.turn, limits.spin].map(|angle| angle.map(f64::to_degrees));
    let turn = turn.map(|angle| format!("a turn of more than {angle:.0} degrees a step is too small"));
    let cut = |most| format!("spin is cut at {} rad/s along each axis of the world", significant(most));
    let spin = spin.map(|angle| format!("spin is slowed to {angle:.0} degrees a step"));
    let rate = limits.rate.map(|most| format!("the body is reset beyond {most:e} rad/s or rad/s2"));
    let all = [turn, limits.component.map(cut), spin, rate];
    all.into_iter().flatten().collect::<Vec<_>>().join("; ")
}

/// The rules that fit as well, each once; in a record without spins with those that make the same attitudes
/// by spins a row apart: a straight turn by the new spin is explicit Euler's by the old.
pub(crate) fn with_unseen(sought: bool, best: &Rule, alike: impl Iterator<Item = Rule>) -> Vec<Rule> {
    use Method::{ExplicitEuler, SemiImplicitEuler};
    let unseen = |rule: &Rule| {
        let base = match rule.base {
            Base::Straight(SemiImplicitEuler, parts) => Base::Method(ExplicitEuler, parts),
            Base::Method(ExplicitEuler, parts) => Base::Straight(SemiImplicitEuler, parts),
            _ => return None,
        };
        // The place of damping is a row apart too.
        let alteration = rule.alteration.map(|x| match x {
            Alteration::Damped { factor, rate, steps, term, .. } => {
                Alteration::Damped { factor, rate, when: When::Open, steps, term }
            }
            other => other,
        });
        sought.then_some(Rule { base, alteration })
    };
    let alike: Vec<_> = alike.collect();
    let more: Vec<_> = std::iter::once(best).chain(&alike).filter_map(unseen).collect();
    let (mut all, mut names) = (Vec::new(), vec![best.name()]);
    for rule in alike.into_iter().chain(more) {
        if !names.contains(&rule.name()) {
            names.push(rule.name());
            all.push(rule);
        }
    }
    all
}
