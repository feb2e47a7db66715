//! What the comment lines of a record tell.

use crate::error::Error;
use nalgebra::Vector3;

/// What was told before the first row.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Told {
    /// Who made the record.
    pub engine: Option<String>,
    /// Principal moments, kg m².
    pub inertia: Option<Vector3<f64>>,
    /// The step, s.
    pub step: Option<f64>,
    /// A torque constant in the world, N m.
    pub torque: Option<Vector3<f64>>,
}

/// Whatever comes after `word` and a colon, an equals sign or blanks.
fn after<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    let at = text.to_ascii_lowercase().find(word)?;
    Some(text[at + word.len()..].trim_start_matches([':', '=', ' ', '\t']))
}

/// The first word or fraction there is a number.
fn number(text: &str) -> Option<f64> {
    let word = text.split([' ', ',', ';', '\t', ')', ']']).next()?;
    match word.split_once('/') {
        Some((over, under)) => Some(over.parse::<f64>().ok()? / under.parse::<f64>().ok()?),
        None => word.parse().ok(),
    }
}

fn three(text: &str) -> Option<Vector3<f64>> {
    let text = text.trim_start_matches(['(', '[', ' ']);
    let mut numbers =
        text.split([' ', ',', '\t', ';', ')', ']']).filter(|x| !x.is_empty()).map_while(|x| x.parse().ok());
    Some(Vector3::new(numbers.next()?, numbers.next()?, numbers.next()?))
}

impl Told {
    /// Reads one more comment line. What it does not understand it takes for prose.
    pub(crate) fn read(&mut self, comment: &str, line: usize) -> Result<(), Error> {
        if self.engine.is_none()
            && let Some(name) = after(comment, "engine:")
        {
            self.engine = Some(name.split(';').next().unwrap_or(name).trim().to_string());
        }
        for word in ["inertia", "moments"] {
            self.inertia = self.inertia.or_else(|| after(comment, word).and_then(three));
        }
        self.torque = self.torque.or_else(|| after(comment, "torque").and_then(three));
        for word in ["dt", "step"] {
            if self.step.is_none()
                && let Some(step) = after(comment, word).and_then(number)
            {
                if !(step.is_finite() && step > 0.0) {
                    let problem = format!("the step is told as {step}: it must be above zero");
                    return Err(Error::Line { line, problem });
                }
                self.step = Some(step);
            }
        }
        Ok(())
    }
}
