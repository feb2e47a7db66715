//! Ways to answer for a free body, and how accurate they can be.

use crate::error::{Error, finite};
use crate::initial_state::Checked;
use crate::plan::Strategy;
use crate::scene::Outputs;
use nalgebra::Vector3;
use tumbling::exact::{FreeMotion, Regime};

/// The number of roundings by which the closed form may be off, each as large as the effect of rounding an
/// input.
const ROUNDINGS: f64 = 16.0;

/// The cheapest way to the outputs of a motion up to the time `end`.
pub(crate) fn strategy(
    body: &Checked,
    motion: &FreeMotion,
    outputs: Outputs,
    end: f64,
    accuracy: f64,
) -> Result<Strategy, Error> {
    let elementary =
        |strategy| determined(body, accuracy, (length(&body.along) * end).max(1.0)).map(|()| strategy);
    match motion.regime() {
        Regime::AtRest | Regime::Steady { .. } | Regime::SymmetricTop { .. }
            if !(outputs.attitude || outputs.spin) =>
        {
            Ok(Strategy::Nothing)
        }
        Regime::AtRest => Ok(Strategy::Constant),
        Regime::Steady { .. } if !outputs.attitude => Ok(Strategy::Constant),
        Regime::Steady { .. } => elementary(Strategy::Rotation),
        Regime::SymmetricTop { .. } => elementary(Strategy::SymmetricTop),
        regime => {
            attainable(motion, regime, body, end, accuracy)?;
            Ok(match outputs {
                Outputs { attitude: true, .. } => Strategy::Elliptic,
                Outputs { spin: true, .. } | Outputs { angle_to_momentum: true, .. } => {
                    Strategy::EllipticSpin
                }
                _ => Strategy::Nothing,
            })
        }
    }
}

fn allowed(requested: f64, attainable: f64) -> Result<(), Error> {
    if requested >= attainable { Ok(()) } else { Err(Error::unattainable(requested, attainable)) }
}

/// Refuses an accuracy finer than what the rounding of the start leaves after an angle `turned`, rad.
pub(crate) fn determined(body: &Checked, accuracy: f64, turned: f64) -> Result<(), Error> {
    allowed(accuracy, ROUNDINGS * f64::EPSILON * turned * coarsening(body))
}

/// The length of a vector, whose square may be beyond `f64`.
fn length(v: &Vector3<f64>) -> f64 {
    let largest = v.amax();
    if largest > 0.0 { (v / largest).norm() * largest } else { largest }
}

/// The largest factor by which the rounding of a number of the body exceeds that of its own size.
fn coarsening(body: &Checked) -> f64 {
    let share = |rounded: &Vector3<f64>, size: &Vector3<f64>| {
        rounded.zip_map(size, |rounded, size| if rounded == 0.0 { 1.0 } else { rounded / size }).max()
    };
    let speed = Vector3::repeat(length(&body.along).max(f64::MIN_POSITIVE));
    share(&body.rounded.moments, &body.moments.vector()).max(share(&body.rounded.omega, &speed)).max(1.0)
}

/// Refuses an accuracy finer than the conditioning of the motion permits. If a cheap bound is not conclusive,
/// the derivatives of the motion by its initial spin and moments decide, at the end and at the last flip,
/// where the spin changes most.
fn attainable(
    motion: &FreeMotion,
    regime: Regime,
    body: &Checked,
    end: f64,
    accuracy: f64,
) -> Result<(), Error> {
    let speed = length(&body.along);
    finite("the angle turned up to the last time", speed * end)?;
    let complement = match regime {
        Regime::Elliptic { complement, .. } => complement,
        _ => 0.0,
    };
    let moments = body.moments.vector();
    let thin = moments.max() / moments.min();
    let bound = ROUNDINGS * f64::EPSILON * thin * coarsening(body) * (speed * end).max(1.0)
        / (complement * complement);
    if accuracy >= bound {
        return Ok(());
    }
    // By the numbers along the principal axes, whose roundings are known.
    let framed = body.along != body.omega;
    let along = if framed { FreeMotion::new(body.moments, &body.along)? } else { *motion };
    let mut worst = 1.0_f64;
    let rounded = body.rounded;
    let flip = motion.flips(0.0, end)?.next_back();
    for time in flip.into_iter().chain([end]) {
        let (by_start, by_tensor) = along.sensitivities(time)?;
        for j in 0..3 {
            let change = |row: usize| {
                length(&by_start.fixed_view::<3, 1>(row, 3 + j).into()) * rounded.omega[j]
                    + length(&by_tensor.fixed_view::<3, 1>(row, j).into()) * rounded.moments[j]
            };
            worst = worst.max(change(3) / speed).max(change(0));
        }
    }
    allowed(accuracy, ROUNDINGS * f64::EPSILON * worst)
}
