//! Spins that a record does not have, from the turns between its attitudes.

use crate::error::Error;
use crate::read::{Clock, Pair, Row};
use crate::thresholds::*;
use nalgebra::Vector3;
use tumbling::exact::FreeMotion;

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
    let to = pair.to.attitude?;
    let from = pair.from.attitude?;
    let mut omega = whole / pair.h;
    let mut least = f64::INFINITY;
    for _ in 0..SPIN_ROUNDS {
        let motion = FreeMotion::new((*moments).try_into().ok()?, &omega).ok()?;
        let got = from * motion.at(pair.h).ok()?.attitude.into_inner();
        // What is left of the turn, in body axes.
        let left = Pair {
            from: Row { attitude: Some(got), ..pair.to },
            to: Row { attitude: Some(to), ..pair.to },
            h: pair.h,
        };
        let left = left.turn()?;
        let size = left.norm();
        if size >= least || size == 0.0 {
            break;
        }
        least = size;
        let by_start = motion.state_transition(pair.h).ok()?.fixed_view::<3, 3>(0, 3).into_owned();
        omega += by_start.lu().solve(&left)?;
    }
    (least <= TURN_LEFT && omega.iter().all(|x| x.is_finite())).then_some(omega)
}

/// A row with the spin that the record does not have, or why it has none.
pub(crate) enum Derived {
    /// Its spin is known.
    Known(Row),
    /// There is no row before or after to compute it from.
    Unknown,
    /// The attitude turns by so much up to this line, rad.
    TooFar { line: usize, turn: f64 },
}

/// Rows, with spins where the record has none: each as soon as the next one is there.
pub(crate) struct Feed {
    pub has_spin: bool,
    pub moments: Vector3<f64>,
    pub clock: Clock,
    pub waiting: Option<Row>,
}

impl Feed {
    pub(crate) fn push(&mut self, state: &Row) -> Result<Derived, Error> {
        if self.has_spin {
            return Ok(Derived::Known(*state));
        }
        let Some(from) = self.waiting.replace(*state) else { return Ok(Derived::Unknown) };
        let (h, times) = self.clock.between(from.t, state.t);
        let pair = Pair { from, to: *state, h };
        let ahead = state.attitude.filter(|_| times == 1.0).map(|q| (state.line, q));
        Ok(match spin(&self.moments, &pair) {
            Some(omega) => Derived::Known(Row { omega, ahead, ..from }),
            None if times == 1.0 => {
                let turn = pair.turn().map_or(f64::NAN, |turn| turn.norm());
                Derived::TooFar { line: state.line, turn }
            }
            None => Derived::Unknown,
        })
    }
}
