//! The explicit Euler method [Eul68](crate::references): straight ahead.

use super::method::{About, Keeps};
use super::rk4::Motion;
use super::system::System;
use crate::scalar::Analytic;

pub(super) const EULER: About =
    About { name: "explicit Euler", order: 1, implicit: false, keeps: Keeps::NOTHING, source: "Eul68" };

pub(super) fn euler<T: Analytic>(system: &System<T>, start: &Motion<T>, h: &T) -> Motion<T> {
    start.plus(&system.rate(start), h)
}
