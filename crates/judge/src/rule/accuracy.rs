//! How the errors of single steps go, for a rule that is none of those known: of what order it is, and how
//! large its errors are.

use crate::read::state::{Pair, median, ordered};
use crate::thresholds::{ABOVE_ROUNDING, EVEN_ERRORS, ORDER_GAIN, ORDER_LEFT, ORDER_STEPS, ORDER_TERMS};
use nalgebra::Vector3;
use serde::Serialize;
use tumbling::PrincipalMoments;
use tumbling::dynamics::euler;
use tumbling::exact::FreeMotion;

/// How the errors of a record's steps go, relative to the exact motion from the row before.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Accuracy {
    /// The errors go along the record as those of a rule of about this order with steps of one length; `None`
    /// where they do not show an order, as those of a rule that keeps energy and momentum never do.
    pub order: Option<u32>,
    /// Whether they show no order and are about equal in all steps though the motion is not: those of steps
    /// whose lengths are chosen by their errors.
    pub controlled: bool,
    /// The median error of a step, a second: of the spin relative to its length.
    pub per_second: f64,
}

/// A step and its error, relative to the spin.
struct Miss {
    omega: Vector3<f64>,
    error: Vector3<f64>,
    h: f64,
}

/// The errors of the steps, where they are above rounding.
pub(crate) fn accuracy(moments: &Vector3<f64>, pairs: &[Pair], floor: f64) -> Option<Accuracy> {
    let checked = PrincipalMoments::try_from(*moments).ok()?;
    let miss = |pair: &Pair| {
        let exact = FreeMotion::new(checked, &pair.from.omega).ok()?.omega(pair.h).ok()?;
        let error = (pair.to.omega - exact) / exact.norm();
        let size = error.norm();
        let omega = (pair.from.omega + pair.to.omega) / 2.0;
        (size > ABOVE_ROUNDING * floor && size.is_finite()).then_some(Miss { omega, error, h: pair.h })
    };
    let misses: Vec<Miss> = pairs.iter().filter_map(miss).collect();
    if misses.len() < ORDER_STEPS || 2 * misses.len() < pairs.len() {
        return None;
    }
    let per_second = median(misses.iter().map(|miss| miss.error.norm() / miss.h));
    let order = order(&misses, ordered(moments)[1]);
    let whole = spread(misses.iter().map(|miss| miss.error.norm().ln()));
    let rate = |miss: &Miss| euler::angular_acceleration(moments, &miss.omega, &Vector3::zeros()).norm();
    let moves = spread(misses.iter().map(|miss| rate(miss).ln()));
    Some(Accuracy { order, controlled: order.is_none() && whole < EVEN_ERRORS * moves, per_second })
}

/// The spread of numbers: the root of the mean square of what differs from the mean.
fn spread(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = values.clone().map(|_| 1.0).sum::<f64>();
    let mean = values.clone().sum::<f64>() / count;
    (values.map(|x| (x - mean) * (x - mean)).sum::<f64>() / count).sqrt()
}

/// The order whose leading error goes along the motion as the errors do.
///
/// The leading error of a rule of order p is a polynomial of degree p + 2 in the spin. It turns with the body
/// by half a turn about an axis, so that its component along x is x times a polynomial in the squares where p
/// is odd, and y z times one where p is even; and along one motion each square is linear in one of them.
fn order(misses: &[Miss], middle: usize) -> Option<u32> {
    let greatest = misses.iter().map(|miss| miss.omega[middle].powi(2)).fold(0.0, f64::max);
    let square = |miss: &Miss| miss.omega[middle].powi(2) / greatest;
    let left = |even: bool| -> [f64; ORDER_TERMS] {
        let mut sums = [0.0; ORDER_TERMS];
        for i in 0..3 {
            let factor =
                |omega: &Vector3<f64>| if even { omega[(i + 1) % 3] * omega[(i + 2) % 3] } else { omega[i] };
            let mut rest: Vec<f64> = misses.iter().map(|miss| miss.error[i] / miss.error.norm()).collect();
            let mut basis: Vec<Vec<f64>> = Vec::new();
            for (degree, sum) in (0..).zip(&mut sums) {
                let term = |miss: &Miss| factor(&miss.omega) * square(miss).powi(degree) / miss.error.norm();
                let mut term: Vec<f64> = misses.iter().map(term).collect();
                basis.iter().for_each(|known| take_away(&mut term, known));
                take_away(&mut rest, &term);
                basis.push(term);
                *sum += rest.iter().map(|x| x * x).sum::<f64>() / misses.len() as f64;
            }
        }
        sums.map(f64::sqrt)
    };
    let mut best: Option<(f64, u32)> = None;
    for even in [true, false] {
        let left = left(even);
        for degree in 1..ORDER_TERMS {
            let order = 2 * degree as u32 - u32::from(!even);
            // Each term more leaves less; this one must leave much less.
            let plain = left[degree] < ORDER_LEFT && left[degree] < ORDER_GAIN * left[degree - 1];
            if plain && best.is_none_or(|(least, _)| left[degree] < ORDER_GAIN * least) {
                best = Some((left[degree], order));
            }
        }
    }
    best.map(|(_, order)| order)
}

/// Takes from numbers what goes along with others.
fn take_away(numbers: &mut [f64], along: &[f64]) {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let share = dot(numbers, along) / dot(along, along).max(f64::MIN_POSITIVE);
    numbers.iter_mut().zip(along).for_each(|(x, y)| *x -= share * y);
}
