//! The body of a record, and how each rule that may have made it takes a row one step further.

use crate::read::{Pair, Row, angle_between, ordered};
use crate::rule::{Alteration, Base, Rule, Steps, Turn, When};
use crate::thresholds::*;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::{Engine, PositionStage, State, System, Torque};
use tumbling::{Body, Error, Inertia, attitude, dynamics::euler};
use tumbling_engines::{Limits, parted, turned_straight};

/// An attitude, body to world, and a spin in body axes, rad/s.
type End = (Quaternion<f64>, Vector3<f64>);

/// `q` turned by the spin for `h` seconds.
fn turned(q: &Quaternion<f64>, omega: &Vector3<f64>, h: f64) -> Quaternion<f64> {
    attitude::product(q, &attitude::turn(&(omega * h)))
}

/// What becomes of a rule's step where the attitude does not turn as the rule has it; `by` is the turn by a
/// spin.
fn turned_otherwise(
    turn: Turn,
    (start, old): (&Quaternion<f64>, &Vector3<f64>),
    (q, omega): End,
    by: impl Fn(&Quaternion<f64>, &Vector3<f64>) -> Quaternion<f64>,
) -> End {
    let inside = |q: &Quaternion<f64>| attitude::product(&start.conjugate(), q) / start.norm_squared();
    let seen = |from: &Quaternion<f64>, at: &Quaternion<f64>| {
        let turned = attitude::rotation_matrix(at).tr_mul(&(attitude::rotation_matrix(from) * omega));
        turned / (at.norm_squared() * from.norm_squared())
    };
    match turn {
        Turn::Old | Turn::Late | Turn::Early | Turn::Otherwise => (by(start, old), omega),
        Turn::BodyInWorld => (attitude::product(&inside(&q), start), omega),
        Turn::WorldInBody => {
            let end = attitude::product(&attitude::product(start, &q), &start.conjugate());
            let end = end / start.norm_squared();
            (end, seen(&q, &end))
        }
        Turn::TwiceBefore => (attitude::product(&by(start, old), &inside(&q)), omega),
        Turn::TwiceAfter => (by(&q, &omega), omega),
        Turn::Own => {
            let omega = seen(&q, start);
            (by(start, &omega), omega)
        }
    }
}

/// The body that a record is of.
#[derive(Debug, Clone)]
pub(crate) struct Subject {
    /// The moments, relative to `unit`.
    pub moments: Vector3<f64>,
    /// A torque constant in the world, relative to `unit`.
    pub torque: Option<Vector3<f64>>,
    /// A power of two that makes products of momenta numbers where moments are very large or small, kg m².
    pub unit: f64,
    pub system: System<f64>,
}

impl Subject {
    pub(crate) fn new(moments: Vector3<f64>, torque: Option<Vector3<f64>>) -> Result<Self, Error> {
        let size = moments.amax().log2().floor();
        let unit = if size.abs() < FAR_FROM_ONE { 1.0 } else { size.exp2() };
        let (moments, torque) = (moments / unit, torque.map(|torque| torque / unit));
        let torques = torque.map(|torque| vec![Torque::InWorld(torque)]).unwrap_or_default();
        Ok(Self { moments, torque, unit, system: System::with(moments.try_into()?, torques)? })
    }

    /// Whether the gyroscopic term is more than rounding in the changes of spin that these steps should have.
    pub(crate) fn should_change(&self, pairs: &[Pair], floor: f64) -> bool {
        let [smallest, _, largest] = ordered(&self.moments);
        self.moments[smallest] < self.moments[largest]
            && pairs.iter().any(|pair| {
                let rate = euler::angular_acceleration(&self.moments, &pair.from.omega, &Vector3::zeros());
                rate.norm() * pair.h > STILL * floor * pair.from.omega.norm()
            })
    }

    fn motion(&self, state: &Row) -> State<f64> {
        State { attitude: state.start(), momentum: self.system.momentum(&state.omega) }
    }

    /// A base's step.
    fn based(&self, base: Base, from: &Row, h: f64) -> Option<End> {
        let start = from.start();
        let end = |end: State<f64>| (end.attitude, self.system.omega(&end.momentum));
        match base {
            Base::Exact => {
                let motion = FreeMotion::new(self.moments.try_into().ok()?, &from.omega).ok()?;
                let after = motion.at(h).ok()?;
                Some((start * after.attitude.into_inner(), after.omega))
            }
            Base::Method(method, parts) | Base::Straight(method, parts) => {
                let straight = matches!(base, Base::Straight(..));
                let limits = Limits { straight, ..Limits::NONE };
                parted(method, parts, &limits, &self.system, &self.motion(from), h).ok().map(end)
            }
            Base::Engine(engine) => engine.step(&self.system, &self.motion(from), h).ok().map(end),
            Base::PositionStage(parts) => self.staged(parts.max(1), from, h),
            Base::FrozenTensor(first, steps) => {
                // In the axes that the body had there the tensor is frozen at the identity.
                let from = Row { attitude: Some(attitude::product(&first.conjugate(), &start)), ..*from };
                let (q, omega) = self.frozen(steps, &from, h)?;
                Some((attitude::product(&first, &q), omega))
            }
            Base::MomentumForSpin(mass) => {
                let momentum = self.system.momentum(&from.omega);
                let q = turned(&start, &(momentum / mass), h);
                let world = attitude::rotation_matrix(&start) * momentum;
                Some((q, self.system.omega(&attitude::rotation_matrix(&q).tr_mul(&world))))
            }
        }
    }

    /// The library's position stage in this number of parts.
    fn staged(&self, parts: u32, from: &Row, h: f64) -> Option<End> {
        let stage = PositionStage::new(&self.moments).ok()?;
        let attitude = UnitQuaternion::new_normalize(from.start()).into_inner();
        let part = h / f64::from(parts);
        let start = (attitude, attitude::rotation_matrix(&attitude) * from.omega);
        let (attitude, omega) = (0..parts).try_fold(start, |(attitude, omega), _| {
            let end = stage.step(&attitude, &omega, part);
            // No parts: it does not step so fast a spin.
            (end.parts > 0).then_some((end.attitude, end.omega))
        })?;
        Some((attitude, attitude::rotation_matrix(&attitude).tr_mul(&omega)))
    }

    /// The step with the tensor frozen as it stands at the identity.
    fn frozen(&self, steps: Steps, from: &Row, h: f64) -> Option<End> {
        let start = from.start();
        if steps == Steps::Fourth {
            let [a, b, c] = self.moments.into();
            let (body, start) = (Inertia::from_moments(a, b, c).ok()?, UnitQuaternion::new_normalize(start));
            let body = Body::spinning(body, start, &from.omega).ok()?;
            let run = Engine::Frozen.run(&body, h, 1).ok()?;
            let end = run.last().unwrap_or(&body);
            return Some((end.attitude().into_inner(), end.omega_body()));
        }
        let world = attitude::rotation_matrix(&start) * from.omega;
        let world = world + euler::angular_acceleration(&self.moments, &world, &Vector3::zeros()) * h;
        let q = attitude::product(&attitude::turn(&(world * h)), &start);
        Some((q, attitude::rotation_matrix(&q).tr_mul(&world)))
    }

    /// The attitude and spin that a rule makes of a row.
    fn after(&self, rule: &Rule, from: &Row, h: f64) -> Option<End> {
        let start = from.start();
        let base = |from: &Row, h: f64| self.based(rule.base, from, h);
        let by = |q: &Quaternion<f64>, omega: &Vector3<f64>| match rule.base {
            Base::Straight(..) => turned_straight(q, omega, h),
            _ => turned(q, omega, h),
        };
        let with = |omega: Vector3<f64>| (by(&start, &omega), omega);
        // The spin's own equation has no other term: a multiple of it acts for that multiple of the time.
        let stepped = |from: &Row, term: f64| match term {
            1.0 => base(from, h),
            _ => base(from, h * term).map(|end| with(end.1)),
        };
        let Some(alteration) = rule.alteration else { return base(from, h) };
        match alteration {
            Alteration::Damped { factor, rate, when, steps: steps @ 2.., term } => {
                let alteration = Alteration::Damped { factor, rate, when, steps: 1, term };
                let one = rule.base.in_parts(rule.base.parts() / steps).but(alteration);
                let end = (0..steps).try_fold(*from, |row, _| self.next(&one, &row, h / f64::from(steps)))?;
                Some((end.start(), end.omega))
            }
            Alteration::OtherMoments(moments, axes) => {
                let (q, omega) = (start * axes.into_inner(), axes.inverse() * from.omega);
                let from = Row { attitude: Some(q), omega, ..*from };
                let system = System::of_numbers(moments, Vec::new());
                let other = Self { moments, torque: None, unit: 1.0, system };
                let (q, omega) = other.based(rule.base, &from, h)?;
                Some((q * axes.inverse().into_inner(), axes * omega))
            }
            Alteration::Damped { factor, when, term, .. } => match when {
                When::Before => stepped(&Row { omega: from.omega * factor, ..*from }, term),
                When::Beside => Some(with(stepped(from, term)?.1 - from.omega * (1.0 - factor))),
                When::After => Some(with(stepped(from, term)?.1 * factor)),
                When::Turned | When::Open => stepped(from, term).map(|(q, omega)| (q, omega * factor)),
            },
            Alteration::Term(times) | Alteration::TermOrTimes(times) => Some(with(base(from, h * times)?.1)),
            Alteration::Times(times) => base(from, h * times),
            Alteration::Turned(turn) => {
                Some(turned_otherwise(turn, (&start, &from.omega), base(from, h)?, by))
            }
            Alteration::Capped(most) => {
                let (q, omega) = base(from, h)?;
                let speed = omega.norm();
                Some(if speed <= most { (q, omega) } else { with(omega * (most / speed)) })
            }
        }
    }

    /// One step more, of a body that goes by a rule.
    pub(crate) fn next(&self, rule: &Rule, from: &Row, h: f64) -> Option<Row> {
        let (q, omega) = self.after(rule, from, h)?;
        let attitude = from.attitude.map(|_| q);
        let sound = omega.iter().chain(q.coords.iter()).all(|x| x.is_finite());
        sound.then_some(Row { t: from.t + h, attitude, omega, ..*from })
    }

    /// The spin that a rule makes of a row.
    pub(crate) fn spin_after(&self, rule: &Rule, pair: &Pair) -> Option<Vector3<f64>> {
        self.after(rule, &pair.from, pair.h).map(|end| end.1)
    }

    /// How far a rule's second step is from the recorded one, if its first is the recorded one: the spin that
    /// it takes for that is the rule's own. As a turn in rad and what is left of the first step, relative to
    /// the angle turned.
    pub(crate) fn left_of_turns(&self, rule: &Rule, pair: &Pair) -> Option<(Vector3<f64>, f64)> {
        let ([_, omega], least) = self.spins_of_turn(rule, pair)?;
        let from = self.next(rule, &Row { omega, ..pair.to }, pair.h)?;
        let to = Row { attitude: Some(pair.to.ahead?.1), ..pair.to };
        let turn = pair.from.omega.norm() * pair.h;
        Some((Pair { from, to, h: pair.h }.turn()? / turn, least / turn))
    }

    /// The spins before and after with which a rule's step is the recorded turn, and what is left of it, rad.
    pub(crate) fn spins_of_turn(&self, rule: &Rule, pair: &Pair) -> Option<([Vector3<f64>; 2], f64)> {
        let mut omega = pair.from.omega;
        let mut least = f64::INFINITY;
        let mut after = None;
        for _ in 0..RULE_ROUNDS {
            let (q, spin) = self.after(rule, &Row { omega, ..pair.from }, pair.h)?;
            let left = Pair { from: Row { attitude: Some(q), ..pair.to }, ..*pair }.turn()?;
            let size = left.norm();
            if size >= least || size.is_nan() {
                break;
            }
            (least, after) = (size, Some([omega, spin]));
            omega += left / pair.h;
        }
        Some((after?, least))
    }

    /// How far a rule's step is from the recorded one: of the spin relative to the larger of its values
    /// before and after, of the attitude in rad, relative to the angle turned where that is over 1. Infinite
    /// where the rule takes no such step.
    pub(crate) fn residual(&self, rule: &Rule, pair: &Pair) -> f64 {
        if pair.to.ahead.is_some() {
            let off = self.left_of_turns(rule, pair).map(|(second, first)| second.norm() + first);
            return off.filter(|off| off.is_finite()).unwrap_or(f64::INFINITY);
        }
        let Some((mut q, omega)) = self.after(rule, &pair.from, pair.h) else { return f64::INFINITY };
        let based = |omega| self.based(rule.base, &Row { omega, ..pair.from }, pair.h);
        if rule.alteration == Some(Alteration::Turned(Turn::Late)) {
            // The spin of this row stands in the next one.
            q = based(pair.to.omega).map_or(q, |end| end.0);
        } else if rule.alteration == Some(Alteration::Turned(Turn::Early))
            && !matches!(rule.base, Base::Straight(_, 1))
        {
            // That of this row stood in the last one: it is the one that the rule takes here. (A straight
            // turn is by the new spin, which this row has.)
            let mut before = pair.from.omega;
            for _ in 0..RULE_ROUNDS {
                let Some((turned, after)) = based(before) else { return f64::INFINITY };
                let left = pair.from.omega - after;
                (q, before) = (turned, before + left);
                if left.norm() <= f64::EPSILON * after.norm() {
                    break;
                }
            }
        }
        let speed = pair.to.omega.norm().max(pair.from.omega.norm()).max(f64::MIN_POSITIVE);
        let spin = (omega - pair.to.omega).norm() / speed;
        let turn = match (pair.from.attitude, pair.to.attitude) {
            (Some(_), Some(to)) if !rule.is_of_spin() => {
                angle_between(&q, &to) / (pair.to.omega.norm() * pair.h).max(1.0)
            }
            _ => 0.0,
        };
        // The larger of a number and of none is the number.
        if spin.is_nan() || turn.is_nan() { f64::INFINITY } else { spin.max(turn) }
    }
}
