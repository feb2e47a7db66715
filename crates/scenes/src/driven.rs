//! How a body under torques is stepped: a tolerance is chosen by the accuracy, and then tried.

use crate::error::Error;
use crate::initial_state::Checked;
use crate::outputs::Outputs;
use crate::scene::Scene;
use crate::strategy::Driven;
use crate::torques::{Rates, have_series};
use crate::trial::{Budget, LEAST_TOLERANCE, Trial};
use tumbling::Body;

/// The largest number of steps of all trial runs together.
const MOST_STEPS: usize = 3_000_000;
/// The number of requested times at which runs are compared, besides the last,
const COMPARED: u64 = 32;
/// and the number of equal parts of the span at whose ends they are.
const INNER: u32 = 16;

/// How often an accuracy is tried that may be attainable where the one requested is not.
const OFFERS: usize = 8;

/// The run that the trials showed to be accurate enough.
///
/// An accuracy is offered instead only where a plan for it was made: the smallest difference that two runs
/// showed is a bad guess, for it is small by chance where all of it is rounding.
pub(crate) fn chosen(start: &Checked, body: &Body, scene: &Scene) -> Result<Driven, Error> {
    let requested = scene.accuracy();
    let mut found = chosen_to(requested, start, body, scene);
    let mut offered = None;
    for _ in 0..OFFERS {
        match found {
            Err(Error::Unattainable { attainable, .. }) => {
                let offer = two_digits(attainable.max(2.0 * offered.unwrap_or(0.0)));
                offered = Some(offer);
                found = chosen_to(offer, start, body, scene);
            }
            Ok(driven) => {
                let refused = |attainable| Err(Error::Unattainable { requested, attainable });
                return offered.map_or(Ok(driven), refused);
            }
            _ => break,
        }
    }
    match found {
        Err(Error::Unattainable { .. }) | Ok(_) => Err(Error::Disagreement { requested, steps: 0 }),
        Err(Error::Disagreement { steps, .. }) => Err(Error::Disagreement { requested, steps }),
        Err(error) => Err(error),
    }
}

/// The number rounded up to the two digits that are printed of it.
fn two_digits(x: f64) -> f64 {
    format!("{:.1e}", 1.05 * x).parse().unwrap_or(x).max(x)
}

fn chosen_to(accuracy: f64, start: &Checked, body: &Body, scene: &Scene) -> Result<Driven, Error> {
    let end = scene.times().end();
    let rates = Rates::of(start, scene.torques(), end)?;
    let (times, stiff) = (compared(scene), rates.are_stiff(end));
    let outputs = Outputs { flips: scene.outputs().flips && start.can_flip(), ..scene.outputs() };
    let turned = (rates.spin * end).max(1.0);
    let trial = Trial { body, torques: scene.torques(), times: &times, outputs, accuracy, turned };
    // Leaves room for a finer tolerance, so that there are two runs to compare.
    let first = (0.03 * accuracy).max(8.0 * LEAST_TOLERANCE);
    // Where damping is that fast, each step is a collocation; MOST_STEPS of them take too long to try.
    let most = if stiff { MOST_STEPS / 20 } else { MOST_STEPS };
    let mut budget = Budget { left: most, spent: 0.0 };
    let (tolerance, difference, steps) =
        if end == 0.0 { (first, 0.0, 0) } else { trial.refined(first, &mut budget)? };
    let stepper = trial.stepper(tolerance, usize::MAX)?;
    let stops = if have_series(scene.torques()) { Vec::new() } else { times };
    Ok(Driven { stepper, stops, tolerance, difference, steps, trials: budget.spent, stiff })
}

/// Times at which runs are compared, in order: some of those requested, evenly chosen, with the last, and
/// ever closer to the first, where what fades fast is still there; and some between, for at one instant alone
/// two wrong runs may meet.
fn compared(scene: &Scene) -> Vec<f64> {
    let last = scene.times().count().saturating_sub(1);
    let every = scene.times().count().div_ceil(COMPARED).max(1);
    let doubled = (0..64).map(|k| 1_u64 << k);
    let places = (0..COMPARED).map(|k| k * every).chain(doubled).filter(|n| *n < last).chain([last]);
    let end = scene.times().end();
    let inner = (1..INNER).map(|k| end * (f64::from(k) / f64::from(INNER)));
    let mut times: Vec<f64> = places.map(|n| scene.times().nth(n)).chain(inner).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}
