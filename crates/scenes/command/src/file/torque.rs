//! A torque from its table in a file.

use nalgebra::Vector3;
use serde::Deserialize;
use std::ops::Range;
use toml::Spanned;
use tumbling::Subject;
use tumbling::step::Torque;
use tumbling_bodies::{Error, list};

type Vector = Option<Spanned<[f64; 3]>>;
type Number = Option<Spanned<f64>>;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct TorqueTable {
    #[serde(default, deserialize_with = "list")]
    in_body: Vector,
    #[serde(default, deserialize_with = "list")]
    in_world: Vector,
    #[serde(default, deserialize_with = "list")]
    arm: Vector,
    #[serde(default, deserialize_with = "list")]
    field: Vector,
    #[serde(default, deserialize_with = "list")]
    moment: Vector,
    #[serde(default, deserialize_with = "list")]
    rest: Vector,
    stiffness: Number,
    #[serde(default, deserialize_with = "list")]
    damping: Vector,
    dissipation: Number,
    #[serde(default, deserialize_with = "list")]
    toward: Vector,
    #[serde(default, deserialize_with = "list")]
    orbit: Vector,
    strength: Number,
    #[serde(default, deserialize_with = "list")]
    amplitude: Vector,
    rate: Number,
    phase: Number,
    from: Number,
    to: Number,
}

/// The fields of each kind of torque, those that may be left out in a list of their own.
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

impl TorqueTable {
    /// The fields that there are, and where.
    fn present(&self) -> Vec<(&'static str, Range<usize>)> {
        macro_rules! spans {
            ($($name:literal $field:ident)*) => { [$(($name, self.$field.as_ref().map(Spanned::span))),*] };
        }
        let all = spans!("in-body" in_body "in-world" in_world "arm" arm "field" field "moment" moment
            "rest" rest "stiffness" stiffness "damping" damping "dissipation" dissipation "toward" toward
            "orbit" orbit "strength" strength "amplitude" amplitude "rate" rate "phase" phase
            "from" from "to" to);
        all.into_iter().filter_map(|(name, span)| Some((name, span?))).collect()
    }
}

/// That the fields are those of one kind.
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
        Torque::magnetic(&vector(&t.moment), &vector(&t.field))
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

/// A refusal of the library, at the field that it is about.
pub(super) fn refused(text: &str, table: &Spanned<TorqueTable>, error: &tumbling::Error) -> Error {
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
        _ => &[],
    };
    let present = table.get_ref().present();
    match from.iter().find_map(|name| present.iter().find(|(field, _)| field == name)) {
        Some((field, span)) => Error::at(text, span, error).of_field(field),
        None => Error::at(text, &table.span(), error).of_field("torque"),
    }
}
