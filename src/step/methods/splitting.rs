//! The three-rotation splitting: the energy's three terms one after another, each an exact turn about a
//! principal axis ([McL93](crate::references), [Rei93](crate::references), [TW94](crate::references)); and
//! compositions of it to orders 4 and 6.

use super::implicit::ratio;
use crate::attitude;
use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;
use nalgebra::Quaternion;

/// Shares of the step, in order; the same backwards from the last on. The weights of a symmetric composition
/// of a symmetric method of order 2 must have the sum 1 and cubes with the sum 0 to give order 4. Three
/// rational weights are too few, since 2 has no rational cube root, and so are five, since 4 is not a sum of
/// two rational cubes. Of seven, these are by far the smallest with integers up to 60 over a common one: 2
/// (12^3 + 17^3 + 19^3) = 30^3.
const SEVEN: [(i32, u32); 4] = [(19, 66), (17, 66), (12, 66), (-30, 66)];

/// Shares of the step for order 6: also their fifth powers sum to 0, and so does one more polynomial. The
/// first is a free number, taken as it was published [KL97](crate::references) with 26 digits; the others
/// solve the four equations.
const NINE: [Decimal; 5] = [
    (false, [392_161_444, 7_314_139, 279_250_560]),
    (false, [332_599_136, 789_359_438, 599_748_634]),
    (true, [706_246_172, 557_639_359, 809_964_820]),
    (false, [82_213_596, 293_550_800, 231_490_449]),
    (false, [798_543_990, 934_829_963, 398_950_353]),
];

/// A decimal of 27 digits below 1: whether it is negative, and its digits in three groups of nine.
type Decimal = (bool, [u32; 3]);

/// Its value, exact where the number type is.
fn decimal<T: Analytic>((negative, groups): Decimal) -> T {
    let base = T::integer(1_000_000_000);
    // From the last group on, so that the small ones are not lost one by one.
    let size = groups.iter().rev().fold(T::zero(), |sum, &group| (sum + T::integer(group)) / base.clone());
    if negative { -size } else { size }
}

pub(crate) fn order_2<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    composed(system, start, h, &[T::one()])
}

pub(crate) fn order_4<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let [a, b, c, d] = SEVEN.map(|(n, below)| ratio::<T>(n, below));
    composed(system, start, h, &[a.clone(), b.clone(), c.clone(), d, c, b, a])
}

pub(crate) fn order_6<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let [a, b, c, d, e] = NINE.map(decimal::<T>);
    composed(system, start, h, &[a.clone(), b.clone(), c.clone(), d.clone(), e, d, c, b, a])
}

/// With a torque, all of it between two half kicks: then of order 2.
fn composed<T: Analytic>(system: &System<T>, start: &State<T>, h: &T, shares: &[T]) -> State<T> {
    let half = h.clone() / T::integer(2);
    system.between_half_kicks(start, h, |mut motion| {
        let mut before = T::zero();
        for share in shares {
            let half_share = share.clone() * half.clone();
            // The last turn of one share and the first of the next are about the same axis.
            turned(system, &mut motion, 0, &(before + half_share.clone()));
            turned(system, &mut motion, 1, &half_share);
            turned(system, &mut motion, 2, &(share.clone() * h.clone()));
            turned(system, &mut motion, 1, &half_share);
            before = half_share;
        }
        turned(system, &mut motion, 0, &before);
        motion
    })
}

/// The turn that the energy of the spin about one axis alone makes in a time.
fn turned<T: Analytic>(system: &System<T>, motion: &mut State<T>, axis: usize, time: &T) {
    let rate = motion.momentum[axis].clone() * system.inverse[axis].clone();
    spun(motion, axis, &(rate * time.clone() / T::integer(2)));
}

/// The body turned about its own axis by twice the angle, its momentum staying in the world.
fn spun<T: Analytic>(motion: &mut State<T>, axis: usize, half_angle: &T) {
    let (i, j, k) = (axis, (axis + 1) % 3, (axis + 2) % 3);
    let (s, c) = half_angle.sin_cos();
    let p = |x: &T, y: &T| x.clone() * y.clone();
    let (sine, sine_square) = (p(&s, &c), p(&s, &s));
    let (sine, less) = (sine.clone() + sine, sine_square.clone() + sine_square);
    // cos of the whole angle is 1 less `less`: small turns keep their digits.
    let (v, w) = (motion.momentum[j].clone(), motion.momentum[k].clone());
    motion.momentum[j] = v.clone() - (p(&v, &less) - p(&w, &sine));
    motion.momentum[k] = w.clone() - (p(&w, &less) + p(&v, &sine));
    let q = &motion.attitude.coords;
    let mut turned = q.clone_owned();
    turned.w = p(&q.w, &c) - p(&q[i], &s);
    turned[i] = p(&q[i], &c) + p(&q.w, &s);
    turned[j] = p(&q[j], &c) + p(&q[k], &s);
    turned[k] = p(&q[k], &c) - p(&q[j], &s);
    motion.attitude = Quaternion::from_vector(turned);
}

/// The splitting of Dullweber, Leimkuhler and McLachlan [DLM97](crate::references): the exact motion of a
/// symmetric top between two half turns that correct for the difference between the body and that top.
///
/// The top is symmetric about z, with the moment about x for its two equal ones; the difference is a turn
/// about y. A body is best given with the two moments first that are nearest to each other. With a torque,
/// all of it between two half kicks.
pub(crate) fn symmetric_top<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let half = h.clone() / T::integer(2);
    let quarter = half.clone() / T::integer(2);
    let inverse = &system.inverse;
    let difference = |axis: usize| inverse[axis].clone() - inverse.x.clone();
    let rest = |motion: &mut State<T>| {
        let angle = difference(1) * motion.momentum.y.clone() * quarter.clone();
        spun(motion, 1, &angle);
    };
    system.between_half_kicks(start, h, |mut motion| {
        rest(&mut motion);
        // A turn about the momentum, which does not move it, and one about the axis.
        let about = motion.momentum.map(|x| x * inverse.x.clone() * h.clone());
        motion.attitude = attitude::product(&motion.attitude, &attitude::turn(&about));
        let angle = difference(2) * motion.momentum.z.clone() * half.clone();
        spun(&mut motion, 2, &angle);
        rest(&mut motion);
        motion
    })
}
