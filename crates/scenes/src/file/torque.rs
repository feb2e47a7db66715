//! A torque from its table in a file, and back.

use super::fields::Fields;
use super::write::{list, number};
use crate::error::Error;
use nalgebra::Vector3;
use tumbling::Subject;
use tumbling::step::Torque;

/// All fields that a torque may have.
pub(super) const FIELDS: [&str; 17] = [
    "in-body",
    "in-world",
    "arm",
    "field",
    "moment",
    "rest",
    "stiffness",
    "damping",
    "dissipation",
    "toward",
    "orbit",
    "strength",
    "amplitude",
    "rate",
    "phase",
    "from",
    "to",
];

pub(super) fn read(table: &Fields<'_, '_>) -> Result<Torque<f64>, Error> {
    let found = [
        table.vector("in-body")?.map(Torque::InBody),
        table.vector("in-world")?.map(Torque::InWorld),
        aligning(table)?,
        table.vector("damping")?.map(Torque::Damping),
        table.number("dissipation")?.map(Torque::Dissipation),
        gradient(table)?,
        periodic(table)?,
    ];
    let mut found = found.into_iter().flatten();
    let torque = match (found.next(), found.next()) {
        (Some(one), None) => one,
        (None, _) => {
            return Err(table.missing(
                "the kind of this torque, `in-body`, `in-world`, `arm` and `field`, `moment` and `field`, \
                 `arm`, `rest` and `stiffness`, `damping`, `dissipation`, `toward` and `orbit`, or `amplitude` and `rate`,",
            ));
        }
        (Some(_), Some(_)) => return Err(two_kinds(table)),
    };
    Ok(match (table.number("from")?, table.number("to")?) {
        (None, None) => torque,
        (from, to) => Torque::during(from.unwrap_or(f64::NEG_INFINITY), to.unwrap_or(f64::INFINITY), torque),
    })
}

fn two_kinds(table: &Fields<'_, '_>) -> Error {
    Error::File {
        line: Some(table.lines.at(&table.span)),
        field: Some("torque".into()),
        why: "one kind of torque is expected in each `[[torque]]`, not two".into(),
    }
}

/// A weight, a magnet or a spring.
fn aligning(table: &Fields<'_, '_>) -> Result<Option<Torque<f64>>, Error> {
    let (arm, field) = (table.vector("arm")?, table.vector("field")?);
    let (moment, rest, stiffness) =
        (table.vector("moment")?, table.vector("rest")?, table.number("stiffness")?);
    Ok(Some(match (arm, moment, field, rest, stiffness) {
        (Some(arm), None, Some(field), None, None) => Torque::Aligning { arm, field },
        (None, Some(moment), Some(field), None, None) => Torque::magnetic(&moment, &field),
        (Some(arm), None, None, Some(rest), Some(stiffness)) => Torque::spring(&arm, &rest, stiffness),
        (None, None, None, None, None) => return Ok(None),
        (None, None, Some(_), None, None) => return Err(table.alone("field", "`arm` (m) or `moment` (A m²)")),
        (Some(_), None, None, None, None) => return Err(table.alone("arm", "`field` (N)")),
        (None, Some(_), None, None, None) => return Err(table.alone("moment", "`field` (T)")),
        (None, None, None, Some(_), _) => return Err(table.alone("rest", "`arm`")),
        (None, None, None, None, Some(_)) => return Err(table.alone("stiffness", "`arm`")),
        (Some(_), None, None, Some(_), None) => return Err(table.alone("rest", "`stiffness` (N m)")),
        (Some(_), None, None, None, Some(_)) => return Err(table.alone("stiffness", "`rest`")),
        _ => return Err(two_kinds(table)),
    }))
}

/// The gravity gradient: of a circular orbit, or of another strength.
fn gradient(table: &Fields<'_, '_>) -> Result<Option<Torque<f64>>, Error> {
    let (direction, orbit) = (table.vector("toward")?, table.vector("orbit")?);
    Ok(Some(match (direction, orbit, table.number("strength")?) {
        (None, None, None) => return Ok(None),
        (Some(toward), Some(orbit), None) => Torque::gravity_gradient(&toward, &orbit),
        (Some(direction), orbit, Some(strength)) => {
            Torque::GravityGradient { strength, direction, orbit: orbit.unwrap_or_else(Vector3::zeros) }
        }
        (Some(_), None, None) => return Err(table.alone("toward", "`orbit` (rad/s) or `strength` (1/s²)")),
        (None, Some(_), _) => return Err(table.alone("orbit", "`toward`")),
        (None, None, Some(_)) => return Err(table.alone("strength", "`toward`")),
    }))
}

fn periodic(table: &Fields<'_, '_>) -> Result<Option<Torque<f64>>, Error> {
    Ok(Some(match (table.vector("amplitude")?, table.number("rate")?, table.number("phase")?) {
        (None, None, None) => return Ok(None),
        (Some(amplitude), Some(rate), phase) => {
            Torque::Periodic { amplitude, rate, phase: phase.unwrap_or(0.0) }
        }
        (Some(_), None, _) => return Err(table.alone("amplitude", "`rate` (rad/s)")),
        (None, Some(_), _) => return Err(table.alone("rate", "`amplitude` (N m)")),
        (None, None, Some(_)) => return Err(table.alone("phase", "`amplitude` (N m)")),
    }))
}

/// The field that the library refuses.
pub(super) fn field(table: &Fields<'_, '_>, error: &tumbling::Error) -> &'static str {
    // Of each subject the fields that it may come from, the first that the table has.
    let from: &[&str] = match error.subject() {
        Subject::Torque => &["in-body", "in-world", "amplitude"],
        Subject::Arm => &["arm", "moment"],
        Subject::Field => &["stiffness", "field"],
        Subject::DampingCoefficient => &["damping"],
        Subject::DissipationStrength => &["dissipation"],
        Subject::GradientStrength => &["strength", "orbit"],
        Subject::GradientDirection => &["toward"],
        Subject::OrbitRate => &["orbit"],
        Subject::PeriodicRate => &["rate"],
        Subject::PeriodicPhase => &["phase"],
        Subject::TorqueStart => &["from"],
        Subject::TorqueEnd => &["to"],
        _ => &FIELDS,
    };
    from.iter().copied().find(|field| table.get(field).is_some()).unwrap_or_default()
}

/// The lines of its table.
pub(super) fn write(torque: &Torque<f64>) -> String {
    match torque {
        Torque::InBody(value) => format!("in-body = {} # N m\n", list(value.as_slice())),
        Torque::InWorld(value) => format!("in-world = {} # N m\n", list(value.as_slice())),
        Torque::Aligning { arm, field } => {
            format!("arm = {}\nfield = {}\n", list(arm.as_slice()), list(field.as_slice()))
        }
        Torque::Damping(value) => format!("damping = {} # N m s\n", list(value.as_slice())),
        Torque::Dissipation(strength) => format!("dissipation = {} # s/(kg m²)\n", number(*strength)),
        Torque::GravityGradient { strength, direction, orbit } => format!(
            "toward = {}\norbit = {} # rad/s\nstrength = {} # 1/s²\n",
            list(direction.as_slice()),
            list(orbit.as_slice()),
            number(*strength)
        ),
        Torque::Periodic { amplitude, rate, phase } => format!(
            "amplitude = {} # N m\nrate = {} # rad/s\nphase = {} # rad\n",
            list(amplitude.as_slice()),
            number(*rate),
            number(*phase)
        ),
        // A scene has no window of time within another, and none without a bound.
        Torque::During { start, end, torque } => {
            let bounds = [("from", start), ("to", end)].into_iter().filter(|(_, time)| time.is_finite());
            let bounds: String =
                bounds.map(|(name, time)| format!("{name} = {} # s\n", number(*time))).collect();
            bounds + &write(torque)
        }
        _ => format!("# a torque that files cannot hold: {torque:?}\n"),
    }
}
