//! Ways to answer for a free body, and how right they can be.

use super::plan::{Rotation, Top, Way};
use super::{Principal, Wants};
use crate::dynamics::regime::{Kind, classify};
use crate::error::{Error, Refusal};
use crate::exact::{FreeMotion, Precession, Regime, Turn, scaled};
use crate::number::power_of_two::times_power_of_two;
use nalgebra::Vector3;

/// So many roundings of its own the closed form may be off, each as large as the motion makes that of an input.
const ROUNDINGS: f64 = 16.0;

/// The cheapest way.
pub(super) fn way(body: &Principal, wants: Wants, end: f64, accuracy: f64) -> Result<Way, Error> {
    let (moments, omega): ([f64; 3], [f64; 3]) = (body.moments.into(), body.omega.into());
    let kind = classify(body.moments, &body.omega);
    let follows = wants.attitude || wants.spin || (wants.gap && matches!(kind, Kind::Asymmetric(_)));
    if !follows {
        if wants.flips && matches!(kind, Kind::Asymmetric(_)) {
            let motion = FreeMotion::new(body.moments, &body.omega)?;
            attainable(&motion, body, end, accuracy)?;
        }
        return Ok(Way::Nothing);
    }
    let in_body = |wanted: bool| wanted.then(|| body.in_body(body.omega));
    let (unit_moments, unit_omega, exponent) = scaled(&moments, &omega);
    let clock = times_power_of_two(1.0, exponent);
    let speed = body.omega.norm();
    let turned = (speed * end).max(1.0);
    let coarser = coarser(body);
    let elementary = || allowed(accuracy, ROUNDINGS * f64::EPSILON * turned * coarser);
    match kind {
        Kind::Steady if !wants.attitude => Ok(Way::Constant { spin: in_body(true), attitude: None }),
        Kind::Steady if body.omega == Vector3::zeros() => {
            Ok(Way::Constant { spin: in_body(wants.spin), attitude: Some(body.attitude) })
        }
        Kind::Steady => {
            elementary()?;
            let turn = Turn::along(unit_omega.map(Into::into));
            Ok(Way::Rotation(Rotation { turn, clock, spin: in_body(wants.spin) }))
        }
        Kind::Symmetric(axis) => {
            elementary()?;
            let precession = Precession::new(&unit_moments, axis, &unit_omega, &body.omega);
            Ok(Way::SymmetricTop(Top { precession, clock }))
        }
        Kind::Asymmetric(_) => {
            let motion = Box::new(FreeMotion::new(body.moments, &body.omega)?);
            attainable(&motion, body, end, accuracy)?;
            Ok(if wants.attitude { Way::Elliptic(motion) } else { Way::EllipticSpin(motion) })
        }
    }
}

fn allowed(asked: f64, attainable: f64) -> Result<(), Error> {
    if asked >= attainable { Ok(()) } else { Err(Refusal::Unattainable { asked, attainable }.into()) }
}

/// How many times as much as their own size some of the body's numbers may be rounded by.
fn coarser(body: &Principal) -> f64 {
    let share = |rounded: &Vector3<f64>, size: &Vector3<f64>| {
        rounded.zip_map(size, |rounded, size| if rounded == 0.0 { 1.0 } else { rounded / size }).max()
    };
    let speed = Vector3::repeat(body.omega.norm().max(f64::MIN_POSITIVE));
    share(&body.rounded.moments, &body.moments.vector()).max(share(&body.rounded.omega, &speed)).max(1.0)
}

/// Refuses an accuracy below what the conditioning of the motion leaves. Where a bound that costs nothing does not settle it, the
/// derivatives of the motion by its start and its moments do, at the end and at the last flip, where the spin moves the most.
fn attainable(motion: &FreeMotion, body: &Principal, end: f64, accuracy: f64) -> Result<(), Error> {
    let speed = motion.omega(0.0)?.norm();
    if !(speed * end).is_finite() {
        return Err(
            Refusal::OutOfRange { what: "the angle turned up to the last time", value: speed * end }.into()
        );
    }
    let complement = match motion.regime() {
        Regime::Circulating { complement, .. } => complement,
        _ => 0.0,
    };
    let moments = motion.moments();
    let thin = moments.largest() / moments.smallest();
    let bound =
        ROUNDINGS * f64::EPSILON * thin * coarser(body) * (speed * end).max(1.0) / (complement * complement);
    if accuracy >= bound {
        return Ok(());
    }
    let mut worst = 1.0_f64;
    let rounded = body.rounded;
    let flip = motion.flips(0.0, end)?.next_back();
    for time in flip.into_iter().chain([end]) {
        let (by_start, by_tensor) = (motion.state_transition(time)?, motion.tensor_sensitivity(time)?);
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
