//! The explicit Euler method [Eul68](crate::references): straight ahead.

use crate::body::State;
use crate::number::Analytic;
use crate::step::info::{Conserved, MethodInfo};
use crate::step::system::System;

pub(crate) const EULER: MethodInfo = MethodInfo {
    name: "explicit Euler",
    order: 1,
    implicit: false,
    conserved: Conserved::NONE,
    source: "Eul68",
};

pub(crate) fn euler<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    start.plus(&system.rate(start), h.clone())
}
