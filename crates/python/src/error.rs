//! The errors of the crates as one Python exception, with the same messages.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

pyo3::create_exception!(
    tumbling,
    Error,
    PyValueError,
    "What was refused, and why: a sentence that names the value, the rule and the margin.\n\n\
     `kind` is a word for programs (such as 'Impossible', 'NotFinite', 'OutOfBounds', 'Unattainable', 'Shape', 'Type',\n\
     'Record'), `subject` names what was refused.\n\n\
     >>> import tumbling\n\
     >>> try:\n\
     ...     tumbling.Inertia([1.11, 100.11, 1.01])\n\
     ... except ValueError as error:\n\
     ...     caught = error\n\
     >>> assert caught.kind == 'Impossible' and 'fails by 97.99' in str(caught)"
);

/// The reason why a call failed.
pub enum Refused {
    Library { sentence: String, kind: String, subject: String },
    Python(PyErr),
}

pub type Answer<T> = Result<T, Refused>;

impl Refused {
    pub fn new(kind: &str, subject: &str, sentence: String) -> Self {
        Self::Library { sentence, kind: kind.into(), subject: subject.into() }
    }

    /// With kind and subject if the cause is an error of the library.
    fn of(error: &(dyn std::error::Error + 'static), kind: &str, subject: &str) -> Self {
        let mut cause = Some(error);
        while let Some(one) = cause {
            if let Some(own) = one.downcast_ref::<tumbling::Error>() {
                return Self::new(&format!("{:?}", own.kind()), own.subject().words(), error.to_string());
            }
            cause = one.source();
        }
        Self::new(kind, subject, error.to_string())
    }
}

impl From<tumbling::Error> for Refused {
    fn from(error: tumbling::Error) -> Self {
        Self::of(&error, "", "")
    }
}

impl From<tumbling_scenes::Error> for Refused {
    fn from(error: tumbling_scenes::Error) -> Self {
        use tumbling_scenes::Error as Scene;
        let mut cause = &error;
        while let Scene::Body { source, .. } | Scene::Field { source, .. } = cause {
            cause = source;
        }
        let (kind, subject) = match cause {
            Scene::Value { what, value, .. } if value.is_finite() => ("OutOfBounds", *what),
            Scene::Value { what, .. } => ("NotFinite", *what),
            Scene::Undefined { what, .. } => ("Undefined", *what),
            Scene::Disagreement { .. } | Scene::OutOfSteps { .. } => ("NotConverged", "the accuracy"),
            _ => ("Unattainable", "the accuracy"),
        };
        Self::of(&error, kind, subject)
    }
}

impl From<tumbling_judge::Error> for Refused {
    fn from(error: tumbling_judge::Error) -> Self {
        Self::of(&error, "Record", "the record")
    }
}

impl From<PyErr> for Refused {
    fn from(error: PyErr) -> Self {
        Self::Python(error)
    }
}

impl From<Refused> for PyErr {
    fn from(refused: Refused) -> Self {
        let (sentence, kind, subject) = match refused {
            Refused::Library { sentence, kind, subject } => (sentence, kind, subject),
            Refused::Python(error) => return error,
        };
        Python::attach(|py| {
            let error = Error::new_err(sentence);
            let value = error.value(py);
            match value.setattr("kind", kind).and_then(|()| value.setattr("subject", subject)) {
                Ok(()) => error,
                Err(other) => other,
            }
        })
    }
}
