//! The states of a body, one after another.

use super::plan::{Driven, Plan, Way, energy};
use crate::error::Error;
use crate::step::Motion;
use nalgebra::{UnitQuaternion, Vector3};

/// A body at one time: of what was asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// s from the start.
    pub time: f64,
    /// Angular velocity in body axes, rad/s.
    pub spin: Option<Vector3<f64>>,
    /// Body to world.
    pub attitude: Option<UnitQuaternion<f64>>,
    /// Kinetic energy, J.
    pub energy: Option<f64>,
    /// The angle between spin and momentum, rad.
    pub gap: Option<f64>,
}

/// The states asked of one body, in order of time. After an error there are no more.
#[derive(Debug, Clone)]
pub struct States<'a> {
    plan: &'a Plan<'a>,
    next: u64,
    end: u64,
    walker: Option<(f64, Motion<f64>)>,
}

/// Spin along the principal axes, and the turn of those since the start.
type Here = (Option<Vector3<f64>>, Option<UnitQuaternion<f64>>);

impl<'a> States<'a> {
    pub(super) fn new(plan: &'a Plan<'a>) -> Self {
        let walker = match &plan.way {
            Way::Stepper(driven) | Way::Flow(driven) | Way::Controlled(driven) | Way::Stiff(driven) => {
                Some((0.0, driven.start.clone()))
            }
            _ => None,
        };
        Self { plan, next: 0, end: plan.scene.times.count(), walker }
    }

    /// How many are still to come.
    #[must_use]
    pub fn remaining(&self) -> u64 {
        self.end.saturating_sub(self.next)
    }

    fn at(&mut self, time: f64) -> Result<State, Error> {
        let plan = self.plan;
        let wants = plan.scene.wants;
        let blank = State { time, spin: None, attitude: None, energy: plan.energy, gap: plan.gap };
        let turned = |turn| {
            let whole = plan.body.world * UnitQuaternion::new_unchecked(turn);
            plan.body.frame.map_or(whole, |frame| whole * frame.inverse())
        };
        let start = time == 0.0;
        let (along, attitude): Here = match &plan.way {
            Way::Nothing => (None, None),
            Way::Constant { spin, attitude } => {
                return Ok(State { spin: *spin, attitude: *attitude, ..blank });
            }
            Way::Rotation(rotation) => {
                let attitude =
                    if start { plan.body.attitude } else { turned(rotation.turn.at(time * rotation.clock)) };
                return Ok(State { spin: rotation.spin, attitude: Some(attitude), ..blank });
            }
            _ if start => (Some(plan.body.omega), Some(plan.body.attitude)),
            Way::SymmetricTop(top) => {
                let time = time * top.clock;
                let attitude = wants.attitude.then(|| turned(top.precession.attitude(time)));
                (wants.spin.then(|| top.precession.omega(time)), attitude)
            }
            Way::EllipticSpin(motion) => (Some(motion.omega(time)?), None),
            Way::Elliptic(motion) if wants.spin || wants.gap => {
                let at = motion.at(time)?;
                (Some(at.omega), Some(turned(at.attitude.into_inner())))
            }
            Way::Elliptic(motion) => (None, Some(turned(motion.attitude(time)?.into_inner()))),
            Way::Stepper(driven) | Way::Flow(driven) | Way::Controlled(driven) | Way::Stiff(driven) => {
                let (spin, attitude) = walked(&mut self.walker, driven, time)?;
                let whole = plan.body.frame.map_or(attitude, |frame| attitude * frame.inverse());
                (Some(spin), Some(whole))
            }
        };
        let moving = |wanted: bool, kept: Option<f64>| if wanted && kept.is_none() { along } else { None };
        Ok(State {
            time,
            spin: if wants.spin { along.map(|omega| plan.body.in_body(omega)) } else { None },
            attitude: if wants.attitude { attitude } else { None },
            energy: match moving(wants.energy, plan.energy) {
                Some(omega) => Some(energy(&plan.body.moments, &omega)?),
                None => plan.energy,
            },
            gap: match moving(wants.gap, plan.gap) {
                Some(omega) => Some(plan.inertia.gap(&omega)?),
                None => plan.gap,
            },
        })
    }
}

/// Steps on to a time.
fn walked(
    walker: &mut Option<(f64, Motion<f64>)>,
    driven: &Driven,
    time: f64,
) -> Result<(Vector3<f64>, UnitQuaternion<f64>), Error> {
    let (mut now, mut motion) = walker.take().unwrap_or_else(|| (0.0, driven.start.clone()));
    if time > now {
        motion = driven.by.on(&driven.system, &motion, time - now, &mut { usize::MAX })?;
        now = time;
    }
    let spin = driven.system.omega(&motion.vector);
    let attitude = UnitQuaternion::from_quaternion(motion.attitude);
    *walker = Some((now, motion));
    Ok((spin, attitude))
}

impl Iterator for States<'_> {
    type Item = Result<State, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.next >= self.end {
            return None;
        }
        let time = self.plan.scene.times.nth(self.next);
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
