//! Scenes: bodies let go, what acts on them, what is asked of them; answered in the cheapest way that is accurate enough.
//!
//! A [`Scene`] is a plain value. [`Scene::plan`] decides for one of its bodies how to answer: a [`Plan`] holds what its [`Way`] uses and
//! nothing else, says in words what it leaves out ([`Plan::explain`]), and gives the states one after another ([`Plan::states`]), so that
//! a long run takes no more room than a short one.
//!
//! ```
//! use nalgebra::Vector3;
//! use tumbling::scene::{Scene, Times, Toss, Wants, Way};
//!
//! // A racket, a flip: when, and nothing else. No motion is computed.
//! let racket = Toss::spinning(Vector3::new(0.00121, 0.01638, 0.01748), Vector3::new(0.01, 10.0, 0.0));
//! let wants = Wants { flips: true, ..Wants::NOTHING };
//! let scene = Scene::new(vec![racket], vec![], Times::every(0.1, 10.0), wants, 1e-9)?;
//! let plan = scene.plan(0)?;
//! assert!(matches!(plan.way(), Way::Nothing));
//! assert_eq!(plan.flips()?.count(), 5);
//! # Ok::<(), tumbling::Error>(())
//! ```
//!
//! # Accuracy
//!
//! One number: the most that any state may be off, as the angle of the attitude (rad), as the spin beside the largest spin that the
//! motion has had, and as the energy beside the largest that it has had. A free body is answered in closed form, as exactly as its conditioning lets it be; an
//! accuracy beyond that is refused with what can be had. Under a torque a method and a step are chosen, and then tried: the run at that
//! step is held against a finer one, and it is refined until the two agree to half of the accuracy, or to a tenth if the
//! coarser is to answer. That is evidence, not proof.

mod by;
mod cost;
mod driven;
mod explain;
mod free;
mod plan;
mod polhode;
mod states;

pub use cost::Cost;
pub use plan::{Driven, Plan, Way};
pub use polhode::Polhode;
pub use states::{Answer, States};

use crate::body::attitude;
use crate::error::{Error, Refusal, finite, finite_vector, not_negative, positive};
use crate::inertia::{Inertia, PrincipalMoments};
use crate::step::Torque;
use nalgebra::{UnitQuaternion, Vector3};

/// What a body is let go with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LetGo {
    /// With this angular velocity in body axes, rad/s.
    Spin(Vector3<f64>),
    /// With this angular momentum in world axes, kg m²/s.
    Momentum(Vector3<f64>),
}

/// A part of a [`Toss`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TossPart {
    /// The diagonal of the tensor.
    Moments,
    /// The tensor with its products.
    Products,
    /// The attitude.
    Attitude,
    /// The spin or momentum.
    Start,
}

/// A body as it is let go. A plain value: it is checked when it is [planned](Scene::plan).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Toss {
    /// The diagonal of its inertia tensor, kg m²: its principal moments where the products are zero.
    pub moments: Vector3<f64>,
    /// The off-diagonal entries xy, xz, yz of its tensor, kg m², signed so that `L = I w` holds. Damping of such a body must be the same
    /// along all axes: that of one axis is told along the principal axes, and these have no order to go by.
    pub products: Vector3<f64>,
    /// Body to world.
    pub attitude: UnitQuaternion<f64>,
    /// What it is let go with.
    pub with: LetGo,
}

impl Toss {
    /// A body of these principal moments (kg m²) with this spin (rad/s) along the same axes, which are the world's at the start.
    #[must_use]
    pub fn spinning(moments: Vector3<f64>, omega: Vector3<f64>) -> Self {
        let (products, attitude) = (Vector3::zeros(), UnitQuaternion::identity());
        Self { moments, products, attitude, with: LetGo::Spin(omega) }
    }

    /// The part that makes it no body, and why; none of a body that can be.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::scene::{Toss, TossPart};
    /// let toss = Toss::spinning(Vector3::new(1.0, 2.0, 3.5), Vector3::x());
    /// assert_eq!(toss.fault().map(|(part, _)| part), Some(TossPart::Moments));
    /// ```
    #[must_use]
    pub fn fault(&self) -> Option<(TossPart, Error)> {
        self.parts().err()
    }

    /// In its principal axes, checked.
    fn principal(&self) -> Result<Principal, Error> {
        self.parts().map_err(|(_, error)| error)
    }

    fn parts(&self) -> Result<Principal, (TossPart, Error)> {
        let of = |part| move |error| (part, error);
        let attitude = attitude::checked(&self.attitude).map_err(of(TossPart::Attitude))?;
        finite_vector("a product of inertia", &self.products).map_err(of(TossPart::Products))?;
        let (moments, frame) = if self.products == Vector3::zeros() {
            (self.moments, None)
        } else {
            let tensor = Inertia::new(self.moments.into(), self.products.into());
            let axes = tensor.map_err(of(TossPart::Products))?.principal();
            (axes.moments(), Some(axes.rotation()))
        };
        let tensor = if frame.is_some() { TossPart::Products } else { TossPart::Moments };
        let checked = PrincipalMoments::try_from(moments).map_err(of(tensor))?;
        let along = |v: &Vector3<f64>| frame.map_or(*v, |frame| frame.inverse() * v);
        let start = of(TossPart::Start);
        let omega = match &self.with {
            LetGo::Spin(omega) => {
                finite_vector("the spin", omega).map_err(start)?;
                along(omega)
            }
            LetGo::Momentum(momentum) => {
                finite_vector("the angular momentum", momentum).map_err(start)?;
                along(&(attitude.inverse() * momentum)).component_div(&moments)
            }
        };
        finite_vector("the spin", &omega).map_err(start)?;
        let world = frame.map_or(attitude, |frame| attitude * frame);
        // What the way to here has rounded: axes of a tensor to the size of its largest moment, a turned vector to its length.
        let (greatest, length) = (moments.max(), moments.component_mul(&omega).norm());
        let turned = frame.is_some() || attitude != UnitQuaternion::identity();
        let rounded = Rounded {
            moments: if frame.is_some() { Vector3::repeat(greatest) } else { moments },
            omega: match (&self.with, frame) {
                (LetGo::Momentum(_), Some(_)) => {
                    // The moment that the momentum is divided by is rounded too.
                    moments.zip_map(&omega, |moment, w| (length + w.abs() * greatest) / moment)
                }
                (LetGo::Momentum(_), None) if turned => moments.map(|moment| length / moment),
                (LetGo::Spin(_), Some(_)) => Vector3::repeat(omega.norm()),
                _ => omega.abs(),
            },
        };
        Ok(Principal { moments: checked, omega, frame, world, attitude, rounded })
    }
}

/// A body along its principal axes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Principal {
    moments: PrincipalMoments,
    omega: Vector3<f64>,
    /// Principal axes to body axes, where they are not the same.
    frame: Option<UnitQuaternion<f64>>,
    /// Principal axes to world, at the start.
    world: UnitQuaternion<f64>,
    /// Body to world, at the start.
    attitude: UnitQuaternion<f64>,
    rounded: Rounded,
}

/// The numbers of a body along its principal axes, each with what one rounding of it is a share of.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Rounded {
    moments: Vector3<f64>,
    omega: Vector3<f64>,
}

impl Principal {
    fn in_body(&self, vector: Vector3<f64>) -> Vector3<f64> {
        self.frame.map_or(vector, |frame| frame * vector)
    }
}

/// When states are asked for, s from the start.
#[derive(Debug, Clone, PartialEq)]
pub enum Times {
    /// At these, none before the start and none before the one ahead of it in the list.
    Given(Vec<f64>),
    /// At the start, and then every so often up to the end of the span, which is one of the times where it is a multiple.
    Every {
        /// From one to the next.
        step: f64,
        /// How long the scene lasts. Zero answers the start.
        span: f64,
    },
}

/// A multiple is meant where the quotient is one to so many roundings: 0.3 / 0.1 is one below 3.
const MULTIPLE: f64 = 4.0 * f64::EPSILON;

impl Times {
    /// Every `step` seconds from 0 to `span`.
    #[must_use]
    pub const fn every(step: f64, span: f64) -> Self {
        Self::Every { step, span }
    }

    /// Whether a scene can have them.
    ///
    /// # Errors
    /// None at all; one that is not finite, before the start or before the one ahead of it; more than `f64` counts.
    pub fn validate(&self) -> Result<(), Error> {
        match self {
            Self::Given(times) => {
                if times.is_empty() {
                    return Err(Refusal::TooFew { what: "times", count: 0, needed: 1 }.into());
                }
                for &time in times {
                    not_negative("a time", time)?;
                }
                match times.windows(2).find(|pair| pair[0] > pair[1]) {
                    Some(pair) => Err(Refusal::Order {
                        smaller: "a time",
                        small: pair[0],
                        larger: "the one after it",
                        large: pair[1],
                    }
                    .into()),
                    None => Ok(()),
                }
            }
            Self::Every { step, span } => {
                let steps = not_negative("the span", *span)? / positive("the time between states", *step)?;
                let most = 1.0 / f64::EPSILON;
                if steps > most {
                    return Err(Refusal::Order {
                        smaller: "the number of states",
                        small: steps,
                        larger: "the greatest that f64 counts one by one",
                        large: most,
                    }
                    .into());
                }
                Ok(())
            }
        }
    }

    /// How many there are.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // checked: whole, and below 2^53
    pub fn count(&self) -> u64 {
        match self {
            Self::Given(times) => times.len() as u64,
            Self::Every { step, span } => {
                let steps = span / step;
                let whole = steps.round();
                let whole = if (steps - whole).abs() <= MULTIPLE * steps { whole } else { steps.floor() };
                whole as u64 + 1
            }
        }
    }

    /// The one of this number, s, from 0; the last for a number beyond.
    #[must_use]
    pub fn nth(&self, n: u64) -> f64 {
        self.within(n.min(self.count().saturating_sub(1)))
    }

    /// The one of this number, which is below the count.
    #[allow(clippy::cast_precision_loss)]
    fn within(&self, n: u64) -> f64 {
        match self {
            Self::Given(times) => {
                usize::try_from(n).ok().and_then(|n| times.get(n)).copied().unwrap_or_default()
            }
            Self::Every { step, span } => (n as f64 * step).min(*span),
        }
    }

    /// The last instant of the scene.
    #[must_use]
    pub fn end(&self) -> f64 {
        match self {
            Self::Given(times) => times.last().copied().unwrap_or_default(),
            Self::Every { span, .. } => *span,
        }
    }
}

/// What is asked of each body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Wants {
    /// The angular velocity in body axes, at each time.
    pub spin: bool,
    /// The attitude, body to world, at each time.
    pub attitude: bool,
    /// The kinetic energy, at each time.
    pub energy: bool,
    /// The angle between spin and momentum, at each time.
    pub gap: bool,
    /// The instants up to the end at which the spin along the middle axis changes sign. Of free bodies.
    pub flips: bool,
    /// The path of the spin in the body. Of free bodies.
    pub polhode: bool,
}

impl Wants {
    /// None of it.
    pub const NOTHING: Self =
        Self { spin: false, attitude: false, energy: false, gap: false, flips: false, polhode: false };
}

/// Bodies that do not touch, what acts on each of them, what is asked, and how right the answer must be.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    bodies: Vec<Toss>,
    torques: Vec<Torque<f64>>,
    times: Times,
    wants: Wants,
    accuracy: f64,
}

impl Scene {
    /// Bodies under the same torques, asked for the same things at the same times. Torques that are zero are left out.
    ///
    /// What is wrong with one body is said when that body is [planned](Self::plan); the others are answered.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::scene::{Scene, Times, Toss, Wants};
    /// let good = Toss::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 1.0, 0.2));
    /// let bad = Toss::spinning(Vector3::new(1.0, 2.0, 3.5), Vector3::new(0.1, 1.0, 0.2));
    /// let wants = Wants { spin: true, ..Wants::NOTHING };
    /// let scene = Scene::new(vec![good, bad, good], vec![], Times::every(1.0, 2.0), wants, 1e-9)?;
    /// assert!(scene.plan(0).is_ok() && scene.plan(2).is_ok());
    /// assert!(scene.plan(1).unwrap_err().to_string().starts_with("body 1: no body has principal moments"));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// No body; a torque that is not valid; no time, one that is not finite, before the start or before the one ahead of it; more
    /// times than `f64` counts; an accuracy that is not above zero and below 1, or so fine that no state has it (2 epsilon).
    pub fn new(
        bodies: Vec<Toss>,
        torques: Vec<Torque<f64>>,
        times: Times,
        wants: Wants,
        accuracy: f64,
    ) -> Result<Self, Error> {
        if bodies.is_empty() {
            return Err(Refusal::TooFew { what: "bodies", count: 0, needed: 1 }.into());
        }
        let of_torque = |index, source| Refusal::OfTorque { index, source: Box::new(source) };
        torques
            .iter()
            .enumerate()
            .try_for_each(|(index, torque)| torque.validate().map_err(|source| of_torque(index, source)))?;
        times.validate()?;
        finite("the accuracy", accuracy)?;
        if positive("the accuracy", accuracy)? >= 1.0 {
            return Err(Refusal::NotBelow { what: "the accuracy", value: accuracy, limit: 1.0 }.into());
        }
        if accuracy < 2.0 * f64::EPSILON {
            return Err(Refusal::Unattainable { asked: accuracy, attainable: 2.0 * f64::EPSILON }.into());
        }
        let torques = torques.into_iter().filter(|torque| !driven::is_nothing(torque)).collect();
        Ok(Self { bodies, torques, times, wants, accuracy })
    }

    /// The bodies.
    #[must_use]
    pub fn bodies(&self) -> &[Toss] {
        &self.bodies
    }

    /// The torques on each of them, without those that are zero.
    #[must_use]
    pub fn torques(&self) -> &[Torque<f64>] {
        &self.torques
    }

    /// The times asked for.
    #[must_use]
    pub fn times(&self) -> &Times {
        &self.times
    }

    /// What is asked.
    #[must_use]
    pub fn wants(&self) -> Wants {
        self.wants
    }

    /// How right the answer must be.
    #[must_use]
    pub fn accuracy(&self) -> f64 {
        self.accuracy
    }

    /// How to answer for the body of this number, from 0.
    ///
    /// # Errors
    /// With the number of the body: what is wrong with it, [what it does not have](crate::Refusal::Undefined), an accuracy that [cannot be
    /// had](crate::Refusal::Unattainable), or a motion that leaves `f64`.
    pub fn plan(&self, index: usize) -> Result<Plan<'_>, Error> {
        let of_body = |source| Refusal::OfBody { index, source: Box::new(source) }.into();
        let Some(toss) = self.bodies.get(index) else {
            return Err(Refusal::TooFew {
                what: "bodies",
                count: self.bodies.len(),
                needed: index.saturating_add(1),
            }
            .into());
        };
        Plan::new(self, toss).map_err(of_body)
    }

    /// Answers all of it, body by body and one after the other (the crate `tumbling-scenes` has many side by side): `take` is given the number of each body and its states in order, or what is wrong with it, after which
    /// the next is answered.
    pub fn run(&self, mut take: impl FnMut(usize, Result<Answer, Error>)) {
        for index in 0..self.bodies.len() {
            match self.plan(index) {
                Ok(plan) => plan.states().for_each(|state| take(index, state)),
                Err(error) => take(index, Err(error)),
            }
        }
    }
}
