//! Rules that may have made a record: each takes a row one step further.

use crate::engines::{Limits, PHYSICS_ENGINES, PhysicsEngine};
use crate::laws::unit;
use crate::state::{Pair, Row};
use nalgebra::{Quaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::{Engine, Method, State, System, Torque};
use tumbling::{Body, Inertia, attitude, dynamics::euler};

/// A rule, as a diagnosis names it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Rule {
    /// The motion itself.
    Exact,
    /// A method of the library, with so many parts a step.
    Method(Method, u32),
    /// A physics engine's rule, and what the engine adds to it for a fast body.
    Engine(PhysicsEngine),
    /// The spin in the world by the body's tensor as it stood at the identity.
    FrozenTensor(Steps),
    /// The same by the tensor as it stood at this attitude, the record's first.
    FrozenAt(Quaternion<f64>, Steps),
    /// The momentum, divided by this one number, turns the body.
    MomentumForSpin(f64),
    /// A rule for a body with other moments than the record says.
    OtherMoments(Vector3<f64>, Base),
    /// A rule, and the spin lessened by this factor in each step: after the rule, or before.
    Damped(f64, Base, When),
    /// A rule, and the spin about each axis of the body lessened by a factor of its own in each step.
    DampedByAxis(Vector3<f64>, Base, When),
    /// A rule, and no spin beyond this, rad/s.
    Capped(f64, Base),
    /// A rule, and no turn where a step would turn by this or less, rad.
    SmallTurn(f64, Base),
    /// A rule, and each component of the spin in body axes that is no greater than this, rad/s, put to zero.
    Zeroed(f64, Base),
    /// A rule for the spin, and so many times the turn that it says.
    OtherTurn(f64, Base),
    /// A rule, and steps so many times as long as the record says.
    OtherStep(f64, Base),
    /// The spin stepped so, and the attitude straight by the new one: `q + h/2 q w`, its length put right or not. (By the old spin it is
    /// [`Method::ExplicitEuler`].)
    Straight(Spin),
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

/// What is altered in the compound suspects.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Base {
    /// The motion itself.
    Exact,
    /// A method, with so many parts a step.
    Method(Method, u32),
}

impl Base {
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

    /// In words.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Exact => "the exact motion".into(),
            Self::Method(method, 1) => method.info().name.into(),
            Self::Method(method, parts) => format!("{}, {parts} parts a step", method.info().name),
        }
    }
}

/// The attitude `q + h/2 q w`, of whatever length.
pub(crate) fn straight(q: &Quaternion<f64>, omega: &Vector3<f64>, h: f64) -> Quaternion<f64> {
    q + attitude::product(q, &Quaternion::from_imag(omega * (h / 2.0)))
}

/// A rule alone, with nothing that an engine adds.
pub(crate) fn bare(method: Method, parts: u32) -> PhysicsEngine {
    let engine = PHYSICS_ENGINES[0];
    PhysicsEngine {
        name: method.info().name,
        version: None,
        setting: "",
        method,
        parts,
        limits: Limits::NONE,
        ..engine
    }
}

/// The simple ones, in the order in which they are preferred where several explain a record alike.
pub(crate) fn simple(free: bool, pairs: &[Pair]) -> Vec<Rule> {
    let mut all = Vec::new();
    if free {
        all.push(Rule::Exact);
    }
    for base in Base::all() {
        if let Base::Method(method, parts) = base {
            all.push(Rule::Method(method, parts));
        }
    }
    for &engine in PHYSICS_ENGINES.iter().filter(|engine| engine.limits != Limits::NONE) {
        all.push(Rule::Engine(engine));
        // Bullet's greatest spin is a setting, and may have been raised.
        if let (Some(usual), Some(most)) = (engine.limits.component, greatest(pairs))
            && most > usual * (1.0 + 1e-9)
        {
            let limits = Limits { component: Some(most), ..engine.limits };
            all.push(Rule::Engine(PhysicsEngine { limits, record: None, ..engine }));
        }
    }
    for &method in Method::ALL {
        let rule = Rule::Method(method, 1);
        if !all.contains(&rule) {
            all.push(rule);
        }
    }
    if free {
        all.extend([Rule::Straight(Spin::Kept), Rule::Straight(Spin::Explicit)]);
    }
    all.extend([Rule::FrozenTensor(Steps::First), Rule::FrozenTensor(Steps::Fourth)]);
    all
}

/// The most spin along an axis of the world after any step.
fn greatest(pairs: &[Pair]) -> Option<f64> {
    let along = |pair: &Pair| Some((attitude::rotation_matrix(&pair.from.attitude?) * pair.to.omega).amax());
    pairs.iter().filter_map(along).reduce(f64::max)
}

/// The body that a record is of.
#[derive(Debug, Clone)]
pub(crate) struct Subject {
    pub moments: Vector3<f64>,
    pub torque: Option<Vector3<f64>>,
    pub system: System<f64>,
}

impl Subject {
    pub(crate) fn new(moments: Vector3<f64>, torque: Option<Vector3<f64>>) -> Result<Self, tumbling::Error> {
        let torques = torque.map(|torque| vec![Torque::InWorld(torque)]).unwrap_or_default();
        Ok(Self { moments, torque, system: System::with(moments.try_into()?, torques)? })
    }

    fn motion(&self, state: &Row) -> State<f64> {
        State {
            attitude: state.attitude.unwrap_or_else(Quaternion::identity),
            momentum: self.system.momentum(&state.omega),
        }
    }

    /// The base's step, as attitude and spin.
    fn based(
        &self,
        base: Base,
        from: &Row,
        h: f64,
    ) -> Result<(Quaternion<f64>, Vector3<f64>), tumbling::Error> {
        match base {
            Base::Exact => {
                let after = FreeMotion::new(self.moments.try_into()?, &from.omega)?.at(h)?;
                let start = from.attitude.unwrap_or_else(Quaternion::identity);
                Ok((start * after.attitude.into_inner(), after.omega))
            }
            Base::Method(method, parts) => {
                let end = bare(method, parts).step(&self.system, &self.motion(from), h)?;
                Ok((end.attitude, self.system.omega(&end.momentum)))
            }
        }
    }

    /// The attitude and spin that a rule makes of a row.
    fn after(
        &self,
        rule: &Rule,
        from: &Row,
        h: f64,
    ) -> Result<(Quaternion<f64>, Vector3<f64>), tumbling::Error> {
        let start = from.attitude.unwrap_or_else(Quaternion::identity);
        let turned = |omega: &Vector3<f64>| attitude::product(&start, &attitude::turn(&(omega * h)));
        match rule {
            Rule::Exact => self.based(Base::Exact, from, h),
            Rule::Method(method, parts) => self.based(Base::Method(*method, *parts), from, h),
            Rule::Engine(engine) => {
                let end = engine.step(&self.system, &self.motion(from), h)?;
                Ok((end.attitude, self.system.omega(&end.momentum)))
            }
            Rule::FrozenTensor(Steps::First) => {
                let rotation = attitude::rotation_matrix(&start);
                let world = rotation * from.omega;
                let world = world + euler::angular_acceleration(&self.moments, &world, &Vector3::zeros()) * h;
                let q = attitude::product(&attitude::turn(&(world * h)), &start);
                Ok((q, attitude::rotation_matrix(&q).tr_mul(&world)))
            }
            Rule::FrozenTensor(Steps::Fourth) => {
                let [a, b, c] = self.moments.into();
                let body = Body::spinning(Inertia::from_moments(a, b, c)?, unit(&start), &from.omega)?;
                let run = Engine::Frozen.run(&body, h, 1)?;
                let end = run.last().unwrap_or(&body);
                Ok((end.attitude().into_inner(), end.omega_body()))
            }
            Rule::FrozenAt(first, steps) => {
                // In the axes that the body had at first the tensor is frozen at the identity.
                let from = Row { attitude: Some(attitude::product(&first.conjugate(), &start)), ..*from };
                let (q, omega) = self.after(&Rule::FrozenTensor(*steps), &from, h)?;
                Ok((attitude::product(first, &q), omega))
            }
            Rule::MomentumForSpin(mass) => {
                let momentum = self.system.momentum(&from.omega);
                let q = turned(&(momentum / *mass));
                let world = attitude::rotation_matrix(&start) * momentum;
                Ok((q, self.system.omega(&attitude::rotation_matrix(&q).tr_mul(&world))))
            }
            Rule::OtherMoments(moments, base) => Self::new(*moments, self.torque)?.based(*base, from, h),
            Rule::Damped(factor, base, When::After) => {
                let omega = self.based(*base, from, h)?.1 * *factor;
                Ok((turned(&omega), omega))
            }
            Rule::Damped(factor, base, When::Before) => {
                self.based(*base, &Row { omega: from.omega * *factor, ..*from }, h)
            }
            Rule::DampedByAxis(factors, base, When::After) => {
                let omega = self.based(*base, from, h)?.1.component_mul(factors);
                Ok((turned(&omega), omega))
            }
            Rule::DampedByAxis(factors, base, When::Before) => {
                self.based(*base, &Row { omega: from.omega.component_mul(factors), ..*from }, h)
            }
            Rule::SmallTurn(angle, base) => {
                let (q, omega) = self.based(*base, from, h)?;
                Ok((if omega.norm() * h <= *angle { start } else { q }, omega))
            }
            Rule::Zeroed(least, base) => {
                let (q, omega) = self.based(*base, from, h)?;
                let kept = omega.map(|x| if x.abs() <= *least { 0.0 } else { x });
                Ok((if kept == omega { q } else { turned(&kept) }, kept))
            }
            Rule::OtherTurn(factor, base) => {
                let omega = self.based(*base, from, h)?.1;
                Ok((turned(&(omega * *factor)), omega))
            }
            Rule::OtherStep(factor, base) => self.based(*base, from, h * *factor),
            Rule::Straight(spin) => {
                let rate = match spin {
                    Spin::Kept => Vector3::zeros(),
                    Spin::Explicit => {
                        euler::angular_acceleration(&self.moments, &from.omega, &Vector3::zeros())
                    }
                };
                let after = from.omega + rate * h;
                let q = straight(&start, &after, h);
                Ok((q / q.norm(), after))
            }
            Rule::Capped(most, base) => {
                let (q, omega) = self.based(*base, from, h)?;
                let speed = omega.norm();
                if speed <= *most {
                    return Ok((q, omega));
                }
                let omega = omega * (*most / speed);
                Ok((turned(&omega), omega))
            }
        }
    }

    /// One step more, of a body that goes by a rule.
    pub(crate) fn next(&self, rule: &Rule, from: &Row, h: f64) -> Option<Row> {
        let (q, omega) = self.after(rule, from, h).ok()?;
        let attitude = from.attitude.map(|_| q);
        let sound = omega.iter().chain(q.coords.iter()).all(|x| x.is_finite());
        sound.then_some(Row { t: from.t + h, attitude, omega, ..*from })
    }

    /// The spin that a rule makes of a row.
    pub(crate) fn spin_after(&self, rule: &Rule, pair: &Pair) -> Option<Vector3<f64>> {
        self.after(rule, &pair.from, pair.h).ok().map(|end| end.1)
    }

    /// How far a rule's second step is from the recorded one, if its first is the recorded one: the spin that it takes for that is the
    /// rule's own. In rad, beside the angle turned.
    fn residual_of_turns(&self, rule: &Rule, pair: &Pair, ahead: &Quaternion<f64>) -> Option<f64> {
        let middle = pair.to.attitude?;
        let mut omega = pair.from.omega;
        let mut least = f64::INFINITY;
        let mut after = None;
        for _ in 0..60 {
            let (q, spin) = self.after(rule, &Row { omega, ..pair.from }, pair.h).ok()?;
            let left = Pair { from: Row { attitude: Some(q), ..pair.to }, ..*pair }.turn()?;
            let size = left.norm();
            if size >= least || size.is_nan() {
                break;
            }
            (least, after) = (size, Some(spin));
            omega += left / pair.h;
        }
        let turn = pair.from.omega.norm() * pair.h;
        let (q, _) =
            self.after(rule, &Row { attitude: Some(middle), omega: after?, ..pair.to }, pair.h).ok()?;
        let off = (crate::laws::angle_between(&q, ahead) + least) / turn;
        off.is_finite().then_some(off)
    }

    /// How far a rule's step is from the recorded one: of the spin beside the larger of its values before and after, of the
    /// attitude in rad, beside the angle turned where that is over 1. Infinite where the rule takes no such step.
    pub(crate) fn residual(&self, rule: &Rule, pair: &Pair) -> f64 {
        if let Some((_, ahead)) = pair.to.ahead {
            return self.residual_of_turns(rule, pair, &ahead).unwrap_or(f64::INFINITY);
        }
        let Ok((q, omega)) = self.after(rule, &pair.from, pair.h) else { return f64::INFINITY };
        let speed = pair.to.omega.norm().max(pair.from.omega.norm()).max(f64::MIN_POSITIVE);
        let spin = (omega - pair.to.omega).norm() / speed;
        let turn = match (pair.from.attitude, pair.to.attitude) {
            (Some(_), Some(to)) => {
                crate::laws::angle_between(&q, &to) / (pair.to.omega.norm() * pair.h).max(1.0)
            }
            _ => 0.0,
        };
        let worst = spin.max(turn);
        if worst.is_nan() { f64::INFINITY } else { worst }
    }
}
