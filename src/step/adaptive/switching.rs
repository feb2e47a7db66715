//! Torques that begin and end: a run is made of pieces without a switch on the way.

use crate::number::Analytic;
use crate::step::system::System;
use crate::step::torque::{Torque, before_or_at};
use alloc::sync::Arc;
use alloc::vec::Vec;
use num_traits::FromPrimitive;

/// The system under the torques that act from the time `from` to the next switch on the way to `end`, s after
/// the start of a run; and the time of this switch, or the end.
pub(super) fn piece<T: Analytic + Copy + FromPrimitive>(
    system: &Arc<System<T>>,
    from: f64,
    end: f64,
) -> (Arc<System<T>>, f64) {
    if !system.torques().iter().any(|torque| matches!(torque, Torque::During { .. })) {
        return (Arc::clone(system), end);
    }
    let until = next_switch(system, from, end);
    (Arc::new(acting(system, from, until)), until)
}

/// The number with its sign.
pub(super) fn signed<T: Analytic + Copy>(x: T) -> f64 {
    if before_or_at(&T::zero(), &x) { x.size() } else { -x.size() }
}

/// A torque without its times, and when all of them allow it to act: from and to, s after the system's time.
fn window<'a, T: Analytic + Copy>(system: &System<T>, torque: &'a Torque<T>) -> (&'a Torque<T>, [f64; 2]) {
    let (mut torque, mut first, mut last) = (torque, f64::NEG_INFINITY, f64::INFINITY);
    while let Torque::During { start, end, torque: inner } = torque {
        let [start, end] = [*start, *end].map(|time| signed(time - *system.time()));
        (torque, first, last) = (&**inner, first.max(start), last.min(end));
    }
    (torque, [first, last])
}

/// The first switch after `from` on the way to `duration`, or this.
fn next_switch<T: Analytic + Copy>(system: &System<T>, from: f64, duration: f64) -> f64 {
    let ahead = |time: &f64| {
        if duration < 0.0 { *time < from && *time > duration } else { *time > from && *time < duration }
    };
    let switches = system.torques().iter().flat_map(|torque| window(system, torque).1).filter(ahead);
    switches.fold(duration, |next, time| if (time - from).abs() < (next - from).abs() { time } else { next })
}

/// The system under the torques that act all the way from one time to the other.
fn acting<T: Analytic + Copy + FromPrimitive>(system: &System<T>, from: f64, until: f64) -> System<T> {
    let (first, last) = if from < until { (from, until) } else { (until, from) };
    let torques: Vec<_> = system
        .torques()
        .iter()
        .filter_map(|torque| {
            let (torque, [start, end]) = window(system, torque);
            (start <= first && last <= end).then(|| torque.clone())
        })
        .collect();
    let mut piece = System::of_numbers(*system.moments(), torques);
    piece.set_time(*system.time() + T::from_f64(from).unwrap_or_else(T::zero));
    piece
}
