//! The explicit Euler method [Eul68](crate::references): straight ahead.

use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;

pub(crate) fn euler<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    start.plus(&system.rate(start), h.clone())
}
