//! How well engines' rules integrate the body, frame by frame, compared with the exact motion.

use super::row;
use crate::of_body::{Kind, Subject};
use crate::units;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::error::Error;
use std::f64::consts::TAU;
use tumbling::PrincipalMoments;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, PositionStage, State, System};
use tumbling_engines::PHYSICS_ENGINES;

/// The duration of the comparison, turns.
const TURNS: u32 = 10;
/// Frames a turn: 60 a second at a turn a second.
const FRAMES: u32 = 60;
/// The push about the largest axis, as a part of the spin: it flips within a turn or a few.
const PUSH: f64 = 0.1;
/// The largest accepted error of energy and of momentum.
const ALLOWED: f64 = 0.01;
/// The largest accepted error of the attitude at the end, rad.
const ANGLE: f64 = 0.1;
/// More frames a turn are not tried.
const MOST: u32 = 4096;

/// The rules that are compared: methods of the library, and `None` for its position stage.
const RULES: [(&str, Option<Method>); 6] = [
    ("constant spin", Some(Method::ConstantSpin)),
    ("semi-implicit Euler", Some(Method::SemiImplicitEuler)),
    ("the same, rescaled", Some(Method::Rescaled)),
    ("one Newton step", Some(Method::ImplicitOneNewton)),
    ("Runge-Kutta 4", Some(Method::RungeKutta4)),
    ("the position stage of this library", None),
];

/// Some engines that use a method in one of their settings.
fn engines(method: Method) -> String {
    let rows = PHYSICS_ENGINES.iter().filter(|engine| engine.method == method);
    let mut names: Vec<_> = rows.map(|engine| engine.name).collect();
    names.dedup();
    names.truncate(3);
    if names.is_empty() { String::new() } else { format!(" ({})", names.join(", ")) }
}

/// Errors over the run.
#[derive(Debug, Clone, Copy, Default)]
struct Errors {
    /// The greatest of the energy, relative to the start.
    energy: f64,
    /// The greatest of the momentum in the world, relative to the start.
    momentum: f64,
    /// Of the attitude at the end, rad.
    attitude: f64,
}

/// The spin at the start along the principal axes, in parts of the whole.
fn start(subject: &Subject<'_>) -> Vector3<f64> {
    match subject.kind {
        Kind::Three => Vector3::new(0.0, PUSH.cos(), PUSH.sin()),
        _ => Vector3::new(0.5, 0.0, 0.75_f64.sqrt()),
    }
}

type Ran = Result<Option<Errors>, Box<dyn Error>>;

/// `None` where the rule breaks down, or energy or momentum is off by more than is allowed.
fn run(rule: Option<Method>, subject: &Subject<'_>, frames: u32, allowed: f64) -> Ran {
    // In units of the largest moment and of the spin: the errors do not depend on these units, and nothing
    // overflows.
    let moments = PrincipalMoments::try_from(subject.moments.vector() / subject.moments.vector().z)?;
    let omega = start(subject);
    let motion = FreeMotion::new(moments, &omega)?;
    let system = System::free(moments)?;
    let mut state = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    let (energy, momentum) = (system.energy(&state), state.momentum);
    let h = TAU / f64::from(frames);
    let stage = PositionStage::new(&moments.vector())?;
    let mut errors = Errors::default();
    let mut spin = omega; // in world axes
    for _ in 0..TURNS * frames {
        match rule {
            Some(method) => match method.step(&system, &state, h) {
                Ok(next) => state = next,
                Err(_) => return Ok(None),
            },
            None => {
                let end = stage.step(&state.attitude, &spin, h);
                spin = end.omega;
                let in_body = UnitQuaternion::new_normalize(end.attitude).inverse() * spin;
                state = State { attitude: end.attitude, momentum: system.momentum(&in_body) };
            }
        }
        let in_world = UnitQuaternion::new_normalize(state.attitude) * state.momentum;
        let off = (in_world - momentum).norm() / momentum.norm();
        errors.energy = errors.energy.max((system.energy(&state) / energy - 1.0).abs());
        errors.momentum = errors.momentum.max(off);
        if !(errors.energy + off).is_finite() || errors.energy.max(off) > allowed {
            return Ok(None);
        }
    }
    let exact = motion.attitude(f64::from(TURNS) * TAU)?;
    errors.attitude = UnitQuaternion::new_normalize(state.attitude).angle_to(&exact);
    Ok(Some(errors))
}

/// The fewest frames a turn, out of 4, 6, 8, 12, 16, ..., that keep energy, momentum and attitude; `None` if
/// it is above [`MOST`].
fn needed(rule: Option<Method>, subject: &Subject<'_>) -> Result<Option<u32>, Box<dyn Error>> {
    for frames in (2..12).flat_map(|k| [1 << k, 3 << (k - 1)]).chain([MOST]) {
        if run(rule, subject, frames, ALLOWED)?.is_some_and(|e| e.attitude <= ANGLE) {
            return Ok(Some(frames));
        }
    }
    Ok(None)
}

fn share(error: f64) -> String {
    match error {
        ..1e-12 => "to rounding".into(),
        1e-12..1e-3 => units::significant(error, 2),
        10.0.. => "more than 1000 %".into(),
        _ => format!("{} %", units::significant(100.0 * error, 2)),
    }
}

pub(super) fn section(subject: &Subject<'_>) -> Result<String, Box<dyn Error>> {
    let frame = units::TIME.say(TAU / subject.spin / f64::from(FRAMES));
    let mut out = format!(
        "<section><h2>The step that an engine needs</h2>\n<p>{TURNS} turns at {FRAMES} frames a turn (a frame each {frame}), {}: \
         greatest errors, and the fewest frames a turn with energy and momentum right to 1 % and the attitude at the end to {:.0}°</p>\n<table><tr><th scope=\"col\">rule</th>\
         <th scope=\"col\">energy</th><th scope=\"col\">momentum</th><th scope=\"col\">attitude at the end</th>\
         <th scope=\"col\">frames a turn needed</th></tr>\n",
        match subject.kind {
            Kind::Three => "spun about axis 2 with a slip of 0.1",
            _ => "spun between axes 1 and 3",
        },
        ANGLE.to_degrees()
    );
    for (name, rule) in RULES {
        let cells = match run(rule, subject, FRAMES, f64::INFINITY)? {
            Some(errors) => {
                let needed = needed(rule, subject)?;
                let angle = format!("{}°", units::significant(errors.attitude.to_degrees(), 2));
                let needed = needed.map_or(format!("more than {MOST}"), |frames| frames.to_string());
                [share(errors.energy), share(errors.momentum), angle, needed]
            }
            None => ["breaks down", "breaks down", "", ""].map(String::from),
        };
        out += &row(&format!("{name}{}", rule.map_or_else(String::new, engines)), &cells);
    }
    out += "</table>\n</section>\n";
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tumbling_bodies::BodyModel;

    #[test]
    fn neither_the_unit_of_moments_nor_that_of_time_changes_an_error() {
        let section = |text: &str| {
            let body = BodyModel::from_toml(text, "".as_ref()).unwrap();
            let page = section(&Subject::new(&body).unwrap()).unwrap();
            page.split_once("<table>").unwrap().1.to_owned()
        };
        let page = section("moments = [1, 2, 2.5]");
        assert!(!page.contains("breaks down"));
        for far in ["moments = [1e300, 2e300, 2.5e300]", "moments = [1, 2, 2.5]\nspin = 1e200"] {
            assert_eq!(section(far), page);
        }
    }

    #[test]
    fn the_position_stage_keeps_both_laws_and_a_constant_spin_does_not() {
        let phone = BodyModel::load("phone").unwrap();
        let subject = Subject::new(&phone).unwrap();
        let errors = |rule: Option<Method>| run(rule, &subject, FRAMES, f64::INFINITY).unwrap().unwrap();
        let stage = errors(None);
        assert!(stage.energy < 1e-12 && stage.momentum < 1e-12, "{stage:?}");
        let constant = errors(Some(Method::ConstantSpin));
        assert!(constant.energy < 1e-12 && constant.momentum > 0.01, "{constant:?}");
        // A method of order 4: with twice the frames, the error of the attitude is about 16 times smaller.
        let fourth =
            |frames| run(Some(Method::RungeKutta4), &subject, frames, f64::INFINITY).unwrap().unwrap();
        let gain = fourth(240).attitude / fourth(480).attitude;
        assert!((12.0..20.0).contains(&gain), "{gain}");
    }
}
