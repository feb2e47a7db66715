//! Where a motion starts anew: a step out of all proportion, or back at the start without a way there.

use crate::laws::Trial;
use crate::read::{Pair, Row, angle_between};
use crate::thresholds::*;
use nalgebra::Vector3;
use tumbling::attitude::rotation_matrix;
use tumbling::dynamics::euler;

/// A row at which the motion starts anew.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reset {
    /// Its line in the file.
    pub line: usize,
    /// Its time, s.
    pub time: f64,
    /// Whether the body was put to rest.
    pub to_rest: bool,
    /// Whether it was put back to its start.
    pub to_start: bool,
}

/// How far steps were off the law, relative to the spin or in rad.
#[derive(Default)]
pub(super) struct Errors {
    /// The most in spin or turn, slowly forgotten.
    off: f64,
    /// How many steps there were.
    steps: u64,
    /// The most in turn.
    turn: f64,
}

impl Trial {
    /// Whether the motion starts anew with a row, this number of steps after the last.
    pub(super) fn reset(&mut self, pair: &Pair, times: f64) -> Option<Reset> {
        let Pair { from: last, to: state, .. } = pair;
        let to_start = self.starts_anew(last, state);
        let jumps = times == 1.0 && self.jumps(pair);
        let to_rest = state.omega == Vector3::zeros();
        let line = state.ahead.map_or(state.line, |(line, _)| line);
        let reset = Reset { line, time: state.t, to_rest, to_start: to_start && !to_rest };
        (to_start || jumps).then_some(reset)
    }

    /// A step that is a hundred times as far from the law as the steps before it were, and farther than a
    /// rule's error in one step can be: the law itself changes the spin by no more than the angle turned.
    fn jumps(&mut self, pair: &Pair) -> bool {
        let (from, to) = (pair.from.omega, pair.to.omega);
        // Of attitudes alone a spin that is out of all proportion is what is to be found.
        let speed = if self.known.has_spin() { from.norm().max(to.norm()) } else { from.norm() };
        let mean = (from + to) / 2.0;
        let rate = euler::angular_acceleration(&self.known.moments, &mean, &self.torque(pair));
        let spin = (to - from - rate * pair.h).norm() / speed;
        let turn = match (pair.turn(), speed * pair.h < SHORT_TURN) {
            (Some(turn), true) => (turn - mean * pair.h).norm(),
            _ => 0.0,
        };
        let off = spin.max(turn);
        if !off.is_finite() {
            return false;
        }
        // A slow body turns little in a step: what is no jump for a fast one is many steps for it.
        let thrown = self.errors.steps > STEPS_BEFORE_A_JUMP
            && turn > THROWN_IN_TURNS * speed * pair.h
            && turn > JUMP_IN_ERRORS * self.errors.turn
            && turn > THROWN_IN_ROUNDINGS * self.known.floor.size;
        self.errors.turn = self.errors.turn.max(turn);
        let jumps = thrown
            || self.errors.steps > STEPS_BEFORE_A_JUMP
                && off > JUMP
                && off > JUMP_IN_TURNS * speed * pair.h
                && off > JUMP_IN_ERRORS * self.errors.off;
        if !jumps {
            // Forgotten slowly, so that a rule that goes astray now and then is known to.
            self.errors.off = off.max(ERROR_KEPT * self.errors.off);
            self.errors.steps += 1;
        }
        jumps
    }

    /// The torque in body axes, for a mean over the step.
    fn torque(&self, pair: &Pair) -> Vector3<f64> {
        match (self.known.said.torque, pair.from.attitude) {
            (Some(torque), Some(q)) => rotation_matrix(&q).tr_mul(&torque) / q.norm_squared(),
            _ => Vector3::zeros(),
        }
    }

    /// A body that moves is at rest all of a sudden, or back at the start without a way there.
    fn starts_anew(&self, last: &Row, state: &Row) -> bool {
        let [jump, turns] = JUMP_BACK;
        let (before, now) = (last.omega.norm(), state.omega.norm());
        if before > 0.0 && now == 0.0 {
            return before > NEARLY_AT_REST.max(ON_AXIS * self.known.floor.size) * self.first.omega.norm();
        }
        let back = (state.omega - self.first.omega).norm() <= BACK * self.first.omega.norm();
        let Some(((first, q), was)) = self.first.attitude.zip(state.attitude).zip(last.attitude) else {
            let (h, [errors, roundings]) = (state.t - last.t, BACK_IN_ERRORS);
            let mean = (last.omega + state.omega) / 2.0;
            let rate = euler::angular_acceleration(&self.known.moments, &mean, &Vector3::zeros());
            let off = (state.omega - last.omega - rate * h).norm() / before.max(now);
            let change = (state.omega - last.omega).norm() / before.max(now);
            let far = off.min(change) > roundings * self.known.floor.size && off > errors * self.errors.off;
            return back && (change > jump || far && self.errors.steps >= STEPS_BEFORE_A_JUMP);
        };
        let turned = angle_between(&was, &q);
        back && angle_between(&first, &q) < BACK
            && turned > jump
            && turned > turns * before.max(now) * (state.t - last.t)
    }
}
