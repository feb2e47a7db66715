//! The states of a body, one after another.

use super::plan::{Driven, Plan, Way, energy};
use crate::error::Error;
use crate::exact::FreeMotion;
use crate::step::State;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A body at one time: of what was asked for.
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
    pub gap: Option<f64>,
}

/// The states asked of one body, in order of time. After an error there are no more.
#[derive(Debug, Clone)]
pub struct States<'a> {
    plan: &'a Plan<'a>,
    next: u64,
    end: u64,
    walker: Option<(f64, State<f64>)>,
}

/// Spin along the principal axes, and the turn of those since the start.
type Here = (Option<Vector3<f64>>, Option<UnitQuaternion<f64>>);

impl<'a> States<'a> {
    pub(super) fn new(plan: &'a Plan<'a>) -> Self {
        let walker = match &plan.way {
            Way::Stepper(driven) | Way::Flow(driven) | Way::Controlled(driven) | Way::Stiff(driven) => {
                Some((0.0, driven.start))
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

    fn at(&mut self, time: f64) -> Result<Answer, Error> {
        let plan = self.plan;
        let wants = plan.scene.wants;
        let start = time == 0.0;
        let (along, attitude): Here = match &plan.way {
            Way::Nothing => (None, None),
            Way::Constant { spin, attitude } => {
                return Ok(Answer { spin: *spin, attitude: *attitude, ..plan.blank(time) });
            }
            Way::Rotation(rotation) => {
                let attitude = if start {
                    plan.body.attitude
                } else {
                    plan.turned(rotation.turn.at(time * rotation.clock))
                };
                return Ok(Answer { spin: rotation.spin, attitude: Some(attitude), ..plan.blank(time) });
            }
            _ if start => (Some(plan.body.omega), Some(plan.body.attitude)),
            Way::SymmetricTop(top) => {
                let time = time * top.clock;
                let attitude = wants.attitude.then(|| plan.turned(top.precession.attitude(time)));
                (wants.spin.then(|| top.precession.omega(time)), attitude)
            }
            Way::EllipticSpin(motion) => (Some(motion.omega(time)?), None),
            Way::Elliptic(motion) if wants.spin || wants.gap => {
                let at = motion.at(time)?;
                (Some(at.omega), Some(plan.turned(at.attitude.into_inner())))
            }
            Way::Elliptic(motion) => (None, Some(plan.turned(motion.attitude(time)?.into_inner()))),
            Way::Stepper(driven) | Way::Flow(driven) | Way::Controlled(driven) | Way::Stiff(driven) => {
                let (spin, attitude) = walked(&mut self.walker, driven, time)?;
                let whole = plan.body.frame.map_or(attitude, |frame| attitude * frame.inverse());
                (Some(spin), Some(whole))
            }
        };
        plan.told(time, along, attitude)
    }
}

impl Plan<'_> {
    /// The free motion that its states are taken from, along the body's principal axes and from their place at the start; none where
    /// nothing moves, or under a torque.
    ///
    /// Whoever has many such bodies may ask their motions [side by side](crate::exact::Batch) and have each answer put
    /// [as the scene asks](Self::state).
    #[must_use]
    pub fn motion(&self) -> Option<FreeMotion> {
        match &self.way {
            Way::EllipticSpin(motion) | Way::Elliptic(motion) => Some(**motion),
            Way::Rotation(_) | Way::SymmetricTop(_) => {
                FreeMotion::new(self.body.moments, &self.body.omega).ok()
            }
            _ => None,
        }
    }

    /// What the scene asks for, of a body whose [motion](Self::motion) has this spin (principal axes, rad/s) at this time, and this turn
    /// since the start: to the bit what [`States`] answers.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::scene::{Scene, Times, Toss, Wants};
    /// let toss = Toss::spinning(Vector3::new(1.0, 1.5, 2.0), Vector3::new(0.1, 1.0, 0.2));
    /// let wants = Wants { spin: true, attitude: true, energy: true, ..Wants::NOTHING };
    /// let scene = Scene::new(vec![toss], vec![], Times::every(0.5, 10.0), wants, 1e-9)?;
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
    /// An energy or a gap beyond `f64`.
    pub fn state(
        &self,
        time: f64,
        omega: &Vector3<f64>,
        turn: Option<&UnitQuaternion<f64>>,
    ) -> Result<Answer, Error> {
        if time == 0.0 {
            return self.told(time, Some(self.body.omega), Some(self.body.attitude));
        }
        let attitude = turn.filter(|_| self.scene.wants.attitude).map(|turn| self.turned(turn.into_inner()));
        self.told(time, Some(*omega), attitude)
    }

    /// A state of what does not change.
    fn blank(&self, time: f64) -> Answer {
        Answer { time, spin: None, attitude: None, energy: self.energy, gap: self.gap }
    }

    fn turned(&self, turn: Quaternion<f64>) -> UnitQuaternion<f64> {
        let whole = self.body.world * UnitQuaternion::new_unchecked(turn);
        self.body.frame.map_or(whole, |frame| whole * frame.inverse())
    }

    /// A state of this spin along the principal axes and this attitude of the body.
    fn told(
        &self,
        time: f64,
        along: Option<Vector3<f64>>,
        attitude: Option<UnitQuaternion<f64>>,
    ) -> Result<Answer, Error> {
        let wants = self.scene.wants;
        let moving = |wanted: bool, kept: Option<f64>| if wanted && kept.is_none() { along } else { None };
        Ok(Answer {
            time,
            spin: if wants.spin { along.map(|omega| self.body.in_body(omega)) } else { None },
            attitude: if wants.attitude { attitude } else { None },
            energy: match moving(wants.energy, self.energy) {
                Some(omega) => Some(energy(self.body.moments, &omega)?),
                None => self.energy,
            },
            gap: match moving(wants.gap, self.gap) {
                Some(omega) => Some(self.inertia.angle_to_momentum(&omega)?),
                None => self.gap,
            },
        })
    }
}

/// Steps on to a time.
fn walked(
    walker: &mut Option<(f64, State<f64>)>,
    driven: &Driven,
    time: f64,
) -> Result<(Vector3<f64>, UnitQuaternion<f64>), Error> {
    let (mut now, mut motion) = walker.take().unwrap_or((0.0, driven.start));
    if time > now {
        motion = driven.by.on(&driven.system, &motion, time - now, 1, &mut { usize::MAX })?;
        now = time;
    }
    let spin = driven.system.omega(&motion.momentum);
    let attitude = UnitQuaternion::from_quaternion(motion.attitude);
    *walker = Some((now, motion));
    Ok((spin, attitude))
}

impl Iterator for States<'_> {
    type Item = Result<Answer, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.next >= self.end {
            return None;
        }
        let time = self.plan.scene.times.within(self.next);
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
