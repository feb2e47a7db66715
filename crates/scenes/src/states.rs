//! The states of a body, one after another.

use crate::error::Error;
use crate::plan::{Plan, energy};
use crate::scene::Scene;
use crate::step_control::{Stepping, Stop};
use crate::strategy::{Driven, Strategy};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::{Inertia, attitude};

/// A body at one time: the outputs requested.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// s from the start.
    pub time: f64,
    /// Angular velocity in body axes, rad/s.
    pub spin: Option<Vector3<f64>>,
    /// Body to world.
    pub attitude: Option<UnitQuaternion<f64>>,
    /// Kinetic energy, J.
    pub energy: Option<f64>,
    /// The angle between spin and momentum, rad.
    pub angle_to_momentum: Option<f64>,
}

/// The states of one body, in order of time. After an error there are no more.
#[derive(Debug, Clone)]
pub struct States<'a> {
    plan: &'a Plan<'a>,
    next: u64,
    end: u64,
    /// Of a driven body, once its first state is requested.
    stepping: Option<Stepping<'a>>,
    /// The number of its stops that are behind it.
    stops: usize,
}

/// Spin along the principal axes, and attitude of the body.
type SpinAndAttitude = (Option<Vector3<f64>>, Option<UnitQuaternion<f64>>);

impl Scene {
    /// Answers all of it, one body after the other ([`batch`](crate::batch) answers many side by side):
    /// `take` gets the number of each body with its states in order of time, or with what is wrong with it;
    /// then the next is answered.
    pub fn run(&self, mut take: impl FnMut(usize, Result<Answer, Error>)) {
        for index in 0..self.bodies().len() {
            match self.plan(index) {
                Ok(plan) => plan.states().for_each(|state| take(index, state)),
                Err(error) => take(index, Err(error)),
            }
        }
    }
}

impl Plan<'_> {
    /// The states at the times of the scene, in order, one at a time.
    #[must_use]
    pub fn states(&self) -> States<'_> {
        States::new(self)
    }
}

impl<'a> States<'a> {
    fn new(plan: &'a Plan<'a>) -> Self {
        Self { plan, next: 0, end: plan.scene.times().count(), stepping: None, stops: 0 }
    }

    /// The number of states still to come.
    #[must_use]
    pub fn remaining(&self) -> u64 {
        self.end.saturating_sub(self.next)
    }

    fn at(&mut self, time: f64) -> Result<Answer, Error> {
        let plan = self.plan;
        let (along, attitude): SpinAndAttitude = match &plan.strategy {
            Strategy::Nothing => (None, None),
            Strategy::Constant { spin, attitude } => {
                let (energy, angle_to_momentum) = (plan.energy, plan.angle_to_momentum);
                return Ok(Answer { time, spin: *spin, attitude: *attitude, energy, angle_to_momentum });
            }
            _ if time == 0.0 => (Some(plan.body.omega), Some(plan.body.attitude)),
            Strategy::Rotation { motion, spin } => {
                let attitude = Some(plan.turned(motion.attitude(time)?.into_inner()));
                let (energy, angle_to_momentum) = (plan.energy, plan.angle_to_momentum);
                return Ok(Answer { time, spin: *spin, attitude, energy, angle_to_momentum });
            }
            Strategy::SymmetricTop(motion) | Strategy::EllipticSpin(motion) | Strategy::Elliptic(motion) => {
                let outputs = plan.scene.outputs();
                let spin = outputs.spin || (outputs.angle_to_momentum && plan.angle_to_momentum.is_none());
                match (spin, outputs.attitude) {
                    (_, false) => (Some(motion.omega(time)?), None),
                    (false, true) => (None, Some(plan.turned(motion.attitude(time)?.into_inner()))),
                    (true, true) => {
                        let at = motion.at(time)?;
                        (Some(at.omega), Some(plan.turned(at.attitude.into_inner())))
                    }
                }
            }
            Strategy::ExactDrift(driven) | Strategy::Adaptive(driven) => {
                let (spin, attitude) = self.stepped(driven, time)?;
                let attitude = plan.body.frame.map_or(attitude, |frame| attitude * frame.inverse());
                (Some(spin), Some(attitude))
            }
        };
        plan.answer(time, along, attitude)
    }

    /// Steps on to a time.
    fn stepped(
        &mut self,
        driven: &'a Driven,
        time: f64,
    ) -> Result<(Vector3<f64>, UnitQuaternion<f64>), Error> {
        let stepping = match &mut self.stepping {
            Some(stepping) => stepping,
            none => none.insert(Stepping::new(driven.control, &driven.system, &driven.start, usize::MAX)?),
        };
        let mut to = |time| {
            stepping.to(time, 1, &mut { usize::MAX }).map_err(|stop| match stop {
                Stop::Refused(error) => error,
                Stop::OutOfSteps => Error::OutOfRange { what: "the number of steps", value: f64::INFINITY },
            })
        };
        while let Some(&stop) = driven.stops.get(self.stops).filter(|stop| **stop < time) {
            to(stop)?;
            self.stops += 1;
        }
        let state = to(time)?;
        Ok((driven.system.omega(&state.momentum), UnitQuaternion::from_quaternion(state.attitude)))
    }
}

impl Plan<'_> {
    /// The answer for a body whose [motion](Self::motion) has this spin (principal axes, rad/s) and this turn
    /// since the start at this time: the same bits as [`States`].
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling_scenes::{InitialState, Outputs, Scene, Times};
    /// let body = InitialState::spinning(Vector3::new(1.0, 1.5, 2.0), Vector3::new(0.1, 1.0, 0.2));
    /// let outputs = Outputs { spin: true, attitude: true, energy: true, ..Outputs::NOTHING };
    /// let scene = Scene::new([body], vec![], Times::every(0.5, 10.0), outputs, 1e-9)?;
    /// let plan = scene.plan(0)?;
    /// let motion = plan.motion().ok_or("it moves")?;
    /// for state in plan.states() {
    ///     let state = state?;
    ///     let at = motion.at(state.time)?;
    ///     assert_eq!(plan.state(state.time, &at.omega, Some(&at.attitude))?, state);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// An energy or a angle to the momentum beyond `f64`.
    pub fn state(
        &self,
        time: f64,
        omega: &Vector3<f64>,
        turn: Option<&UnitQuaternion<f64>>,
    ) -> Result<Answer, Error> {
        if time == 0.0 {
            return self.answer(time, Some(self.body.omega), Some(self.body.attitude));
        }
        let attitude =
            turn.filter(|_| self.scene.outputs().attitude).map(|turn| self.turned(turn.into_inner()));
        self.answer(time, Some(*omega), attitude)
    }

    #[inline(always)]
    fn turned(&self, turn: Quaternion<f64>) -> UnitQuaternion<f64> {
        let whole = UnitQuaternion::new_unchecked(attitude::product(&self.body.world, &turn));
        self.body.frame.map_or(whole, |frame| whole * frame.inverse())
    }

    /// The outputs of this spin along the principal axes and this attitude of the body.
    #[inline]
    fn answer(
        &self,
        time: f64,
        along: Option<Vector3<f64>>,
        attitude: Option<UnitQuaternion<f64>>,
    ) -> Result<Answer, Error> {
        let outputs = self.scene.outputs();
        let moving = |wanted: bool, kept: Option<f64>| if wanted && kept.is_none() { along } else { None };
        Ok(Answer {
            time,
            spin: if outputs.spin { along.map(|omega| self.body.in_body(omega)) } else { None },
            attitude: if outputs.attitude { attitude } else { None },
            energy: match moving(outputs.energy, self.energy) {
                Some(omega) => Some(energy(self.body.moments, &omega)?),
                None => self.energy,
            },
            angle_to_momentum: match moving(outputs.angle_to_momentum, self.angle_to_momentum) {
                Some(omega) => Some(Inertia::from(self.body.moments).angle_to_momentum(&omega)?),
                None => self.angle_to_momentum,
            },
        })
    }
}

impl Iterator for States<'_> {
    type Item = Result<Answer, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.next >= self.end {
            return None;
        }
        let time = self.plan.scene.times().within(self.next);
        self.next += 1;
        let state = self.at(time);
        if state.is_err() {
            self.next = self.end;
        }
        Some(state)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let whole = usize::try_from(self.remaining()).ok();
        (usize::from(self.remaining() > 0), whole)
    }
}
