//! The states of a body, one after another.

use crate::error::Error;
use crate::plan::Plan;
use crate::plan::Strategy;
use crate::scene::Scene;
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::Stepper;

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

/// The states of one body, in order of time. It ends after an error.
#[derive(Debug, Clone)]
pub struct States<'a> {
    plan: &'a Plan<'a>,
    next: u64,
    end: u64,
    /// Of a driven body, once its first state is requested.
    stepper: Option<Box<Stepper>>,
}

/// Spin in body axes, and attitude.
type SpinAndAttitude = (Option<Vector3<f64>>, Option<UnitQuaternion<f64>>);

impl Scene {
    /// Answers the whole scene, one body after the other ([`batch`](crate::batch) answers many side by side).
    /// `take` is called with the number of each body and its states in order of time, or its error, before
    /// the next body is answered.
    pub fn run(&self, mut take: impl FnMut(usize, Result<Answer, Error>)) {
        for index in 0..self.bodies().len() {
            match self.plan(index) {
                Ok(plan) => plan.states().for_each(|state| take(index, state)),
                Err(error) => take(index, Err(error)),
            }
        }
    }
}

impl<'a> States<'a> {
    fn at(&mut self, time: f64) -> Result<Answer, Error> {
        let (plan, start) = (self.plan, &self.plan.start);
        let (spin, attitude) = match (plan.strategy, &plan.motion) {
            (Strategy::Nothing, _) => (None, None),
            (Strategy::Constant, _) => (Some(start.omega), Some(start.attitude)),
            _ if time == 0.0 => (Some(start.omega), Some(start.attitude)),
            (Strategy::Rotation, Some(motion)) => (Some(start.omega), Some(motion.attitude(time)?)),
            (_, Some(motion)) => plan.of_motion(motion, time)?,
            (_, None) => self.stepped(time)?,
        };
        plan.answer(time, spin, attitude)
    }

    /// Steps on to a time.
    fn stepped(&mut self, time: f64) -> Result<SpinAndAttitude, Error> {
        let Some(driven) = &self.plan.driven else { return Ok((None, None)) };
        let stepper = self.stepper.get_or_insert_with(|| Box::new(driven.stepper.clone()));
        let state = stepper.step_to(time)?;
        Ok((Some(stepper.omega()), Some(UnitQuaternion::from_quaternion(state.attitude))))
    }
}

impl Plan<'_> {
    /// The states at the times of the scene, in order, one at a time.
    #[must_use]
    pub fn states(&self) -> States<'_> {
        States { plan: self, next: 0, end: self.scene.times().count(), stepper: None }
    }

    #[inline]
    fn of_motion(&self, motion: &FreeMotion, time: f64) -> Result<SpinAndAttitude, Error> {
        let outputs = self.scene.outputs();
        let spin = outputs.spin || (outputs.angle_to_momentum && self.angle_to_momentum.is_none());
        Ok(match (spin, outputs.attitude) {
            (_, false) => (Some(motion.omega(time)?), None),
            (false, true) => (None, Some(motion.attitude(time)?)),
            (true, true) => {
                let at = motion.at(time)?;
                (Some(at.omega), Some(at.attitude))
            }
        })
    }

    /// The motion behind its states, if the body is free and its outputs change with time.
    pub(crate) fn moving(&self) -> Option<&FreeMotion> {
        let moves = !matches!(self.strategy, Strategy::Nothing | Strategy::Constant);
        self.motion.as_deref().filter(|_| moves)
    }

    /// The answer of a [moving](Self::moving) body with this spin and attitude, with the bits of [`States`].
    pub(crate) fn state(
        &self,
        time: f64,
        omega: Vector3<f64>,
        attitude: Option<UnitQuaternion<f64>>,
    ) -> Result<Answer, Error> {
        let steady = self.strategy == Strategy::Rotation;
        self.answer(time, Some(if steady { self.start.omega } else { omega }), attitude)
    }

    /// The outputs of this spin in body axes and this attitude.
    #[inline]
    fn answer(
        &self,
        time: f64,
        omega: Option<Vector3<f64>>,
        attitude: Option<UnitQuaternion<f64>>,
    ) -> Result<Answer, Error> {
        let outputs = self.scene.outputs();
        let moving = |wanted: bool, kept: Option<f64>| omega.filter(|_| wanted && kept.is_none());
        Ok(Answer {
            time,
            spin: omega.filter(|_| outputs.spin),
            attitude: attitude.filter(|_| outputs.attitude),
            energy: match moving(outputs.energy, self.energy) {
                Some(omega) => Some(self.start.energy(&omega)?),
                None => self.energy,
            },
            angle_to_momentum: match moving(outputs.angle_to_momentum, self.angle_to_momentum) {
                Some(omega) => Some(self.start.inertia.angle_to_momentum(&omega)?),
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

    /// Without the states before it.
    fn last(mut self) -> Option<Self::Item> {
        self.next = self.next.max(self.end.saturating_sub(1));
        self.next()
    }
}
