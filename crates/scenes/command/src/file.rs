//! A scene from the text of a TOML file.
//!
//! A body is a table as [`tumbling_bodies`] reads it, with its start: `spin` or `momentum`, and `attitude`.
//! It may be given by moments, a solid, parts, a mesh, the name of a body of the book, another file, or a
//! link of a robot.

mod torque;

use nalgebra::{Quaternion, UnitQuaternion};
use serde::Deserialize;
use std::ops::Range;
use std::path::Path;
use toml::Spanned;
use torque::TorqueTable;
use tumbling_bodies::{Error, SceneBodies, Spin, Table, from_toml};
use tumbling_scenes::{Error as SceneError, Field, InitialState, Outputs, Scene, Start, Times};

/// A scene read from a file.
#[derive(Debug)]
pub struct File {
    /// The scene.
    pub scene: Scene,
    text: String,
    /// The position of each body in the text, and the positions of its fields.
    bodies: Vec<(Range<usize>, Fields)>,
}

type Fields = Vec<(&'static str, Range<usize>)>;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneTable {
    accuracy: Spanned<f64>,
    span: Option<Spanned<f64>>,
    every: Option<Spanned<f64>>,
    times: Option<Spanned<Vec<f64>>>,
    wants: Vec<Want>,
    body: Vec<Spanned<Table>>,
    #[serde(default)]
    torque: Vec<Spanned<TorqueTable>>,
}

#[derive(Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
enum Want {
    Spin,
    Attitude,
    Energy,
    AngleToMomentum,
    Flips,
    Polhode,
}

impl File {
    /// An error in a body, at the line of the field if it is about a field.
    pub fn error(&self, index: usize, error: &SceneError) -> Error {
        let names: &[&str] = match error.field() {
            None => &[],
            Some(Field::Moments) => &["moments"],
            Some(Field::Products) => &["products", "moments"],
            Some(Field::Attitude) => &["attitude"],
            Some(Field::Spin) => &["spin"],
            Some(Field::Momentum) => &["momentum"],
        };
        let Some((head, fields)) = self.bodies.get(index) else { return Error::new(error) };
        match names.iter().find_map(|name| fields.iter().find(|(field, _)| field == name)) {
            Some((field, span)) => Error::at(&self.text, span, error).of_field(field),
            None => Error::at(&self.text, head, error),
        }
    }
}

/// A scene from the text of a file; the files that it names lie in `folder`. An impossible tensor is refused
/// when its body is planned.
///
/// # Errors
/// The line, the field and what was expected.
pub fn read(text: String, folder: &Path) -> Result<File, Error> {
    let table: SceneTable = from_toml(&text)?;
    let times = times(&text, &table)?;
    let has = |want| table.wants.contains(&want);
    let outputs = Outputs {
        spin: has(Want::Spin),
        attitude: has(Want::Attitude),
        energy: has(Want::Energy),
        angle_to_momentum: has(Want::AngleToMomentum),
        flips: has(Want::Flips),
        polhode: has(Want::Polhode),
    };
    let bodies = SceneBodies::new(&text, folder);
    let states = table.body.iter().map(|body| initial_state(&text, body, &bodies));
    let states = states.collect::<Result<Vec<_>, _>>()?;
    let torques = table.torque.iter().map(|torque| torque::read(&text, torque)).collect::<Result<_, _>>()?;
    let accuracy = *table.accuracy.get_ref();
    let scene = Scene::new(states, torques, times, outputs, accuracy).map_err(|error| match error {
        SceneError::Torque { index, source } => torque::refused(&text, &table.torque[index], &source),
        _ if table.body.is_empty() => Error::new("`body` is missing; each begins with `[[body]]`"),
        // Times are right: this is all that is left.
        other => Error::at(&text, &table.accuracy.span(), other).of_field("accuracy"),
    })?;
    let bodies = table.body.iter().map(|body| (body.span(), body.get_ref().present())).collect();
    Ok(File { scene, bodies, text })
}

fn times(text: &str, table: &SceneTable) -> Result<Times, Error> {
    let wrong = |field: &str, span: Range<usize>, why: &dyn std::fmt::Display| {
        Err(Error::at(text, &span, why).of_field(field))
    };
    let both = "either `times` or `every` and `span` are expected, not both";
    let missing = |field: &str| format!("`{field}` is missing, which goes with it");
    let (field, span, times) = match (&table.times, &table.every, &table.span) {
        (Some(times), None, None) => ("times", times.span(), Times::Given(times.get_ref().clone())),
        (None, Some(every), Some(span)) => {
            let times = Times::every(*every.get_ref(), *span.get_ref());
            let [of_span, of_every] = [span, every].map(|x| *x.get_ref());
            // Too many states come of either; the one that is farther from a second is named.
            let at_span = of_span < 0.0 || (of_every > 0.0 && of_span * of_every > 1.0);
            if at_span { ("span", span.span(), times) } else { ("every", every.span(), times) }
        }
        (Some(times), _, _) => return wrong("times", times.span(), &both),
        (None, None, Some(span)) => return wrong("span", span.span(), &missing("every")),
        (None, Some(every), None) => return wrong("every", every.span(), &missing("span")),
        (None, None, None) => return Err(Error::new("`every` and `span`, or `times`, are missing")),
    };
    match times.validate() {
        Ok(()) => Ok(times),
        Err(error) => wrong(field, span, &error),
    }
}

fn initial_state(
    text: &str,
    table: &Spanned<Table>,
    bodies: &SceneBodies<'_>,
) -> Result<InitialState, Error> {
    let (moments, products) = bodies.tensor(table)?;
    let body = table.get_ref();
    let [w, x, y, z] = body.attitude.as_ref().map_or([1.0, 0.0, 0.0, 0.0], |attitude| *attitude.get_ref());
    let attitude = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    let start = match (&body.spin, &body.momentum) {
        (Some(spin), None) => match *spin.get_ref() {
            Spin::Vector(spin) => Start::Spin(spin.into()),
            Spin::Speed(_) => {
                let why = "three numbers are expected here, along the body's axes";
                return Err(Error::at(text, &spin.span(), why).of_field("spin"));
            }
        },
        (None, Some(momentum)) => Start::Momentum((*momentum.get_ref()).into()),
        (None, None) => {
            return Err(Error::at(text, &table.span(), "`spin` or `momentum` of this body is missing"));
        }
        (Some(_), Some(momentum)) => {
            let why = "either `spin` or `momentum` is expected, not both";
            return Err(Error::at(text, &momentum.span(), why).of_field("momentum"));
        }
    };
    Ok(InitialState { moments: moments.into(), products: products.into(), attitude, start })
}

#[cfg(test)]
mod tests;
