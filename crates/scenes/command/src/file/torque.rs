//! A torque from its table in a file.

use nalgebra::Vector3;
use serde::Deserialize;
use toml::Spanned;
use tumbling::Subject;
use tumbling::step::Torque;
use tumbling_bodies::{Error, list, table};

type Vector = Option<Spanned<[f64; 3]>>;
type Number = Option<Spanned<f64>>;

table! {
    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields, rename_all = "kebab-case")]
    pub(super) struct TorqueTable {
        #[serde(default, deserialize_with = "list")]
        in_body as "in-body": [f64; 3],
        #[serde(default, deserialize_with = "list")]
        in_world as "in-world": [f64; 3],
        #[serde(default, deserialize_with = "list")]
        arm: [f64; 3],
        #[serde(default, deserialize_with = "list")]
        field: [f64; 3],
        #[serde(default, deserialize_with = "list")]
        moment: [f64; 3],
        #[serde(default, deserialize_with = "list")]
        rest: [f64; 3],
        stiffness: f64,
        #[serde(default, deserialize_with = "list")]
        damping: [f64; 3],
        dissipation: f64,
        #[serde(default, deserialize_with = "list")]
        toward: [f64; 3],
        #[serde(default, deserialize_with = "list")]
        orbit: [f64; 3],
        strength: f64,
        #[serde(default, deserialize_with = "list")]
        amplitude: [f64; 3],
        rate: f64,
        phase: f64,
        from: f64,
        to: f64,
    }
}

/// The fields of each kind of torque: those required, and those that are optional.
const KINDS: [(&[&str], &[&str]); 10] = [
    (&["in-body"], &[]),
    (&["in-world"], &[]),
    (&["arm", "field"], &[]),
    (&["moment", "field"], &[]),
    (&["arm", "rest", "stiffness"], &[]),
    (&["damping"], &[]),
    (&["dissipation"], &[]),
    (&["toward", "orbit"], &["strength"]),
    (&["toward", "strength"], &["orbit"]),
    (&["amplitude", "rate"], &["phase"]),
];

/// Checks that the fields are those of one kind.
fn check(text: &str, table: &Spanned<TorqueTable>) -> Result<(), Error> {
    let mut present = table.get_ref().present();
    present.retain(|(field, _)| !["from", "to"].contains(field));
    let has = |field: &&str| present.iter().any(|(name, _)| name == field);
    let goes = |(needed, more): &(&[&str], &[&str])| {
        present.iter().all(|(field, _)| needed.contains(field) || more.contains(field))
    };
    let named = |(needed, _): &(&[&str], &[&str])| {
        needed.iter().map(|field| format!("`{field}`")).collect::<Vec<_>>().join(" with ")
    };
    let kinds: Vec<_> = KINDS.iter().filter(|kind| goes(kind)).collect();
    if kinds.iter().any(|(needed, _)| needed.iter().all(has)) {
        return Ok(());
    }
    let all = kinds.iter().map(|kind| named(kind)).collect::<Vec<_>>().join(", or ");
    Err(match (present.first(), kinds.is_empty()) {
        (None, _) => Error::at(text, &table.span(), format!("the kind of this torque is missing: {all}")),
        (_, true) => {
            let why = "one kind of torque is expected in each `[[torque]]`, not two";
            Error::at(text, &table.span(), why).of_field("torque")
        }
        (Some((field, span)), _) => {
            Error::at(text, span, format!("it is a part of {all}, and the rest is missing")).of_field(field)
        }
    })
}

pub(super) fn read(text: &str, table: &Spanned<TorqueTable>) -> Result<Torque<f64>, Error> {
    check(text, table)?;
    let t = table.get_ref();
    let vector = |field: &Vector| field.as_ref().map(|v| Vector3::from(*v.get_ref())).unwrap_or_default();
    let number = |field: &Number| field.as_ref().map(|x| *x.get_ref());
    let torque = if t.in_body.is_some() {
        Torque::InBody(vector(&t.in_body))
    } else if t.in_world.is_some() {
        Torque::InWorld(vector(&t.in_world))
    } else if let Some(stiffness) = number(&t.stiffness) {
        Torque::spring(&vector(&t.arm), &vector(&t.rest), stiffness)
    } else if t.arm.is_some() {
        Torque::Aligning { arm: vector(&t.arm), field: vector(&t.field) }
    } else if t.moment.is_some() {
        Torque::Aligning { arm: vector(&t.moment), field: vector(&t.field) }
    } else if t.damping.is_some() {
        Torque::Damping(vector(&t.damping))
    } else if let Some(strength) = number(&t.dissipation) {
        Torque::Dissipation(strength)
    } else if let Some(strength) = number(&t.strength) {
        Torque::GravityGradient { strength, direction: vector(&t.toward), orbit: vector(&t.orbit) }
    } else if t.toward.is_some() {
        Torque::gravity_gradient(&vector(&t.toward), &vector(&t.orbit))
    } else {
        let (rate, phase) = (number(&t.rate).unwrap_or_default(), number(&t.phase).unwrap_or_default());
        Torque::Periodic { amplitude: vector(&t.amplitude), rate, phase }
    };
    Ok(match (number(&t.from), number(&t.to)) {
        (None, None) => torque,
        (from, to) => Torque::during(from.unwrap_or(f64::NEG_INFINITY), to.unwrap_or(f64::INFINITY), torque),
    })
}

/// An error of the library, at the field that it is about.
pub(super) fn refused(text: &str, table: &Spanned<TorqueTable>, error: &tumbling::Error) -> Error {
    // Of each subject the fields that it may come from, the first that the table has.
    let long = |t: &TorqueTable| {
        t.rest.as_ref().zip(t.stiffness.as_ref()).is_some_and(|(rest, stiffness)| {
            rest.get_ref().iter().any(|x| x.abs() > stiffness.get_ref().abs())
        })
    };
    let from: &[&str] = match error.subject() {
        Subject::Torque => &["in-body", "in-world", "amplitude"],
        Subject::Arm => &["arm", "moment"],
        Subject::Field if long(table.get_ref()) => &["rest"],
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
        _ => &[],
    };
    let present = table.get_ref().present();
    match from.iter().find_map(|name| present.iter().find(|(field, _)| field == name)) {
        Some((field, span)) => Error::at(text, span, error).of_field(field),
        None => Error::at(text, &table.span(), error).of_field("torque"),
    }
}
