mod inverse;
mod moments;
mod nearest;
mod possible;
mod principal;
mod tensor;

use crate::common::{attitude, moments};
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::{Inertia, MassProperties};

/// Of any principal moments along any axes.
pub fn any_tensor() -> impl Strategy<Value = Inertia> {
    (moments(), attitude())
        .prop_map(|(m, q)| Inertia::from_moments(m.x, m.y, m.z).unwrap().turned(q).unwrap())
}

/// The tensor about a point `offset` from the centre of a body of this mass.
pub fn about(inertia: Inertia, mass: f64, offset: &Vector3<f64>) -> Result<Inertia, tumbling::Error> {
    MassProperties::new(mass, &Vector3::zeros(), inertia)?.about(offset)
}
