//! A body at one instant, as the judge takes it, two of them one step apart, and the spin that a turn between
//! two attitudes has.

use crate::thresholds::*;
use nalgebra::{Quaternion, Vector3};
use std::f64::consts::PI;
use tumbling::attitude;
use tumbling::exact::FreeMotion;

/// One row, understood.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Row {
    pub line: usize,
    /// Seconds.
    pub t: f64,
    /// Body to world, of any length.
    pub attitude: Option<Quaternion<f64>>,
    /// In body axes, rad/s.
    pub omega: Vector3<f64>,
    /// In a record of attitudes alone the next row's line and attitude, if it is one step later.
    pub ahead: Option<(usize, Quaternion<f64>)>,
}

impl Row {
    /// Its attitude; the identity where none is given.
    pub(crate) fn start(&self) -> Quaternion<f64> {
        self.attitude.unwrap_or_else(Quaternion::identity)
    }
}

/// Two rows that follow one another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair {
    pub from: Row,
    pub to: Row,
    /// The step between them, s.
    pub h: f64,
}

impl Pair {
    /// The turn between the two as a rotation vector in body axes, rad; of two attitudes the shorter way.
    pub(crate) fn turn(&self) -> Option<Vector3<f64>> {
        let (from, to) = (self.from.attitude?, self.to.attitude?);
        let q = attitude::product(&from.conjugate(), &to);
        let q = if q.w < 0.0 { -q } else { q };
        let sine = q.imag().norm();
        let half = sine.atan2(q.w);
        Some(if sine > 0.0 { q.imag() * (2.0 * half / sine) } else { Vector3::zeros() })
    }

    /// With spins in world axes that are taken for the body's, or in the body's for the world's.
    pub(crate) fn aside(self, in_world: bool) -> Self {
        let aside = |row: Row| {
            let rotation = attitude::rotation_matrix(&row.start()) / row.start().norm_squared();
            Row { omega: if in_world { rotation } else { rotation.transpose() } * row.omega, ..row }
        };
        Self { from: aside(self.from), to: aside(self.to), ..self }
    }

    /// The sine between the axes of a short turn and of the spin: the one before, after, or their mean,
    /// whichever is the nearest.
    pub(crate) fn across(&self) -> Option<f64> {
        let turn = self.turn().filter(|turn| turn.norm() < SHORT_TURN)?;
        let (a, b) = (self.from.omega, self.to.omega);
        let sine = |omega: Vector3<f64>| turn.cross(&omega).norm() / (turn.norm() * omega.norm());
        Some([a, b, a + b].map(sine).into_iter().fold(f64::INFINITY, f64::min))
    }

    /// How far the turn is from what the spin says, relative to the spin: from the one before, after, or
    /// their mean, whichever is the nearest. Nothing where a step turns so far that the shorter way need not
    /// be the right one.
    pub(crate) fn inconsistency(&self) -> Option<f64> {
        let turned = self.turn()? / self.h;
        let (a, b) = (self.from.omega, self.to.omega);
        let speed = a.norm().max(b.norm());
        if speed == 0.0 || speed * self.h > LONG_TURN {
            return None;
        }
        let mean = (a + b) / 2.0;
        Some([a, b, mean].iter().map(|omega| (turned - omega).norm()).fold(f64::INFINITY, f64::min) / speed)
    }
}

/// The middle one, and the one that 95 in 100 do not exceed.
pub(crate) fn middle_and_most(mut values: Vec<f64>) -> Option<[f64; 2]> {
    values.sort_by(f64::total_cmp);
    let last = values.len().checked_sub(1)?;
    Some([50, 95].map(|percent| values[(values.len() * percent / 100).min(last)]))
}

/// The middle one; infinite if there is none.
pub(crate) fn median(values: &mut dyn Iterator<Item = f64>) -> f64 {
    middle_and_most(values.collect()).map_or(f64::INFINITY, |x| x[0])
}

/// The indices of the moments, smallest first.
pub(crate) fn ordered(moments: &Vector3<f64>) -> [usize; 3] {
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    order
}

/// A vector of the body, in the world.
pub(crate) fn in_world(q: &Quaternion<f64>, vector: &Vector3<f64>) -> Vector3<f64> {
    attitude::rotation_matrix(q) * vector
}

/// The angle between two attitudes, rad, whichever sign their quaternions have and however long they are.
pub(crate) fn angle_between(a: &Quaternion<f64>, b: &Quaternion<f64>) -> f64 {
    let between = attitude::product(&a.conjugate(), b);
    (2.0 * between.imag().norm().atan2(between.w.abs())).min(PI)
}

/// The spin at the first of two attitudes with which the exact motion comes to the second, by the shorter
/// way: Newton's method with the motion's own derivatives. `None` where the attitudes are too far apart to
/// tell.
pub(crate) fn spin(moments: &Vector3<f64>, pair: &Pair) -> Option<Vector3<f64>> {
    if pair.from.attitude == pair.to.attitude {
        return Some(Vector3::zeros());
    }
    let whole = pair.turn()?;
    if whole.norm() > FARTHEST_TURN {
        return None;
    }
    let from = pair.from.attitude?;
    let mut omega = whole / pair.h;
    let mut least = f64::INFINITY;
    for _ in 0..FIT_ROUNDS {
        let motion = FreeMotion::new((*moments).try_into().ok()?, &omega).ok()?;
        let got = from * motion.at(pair.h).ok()?.attitude.into_inner();
        // What is left of the turn, in body axes.
        let left = Pair { from: Row { attitude: Some(got), ..pair.to }, ..*pair }.turn()?;
        let size = left.norm();
        if size >= least {
            break;
        }
        least = size;
        let by_start = motion.state_transition(pair.h).ok()?.fixed_view::<3, 3>(0, 3).into_owned();
        omega += by_start.lu().solve(&left)?;
    }
    (least <= TURN_LEFT && omega.iter().all(|x| x.is_finite())).then_some(omega)
}
