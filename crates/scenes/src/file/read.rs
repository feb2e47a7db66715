//! A scene from the text of a file.

use super::fields::{Fields, Lines, nearest};
use super::{BODY, File, OUTPUTS, Place, SCENE, torque};
use crate::error::Error;
use crate::initial_state::{InitialState, Start};
use crate::outputs::Outputs;
use crate::scene::Scene;
use crate::times::Times;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A scene from the text of a file.
///
/// # Errors
/// [`Error::File`] with the line, the field and what was expected. An invalid body is refused when it is
/// planned.
pub fn read(text: &str) -> Result<File, Error> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines = Lines::of(text);
    let root = DeTable::parse(text).map_err(|error| Error::File {
        line: error.span().map(|span| lines.at(&span)),
        field: None,
        why: error.message().to_owned(),
    })?;
    let root = Fields::new(&lines, root.get_ref(), 0..0, &SCENE)?;
    let accuracy = root.number("accuracy")?.ok_or_else(|| root.missing("the field `accuracy`"))?;
    let times = times(&root)?;
    let outputs = outputs(&root)?;
    let bodies = root.tables("body", &BODY)?;
    if bodies.is_empty() {
        return Err(root.missing("a body, `[[body]]`,"));
    }
    let states = bodies.iter().map(initial_state).collect::<Result<Vec<_>, _>>()?;
    let torque_tables = root.tables("torque", &torque::FIELDS)?;
    let torques = torque_tables.iter().map(torque::read).collect::<Result<_, _>>()?;
    times.validate().map_err(|error| {
        let field = match &times {
            Times::Given(_) => "times",
            Times::Every { span, .. } if *span < 0.0 => "span",
            Times::Every { .. } => "every",
        };
        root.refused(field, &error)
    })?;
    let scene = Scene::new(states, torques, times, outputs, accuracy).map_err(|error| match error {
        Error::Torque { index, source } => match torque_tables.get(index) {
            Some(table) => table.refused(torque::field(table, &source), &source),
            None => Error::File { line: None, field: None, why: source.to_string() },
        },
        // Bodies and times are there and right: this is all that is left.
        other => root.refused("accuracy", &other),
    })?;
    let place = |body: &Fields<'_, '_>| Place {
        line: lines.at(&body.span),
        fields: BODY.into_iter().filter_map(|name| Some((name, lines.at(&body.get(name)?.span())))).collect(),
    };
    Ok(File { scene, bodies: bodies.iter().map(place).collect() })
}

fn times(root: &Fields<'_, '_>) -> Result<Times, Error> {
    match (root.numbers("times")?, root.number("every")?, root.number("span")?) {
        (Some(times), None, None) => Ok(Times::Given(times)),
        (None, Some(step), Some(span)) => Ok(Times::Every { step, span }),
        (Some(_), _, _) => {
            let span = root.get("times").map_or(0..0, Spanned::span);
            Err(root.lines.wrong(
                &span,
                "times",
                "either `times` or `every` and `span` are expected, not both",
            ))
        }
        (None, None, Some(_)) => Err(root.alone("span", "`every`")),
        (None, Some(_), None) => Err(root.alone("every", "`span`")),
        (None, None, None) => Err(root.missing("`every` and `span`, or `times`,")),
    }
}

fn outputs(root: &Fields<'_, '_>) -> Result<Outputs, Error> {
    let value = root.get("wants").ok_or_else(|| root.missing("the field `wants`"))?;
    let DeValue::Array(list) = value.get_ref() else {
        return Err(root.expected("wants", value, "a list of words"));
    };
    let mut outputs = Outputs::NOTHING;
    for item in list.iter() {
        let DeValue::String(word) = item.get_ref() else {
            return Err(root.expected("wants", item, "a word"));
        };
        let requested = match word.as_ref() {
            "spin" => &mut outputs.spin,
            "attitude" => &mut outputs.attitude,
            "energy" => &mut outputs.energy,
            "angle-to-momentum" => &mut outputs.angle_to_momentum,
            "flips" => &mut outputs.flips,
            "polhode" => &mut outputs.polhode,
            other => {
                let why = format!("`{other}` cannot be requested.{}", nearest(other, &OUTPUTS));
                return Err(root.lines.wrong(&item.span(), "wants", why));
            }
        };
        *requested = true;
    }
    Ok(outputs)
}

fn initial_state(body: &Fields<'_, '_>) -> Result<InitialState, Error> {
    let moments = body.vector("moments")?.ok_or_else(|| body.missing("the field `moments` of this body"))?;
    let products = body.vector("products")?.unwrap_or_else(Vector3::zeros);
    let [w, x, y, z] = body.exactly::<4>("attitude")?.unwrap_or([1.0, 0.0, 0.0, 0.0]);
    let attitude = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    let start = match (body.vector("spin")?, body.vector("momentum")?) {
        (Some(spin), None) => Start::Spin(spin),
        (None, Some(momentum)) => Start::Momentum(momentum),
        (None, None) => return Err(body.missing("`spin` or `momentum` of this body")),
        (Some(_), Some(_)) => {
            let span = body.get("momentum").map_or(0..0, Spanned::span);
            return Err(body.lines.wrong(
                &span,
                "momentum",
                "either `spin` or `momentum` is expected, not both",
            ));
        }
    };
    Ok(InitialState { moments, products, attitude, start })
}
