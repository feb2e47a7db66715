//! Why a scene or one of its bodies cannot be answered.

use std::fmt;

/// What is wrong with a scene, a body or a torque.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling_scenes::{Error, Field, InitialState, Outputs, Scene, Times};
/// let thin = InitialState::spinning(Vector3::new(1.0, 2.0, 3.5), Vector3::x());
/// let scene = Scene::new([thin], vec![], Times::every(1.0, 2.0), Outputs::NOTHING, 1e-9)?;
/// let error = scene.plan(0).unwrap_err();
/// assert_eq!(error.field(), Some(Field::Moments));
/// assert!(error.to_string().starts_with("body 0: no body has principal moments"));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A number breaks a rule.
    Value {
        /// What the number stands for.
        what: &'static str,
        /// The number.
        value: f64,
        /// The rule: "it must ...".
        rule: String,
    },
    /// Something is wrong with one body.
    Body {
        /// Its number, from 0.
        index: usize,
        /// What is wrong with it.
        source: Box<Error>,
    },
    /// Something is wrong with one field of an initial state.
    Field {
        /// Which field.
        field: Field,
        /// What is wrong with it.
        source: Box<Error>,
    },
    /// Something is wrong with one torque.
    Torque {
        /// Its number, from 0.
        index: usize,
        /// What is wrong with it.
        source: tumbling::Error,
    },
    /// The accuracy requested is finer than the motion permits.
    Unattainable {
        /// The accuracy requested.
        requested: f64,
        /// The finest accuracy possible; under a torque, the finest that was observed.
        attainable: f64,
    },
    /// No two trial runs reached the last time within the number of steps allowed.
    OutOfSteps {
        /// The number of steps taken in all trial runs.
        steps: usize,
    },
    /// No two trial runs agreed to any digit.
    Disagreement {
        /// The number of steps taken in all trial runs.
        steps: usize,
    },
    /// An output that this motion does not have.
    Undefined {
        /// The output.
        what: &'static str,
        /// Why there is none.
        why: &'static str,
    },
    /// The library refuses a number or a motion.
    Library(tumbling::Error),
}

/// A field of an [`InitialState`](crate::InitialState), by its name in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Field {
    /// The diagonal of the tensor.
    Moments,
    /// The off-diagonal entries of the tensor.
    Products,
    /// The attitude.
    Attitude,
    /// The angular velocity.
    Spin,
    /// The angular momentum.
    Momentum,
}

impl Error {
    /// The wrong field of the initial state, if the error is about one.
    #[must_use]
    pub fn field(&self) -> Option<Field> {
        match self {
            Self::Field { field, .. } => Some(*field),
            Self::Body { source, .. } => source.field(),
            _ => None,
        }
    }

    /// With the accuracy that can be had rounded up to the two digits that are printed.
    pub(crate) fn unattainable(requested: f64, attainable: f64) -> Self {
        let printed = |x: f64| format!("{x:.1e}").parse().unwrap_or(x);
        let [nearest, above] = [attainable, 1.05 * attainable].map(printed);
        Self::Unattainable { requested, attainable: if nearest < attainable { above } else { nearest } }
    }

    pub(crate) fn of_field(field: Field) -> impl Fn(Self) -> Self {
        move |source| Self::Field { field, source: Box::new(source) }
    }
}

impl From<tumbling::Error> for Error {
    fn from(error: tumbling::Error) -> Self {
        Self::Library(error)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value { what, value, rule } => write!(f, "{what} is {value:?}: {rule}"),
            Self::Body { index, source } => write!(f, "body {index}: {source}"),
            Self::Field { source, .. } => source.fmt(f),
            Self::Torque { index, source } => write!(f, "torque {index}: {source}"),
            Self::Unattainable { requested, attainable } => write!(
                f,
                "an accuracy of {requested:e} is requested, {:.1e} times finer than what can be had: {attainable:.1e}",
                attainable / requested
            ),
            Self::Disagreement { steps } => {
                write!(f, "no two trial runs, of {steps} steps in all, agreed to any digit")
            }
            Self::OutOfSteps { steps } => {
                write!(
                    f,
                    "the trial runs took {steps} steps, and too few are left to reach the last time twice"
                )
            }
            Self::Undefined { what, why } => write!(f, "{what} is requested, but {why}"),
            Self::Library(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Body { source, .. } | Self::Field { source, .. } => Some(source.as_ref()),
            Self::Torque { source, .. } | Self::Library(source) => Some(source),
            _ => None,
        }
    }
}

/// `value` if it is finite.
pub(crate) fn finite(what: &'static str, value: f64) -> Result<f64, Error> {
    within(what, value, value.is_finite(), "it must be a finite number")
}

/// `value` if it is finite and above zero.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, Error> {
    within(what, finite(what, value)?, value > 0.0, "it must be above zero")
}

/// `value` if it is finite and not below zero.
pub(crate) fn not_negative(what: &'static str, value: f64) -> Result<f64, Error> {
    within(what, finite(what, value)?, value >= 0.0, "it must not be below zero")
}

pub(crate) fn within(
    what: &'static str,
    value: f64,
    holds: bool,
    rule: impl Into<String>,
) -> Result<f64, Error> {
    if holds { Ok(value) } else { Err(Error::Value { what, value, rule: rule.into() }) }
}
