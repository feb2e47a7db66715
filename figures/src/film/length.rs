//! The length of a film: until the motion starts again, if it does.

use super::{Camera, Request, thrown};
use std::error::Error;
use std::f64::consts::{PI, TAU};
use tumbling::Axis;
use tumbling::exact::FreeMotion;
use tumbling_bodies::BodyModel;

/// The length of a film, and its camera.
#[derive(Debug)]
pub(super) struct Length {
    /// Of the film, s.
    pub(super) film: f64,
    /// Of the motion that it shows, s.
    pub(super) motion: f64,
    pub(super) camera: Camera,
    /// The angle about the momentum from the first attitude to the attitude at the next return to the first
    /// spin, rad.
    pub(super) missing: f64,
    /// The reason for the choice, in words.
    pub(super) why: String,
}

/// The longest film whose length was not requested, s.
const LONGEST: f64 = 30.0;

/// An error that counts as closed, rad: it is too small to see.
const CLOSED: f64 = 2e-3;

type Chosen = Result<(f64, Length), Box<dyn Error>>;

/// The push, and the length of the film with it.
pub(super) fn choose(model: &BodyModel, request: &Request) -> Chosen {
    let usual = if request.axis == Axis::Middle { 0.02 } else { 0.2 };
    let room = request.camera.is_none_or(|camera| camera == Camera::Room);
    let push = match request.push {
        Some(push) => push,
        None if room && request.seconds.is_none() => closing(model, request, usual).unwrap_or(usual),
        None => usual,
    };
    let body = thrown(model, request, push)?;
    let motion = FreeMotion::of(&body)?;
    // A turn of the first spin takes a second of the film.
    let pace = body.omega_body().norm() / TAU;
    let shown = if (pace - 1.0).abs() < 0.02 {
        String::new()
    } else if pace > 1.0 {
        format!(", slowed down {pace:.1} times")
    } else {
        format!(", sped up {:.1} times", 1.0 / pace)
    };
    let length = |motion: f64, camera: Camera, missing: f64, why: String| {
        let film = motion * pace;
        (push, Length { film, motion, camera, missing, why: format!("{film:.2} s{shown}, {why}") })
    };
    let asked = request.camera.unwrap_or(Camera::Room);
    if let Some(seconds) = request.seconds {
        return Ok(length(seconds / pace, asked, 0.0, "as requested".into()));
    }
    let Some(period) = motion.period()? else {
        return Ok(length(1.0 / pace, asked, 0.0, "a turn of a steady spin".into()));
    };
    if period * pace > LONGEST {
        let why = format!("of the {:.2} s after which the spin comes back", period * pace);
        return Ok(length(LONGEST / pace, asked, 0.0, why));
    }
    let twist = 2.0 * motion.twist_of_half_period().unwrap_or(0.0);
    let once = wrapped(twist);
    match request.camera {
        Some(Camera::Body) => Ok(length(period, Camera::Body, 0.0, "until the spin comes back".into())),
        Some(Camera::Momentum) => Ok(length(period, Camera::Momentum, once, turning(once))),
        chosen => {
            let most = (LONGEST / (period * pace)).floor().max(1.0) as u32;
            let best = nearest(twist, most);
            let missing = wrapped(f64::from(best) * twist);
            if chosen.is_none() && missing.abs() > CLOSED {
                return Ok(length(period, Camera::Momentum, once, turning(once)));
            }
            let why = match best {
                1 => "until spin and attitude come back".into(),
                n => format!("until the spin has come back {n} times and the attitude nearly"),
            };
            Ok(length(f64::from(best) * period, Camera::Room, 0.0, why))
        }
    }
}

fn turning(missing: f64) -> String {
    format!(
        "until the spin comes back, the camera turning by {:.1} degrees about the momentum",
        missing.to_degrees()
    )
}

/// The number of periods, at most `most`, after which the attitude is nearest to the first one: the smallest
/// number that closes the film, or else the best.
fn nearest(twist: f64, most: u32) -> u32 {
    let off = |n: u32| wrapped(f64::from(n) * twist).abs();
    let closed = (1..=most).find(|&n| off(n) < CLOSED);
    closed.or_else(|| (1..=most).min_by(|&a, &b| off(a).total_cmp(&off(b)))).unwrap_or(1)
}

/// Between -π and π.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * ((angle + PI) / TAU).floor()
}

/// The push nearest to the usual one with which the body returns to its first spin and its first attitude at
/// the same time. Then the film closes for a camera at rest.
fn closing(model: &BodyModel, request: &Request, usual: f64) -> Option<f64> {
    let missing = |push: f64| -> Option<f64> {
        let motion = FreeMotion::of(&thrown(model, request, push).ok()?).ok()?;
        let film = motion.period().ok()?? * request.spin.abs() / TAU;
        (film < LONGEST).then_some(wrapped(2.0 * motion.twist_of_half_period()?))
    };
    let grid: Vec<f64> = (-60..=60).map(|i| usual * 3.0_f64.powf(f64::from(i) / 60.0)).collect();
    let between = |pair: &[f64]| -> Option<f64> {
        let (mut low, mut high) = (pair[0], pair[1]);
        let (a, b) = (missing(low)?, missing(high)?);
        // A change of sign near zero, not a jump by a whole turn.
        if a * b > 0.0 || (a - b).abs() > PI {
            return None;
        }
        for _ in 0..60 {
            let middle = (low * high).sqrt();
            if missing(middle)? * a > 0.0 { low = middle } else { high = middle }
        }
        Some(low)
    };
    let far = |push: &f64| (push / usual).ln().abs();
    grid.windows(2).filter_map(between).min_by(|a, b| far(a).total_cmp(&far(b)))
}
