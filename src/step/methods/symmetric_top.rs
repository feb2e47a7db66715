//! The splitting of Dullweber, Leimkuhler and McLachlan [DLM97](crate::references): the exact motion of a
//! symmetric top between two half turns that make up for what the body is not one.

use super::splitting::spun;
use crate::attitude;
use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;

/// The top is symmetric about z, with the moment about x for its two equal ones; the difference is a turn
/// about y. A body is best given with the two moments first that are nearest to each other. With a torque,
/// all of it between two half kicks.
pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let half = h.clone() / T::integer(2);
    let quarter = half.clone() / T::integer(2);
    let inverse = system.inverse();
    let difference = |axis: usize| inverse[axis].clone() - inverse.x.clone();
    let mut motion = system.kick(start, half.clone());
    let rest = |motion: &mut State<T>| {
        let angle = difference(1) * motion.momentum.y.clone() * quarter.clone();
        spun(motion, 1, &angle);
    };
    rest(&mut motion);
    // A turn about the momentum, which does not move it, and one about the axis.
    let about = motion.momentum.map(|x| x * inverse.x.clone() * h.clone());
    motion.attitude = attitude::product(&motion.attitude, &attitude::turn(&about));
    let angle = difference(2) * motion.momentum.z.clone() * half.clone();
    spun(&mut motion, 2, &angle);
    rest(&mut motion);
    system.adjoint_kick(&motion, half)
}
