//! The form in which mass properties are written and read with serde, feature `serde`. What is read goes
//! through the constructor.

use super::MassProperties;
use crate::error::Error;
use crate::inertia::Inertia;
use serde::{Deserialize, Serialize};

/// Mass in kg, centre in m, inertia about the centre.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Properties {
    mass: f64,
    centre: [f64; 3],
    inertia: Inertia,
}

impl From<MassProperties> for Properties {
    fn from(p: MassProperties) -> Self {
        Self { mass: p.mass(), centre: p.centre().into(), inertia: p.inertia() }
    }
}

impl TryFrom<Properties> for MassProperties {
    type Error = Error;

    fn try_from(p: Properties) -> Result<Self, Error> {
        Self::new(p.mass, &p.centre.into(), p.inertia)
    }
}
