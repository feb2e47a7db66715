//! Ways to answer for a free body, and how accurate they can be.

use crate::error::Error;
use crate::initial_state::Principal;
use crate::outputs::Outputs;
use crate::strategy::Strategy;
use nalgebra::Vector3;
use tumbling::exact::{FreeMotion, Regime};

/// The closed form may be off by this number of its own roundings, each as large as the motion makes that of
/// an input.
const ROUNDINGS: f64 = 16.0;

/// The cheapest way.
pub(crate) fn strategy(
    body: &Principal,
    outputs: Outputs,
    end: f64,
    accuracy: f64,
) -> Result<Strategy, Error> {
    if !(outputs.attitude || outputs.spin || outputs.angle_to_momentum || outputs.flips) {
        return Ok(Strategy::Nothing);
    }
    let motion = FreeMotion::new(body.moments, &body.omega)?;
    let in_body = |wanted: bool| wanted.then(|| body.in_body(body.omega));
    let elementary = || {
        let turned = (body.omega.norm() * end).max(1.0);
        allowed(accuracy, ROUNDINGS * f64::EPSILON * turned * coarsening(body))
    };
    let regime = motion.regime();
    match regime {
        Regime::AtRest | Regime::Steady { .. } | Regime::SymmetricTop { .. }
            if !(outputs.attitude || outputs.spin) =>
        {
            Ok(Strategy::Nothing)
        }
        Regime::AtRest => Ok(Strategy::Constant {
            spin: in_body(outputs.spin),
            attitude: outputs.attitude.then_some(body.attitude),
        }),
        Regime::Steady { .. } if !outputs.attitude => {
            Ok(Strategy::Constant { spin: in_body(true), attitude: None })
        }
        Regime::Steady { .. } => {
            let (motion, spin) = (Box::new(motion), in_body(outputs.spin));
            elementary().map(|()| Strategy::Rotation { motion, spin })
        }
        Regime::SymmetricTop { .. } => elementary().map(|()| Strategy::SymmetricTop(Box::new(motion))),
        _ => {
            attainable(&motion, regime, body, end, accuracy)?;
            Ok(match outputs {
                Outputs { attitude: true, .. } => Strategy::Elliptic(Box::new(motion)),
                Outputs { spin: true, .. } | Outputs { angle_to_momentum: true, .. } => {
                    Strategy::EllipticSpin(Box::new(motion))
                }
                _ => Strategy::Nothing,
            })
        }
    }
}

fn allowed(requested: f64, attainable: f64) -> Result<(), Error> {
    if requested >= attainable { Ok(()) } else { Err(Error::Unattainable { requested, attainable }) }
}

/// The largest factor by which the rounding of a number of the body exceeds that of its own size.
fn coarsening(body: &Principal) -> f64 {
    let share = |rounded: &Vector3<f64>, size: &Vector3<f64>| {
        rounded.zip_map(size, |rounded, size| if rounded == 0.0 { 1.0 } else { rounded / size }).max()
    };
    let speed = Vector3::repeat(body.omega.norm().max(f64::MIN_POSITIVE));
    share(&body.rounded.moments, &body.moments.vector()).max(share(&body.rounded.omega, &speed)).max(1.0)
}

/// Refuses an accuracy finer than the conditioning of the motion permits. Where a bound that costs nothing
/// does not decide, the derivatives of the motion by its initial spin and its moments do, at the end and at
/// the last flip, where the spin moves the most.
fn attainable(
    motion: &FreeMotion,
    regime: Regime,
    body: &Principal,
    end: f64,
    accuracy: f64,
) -> Result<(), Error> {
    let speed = motion.omega(0.0)?.norm();
    if !(speed * end).is_finite() {
        return Err(Error::OutOfRange { what: "the angle turned up to the last time", value: speed * end });
    }
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
    let mut worst = 1.0_f64;
    let rounded = body.rounded;
    let flip = motion.flips(0.0, end)?.next_back();
    for time in flip.into_iter().chain([end]) {
        let (by_start, by_tensor) = motion.sensitivities(time)?;
        for j in 0..3 {
            let change = |row: usize| {
                by_start.fixed_view::<3, 1>(row, 3 + j).norm() * rounded.omega[j]
                    + by_tensor.fixed_view::<3, 1>(row, j).norm() * rounded.moments[j]
            };
            worst = worst.max(change(3) / speed).max(change(0));
        }
    }
    allowed(accuracy, ROUNDINGS * f64::EPSILON * worst)
}
