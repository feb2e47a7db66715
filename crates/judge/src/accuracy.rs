//! How the errors of single steps go, for a rule that is none of those known: of what order it is, and how
//! large its errors are.

use crate::state::{Pair, median};
use crate::thresholds::{ABOVE_ROUNDING, EVEN_ERRORS, ORDER_PLAINER, ORDER_SPREAD, ORDER_STEPS, ORDERS};
use nalgebra::Vector3;
use tumbling::PrincipalMoments;
use tumbling::exact::FreeMotion;

/// How the errors of a record's steps go, relative to the exact motion from the row before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    /// The errors go along the record as those of a rule of about this order with steps of one length; `None`
    /// where they do not show an order.
    pub order: Option<u32>,
    /// Whether they are about equal in all steps though the motion is not: of steps whose lengths are chosen
    /// by their errors.
    pub controlled: bool,
    /// The median error of a step, a second: of the spin relative to its length.
    pub per_second: f64,
}

/// The errors of the steps, where they are above rounding.
pub(crate) fn accuracy(moments: &Vector3<f64>, pairs: &[Pair], floor: f64) -> Option<Accuracy> {
    let checked = PrincipalMoments::try_from(*moments).ok()?;
    let error = |pair: &Pair| {
        let exact = FreeMotion::new(checked, &pair.from.omega).ok()?.omega(pair.h).ok()?;
        let off = (pair.to.omega - exact).norm() / exact.norm();
        (off > ABOVE_ROUNDING * floor && off.is_finite()).then_some((*pair, off))
    };
    let errors: Vec<(Pair, f64)> = pairs.iter().filter_map(error).collect();
    if errors.len() < ORDER_STEPS || 2 * errors.len() < pairs.len() {
        return None;
    }
    let per_second = median(errors.iter().map(|(pair, off)| off / pair.h));
    let logarithms: Vec<f64> = errors.iter().map(|(_, off)| off.ln()).collect();
    let whole = spread(&logarithms);
    let mut spreads = Vec::new();
    let mut moves = 0.0_f64;
    for order in 1..=ORDERS {
        let sizes: Vec<f64> = errors.iter().map(|(pair, _)| size(moments, pair, order).ln()).collect();
        if sizes.iter().any(|x| !x.is_finite()) {
            continue;
        }
        let left: Vec<f64> = logarithms.iter().zip(&sizes).map(|(a, b)| a - b).collect();
        spreads.push((order, spread(&left)));
        moves = moves.max(spread(&sizes));
    }
    let best = spreads.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
    let plain = best.filter(|(_, left)| *left < ORDER_SPREAD && *left < ORDER_PLAINER * whole);
    let controlled = plain.is_none() && whole < EVEN_ERRORS * moves;
    Some(Accuracy { order: plain.map(|(order, _)| order), controlled, per_second })
}

/// The root of the mean square of what differs from the mean.
fn spread(values: &[f64]) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    (values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / count).sqrt()
}

/// The length of the term of the spin's power series in the step that a rule of this order leaves out,
/// relative to the spin.
fn size(moments: &Vector3<f64>, pair: &Pair, order: u32) -> f64 {
    let ratios = Vector3::new(
        (moments.y - moments.z) / moments.x,
        (moments.z - moments.x) / moments.y,
        (moments.x - moments.y) / moments.z,
    );
    let omega = (pair.from.omega + pair.to.omega) / 2.0;
    let mut terms = vec![omega];
    for k in 0..=order as usize {
        let mut sum = Vector3::zeros();
        for j in 0..=k {
            let (a, b) = (terms[j], terms[k - j]);
            sum += Vector3::new(a.y * b.z, a.z * b.x, a.x * b.y);
        }
        terms.push(ratios.component_mul(&sum) * (pair.h / (k + 1) as f64));
    }
    terms.last().map_or(0.0, Vector3::norm) / omega.norm()
}
